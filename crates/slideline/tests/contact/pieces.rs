//! Masters in the plane that are in several pieces.
//!
//! ```text
//!         | |
//!      __ |_| __       a plug in a slot, both walls one surface
//!     |  |   |  |
//! ```

use crate::plane_blocks::block;
use crate::space_decks::solved;
use slideline::{Job, ReadOptions};

/// A plug between two walls that is moved down and to one of them, then to the other one.
fn deck(surfaces: &str, pairs: &str, cards: &str) -> String {
    let mut text = "*HEADING\nslot\n".to_owned();
    block(&mut text, ("LEFT", 1), [3, 3], [[-2.0, 0.0], [-0.5, 1.0]]);
    block(&mut text, ("RIGHT", 101), [3, 3], [[0.5, 0.0], [2.0, 1.0]]);
    block(&mut text, ("PLUG", 1001), [4, 6], [[-0.45, 1.1], [0.45, 3.0]]);
    format!(
        "{text}*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n*SURFACE INTERACTION, NAME=I\n*FRICTION\n0.2\n*SURFACE, NAME=P\nPLUG,\n{surfaces}{pairs}\
         *NSET, NSET=BASE, GENERATE\n1, 4\n101, 104\n*NSET, NSET=GRIP, GENERATE\n1031, 1035\n*BOUNDARY\nBASE, 1, 2\n\
         *STEP, NLGEOM\n*STATIC\n.1, 1., , .1\n{cards}*BOUNDARY\nGRIP, 1, 1, .08\nGRIP, 2, 2, -1.5\n*END STEP\n\
         *STEP, NLGEOM\n*STATIC\n.1, 1., , .1\n*BOUNDARY\nGRIP, 1, 1, -.08\n*END STEP\n"
    )
}

/// Requirement: one surface of both walls of a slot is as two surfaces with a pair each, over faces and at nodes, and cards that name
/// the pair mean both. Source: the deck with two. It was refused (SL0329). Tolerance: rounding.
#[test]
fn walls_of_a_slot_may_be_one_surface() {
    let apart = "*SURFACE, NAME=L\nLEFT,\n*SURFACE, NAME=R\nRIGHT,\n";
    let one = "*SURFACE, NAME=B\nLEFT,\nRIGHT,\n";
    for kind in ["SURFACE", "NODE"] {
        let card = format!("*CONTACT PAIR, INTERACTION=I, TYPE={kind} TO SURFACE\n");
        for allowed in [false, true] {
            let cards = |masters: &[&str]| -> String {
                let lines = masters.iter().map(|own| format!("P, {own}, .01\n"));
                if allowed {
                    format!("*CONTACT INTERFERENCE\n{}", lines.collect::<String>())
                } else {
                    String::new()
                }
            };
            let two =
                solved(&deck(apart, &format!("{card}P, L\n{card}P, R\n"), &cards(&["L", "R"])));
            let pieces = solved(&deck(one, &format!("{card}P, B\n"), &cards(&["B"])));
            assert_eq!(two.contact.len(), pieces.contact.len());
            assert!(two.force()[0] > 1.0, "{:?}", two.force());
            for (a, b) in two.nodes.iter().zip(&pieces.nodes) {
                let off = (0..2).map(|k| (a.2[k] - b.2[k]).abs()).fold(0.0, f64::max);
                assert!(a.0 == b.0 && off < 1e-9, "{kind} {allowed} {}: {off}", a.0);
            }
        }
    }
}

/// Requirement: *CLEARANCE and *MODEL CHANGE of the pair are those of both pieces, and *CONTACT PRINT finds them. Source: the deck
/// with two surfaces. Tolerance: rounding.
#[test]
fn cards_mean_all_pieces() {
    let apart = "*SURFACE, NAME=L\nLEFT,\n*SURFACE, NAME=R\nRIGHT,\n";
    let one = "*SURFACE, NAME=B\nLEFT,\nRIGHT,\n";
    let card = "*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\n";
    let clear = |masters: &[&str]| -> String {
        let lines =
            masters.iter().map(|own| format!("*CLEARANCE, SLAVE=P, MASTER={own}, VALUE=.02\n"));
        lines.collect()
    };
    let print = "*CONTACT PRINT, SLAVE=P, MASTER=B\nCSTRESS\n";
    let [two, pieces] = [
        (apart, format!("{card}P, L\n{card}P, R\n{}", clear(&["L", "R"])), ""),
        (one, format!("{card}P, B\n{}", clear(&["B"])), print),
    ]
    .map(|(surfaces, pairs, cards)| solved(&deck(surfaces, &pairs, cards)));
    assert_eq!(two.nodes, pieces.nodes);
    let read = Job::read_text(
        "print",
        &deck(one, &format!("{card}P, B\n"), print),
        &ReadOptions::default(),
    );
    assert!(!read.diagnostics.iter().any(|own| own.code.0 == "SL0252"), "{:#?}", read.diagnostics);
    let removed = "*MODEL CHANGE, TYPE=CONTACT PAIR, REMOVE\nP, B\n";
    let last = solved(&deck(one, &format!("{card}P, B\n"), removed));
    assert!(last.contact.iter().all(|row| row.pressure == 0.0));
}

/// Requirement: a card that names a pair means no other one whose master has that name with # and more behind it.
#[test]
fn names_with_a_number_sign_are_names() {
    let two = "*SURFACE, NAME=W\nLEFT,\n*SURFACE, NAME=W#1\nRIGHT,\n";
    let card = "*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\n";
    let pairs = format!("{card}P, W#1\n{card}P, W\n");
    let removed = "*MODEL CHANGE, TYPE=CONTACT PAIR, REMOVE\nP, W\n";
    let last = solved(&deck(two, &pairs, removed));
    let pressed = last.forces[..10].iter().map(|force| force[0].abs()).fold(0.0, f64::max);
    assert!(pressed > 1.0, "{pressed}");
}
