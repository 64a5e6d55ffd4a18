//! Normals of beams, `*NORMAL`, and axes of sections that turn with parts: closed forms, and decks that say
//! the same in other words.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use super::exactly;
use slideline::model::Dof;
use slideline::{Event, Job, Observer, ReadOptions, Stop};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::ops::ControlFlow;

#[derive(Default)]
struct Motions(BTreeMap<String, [f64; 3]>);

impl Observer for Motions {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            for node in 0..frame.model.nodes.len() {
                let of = |dof| frame.nodal.displacement(node, dof);
                let name = frame.model.nodes.name(node).to_string();
                self.0.insert(name, [Dof::U1, Dof::U2, Dof::U3].map(of));
            }
        }
        ControlFlow::Continue(())
    }
}

fn motions(deck: &str) -> BTreeMap<String, [f64; 3]> {
    exactly::solved::<Motions>(deck).0.0
}

fn errors(deck: &str) -> Vec<String> {
    let said = Job::read_text("normals", deck, &ReadOptions::default()).diagnostics;
    let errors = said.into_iter().filter(|own| own.severity.word() == "error");
    errors.map(|own| own.code.0.to_owned()).collect()
}

/// The largest difference of displacements of nodes of the same name.
fn apart(one: &BTreeMap<String, [f64; 3]>, other: &BTreeMap<String, [f64; 3]>) -> f64 {
    let each = one.iter().flat_map(|(name, own)| {
        own.iter().zip(other[name]).map(|(a, b)| (a - b).abs()).collect::<Vec<_>>()
    });
    each.fold(0.0, f64::max)
}

/// A cantilever of length 1 along x with so many elements of a type, RECT 0.04 by 0.02, E = 1e6, nu = 0,
/// under a force of 0.01 (1, 1)/sqrt 2 across its end, or what `history` says.
fn arm(kind: &str, count: usize, cards: &str, first_axis: &str, step: &str) -> String {
    let each = if kind == "B31" { 1 } else { 2 };
    let mut deck = String::from("*NODE, NSET=ALL\n");
    for i in 0..=each * count {
        let _ = writeln!(deck, "{}, {:?}, 0., 0.", i + 1, i as f64 / (each * count) as f64);
    }
    let _ = writeln!(deck, "*ELEMENT, TYPE={kind}, ELSET=B");
    for e in 0..count {
        let nodes: Vec<String> = (0..=each).map(|k| (1 + each * e + k).to_string()).collect();
        let _ = writeln!(deck, "{}, {}", e + 1, nodes.join(", "));
    }
    let end = each * count + 1;
    let _ = write!(
        deck,
        "{cards}*BEAM SECTION, SECTION=RECT, ELSET=B, MATERIAL=M\n0.04, 0.02\n{first_axis}\n\
         *MATERIAL, NAME=M\n*ELASTIC\n1e6, 0.\n*STEP{step}\n*STATIC\n0.5, 1.\n*BOUNDARY\n1, 1, 6\n\
         *CLOAD\n{end}, 2, 0.0070710678118654755\n{end}, 3, 0.0070710678118654755\n*END STEP\n"
    );
    deck
}

/// Requirement: normals are n2 of the section, also where they lean along the axis, over a direction n1
/// that says otherwise; large motion, B31 and B32. Source: Abaqus manual, orientation of sections of
/// beams. Tolerance: rounding.
#[test]
fn a_normal_is_axis_two() {
    // n2 = (0, 0.6, 0.8): n1 = n2 x t = (0, 0.8, -0.6)
    for kind in ["B31", "B32"] {
        let named = motions(&arm(kind, 4, "", "0., 0.8, -0.6", ", NLGEOM"));
        for normal in ["0., 0.6, 0.8", "0.7, 1.2, 1.6"] {
            let cards = format!("*NORMAL\nB, ALL, {normal}\n");
            let given = motions(&arm(kind, 4, &cards, "0., 0., -1.", ", NLGEOM"));
            assert!(apart(&named, &given) < 1e-12, "{kind} {normal}");
            let turned = motions(&arm(kind, 4, "", "0., 0., -1.", ", NLGEOM"));
            assert!(apart(&named, &turned) > 1e-3, "{kind}");
        }
    }
}

/// Requirement: normals that turn by a right angle from the root to the end make a pretwisted beam, whose
/// end moves by P int (L - s)^2 C(s) ds, C = R diag(1/EI11, 1/EI22) R' with the angle of the section at s. 80
/// elements B31, small displacements; shear is (h/L)^2 = 0.1 % of it: 0.5 %.
#[test]
fn a_pretwisted_beam() {
    let count = 80;
    let quarter = std::f64::consts::FRAC_PI_2;
    let mut cards = String::from("*NORMAL\n");
    for i in 0..=count {
        let (sin, cos) = (quarter * i as f64 / count as f64).sin_cos();
        for e in [i, i + 1] {
            if (1..=count).contains(&e) {
                let _ = writeln!(cards, "{e}, {}, 0., {cos:?}, {sin:?}", i + 1);
            }
        }
    }
    let found = motions(&arm("B31", count, &cards, "0., 0., -1.", ""))[&(count + 1).to_string()];
    // softness along n2 and n1 of the section
    let along = [12.0 / (1e6 * 0.04 * 0.02_f64.powi(3)), 12.0 / (1e6 * 0.02 * 0.04_f64.powi(3))];
    let (mut expected, steps) = ([0.0, 0.0], 20_000);
    let force = 0.01 / 2.0_f64.sqrt();
    for k in 0..steps {
        let s = (k as f64 + 0.5) / steps as f64;
        let (sin, cos) = (quarter * s).sin_cos();
        let arm = (1.0 - s).powi(2) / steps as f64 * force;
        let (across, second) = (cos + sin, cos - sin); // of (1, 1) along n2 and along (-sin, cos)
        expected[0] += arm * (along[0] * across * cos - along[1] * second * sin);
        expected[1] += arm * (along[0] * across * sin + along[1] * second * cos);
    }
    for k in 0..2 {
        assert!((found[k + 1] / expected[k] - 1.0).abs() < 5e-3, "{found:?} {expected:?}");
    }
}

/// Requirement: a load across the section is along the axis that a node behind the element, or a normal,
/// gives it, as it is along that of the section card. Source: Abaqus manual, `*DLOAD` (P1, P2). Tolerance:
/// rounding.
#[test]
fn loads_follow_the_axes_of_elements() {
    let loaded =
        |deck: String| deck.replace("*CLOAD\n", "*DLOAD\nB, P1, 0.1\nB, P2, 0.05\n*CLOAD\n");
    let named = motions(&loaded(arm("B31", 4, "", "0., 0.8, -0.6", ", NLGEOM")));
    let given = arm("B31", 4, "*NORMAL\nB, ALL, 0., 0.6, 0.8\n", "0., 0., -1.", ", NLGEOM");
    assert!(apart(&named, &motions(&loaded(given))) < 1e-12);
    let mut behind = arm("B31", 4, "*NODE\n99, 0., 800., -600.\n", "0., 0., -1.", ", NLGEOM");
    for e in 1..=4 {
        behind = behind
            .replace(&format!("\n{e}, {e}, {}\n", e + 1), &format!("\n{e}, {e}, {}, 99\n", e + 1));
    }
    let mut behind = motions(&loaded(behind));
    behind.remove("99");
    // the direction is that from each first node: nearly the same from far away
    assert!(apart(&behind, &named) < 1e-5, "{}", apart(&behind, &named));
}

/// Requirement: axis 1 of sections and normals turn with the instance of their part: the turned arm moves as
/// the arm under the load turned back, turned. Tolerance: rounding.
#[test]
fn axes_turn_with_the_instance() {
    for cards in ["", "*Normal\nB, All, 0., 0.6, 0.8\n"] {
        let deck = |place: &str, load: &str| {
            format!(
                "*Part, name=Arm\n*Node, nset=All\n1, 0., 0., 0.\n2, 0.5, 0., 0.\n3, 1., 0., 0.\n\
                 *Element, type=B31, elset=B\n1, 1, 2\n2, 2, 3\n{cards}\
                 *Beam Section, section=RECT, elset=B, material=M\n0.04, 0.02\n0., 0.8, -0.6\n*End Part\n\
                 *Assembly, name=A\n*Instance, name=Arm-1, part=Arm\n{place}*End Instance\n*End Assembly\n\
                 *Material, name=M\n*Elastic\n1e6, 0.\n*Step, nlgeom\n*Static\n0.5, 1.\n*Boundary\n\
                 Arm-1.1, 1, 6\n*Cload\n{load}*End Step\n"
            )
        };
        // by 90 degrees about x: y becomes z, z becomes -y
        let plain = motions(&deck("", "Arm-1.3, 2, 0.02\nArm-1.3, 3, 0.01\n"));
        let turn = "0., 0., 0.\n0., 0., 0., 1., 0., 0., 90.\n";
        let turned = motions(&deck(turn, "Arm-1.3, 3, 0.02\nArm-1.3, 2, -0.01\n"));
        let end = |motions: &BTreeMap<String, [f64; 3]>| *motions.values().last().unwrap();
        let ([x, y, z], found) = (end(&plain), end(&turned));
        let off = found.iter().zip([x, -z, y]).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < 1e-12 && y.abs() > 1e-3, "{cards}{found:?} {plain:?}");
    }
}

/// Requirement: normals that mean nothing are refused, in the plane those that are not across the beam
/// to its left; those that are change nothing.
#[test]
fn normals_that_cannot_be() {
    let space = |cards: &str, kind: &str| arm(kind, 2, cards, "0., 0., -1.", "");
    for (cards, kind, code) in [
        ("*NORMAL\nB, ALL, 1., 0., 0.\n", "B31", "SL0375"),
        ("*NORMAL\nB, ALL, 0., 0., 0.\n", "B31", "SL0232"),
        ("*NORMAL\n1, 3, 0., 1., 0.\n", "B31", "SL0304"),
        ("*NORMAL\n7, 1, 0., 1., 0.\n", "B31", "SL0308"),
        ("*NORMAL\n1, 77, 0., 1., 0.\n", "B31", "SL0304"),
        ("*NORMAL\n1, 1, 0., 0., 1.\n", "B32", "SL0221"),
        ("*NORMAL, TYPE=CONTACT SURFACE\nS, ALL, 0., 1., 0.\n", "B31", "SL0221"),
        ("*NORMAL\n", "B31", "SL0208"),
        ("*ELEMENT, TYPE=T3D2, ELSET=T\n91, 1, 2\n*NORMAL\nT, ALL, 0., 1., 0.\n", "B31", "SL0325"),
    ] {
        let found = errors(&space(cards, kind));
        assert!(found.iter().any(|own| own == code), "{cards}: {found:?}");
    }
    let plane = |cards: &str| {
        arm("B31", 2, cards, "0., 0., -1.", "")
            .replace("B31", "B21")
            .replace("3, 3, 0.00", "3, 1, 0.00")
    };
    let plain = motions(&plane(""));
    assert!(apart(&plain, &motions(&plane("*NORMAL\nB, ALL, 0.1, 1., 0.\n"))) == 0.0);
    for normal in ["0., -1., 0.", "1., 1., 0.", "0., 0., 1."] {
        let found = errors(&plane(&format!("*NORMAL\nB, ALL, {normal}\n")));
        assert!(
            found.iter().all(|own| own == "SL0221") && !found.is_empty(),
            "{normal}: {found:?}"
        );
    }
}
