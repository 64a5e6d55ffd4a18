//! Paths that are no files, and decks of rubbish.
//!
//! Requirement: the program never waits for what does not come, and says what is wrong. Source:
//! docs/robustness.md.

#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::jobs::{PROGRAM, WRITE, code, columns, folder, irs, slideline, stderr};
use std::path::Path;
use std::process::{Command, Output};
use std::time::{Duration, Instant};

/// Runs the program; one that waits for more than a minute hangs.
fn ends(folder: &Path, arguments: &[&str]) -> Output {
    let mut child = Command::new(PROGRAM)
        .args(arguments)
        .current_dir(folder)
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    let began = Instant::now();
    while child.try_wait().unwrap().is_none() {
        if began.elapsed() > Duration::from_secs(60) {
            child.kill().unwrap();
            panic!("{arguments:?} waits for a pipe");
        }
        std::thread::sleep(Duration::from_millis(10));
    }
    child.wait_with_output().unwrap()
}

fn pipe(path: &Path) {
    assert!(Command::new("mkfifo").arg(path).status().unwrap().success());
}

/// Requirement: a pipe, a device or a folder is refused as deck, included file, earlier job, saved
/// state and result file; nothing is waited for.
#[test]
fn what_is_no_file_is_refused() {
    let folder = folder("no-files");
    pipe(&folder.join("pipe.inp"));
    std::fs::create_dir(folder.join("folder.inp")).unwrap();
    for deck in ["pipe.inp", "pipe", "folder.inp", "/dev/null", "/dev/zero"] {
        for command in ["run", "check"] {
            let output = ends(&folder, &[command, deck]);
            assert_eq!(code(&output), 1, "{deck}");
            assert!(stderr(&output).contains("SL0701"), "{deck}: {}", stderr(&output));
        }
    }
    std::fs::write(folder.join("includes.inp"), "*INCLUDE, INPUT=pipe.inp\n").unwrap();
    let output = ends(&folder, &["check", "includes.inp"]);
    assert!(code(&output) == 1 && stderr(&output).contains("SL0120"), "{}", stderr(&output));

    std::fs::write(folder.join("job.inp"), columns(2, WRITE, &irs())).unwrap();
    std::fs::write(folder.join("next.inp"), "*RESTART, READ\n*STEP\n*STATIC\n*END STEP\n").unwrap();
    pipe(&folder.join("job.rst"));
    let output = ends(&folder, &["run", "job", "--restart"]);
    assert!(code(&output) == 1 && stderr(&output).contains("SL07"), "{}", stderr(&output));
    let output = ends(&folder, &["run", "next", "--oldjob", "job"]);
    assert!(code(&output) == 1 && stderr(&output).contains("SL07"), "{}", stderr(&output));
    for name in ["job.json", "other.history.csv"] {
        pipe(&folder.join(name));
    }
    assert_eq!(code(&ends(&folder, &["report", "job"])), 1);
}

/// Requirement: a deck of comments is no deck, whatever bytes they have.
#[test]
fn a_deck_of_comments_is_an_input_error() {
    let folder = folder("comments");
    for (name, bytes) in [("odd.inp", &b"** \xe9\n"[..]), ("plain.inp", b"** e\n")] {
        std::fs::write(folder.join(name), bytes).unwrap();
        for command in ["run", "check"] {
            let output = slideline(&folder, &[command, name]);
            assert_eq!(code(&output), 1, "{name}");
            assert!(stderr(&output).contains("SL0101"), "{}", stderr(&output));
        }
    }
}

/// Requirement: rubbish of any length is told in few words. Its time is measured in
/// docs/benchmarks.md.
#[test]
fn unknown_keywords_are_told_in_few_words() {
    let folder = folder("rubbish");
    let deck: String = (0..200_000).map(|k| format!("*KEYWRD{k}\n{k}, {k}.\n")).collect();
    std::fs::write(folder.join("rubbish.inp"), deck).unwrap();
    let output = slideline(&folder, &["check", "rubbish.inp"]);
    assert_eq!(code(&output), 1);
    assert!(stderr(&output).matches("SL0201").count() <= 52, "{}", stderr(&output));
    assert!(stderr(&output).contains("199950 more of SL0201"), "{}", stderr(&output));
}
