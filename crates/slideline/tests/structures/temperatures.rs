//! Temperatures: free expansion, closed forms, steps, energy.
//!
//! Source: docs/theory.md section 3.7; closed forms of Timoshenko named where they stand.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::heat::{Watch, run, run_in};
use slideline::model::{Dialect, ElementType, TYPES, types};
use slideline::{Job, Quiet, ReadOptions, RunOptions, Status};
use std::fmt::Write as _;
use std::path::Path;

const YOUNG: f64 = 200.0;
const EXPANSION: f64 = 2e-3;
const HEAT: f64 = 100.0;

/// Solids that a single element leaves motions without stiffness, if it is held at points alone.
const LOOSE: [&str; 8] = ["CPS8R", "CPE8R", "CAX8R", "CAX3", "CAX4R", "C3D6", "C3D10H", "C3D20R"];

/// What a body is made of: elasticity, and coefficients of expansion along its axes.
struct Body<'a> {
    law: &'a str,
    expansion: [f64; 3],
    nlgeom: &'a str,
}

/// One element of a type, supported so that it moves as it likes; sheared where supports at points
/// hold it.
fn alone(row: &ElementType, body: &Body<'_>, heat: fn([f64; 3]) -> f64) -> String {
    let loose = LOOSE.contains(&row.name());
    let shear = if loose { 0.0 } else { 0.1 };
    let shape = |[x, y, z]: &[f64; 3]| [4.0 + x + 2.0 * shear * y, shear * x + y, *z];
    let places: Vec<[f64; 3]> = row.cell.places.iter().map(shape).collect();
    let mut text = String::from("*NODE\n");
    for (k, [x, y, z]) in places.iter().enumerate() {
        let _ = writeln!(text, "{}, {x}, {y}, {z}", k + 1);
    }
    let labels: Vec<String> = (1..=places.len()).map(|k| k.to_string()).collect();
    let _ = writeln!(text, "*ELEMENT, TYPE={}, ELSET=E", row.name());
    let lines: Vec<String> = labels.chunks(12).map(|line| line.join(",")).collect();
    let _ = writeln!(text, "1, {}", lines.join(",\n"));
    let [a, b, c] = body.expansion;
    let _ = write!(
        text,
        "*SOLID SECTION, ELSET=E, MATERIAL=M\n*MATERIAL, NAME=M\n{}\n\
         *EXPANSION, TYPE=ORTHO\n{a}, {b}, {c}\n*STEP, {}\n*STATIC\n0.25, 1.0\n*BOUNDARY\n",
        body.law, body.nlgeom
    );
    if loose {
        text.push_str(&on_planes(row, &places));
    } else {
        text.push_str(match (row.is_ring(), row.is_spatial()) {
            (true, _) => "1, 2\n",
            (_, false) => "1, 1, 2\n2, 2\n",
            (_, true) => "1, 1, 3\n2, 2, 3\n3, 3\n",
        });
    }
    text.push_str("*TEMPERATURE\n");
    for (k, at) in places.iter().enumerate() {
        let _ = writeln!(text, "{}, {}", k + 1, heat(*at));
    }
    text + "*END STEP\n"
}

/// Supports of the planes of smallest coordinates, the axis of rings left out.
fn on_planes(row: &ElementType, places: &[[f64; 3]]) -> String {
    let mut text = String::new();
    let axes = if row.is_spatial() { 0..3 } else { 0..2 };
    for axis in axes.filter(|axis| !(row.is_ring() && *axis == 0)) {
        let least = places.iter().fold(f64::INFINITY, |least, at| least.min(at[axis]));
        for (k, _) in places.iter().enumerate().filter(|(_, at)| at[axis] == least) {
            let _ = writeln!(text, "{}, {}", k + 1, axis + 1);
        }
    }
    text
}

/// Every solid but trusses.
fn solids() -> impl Iterator<Item = &'static ElementType> {
    TYPES
        .into_iter()
        .filter(|row| row.kinematics.card() == Some("*SOLID SECTION") && !row.is_truss())
}

/// Coefficients that leave an element free: a plane that is held across does not expand there, and
/// a ring grows as its hoops do.
fn free(row: &ElementType, [a, b, c]: [f64; 3]) -> [f64; 3] {
    match row.name() {
        name if name.starts_with("CPE") => [a, b, 0.0],
        _ if row.is_ring() => [a, b, a],
        _ => [a, b, c],
    }
}

/// Largest stress of a run of one solid.
fn largest_stress(row: &ElementType, watch: &Watch) -> f64 {
    let count = row.values(row.field("S").unwrap().0);
    watch.elements[..count].iter().fold(0.0, |most, s| f64::max(most, s.abs()))
}

/// Requirement: a free body of any element and law is free of stress at any even temperature, and
/// as large as its law says. Tolerance: rounding.
#[test]
fn free_expansion_is_free_of_stress() {
    let even = EXPANSION * HEAT;
    let laws = [
        ("*ELASTIC\n200.0, 0.3", even.exp()),
        ("*ELASTIC\n100.0, 0.2, 0.0\n300.0, 0.4, 200.0", even.exp()),
        ("*ELASTIC\n200.0, 0.3\n*PLASTIC\n1.0, 0.0\n2.0, 0.1", even.exp()),
        ("*HYPERELASTIC, NEO HOOKE\n40.0, 0.01", 1.0 + even),
    ];
    for row in solids() {
        for (law, stretch) in laws {
            let expansion = free(row, [EXPANSION; 3]);
            let large = run(&alone(row, &Body { law, expansion, nlgeom: "NLGEOM" }, |_| HEAT));
            let most = largest_stress(row, &large);
            assert!(most < 2e-12 * YOUNG, "{} {law} {most}", row.name());
            let small = run(&alone(row, &Body { law, expansion, nlgeom: "NLGEOM=NO" }, |_| HEAT));
            let most = largest_stress(row, &small);
            assert!(most < 2e-13 * YOUNG, "{} {law} {most}", row.name());
            if !row.is_ring() && !LOOSE.contains(&row.name()) {
                let [a, b] = [1, 2].map(|node| large.u[&node]);
                let [x, y, z] = [0, 1, 2].map(|axis| {
                    let place = |k: usize| {
                        let [x, y, z] = row.cell.places[k];
                        [4.0 + x + 0.2 * y, 0.1 * x + y, z][axis]
                    };
                    [place(1) - place(0), place(1) - place(0) + b[axis] - a[axis]]
                });
                let length = |k: usize| (x[k] * x[k] + y[k] * y[k] + z[k] * z[k]).sqrt();
                let error = length(1) / length(0) - stretch;
                assert!(error.abs() < 1e-12, "{} {law} {error}", row.name());
            }
        }
    }
}

/// Requirement: in the dialect of CalculiX a free body of any law is longer by its thermal strain itself. Source: ccx 2.20, a free cube
/// heated by 0.01 and 0.2: 1.000000E-02 and 0.2. Tolerance: that of the run.
#[test]
fn free_expansion_in_calculix_is_a_change_of_length() {
    let laws = ["*ELASTIC\n200.0, 0.3", "*HYPERELASTIC, NEO HOOKE\n40.0, 0.01"];
    let kind = solids().find(|row| row.name() == "C3D8").unwrap();
    for law in laws {
        let body = Body { law, expansion: [EXPANSION; 3], nlgeom: "NLGEOM" };
        let deck = alone(kind, &body, |_| HEAT);
        let watch = run_in(&deck, Dialect::Calculix);
        let [a, b] = [1, 2].map(|node| watch.u[&node]);
        let [from, to] = [0, 1].map(|k: usize| kind.cell.places[k]);
        let along: [f64; 3] = std::array::from_fn(|k| to[k] - from[k]);
        let [x, y, z] = [along[0] + 0.2 * along[1], 0.1 * along[0] + along[1], along[2]];
        let length = |by: [f64; 3]| (x + by[0]).hypot(y + by[1]).hypot(z + by[2]);
        let moved = std::array::from_fn(|k| b[k] - a[k]);
        let error = length(moved) / length([0.0; 3]) - 1.0 - EXPANSION * HEAT;
        assert!(error.abs() < 1e-12, "{law} {error}");
    }
}

/// Requirement: the same of a body that neither stretches nor expands alike in all directions.
#[test]
fn free_expansion_along_three_axes() {
    let law = "*ELASTIC, TYPE=ENGINEERING CONSTANTS\n200.0, 100.0, 50.0, 0.3, 0.2, 0.25, 60.0, \
               40.0\n30.0";
    for row in solids() {
        let expansion = free(row, [EXPANSION, 0.5 * EXPANSION, -0.25 * EXPANSION]);
        for nlgeom in ["NLGEOM", "NLGEOM=NO"] {
            let watch = run(&alone(row, &Body { law, expansion, nlgeom }, |_| HEAT));
            let most = largest_stress(row, &watch);
            assert!(most < 2e-12 * YOUNG, "{} {nlgeom} {most}", row.name());
            assert!(watch.u.values().flatten().any(|u| u.abs() > 1e-3), "{}", row.name());
        }
    }
}

/// Requirement: where temperatures run straight through a free body it bends without stress, with
/// every element that can bend so: quadratic ones and those with incompatible modes. Source: a
/// thermal strain that is linear is compatible. Tolerance: rounding.
#[test]
fn a_straight_field_leaves_bending_elements_free() {
    let bends = |row: &&ElementType| {
        let straight = row.cell.is_quadratic() || row.name().ends_with('I');
        !row.is_ring() && straight && !LOOSE.contains(&row.name())
    };
    for row in solids().filter(bends) {
        let expansion = free(row, [EXPANSION; 3]);
        let body = Body { law: "*ELASTIC\n200.0, 0.3", expansion, nlgeom: "NLGEOM=NO" };
        let text = alone(row, &body, |[x, y, _]| 20.0 + 3.0 * (x - 4.0) + 5.0 * y);
        let watch = run(&text);
        let most = largest_stress(row, &watch);
        let scale = YOUNG * EXPANSION * 8.0;
        assert!(most < 1e-12 * scale, "{} {most}", row.name());
        assert!(watch.u[&3][1] != 0.0);
    }
}

/// Requirement: a body that is held all round is under the pressure 3 K a T, at large strain
/// J_th 3 K a T of logarithmic strain; forces of mean coefficients from another zero. Source:
/// docs/theory.md eqs. (3.60) to (3.62). Tolerance: rounding.
#[test]
fn held_all_round() {
    let deck = |nlgeom: &str| {
        format!(
            "*NODE\n1,0,0\n2,1,0\n3,2,0\n4,0,1\n5,1,1\n6,2,1\n*NSET, NSET=ALL, GENERATE\n1,6,1\n\
             *ELEMENT, TYPE=CPE4, ELSET=E\n1, 1,2,5,4\n2, 2,3,6,5\n\
             *SOLID SECTION, ELSET=E, MATERIAL=M\n*MATERIAL, NAME=M\n*ELASTIC\n200.0, 0.3\n\
             *EXPANSION, ZERO=10.\n1e-3, 20.\n3e-3, 120.\n\
             *INITIAL CONDITIONS, TYPE=TEMPERATURE\nALL, 20.\n*STEP, {nlgeom}\n*STATIC\n0.5, 1.0\n\
             *BOUNDARY\nALL, 2\n1, 1\n4, 1\n3, 1\n6, 1\n*TEMPERATURE\nALL, 70.\n*END STEP\n"
        )
    };
    // a(70) = 2e-3
    let strain: f64 = 2e-3 * 60.0 - 1e-3 * 10.0;
    let pressure = 3.0 * 200.0 / (3.0 * 0.4) * strain;
    for (nlgeom, exact) in [("NLGEOM=NO", pressure), ("NLGEOM", (3.0 * strain).exp() * pressure)] {
        let watch = run(&deck(nlgeom));
        let pushed = watch.reactions[&1][0] + watch.reactions[&4][0];
        assert!((pushed - exact).abs() < 1e-12 * exact, "{nlgeom} {pushed} {exact}");
        let energy = watch.energies.last().unwrap();
        assert!((energy.thermal_work - energy.strain_energy).abs() < 1e-12 * energy.strain_energy);
    }
}

/// A mesh of `CPS8` or `CAX8` on [x0, x0 + length] x [0, height], its material by the row.
fn mesh(kind: &str, [nx, ny]: [usize; 2], [x0, length, height]: [f64; 3]) -> String {
    let label = |i: usize, j: usize| 1 + i + 1000 * j;
    let mut text = String::from("*NODE\n");
    for j in 0..=2 * ny {
        for i in (0..=2 * nx).filter(|i| i % 2 == 0 || j % 2 == 0) {
            let x = x0 + length * i as f64 / (2 * nx) as f64;
            let _ = writeln!(text, "{}, {x}, {}", label(i, j), height * j as f64 / (2 * ny) as f64);
        }
    }
    for j in 0..ny {
        let _ = writeln!(text, "*ELEMENT, TYPE={kind}, ELSET=ROW{j}");
        for i in 0..nx {
            let (a, b) = (2 * i, 2 * j);
            let nodes = [
                (a, b),
                (a + 2, b),
                (a + 2, b + 2),
                (a, b + 2),
                (a + 1, b),
                (a + 2, b + 1),
                (a + 1, b + 2),
                (a, b + 1),
            ];
            let nodes: Vec<String> = nodes.map(|(i, j)| label(i, j).to_string()).to_vec();
            let _ = writeln!(text, "{}, {}", 1 + i + 1000 * j, nodes.join(", "));
        }
    }
    text
}

/// Requirement: a strip of two metals bends with the curvature of Timoshenko (1925). Tolerance:
/// what is left of the ends in the middle.
#[test]
fn bimetal_strip() {
    let (soft, hard, heat) = (100.0, 200.0, 50.0);
    let mut text = mesh("CPS8", [20, 2], [0.0, 10.0, 1.0]);
    for (row, young, a) in [(0, soft, 3e-5), (1, hard, 1e-5)] {
        let _ = write!(
            text,
            "*SOLID SECTION, ELSET=ROW{row}, MATERIAL=M{row}\n1.0\n*MATERIAL, NAME=M{row}\n\
             *ELASTIC\n{young}, 0.3\n*EXPANSION\n{a}\n"
        );
    }
    text.push_str("*NSET, NSET=ALL, ELSET=ROW0\n*NSET, NSET=ALL, ELSET=ROW1\n");
    let _ = write!(
        text,
        "*STEP\n*STATIC\n1.0, 1.0\n*BOUNDARY\n1, 1, 2\n41, 2\n*TEMPERATURE\nALL, {heat}\n*END STEP\n"
    );
    let watch = run(&text);
    let down = |i: u64| watch.u[&(1 + i)][1];
    let curvature = (down(16) - 2.0 * down(20) + down(24)) / (1.0 * 1.0);
    let (m, n) = (1.0_f64, soft / hard);
    let part = 3.0 * (1.0 + m).powi(2) + (1.0 + m * n) * (m * m + 1.0 / (m * n));
    let exact = 6.0 * 2e-5 * heat * (1.0 + m).powi(2) / part;
    // the lower one expands more: the middle comes below the line of the ends
    assert!((curvature - exact).abs() < 1e-7 * exact, "{curvature} {exact}");
}

/// Requirement: a long tube, hot inside, grows as in Timoshenko and Goodier (1951), article 135,
/// held along its axis. Tolerance: that of ten quadratic elements.
#[test]
fn thick_tube() {
    let (a, b, heat, alpha, nu) = (1.0_f64, 2.0_f64, 80.0, 1e-5, 0.3);
    let field = |r: f64| heat * (b / r).ln() / (b / a).ln();
    let mut text = mesh("CAX8", [10, 1], [a, b - a, 0.1]);
    text.push_str("*NSET, NSET=ALL, ELSET=ROW0\n*SOLID SECTION, ELSET=ROW0, MATERIAL=M\n");
    let _ = write!(
        text,
        "*MATERIAL, NAME=M\n*ELASTIC\n200.0, {nu}\n*EXPANSION\n{alpha}\n\
         *STEP\n*STATIC\n1.0, 1.0\n*BOUNDARY\nALL, 2\n*TEMPERATURE\n"
    );
    for j in 0..=2 {
        for i in (0..=20).filter(|i| i % 2 == 0 || j % 2 == 0) {
            let _ = writeln!(text, "{}, {}", 1 + i + 1000 * j, field(a + 0.05 * i as f64));
        }
    }
    let watch = run(&(text + "*END STEP\n"));
    // integral of T r from a to r
    let sum = |r: f64| {
        let of = |r: f64| 0.5 * r * r * ((b / r).ln() + 0.5);
        heat / (b / a).ln() * (of(r) - of(a))
    };
    let exact = |r: f64| {
        let all = sum(b) / (b * b - a * a);
        (1.0 + nu) * alpha / (1.0 - nu) * (sum(r) / r + ((1.0 - 2.0 * nu) * r + a * a / r) * all)
    };
    for i in 0..=20_u64 {
        let r = a + 0.05 * i as f64;
        let error = watch.u[&(1 + i)][0] / exact(r) - 1.0;
        assert!(error.abs() < 1e-5, "{r} {error}");
    }
}

/// A row of beams of a type along the x axis, four elements on a length of 2.
fn beams(row: &ElementType, (nlgeom, boundary, heat): (&str, &str, &str)) -> String {
    let nodes = 4 * (row.cell.nodes - 1) + 1;
    let mut text = String::from("*NODE\n");
    for k in 0..nodes {
        let _ = writeln!(text, "{}, {}, 0.0", k + 1, 2.0 * k as f64 / (nodes - 1) as f64);
    }
    let _ = writeln!(text, "*NSET, NSET=ALL, GENERATE\n1, {nodes}, 1\n*NSET, NSET=TIP\n{nodes}");
    let _ = writeln!(text, "*ELEMENT, TYPE={}, ELSET=B", row.name());
    for k in 0..4 {
        let first = 1 + k * (row.cell.nodes - 1);
        let own: Vec<String> = (first..first + row.cell.nodes).map(|n| n.to_string()).collect();
        let _ = writeln!(text, "{}, {}", k + 1, own.join(", "));
    }
    text + &format!(
        "*BEAM SECTION, SECTION=RECT, ELSET=B, MATERIAL=M\n0.3, 0.1\n*MATERIAL, NAME=M\n*ELASTIC\n\
         200.0, 0.3, 0.\n100.0, 0.3, 100.\n*EXPANSION\n{EXPANSION}\n*STEP, {nlgeom}\n*STATIC\n\
         0.25, 1.0\n*BOUNDARY\n1, 1, 6\n{boundary}\n*TEMPERATURE\nALL, {heat}\n*END STEP\n"
    )
}

/// Requirement: a free beam grows by a T and is bent by -a dT/dy a length, to an arc at large
/// displacement, without forces; one that is held has N = -E(T) A a T. Source: docs/theory.md eq.
/// (3.63). Tolerance: rounding, and convergence of the iterations.
#[test]
fn beams_expand_and_bend() {
    for row in [&types::B21, &types::B22, &types::B23] {
        let tip = if row.cell.nodes == 3 { 9 } else { 5 };
        for nlgeom in ["NLGEOM", "NLGEOM=NO"] {
            let watch = run(&beams(row, (nlgeom, "1, 1, 6", "50.0")));
            assert!((watch.u[&tip][0] - 2.0 * EXPANSION * 50.0).abs() < 1e-12, "{}", row.name());
            let most = watch.elements.chunks(6).map(|own| own[0].abs()).fold(0.0, f64::max);
            assert!(most < 1e-11, "{} {most}", row.name());
            let watch = run(&beams(row, (nlgeom, "1, 1, 6", "50.0, 400.0")));
            let turn = -EXPANSION * 400.0 * 2.0;
            assert!((watch.u[&tip][5] - turn).abs() < 1e-9, "{} {:?}", row.name(), watch.u[&tip]);
            let watch = run(&beams(row, (nlgeom, "TIP, 1, 6", "50.0")));
            let exact = 150.0 * 0.03 * EXPANSION * 50.0;
            let pushed = watch.reactions[&1][0];
            assert!((pushed - exact).abs() < 1e-11, "{} {pushed} {exact}", row.name());
        }
    }
}

/// Requirement: where the energy is quadratic, heat and loads together leave nothing over.
/// Tolerance: rounding.
#[test]
fn the_energy_of_heat_balances() {
    let mut text = mesh("CPS8", [3, 2], [0.0, 3.0, 1.0]);
    text.push_str(
        "*ELSET, ELSET=E\nROW0, ROW1\n*SOLID SECTION, ELSET=E, MATERIAL=M\n*MATERIAL, NAME=M\n\
         *ELASTIC\n200.0, 0.3\n*EXPANSION\n1e-3\n*NSET, NSET=ALL, ELSET=E\n\
         *STEP\n*STATIC\n0.125, 1.0, 1e-5, 0.125\n*BOUNDARY\n1, 1, 2\n2001, 1\n4001, 1\n7, 1\n\
         *CLOAD\n4004, 2, -3.0\n*TEMPERATURE\nALL, 40.\n4004, 90.\n*END STEP\n",
    );
    let watch = run(&text);
    let last = watch.energies.last().unwrap();
    assert!(last.thermal_work > 0.05 && last.strain_energy > 0.1, "{last:?}");
    assert!(last.balance.abs() < 1e-12 * last.strain_energy, "{last:?}");
}

/// Requirement: bodies that follow heat freely hold no energy and are not warned of any: what is left of the
/// work of heat is of the order of the strain of an increment, times the energy that heat adds and the
/// motion takes back. With large displacements, in the plane and of rings, hot and cold.
#[test]
fn free_bodies_miss_no_energy_of_heat() {
    for (kind, to) in ["CPS8", "CAX8"].into_iter().flat_map(|kind| [(kind, -90.), (kind, 200.)]) {
        let text = mesh(kind, [3, 2], [1.0, 3.0, 1.0])
            + &format!(
                "*ELSET, ELSET=E\nROW0, ROW1\n*SOLID SECTION, ELSET=E, MATERIAL=M\n*MATERIAL, NAME=M\n\
                 *ELASTIC\n2e5, 0.3\n*EXPANSION\n1.2e-5\n*NSET, NSET=ALL, ELSET=E\n\
                 *STEP, NLGEOM\n*STATIC\n0.25, 1.0\n*BOUNDARY\n1, {}, 2\n{}*TEMPERATURE\nALL, {to}\n\
                 *END STEP\n",
                if kind == "CAX8" { 2 } else { 1 },
                if kind == "CAX8" { "" } else { "7, 2\n" },
            );
        let read = Job::read_text("free", &text, &ReadOptions::default());
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("free_heat");
        let options = RunOptions { folder: Some(folder), ..RunOptions::default() };
        let outcome = slideline::run(&read, &options, &mut Quiet);
        assert_eq!(outcome.status, Status::Completed, "{kind} {:#?}", outcome.diagnostics);
        let warned = outcome.diagnostics.iter().find(|said| said.code.0 == "SL0604");
        assert!(warned.is_none(), "{kind} {to}: {warned:#?}");
    }
}

/// Requirement: temperatures run straight over a step, follow amplitudes, stay with OP=MOD and go
/// back to where they began with OP=NEW. Source: manuals, `*TEMPERATURE`.
#[test]
fn temperatures_over_steps() {
    let text = "*NODE\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n*NSET, NSET=ALL\n1,2,3,4\n\
         *ELEMENT, TYPE=CPS4, ELSET=E\n1, 1,2,3,4\n*SOLID SECTION, ELSET=E, MATERIAL=M\n\
         *MATERIAL, NAME=M\n*ELASTIC\n200.0, 0.3\n*PHYSICAL CONSTANTS, ABSOLUTE ZERO=-273.15\n\
         *AMPLITUDE, NAME=A\n0.0, 0.0, 0.5, 1.0, 1.0, 0.5\n\
         *INITIAL CONDITIONS, TYPE=TEMPERATURE\nALL, 20.\n4, 10.\n\
         *STEP\n*STATIC, DIRECT\n0.5, 1.0\n*BOUNDARY\n1, 1, 2\n2, 2\n\
         *TEMPERATURE\nALL, 60.\n*TEMPERATURE, AMPLITUDE=A\n3, 80.\n*END STEP\n\
         *STEP\n*STATIC, DIRECT\n0.5, 1.0\n*TEMPERATURE\n2, 100.\n*END STEP\n\
         *STEP\n*STATIC, DIRECT\n0.5, 1.0\n*TEMPERATURE, OP=NEW\n1, 0.\n*END STEP\n";
    let exact = [
        [40.0, 40.0, 80.0, 35.0],
        [60.0, 60.0, 40.0, 60.0],
        [60.0, 80.0, 40.0, 60.0],
        [60.0, 100.0, 40.0, 60.0],
        [30.0, 60.0, 30.0, 35.0],
        [0.0, 20.0, 20.0, 10.0],
    ];
    assert_eq!(run(text).temperatures, exact);
}
