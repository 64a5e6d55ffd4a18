//! Thick tubes under pressure: elastic, plastic and of rubber.

use slideline_theory::closed::tube::Tube;
use slideline_verification::{Claim, Group, Meshed, Record, Solid, run};

pub const GROUP: Group = Group {
    file: "solids_tubes",
    claims: &[
        Claim {
            name: "elastic_tube",
            requirement: "rings and solids held at their ends follow Lame.",
            source: "Lame; plane strain.",
            tolerance: "1 % linear, 0.05 % quadratic types with 8 elements over the wall.",
            measure: elastic,
        },
        Claim {
            name: "elastic_tube_converges",
            requirement: "the pressure converges with the square of the element size, quadratic \
                          types with its fourth power.",
            source: "Theory of finite elements: energy.",
            tolerance: "orders 1.9 and 3.5 from 4 to 8 elements; types of fewer points are told, not \
                        judged.",
            measure: orders,
        },
        Claim {
            name: "plastic_tube",
            requirement: "a tube without hardening carries 2 sigma ln(B/A)/sqrt 3.",
            source: "von Mises in plane strain.",
            tolerance: "1 %: 16 elements over the wall; small displacement.",
            measure: plastic,
        },
        Claim {
            name: "rubber_tube",
            requirement: "a neo-Hookean tube blown up by half its radius follows the incompressible \
                          closed form.",
            source: "shared derivation in crates/theory, closed::tube.",
            tolerance: "0.5 %: K = 10^4 G and 8 elements over the wall.",
            measure: rubber,
        },
    ],
};

const TUBE: Tube = Tube { inner: 1.0, outer: 2.0 };
const HEIGHT: f64 = 0.25;

/// Pressure and motion of the outer face for a motion of the inner one.
fn inflate(element: &str, cells: usize, material: &str, step: &str, moved: f64) -> [f64; 2] {
    let solid = Solid {
        element,
        cells: [cells, 1, 1],
        map: |[x, y, _]| [1.0 + x, HEIGHT * y, 0.0],
        material,
    };
    let mesh: Meshed = solid.mesh();
    let mut deck = format!("*HEADING\ntube\n{}*STEP{step}\n*BOUNDARY\n", mesh.text);
    deck.push_str(&mesh.hold(|_| true, 2, 0.0));
    deck.push_str(&mesh.hold(|at| at[0] == 0.0, 1, moved));
    deck.push_str("*END STEP\n");
    let Ok(curve) = run(&deck) else { return [f64::NAN; 2] };
    let inner = mesh.labels(|at| at[0] == 0.0);
    let force: f64 =
        inner.iter().filter_map(|&label| curve.reaction(label, 1).last().copied()).sum();
    let radius = if step.contains("NLGEOM") { 1.0 + moved } else { 1.0 };
    let area = 2.0 * std::f64::consts::PI * radius * HEIGHT;
    let outer = curve.displacement(mesh.nearest([1.0, 0.0, 0.0]), 1);
    [force / area, outer.last().copied().unwrap_or(f64::NAN)]
}

const LINEAR: &str = "\n*STATIC\n1.0, 1.0";

fn elastic(record: &mut Record) {
    let moved = 1e-3;
    let (pressure, outer) =
        (TUBE.elastic_pressure(moved, 7.0, 0.3), TUBE.elastic_outer(moved, 0.3));
    for (element, tolerance) in [
        ("CAX3", 0.02),
        ("CAX4", 0.01),
        ("CAX4I", 0.01),
        ("CAX4R", 0.01),
        ("CAX4H", 0.01),
        ("CAX6", 5e-4),
        ("CAX8", 5e-4),
        ("CAX8R", 5e-4),
    ] {
        let [p, u] = inflate(element, 8, "*ELASTIC\n7.0, 0.3\n", LINEAR, moved);
        record.at_most(format!("{element}, pressure"), (p / pressure - 1.0).abs(), tolerance);
        record.at_most(format!("{element}, outer face"), (u / outer - 1.0).abs(), tolerance);
    }
}

fn orders(record: &mut Record) {
    let exact = TUBE.elastic_pressure(1e-3, 7.0, 0.3);
    let order = |element: &str| {
        let error = |cells| {
            let [p, _] = inflate(element, cells, "*ELASTIC\n7.0, 0.3\n", LINEAR, 1e-3);
            (p / exact - 1.0).abs()
        };
        (error(4) / error(8)).log2()
    };
    for (element, least) in [("CAX4", 1.9), ("CAX4I", 1.9), ("CAX8", 3.5)] {
        record.at_least(format!("{element}, order"), order(element), least);
    }
    for element in ["CAX4R", "CAX8R"] {
        record.tell(format!("{element}, order"), order(element));
    }
}

fn plastic(record: &mut Record) {
    let exact = TUBE.limit_pressure(0.01);
    let material = "*ELASTIC\n7.0, 0.3\n*PLASTIC\n0.01, 0.0\n";
    for element in ["CAX4", "CAX4R", "CAX8R"] {
        let [p, _] = inflate(element, 16, material, "\n*STATIC\n0.1, 1.0", 0.02);
        record.at_most(format!("{element}, limit pressure"), (p / exact - 1.0).abs(), 0.01);
    }
}

fn rubber(record: &mut Record) {
    let exact = TUBE.rubber_pressure(1.5, 1.0);
    for element in ["CAX4", "CAX4H", "CAX8R"] {
        let material = "*HYPERELASTIC, NEO HOOKE\n0.5, 2.0E-4\n";
        let [p, _] = inflate(element, 8, material, ", NLGEOM\n*STATIC\n0.1, 1.0", 0.5);
        record.at_most(format!("{element}, pressure"), (p / exact - 1.0).abs(), 5e-3);
    }
}
