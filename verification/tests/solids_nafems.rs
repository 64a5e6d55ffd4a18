//! NAFEMS' linear elastic benchmarks LE1, LE6 and LE10.
//!
//! ```text
//!   B ___
//!   |    ``--._        quarter between two ellipses
//!   A_         \       A (0, 1), B (0, 2.75), C (3.25, 0), D (2, 0)
//!     `\        |      LE1: plane stress, pulled outwards on BC
//!       D-------C      LE10: plate 0.6 thick, pressed from above
//! ```

use slideline_verification::{Claim, Group, Meshed, Record, Solid, nodal_stress};
use std::path::Path;

pub const GROUP: Group = Group {
    file: "solids_nafems",
    claims: &[
        Claim {
            name: "nafems_le1",
            requirement: "sigma_yy at D of the elliptic membrane is 92.7 MPa.",
            source: "The Standard NAFEMS Benchmarks (1990), test LE1; stress at the node as JOB.frd \
                     has it, from the points of its element.",
            tolerance: "1 % where it is reached with 8 by 12 quadratic, 16 by 24 linear elements; \
                        fewer points stand farther from D: 2.5 % and 5 %, less than half with half \
                        the size. Constant strain and full integration are told.",
            measure: membrane,
        },
        Claim {
            name: "nafems_le6",
            requirement: "the largest principal stress below the middle of the skew plate is 0.802 \
                          MPa.",
            source: "The Standard NAFEMS Benchmarks (1990), test LE6, a thin plate; here one layer of \
                     solids, held along the middle of its sides.",
            tolerance: "3 %: 16 by 16 elements of fewer points; the obtuse corners are singular. Fully \
                        integrated ones, six times as wide as thick, are stiffer and told.",
            measure: skew_plate,
        },
        Claim {
            name: "nafems_le10",
            requirement: "sigma_yy at D of the thick plate is -5.38 MPa.",
            source: "The Standard NAFEMS Benchmarks (1990), test LE10; stress at the node as JOB.frd \
                     has it, from the points of its element.",
            tolerance: "2.5 % quadratic types, 9 by 12 by 4 hexahedra, 6 by 8 by 2 cells of wedges \
                        and of tetrahedra; 5 % with incompatible modes, 12 by 16 by 4: straight \
                        through points at a corner where the stress is steep.",
            measure: plate,
        },
    ],
};

/// From inside to outside, and around from the x axis.
fn ellipses([x, y, z]: [f64; 3]) -> [f64; 3] {
    let (sine, cosine) = (std::f64::consts::FRAC_PI_2 * y).sin_cos();
    let between = |inner: f64, outer: f64| inner + x * (outer - inner);
    [between(2.0, 3.25) * cosine, between(1.0, 2.75) * sine, 0.6 * z]
}

/// MPa and metres.
const STEEL: &str = "*ELASTIC\n210.0E3, 0.3\n";

/// Stress at a place of the unit cube, run in a folder of its own.
fn stress(
    solid: &Solid<'_>,
    of: impl Fn(&Meshed) -> (String, String),
    at: [f64; 3],
) -> Result<[f64; 6], String> {
    let mesh = solid.curved();
    let text = mesh.text.replace("MATERIAL=M\n1.0\n", "MATERIAL=M\n0.1\n");
    let (held, pressed) = of(&mesh);
    let deck = format!(
        "*HEADING\nNAFEMS\n{text}*STEP\n*STATIC\n1.0, 1.0\n*BOUNDARY\n{held}*DLOAD\n{pressed}*EL \
         FILE\nS\n*END STEP\n"
    );
    let name = format!("{}-{}", solid.element, solid.cells[1]);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("solids_nafems").join(name);
    nodal_stress(&folder, &deck, mesh.nearest(at))
}

/// sigma_yy at D.
fn stress_at_d(element: &str, cells: [usize; 3]) -> Result<f64, String> {
    let solid = Solid { element, cells, map: ellipses, material: STEEL };
    let symmetric = |mesh: &Meshed| {
        mesh.hold(|at| at[1] == 0.0, 2, 0.0) + &mesh.hold(|at| at[1] == 1.0, 1, 0.0)
    };
    let membrane = |mesh: &Meshed| (symmetric(mesh), mesh.press(|at| at[0] == 1.0, -10.0));
    let plate = |mesh: &Meshed| {
        let outside = |at: [f64; 3]| at[0] == 1.0;
        let across = mesh.hold(outside, 1, 0.0) + &mesh.hold(outside, 2, 0.0);
        let held = symmetric(mesh) + &across + &mesh.hold(|at| outside(at) && at[2] == 0.5, 3, 0.0);
        (held, mesh.press(|at| at[2] == 1.0, 1.0))
    };
    let found = if solid.is_spatial() {
        stress(&solid, plate, [0.0, 0.0, 1.0])
    } else {
        stress(&solid, membrane, [0.0; 3])
    };
    found.map(|stress| stress[1])
}

fn judge(
    record: &mut Record,
    element: &str,
    cells: [usize; 3],
    exact: f64,
    tolerance: Option<f64>,
) {
    let [x, y, z] = cells;
    let what = format!("{element}, {x} by {y} by {z}, stress at D over NAFEMS'");
    match (stress_at_d(element, cells), tolerance) {
        (Ok(stress), Some(tolerance)) => {
            record.within(what, stress / exact, [1.0 - tolerance, 1.0 + tolerance]);
        }
        (Ok(stress), None) => record.tell(what, stress / exact),
        (Err(why), _) => record.holds(format!("{what}: {why}"), false),
    }
}

fn membrane(record: &mut Record) {
    for (element, cells, tolerance) in [
        ("CPS8", [8, 12, 1], 0.01),
        ("CPS8R", [8, 12, 1], 0.025),
        ("CPS8R", [16, 24, 1], 0.01),
        ("CPS6", [8, 12, 1], 0.05),
        ("CPS6", [16, 24, 1], 0.02),
        ("CPS4I", [16, 24, 1], 0.01),
    ] {
        judge(record, element, cells, 92.7, Some(tolerance));
    }
    for element in ["CPS3", "CPS4", "CPS4R"] {
        judge(record, element, [16, 24, 1], 92.7, None);
    }
}

fn plate(record: &mut Record) {
    for (element, cells, tolerance) in [
        ("C3D20", [9, 12, 4], 0.025),
        ("C3D20R", [9, 12, 4], 0.025),
        ("C3D10", [6, 8, 2], 0.025),
        ("C3D15", [6, 8, 2], 0.025),
        ("C3D8I", [12, 16, 4], 0.05),
    ] {
        judge(record, element, cells, -5.38, Some(tolerance));
    }
    judge(record, "C3D8", [12, 16, 4], -5.38, None);
}

/// Sides of 1 m, an angle of 30 degrees, 1 cm thick.
fn skew([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x + 0.75f64.sqrt() * y, 0.5 * y, 0.01 * z]
}

fn skew_plate(record: &mut Record) {
    for element in ["C3D20R", "C3D20"] {
        let solid = Solid { element, cells: [16, 16, 1], map: skew, material: STEEL };
        let held = |mesh: &Meshed| {
            let side = |at: [f64; 3]| [at[0], at[1]].iter().any(|x| *x == 0.0 || *x == 1.0);
            let corner = |at: [f64; 3]| at == [0.0, 0.0, 0.5];
            let held = mesh.hold(|at| side(at) && at[2] == 0.5, 3, 0.0)
                + &mesh.hold(corner, 1, 0.0)
                + &mesh.hold(|at| corner(at) || at == [1.0, 0.0, 0.5], 2, 0.0);
            (held, mesh.press(|at| at[2] == 1.0, 0.7e-3))
        };
        match stress(&solid, held, [0.5, 0.5, 0.0]) {
            Ok([xx, yy, _, xy, ..]) => {
                let largest = 0.5 * (xx + yy) + (0.5 * (xx - yy)).hypot(xy);
                let what = format!("{element}, principal stress over NAFEMS'");
                if element == "C3D20R" {
                    record.within(what, largest / 0.802, [0.97, 1.03]);
                } else {
                    record.tell(what, largest / 0.802);
                }
            }
            Err(why) => record.holds(format!("{element}: {why}"), false),
        }
    }
}
