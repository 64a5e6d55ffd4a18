//! `slideline new`: decks to begin with.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const KINDS: [&str; 5] = ["snap-fit", "annular", "cam", "leaf-switch", "battery-spring"];

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("new").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

fn slideline(folder: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let program = env!("CARGO_BIN_EXE_slideline");
    let Output { status, stdout, stderr } =
        Command::new(program).args(arguments).current_dir(folder).output().unwrap();
    (status.code(), String::from_utf8(stdout).unwrap(), String::from_utf8(stderr).unwrap())
}

/// Smallest and largest value of a column of a node over the run.
fn extremes(folder: &Path, job: &str, node: &str, column: &str) -> [f64; 2] {
    let text = std::fs::read_to_string(folder.join(format!("{job}.history.csv"))).unwrap();
    let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let head = lines.next().unwrap();
    let place = head.iter().position(|name| *name == column).unwrap();
    let own = lines.filter(|row| row[3] == node).map(|row| row[place].parse::<f64>().unwrap());
    own.fold([0.0, 0.0], |[low, high], value| [f64::min(low, value), f64::max(high, value)])
}

/// Requirement: every deck is written, runs to its end without a warning, and its verdict is green.
#[test]
fn every_kind_runs_as_it_is() {
    let folder = folder("all");
    for kind in KINDS {
        let (code, said, errors) = slideline(&folder, &["new", kind]);
        assert_eq!((code, errors.as_str()), (Some(0), ""));
        assert!(said.contains(&format!("slideline run {kind}.inp")), "{said}");
        let (code, said, errors) = slideline(&folder, &["run", kind, "--no-html"]);
        assert_eq!(code, Some(0), "{kind}: {errors}");
        assert!(said.contains("verdict: green\n"), "{kind}: {said}");
        assert!(!errors.contains("warning["), "{kind}: {errors}");
        assert!(!errors.contains("advice["), "{kind}: {errors}");
    }
}

/// Requirement: a deck does in any set of units what its head says: with all parameters in metres
/// and pascals the largest force is the same in newtons, the largest moment a thousandth.
#[test]
fn every_kind_runs_in_other_units() {
    let folder = folder("units");
    let kinds = [
        ("snap-fit", "100", "RF1", 1.0),
        ("annular", "9000", "RF2", 1.0),
        ("cam", "100", "RM3", 1.0e-3),
        ("leaf-switch", "100", "RF2", 1.0),
        ("battery-spring", "100", "RF2", 1.0),
    ];
    for (kind, node, column, factor) in kinds {
        slideline(&folder, &["new", kind]);
        slideline(&folder, &["run", kind, "--no-html"]);
        let deck = std::fs::read_to_string(folder.join(format!("{kind}.inp"))).unwrap();
        let other: Vec<String> = deck.lines().map(in_metres).collect();
        std::fs::write(folder.join("metres.inp"), other.join("\n")).unwrap();
        let (_, said, errors) = slideline(&folder, &["run", "metres", "--no-html"]);
        assert!(said.contains("verdict: green\n"), "{kind}: {said}{errors}");
        let largest = |job: &str| {
            let [low, high] = extremes(&folder, job, node, column);
            high.max(-low)
        };
        let (own, other) = (factor * largest(kind), largest("metres"));
        assert!(own > 0.0 && (own - other).abs() < 1e-6 * own, "{kind}: {own}, {other}");
    }
}

/// A line of a deck with its value in metres or pascals.
fn in_metres(line: &str) -> String {
    let factor = match line {
        _ if line.contains("[mm]") => 1.0e-3,
        _ if line.contains("[MPa]") => 1.0e6,
        _ => return line.to_owned(),
    };
    let (name, rest) = line.split_once(" = ").unwrap();
    let value: f64 = rest.split('#').next().unwrap().trim().parse().unwrap();
    format!("{name} = {:?}", value * factor)
}

/// Requirement: every parameter of a deck may be set for one run, and the geometry follows: with
/// each a fifth larger the deck still runs to its end.
#[test]
fn parameters_can_be_set() {
    let folder = folder("set");
    for kind in KINDS {
        slideline(&folder, &["new", kind]);
        let deck = std::fs::read_to_string(folder.join(format!("{kind}.inp"))).unwrap();
        let own = deck.lines().filter_map(|line| line.split_once(" = "));
        let own: Vec<(&str, f64)> = own
            .filter_map(|(name, rest)| Some((name, rest.split('#').next()?.trim().parse().ok()?)))
            .collect();
        assert!(own.len() >= 10, "{kind}: {own:?}");
        for (name, value) in own {
            let set = format!("{name}={}", 1.2 * value);
            let (code, _, errors) = slideline(&folder, &["check", kind, "--set", &set]);
            assert_eq!(code, Some(0), "{kind} {set}: {errors}");
        }
    }
    // whole numbers in a ratio
    let whole = ["--set", "round=3", "--set", "bead=1", "--set", "wall=3"];
    let (code, _, errors) = slideline(&folder, &[&["check", "annular"][..], &whole].concat());
    assert_eq!(code, Some(0), "{errors}");
}

/// Requirement: parameters do what they say. An arm of half the length is stiffer: by the beam
/// formula its force grows with the cube of the length; the leaf of a battery spring is stiffer with
/// the cube of its thickness, softened by its large motion.
#[test]
fn parameters_change_what_they_should() {
    let folder = folder("change");
    let largest = |job: &str, set: &str| {
        let (code, _, errors) = slideline(&folder, &["run", job, "--no-html", "--set", set]);
        assert_eq!(code, Some(0), "{errors}");
        let column = if job == "snap-fit" { "RF1" } else { "RF2" };
        let [low, high] = extremes(&folder, job, "100", column);
        high.max(-low)
    };
    slideline(&folder, &["new", "snap-fit"]);
    let ratio = largest("snap-fit", "length=40") / largest("snap-fit", "length=50");
    assert!((ratio / 1.25_f64.powi(3) - 1.0).abs() < 0.05, "{ratio}");
    slideline(&folder, &["new", "battery-spring"]);
    let ratio = largest("battery-spring", "thickness=0.25") / largest("battery-spring", "mu=0.2");
    assert!((ratio / 1.25_f64.powi(3) - 1.0).abs() < 0.05, "{ratio}");
}

/// Requirement: without a kind all are listed; a kind that is not one names the nearest; a file that
/// is there is kept.
#[test]
fn kinds_are_listed_and_files_kept() {
    let folder = folder("kept");
    let (code, said, _) = slideline(&folder, &["new"]);
    assert!(code == Some(0) && KINDS.iter().all(|kind| said.contains(kind)), "{said}");
    let (code, _, errors) = slideline(&folder, &["new", "snapfit"]);
    assert!(code == Some(64) && errors.contains("'snap-fit'"), "{errors}");
    let written = || std::fs::read_to_string(folder.join("mine.inp")).unwrap();
    slideline(&folder, &["new", "cam", "-o", "mine.inp"]);
    let before = written();
    let (code, _, errors) = slideline(&folder, &["new", "annular", "-o", "mine.inp"]);
    assert!(code == Some(1) && errors.contains("error[SL0719]"), "{errors}");
    assert_eq!(written(), before);
    let (code, _, errors) = slideline(&folder, &["new", "cam", "-o", "nowhere/cam.inp"]);
    assert!(code == Some(4) && errors.contains("error[SL0702]"), "{errors}");
}
