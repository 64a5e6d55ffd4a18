//! Axes of every element from a `*DISTRIBUTION`, judged on what runs leave.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use super::exactly;
use slideline::model::Dof;
use slideline::{Event, Observer, Stop};
use std::collections::BTreeMap;
use std::ops::ControlFlow;

#[derive(Default)]
struct Motions(BTreeMap<u64, [f64; 2]>);

impl Observer for Motions {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            for node in 0..frame.model.nodes.len() {
                let of = |dof| frame.nodal.displacement(node, dof);
                self.0.insert(frame.model.nodes.label(node), [Dof::U1, Dof::U2].map(of));
            }
        }
        ControlFlow::Continue(())
    }
}

fn motions(deck: &str) -> BTreeMap<u64, [f64; 2]> {
    exactly::solved::<Motions>(deck).0.0
}

/// Plies of 1 by 1 that stand apart, under the tension 2 along x; the section follows. Nodes of the ply
/// k: 10 k + 1 to 4.
fn plies(section: &str, step: &str) -> String {
    let (mut nodes, mut elements, mut held) = (String::new(), String::new(), String::new());
    for k in 0..4_u64 {
        let (first, y) = (10 * k, 2.0 * k as f64);
        nodes += &format!(
            "{}, 0., {y:?}\n{}, 1., {y:?}\n{}, 1., {:?}\n{}, 0., {:?}\n",
            first + 1,
            first + 2,
            first + 3,
            y + 1.0,
            first + 4,
            y + 1.0
        );
        let row: Vec<String> = (1..5).map(|n| (first + n).to_string()).collect();
        elements += &format!("{}, {}\n", k + 1, row.join(", "));
        held += &format!("{0}, 1, 2\n{1}, 1\n", first + 1, first + 4);
    }
    format!(
        "*NODE\n{nodes}*ELEMENT, TYPE=CPS4, ELSET=PLIES\n{elements}*SURFACE, NAME=RIGHT\nPLIES, S2\n\
         {section}*MATERIAL, NAME=M\n*ELASTIC, TYPE=LAMINA\n120., 9., 0.3, 5., 5., 3.\n\
         *STEP{step}\n*STATIC\n0.5, 1.\n*BOUNDARY\n{held}*DSLOAD\nRIGHT, TRVEC, 0.02, 1., 0., 0.\n*END STEP\n"
    )
}

const TABLE: &str = "*DISTRIBUTION TABLE, NAME=T\nCOORD3D, COORD3D\n";

/// Requirement: a ply under tension across its fibres stretches by sigma/Ex, 1/Ex = c^4/E1 + s^4/E2 +
/// (1/G12 - 2 nu12/E1) c^2 s^2, each of four with the angle of its line, of its set or of the default.
/// Source: Jones, Mechanics of Composite Materials. Small displacements; 1e-9.
#[test]
fn plies_of_several_angles() {
    let angles = [30.0_f64, 0.0, 45.0, 45.0];
    let line = |degrees: f64| {
        let (s, c) = degrees.to_radians().sin_cos();
        format!("{c:?}, {s:?}, 0., {:?}, {c:?}, 0.", -s)
    };
    let section = format!(
        "{TABLE}*ELSET, ELSET=LAST\n3, 4\n*DISTRIBUTION, NAME=D, LOCATION=ELEMENT, TABLE=T\n\
         , {}\n1, {}\nLAST, {}\n*ORIENTATION, NAME=O\nD\n\
         *SOLID SECTION, ELSET=PLIES, MATERIAL=M, ORIENTATION=O\n",
        line(0.0),
        line(30.0),
        line(45.0)
    );
    let found = motions(&plies(&section, ""));
    for (k, angle) in angles.into_iter().enumerate() {
        let (s, c) = angle.to_radians().sin_cos();
        let softness =
            c.powi(4) / 120.0 + s.powi(4) / 9.0 + (1.0 / 5.0 - 0.6 / 120.0) * (c * s).powi(2);
        let stretch = found[&(10 * k as u64 + 2)][0];
        assert!((stretch / (0.02 * softness) - 1.0).abs() < 1e-9, "{angle} {stretch}");
    }
}

/// Requirement: with large motion, too, the elements of one section are what they are in sections of
/// their own, and a step may give all of them other axes. Tolerance: rounding.
#[test]
fn one_section_or_several() {
    let lines =
        ["0.8, 0.6, 0., -0.6, 0.8, 0.", "1., 0., 0., 0., 1., 0.", "0., 1., 0., -1., 0., 0."];
    let each = |at: usize| lines[at % 3];
    let mut one =
        format!("{TABLE}*DISTRIBUTION, NAME=D, LOCATION=ELEMENT, TABLE=T\n, {}\n", each(0));
    let mut several = String::new();
    for k in 0..4 {
        if k % 3 > 0 {
            one += &format!("{}, {}\n", k + 1, each(k));
        }
        several += &format!(
            "*ELSET, ELSET=P{k}\n{},\n*ORIENTATION, NAME=O{k}\n{}\n\
             *SOLID SECTION, ELSET=P{k}, MATERIAL=M, ORIENTATION=O{k}\n",
            k + 1,
            each(k)
        );
    }
    one += "*ORIENTATION, NAME=O\nD\n";
    let own = format!("{one}*SOLID SECTION, ELSET=PLIES, MATERIAL=M, ORIENTATION=O\n");
    let apart = |a: &BTreeMap<u64, [f64; 2]>, b: &BTreeMap<u64, [f64; 2]>| {
        let each =
            a.iter().flat_map(|(label, u)| u.iter().zip(b[label]).map(|(a, b)| (a - b).abs()));
        each.fold(0.0, f64::max)
    };
    let expected = motions(&plies(&several, ", NLGEOM"));
    let found = motions(&plies(&own, ", NLGEOM"));
    assert!(apart(&found, &expected) < 1e-14, "{}", apart(&found, &expected));
    let plain = format!("{one}*SOLID SECTION, ELSET=PLIES, MATERIAL=M\n");
    let changed = plies(&plain, ", NLGEOM").replace(
        "*STATIC\n",
        "*CHANGE SOLID SECTION, ELSET=PLIES, MATERIAL=M, ORIENTATION=O\n*STATIC\n",
    );
    let found = motions(&changed);
    assert!(apart(&found, &expected) < 1e-12, "{}", apart(&found, &expected));
}
