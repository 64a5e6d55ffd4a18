//! A profile that slides on a profile: contact integrated along the slave's, no slave nodes placed.
//!
//! ```text
//!       o body: pressed down, or on springs, or at the end of an arm
//!      | |
//!      '-'   nose of radius r            F = K w times the integral of the overclosure along the nose
//!    _______     ____/\____  plate, ramp, catch
//! ```

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::Dof;
use slideline::observe::{Ending, Event, Observer, Stop};
use slideline::{Job, ReadOptions, SolveOptions, TangentCheck, solve};
use std::ops::ControlFlow;

const RADIUS: f64 = 0.5;
const WIDTH: f64 = 2.0;
const STIFFNESS: f64 = 4.0e4;

/// What a run leaves of the body and of its pair.
#[derive(Default)]
struct Watch {
    /// Reactions at the node of the nose, and its displacements.
    reactions: Vec<[f64; 3]>,
    places: Vec<[f64; 3]>,
    /// Where contact stands, of the first row.
    stands: Vec<[f64; 3]>,
    /// Forces along x at the root of the arm.
    roots: Vec<f64>,
    /// Moment of all forces about the origin, in the largest force times the size [1].
    imbalance: f64,
    attempts_given_up: usize,
    most_iterations: usize,
    balance: f64,
    tangent: f64,
}

impl Observer for Watch {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::AttemptFailed(_) => self.attempts_given_up += 1,
            Event::Tangent(report) => self.tangent = self.tangent.max(report.off),
            Event::Committed(frame) => {
                let own = frame.model.nodes.find(NOSE).unwrap();
                let dofs = [Dof::U1, Dof::U2, Dof::UR3];
                self.reactions.push(dofs.map(|dof| frame.nodal.reaction(own, dof)));
                self.places.push(dofs.map(|dof| frame.nodal.displacement(own, dof)));
                self.stands.extend(frame.contact.first().map(|row| row.position));
                let root = frame.model.nodes.find(ROOT);
                self.roots.extend(root.map(|root| frame.nodal.reaction(root, Dof::U1)));
                let iterations = frame.severe_iterations + frame.equilibrium_iterations;
                self.most_iterations = self.most_iterations.max(iterations);
                for pair in frame.pairs {
                    let off = pair.force_imbalance.max(pair.moment_imbalance);
                    self.imbalance = self.imbalance.max(off);
                }
                let energy = frame.energy;
                self.balance = self.balance.max(energy.balance.abs());
            }
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

const NOSE: u64 = 50;
const ROOT: u64 = 1;

fn run(deck: &str, options: &SolveOptions) -> Watch {
    let read = Job::read_text("profiles", deck, &ReadOptions::default());
    let model = read.model.unwrap_or_else(|| panic!("{deck}\n{:#?}", read.diagnostics));
    let mut watch = Watch::default();
    let ending = solve(&model, options, &mut watch);
    assert!(matches!(ending, Ending::Completed(_)), "{deck}\n{ending:?}");
    watch
}

/// A place turned by an angle and moved, in so many millimetres a unit.
fn placed([x, y]: [f64; 2], turn: f64, unit: f64) -> String {
    let (sin, cos) = turn.sin_cos();
    format!("{:?}, {:?}", unit * (cos * x - sin * y + 3.0), unit * (sin * x + cos * y - 1.0))
}

/// A nose of two arcs between flanks, its lowest point at the origin, and what it slides on.
fn surfaces(on: &[[f64; 2]], turn: f64, unit: f64) -> String {
    let r = RADIUS;
    let at = |place: [f64; 2]| placed(place, turn, unit);
    let centre = at([0.0, r]);
    // travel with the material on its right: the outward normal is 90 degrees to the left
    let mut text = format!(
        "*NODE\n{NOSE}, {}\n99, {}\n*SURFACE, NAME=NOSE, TYPE=SEGMENTS\nSTART, {}\nLINE, {}\n\
         CIRCL, {}, {centre}\nCIRCL, {}, {centre}\nLINE, {}\n\
         *RIGID BODY, REF NODE={NOSE}, ANALYTICAL SURFACE=NOSE\n*SURFACE, NAME=CATCH, TYPE=SEGMENTS\n",
        at([0.0, 3.0]),
        at([0.0, -5.0]),
        at([r, 2.0]),
        at([r, r]),
        at([0.0, 0.0]),
        at([-r, r]),
        at([-r, 2.0]),
    );
    for (k, place) in on.iter().enumerate() {
        let word = if k == 0 { "START" } else { "LINE" };
        text += &format!("{word}, {}\n", at(*place));
    }
    text + "*RIGID BODY, REF NODE=99, ANALYTICAL SURFACE=CATCH\n"
}

fn law(friction: f64, stiffness: f64, unit: f64) -> String {
    let friction = if friction > 0.0 { format!("*FRICTION\n{friction}\n") } else { String::new() };
    format!(
        "*SURFACE INTERACTION, NAME=I\n{:?}\n{friction}*SURFACE BEHAVIOR, \
         PRESSURE-OVERCLOSURE=LINEAR\n{stiffness:?}\n",
        WIDTH * unit
    )
}

/// Requirement: pressed on a plate by d, a nose of radius r feels F = K w r (2 d a - 2 r (a - sin a)),
/// cos a = 1 - d/r, along the normal and nothing else, whichever way both lie and in any unit; with
/// the roles exchanged, where the plate is pressed towards the centre of the nose,
/// F = 2 K w (r - d) r (ln((1 + sin a)/cos a) - sin a). Source: the integrals of d - r (1 - cos t) along the
/// arc, and of (r - q) (r - d)/q along the plate, q the distance from the centre.
/// Tolerance: three Gauss points a cell, 1e-5.
#[test]
fn a_nose_on_a_plate() {
    for (turn, unit) in [(0.0, 1.0), (0.7, 1.0), (2.9, 1e-3)] {
        for pair in ["NOSE, CATCH", "CATCH, NOSE"] {
            let stiffness = STIFFNESS / unit;
            let on = [[-4.0, 0.0], [4.0, 0.0]];
            let [sin, cos] = [f64::sin(turn), f64::cos(turn)];
            let deck = format!(
                "*HEADING\nnose\n{}{}*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\n{pair}\n\
                 *BOUNDARY\n99, 1, 2\n99, 6\n{NOSE}, 6\n*STEP, NLGEOM\n*STATIC, DIRECT\n0.25, 1.0\n\
                 *BOUNDARY\n{NOSE}, 1, 1, {:?}\n{NOSE}, 2, 2, {:?}\n*END STEP\n",
                surfaces(&on, turn, unit),
                law(0.0, stiffness, unit),
                0.08 * unit * sin,
                -0.08 * unit * cos,
            );
            let watch = run(&deck, &SolveOptions::default());
            for (k, [x, y, m]) in watch.reactions.iter().enumerate() {
                let d = 0.02 * (k + 1) as f64;
                let a = (1.0 - d / RADIUS).acos();
                let along = match pair {
                    "NOSE, CATCH" => RADIUS * (2.0 * d * a - 2.0 * RADIUS * (a - a.sin())),
                    _ => 2.0 * (RADIUS - d) * RADIUS * (((1.0 + a.sin()) / a.cos()).ln() - a.sin()),
                };
                let force = STIFFNESS * WIDTH * along * unit * unit;
                let off = (x - force * sin).hypot(y + force * cos) / force;
                assert!(off < 1e-5, "{turn} {unit} {pair} {k}: {off:e}");
                assert!(m.abs() < 1e-9 * force * unit, "{pair} {k}: moment {m:e} of {force}");
            }
            assert!(watch.imbalance < 1e-9 && watch.attempts_given_up == 0, "{}", watch.imbalance);
            if turn == 0.0 {
                // told near the lowest place of the nose, at (3, -1), not at its reference node
                let [x, y, _] = watch.stands[3].map(|own| own / unit);
                assert!((x - 3.0).abs() < 0.1 && (y + 1.0).abs() < 0.11, "{pair}: {x} {y}");
            }
        }
    }
}

/// Requirement: on springs over a ramp of angle a the force along is that across times
/// tan(a + atan mu) up and tan(a - atan mu) down, in either role; moments and forces of the pair balance; the
/// tangent is the derivative of the forces. Source: equilibrium of a body that slides. Tolerance: that of Newton's
/// method, 1e-6.
#[test]
fn a_nose_on_a_ramp() {
    for pair in ["NOSE, CATCH", "CATCH, NOSE"] {
        for (friction, slope) in [(0.0, 0.4), (0.3, 0.4), (0.3, -0.5), (0.15, 0.1)] {
            let on = [[-9.0, -9.0 * slope], [9.0, 9.0 * slope]];
            let deck = format!(
                "*HEADING\nramp\n{}{}*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\n{pair}\n\
                 *ELEMENT, TYPE=SPRING1, ELSET=S\n1, {NOSE}\n*SPRING, ELSET=S\n2\n100.0\n\
                 *BOUNDARY\n99, 1, 2\n99, 6\n{NOSE}, 6\n*STEP, NLGEOM\n*STATIC, DIRECT\n0.25, 1.0\n\
                 *BOUNDARY\n99, 2, 2, 0.3\n{NOSE}, 1, 1, 0.0\n*END STEP\n*STEP, NLGEOM\n*STATIC, DIRECT\n\
                 0.05, 1.0\n*BOUNDARY\n{NOSE}, 1, 1, 0.4\n*END STEP\n",
                surfaces(&on, 0.0, 1.0),
                law(friction, STIFFNESS, 1.0),
            );
            let options =
                SolveOptions { check_tangent: TangentCheck::Every, ..SolveOptions::default() };
            let watch = run(&deck, &options);
            let last = watch.reactions.len() - 1;
            let across = 100.0 * watch.places[last][1];
            let sign = if slope > 0.0 { 1.0 } else { -1.0 };
            let angle = slope.abs().atan() + sign * f64::atan(friction);
            let expected = sign * across * angle.tan();
            let off = (watch.reactions[last][0] / expected - 1.0).abs();
            assert!(off < 1e-6, "{pair} {friction} {slope}: {off:e}");
            assert!(watch.imbalance < 1e-9 && watch.attempts_given_up == 0, "{}", watch.imbalance);
            assert!(watch.most_iterations <= 6, "{}", watch.most_iterations);
            assert!(watch.tangent < 1e-6, "{pair} {friction} {slope}: {:e}", watch.tangent);
        }
    }
}

/// Requirement: a rounded nose at the end of an arm passes a rounded catch and comes back: no attempt is
/// given up, at most six iterations, both roles give the same force within half a per cent of the peak,
/// and the peak is that of 200 increments within 1 per cent.
#[test]
fn an_arm_with_a_nose_passes_a_catch() {
    let force = |pair: &str, increment: f64| {
        let deck = arm(pair, increment);
        let watch = run(&deck, &SolveOptions::default());
        assert_eq!(watch.attempts_given_up, 0, "{pair} {increment}");
        assert!(watch.most_iterations <= 6, "{pair} {increment}: {}", watch.most_iterations);
        assert!(watch.imbalance < 1e-9);
        watch.roots
    };
    let [one, other] = ["NOSE, CATCH", "CATCH, NOSE"].map(|pair| force(pair, 0.02));
    let peak = |all: &[f64]| all.iter().fold(0.0_f64, |most, own| most.max(own.abs()));
    let apart = one.iter().zip(&other).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(peak(&one) > 0.1 && apart < 0.005 * peak(&one), "{apart} of {}", peak(&one));
    let fine = force("NOSE, CATCH", 0.005);
    assert!((peak(&fine) / peak(&one) - 1.0).abs() < 0.01, "{} {}", peak(&one), peak(&fine));
}

fn arm(pair: &str, increment: f64) -> String {
    let mut deck = String::from("*HEADING\narm\n*NODE, NSET=LINE\n");
    for k in 0..=12 {
        deck +=
            &format!("{}, {:?}, 3.0\n", if k == 12 { NOSE } else { k + 1 }, 2.5 * k as f64 - 30.0);
    }
    deck += "*ELEMENT, TYPE=B21, ELSET=ARM\n";
    for k in 0..12 {
        deck += &format!("{}, {}, {}\n", k + 1, k + 1, if k == 11 { NOSE } else { k + 2 });
    }
    let r = RADIUS;
    deck + &format!(
        "*BEAM SECTION, SECTION=RECT, ELSET=ARM, MATERIAL=M\n{WIDTH:?}, 1.5\n*MATERIAL, NAME=M\n\
         *ELASTIC\n2400.0, 0.35\n*NODE\n99, 4.0, -5.0\n*SURFACE, NAME=NOSE, TYPE=SEGMENTS\n\
         START, {r:?}, 2.0\nLINE, {r:?}, {r:?}\nCIRCL, 0.0, 0.0, 0.0, {r:?}\n\
         CIRCL, -{r:?}, {r:?}, 0.0, {r:?}\nLINE, -{r:?}, 2.0\n\
         *RIGID BODY, REF NODE={NOSE}, ANALYTICAL SURFACE=NOSE\n\
         *SURFACE, NAME=CATCH, TYPE=SEGMENTS, FILLET RADIUS=0.4\nSTART, 0.6, -1.0\nLINE, 4.0, 1.0\n\
         LINE, 5.0, 1.0\nLINE, 7.4, -1.4\n*RIGID BODY, REF NODE=99, ANALYTICAL SURFACE=CATCH\n{}\
         *CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\n{pair}\n*BOUNDARY\n99, 1, 2\n99, 6\n\
         1, 2\n1, 6\n*STEP, NLGEOM, INC=1000\n*STATIC, DIRECT\n{increment:?}, 1.0\n*BOUNDARY\n1, 1, 1, 7.5\n\
         *END STEP\n*STEP, NLGEOM, INC=1000\n*STATIC, DIRECT\n{increment:?}, 1.0\n*BOUNDARY\n1, 1, 1, 0.0\n*END STEP\n",
        law(0.3, 5000.0, 1.0)
    )
}

/// Requirement: what moves slave nodes, and rings, are refused in words that name the reason.
#[test]
fn what_a_profile_cannot_do_is_said() {
    let on = [[-4.0, 0.0], [4.0, 0.0]];
    let deck = format!(
        "*HEADING\nnose\n{}{}*CONTACT PAIR, INTERACTION=I, ADJUST=0.1\nNOSE, CATCH\n*BOUNDARY\n\
         99, 1, 2\n99, 6\n{NOSE}, 6\n*STEP, NLGEOM\n*STATIC\n0.25, 1.0\n*END STEP\n",
        surfaces(&on, 0.0, 1.0),
        law(0.0, STIFFNESS, 1.0)
    );
    let read = Job::read_text("profiles", &deck, &ReadOptions::default());
    assert!(read.model.is_none());
    let said: Vec<&str> = read.diagnostics.iter().map(|own| own.message.as_str()).collect();
    assert!(
        said.iter().any(|own| own.contains("ADJUST moves slave nodes, and NOSE has none")),
        "{said:?}"
    );
}

/// Requirement: before anything moves the gap that is told is that of the places of both profiles that are
/// nearest: of a circle of radius 0.5 about (0, 0.5) over a line through (0.6, -1) and (4, 1), the distance of its
/// centre less its radius. Source: geometry. Tolerance: places are found to 1e-9 of a segment.
#[test]
fn the_gap_at_the_start_is_that_of_the_nearest_places() {
    let read = Job::read_text("profiles", &arm("NOSE, CATCH", 0.02), &ReadOptions::default());
    let start =
        slideline::initial_gaps(&read.model.unwrap(), &SolveOptions::default(), None).unwrap();
    let nearest = start.points.iter().map(|row| row.opening).fold(f64::INFINITY, f64::min);
    let way = [3.4_f64, 2.0];
    let distance = (way[0] * 1.5 + way[1] * 0.6) / way[0].hypot(way[1]);
    assert!((nearest - (distance - RADIUS)).abs() < 1e-9, "{nearest} {distance}");
}
