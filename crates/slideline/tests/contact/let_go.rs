//! Bodies that nothing but contact holds stay where it leaves them.
//!
//! ```text
//!      push              let go
//!    |=>[ ]         <=|    [ ]        without mass a body has no momentum: the first guess of an
//!    =========      =========         increment must not let it fly on
//! ```
//!
//! docs/theory.md section 8.2

#![allow(clippy::unwrap_used)] // a test may fail where it stands

use crate::space_decks::{Last, solved};
use std::fmt::Write as _;

/// Nodes and elements of a plane block of so many cells; nodes are numbered along its rows.
fn block(
    text: &mut String,
    (name, base): (&str, usize),
    cells: [usize; 2],
    corners: [[f64; 2]; 2],
) {
    let [low, high] = corners;
    let node = |i: usize, j: usize| base + i + (cells[0] + 1) * j;
    let _ = writeln!(text, "*NODE");
    for j in 0..=cells[1] {
        for i in 0..=cells[0] {
            let at = |axis: usize, k: usize| {
                low[axis] + (high[axis] - low[axis]) * k as f64 / cells[axis] as f64
            };
            let _ = writeln!(text, "{}, {:?}, {:?}", node(i, j), at(0, i), at(1, j));
        }
    }
    let _ = writeln!(text, "*ELEMENT, TYPE=CPS4, ELSET={name}");
    for j in 0..cells[1] {
        for i in 0..cells[0] {
            let corners = [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)];
            let corners = corners.map(|own| own.to_string()).join(", ");
            let _ = writeln!(text, "{}, {corners}", node(i, j));
        }
    }
    let _ = writeln!(text, "*SOLID SECTION, ELSET={name}, MATERIAL=M\n1.");
}

const MATERIAL: &str =
    "*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n*SURFACE INTERACTION, NAME=I\n*FRICTION\n0.2\n";
const GENERAL: &str =
    "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\n, , I\n";

/// The mean motion of the nodes from a label on.
fn moved(last: &Last, from: u64) -> [f64; 2] {
    let own: Vec<_> = last.nodes.iter().filter(|(label, ..)| *label >= from).collect();
    [0, 1].map(|axis| own.iter().map(|own| own.2[axis]).sum::<f64>() / own.len() as f64)
}

/// Requirement: a block that stands 0.01 in another one is set upon it, and stays there, in however many increments. In ten it rose
/// by 0.186, and nothing was said. Tolerance: 1e-9 of the size.
#[test]
fn a_block_that_is_set_free_does_not_rise() {
    for increments in [1, 2, 10, 60] {
        let mut text = "*HEADING\nset free\n".to_owned();
        block(&mut text, ("LOW", 1), [8, 2], [[-4.0, -2.0], [4.0, 0.0]]);
        block(&mut text, ("UP", 1001), [5, 1], [[-2.0, -0.01], [2.0, 0.99]]);
        text += MATERIAL;
        text += GENERAL;
        let step = 1.0 / f64::from(increments);
        let _ = write!(
            text,
            "*NSET, NSET=BASE, GENERATE\n1, 9\n*BOUNDARY\nBASE, 1, 2\n*STEP, NLGEOM\n*STATIC\n{step:?}, 1., , {step:?}\n\
             *END STEP\n"
        );
        let [_, up] = moved(&solved(&text), 1001);
        assert!((up - 0.01).abs() < 1e-9, "{increments}: {up}");
    }
}

/// Requirement: a block between rails that another one pushes and lets go stays where that was farthest, in increments of a step of
/// one amplitude; its rails hold it across. Tolerance: 1e-6, what iterations leave.
#[test]
fn what_is_pushed_stays_when_the_push_ends() {
    for increments in [10, 20, 37] {
        let mut text = "*HEADING\npush\n".to_owned();
        block(&mut text, ("PUSH", 1), [2, 2], [[-2.1, 0.0], [-0.1, 1.0]]);
        block(&mut text, ("FREE", 1001), [2, 3], [[0.0, 0.0], [2.0, 1.0]]);
        text += MATERIAL;
        text += GENERAL;
        let step = 1.0 / f64::from(increments);
        let _ = write!(
            text,
            "*NSET, NSET=GRIP, GENERATE\n1, 9\n*NSET, NSET=RAILED, GENERATE\n1001, 1012\n\
             *AMPLITUDE, NAME=GO\n0., 0., .6, 1., 1., 0.\n*BOUNDARY\nRAILED, 2, 2\nGRIP, 2, 2\n\
             *STEP, NLGEOM\n*STATIC\n{step:?}, 1., , {step:?}\n*BOUNDARY, AMPLITUDE=GO\nGRIP, 1, 1, .6\n*END STEP\n"
        );
        let [along, _] = moved(&solved(&text), 1001);
        // as far as it was pushed at the end of an increment
        let most = (0..=increments).map(|k| f64::from(k) * step);
        let most = most.map(|t| if t <= 0.6 { t / 0.6 } else { (1.0 - t) / 0.4 });
        let farthest = 0.6 * most.fold(0.0, f64::max) - 0.1;
        assert!((along - farthest).abs() < 1e-6, "{increments}: {along}, not {farthest}");
    }
}
