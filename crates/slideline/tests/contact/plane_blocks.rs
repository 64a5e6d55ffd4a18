//! Blocks of plane elements as text, for decks that several files of tests write.

use std::fmt::Write as _;

/// Nodes and elements of a plane block of so many cells; nodes are numbered along its rows.
pub fn block(
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

pub const MATERIAL: &str =
    "*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n*SURFACE INTERACTION, NAME=I\n*FRICTION\n0.2\n";
pub const GENERAL: &str =
    "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\n, , I\n";

/// The cards of a step in so many increments, with what is prescribed in it.
pub fn step(increments: usize, cards: &str) -> String {
    let size = 1.0 / increments as f64;
    format!("*STEP, NLGEOM\n*STATIC\n{size:?}, 1., , {size:?}\n{cards}*END STEP\n")
}
