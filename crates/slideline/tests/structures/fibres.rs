//! Soft tissue with fibres through decks: `*ANISOTROPIC HYPERELASTIC, HOLZAPFEL`.
//!
//! Source: docs/theory.md eqs (3.113) to (3.115), the energy by hand.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use super::exactly;
use slideline::model::Dof;
use slideline::observe::Totals;
use slideline::{Event, Job, Observer, ReadOptions, Stop};
use std::ops::ControlFlow;

const AXES: [Dof; 3] = [Dof::U1, Dof::U2, Dof::U3];

#[derive(Default)]
struct End {
    /// Displacements and reactions, three a node.
    motion: Vec<f64>,
    reaction: Vec<f64>,
    totals: Option<Totals>,
}

impl Observer for End {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            let nodes = || 0..frame.model.nodes.len();
            let moved = |node| AXES.map(|dof| frame.nodal.displacement(node, dof));
            let held = |node| AXES.map(|dof| frame.nodal.reaction(node, dof));
            self.motion = nodes().flat_map(moved).collect();
            self.reaction = nodes().flat_map(held).collect();
        }
        ControlFlow::Continue(())
    }
}

/// A unit cube of C10 = 1.2, D = 0.4, k1 = 0.9, k2 = 1.5, kappa = 0.1 with cards of its orientation.
fn deck(kind: &str, orientation: &str, families: usize, step: &str, held: &str) -> String {
    format!(
        "*NODE, NSET=ALL\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 1., 1., 0.\n4, 0., 1., 0.\n5, 0., 0., 1.\n6, 1., 0., 1.\n\
         7, 1., 1., 1.\n8, 0., 1., 1.\n*ELEMENT, TYPE={kind}, ELSET=E\n1, 1, 2, 3, 4, 5, 6, 7, 8\n\
         {orientation}*SOLID SECTION, ELSET=E, MATERIAL=M, ORIENTATION=O\n*MATERIAL, NAME=M\n\
         *ANISOTROPIC HYPERELASTIC, HOLZAPFEL, LOCAL DIRECTIONS={families}\n1.2, 0.4, 0.9, 1.5, 0.1\n\
         *NSET, NSET=X0\n1, 4, 5, 8\n*NSET, NSET=X1\n2, 3, 6, 7\n*STEP{step}\n*STATIC\n0.25, 1.\n*BOUNDARY\n\
         {held}*END STEP\n"
    )
}

fn solved(deck: &str) -> End {
    let (end, totals) = exactly::solved::<End>(deck);
    End { totals: Some(totals), ..end }
}

fn pull(end: &End) -> f64 {
    [1, 2, 5, 6].iter().map(|&node| end.reaction[3 * node]).sum()
}

/// Requirement: a cube that is stretched between walls, its sides held, pulls with dW/dl, two
/// families of fibres at 30 degrees about the pull; with small displacements with the moduli of
/// small strain. Tolerance: that of the difference of energies, 1e-8.
#[test]
fn a_cube_between_walls() {
    let (sin, cos) = 30.0_f64.to_radians().sin_cos();
    let axes = format!(
        "*ORIENTATION, NAME=O, LOCAL DIRECTIONS=2\n1., 0., 0., 0., 1., 0.\n3, 0.\n{cos:?}, {sin:?}, 0.\n\
         {cos:?}, {:?}, 0.\n",
        -sin
    );
    let energy = |l: f64| {
        let shape = l.powf(-2.0 / 3.0);
        let first = shape * (l * l + 2.0) - 3.0;
        let along = shape * (l * l * cos * cos + sin * sin) - 1.0;
        let e = (0.1 * first + 0.7 * along).max(0.0);
        1.2 * first
            + (0.5 * (l * l - 1.0) - l.ln()) / 0.4
            + 2.0 * 0.9 / 3.0 * (1.5 * e * e).exp_m1()
    };
    for travel in [0.4, -0.25] {
        let held = format!("ALL, 2, 3\nX0, 1\nX1, 1, 1, {travel:?}\n");
        let end = solved(&deck("C3D8", &axes, 2, ", NLGEOM", &held));
        let l = 1.0 + travel;
        let exact = (energy(l + 1e-5) - energy(l - 1e-5)) / 2e-5;
        assert!((pull(&end) - exact).abs() < 1e-8 * (1.0 + exact.abs()), "{} {exact}", pull(&end));
        let end = solved(&deck("C3D8", &axes, 2, "", &held));
        let way = 2.0 * 0.7 * (cos * cos - 1.0 / 3.0);
        let fibres = if travel > 0.0 { 2.0 * 0.9 * way * way } else { 0.0 };
        let exact = travel * (2.0 / 0.4 + 4.0 / 3.0 * 2.4 + fibres);
        assert!((pull(&end) - exact).abs() < 1e-9, "small {} {exact}", pull(&end));
    }
}

/// Requirement: directions are along the axes of the orientation: turned axes with directions along them are
/// plain axes with directions turned, far from rest, with Newton's rate. Tolerance: 1e-9.
#[test]
fn directions_are_along_the_axes() {
    let held = "X0, 1, 3\nX1, 1, 1, 0.5\nX1, 2, 2, 0.3\n";
    // axes turned by 30 degrees about z, then by 20 about the new z: fibres along the turned axis 1
    let turned = "*ORIENTATION, NAME=O, LOCAL DIRECTIONS=1\n0.8660254037844387, 0.5, 0., -0.5, \
                  0.8660254037844387, 0.\n3, 20.\n2., 0., 0.\n";
    let (sin, cos) = 50.0_f64.to_radians().sin_cos();
    let plain = format!(
        "*ORIENTATION, NAME=O, LOCAL DIRECTIONS=1\n1., 0., 0., 0., 1., 0.\n3, 0.\n{cos:?}, {sin:?}, 0.\n"
    );
    let one = solved(&deck("C3D8I", turned, 1, ", NLGEOM", held));
    let other = solved(&deck("C3D8I", &plain, 1, ", NLGEOM", held));
    for (one, other) in one.motion.iter().zip(&other.motion) {
        assert!((one - other).abs() < 1e-9, "{one} {other}");
    }
    let across = solved(&deck("C3D8I", &plain.replace("3, 0.", "3, 90."), 1, ", NLGEOM", held));
    assert!((pull(&across) - pull(&one)).abs() > 1e-2);
    let totals = one.totals.unwrap();
    assert!(totals.iterations <= 6 * 4, "{}", totals.iterations);
}

/// Requirement: what a tissue cannot be is refused with its line.
#[test]
fn what_is_refused() {
    let axes =
        "*ORIENTATION, NAME=O, LOCAL DIRECTIONS=1\n1., 0., 0., 0., 1., 0.\n3, 0.\n1., 0., 0.\n";
    let sound = deck("C3D8", axes, 1, ", NLGEOM", "X0, 1, 3\nX1, 1, 1, 0.1\n");
    let codes = |deck: &str| -> Vec<&'static str> {
        let said = Job::read_text("fibres", deck, &ReadOptions::default()).diagnostics;
        let errors = said.iter().filter(|own| own.severity.word() == "error");
        errors.map(|own| own.code.0).collect()
    };
    assert_eq!(codes(&sound), [""; 0]);
    for (old, new, code) in [
        (", HOLZAPFEL", ", FUNG-ORTHOTROPIC", "SL0221"),
        (", HOLZAPFEL", "", "SL0221"),
        (", ORIENTATION=O", "", "SL0309"),
        ("HOLZAPFEL, LOCAL DIRECTIONS=1", "HOLZAPFEL, LOCAL DIRECTIONS=2", "SL0309"),
        ("HOLZAPFEL, LOCAL DIRECTIONS=1", "HOLZAPFEL, LOCAL DIRECTIONS=4", "SL0234"),
        ("1.2, 0.4,", "1.2, 0.,", "SL0234"),
        ("1.5, 0.1", "1.5, 0.5", "SL0234"),
        ("3, 0.\n1., 0., 0.\n", "3, 0.\n", "SL0208"),
        ("3, 0.\n1., 0., 0.\n", "3, 0.\n0., 0., 0.\n", "SL0232"),
        ("*NSET, NSET=X0", "*PLASTIC\n1., 0.\n*NSET, NSET=X0", "SL0309"),
        ("*NSET, NSET=X0", "*VISCOELASTIC, TIME=PRONY\n.5, .5, 1.\n*NSET, NSET=X0", "SL0309"),
    ] {
        assert!(sound.contains(old), "{old}");
        let found = codes(&sound.replacen(old, new, 1));
        assert!(found.contains(&code), "{new}: {found:?}");
    }
}
