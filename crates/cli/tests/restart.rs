//! Going on from a saved state: whatever ended the first part, the files are
//! those of a run that was never left.
//!
//! Requirement: bit-identical continuation; no kill loses what was committed.
//! Source: docs/restart.md. Files are compared byte for byte, so there is no
//! tolerance; of `JOB.json` the wall time is left out, and `JOB.html` with it.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

mod jobs;

use jobs::{
    PROGRAM, WRITE, code, columns, corpus, files, folder, irs, isl, same, sections, slideline,
    stderr,
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

/// Numbers that look random, the same in every run of the test. [derived: a
/// linear congruential generator]
struct Moments(u64);

impl Moments {
    fn below(&mut self, most: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963);
        (self.0 >> 33) % most.max(1)
    }
}

/// Requirement: a run of 200 increments, killed at 20 random moments of its
/// life (the rest of it too), has the files of a run that was left alone.
#[test]
fn twenty_kills_at_random_moments() {
    let deck = columns(67, WRITE, &irs());
    let whole = folder("kills_whole");
    std::fs::write(whole.join("job.inp"), &deck).unwrap();
    let began = Instant::now();
    assert_eq!(code(&slideline(&whole, &["run", "job", "--quiet", "--no-html"])), 0);
    let lifetime = began.elapsed();
    let expected = files(&whole, "job");
    let part = folder("kills");
    std::fs::write(part.join("job.inp"), &deck).unwrap();
    let mut moments = Moments(7);
    let (mut kills, mut rounds) = (0, 0);
    while kills < 20 && rounds < 400 {
        rounds += 1;
        let begins_anew = !part.join("job.rst").exists();
        let mut child = Command::new(PROGRAM)
            .args(["run", "job", "--quiet", "--no-html"])
            .args((!begins_anew).then_some("--restart"))
            .current_dir(&part)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let moment = lifetime.as_micros() as u64 / 4;
        std::thread::sleep(Duration::from_micros(moments.below(moment)));
        let ended = child.try_wait().unwrap();
        let _ = child.kill();
        let _ = child.wait();
        match ended {
            None => kills += 1,
            Some(status) => {
                assert_eq!(status.code(), Some(0), "after {kills} kills");
                same(&expected, &files(&part, "job"), &format!("after {kills} kills"));
                std::fs::remove_file(part.join("job.rst")).unwrap();
            }
        }
    }
    assert!(kills >= 20, "{kills} kills in {rounds} rounds");
    if part.join("job.rst").exists() {
        let output = slideline(&part, &["run", "job", "--restart", "--quiet", "--no-html"]);
        assert_eq!(code(&output), 0);
        same(&expected, &files(&part, "job"), "after the last kill");
    }
    println!("{kills} kills in {rounds} rounds of a run of {lifetime:?}");
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
        // head, preface or the last state: the others are not used
        let place = if length < last { length % places[1] } else { length };
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

/// Ctrl-C saves the state of the last increment, whatever FREQUENCY says.
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
