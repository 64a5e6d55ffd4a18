//! Cantilevers of solids against Timoshenko's beam.

use slideline_theory::closed::timoshenko::ShearBeam;
use slideline_verification::{Claim, Group, Record, Solid, run};
use std::fmt::Write as _;

pub const GROUP: Group = Group {
    file: "solids_beams",
    claims: &[Claim {
        name: "cantilevers_bend_as_timoshenko_says",
        requirement: "twenty elements along and two over the height bend as a shear-flexible \
                          beam, where the type is made for bending.",
        source: "Timoshenko; shear stiffness 5/6 G A.",
        tolerance: "3 %, coarse meshes; types that lock are told, not judged.",
        measure: cantilevers,
    }],
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
        "C3D10", "C3D15", "C3D20", "C3D20R",
    ] {
        let ratio = cantilever(element) / exact;
        record.within(format!("{element}, deflection over Timoshenko's"), ratio, [0.97, 1.03]);
    }
    for element in ["CPS3", "CPS4", "CPE3", "CPE4", "C3D4", "C3D6", "C3D8", "C3D8R", "C3D10H"] {
        record
            .tell(format!("{element}, deflection over Timoshenko's"), cantilever(element) / exact);
    }
}
