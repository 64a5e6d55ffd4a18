//! Ridges, valleys and chamfers of meshes are met as they are drawn, however few faces draw them.
//!
//! ```text
//!        | block |                | block |
//!        |___.___|                |___.___|
//!        .-'   '-.                .-'   '-.          one face a side, or four: the same roof
//!     o-'         '-o          o-o-o     o-o-o
//! ```
//!
//! docs/theory.md section 5.9

#![allow(clippy::unwrap_used)] // a test may fail where it stands

use crate::space_decks::{Block, Kind, solved};
use std::fmt::Write as _;

/// Where a profile turns, from left to right, and by what each of its sides falls behind the last.
type Profile<'a> = &'a [[f64; 2]];

const ROOF: Profile<'_> = &[[-1.6, -0.3], [0.05, 0.0], [1.6, -0.25]];
const VALLEY: Profile<'_> = &[[-1.6, 0.2], [0.05, -0.07], [1.6, 0.2]];
const CHAMFER: Profile<'_> = &[[-1.6, -0.5], [-0.28, 0.0], [0.21, 0.0], [1.6, -0.7]];

/// The places of a profile with `faces` faces a side.
fn divided(profile: Profile<'_>, faces: usize) -> Vec<[f64; 2]> {
    let parts = profile.windows(2).flat_map(|ends| {
        (0..faces).map(move |k| {
            let s = k as f64 / faces as f64;
            [0, 1].map(|axis| (1.0 - s) * ends[0][axis] + s * ends[1][axis])
        })
    });
    parts.chain(profile.last().copied()).collect()
}

/// A rigid mesh over a profile, of quadrilaterals or of triangles.
fn mesh(profile: Profile<'_>, faces: usize, element: &str) -> String {
    let mut text = "*NODE\n300, 0., 0., -1.\n".to_owned();
    let places = divided(profile, faces);
    for (k, [x, z]) in places.iter().enumerate() {
        let _ = writeln!(text, "{}, {x:?}, -1., {z:?}\n{}, {x:?}, 1., {z:?}", 301 + k, 401 + k);
    }
    let _ = writeln!(text, "*ELEMENT, TYPE={element}, ELSET=ROOF");
    for k in 0..places.len() - 1 {
        let [a, b, c, d] = [301 + k, 302 + k, 402 + k, 401 + k];
        let _ = match element {
            "R3D4" => writeln!(text, "{}, {a}, {b}, {c}, {d}", 901 + k),
            _ => writeln!(text, "{}, {a}, {b}, {c}\n{}, {a}, {c}, {d}", 901 + k, 951 + k),
        };
    }
    text + "*SURFACE, NAME=LOWER\nROOF, SPOS\n*RIGID BODY, ELSET=ROOF, REF NODE=300\n"
}

/// A block pressed on a lower body by `depth` from a `height`, and slid a little.
fn deck(lower: &str, [height, depth]: [f64; 2], kind: &str) -> String {
    let block = Block { name: "UPPER", base: 1000, cells: [12, 2, 3], kind: Kind::C3d8 };
    let mut text = "*HEADING\nridge\n".to_owned();
    block.write(&mut text, |[x, y, z]| [x - 0.5, 0.3 * y - 0.15, 0.5 * z + height]);
    let (foot, head) =
        (block.surface("FOOT", |at| at[2] == 0.0), block.set("HEAD", |at| at[2] == 1.0));
    let _ = write!(
        text,
        "*SOLID SECTION, ELSET=UPPER, MATERIAL=M\n*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n{lower}\
         {foot}{head}*SURFACE INTERACTION, NAME=I\n*FRICTION\n.2\n*CONTACT PAIR, INTERACTION=I, \
         TYPE={kind}\nFOOT, LOWER\n*BOUNDARY\n300, 1, 6\n*STEP, NLGEOM, INC=400\n*STATIC\n.2, 1.\n\
         *BOUNDARY\nHEAD, 1, 2\nHEAD, 3, 3, -{depth:?}\n*END STEP\n*STEP, NLGEOM, INC=400\n\
         *STATIC\n.2, 1.\n*BOUNDARY\nHEAD, 1, 1, .01\n*END STEP\n"
    );
    text
}

fn force(lower: &str, from: [f64; 2], kind: &str) -> [f64; 3] {
    solved(&deck(lower, from, kind)).force()
}

/// Requirement: the force on a block that is pressed on a ridge, into a valley or on a chamfer does not depend on how many
/// faces draw each of its sides, nor on whether they have three or four corners: 1e-5; and it is that of contact over
/// faces, which smooths nothing, but for what both make of a mesh of twelve elements: 8 %. Smoothed by normals at
/// the ridge, a roof of two faces pressed twice as hard.
#[test]
fn few_faces_draw_the_same_roof() {
    for (what, profile, from) in [
        ("roof", ROOF, [0.0, 0.04]),
        ("valley", VALLEY, [0.03, 0.1]),
        ("chamfer", CHAMFER, [0.0, 0.03]),
    ] {
        let expected = force(&mesh(profile, 4, "R3D4"), from, "NODE TO SURFACE");
        for (faces, element) in [(1, "R3D4"), (1, "R3D3"), (2, "R3D4"), (3, "R3D3")] {
            let found = force(&mesh(profile, faces, element), from, "NODE TO SURFACE");
            for (a, b) in found.iter().zip(expected) {
                assert!(
                    (a - b).abs() < 1e-5 * expected[2],
                    "{what} {faces} {element} {found:?} {expected:?}"
                );
            }
        }
        let spread = force(&mesh(profile, 1, "R3D4"), from, "SURFACE TO SURFACE");
        assert!((spread[2] / expected[2] - 1.0).abs() < 0.08, "{what} {spread:?} {expected:?}");
    }
}

/// A rigid pyramid of four triangles under the block, or a pad with a chamfer around, turned about its axis.
fn solid(is_pad: bool, turned: f64) -> String {
    let (s, c) = f64::sin_cos(turned);
    let ring = |first: usize, half: f64, z: f64| -> String {
        let corners = [[-half, -half], [half, -half], [half, half], [-half, half]];
        let line = |(k, [x, y]): (usize, [f64; 2])| {
            format!("{}, {:?}, {:?}, {z:?}\n", first + k, c * x - s * y + 0.02, s * x + c * y)
        };
        corners.into_iter().enumerate().map(line).collect()
    };
    let faces = if is_pad {
        "*ELEMENT, TYPE=R3D4, ELSET=ROOF\n901, 401, 402, 403, 404\n902, 301, 302, 402, 401\n\
         903, 302, 303, 403, 402\n904, 303, 304, 404, 403\n905, 304, 301, 401, 404\n"
    } else {
        "*ELEMENT, TYPE=R3D3, ELSET=ROOF\n901, 301, 302, 310\n902, 302, 303, 310\n\
         903, 303, 304, 310\n904, 304, 301, 310\n"
    };
    let inner = if is_pad { ring(401, 0.13, 0.0) } else { "310, 0.02, 0., 0.\n".to_owned() };
    format!(
        "*NODE\n300, 0., 0., -1.\n{}{inner}{faces}*SURFACE, NAME=LOWER\nROOF, SPOS\n*RIGID BODY, \
         ELSET=ROOF, REF NODE=300\n",
        ring(301, 1.2, -0.4)
    )
}

/// Requirement: nothing of a pyramid and of a pad with a chamfer is smoothed, however they are turned: the force is that
/// without smoothing. 1e-9 of it.
#[test]
fn pyramids_and_pads_are_met_as_they_are_drawn() {
    for (is_pad, turned) in [(false, 0.0), (false, 0.1), (false, 0.3), (true, 0.0), (true, 0.3)] {
        let forces = ["NODE TO SURFACE", "NODE TO SURFACE, SMOOTH=0."]
            .map(|kind| force(&solid(is_pad, turned), [0.0, 0.03], kind));
        for (a, b) in forces[0].iter().zip(forces[1]) {
            assert!((a - b).abs() < 1e-9 * forces[1][2], "{is_pad} {turned} {forces:?}");
        }
    }
}
