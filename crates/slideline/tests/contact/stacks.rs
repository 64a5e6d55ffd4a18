//! Stacks of blocks in space in general contact: sides that are flush, edges that overhang a little, blocks that
//! nothing but friction holds.
//!
//! ```text
//!          +------+
//!       +--+---+--+        the corner that overhangs stands beyond an edge of the other block and on or
//!       +------+           beside the next one: all faces at the corner of that are as near
//! ```
//!
//! docs/theory.md 5.8 and 5.14.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use super::space_decks::{Block, Kind, ended};
use slideline::SolveOptions;
use slideline::observe::Ending;
use std::fmt::Write;

/// A block: its size, cells and middle across, and its modulus.
#[derive(Clone, Copy, Debug)]
struct Layer {
    size: [f64; 3],
    cells: [usize; 3],
    middle: [f64; 2],
    modulus: f64,
}

/// Blocks upon one another, pressed from above, then drawn along.
fn deck(kind: Kind, layers: &[Layer], friction: f64, (pressed, drawn): (f64, f64)) -> String {
    let (mut text, mut height) = (String::from("*HEADING\nstack\n"), 0.0);
    let names = ["A", "B", "C", "D"];
    for (number, (layer, name)) in layers.iter().zip(names).enumerate() {
        let block = Block { name, base: 10_000 * number as u64, cells: layer.cells, kind };
        let place = |at: [f64; 3]| {
            let [x, y] = [0, 1].map(|k| layer.middle[k] + layer.size[k] * (at[k] - 0.5));
            [x, y, height + layer.size[2] * at[2]]
        };
        block.write(&mut text, place);
        height += layer.size[2];
        let modulus = layer.modulus;
        write!(
            text,
            "*SOLID SECTION, ELSET={name}, MATERIAL={name}\n*MATERIAL, NAME={name}\n*ELASTIC\n{modulus:?}, 0.3\n"
        )
        .unwrap();
        text += &block.set(&format!("LOW{name}"), |at| at[2] == 0.0);
        text += &block.set(&format!("TOP{name}"), |at| at[2] == 1.0);
    }
    let rubs = if friction > 0.0 { format!("*FRICTION\n{friction:?}\n") } else { String::new() };
    let top = names[layers.len() - 1];
    text + &format!(
        "*SURFACE INTERACTION, NAME=I\n{rubs}*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n\
         *CONTACT PROPERTY ASSIGNMENT\n, , I\n*BOUNDARY\nLOWA, 1, 3\n*STEP, NLGEOM\n*STATIC\n1.0, 1.0\n*BOUNDARY\n\
         TOP{top}, 1, 2\nTOP{top}, 3, 3, {:?}\n*END STEP\n*STEP, NLGEOM\n*STATIC\n0.25, 1.0\n*BOUNDARY\n\
         TOP{top}, 1, 1, {drawn:?}\n*END STEP\n",
        -pressed
    )
}

/// Checks that a stack completes with no attempt given up and few iterations, and that it presses.
fn stands(what: &str, deck: &str) {
    let (ending, last) = ended(deck, &SolveOptions::default());
    assert!(matches!(ending, Ending::Completed(_)), "{what}: {ending:?}");
    assert_eq!(last.given_up, 0, "{what}");
    assert!(last.most() <= 7, "{what}: {} iterations", last.most());
    assert!(last.force()[2].abs() > 1e-3, "{what}: {:?}", last.force());
}

/// Requirement: equal blocks shifted by less than a tenth of a face along sides that are flush, lower one softer or
/// equal, two or three of them, complete: where they stand beyond corners of one another all faces there answer alike.
#[test]
fn shifted_equal_blocks_stand() {
    let layer =
        |middle, modulus| Layer { size: [4.0, 2.0, 2.0], cells: [4, 3, 1], middle, modulus };
    for (kind, shift) in
        [(Kind::C3d8, 0.05), (Kind::C3d8i, 0.05), (Kind::C3d8, 0.03), (Kind::C3d8, 0.075)]
    {
        for soft in [1000.0, 5000.0] {
            let two = [layer([0.0, 0.0], soft), layer([shift, 0.0], 5000.0)];
            stands(&format!("{kind:?} {shift} {soft}"), &deck(kind, &two, 0.0, (0.01, 0.05)));
        }
        let third = layer([shift + 0.5, -0.2], 5000.0);
        let three = [layer([0.0, 0.0], 1000.0), layer([shift, 0.0], 5000.0), third];
        stands(&format!("three {kind:?} {shift}"), &deck(kind, &three, 0.5, (0.01, 0.05)));
    }
}

/// Requirement: quadratic blocks whose sides are flush complete: nodes that stand on an edge and bulge past it have
/// cut no more than that edge.
#[test]
fn flush_quadratic_blocks_stand() {
    let below =
        Layer { size: [2.0, 3.0, 1.0], cells: [4, 2, 1], middle: [0.0, 0.0], modulus: 1000.0 };
    let above =
        Layer { size: [3.0, 3.0, 1.5], cells: [3, 2, 2], middle: [-0.3, 0.0], modulus: 1000.0 };
    for friction in [0.0, 0.2] {
        stands(
            &format!("{friction}"),
            &deck(Kind::C3d20r, &[below, above], friction, (0.03, 0.05)),
        );
    }
}
