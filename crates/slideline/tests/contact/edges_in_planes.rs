//! Sharp edges that end in a plane of symmetry: half of a model has half of its force.
//!
//! ```text
//!         \   |   /         a ridge that is lowest in the plane is pressed into a block; its node in the plane
//!          \  |  /          meets the face below it and the image of that face, so that it is pushed along the plane
//!     ______\_|_/______
//! ```
//!
//! Source: docs/theory.md sections 5.9 and 5.17.

use crate::space_decks::{Block, Kind, solved};

/// A roof upside down on a block, whole or the half beyond y = 0.
fn deck(is_half: bool, kind: Kind, formulation: &str, pair: &str) -> String {
    let along = |half: usize| if is_half { half } else { 2 * half };
    let lower = Block { name: "BLOCK", base: 0, cells: [5, along(3), 3], kind };
    let upper = Block { name: "ROOF", base: 10_000, cells: [4, along(3), 2], kind };
    let from = if is_half { 0.0 } else { -1.0 };
    let length = |v: f64, reach: f64| reach * (from + (1.0 - from) * v);
    let mut text = String::new();
    lower.write(&mut text, |[u, v, w]| [3.0 * u - 1.5, length(v, 2.0), w - 1.0]);
    upper.write(&mut text, |[u, v, w]| {
        let (x, y) = (1.6 * u - 0.8, length(v, 1.5));
        [x, y, (1.0 - w) * (0.9 * x.abs() + 0.12 * y * y) + 1.2 * w]
    });
    let sets = [
        lower.surface("GROUND", |[_, _, w]| w == 1.0),
        upper.surface("RIDGE", |[_, _, w]| w == 0.0),
        lower.set("FOOT", |[_, _, w]| w == 0.0),
        upper.set("TOP", |[_, _, w]| w == 1.0),
        lower.set("CUT1", |[_, v, w]| v == 0.0 && w > 0.0),
        upper.set("CUT2", |[_, v, w]| v == 0.0 && w < 1.0),
    ];
    let cut = if is_half { "CUT1, 2, 2\nCUT2, 2, 2\n" } else { "" };
    format!(
        "{text}{}*SOLID SECTION, ELSET=BLOCK, MATERIAL=SOFT\n*SOLID SECTION, ELSET=ROOF, MATERIAL=STIFF\n\
         *MATERIAL, NAME=SOFT\n*ELASTIC\n100., 0.3\n*MATERIAL, NAME=STIFF\n*ELASTIC\n1e4, 0.3\n\
         *SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I, TYPE={formulation}\n{pair}\n*BOUNDARY\nFOOT, 1, 3\n\
         TOP, 1, 2\n{cut}*STEP, NLGEOM\n*STATIC\n0.25, 1., 1e-6, 0.25\n*BOUNDARY\nTOP, 3, 3, -0.08\n*END STEP\n",
        sets.concat()
    )
}

/// Requirement: half of a ridge has half of the force of the whole, whichever side is named first, with contact at nodes
/// and over faces, in as few iterations; to what the tolerance of equilibrium leaves of either.
#[test]
fn half_of_a_ridge_has_half_of_its_force() {
    for formulation in ["SURFACE TO SURFACE", "NODE TO SURFACE"] {
        for pair in ["RIDGE, GROUND", "GROUND, RIDGE"] {
            let of = |is_half| solved(&deck(is_half, Kind::C3d8, formulation, pair));
            let (whole, half) = (of(false), of(true));
            let [whole_force, half_force] = [&whole, &half].map(|own| own.force()[2].abs());
            let off = (2.0 * half_force / whole_force - 1.0).abs();
            assert!(whole_force > 1.0 && off < 1e-4, "{formulation} {pair}: {whole_force} {off}");
            let (most, usual) = (half.most(), whole.most());
            assert!(
                most <= usual + 1 && half.given_up == 0,
                "{formulation} {pair}: {most} {usual}"
            );
        }
    }
}
