//! The patch test of every solid, in meshes out of shape.

use slideline_verification::{Claim, Group, Record, Solid, run, worst};
use std::fmt::Write as _;

pub const GROUP: Group = Group {
    file: "solids_patch",
    claims: &[
        Claim {
            name: "patch_test_at_small_displacement",
            requirement: "a mesh out of shape whose border moves linearly moves linearly inside, \
                          every element type of the plane and of space.",
            source: "Irons; meshes with moved inner corners.",
            tolerance: "1e-9 of the displacements: rounding of the solution.",
            measure: |record| patch(record, "", 1e-3),
        },
        Claim {
            name: "patch_test_at_large_displacement",
            requirement: "the same with NLGEOM and displacement gradients up to 0.14.",
            source: "A homogeneous deformation is in balance in any homogeneous material.",
            tolerance: "1e-8 of the displacements: convergence of the iteration.",
            measure: |record| patch(record, ", NLGEOM", 0.2),
        },
        Claim {
            name: "patch_test_of_rings",
            requirement: "rings out of shape whose border grows as r and z grow so inside, at small \
                          and at large displacement.",
            source: "u = a r, w = b z is a homogeneous deformation of a ring.",
            tolerance: "1e-9 and 1e-8 of the displacements, as above.",
            measure: |record| {
                rings(record, "", 1e-3);
                rings(record, ", NLGEOM", 0.2);
            },
        },
    ],
};

const TYPES: [&str; 27] = [
    "CPS3", "CPS4", "CPS4I", "CPS4R", "CPS6", "CPS8", "CPS8R", "CPE3", "CPE4", "CPE4I", "CPE4R",
    "CPE4H", "CPE6", "CPE8", "CPE8R", "C3D4", "C3D4H", "C3D6", "C3D8", "C3D8I", "C3D8R", "C3D8H",
    "C3D10", "C3D10H", "C3D15", "C3D20", "C3D20R",
];

/// The unit cube with corners inside moved out of their places.
fn skewed([x, y, z]: [f64; 3]) -> [f64; 3] {
    let inside = 16.0 * x * (1.0 - x) * y * (1.0 - y);
    let [a, b, c] = [0.06 * inside, -0.05 * inside, 0.05 * inside * 4.0 * z * (1.0 - z)];
    [x + a * (1.0 - 0.4 * y), y + b * (1.0 + 0.3 * x), z + c]
}

const RINGS: [&str; 8] = ["CAX3", "CAX4", "CAX4I", "CAX4R", "CAX4H", "CAX6", "CAX8", "CAX8R"];

fn patch(record: &mut Record, nlgeom: &str, size: f64) {
    let field = |[x, y, z]: [f64; 3]| {
        [0.7 * x + 0.5 * y - 0.2 * z, -0.3 * x - 0.6 * y + 0.3 * z, 0.1 * x + 0.4 * y + 0.5 * z]
            .map(|u| size * u)
    };
    judge(record, &TYPES, (nlgeom, size), field);
}

fn rings(record: &mut Record, nlgeom: &str, size: f64) {
    let field = |[r, z, _]: [f64; 3]| [0.7 * size * r, -0.6 * size * z, 0.0];
    judge(record, &RINGS, (nlgeom, size), field);
}

fn judge(
    record: &mut Record,
    types: &[&str],
    (nlgeom, size): (&str, f64),
    field: impl Fn([f64; 3]) -> [f64; 3],
) {
    for &element in types {
        let solid =
            Solid { element, cells: [3, 3, 3], map: skewed, material: "*ELASTIC\n7.0, 0.3\n" };
        let mesh = solid.mesh();
        let axes = if solid.is_spatial() { 3 } else { 2 };
        let field = &field;
        let border = |at: [f64; 3]| (0..axes).any(|k| at[k] == 0.0 || at[k] == 1.0);
        let mut deck =
            format!("*HEADING\npatch\n{}*STEP{nlgeom}\n*STATIC\n1.0, 1.0\n*BOUNDARY\n", mesh.text);
        for (label, _, place) in mesh.nodes.iter().filter(|(_, at, _)| border(*at)) {
            for (axis, value) in field(*place).iter().take(axes).enumerate() {
                let _ = writeln!(deck, "{label}, {0}, {0}, {value:?}", axis + 1);
            }
        }
        deck.push_str("*CONTROLS, PARAMETERS=FIELD\n1.0E-11\n*END STEP\n");
        let curve = match run(&deck) {
            Ok(curve) => curve,
            Err(why) => {
                record.holds(format!("{element}: {why}"), false);
                continue;
            }
        };
        let inside = mesh.nodes.iter().filter(|(_, at, _)| !border(*at));
        let off = inside.flat_map(|(label, _, place)| {
            let (curve, exact) = (&curve, field(*place));
            (0..axes).map(move |axis| {
                let found =
                    curve.displacement(*label, axis + 1).last().copied().unwrap_or(f64::NAN);
                (found - exact[axis]).abs()
            })
        });
        let limit = if nlgeom.is_empty() { 1e-9 } else { 1e-8 };
        record.at_most(
            format!("{element}{nlgeom}, largest error"),
            worst(off.collect::<Vec<_>>()) / size,
            limit,
        );
    }
}
