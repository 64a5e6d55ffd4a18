//! The same deck elsewhere: turned, shifted, mirrored, renumbered.
//!
//! Requirement: the same reactions, turned along, to 1e-9 of the peak force,
//! SMOOTH included. Source: verification section 7. Tolerance: residuals are
//! held at 1e-12, so only rounding of the coordinates is left.

use slideline_verification::{Method, Placement, Push, largest, largest_difference, run};

const TOLERANCE: f64 = 1e-9;

/// Reactions of the circle, and its moment.
fn reactions(push: &Push) -> [Vec<f64>; 3] {
    let curve = run(&push.deck()).unwrap();
    [1, 2, 6].map(|dof| curve.reaction(Push::CIRCLE, dof))
}

fn check(push: &Push, placement: Placement) {
    let [fx, fy, m] = reactions(push);
    let peak = largest(&fx, &fy);
    let turned: Vec<[f64; 2]> =
        fx.iter().zip(&fy).map(|(&x, &y)| placement.vector([x, y])).collect();
    let found = reactions(&Push { placement, ..*push });
    let hand = if placement.mirror { -1.0 } else { 1.0 };
    for (what, found, expected, scale) in [
        ("RF1", &found[0], turned.iter().map(|v| v[0]).collect::<Vec<_>>(), peak),
        ("RF2", &found[1], turned.iter().map(|v| v[1]).collect(), peak),
        ("RM3", &found[2], m.iter().map(|m| hand * m).collect(), peak * 9e-3),
    ] {
        let off = largest_difference(found, &expected) / scale;
        println!("{:?} mu {} {placement:?} {what}: {off:.1e}", push.method, push.mu);
        assert!(off < TOLERANCE, "{push:?} {placement:?} {what}: {off:e}");
    }
}

fn each(test: impl Fn(&Push)) {
    for method in [Method::Irs, Method::Isl] {
        for mu in [0.0, 0.3] {
            test(&Push { mu, tolerance: Some(1e-12), ..Push::paper(method) });
        }
    }
}

#[test]
fn turned_and_shifted() {
    each(|push| {
        check(push, Placement { angle: 0.7, ..Placement::default() });
        check(push, Placement { angle: -2.5, shift: [0.1, -0.05], mirror: false });
    });
}

#[test]
fn mirrored() {
    each(|push| check(push, Placement { mirror: true, ..Placement::default() }));
}

#[test]
fn renumbered() {
    each(|push| {
        let (as_is, other) = (reactions(push), reactions(&Push { renumbered: true, ..*push }));
        let peak = largest(&as_is[0], &as_is[1]);
        for dof in 0..2 {
            let off = largest_difference(&as_is[dof], &other[dof]) / peak;
            assert!(off < TOLERANCE, "{push:?}: {off:e}");
        }
    });
}

/// Requirement: with friction both ways, the stick transition between, and
/// exact stick, just the same.
#[test]
fn there_and_back_with_friction() {
    for friction in ["", ", LAGRANGE"] {
        for method in [Method::Irs, Method::Isl] {
            let push = Push {
                mu: 0.3,
                friction,
                returns: true,
                tolerance: Some(1e-12),
                ..Push::paper(method)
            };
            check(&push, Placement { angle: 1.1, shift: [0.05, 0.1], mirror: false });
            check(&push, Placement { mirror: true, ..Placement::default() });
        }
    }
}
