//! Blocks in space whose surfaces are all of their faces: sides that went in with the face between them.
//!
//! ```text
//!         |  above  |        the lowest part of a side of the block above is below the face of the other one, by
//!     ----o---------o----    what rounding leaves or curved faces sag; seen along its normal the nearest face that
//!     |      below      |    looks at it is the far side of the block below, from within
//! ```
//!
//! docs/theory.md 5.11, an end that went in elsewhere.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use super::space_decks::{Block, Kind, size, solved};

/// A block pressed on a larger one by a hundredth of its height and drawn along; `all`: the surfaces are all faces.
fn deck(kinds: [Kind; 2], slave_above: bool, all: bool) -> String {
    let below = Block { name: "BELOW", base: 0, cells: [4, 4, 2], kind: kinds[0] };
    let above = Block { name: "ABOVE", base: 10_000, cells: [2, 2, 1], kind: kinds[1] };
    let mut text = String::new();
    below.write(&mut text, |[x, y, z]| [2.51 * (x - 0.5), 1.9 * (y - 0.5), 0.85 * (z - 1.0)]);
    above.write(&mut text, |[x, y, z]| [1.21 * x - 0.73, 0.71 * y - 0.4, 0.64 * z]);
    text += &below.set("FIX", |[_, _, z]| z == 0.0);
    text += &above.set("TOP", |[_, _, z]| z == 1.0);
    text += &match all {
        true => "*SURFACE, NAME=LOWER\nBELOW,\n*SURFACE, NAME=UPPER\nABOVE,\n".to_owned(),
        false => {
            below.surface("LOWER", |[_, _, z]| z == 1.0)
                + &above.surface("UPPER", |[_, _, z]| z == 0.0)
        }
    };
    for (name, modulus) in [("BELOW", 5000.0), ("ABOVE", 1000.0)] {
        text += &format!(
            "*MATERIAL, NAME={name}\n*ELASTIC\n{modulus:?}, 0.3\n*SOLID SECTION, ELSET={name}, MATERIAL={name}\n"
        );
    }
    let pair = if slave_above { "UPPER, LOWER" } else { "LOWER, UPPER" };
    text += &format!(
        "*SURFACE INTERACTION, NAME=I\n*FRICTION\n0.1\n*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\n{pair}\n"
    );
    text += "*BOUNDARY\nFIX, 1, 3\n";
    for (along, name) in [(0.0, "PRESSED"), (0.1, "DRAWN")] {
        text += &format!(
            "*STEP, NLGEOM\n{name}\n*STATIC\n0.25, 1.\n*BOUNDARY\nTOP, 1, 1, {along:?}\nTOP, 2, 2\nTOP, 3, 3, -0.0064\n*END STEP\n"
        );
    }
    text
}

/// Requirement: all faces of both blocks as surfaces find their end with no attempt given up, and the force of
/// those that hold the faces alone that look at each other, whose edges are not held by themselves, within 1 %.
#[test]
fn sides_do_not_meet_what_they_are_inside_of() {
    for kinds in [[Kind::C3d8, Kind::C3d10], [Kind::C3d8, Kind::C3d8], [Kind::C3d10, Kind::C3d20r]]
    {
        let [all, facing] = [true, false].map(|all| solved(&deck(kinds, true, all)));
        assert_eq!((all.given_up, facing.given_up), (0, 0), "{kinds:?}");
        assert!(all.worst < 1e-9, "{kinds:?} {}", all.worst);
        let [one, other] = [all.force(), facing.force()];
        let off = size(std::array::from_fn(|k| one[k] - other[k])) / size(other);
        assert!(off < 0.01, "{kinds:?} {one:?} {other:?}");
    }
}

/// An arched block pressed by a quarter of its height on a softer one of rubber, arched the other way, without friction.
fn arched(more: &str, law: &str) -> String {
    let below = Block { name: "BELOW", base: 0, cells: [4, 4, 2], kind: Kind::C3d8i };
    let above = Block { name: "ABOVE", base: 10_000, cells: [2, 2, 1], kind: Kind::C3d8i };
    let mut text = String::new();
    below.write(&mut text, |[x, y, z]| {
        let [x, y] = [2.64 * (x - 0.5), 1.6 * (y - 0.5)];
        [x, y, 0.63 * (z - 1.0) - z * 0.067 * y * y]
    });
    above.write(&mut text, |[x, y, z]| {
        let [x, y] = [0.86 * (x - 0.5), 1.11 * (y - 0.5)];
        [x - 0.15, y - 0.13, 0.01 + 0.52 * z + (1.0 - z) * 0.133 * x * x]
    });
    text += &below.set("FIX", |[_, _, z]| z == 0.0);
    text += &above.set("TOP", |[_, _, z]| z == 1.0);
    text += "*SURFACE, NAME=LOWER\nBELOW,\n*SURFACE, NAME=UPPER\nABOVE,\n";
    for (name, rubber) in [("BELOW", "33., 0.006"), ("ABOVE", "833., 0.00024")] {
        text += &format!(
            "*MATERIAL, NAME={name}\n*HYPERELASTIC, NEO HOOKE\n{rubber}\n*SOLID SECTION, ELSET={name}, MATERIAL={name}\n"
        );
    }
    text + &format!("*SURFACE INTERACTION, NAME=I\n{law}")
        + "*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nUPPER, LOWER\n*BOUNDARY\nFIX, 1, 3\n"
        + &format!(
            "*STEP, NLGEOM{more}\n*STATIC\n0.125, 1.\n*BOUNDARY\nTOP, 1, 2\nTOP, 3, 3, -0.15\n*END STEP\n"
        )
}

/// Requirement: contact over curved faces in space, whose forces are those of a potential but for the error of their
/// integrals, finds its end without friction too, with no attempt given up, and the same one where a symmetric tangent is
/// asked for.
#[test]
fn faces_that_are_no_parallelograms_press_without_friction() {
    let [own, symmetric] = ["", ", UNSYMM=NO"].map(|more| solved(&arched(more, "")));
    assert_eq!((own.given_up, symmetric.given_up), (0, 0));
    assert!(own.worst < 1e-9, "{}", own.worst);
    assert!(own.most() <= 6, "{:?}", own.iterations);
    let [one, other] = [own.force(), symmetric.force()];
    let off = size(std::array::from_fn(|k| one[k] - other[k])) / size(one);
    // residuals are let go at 1e-6
    assert!(off < 1e-5, "{one:?} {other:?}");
    let law = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n1e5\n";
    let soft = solved(&arched(", UNSYMM=NO", law));
    assert_eq!(soft.given_up, 0, "{:?}", soft.iterations);
}
