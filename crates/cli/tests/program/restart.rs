//! Going on from a saved state: whatever ended the first part, the files are
//! those of a run that was never left.
//!
//! Requirement: bit-identical continuation; no kill loses what was committed.
//! Source: docs/restart.md. Files are compared byte for byte, so there is no
//! tolerance; of `JOB.json` the wall time is left out, and `JOB.html` with it.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::jobs::{
    HEAD, PROGRAM, WRITE, code, columns, corpus, files, folder, irs, isl, same, sections,
    slideline, stderr,
};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Runs a deck whole, then with a saved state taken away in the middle, and
/// compares.
fn leave_and_go_on(name: &str, deck: &str, signal_after: &[usize]) {
    let whole = folder(&format!("{name}_whole"));
    std::fs::write(whole.join("job.inp"), deck).unwrap();
    let output = slideline(&whole, &["run", "job", "--quiet", "--no-html"]);
    assert_eq!(code(&output), 0, "{name}: {}", String::from_utf8_lossy(&output.stderr));
    let expected = files(&whole, "job");
    let lines = |folder: &Path| {
        let text = std::fs::read_to_string(folder.join("job.energy.csv")).unwrap_or_default();
        text.lines().count().saturating_sub(1)
    };
    let all = lines(&whole);
    let mut left = 0;
    for &after in signal_after {
        let part = folder(&format!("{name}_{after}"));
        std::fs::write(part.join("job.inp"), deck).unwrap();
        let mut child = Command::new(PROGRAM)
            .args(["run", "job", "--quiet", "--no-html"])
            .current_dir(&part)
            .stdout(Stdio::null())
            .spawn()
            .unwrap();
        let began = Instant::now();
        while lines(&part) < after && began.elapsed() < Duration::from_secs(20) {
            std::thread::yield_now();
        }
        let _ = child.kill();
        let _ = child.wait();
        left += usize::from(lines(&part) < all);
        if !part.join("job.rst").exists() {
            continue;
        }
        let output = slideline(&part, &["run", "job", "--restart", "--quiet", "--no-html"]);
        assert_eq!(code(&output), 0, "{name}: {}", String::from_utf8_lossy(&output.stderr));
        same(&expected, &files(&part, "job"), &format!("{name} killed after {after}"));
    }
    assert!(left > 0, "{name}: every run was faster than its kill");
}

#[test]
fn irs_with_friction_and_three_steps() {
    leave_and_go_on("irs", &columns(40, WRITE, &irs()), &[1, 30, 39, 40, 41, 77, 80, 110]);
}

#[test]
fn isl_with_friction_and_three_steps() {
    leave_and_go_on("isl", &columns(40, WRITE, &isl()), &[2, 35, 64, 81, 110]);
}

#[test]
fn states_are_saved_every_so_many_increments() {
    let deck = columns(40, "*RESTART, WRITE, FREQUENCY=7\n", &irs());
    leave_and_go_on("frequency", &deck, &[8, 50, 100]);
}

/// States thinned by requests, results for cgx, and tables that wait.
#[test]
fn thinned_states_and_frd_results_go_on() {
    let requests = "*NODE FILE, FREQUENCY=7\nU\n*EL PRINT, FREQUENCY=9\nS\n*END STEP";
    let deck = columns(40, WRITE, &irs()).replace("*END STEP", requests);
    leave_and_go_on("thinned", &deck, &[1, 8, 44, 81, 110]);
}

/// The paper's models with friction and softened contact, and integrated
/// contact along a beam.
#[test]
fn the_papers_decks_and_integrated_contact() {
    for name in ["irs_coarse", "isl_coarse"] {
        let deck = corpus(&format!("{name}.inp"))
            .replace("*FRICTION\n0.0", "*FRICTION\n0.3")
            .replace("*STEP,", "*RESTART, WRITE\n*STEP,")
            .replace("0.05, 1.0, 1.0E-6, 0.05", "0.02, 1.0, 1.0E-6, 0.02");
        leave_and_go_on(name, &deck, &[3, 20, 33]);
    }
    let surface = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../corpus/keywords/SURFACE.inp");
    let deck = std::fs::read_to_string(surface).unwrap();
    let deck = deck
        .replace("*STEP, NLGEOM", "*RESTART, WRITE\n*STEP, NLGEOM, INC=1000")
        .replace("0.1, 1.0", "0.01, 1.0, 1.0E-9, 0.01");
    leave_and_go_on("surface", &deck, &[4, 50, 80]);
}

/// What a pair missed where it carried most, after it has left what it met (docs/theory.md section 5.20).
#[test]
fn what_a_pair_missed_goes_on() {
    let ridge = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../corpus/run/SL0621-ridge.inp");
    let deck = std::fs::read_to_string(ridge).unwrap();
    let deck = deck
        .replace("*STEP, NLGEOM", "*AMPLITUDE, NAME=A\n0.0, 0.0, 0.3, 1.0, 0.6, 0.0, 1.0, 0.0\n*RESTART, WRITE\n*STEP, NLGEOM, INC=1000")
        .replace("0.02, 1.0, 1.0E-6, 0.02", "0.002, 1.0, 1.0E-6, 0.002")
        .replace("9, 2, 2, 0.06", "*BOUNDARY, AMPLITUDE=A\n9, 2, 2, 0.06\n*BOUNDARY");
    leave_and_go_on("missed", &deck, &[100, 200, 350]);
}

/// Numbers that look random, the same in every run of the test. [derived: a
/// linear congruential generator]
struct Moments(u64);

impl Moments {
    fn below(&mut self, most: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963);
        (self.0 >> 33) % most.max(1)
    }
}

fn begin(folder: &Path, go_on: bool) -> std::process::Child {
    Command::new(PROGRAM)
        .args(["run", "job", "--quiet", "--no-html"])
        .args(go_on.then_some("--restart"))
        .current_dir(folder)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap()
}

/// Requirement: 100 runs of 200 increments, each killed at a random moment of
/// its life, every third one once or twice more while it goes on, end with 100
/// times the files of a run that was left alone.
#[test]
fn a_hundred_kills_at_random_moments() {
    let deck = columns(67, WRITE, &irs());
    let whole = folder("kills_whole");
    std::fs::write(whole.join("job.inp"), &deck).unwrap();
    let began = Instant::now();
    assert!(begin(&whole, false).wait().unwrap().success());
    let lifetime = began.elapsed().as_micros() as u64;
    let expected = files(&whole, "job");
    let part = folder("kills");
    let mut moments = Moments(7);
    let (mut histories, mut kills, mut anew, mut rounds) = (0, 0, 0, 0);
    while histories < 100 {
        rounds += 1;
        assert!(rounds < 1000, "{histories} histories with {kills} kills");
        let _ = std::fs::remove_dir_all(&part);
        std::fs::create_dir_all(&part).unwrap();
        std::fs::write(part.join("job.inp"), &deck).unwrap();
        let mut killed = 0;
        for _ in 0..1 + rounds % 3 {
            let mut child = begin(&part, part.join("job.rst").exists());
            std::thread::sleep(Duration::from_micros(moments.below(lifetime)));
            let ended = child.try_wait().unwrap();
            let _ = child.kill();
            let _ = child.wait();
            match ended {
                None => killed += 1,
                Some(status) => assert_eq!(status.code(), Some(0), "after {kills} kills"),
            }
        }
        let case = format!("round {rounds}, killed {killed} times");
        let saved = part.join("job.rst").exists();
        anew += usize::from(!saved);
        let status = begin(&part, saved).wait().unwrap();
        assert_eq!(status.code(), Some(0), "{case}");
        same(&expected, &files(&part, "job"), &case);
        kills += killed;
        histories += usize::from(killed > 0);
    }
    println!("{kills} kills, {histories} histories, {anew} before the first state, {lifetime} us");
}

/// What cannot be gone on from is an input error, and nothing is touched.
#[test]
fn what_cannot_be_gone_on_from() {
    let folder = folder("refused");
    std::fs::write(folder.join("job.inp"), columns(4, WRITE, &irs())).unwrap();
    let again = |folder: &Path| slideline(folder, &["run", "job", "--restart", "--quiet"]);
    let output = again(&folder);
    assert_eq!(code(&output), 1);
    assert!(stderr(&output).contains("SL0707"), "{}", stderr(&output));

    assert_eq!(code(&slideline(&folder, &["run", "job", "--quiet"])), 0);
    let state = std::fs::read(folder.join("job.rst")).unwrap();
    let before = files(&folder, "job");
    let output = slideline(&folder, &["run", "job", "--restart"]);
    assert_eq!(code(&output), 0);
    assert!(stderr(&output).contains("SL0591"), "{}", stderr(&output));

    let mut moments = Moments(3);
    let mut damaged: Vec<Vec<u8>> = vec![Vec::new(), b"*HEADING\n".to_vec(), vec![0xff; 4096]];
    let places = sections(&state);
    let last = places[places.len() - 2];
    for _ in 0..12 {
        let length = moments.below(state.len() as u64) as usize;
        damaged.push(state[..length].to_vec());
        let mut flipped = state.clone();
        // what both marks are in, the preface or the last state: the rest is not used
        let used = [length % 22, HEAD + length % (places[1] - HEAD), length.max(last)];
        let place = used[length % 3];
        flipped[place] ^= 1 << moments.below(8);
        damaged.push(flipped);
    }
    for bytes in damaged {
        std::fs::write(folder.join("job.rst"), bytes).unwrap();
        let output = again(&folder);
        assert_eq!(code(&output), 1, "{}", stderr(&output));
        assert!(stderr(&output).contains("SL0708"), "{}", stderr(&output));
    }
    std::fs::write(folder.join("job.rst"), &state).unwrap();
    for (changed, options) in [(true, &[][..]), (false, &["--friction-onset", "delayed"][..])] {
        let comment = if changed { "** changed\n" } else { "" };
        std::fs::write(folder.join("job.inp"), columns(4, WRITE, &irs()) + comment).unwrap();
        let arguments = [&["run", "job", "--restart", "--quiet"][..], options].concat();
        let output = slideline(&folder, &arguments);
        assert_eq!(code(&output), 1);
        assert!(stderr(&output).contains("SL0709"), "{}", stderr(&output));
    }
    same(&before, &files(&folder, "job"), "refused");
    let history = std::fs::read(folder.join("job.history.csv")).unwrap();
    std::fs::write(folder.join("job.history.csv"), &history[..history.len() / 2]).unwrap();
    std::fs::remove_file(folder.join("job.json")).unwrap();
    let output = again(&folder);
    assert_eq!(code(&output), 1);
    assert!(stderr(&output).contains("SL0710"), "{}", stderr(&output));
}

/// Requirement: every signal that asks for an end lets the increment come to
/// its own, saves the state of it whatever FREQUENCY says, tells how to go on,
/// and the job goes on from it to the files of a run that was left alone.
#[cfg(unix)]
#[test]
fn signals_end_a_run_after_an_increment() {
    let deck = columns(700, "*RESTART, WRITE, FREQUENCY=100000\n", &irs());
    let whole = folder("signals_whole");
    std::fs::write(whole.join("job.inp"), &deck).unwrap();
    assert!(begin(&whole, false).wait().unwrap().success());
    let expected = files(&whole, "job");
    for signal in ["INT", "TERM", "HUP"] {
        let part = folder(&format!("signals_{signal}"));
        std::fs::write(part.join("job.inp"), &deck).unwrap();
        let child = Command::new(PROGRAM)
            .args(["run", "job", "--no-html"])
            .current_dir(&part)
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        while !part.join("job_0005.vtu").exists() {
            std::thread::yield_now();
        }
        let id = child.id().to_string();
        let sent = Command::new("kill").args([&format!("-{signal}"), &id]).status().unwrap();
        assert!(sent.success());
        let output = child.wait_with_output().unwrap();
        let said = stderr(&output);
        assert_eq!(code(&output), 130, "{signal}: {said}");
        assert!(said.contains("slideline run job.inp --restart"), "{signal}: {said}");
        let summary = std::fs::read_to_string(part.join("job.json")).unwrap();
        assert!(summary.contains("\"status\":\"interrupted\""), "{signal}: {summary}");
        let rows =
            std::fs::read_to_string(part.join("job.energy.csv")).unwrap().lines().count() - 1;
        assert!(summary.contains(&format!("\"increments\":{rows},")), "{signal}: {summary}");
        assert!((5..2100).contains(&rows), "{signal} after {rows} increments");
        assert!(begin(&part, true).wait().unwrap().success(), "{signal}");
        same(&expected, &files(&part, "job"), signal);
    }
}

/// Requirement: interrupted, a run whose states and tables are thinned gives every file its name
/// and goes on from the increment it had ended.
#[cfg(unix)]
#[test]
fn an_interrupted_run_says_how_to_go_on() {
    let deck = columns(2000, "*RESTART, WRITE, FREQUENCY=100000\n", &irs());
    let deck = deck.replace("*END STEP", "*NODE FILE, FREQUENCY=5\nU\n*END STEP");
    let part = folder("interrupted");
    std::fs::write(part.join("job.inp"), &deck).unwrap();
    let child = Command::new(PROGRAM)
        .args(["run", "job", "--no-html"])
        .current_dir(&part)
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    while !part.join("job_0005.vtu").exists() {
        std::thread::yield_now();
    }
    let id = child.id().to_string();
    assert!(Command::new("kill").args(["-INT", &id]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    assert_eq!(code(&output), 130, "{}", stderr(&output));
    assert!(stderr(&output).contains("slideline run job.inp --restart"), "{}", stderr(&output));
    let rows = |name: &str| std::fs::read_to_string(part.join(name)).unwrap().lines().count();
    let before = rows("job.energy.csv");
    // everything is written: files that wait for the end have their names
    let text = |name: &str| std::fs::read_to_string(part.join(name)).unwrap();
    assert!(text("job.frd").ends_with(" -3\n 9999\n") && text("job.dat").contains("NODES PLANE"));
    let left = std::fs::read_dir(&part).unwrap();
    let names: Vec<String> =
        left.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    assert!(!names.iter().any(|n| n.ends_with(".part") || n.ends_with(".lck")), "{names:?}");
    // interrupted at once: only what is left of one increment is solved again
    let mut child = Command::new(PROGRAM)
        .args(["run", "job", "--restart", "--quiet", "--no-html"])
        .current_dir(&part)
        .spawn()
        .unwrap();
    let began = Instant::now();
    while rows("job.energy.csv") <= before && began.elapsed() < Duration::from_secs(10) {
        std::thread::yield_now();
    }
    let _ = child.kill();
    let _ = child.wait();
    assert!(rows("job.energy.csv") > before);
}
