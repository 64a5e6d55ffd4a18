//! Tractions through decks: they turn with their faces or stay, on the area of now or the undeformed one.
//!
//! Source: docs/theory.md eqs (4.21) to (4.24); Abaqus manual, `*DSLOAD`, `*DLOAD`.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use super::exactly;
use slideline::model::Dof;
use slideline::observe::Totals;
use slideline::{Event, Observer, Stop};
use std::collections::BTreeMap;
use std::ops::ControlFlow;

const AXES: [Dof; 3] = [Dof::U1, Dof::U2, Dof::U3];

#[derive(Default)]
struct End {
    rest: BTreeMap<u64, [f64; 3]>,
    motion: BTreeMap<u64, [f64; 3]>,
    /// Sums of the reactions at every increment.
    reactions: Vec<[f64; 3]>,
    totals: Option<Totals>,
}

impl Observer for End {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            let mut sum = [0.0; 3];
            for node in 0..frame.model.nodes.len() {
                let label = frame.model.nodes.label(node);
                self.rest.insert(label, frame.model.nodes.get(node).position);
                self.motion.insert(label, AXES.map(|dof| frame.nodal.displacement(node, dof)));
                let own = AXES.map(|dof| frame.nodal.reaction(node, dof));
                sum.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
            }
            self.reactions.push(sum);
        }
        ControlFlow::Continue(())
    }
}

impl End {
    fn place(&self, label: u64) -> [f64; 3] {
        std::array::from_fn(|k| self.rest[&label][k] + self.motion[&label][k])
    }

    /// The sum of the reactions at the end.
    fn reaction(&self) -> [f64; 3] {
        *self.reactions.last().unwrap()
    }

    /// The largest difference of a displacement.
    fn apart(&self, other: &Self) -> f64 {
        let each = self.motion.iter().flat_map(|(label, own)| {
            own.iter().zip(other.motion[label]).map(|(a, b)| (a - b).abs())
        });
        each.fold(0.0, f64::max)
    }
}

fn solved(deck: &str) -> End {
    let (end, totals) = exactly::solved::<End>(deck);
    End { totals: Some(totals), ..end }
}

/// A bar of 3 by 1 by 1 along x in three bricks, E = 1000, nu = 0.3; nodes 1 to 4 at x = 0, 13 to 16 at
/// the end, END the face there, TOP the faces y = 1.
fn bar(element: &str, material: &str, history: &str) -> String {
    let mut cards = String::from("*NODE, NSET=ALL\n");
    for i in 0..4 {
        for (k, [y, z]) in [[0, 0], [1, 0], [1, 1], [0, 1]].into_iter().enumerate() {
            cards += &format!("{}, {i}., {y}., {z}.\n", 1 + 4 * i + k);
        }
    }
    cards += "99, 0., 0., 0.\n";
    cards += &format!("*ELEMENT, TYPE={element}, ELSET=B\n");
    for e in 0..3 {
        let row: Vec<String> = (1..=8).map(|k| (4 * e + k).to_string()).collect();
        cards += &format!("{}, {}\n", 1 + e, row.join(", "));
    }
    cards
        + &format!(
            "*NSET, NSET=ROOT\n1, 2, 3, 4\n*ELSET, ELSET=LAST\n3,\n*SURFACE, NAME=END\nLAST, S2\n\
             *SURFACE, NAME=TOP\nB, S4\n\
             *SOLID SECTION, ELSET=B, MATERIAL=M\n*MATERIAL, NAME=M\n{material}{history}"
        )
}

/// A strip of 3 by 1 in the plane, as the bar; nodes 1, 2 at x = 0, 7, 8 at the end.
fn strip(history: &str) -> String {
    let mut cards = String::from("*NODE, NSET=ALL\n");
    for i in 0..4 {
        cards += &format!("{}, {i}., 0.\n{}, {i}., 1.\n", 1 + 2 * i, 2 + 2 * i);
    }
    cards += "99, 0., 0.\n*ELEMENT, TYPE=CPE4, ELSET=B\n";
    for e in 0..3 {
        let first = 1 + 2 * e;
        cards += &format!("{}, {first}, {}, {}, {}\n", 1 + e, first + 2, first + 3, first + 1);
    }
    cards
        + &format!(
            "*NSET, NSET=ROOT\n1, 2\n*ELSET, ELSET=LAST\n3,\n*SURFACE, NAME=END\nLAST, S2\n\
             *SURFACE, NAME=TOP\nB, S3\n\
             *SOLID SECTION, ELSET=B, MATERIAL=M\n0.5\n*MATERIAL, NAME=M\n{ELASTIC}{history}"
        )
}

const ELASTIC: &str = "*ELASTIC\n1000., 0.3\n";

/// A step in which the root turns by these rotations.
fn turning(dofs: &str, loads: &str) -> String {
    format!(
        "*RIGID BODY, REF NODE=99, TIE NSET=ROOT\n*STEP, NLGEOM\n*STATIC\n0.125, 1.\n*BOUNDARY\n\
         99, 1, 6\n{dofs}{loads}*END STEP\n"
    )
}

/// Requirement: a body whose support turns rigidly turns with its loads: the end is that of the body with
/// a support at rest, turned, in the plane by 2 and in space by 2 about (2, -1, 2)/3, for tractions along and
/// across the end and along the top; with FOLLOWER=NO it is another. Tolerance: 1e-8 of the length.
#[test]
fn tractions_turn_with_the_body() {
    let loads = "\nEND, TRVEC, 60., 0.6, 0.8, 0.\nTOP, TRSHR, 25., 1., 0., 0.\n";
    let angle = 2.0_f64;
    for (space, axis) in [(false, [0.0, 0.0, 1.0]), (true, [2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0])] {
        let deck = |history: &str| match space {
            true => bar("C3D8", ELASTIC, history),
            false => strip(history),
        };
        let mut turns = String::new();
        for k in (0..3).filter(|k| space || *k == 2) {
            turns += &format!("99, {0}, {0}, {1:?}\n", 4 + k, angle * axis[k]);
        }
        for resultant in ["", ", CONSTANT RESULTANT=YES"] {
            let load = format!("*DSLOAD{resultant}{loads}");
            let still = solved(&deck(&turning("", &load)));
            let turned = solved(&deck(&turning(&turns, &load)));
            let (sin, cos) = angle.sin_cos();
            let turn = |v: [f64; 3]| -> [f64; 3] {
                let along = (1.0 - cos) * (0..3).map(|k| axis[k] * v[k]).sum::<f64>();
                std::array::from_fn(|k| {
                    let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                    cos * v[k] + sin * (axis[i] * v[j] - axis[j] * v[i]) + along * axis[k]
                })
            };
            for &label in still.rest.keys().filter(|label| **label != 99) {
                let (expected, found) = (turn(still.place(label)), turned.place(label));
                let apart = (0..3).map(|k| (expected[k] - found[k]).abs()).fold(0.0, f64::max);
                assert!(apart < 1e-8, "{space} {resultant} {label}: {found:?} {expected:?}");
            }
            let stays = format!("*DSLOAD, FOLLOWER=NO{resultant}{loads}");
            let stays = solved(&deck(&turning(&turns, &stays)));
            assert!(stays.apart(&turned) > 0.1, "{space} {resultant}");
        }
    }
}

/// Requirement: a traction against the outward normal is a pressure: the same motions and as many
/// iterations, far from rest, in the plane, of rings and in space. Tolerance: 1e-9.
#[test]
fn across_its_face_a_traction_is_a_pressure() {
    let step = |load: &str| {
        format!(
            "*STEP, NLGEOM\n*STATIC\n0.25, 1.\n*BOUNDARY\nROOT, 1, 3\n*DSLOAD\n{load}*END STEP\n"
        )
    };
    let pressure = step("TOP, P, 20.\n");
    let traction = step("TOP, TRVEC, -20., 0., 1., 0.\n");
    let decks = |history: &str| {
        let plane = strip(history);
        let ring = plane.replace("CPE4", "CAX4").replace("99, 0., 0.\n", "");
        [ring, plane, bar("C3D8I", ELASTIC, history)]
    };
    for (pressed, pulled) in decks(&pressure).iter().zip(&decks(&traction)) {
        let (pressed, pulled) = (solved(pressed), solved(pulled));
        assert!(pulled.motion[&8].iter().any(|u| u.abs() > 0.2), "{:?}", pulled.motion[&8]);
        assert!(pressed.apart(&pulled) < 1e-9, "{}", pressed.apart(&pulled));
        let [one, other] = [pressed, pulled].map(|end| end.totals.unwrap().iterations);
        assert_eq!(one, other);
    }
}

/// Requirement: on the area of now the traction at the end of a bar of rubber is its true stress, on the
/// undeformed area its nominal one; so with FOLLOWER=NO, because the end does not turn. Neo-Hooke, C = 40,
/// D = 0.01, stretched by 1.5: closed form, the width from the free sides. Tolerance: 1e-9.
#[test]
fn true_and_nominal_stress() {
    let (c, d, stretch) = (40.0, 0.01, 1.5_f64);
    let stress = |along: f64, one: f64, width: f64| {
        let volume = one * width * width;
        let mean = (one * one + 2.0 * width * width) / 3.0;
        2.0 * c * volume.powf(-5.0 / 3.0) * (along * along - mean) + 2.0 / d * (volume - 1.0)
    };
    let (mut low, mut high) = (0.5, 1.0);
    for _ in 0..60 {
        let width = 0.5 * (low + high);
        if stress(width, stretch, width) > 0.0 { high = width } else { low = width }
    }
    let truth = stress(stretch, stretch, low);
    let rubber = format!("*HYPERELASTIC, NEO HOOKE\n{c:?}, {d:?}\n");
    for follower in ["", ", FOLLOWER=NO"] {
        for (resultant, traction) in [("", truth), (", CONSTANT RESULTANT=YES", truth * low * low)]
        {
            let history = format!(
                "*STEP, NLGEOM\n*STATIC\n0.25, 1.\n*BOUNDARY\nROOT, 1\n1, 2, 3\n2, 3\n4, 2\n5, 2, 3\n\
                 *DLOAD{follower}{resultant}\nLAST, TRVEC2, {traction:?}, 1., 0., 0.\n*END STEP\n"
            );
            let end = solved(&bar("C3D8", &rubber, &history));
            let found = end.place(15)[0] / 3.0;
            assert!((found - stretch).abs() < 1e-9, "{follower} {resultant} {found}");
            let force = -end.reaction()[0];
            assert!((force / (truth * low * low) - 1.0).abs() < 1e-9, "{force}");
        }
    }
}

/// Requirement: a slender cantilever under a shear traction that turns with its end is the elastica under
/// a force across its end: EI psi'' = -P cos psi with psi from the tip, where it begins as zero with
/// psi' = 0, one integration. L = 40 h, P L^2/EI = 4: the end turns by more than a right angle. Source: Euler; thickness
/// and shear make (h/L)^2 of it; 20 elements CPS8R: 0.2 % of the length.
#[test]
fn elastica_under_a_force_across_its_end() {
    let (length, modulus, load) = (40.0, 1.2e6, 4.0);
    let stiffness = modulus / 12.0;
    let force = load * stiffness / (length * length);
    let mut cards = String::from("*NODE\n");
    for i in 0..41_u64 {
        let x = length * i as f64 / 40.0;
        cards += &format!("{}, {x:?}, -0.5\n{}, {x:?}, 0.5\n", 1 + i, 201 + i);
        if i % 2 == 0 {
            cards += &format!("{}, {x:?}, 0.\n", 101 + i);
        }
    }
    cards += "*ELEMENT, TYPE=CPS8R, ELSET=B\n";
    for e in 0..20_u64 {
        let a = 1 + 2 * e;
        let row = [a, a + 2, a + 202, a + 200, a + 1, a + 102, a + 201, a + 100];
        let row: Vec<String> = row.iter().map(u64::to_string).collect();
        cards += &format!("{}, {}\n", 1 + e, row.join(", "));
    }
    cards += &format!(
        "*NSET, NSET=ROOT\n1, 101, 201\n*ELSET, ELSET=LAST\n20,\n*SURFACE, NAME=END\nLAST, S2\n\
         *SOLID SECTION, ELSET=B, MATERIAL=M\n1.\n*MATERIAL, NAME=M\n*ELASTIC\n{modulus:?}, 0.\n\
         *STEP, NLGEOM, INC=200\n*STATIC\n0.05, 1., 1e-4, 0.05\n*BOUNDARY\nROOT, 1\n101, 2\n\
         *DSLOAD\nEND, TRSHR, {force:?}, 0., 1., 0.\n*END STEP\n"
    );
    let end = solved(&cards);
    // from the tip: psi the angle from the end, (x, y) in axes of the end
    let (steps, mut state) = (4000, [0.0_f64; 4]);
    let h = length / f64::from(steps);
    let slope = |[psi, curvature, _, _]: [f64; 4]| {
        [curvature, -force / stiffness * psi.cos(), psi.cos(), psi.sin()]
    };
    for _ in 0..steps {
        let moved = |by: f64, k: [f64; 4]| std::array::from_fn(|i| state[i] + by * k[i]);
        let k1 = slope(state);
        let k2 = slope(moved(0.5 * h, k1));
        let k3 = slope(moved(0.5 * h, k2));
        let k4 = slope(moved(h, k3));
        for i in 0..4 {
            state[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
        }
    }
    // the root stands along x: the tip is turned by minus the angle that was reached there
    let [psi, _, back, across] = state;
    let turn = -psi;
    let (sin, cos) = turn.sin_cos();
    let expected = [cos * back - sin * across, sin * back + cos * across];
    assert!(turn > 1.6, "{turn}");
    let found = end.place(141);
    for k in 0..2 {
        assert!((found[k] - expected[k]).abs() < 2e-3 * length, "{found:?} {expected:?}");
    }
}

/// Requirement: a traction that takes another direction in a second step leaves its old one over the step
/// while the new one comes: halves of both in the middle, in all ways to follow. Small
/// displacements; tolerance: rounding.
#[test]
fn another_direction_comes_over_the_step() {
    let step = |head: &str, load: &str| {
        format!("*STEP\n*STATIC, DIRECT\n0.5, 1.\n{head}*DSLOAD{load}\n*END STEP\n")
    };
    for first in ["", ", FOLLOWER=NO, CONSTANT RESULTANT=YES"] {
        for second in ["", ", FOLLOWER=NO", ", FOLLOWER=NO, CONSTANT RESULTANT=YES"] {
            let history =
                step("*BOUNDARY\nROOT, 1, 2\n", &format!("{first}\nEND, TRVEC, 4., 1., 0., 0."))
                    + &step("", &format!("{second}\nEND, TRVEC, 8., 0., 1., 0."))
                    + &step("", &format!("{second}\nEND, TRVEC, 2., 0., 1., 0."));
            let end = solved(&strip(&history).replace("99, 0., 0.\n", ""));
            let expected = [[1.0, 0.0], [2.0, 0.0], [1.0, 2.0], [0.0, 4.0], [0.0, 2.5], [0.0, 1.0]];
            for (found, expected) in end.reactions.iter().zip(expected) {
                let apart = (0..2).map(|k| (found[k] + expected[k]).abs()).fold(0.0, f64::max);
                assert!(apart < 1e-10, "{first} {second}: {found:?} {expected:?}");
            }
        }
    }
}
