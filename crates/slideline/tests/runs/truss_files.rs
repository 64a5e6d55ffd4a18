//! What files say of trusses: along them, and in the files of ccx along the axes of the model.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::{Dialect, Job, Quiet, ReadOptions, RunOptions, Status};
use std::path::PathBuf;

/// The files of a run, by their endings.
fn run(name: &str, deck: &str, dialect: Dialect) -> impl Fn(&str) -> String + use<> {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("truss_files").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    let reading = ReadOptions { dialect: Some(dialect), ..ReadOptions::default() };
    let read = Job::read_text("job", deck, &reading);
    let options = RunOptions { folder: Some(folder.clone()), ..RunOptions::default() };
    let outcome = slideline::run(&read, &options, &mut Quiet);
    assert_eq!(outcome.status, Status::Completed, "{:#?} {:#?}", read.diagnostics, outcome);
    move |ending| std::fs::read_to_string(folder.join(format!("job{ending}"))).unwrap_or_default()
}

/// Two bars at right angles, the first along (3, 4)/5, whose tip is pulled along that one: at E = 1000 and an area of .5 a force
/// of one stretches it by .002, to a stress of two.
fn bars(kind: &str) -> String {
    let (three, in_space) = (kind.ends_with('3'), kind.starts_with("T3"));
    let elements = if three { "1, 1, 4, 2\n2, 2, 5, 3" } else { "1, 1, 2\n2, 2, 3" };
    let middles = if three { "4, 1.5, 2.\n5, 1., 5.5\n" } else { "" };
    let moved =
        if three { "4, 1, 1, .003\n4, 2, 2, .004\n5, 1, 1, .003\n5, 2, 2, .004\n" } else { "" };
    let flat = if in_space { "ALL, 3\n" } else { "" };
    format!(
        "*NODE, NSET=ALL\n1, 0., 0.\n2, 3., 4.\n3, -1., 7.\n{middles}*ELEMENT, TYPE={kind}, ELSET=B\n{elements}\n\
         *SOLID SECTION, ELSET=B, MATERIAL=M\n.5\n*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n\
         *BOUNDARY\n1, 1, 2\n3, 1, 2\n{flat}*STEP\n*STATIC\n1., 1.\n*BOUNDARY\n{moved}*CLOAD\n2, 1, .6\n2, 2, .8\n\
         *EL PRINT, ELSET=B\nS, E\n*EL FILE, ELSET=B\nS, E\n*NODE FILE\nU\n*END STEP\n"
    )
}

fn close(found: &[f64], exact: &[f64], scale: f64) {
    let apart = found.iter().zip(exact).any(|(own, exact)| (own - exact).abs() > 1e-5 * scale);
    assert!(found.len() == exact.len() && !apart, "{found:?} for {exact:?}");
}

/// The numbers of a line behind its first cells.
fn numbers(line: &str, behind: usize) -> Vec<f64> {
    line.split_whitespace().skip(behind).map(|cell| cell.parse().unwrap()).collect()
}

/// The lines below the one that holds some text.
fn below<'a>(text: &'a str, heading: &str) -> impl Iterator<Item = &'a str> {
    let (_, rest) = text.split_once(heading).unwrap_or_else(|| panic!("no {heading}: {text}"));
    rest.lines().skip(1).filter(|line| !line.trim().is_empty())
}

/// Requirement: stress and strain along a truss stand in JOB.element.csv, and in JOB.dat under their own title, a row a point.
/// Source: sigma = F/A, docs/files.md. Tolerance: digits of the table.
#[test]
fn trusses_have_their_stress_in_tables() {
    for (kind, points) in [("T2D2", 1), ("T2D3", 2), ("T3D2", 1), ("T3D3", 2)] {
        let file = run(kind, &bars(kind), Dialect::Abaqus);
        let rows = file(".element.csv");
        let mut lines = rows.lines();
        let heading: Vec<&str> = lines.next().unwrap().split(',').collect();
        let column = |name: &str| heading.iter().position(|own| *own == name).unwrap();
        let columns = ["element", "point", "S11", "S22", "MISES", "E11"].map(column);
        let each: Vec<Vec<f64>> = lines
            .map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect())
            .map(|cells: Vec<f64>| columns.map(|column| cells[column]).to_vec())
            .collect();
        assert_eq!(each.len(), 2 * points, "{rows}");
        close(&each[0], &[1.0, 1.0, 2.0, 0.0, 2.0, 0.002], 1.0);
        close(&[each[0][5]], &[0.002], 0.002);
        close(&each[2 * points - 1], &[2.0, points as f64, 0.0, 0.0, 0.0, 0.0], 1.0);
        let table = file(".dat");
        assert!(table.contains("ELEMENTS B"), "{table}");
        let first = below(&table, "ELEMENTS B").nth(1).unwrap().to_owned();
        close(&numbers(&first, 0), &[1.0, 1.0, 2.0, 0.002], 1.0);
    }
}

/// Requirement: in the dialect of CalculiX tables and the file of results have them as tensors along the axes of the model, with
/// the strain across. Source: ccx 2.20 on bars along an axis; S = s t t', E = e t t' + q (1 - t t'), q = -nu e.
/// Tolerance: digits of the files.
#[test]
fn ccx_is_told_of_trusses_along_the_axes_of_the_model() {
    let (e, q) = (0.002, -0.0006);
    let stress = [0.72, 1.28, 0.0, 0.96, 0.0, 0.0];
    let strain = [0.36 * e + 0.64 * q, 0.64 * e + 0.36 * q, q, 0.48 * (e - q), 0.0, 0.0];
    for (kind, points) in [("T2D2", 1), ("T3D2", 1), ("T3D3", 2)] {
        let file = run(&format!("ccx-{kind}"), &bars(kind), Dialect::Calculix);
        let table = file(".dat");
        for (heading, exact, scale) in
            [("stresses (elem", stress, 2.0), ("strains (elem", strain, e)]
        {
            let rows: Vec<&str> = below(&table, heading).take(2 * points).collect();
            close(&numbers(rows[0], 2), &exact, scale);
            close(&numbers(rows[2 * points - 1], 2), &[0.0; 6], scale);
        }
        let frd = file(".frd");
        let row = below(&frd, "STRESS").find(|line| line.starts_with(" -1         1")).unwrap();
        let cells = row.as_bytes()[13..].chunks(12).map(|cell| String::from_utf8_lossy(cell));
        let values: Vec<f64> = cells.map(|cell| cell.trim().parse().unwrap()).collect();
        close(&values, &[0.72, 1.28, 0.0, 0.96, 0.0, 0.0], 2.0);
    }
}
