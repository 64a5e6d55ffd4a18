//! Cook's membrane: plane stress, and rubber next to incompressible at large strain.
//!
//! ```text
//!           ,-- tip (48, 60)
//!         ,-  ^
//!       ,-    ^ load, evenly over the end, keeps its direction
//!     |-    ,-
//!     |   ,-     held at x = 0, from y = 0 to 44
//!     | ,-
//! ```

use slideline_verification::{Claim, Group, Record, Solid, run};
use std::fmt::Write as _;

pub const GROUP: Group = Group {
    file: "solids_cook",
    claims: &[
        Claim {
            name: "cooks_membrane",
            requirement: "the middle of the tip of Cook's membrane rises to 23.96.",
            source: "R. D. Cook (1974); converged value, E = 1, nu = 1/3, plane stress, load 1.",
            tolerance: "1 % with 16 elements a side; 2 % with hourglass control, 4 % where full \
                        integration is known to be stiff.",
            measure: membrane,
        },
        Claim {
            name: "cooks_membrane_of_rubber",
            requirement: "the upper corner of the tip rises to 6.9083 at large strain, E = 240.565, \
                          nu = 0.4999, load 100; in plane strain, by elements of the plane and of \
                          space.",
            source: "T. Elguedj, Y. Bazilevs, V. M. Calo, T. J. R. Hughes, B-bar and F-bar projection \
                     methods for nearly incompressible linear and non-linear elasticity, CMAME 197 \
                     (2008), quadratic splines on 128 x 128; the problem is that of Simo and Armero \
                     (1992). Its energy of the volume is another one: here K (J - 1)^2/2, with J off \
                     1 by less than 1e-3.",
            tolerance: "2 % with 16 elements a side, 1 % with 32. Fully integrated triangles lock and \
                        are told.",
            measure: rubber,
        },
        Claim {
            name: "cooks_membrane_of_incompressible_rubber",
            requirement: "the upper corner rises to 4.7011 with G = 1 and a load of 0.8 (0.05 for \
                          each area), incompressible.",
            source: "B. Mueller, Mixed least squares finite element methods based on inverse \
                     stress-strain relations in hyperelasticity, thesis, Duisburg-Essen (2015), as \
                     Elmer's tests have it.",
            tolerance: "2 % with 16 elements a side, 1 % with 32, K = 10^4 G.",
            measure: incompressible,
        },
    ],
};

/// What is pulled, by which load, in which kind of step.
struct Load<'a> {
    material: &'a str,
    total: f64,
    step: &'a str,
}

/// Shares of an evenly loaded edge of `cells` elements at the places y of its nodes: trapezoids of
/// linear types, Simpson's of quadratic ones.
fn share(y: f64, cells: usize, quadratic: bool) -> f64 {
    let n = cells as f64;
    let end = y == 0.0 || y == 1.0;
    let middle = quadratic && (2.0 * n * y).round() as usize % 2 == 1;
    let share = match (quadratic, middle, end) {
        (false, _, true) => 0.5,
        (false, _, false) => 1.0,
        (true, true, _) => 2.0 / 3.0,
        (true, false, true) => 1.0 / 6.0,
        (true, false, false) => 1.0 / 3.0,
    };
    share / n
}

/// Rise of the end at the height y of the unit square.
fn rise(element: &str, cells: usize, load: &Load<'_>, y: f64) -> f64 {
    let solid = Solid {
        element,
        cells: [cells, cells, 1],
        map: |[x, y, z]| [48.0 * x, 44.0 * x + y * (44.0 - 28.0 * x), z],
        material: load.material,
    };
    let mesh = solid.mesh();
    let mut deck = format!("*HEADING\nmembrane\n{}*STEP{}\n*BOUNDARY\n", mesh.text, load.step);
    (1..=2).for_each(|axis| deck.push_str(&mesh.hold(|at| at[0] == 0.0, axis, 0.0)));
    if solid.is_spatial() {
        deck.push_str(&mesh.hold(|_| true, 3, 0.0));
    }
    deck.push_str("*CLOAD\n");
    let quadratic = !solid.is_spatial() && element.contains(['6', '8']);
    // in space of linear types only: two layers of nodes
    let layers = if solid.is_spatial() { 2.0 } else { 1.0 };
    for (label, at, _) in mesh.nodes.iter().filter(|(_, at, _)| at[0] == 1.0) {
        let share = load.total * share(at[1], cells, quadratic) / layers;
        let _ = writeln!(deck, "{label}, 2, {share:?}");
    }
    deck.push_str("*END STEP\n");
    let Ok(curve) = run(&deck) else { return f64::NAN };
    curve.displacement(mesh.nearest([1.0, y, 0.0]), 2).last().copied().unwrap_or(f64::NAN)
}

fn membrane(record: &mut Record) {
    let load = Load {
        material: "*ELASTIC\n1.0, 0.333333333333\n",
        total: 1.0,
        step: "\n*STATIC\n1.0, 1.0",
    };
    let cook = |element| rise(element, 16, &load, 0.5);
    for (element, tolerance) in [
        ("CPS4I", 0.01),
        ("CPS4R", 0.02),
        ("CPS6", 0.01),
        ("CPS8", 0.01),
        ("CPS8R", 0.01),
        ("CPS4", 0.04),
    ] {
        let low = 23.96 * (1.0 - tolerance);
        record.within(format!("{element}, 16 a side"), cook(element), [low, 23.96 * 1.01]);
    }
    record.tell("CPS3, 16 a side", cook("CPS3"));
}

const FAR: &str = ", NLGEOM\n*STATIC\n0.25, 1.0";

/// Types of one pressure an element, of incompatible modes, and of fewer points.
const SOFT: [(&str, usize, f64); 5] = [
    ("CPE4", 16, 0.02),
    ("CPE4", 32, 0.01),
    ("CPE4I", 16, 0.02),
    ("CPE8R", 16, 0.02),
    ("C3D8", 16, 0.02),
];

fn judge(record: &mut Record, load: &Load<'_>, exact: f64) {
    for (element, cells, tolerance) in SOFT {
        let off = (rise(element, cells, load, 1.0) / exact - 1.0).abs();
        record.at_most(format!("{element}, {cells} a side, off the reference"), off, tolerance);
    }
    for element in ["CPE3", "CPE6"] {
        let off = (rise(element, 16, load, 1.0) / exact - 1.0).abs();
        record.tell(format!("{element}, 16 a side, off the reference"), off);
    }
}

fn rubber(record: &mut Record) {
    let shear: f64 = 240.565 / (2.0 * 1.4999);
    let bulk = 240.565 / (3.0 * (1.0 - 2.0 * 0.4999));
    let material = format!("*HYPERELASTIC, NEO HOOKE\n{:?}, {:?}\n", 0.5 * shear, 2.0 / bulk);
    judge(record, &Load { material: &material, total: 100.0, step: FAR }, 6.9083);
}

fn incompressible(record: &mut Record) {
    let material = "*HYPERELASTIC, NEO HOOKE\n0.5, 2.0E-4\n";
    judge(record, &Load { material, total: 0.8, step: FAR }, 4.7011);
}
