//! The same deck elsewhere: turned, shifted, mirrored, renumbered.

use slideline_verification::{
    Claim, Group, Method, Placement, Push, Record, largest, largest_difference, run, worst,
};

const OBJECTIVE: &str = "Mechanics has no origin, no direction and no hand.";
const ROUNDING: &str = "1e-9 of the peak force: residuals are held at 1e-12, so that only rounding \
                        of the coordinates is left.";

pub const GROUP: Group = Group {
    file: "objectivity",
    claims: &[
        Claim {
            name: "turned_and_shifted",
            requirement: "A deck turned and shifted has the same reactions, turned along, SMOOTH \
                          and friction included.",
            source: OBJECTIVE,
            tolerance: ROUNDING,
            measure: turned_and_shifted,
        },
        Claim {
            name: "mirrored",
            requirement: "A mirrored deck, x to -x and both surfaces in reversed order, has the \
                          mirrored reactions.",
            source: OBJECTIVE,
            tolerance: ROUNDING,
            measure: mirrored,
        },
        Claim {
            name: "renumbered",
            requirement: "Other labels in another order change nothing.",
            source: "A label is a name.",
            tolerance: ROUNDING,
            measure: renumbered,
        },
        Claim {
            name: "there_and_back_with_friction",
            requirement: "The same with friction both ways, the stick transition between, and \
                          exact stick.",
            source: OBJECTIVE,
            tolerance: ROUNDING,
            measure: there_and_back_with_friction,
        },
    ],
};

const TOLERANCE: f64 = 1e-9;

/// Reactions of the circle, and its moment.
fn reactions(push: &Push) -> [Vec<f64>; 3] {
    let curve = run(&push.deck()).unwrap();
    [1, 2, 6].map(|dof| curve.reaction(Push::CIRCLE, dof))
}

/// Largest difference of reactions (of peak) and of the moment (of peak times r).
fn off(push: &Push, placement: Placement) -> f64 {
    let [fx, fy, m] = reactions(push);
    let peak = largest(&fx, &fy);
    let turned = fx.iter().zip(&fy).map(|(&x, &y)| placement.vector([x, y]));
    let turned: Vec<[f64; 2]> = turned.collect();
    let found = reactions(&Push { placement, ..*push });
    let hand = if placement.mirror { -1.0 } else { 1.0 };
    let [x, y] = [0, 1].map(|k| turned.iter().map(|v| v[k]).collect::<Vec<f64>>());
    let m: Vec<f64> = m.iter().map(|m| hand * m).collect();
    worst([
        largest_difference(&found[0], &x) / peak,
        largest_difference(&found[1], &y) / peak,
        largest_difference(&found[2], &m) / (peak * 9e-3),
    ])
}

fn words(placement: &Placement) -> String {
    let Placement { angle, shift: [x, y], mirror } = placement;
    let mirrored = if *mirror { "mirrored" } else { "as it is" };
    format!("{mirrored}, turned by {angle}, shifted by {x}, {y}")
}

fn each(mut test: impl FnMut(&Push)) {
    for method in [Method::Irs, Method::Isl, Method::Surface] {
        for mu in [0.0, 0.3] {
            test(&Push { mu, tolerance: Some(1e-12), ..Push::paper(method) });
        }
    }
}

fn check(record: &mut Record, push: &Push, placement: Placement) {
    let what = format!("{:?}, mu {}, {}", push.method, push.mu, words(&placement));
    record.at_most(format!("{what} (of peak)"), off(push, placement), TOLERANCE);
}

fn turned_and_shifted(record: &mut Record) {
    each(|push| {
        check(record, push, Placement { angle: 0.7, ..Placement::default() });
        check(record, push, Placement { angle: -2.5, shift: [0.1, -0.05], mirror: false });
    });
}

fn mirrored(record: &mut Record) {
    each(|push| check(record, push, Placement { mirror: true, ..Placement::default() }));
}

fn renumbered(record: &mut Record) {
    each(|push| {
        let (as_is, other) = (reactions(push), reactions(&Push { renumbered: true, ..*push }));
        let peak = largest(&as_is[0], &as_is[1]);
        let off = worst([0, 1].map(|dof| largest_difference(&as_is[dof], &other[dof]) / peak));
        let what = format!("{:?}, mu {}, largest difference (of peak)", push.method, push.mu);
        record.at_most(what, off, TOLERANCE);
    });
}

fn there_and_back_with_friction(record: &mut Record) {
    for (stick, friction) in [("penalty", ""), ("Lagrange", ", LAGRANGE")] {
        for method in [Method::Irs, Method::Isl] {
            let push = Push {
                mu: 0.3,
                friction,
                returns: true,
                tolerance: Some(1e-12),
                ..Push::paper(method)
            };
            for placement in [
                Placement { angle: 1.1, shift: [0.05, 0.1], mirror: false },
                Placement { mirror: true, ..Placement::default() },
            ] {
                let what = format!("{method:?}, {stick}, {} (of peak)", words(&placement));
                record.at_most(what, off(&push, placement), TOLERANCE);
            }
        }
    }
}
