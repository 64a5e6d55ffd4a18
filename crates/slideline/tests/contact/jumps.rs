//! Masters of elements that would pass a part within one increment.
//!
//! ```text
//!     +--+      |          +--+     at both ends of the increment nothing touches: the way between
//!     |  | ==>  |  leaf    |  |     tells that the block went through the leaf
//!     +--+      |          +--+
//! ```
//!
//! docs/theory.md section 5.8

use crate::let_go::block;
use crate::space_decks::solved;

/// A leaf and a block that is moved past its end in one increment, if it is let; `rigid`: as a rigid body of line elements.
fn deck(contact: &str, rigid: bool) -> String {
    let mut text = "*HEADING\njump\n".to_owned();
    block(&mut text, ("LEAF", 1), [1, 20], [[0.0, 0.0], [0.2, 4.0]]);
    let moved = match rigid {
        true => {
            text += "*NODE\n1001, -1.5, 3.5\n1002, -.5, 3.5\n1003, -.5, 4.5\n1004, -1.5, 4.5\n9000, -1., 4.\n\
                     *ELEMENT, TYPE=R2D2, ELSET=BLOCK\n1001, 1001, 1002\n1002, 1002, 1003\n1003, 1003, 1004\n1004, 1004, 1001\n\
                     *RIGID BODY, REF NODE=9000, ELSET=BLOCK\n*SURFACE, NAME=B\nBLOCK, SNEG\n*NSET, NSET=MOVED\n9000\n";
            "9000, 6\n"
        }
        false => {
            block(&mut text, ("BLOCK", 1001), [2, 2], [[-1.5, 3.5], [-0.5, 4.5]]);
            text += "*SURFACE, NAME=B\nBLOCK,\n*NSET, NSET=MOVED, GENERATE\n1001, 1009\n";
            ""
        }
    };
    format!(
        "{text}*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n*SURFACE INTERACTION, NAME=I\n*SURFACE, NAME=A\nLEAF,\n{contact}\
         *BOUNDARY\n1, 1, 2\n2, 1, 2\n{moved}MOVED, 2\n*STEP, NLGEOM, INC=1000\n*STATIC\n1., 1., 1e-7, 1.\n*BOUNDARY\nMOVED, 1, 1, 3.\n*END STEP\n"
    )
}

/// Requirement: a block that goes past a leaf by more than both are wide in the only increment asked for is met on the way, with the
/// leaf or the block as the slave, over faces and at nodes, of solids and of rigid lines. Before, the run was complete with exactly no force.
#[test]
fn a_master_of_elements_is_not_passed_in_one_increment() {
    let pair = |kind: &str, roles: &str| {
        format!("*CONTACT PAIR, INTERACTION=I, TYPE={kind} TO SURFACE\n{roles}\n")
    };
    let general =
        "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\n, , I\n"
            .to_owned();
    let mut peaks = Vec::new();
    for (contact, rigid) in [
        (pair("SURFACE", "A, B"), false),
        (pair("NODE", "A, B"), false),
        (pair("SURFACE", "A, B"), true),
        (pair("NODE", "A, B"), true),
        (pair("SURFACE", "B, A"), false),
        (general, false),
    ] {
        let last = solved(&deck(&contact, rigid));
        assert!(last.given_up > 0, "{contact}");
        peaks.push(last.forces.iter().map(|force| force[0].abs()).fold(0.0, f64::max));
    }
    assert!(peaks.iter().all(|peak| *peak > 0.01), "{peaks:?}");
}
