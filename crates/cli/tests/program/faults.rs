//! Disks that fail at any call, and processes that end at any call.
//!
//! Requirement: whatever happens to a file, what was committed is there, whole,
//! and the job goes on from it to the files of a run that was left alone.
//! Source: docs/restart.md, "After a bad end". A small library stands between
//! the program and the C library and lets the n-th call that changes a result
//! file go wrong, for every n. Files are compared byte for byte.

#![cfg(target_os = "linux")] // the way to stand in between is that of its loader
#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::jobs::{PROGRAM, WRITE, code, columns, files, folder, irs, same, slideline, stderr};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::OnceLock;

/// The library; it is made with the C compiler that building needs anyway.
fn faults() -> &'static Path {
    static MADE: OnceLock<PathBuf> = OnceLock::new();
    MADE.get_or_init(|| {
        let library = folder("library").join("libfaults.so");
        let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/faults/faults.c");
        let compiler = std::env::var("CC").unwrap_or_else(|_| "cc".to_owned());
        let made = Command::new(&compiler)
            .args(["-shared", "-fPIC", "-O1", "-o"])
            .args([&library, &source])
            .args(["-ldl"])
            .output();
        let made = made.unwrap_or_else(|why| panic!("{compiler}: {why}; a C compiler is needed"));
        assert!(made.status.success(), "{}", stderr(&made));
        library
    })
}

fn faulty(folder: &Path, arguments: &[&str], kind: &str, at: usize) -> Output {
    Command::new(PROGRAM)
        .args(arguments)
        .current_dir(folder)
        .env("LD_PRELOAD", faults())
        .envs([("FAULT_NAME", "job"), ("FAULT_KIND", kind), ("FAULT_AT", &at.to_string())])
        .stdin(Stdio::null())
        .output()
        .unwrap()
}

const BEGIN: [&str; 4] = ["run", "job", "--quiet", "--no-html"];
const GO_ON: [&str; 5] = ["run", "job", "--restart", "--quiet", "--no-html"];

/// A folder with the deck and the files that a run leaves.
fn whole(name: &str) -> (PathBuf, BTreeMap<String, Vec<u8>>) {
    let folder = folder(name);
    std::fs::write(folder.join("job.inp"), columns(2, WRITE, &irs())).unwrap();
    assert_eq!(code(&slideline(&folder, &BEGIN)), 0);
    let files = files(&folder, "job");
    (folder, files)
}

fn clear(folder: &Path) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.file_name().unwrap() != "job.inp" {
            std::fs::remove_file(path).unwrap();
        }
    }
}

/// Files that grow are a beginning of what a whole run writes; files that are
/// written whole are those of the whole run, or of an earlier moment of it.
fn is_whole(files: &BTreeMap<String, Vec<u8>>, expected: &BTreeMap<String, Vec<u8>>, case: &str) {
    for (name, content) in files {
        if name.ends_with(".csv") || name.ends_with(".sta") {
            let begins = expected[name].starts_with(content);
            assert!(begins && (content.is_empty() || content.ends_with(b"\n")), "{case}: {name}");
        } else if name.ends_with(".vtu") {
            assert!(*content == expected[name], "{case}: {name}");
        } else if name.ends_with(".pvd") {
            assert!(content.ends_with(b"</VTKFile>\n"), "{case}: {name}");
        }
    }
}

/// Goes on, or begins where no state was saved yet.
fn finish(folder: &Path, expected: &BTreeMap<String, Vec<u8>>, case: &str) {
    let saved = folder.join("job.rst").exists();
    let output = slideline(folder, if saved { &GO_ON[..] } else { &BEGIN });
    assert_eq!(code(&output), 0, "{case}: {}", stderr(&output));
    same(expected, &files(folder, "job"), case);
}

/// Lets every call of a run go wrong in turn; returns how many there are.
fn every_call(kind: &str) -> usize {
    let (folder, expected) = whole(kind);
    let mut at = 0;
    loop {
        at += 1;
        clear(&folder);
        let case = format!("{kind} at call {at}");
        let output = faulty(&folder, &BEGIN, kind, at);
        let said = stderr(&output);
        if output.status.success() && files(&folder, "job") == expected {
            return at - 1;
        }
        assert!(at < 5000, "{case}: no end");
        if kind == "kill" {
            assert_eq!(output.status.code(), None, "{case}: {said}");
        } else {
            assert_eq!(code(&output), 4, "{case}: {said}");
            let names_file = said.contains("job");
            let why = ["No space left", "Permission denied", "Input/output error"];
            let has_reason = why.iter().any(|reason| said.contains(reason));
            assert!(said.contains("error[SL0702]") && names_file && has_reason, "{case}: {said}");
            assert!(said.contains("--restart") || !folder.join("job.rst").exists(), "{said}");
            is_whole(&files(&folder, "job"), &expected, &case);
        }
        finish(&folder, &expected, &case);
    }
}

#[test]
fn a_disk_that_is_full_from_any_call_on() {
    assert!(every_call("full") > 50);
}

#[test]
fn a_call_that_fails_once() {
    assert!(every_call("once") > 100);
}

#[test]
fn a_folder_that_is_read_only_from_any_call_on() {
    assert!(every_call("read-only") > 20);
}

#[test]
fn a_kill_at_any_call() {
    assert!(every_call("kill") > 100);
}

/// Requirement: going on may end badly as well, at any call, and be gone on
/// with.
#[test]
fn going_on_may_end_badly_too() {
    let (folder, expected) = whole("going_on");
    for kind in ["full", "read-only", "once", "kill"] {
        clear(&folder);
        let output = faulty(&folder, &BEGIN, "kill", 70);
        assert_eq!(output.status.code(), None);
        assert!(folder.join("job.rst").exists());
        let left: BTreeMap<PathBuf, Vec<u8>> = std::fs::read_dir(&folder)
            .unwrap()
            .map(|entry| entry.unwrap().path())
            .map(|path| (path.clone(), std::fs::read(path).unwrap()))
            .collect();
        for at in 1.. {
            clear(&folder);
            left.iter().for_each(|(path, content)| std::fs::write(path, content).unwrap());
            let case = format!("going on, {kind} at call {at}");
            let output = faulty(&folder, &GO_ON, kind, at);
            if output.status.success() && files(&folder, "job") == expected {
                break;
            }
            assert!(at < 5000, "{case}: no end");
            let ended = output.status.code();
            assert_eq!(ended, (kind != "kill").then_some(4), "{case}: {}", stderr(&output));
            finish(&folder, &expected, &case);
        }
    }
}

/// A limit of the system itself on the size of files, with the signal that
/// comes with it ignored by whoever starts the program, or not.
#[test]
fn a_limit_on_the_size_of_files() {
    let (folder, expected) = whole("limit");
    let mut stopped = 0;
    for (ignored, blocks) in ["trap '' XFSZ; ", ""]
        .into_iter()
        .flat_map(|trap| [1, 2, 4, 8, 12, 16, 24, 40].map(|b| (trap, b)))
    {
        clear(&folder);
        let case = format!("{ignored}at most {blocks} blocks");
        let output = Command::new("sh")
            .args(["-c", &format!("{ignored}ulimit -f {blocks}; exec \"$0\" \"$@\"")])
            .arg(PROGRAM)
            .args(BEGIN)
            .current_dir(&folder)
            .output()
            .unwrap();
        if output.status.success() {
            continue;
        }
        stopped += 1;
        assert_eq!(code(&output), 4, "{case}: {}", stderr(&output));
        let said = stderr(&output);
        assert!(said.contains("SL0702") && said.contains("File too large"), "{case}: {said}");
        is_whole(&files(&folder, "job"), &expected, &case);
        finish(&folder, &expected, &case);
    }
    assert!(stopped >= 12, "{stopped}");
}

/// Waits until something has come to pass, a minute at most.
fn within_a_minute(what: &str, mut passed: impl FnMut() -> bool) {
    let begun = std::time::Instant::now();
    while !passed() {
        assert!(begun.elapsed().as_secs() < 60, "waited a minute for {what}");
        std::thread::yield_now();
    }
}

/// A folder that is moved away in the middle of a run and put back, and one
/// that is removed.
#[test]
fn a_folder_that_vanishes() {
    let base = folder("vanishing");
    let deck = columns(700, WRITE, &irs());
    std::fs::write(base.join("job.inp"), &deck).unwrap();
    let run = [&BEGIN[..], &["--out", "out"]].concat();
    assert_eq!(code(&slideline(&base, &run)), 0);
    let expected = files(&base.join("out"), "job");
    for moved in [true, false] {
        std::fs::remove_dir_all(base.join("out")).unwrap();
        let child = Command::new(PROGRAM)
            .args(&run)
            .current_dir(&base)
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut child = child;
        within_a_minute("the twentieth state", || {
            let ended = child.try_wait().unwrap();
            assert!(ended.is_none(), "it ended before its folder vanished: {ended:?}");
            base.join("out/job_0020.vtu").exists()
        });
        if moved {
            std::fs::rename(base.join("out"), base.join("away")).unwrap();
        } else {
            // new files appear while it is emptied
            within_a_minute("an empty folder", || {
                std::fs::remove_dir_all(base.join("out")).is_ok()
            });
        }
        within_a_minute("its end", || child.try_wait().unwrap().is_some());
        let output = child.wait_with_output().unwrap();
        let said = stderr(&output);
        assert_eq!(code(&output), 4, "{said}");
        assert!(said.contains("error[SL0702]") && said.contains("No such file"), "{said}");
        assert!(said.contains("out"), "{said}");
        let again = [&GO_ON[..], &["--out", "out"]].concat();
        if moved {
            std::fs::rename(base.join("away"), base.join("out")).unwrap();
            let output = slideline(&base, &again);
            assert_eq!(code(&output), 0, "{}", stderr(&output));
            same(&expected, &files(&base.join("out"), "job"), "moved away and back");
        } else {
            let output = slideline(&base, &again);
            assert_eq!(code(&output), 1, "{}", stderr(&output));
            assert!(stderr(&output).contains("SL0707"), "{}", stderr(&output));
        }
    }
}
