//! Saved states that were made to harm.
//!
//! Requirement: whatever `JOB.rst` holds, going on from it ends in a status,
//! never in a panic or in memory that the file has not got. The checksum is
//! made right again after every change, so that the content itself is read.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::{Job, Quiet, Read, ReadOptions, RunOptions, Status, run};
use std::path::{Path, PathBuf};

const DECK: &str = "*RESTART, WRITE
*NODE
1, 0.0, 0.1
2, 0.0, 0.0
3, 0.01, 0.1
4, 0.01, 0.0
9, 0.0, 0.0
*ELEMENT, TYPE=B21, ELSET=BEAMS
1, 1, 2
2, 3, 4
*BEAM SECTION, SECTION=RECT, ELSET=BEAMS, MATERIAL=M
0.01, 0.01
*MATERIAL, NAME=M
*ELASTIC
1.0E9, 0.3
*RIGID SURFACE, TYPE=SEGMENTS, ELSET=TIPS
START, -1.0, -1.0E-4
LINE, 1.0, -1.0E-4
*ELEMENT, TYPE=IRS21, ELSET=TIPS
11, 2, 4, 9
*INTERFACE, ELSET=TIPS
0.025
*FRICTION
0.3
*SURFACE CONTACT, SOFTENED
1.0E-5, 4.8E6
*STEP, NLGEOM
*STATIC
0.25, 1.0
*BOUNDARY
1, 1, 6
3, 1, 6
9, 1, 1, 1.0E-3
9, 2, 2, 1.2E-4
9, 6, 6
*END STEP
";

/// Bytes before the content: name, format, length, checksum.
const HEAD: usize = 14 + 8 + 8 + 8;

fn job() -> Read {
    Job::read_text("job", DECK, &ReadOptions::default())
}

/// A folder with the files of a run that was left after two increments.
fn left(name: &str) -> (PathBuf, Vec<u8>) {
    use slideline::observe::{Event, Observer, Stop};
    struct Two;
    impl Observer for Two {
        fn event(&mut self, event: Event<'_>) -> std::ops::ControlFlow<Stop> {
            match event {
                Event::Committed(frame) if frame.increment == 2 => {
                    std::ops::ControlFlow::Break(Stop::Interrupted)
                }
                _ => std::ops::ControlFlow::Continue(()),
            }
        }
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    let options = RunOptions { folder: Some(folder.clone()), ..RunOptions::default() };
    assert_eq!(run(&job(), &options, &mut Two).status, Status::Interrupted);
    let state = std::fs::read(folder.join("job.rst")).unwrap();
    (folder, state)
}

/// FNV-1a, 64 bits, written again.
fn checksum(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash: u64, &byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3)
    })
}

fn sealed(mut file: Vec<u8>) -> Vec<u8> {
    let length = (file.len() - HEAD) as u64;
    file[22..30].copy_from_slice(&length.to_le_bytes());
    let sum = checksum(&file[HEAD..]);
    file[30..38].copy_from_slice(&sum.to_le_bytes());
    file
}

#[test]
fn no_content_makes_it_panic() {
    let (folder, state) = left("hostile");
    assert_eq!(sealed(state.clone()), state, "the layout of the head");
    let options =
        RunOptions { folder: Some(folder.clone()), restart: true, ..RunOptions::default() };
    let mut refused = 0;
    for place in (HEAD..state.len()).step_by(3) {
        for value in [0x00, 0x7f, 0xff] {
            let mut file = state.clone();
            file[place] = value;
            let end = (place + 8).min(file.len());
            if place % 2 == 0 {
                file[place..end].fill(value);
            }
            if slideline::output::restart::unpack(&sealed(file.clone())).is_err() {
                refused += 1;
                continue;
            }
            std::fs::write(folder.join("job.rst"), sealed(file)).unwrap();
            if place % 13 == 0 {
                let outcome = run(&job(), &options, &mut Quiet);
                assert_ne!(outcome.status, Status::InternalError, "{place} {value}");
            }
        }
    }
    assert!(refused > 0);
    for length in HEAD..state.len() {
        let cut = sealed(state[..length].to_vec());
        assert!(slideline::output::restart::unpack(&cut).is_err(), "{length}");
    }
}

#[test]
fn what_was_left_is_finished() {
    let (folder, _) = left("finished");
    let whole = Path::new(env!("CARGO_TARGET_TMPDIR")).join("finished_whole");
    let options = RunOptions { folder: Some(whole.clone()), ..RunOptions::default() };
    assert_eq!(run(&job(), &options, &mut Quiet).status, Status::Completed);
    let options =
        RunOptions { folder: Some(folder.clone()), restart: true, ..RunOptions::default() };
    let outcome = run(&job(), &options, &mut Quiet);
    assert_eq!(outcome.status, Status::Completed, "{:?}", outcome.diagnostics);
    assert_eq!(outcome.totals.increments, 4);
    for name in [
        "job.history.csv",
        "job.contact.csv",
        "job.pair.csv",
        "job.energy.csv",
        "job.msg",
        "job.pvd",
    ] {
        let of = |folder: &Path| std::fs::read(folder.join(name)).unwrap();
        assert!(of(&folder) == of(&whole), "{name}");
    }
}
