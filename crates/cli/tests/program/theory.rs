//! `slideline theory` and `slideline reproduce` as a user types them.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use std::path::Path;
use std::process::{Command, Output};

fn slideline(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_slideline")).args(arguments).output().unwrap()
}

fn table(arguments: &[&str]) -> (String, Vec<Vec<f64>>) {
    let output = slideline(arguments);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let text = String::from_utf8(output.stdout).unwrap();
    let mut lines = text.lines().map(str::to_owned);
    let header = lines.next().unwrap();
    let rows = lines.map(|line| line.split(',').map(|v| v.parse().unwrap()).collect()).collect();
    (header, rows)
}

/// Verification section 1.2, k = 20; seven digits are given there.
#[test]
fn the_first_problem() {
    let (header, rows) = table(&["theory", "diehl-1", "--mu", "0.3"]);
    assert_eq!(header, "increment,time,RF1,RF2,U2,xi_L,F");
    assert_eq!(rows.len(), 21);
    let near = |found: f64, expected: f64| (found / expected - 1.0).abs() < 1e-6;
    assert!(near(rows[20][3], -36.07584) && near(rows[20][5], 13.42578e-3), "{:?}", rows[20]);
    let (_, rows) = table(&["theory", "diehl-1", "--mu", "0", "--exact", "elastica"]);
    assert!(near(rows[20][3], -13.63925), "{:?}", rows[20]);
}

/// Verification section 2: no contact at k = 0, 1; the moment at k = 10.
#[test]
fn the_second_problem() {
    let (header, rows) = table(&["theory", "diehl-2", "--mu", "0.3", "--increments", "20"]);
    assert_eq!(header, "increment,time,RM3,UR3,xi_L,F");
    assert!(rows[1][4].is_nan() && rows[1][5] == 0.0);
    assert!((rows[10][2] / -0.07295934 - 1.0).abs() < 1e-6, "{:?}", rows[10]);
    assert!((rows[20][3] + 60f64.to_radians()).abs() < 1e-15);
}

/// Plain --exact is reissner; the area of the ISL deck is the default.
#[test]
fn defaults_of_the_exact_references() {
    let of = |more: &[&str]| {
        let base = ["theory", "diehl-1", "--mu", "0.3", "--increments", "4"];
        slideline(&[&base, more].concat()).stdout
    };
    assert_eq!(of(&["--exact"]), of(&["--exact", "reissner"]));
    assert_ne!(of(&["--exact"]), of(&["--exact", "softened"]));
    let area = (50e-3 * 9e-3 * 2f64.to_radians().sin()).to_string();
    let named = of(&["--exact", "softened", "--area", &area]);
    assert_eq!(of(&["--exact", "softened"]), named);
    assert!(!of(&["--exact", "continuum"]).is_empty());
    assert_ne!(of(&["--stroke", "return"]), of(&[]));
}

/// Requirement: references hold for any dimensions. Source: dimensional analysis: lengths times
/// 1000 and moduli and pressures over 1e6 leave forces, which are E times a length squared, as they
/// are; the clamp moved along with the circle changes nothing. Tolerance: the references' 1e-8.
#[test]
fn other_dimensions() {
    let scaled = [
        "base-x=7",
        "tip-x=9.222",
        "tip-y=50",
        "width=25",
        "thickness=1.5",
        "modulus=6900",
        "radius=9",
        "start-y=45",
        "travel=-30",
        "clearance=1e-2",
        "pressure=4.8",
    ];
    let moved = ["base-x=0.107", "tip-x=0.109222", "circle-x=0.1"];
    let of = |set: &[&str]| {
        let mut line =
            vec!["theory", "diehl-1", "--mu", "0.3", "--increments", "5", "--exact", "continuum"];
        set.iter().for_each(|entry| line.extend(["--set", entry]));
        table(&line).1
    };
    let plain = of(&[]);
    for set in [&scaled[..], &moved[..]] {
        for (row, other) in plain.iter().zip(of(set)) {
            for column in [2, 3, 6] {
                let close = (other[column] - row[column]).abs() < 1e-8 * plain[5][column].abs();
                assert!(close, "{set:?}: {row:?} {other:?}");
            }
        }
    }
    assert_ne!(plain, of(&["thickness=1.6e-3"]));
}

#[test]
fn what_does_not_exist_is_told() {
    for (arguments, code, words) in [
        (vec!["diehl-1", "--mu", "-0.1"], 1, "must not be negative"),
        (vec!["diehl-1", "--mu", "NaN"], 1, "must not be negative"),
        (vec!["diehl-1", "--mu", "0", "--exact", "softened", "--area", "-1"], 1, "area"),
        (vec!["diehl-1", "--mu", "20", "--exact", "reissner"], 1, "increment"),
        (vec!["diehl-1", "--mu", "0", "--area", "1e-5"], 64, "--exact softened"),
        (vec!["diehl-1", "--mu", "0", "--increments", "0"], 64, "whole number"),
        (vec!["diehl-3", "--mu", "0"], 64, "diehl-1"),
        (vec!["diehl-1", "--mu", "0", "--exact", "--set", "circle-x=-1"], 1, "no contact"),
        (vec!["diehl-2", "--mu", "0", "--set", "pivot-y=1"], 1, "no contact"),
        (vec!["diehl-1", "--mu", "0", "--set", "list"], 64, "thickness"),
        (vec!["diehl-1", "--mu", "0", "--set", "radius=nine"], 64, "needs a number"),
        (vec!["diehl-1", "--mu", "0", "--set", "radius=-1"], 1, "radius"),
        (vec!["diehl-1", "--mu", "0", "--set", "start-y=9e-3"], 1, "clamp"),
    ] {
        let output = slideline(&[vec!["theory"], arguments.clone()].concat());
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(code), "{arguments:?}: {said}");
        assert!(said.contains(words) && output.stdout.is_empty(), "{arguments:?}: {said}");
    }
}

#[test]
fn the_study_is_made_and_said_where() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("study");
    let output = slideline(&["reproduce", "--out", folder.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let said = String::from_utf8(output.stdout).unwrap();
    assert!(said.lines().next().unwrap().contains("] "), "{said}");
    assert!(said.lines().last().unwrap().contains("diehl1995.html"), "{said}");
    for name in ["fig1.svg", "fig8b.png", "errors.csv", "diehl1995.html"] {
        assert!(folder.join(name).is_file(), "{name}");
    }
    let quiet = slideline(&["reproduce", "--quiet", "--out", folder.to_str().unwrap()]);
    assert!(quiet.stdout.is_empty() && quiet.status.success());
    let blocked = folder.join("errors.csv").join("below");
    let blocked = slideline(&["reproduce", "--out", blocked.to_str().unwrap()]);
    assert_eq!(blocked.status.code(), Some(4));
}
