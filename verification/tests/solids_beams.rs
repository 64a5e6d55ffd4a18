//! Cantilevers of solids against Timoshenko's beam, and Cook's membrane.

use slideline_theory::closed::timoshenko::ShearBeam;
use slideline_verification::{Claim, Group, Record, Solid, run};
use std::fmt::Write as _;

pub const GROUP: Group = Group {
    file: "solids_beams",
    claims: &[
        Claim {
            name: "cantilevers_bend_as_timoshenko_says",
            requirement: "twenty elements along and two over the height bend as a shear-flexible \
                          beam, where the type is made for bending.",
            source: "Timoshenko; shear stiffness 5/6 G A.",
            tolerance: "3 %, coarse meshes; types that lock are told, not judged.",
            measure: cantilevers,
        },
        Claim {
            name: "cooks_membrane",
            requirement: "the middle of the tip of Cook's membrane rises to 23.96.",
            source: "R. D. Cook (1974); converged value, E = 1, nu = 1/3, plane stress, load 1.",
            tolerance: "1 % with 16 elements a side; 2 % with hourglass control, 4 % where full \
                        integration is known to be stiff.",
            measure: membrane,
        },
    ],
};

const LENGTH: f64 = 10.0;

fn cantilever(element: &str) -> f64 {
    let solid = Solid {
        element,
        cells: [20, 2, 1],
        map: |[x, y, z]| [LENGTH * x, y, z],
        material: "*ELASTIC\n1000.0, 0.0\n",
    };
    let mesh = solid.mesh();
    let mut deck =
        format!("*HEADING\ncantilever\n{}*STEP\n*STATIC\n1.0, 1.0\n*BOUNDARY\n", mesh.text);
    let axes = if solid.is_spatial() { 3 } else { 2 };
    let root = |at: [f64; 3]| at[0] == 0.0;
    (1..=axes).for_each(|axis| deck.push_str(&mesh.hold(root, axis, 0.0)));
    let tip = mesh.labels(|at| at[0] == 1.0);
    deck.push_str("*CLOAD\n");
    for label in &tip {
        let _ = writeln!(deck, "{label}, 2, {:?}", 0.01 / tip.len() as f64);
    }
    deck.push_str("*END STEP\n");
    let curve = match run(&deck) {
        Ok(curve) => curve,
        Err(_) => return f64::NAN,
    };
    curve.displacement(mesh.nearest([1.0, 0.5, 0.5]), 2).last().copied().unwrap_or(f64::NAN)
}

fn cantilevers(record: &mut Record) {
    let beam = ShearBeam {
        length: LENGTH,
        bending_stiffness: 1000.0 / 12.0,
        shear_stiffness: 5.0 / 6.0 * 500.0,
    };
    let exact = beam.deflection(0.01);
    for element in [
        "CPS4I", "CPS4R", "CPS6", "CPS8", "CPS8R", "CPE4I", "CPE6", "CPE8", "CPE8R", "C3D8I",
        "C3D10", "C3D10M", "C3D15", "C3D20", "C3D20R",
    ] {
        let ratio = cantilever(element) / exact;
        record.within(format!("{element}, deflection over Timoshenko's"), ratio, [0.97, 1.03]);
    }
    for element in ["CPS3", "CPS4", "CPE3", "CPE4", "C3D4", "C3D6", "C3D8", "C3D8R", "C3D10H"] {
        record
            .tell(format!("{element}, deflection over Timoshenko's"), cantilever(element) / exact);
    }
}

fn cook(element: &str, cells: usize) -> f64 {
    let solid = Solid {
        element,
        cells: [cells, cells, 1],
        map: |[x, y, _]| [48.0 * x, 44.0 * x + y * (44.0 - 28.0 * x), 0.0],
        material: "*ELASTIC\n1.0, 0.333333333333\n",
    };
    let mesh = solid.mesh();
    let mut deck =
        format!("*HEADING\nmembrane\n{}*STEP\n*STATIC\n1.0, 1.0\n*BOUNDARY\n", mesh.text);
    (1..=2).for_each(|axis| deck.push_str(&mesh.hold(|at| at[0] == 0.0, axis, 0.0)));
    deck.push_str("*CLOAD\n");
    let edge: Vec<(u64, f64)> =
        mesh.nodes.iter().filter(|node| node.1[0] == 1.0).map(|node| (node.0, node.1[1])).collect();
    let quadratic = element.contains(['6', '8']);
    let n = cells as f64;
    for (label, y) in edge {
        let end = y == 0.0 || y == 1.0;
        let middle = quadratic && (2.0 * n * y).round() as usize % 2 == 1;
        let share = match (quadratic, middle, end) {
            (false, _, true) => 0.5,
            (false, _, false) => 1.0,
            (true, true, _) => 2.0 / 3.0,
            (true, false, true) => 1.0 / 6.0,
            (true, false, false) => 1.0 / 3.0,
        };
        let _ = writeln!(deck, "{label}, 2, {:?}", share / n);
    }
    deck.push_str("*END STEP\n");
    let Ok(curve) = run(&deck) else { return f64::NAN };
    curve.displacement(mesh.nearest([1.0, 0.5, 0.0]), 2).last().copied().unwrap_or(f64::NAN)
}

fn membrane(record: &mut Record) {
    for (element, tolerance) in [
        ("CPS4I", 0.01),
        ("CPS4R", 0.02),
        ("CPS6", 0.01),
        ("CPS8", 0.01),
        ("CPS8R", 0.01),
        ("CPS4", 0.04),
    ] {
        let low = 23.96 * (1.0 - tolerance);
        record.within(format!("{element}, 16 a side"), cook(element, 16), [low, 23.96 * 1.01]);
    }
    record.tell("CPS3, 16 a side", cook("CPS3", 16));
}
