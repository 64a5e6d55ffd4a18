//! Stresses of beams in space in the files: at the points of their sections, and what the verdict
//! makes of them.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::{Job, Quiet, ReadOptions, RunOptions, Status, run};
use std::path::{Path, PathBuf};

const MODULUS: f64 = 1000.0;

/// A cantilever of two elements B31 along z with n1 along x, pulled and pushed at its tip; the files.
fn files(name: &str, section: &str, loads: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("beam_stresses").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    let deck = format!(
        "*NODE, NSET=ALL\n1, 0., 0., 0.\n2, 0., 0., 5.\n3, 0., 0., 10.\n*ELEMENT, TYPE=B31, ELSET=B\n\
         1, 1, 2\n2, 2, 3\n*BEAM SECTION, ELSET=B, MATERIAL=M, SECTION={section}\n1., 0., 0.\n\
         *MATERIAL, NAME=M\n*ELASTIC\n{MODULUS}, 0.25\n*ALLOWABLE, MATERIAL=M, STRAIN=1e-2\n*STEP\n\
         *STATIC\n*BOUNDARY\n1, 1, 6\n*CLOAD\n{loads}\n*EL PRINT, ELSET=B\nSF, S\n\
         *OUTPUT, FIELD\n*ELEMENT OUTPUT, ELSET=B\nS\n*END STEP\n"
    );
    let read = Job::read_text("beam", &deck, &ReadOptions::default());
    let options = RunOptions { folder: Some(folder.clone()), ..RunOptions::default() };
    let outcome = run(&read, &options, &mut Quiet);
    assert_eq!(outcome.status, Status::Completed, "{deck}\n{:?}", read.diagnostics);
    folder
}

/// Stresses of the first element in `beam.element.csv`.
fn stresses(folder: &Path) -> Vec<f64> {
    let text = std::fs::read_to_string(folder.join("beam.element.csv")).unwrap();
    let mut lines = text.lines();
    let heads: Vec<&str> = lines.next().unwrap().split(',').collect();
    // the state after the load, not that of the start
    let row = lines.rfind(|line| line.split(',').nth(3) == Some("1")).unwrap();
    let values = row.split(',').zip(heads).filter(|(_, head)| head.starts_with("S11_"));
    values.map(|(value, _)| value.parse().unwrap()).collect()
}

fn near(a: f64, b: f64, by: f64) {
    assert!((a - b).abs() <= by, "{a} {b}");
}

/// Requirement: the stresses of an angle at its corners are those of bending about its principal
/// axes and of the pull, which acts beside the centroid. Source: flexure in principal axes, found
/// here by turning. Tolerance: 1e-9 of the largest. The table has a row a point, the summary the
/// largest of all as a strain, and its share of the allowable one.
#[test]
fn an_angle_in_its_principal_axes() {
    let (pull, push) = (0.3, 0.05);
    let folder = files("angle", "L\n2., 3., 0.2, 0.3", &format!("3, 3, {pull}\n3, 2, {push}"));
    let plates = [(2.0, 0.2, [0.85, 0.0]), (0.3, 2.8, [0.0, 1.5])];
    let area: f64 = plates.iter().map(|(a, b, _)| a * b).sum();
    let c = [0, 1].map(|k| plates.iter().map(|(a, b, x)| a * b * x[k]).sum::<f64>() / area);
    let moment = |i: usize, j: usize| {
        let of = |(a, b, x): &(f64, f64, [f64; 2])| {
            let side: f64 = [a, b][i] * 1.0;
            let own = if i == j { a * b * side * side / 12.0 } else { 0.0 };
            own + a * b * (x[i] - c[i]) * (x[j] - c[j])
        };
        plates.iter().map(of).sum::<f64>()
    };
    let [xx, xy, yy] = [moment(0, 0), moment(0, 1), moment(1, 1)];
    let turn = 0.5 * (2.0 * xy).atan2(xx - yy);
    let (s, e) = turn.sin_cos();
    let along = |[x, y]: [f64; 2]| [e * x + s * y, e * y - s * x];
    // second moments of the coordinates along the principal axes
    let principal =
        [e * e * xx + 2.0 * s * e * xy + s * s * yy, s * s * xx - 2.0 * s * e * xy + e * e * yy];
    // stress = N/A + sum of gradient times coordinate; at the middle of the first element
    let arm = 10.0 - 2.5;
    let bent = along([-pull * c[0], -pull * c[1] - push * arm]);
    let corners = [[1.85, -0.1], [1.85, 0.1], [-0.15, -0.1], [0.15, 2.9], [-0.15, 2.9]];
    let expected = corners.map(|[x, y]| {
        let [p, q] = along([x - c[0], y - c[1]]);
        pull / area + bent[0] * p / principal[0] + bent[1] * q / principal[1]
    });
    let largest = expected.iter().fold(0.0_f64, |most, own| most.max(own.abs()));
    let told = stresses(&folder);
    assert_eq!(told.len(), 5);
    told.iter().zip(expected).for_each(|(own, by)| near(*own, by, 1e-9 * largest));
    let table = std::fs::read_to_string(folder.join("beam.dat")).unwrap();
    assert!(table.contains("POINT") && table.contains("S11"), "{table}");
    let summary = std::fs::read_to_string(folder.join("beam.json")).unwrap();
    let after = |key: &str| -> f64 {
        let rest = summary.split(key).nth(1).unwrap();
        rest[..rest.find([',', '}']).unwrap()].parse().unwrap()
    };
    near(after("\"fibre_strain\":{\"max\":"), largest / MODULUS, 1e-9 * largest / MODULUS);
    near(after("\"utilisation\":"), 100.0 * largest / MODULUS, 1e-7 * largest / MODULUS);
}

/// Requirement: bent in a skew direction a rod strains most between two of its points: at its rim,
/// M r / E I.
#[test]
fn the_rim_of_a_rod() {
    let (x, y) = (0.03_f64, 0.01_f64);
    let folder = files("rod", "CIRC\n0.5", &format!("3, 1, {x}\n3, 2, {y}"));
    let second_moment = 0.25 * std::f64::consts::PI * 0.5_f64.powi(4);
    let largest = x.hypot(y) * 7.5 * 0.5 / second_moment;
    let told = stresses(&folder);
    assert_eq!(told.len(), 8);
    assert!(told.iter().all(|own| own.abs() < 0.999 * largest), "{told:?}");
    let summary = std::fs::read_to_string(folder.join("beam.json")).unwrap();
    let rest = summary.split("\"fibre_strain\":{\"max\":").nth(1).unwrap();
    let strain: f64 = rest[..rest.find([',', '}']).unwrap()].parse().unwrap();
    near(strain, largest / MODULUS, 1e-9);
}
