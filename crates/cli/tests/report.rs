//! `slideline report` and `slideline plot`: from files alone, and what they
//! say about files that are none.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const DECK: &str =
    concat!(env!("CARGO_MANIFEST_DIR"), "/../../corpus/diehl1995/isl_coarse_push_pull_mu03.inp");

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("report").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

fn slideline(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_slideline"))
        .args(arguments)
        .current_dir(folder)
        .output()
        .unwrap()
}

fn code(output: &Output) -> i32 {
    output.status.code().unwrap_or_else(|| panic!("{output:?}"))
}

fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn stdout(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// A folder with the results of the push-pull deck and a copy of the deck.
fn job(name: &str) -> PathBuf {
    let folder = folder(name);
    std::fs::copy(DECK, folder.join("job.inp")).unwrap();
    let output = slideline(&folder, &["run", "job", "--quiet"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    folder
}

fn read(folder: &Path, name: &str) -> String {
    std::fs::read_to_string(folder.join(name)).unwrap()
}

#[test]
fn a_run_ends_with_a_report_that_the_files_alone_give_again() {
    let folder = job("again");
    let first = read(&folder, "job.html");
    assert!(first.len() <= 1_500_000, "{} bytes", first.len());
    for asked in ["job", "job.json", "job.inp"] {
        std::fs::remove_file(folder.join("job.html")).unwrap();
        let output = slideline(&folder, &["report", asked]);
        assert_eq!(code(&output), 0, "{}", stderr(&output));
        assert_eq!(read(&folder, "job.html"), first);
        let said = stdout(&output);
        for part in ["Completed: 40 increments", "Self-locking", "retention force", "job.html"] {
            assert!(said.contains(part), "{part}: {said}");
        }
    }
    assert!(!first.contains("src=") && !first.contains("http-equiv=\"refresh"), "it is alone");
    let output = slideline(&folder, &["run", "job", "--quiet", "--no-html"]);
    assert_eq!(code(&output), 0);
    assert!(!folder.join("job.html").exists(), "--no-html leaves none, not even an old one");
}

/// Requirement: issue text, "a clear message, nothing overwritten".
#[test]
fn files_that_are_missing_truncated_or_foreign_are_named_and_nothing_is_written() {
    let folder = job("bad-files");
    std::fs::write(folder.join("job.html"), "kept").unwrap();
    let half = |name: &str| {
        let text = std::fs::read(folder.join(name)).unwrap();
        text[..text.len() / 2].to_vec()
    };
    let cases: Vec<(&str, Option<Vec<u8>>)> = vec![
        ("job.json", None),
        ("job.json", Some(half("job.json"))),
        ("job.json", Some(b"{\"schema\":99,\"status\":\"completed\"}".to_vec())),
        ("job.json", Some(b"[1, 2]".to_vec())),
        ("job.history.csv", Some(half("job.history.csv"))),
        ("job.history.csv", Some(b"a,b\n1,2\n".to_vec())),
        ("job.contact.csv", Some(half("job.contact.csv"))),
        ("job.contact.csv", Some(vec![0xff, 0xfe, 0, 1])),
        ("job.energy.csv", None),
        ("job.energy.csv", Some(half("job.energy.csv"))),
        ("job_0007.vtu", None),
        ("job_0007.vtu", Some(half("job_0007.vtu"))),
        ("job_0000.vtu", Some(b"<?xml version=\"1.0\"?><VTKFile/>".to_vec())),
        ("job.dat", None),
        ("job.msg", None),
    ];
    for (name, content) in cases {
        let path = folder.join(name);
        let good = std::fs::read(&path).unwrap();
        match &content {
            Some(content) => std::fs::write(&path, content).unwrap(),
            None => std::fs::remove_file(&path).unwrap(),
        }
        let output = slideline(&folder, &["report", "job"]);
        assert_eq!(code(&output), 1, "{name}: {}", stderr(&output));
        let said = stderr(&output);
        assert!(said.contains("SL0704") && said.contains(name), "{name}: {said}");
        assert_eq!(read(&folder, "job.html"), "kept", "{name}");
        assert!(!folder.join("job.html.part").exists());
        std::fs::write(&path, good).unwrap();
    }
    assert_eq!(code(&slideline(&folder, &["report", "job"])), 0);
    assert_eq!(code(&slideline(&folder, &["report", "nothing"])), 1);
}

#[test]
fn a_job_that_runs_is_refused_unless_asked_for() {
    let folder = job("running");
    let json = read(&folder, "job.json").replace("\"completed\"", "\"running\"");
    std::fs::write(folder.join("job.json"), json).unwrap();
    // a process that was killed left a row without its end
    let history = read(&folder, "job.history.csv");
    std::fs::write(folder.join("job.history.csv"), &history[..history.len() - 9]).unwrap();
    let energy = read(&folder, "job.energy.csv");
    let whole = energy.trim_end().rfind('\n').unwrap() + 4;
    std::fs::write(folder.join("job.energy.csv"), &energy[..whole]).unwrap();
    std::fs::write(folder.join("job.html"), "kept").unwrap();
    let output = slideline(&folder, &["report", "job"]);
    assert_eq!(code(&output), 1);
    assert!(stderr(&output).contains("SL0705"), "{}", stderr(&output));
    assert_eq!(read(&folder, "job.html"), "kept");
    let output = slideline(&folder, &["report", "job", "--unfinished"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let said = stdout(&output);
    assert!(said.contains("Not finished") && said.contains("39 increments"), "{said}");
}

#[test]
fn a_deck_that_was_changed_is_told() {
    let folder = job("changed");
    let deck = read(&folder, "job.inp");
    std::fs::write(folder.join("job.inp"), deck.replace("0.3", "0.2")).unwrap();
    let output = slideline(&folder, &["report", "job"]);
    assert_eq!(code(&output), 0);
    assert!(stderr(&output).contains("SL0706"), "{}", stderr(&output));
    assert!(read(&folder, "job.html").contains("The deck was changed after this run"));
}

#[test]
fn a_report_that_cannot_be_written_is_exit_4() {
    let folder = job("unwritable");
    std::fs::remove_file(folder.join("job.html")).unwrap();
    std::fs::create_dir(folder.join("job.html")).unwrap();
    let output = slideline(&folder, &["report", "job"]);
    assert_eq!(code(&output), 4, "{}", stderr(&output));
    assert!(stderr(&output).contains("SL0702"), "{}", stderr(&output));
}

#[test]
fn an_overlay_must_be_a_curve() {
    let folder = job("overlay");
    std::fs::write(folder.join("theory.csv"), "increment,time,RF2,U2\n0,0,0,0\n1,1,-9,-0.03\n")
        .unwrap();
    assert_eq!(code(&slideline(&folder, &["report", "job", "--overlay", "theory.csv"])), 0);
    assert!(read(&folder, "job.html").contains("\"name\":\"theory.csv\""));
    for wrong in ["a,b\n1,2\n", "U2,RF2\n", "U2,RF2\n1,2", ""] {
        std::fs::write(folder.join("wrong.csv"), wrong).unwrap();
        let output = slideline(&folder, &["report", "job", "--overlay", "wrong.csv"]);
        assert_eq!(code(&output), 1, "{wrong:?}: {}", stderr(&output));
        assert!(stderr(&output).contains("wrong.csv"), "{}", stderr(&output));
    }
}

#[test]
fn plots_are_numbers_svg_or_png() {
    let folder = job("plot");
    let ask = ["plot", "job", "--x", "U2", "--y", "RF2"];
    let with = |more: &[&str]| slideline(&folder, &[&ask[..], more].concat());
    let table = stdout(&with(&["--node", "9999"]));
    let mut lines = table.lines();
    assert_eq!(lines.next(), Some("time,U2,RF2"));
    assert_eq!(lines.next(), Some("0,0,0"));
    let last = read(&folder, "job.history.csv").lines().last().unwrap().to_owned();
    let cells: Vec<&str> = last.split(',').collect();
    assert_eq!(lines.last().unwrap(), format!("{},{},{}", cells[2], cells[5], cells[8]));
    assert_eq!(stdout(&with(&[])), table, "the only driven node need not be named");

    for (name, begin) in [("f.svg", &b"<svg "[..]), ("f.png", &b"\x89PNG"[..]), ("f.csv", b"time,")]
    {
        let output = with(&["-o", name, "--compare", "job"]);
        assert_eq!(code(&output), 0, "{}", stderr(&output));
        assert!(stdout(&output).contains("largest difference 0e0"), "{}", stdout(&output));
        assert!(std::fs::read(folder.join(name)).unwrap().starts_with(begin), "{name}");
    }
    assert_eq!(code(&with(&["--node", "1"])), 1);
    assert_eq!(code(&slideline(&folder, &["plot", "job", "--x", "U2", "--y", "RF7"])), 1);
    assert_eq!(code(&with(&["-o", "f.pdf"])), 64);
    assert_eq!(code(&with(&["-o", "no/such/folder/f.svg"])), 4);
}
