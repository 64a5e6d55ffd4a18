//! Every command that the documentation shows runs, and the site is made.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use std::path::{Path, PathBuf};
use std::process::Command;

const PROGRAM: &str = env!("CARGO_BIN_EXE_slideline");

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap()
}

/// An empty folder of that name.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

fn copy(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).unwrap();
    for entry in std::fs::read_dir(from).unwrap() {
        let path = entry.unwrap().path();
        let target = to.join(path.file_name().unwrap());
        if path.is_dir() {
            copy(&path, &target);
        } else {
            std::fs::copy(&path, &target).unwrap();
        }
    }
}

/// Pages of the repository that people read.
fn pages() -> Vec<PathBuf> {
    let mut pages = vec![root().join("README.md")];
    for folder in ["docs", "docs/guide", "docs/keywords", "docs/errors"] {
        let entries = std::fs::read_dir(root().join(folder)).unwrap();
        let paths = entries.map(|entry| entry.unwrap().path());
        pages.extend(paths.filter(|path| path.extension().is_some_and(|ending| ending == "md")));
    }
    pages.sort();
    pages
}

/// Lines of the blocks marked as commands.
fn commands(text: &str) -> Vec<String> {
    let blocks = text.split("\n```sh\n").skip(1);
    let lines = blocks.flat_map(|block| block.split("\n```").next().unwrap_or_default().lines());
    lines.map(str::trim).filter(|line| !line.is_empty()).map(str::to_owned).collect()
}

/// Words of a command; quotation marks keep blanks together.
fn words(line: &str) -> Vec<String> {
    let mut words = Vec::new();
    for (place, part) in line.split('"').enumerate() {
        if place % 2 == 1 {
            words.push(part.to_owned());
        } else {
            words.extend(part.split_whitespace().map(str::to_owned));
        }
    }
    words
}

/// Requirement: every command shown ends with exit code 0, page by page in
/// the order of the page, in a folder that has the corpus. Commands of cargo
/// that build the program stand for this build of it.
#[test]
fn every_command_shown_runs() {
    let mut count = 0;
    for page in pages() {
        let commands = commands(&std::fs::read_to_string(&page).unwrap());
        if commands.is_empty() {
            continue;
        }
        let name = page.file_stem().unwrap().to_str().unwrap();
        let place = folder(&format!("commands_{name}"));
        copy(&root().join("corpus"), &place.join("corpus"));
        for line in commands {
            let line = line.replace("cargo run --release -- ", "slideline ");
            if line == "cargo install --path crates/cli" {
                assert!(root().join("crates/cli/Cargo.toml").exists());
                continue;
            }
            if let Some((_, example)) = line.split_once("-p slideline --example ") {
                let path = format!("crates/slideline/examples/{example}.rs");
                assert!(root().join(path).exists(), "{line}"); // cargo test builds it
                continue;
            }
            if line.starts_with("cargo test ") {
                continue; // that is what runs here
            }
            let words = words(&line);
            assert_eq!(words[0], "slideline", "{}: {line}", page.display());
            let output = Command::new(PROGRAM).args(&words[1..]).current_dir(&place).output();
            let output = output.unwrap();
            let said = String::from_utf8_lossy(&output.stderr).into_owned();
            assert!(output.status.success(), "{}: {line}\n{said}", page.display());
            count += 1;
        }
    }
    assert!(count >= 15, "only {count} commands");
}

/// Requirement: one command makes the site; it has a page for each keyword
/// and code and loads nothing from elsewhere.
#[test]
fn one_command_makes_the_site() {
    let place = folder("site");
    let output = Command::new(PROGRAM).args(["docs", "--out", "site"]).current_dir(&place).output();
    assert!(output.unwrap().status.success());
    let site = place.join("site");
    for name in ["index", "snap-fit", "theory", "keywords/FRICTION", "errors/SL0304"] {
        let text = std::fs::read_to_string(site.join(format!("{name}.html"))).unwrap();
        assert!(!text.contains("<script") && !text.contains("src=\"http"), "{name}");
    }
}

/// Requirement: the forces of the snap-fit are those its page states, and
/// within 10 % of the designers' rule (Bayer) at the ends of the ramps.
/// Source: verification table, snap-fit rule, gate 5-15 %: the rule leaves out
/// what the force along the arm does to its stiffness.
#[test]
fn the_snap_fit_is_near_the_rule() {
    let place = folder("snap_fit");
    let deck = root().join("corpus/tutorial/snap_fit.inp");
    let mut run = Command::new(PROGRAM);
    run.arg("run").arg(deck).args(["--quiet", "--out", "."]).current_dir(&place);
    assert!(run.output().unwrap().status.success());
    let text = std::fs::read_to_string(place.join("snap_fit.history.csv")).unwrap();
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().unwrap().split(',').collect();
    let column = |name: &str| header.iter().position(|own| *own == name).unwrap();
    let (step, node, force) = (column("step"), column("node"), column("RF1"));
    let mut peaks = [0.0_f64; 2];
    for line in lines {
        let cells: Vec<&str> = line.split(',').collect();
        if cells[node] == "100" {
            let way: usize = cells[step].parse().unwrap();
            // Against the motion: to the left on the way in, to the right on the way out.
            let driven = cells[force].parse::<f64>().unwrap() * if way == 1 { -1.0 } else { 1.0 };
            peaks[way - 1] = peaks[way - 1].max(driven);
        }
    }
    let deflection = |y: f64| 6900.0 * 25.0 * (1.5_f64 / 50.0).powi(3) * y / 4.0;
    let rule = |y: f64, ramp: f64| {
        let slope = ramp.to_radians().tan();
        deflection(y) * (0.3 + slope) / (1.0 - 0.3 * slope)
    };
    let rules = [rule(1.973_205, 30.0), rule(1.941_421, 45.0)];
    let page = std::fs::read_to_string(root().join("docs/guide/snap-fit.md")).unwrap();
    for (peak, rule) in peaks.into_iter().zip(rules) {
        assert!((peak / rule - 1.0).abs() < 0.10, "{peak} against {rule}");
        assert!(page.contains(&format!("| {rule:.3} N | {peak:.3} N |")), "{rule:.3} {peak:.3}");
    }
}
