//! Files of saved states that were damaged, or made to harm.
//!
//! Requirement: whatever `JOB.rst` holds, reading it ends in a state that was
//! saved or in a reason, never in a panic, a wrong number or in memory that the
//! file has not got. Source: docs/restart.md, "The file".

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::output::restart::unpack;
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

/// Bytes before the marks: name, format.
const MARKS: usize = 14 + 8;
/// Bytes of the head: two marks of valid length and checksum.
const HEAD: usize = MARKS + 2 * SECTION;
/// A length and its checksum, before every content and as a mark.
const SECTION: usize = 8 + 4;

fn job() -> Read {
    of(DECK)
}

fn of(deck: &str) -> Read {
    Job::read_text("job", deck, &ReadOptions::default())
}

fn left(name: &str) -> (PathBuf, Vec<u8>) {
    left_of(name, DECK)
}

/// A folder with the files of a run that was left after two increments.
fn left_of(name: &str, deck: &str) -> (PathBuf, Vec<u8>) {
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
    assert_eq!(run(&of(deck), &options, &mut Two).status, Status::Interrupted);
    let state = std::fs::read(folder.join("job.rst")).unwrap();
    (folder, state)
}

/// CRC-32 (IEEE), written again.
fn checksum(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0_u32, |sum, &byte| {
        (0..8).fold(sum ^ u32::from(byte), |sum, _| {
            sum >> 1 ^ if sum & 1 == 1 { 0xedb8_8320 } else { 0 }
        })
    })
}

fn word(file: &[u8], at: usize) -> usize {
    u64::from_le_bytes(*file[at..].first_chunk().unwrap()) as usize
}

/// First byte of every section, and the end of the last.
fn sections(file: &[u8]) -> Vec<usize> {
    let mut places = vec![HEAD];
    while *places.last().unwrap() < word(file, MARKS).max(word(file, MARKS + SECTION)) {
        let start = *places.last().unwrap();
        places.push(start + SECTION + word(file, start));
    }
    places
}

/// Makes both marks say that the file is valid up to that length.
fn marked(file: &mut [u8], valid: u64) {
    let valid = valid.to_le_bytes();
    let mark = [&valid[..], &checksum(&valid).to_le_bytes()].concat();
    file[MARKS..HEAD].copy_from_slice(&[&mark[..], &mark].concat());
}

/// The file with all checksums made right, each section as long as `places`
/// say.
fn sealed(mut file: Vec<u8>, places: &[usize]) -> Vec<u8> {
    let end = file.len();
    marked(&mut file, end as u64);
    for pair in places.windows(2) {
        let (start, end) = (pair[0], pair[1].min(end));
        let length = (end - start - SECTION) as u64;
        file[start..start + 8].copy_from_slice(&length.to_le_bytes());
        let bytes = [&length.to_le_bytes()[..], &file[start + SECTION..end]].concat();
        file[start + 8..start + SECTION].copy_from_slice(&checksum(&bytes).to_le_bytes());
    }
    file
}

/// Requirement: a file cut off anywhere gives a reason. (A byte more than it
/// says is no damage: it is what a kill leaves of a state that did not count
/// yet.)
#[test]
fn every_truncation_is_found() {
    let (_, file) = left("truncated");
    let whole = unpack(&file).unwrap();
    for length in 0..file.len() {
        let reason = unpack(&file[..length]).map(|_| ()).unwrap_err();
        assert!(!reason.is_empty(), "{length}");
    }
    let longer = [&file[..], &[0xff; 100]].concat();
    assert_eq!(unpack(&longer).unwrap().checkpoint, whole.checkpoint);
}

/// Requirement: every flipped bit is found, or lies in a state that is not
/// used: never another state than the one that was saved.
#[test]
fn every_flipped_bit_is_found() {
    let (_, file) = left("flipped");
    let places = sections(&file);
    let [.., last, end] = places[..] else { panic!("{places:?}") };
    assert_eq!((places.len(), end), (4, file.len()), "preface and two states");
    let whole = unpack(&file).unwrap();
    for place in 0..file.len() {
        for bit in 0..8 {
            let mut flipped = file.clone();
            flipped[place] ^= 1 << bit;
            match unpack(&flipped) {
                Err(reason) => assert!(!reason.is_empty()),
                Ok(saved) => {
                    let unused = (places[1]..last).contains(&place);
                    let other_mark = (MARKS..HEAD).contains(&place);
                    assert!(unused || other_mark, "byte {place}, bit {bit}");
                    assert_eq!(saved.checkpoint, whole.checkpoint, "byte {place}, bit {bit}");
                }
            }
        }
    }
}

/// Requirement: lengths that lie cost no memory, with right checksums too.
#[test]
fn lengths_that_lie() {
    let (_, file) = left("lengths");
    let places = sections(&file);
    for at in [MARKS, places[0], places[1], places[2]] {
        for length in [0, 1, 15, 16, 17, 1 << 32, 1 << 47, 1 << 60, u64::MAX - 15, u64::MAX] {
            let mut lying = file.clone();
            if at == MARKS {
                marked(&mut lying, length);
            } else {
                lying[at..at + 8].copy_from_slice(&length.to_le_bytes());
            }
            assert!(unpack(&lying).is_err(), "{at}: {length}");
        }
    }
    for start in (HEAD + SECTION..file.len() - 8).step_by(8) {
        for length in [1 << 40, (1 << 47) - 1, u64::MAX] {
            let mut lying = file.clone();
            lying[start..start + 8].copy_from_slice(&u64::to_le_bytes(length));
            let _ = unpack(&sealed(lying, &places)); // must come back, and soon
        }
    }
}

/// Requirement: a file of an earlier layout says that it is one.
#[test]
fn other_versions_are_told() {
    let (folder, mut file) = left("version");
    file[14] = 3;
    assert!(unpack(&file).unwrap_err().contains("another version"));
    std::fs::write(folder.join("job.rst"), file).unwrap();
    let options = RunOptions { folder: Some(folder), restart: true, ..RunOptions::default() };
    let outcome = run(&job(), &options, &mut Quiet);
    let said: Vec<&str> = outcome.diagnostics.iter().map(|said| said.code.0).collect();
    assert_eq!((outcome.status, said), (Status::InputError, vec!["SL0708"]));
}

#[test]
fn no_content_makes_it_panic() {
    let (folder, file) = left("hostile");
    let places = sections(&file);
    assert!(sealed(file.clone(), &places)[HEAD..] == file[HEAD..], "the layout");
    let options =
        RunOptions { folder: Some(folder.clone()), restart: true, ..RunOptions::default() };
    let mut refused = 0;
    for place in (HEAD + SECTION..file.len()).step_by(3) {
        if places.iter().any(|start| (*start..start + SECTION).contains(&place)) {
            continue;
        }
        for value in [0x00, 0x7f, 0xff] {
            let mut other = file.clone();
            other[place] = value;
            let end = (place + 8).min(other.len());
            if place % 2 == 0 {
                other[place..end].fill(value);
            }
            let other = sealed(other, &places);
            if unpack(&other).is_err() {
                refused += 1;
                continue;
            }
            std::fs::write(folder.join("job.rst"), other).unwrap();
            if place % 13 == 0 {
                let outcome = run(&job(), &options, &mut Quiet);
                assert_ne!(outcome.status, Status::InternalError, "{place} {value}");
            }
        }
    }
    assert!(refused > 0);
    for length in places[2] + SECTION..file.len() {
        let cut = sealed(file[..length].to_vec(), &places);
        assert!(unpack(&cut).is_err(), "{length}");
    }
}

/// Compares the files of a run that was left after two of its increments and finished with
/// those of an uninterrupted one.
fn finishes(name: &str, deck: &str, files: &[&str]) {
    let (folder, _) = left_of(name, deck);
    let whole = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}_whole"));
    let options = RunOptions { folder: Some(whole.clone()), ..RunOptions::default() };
    let uninterrupted = run(&of(deck), &options, &mut Quiet);
    assert_eq!(uninterrupted.status, Status::Completed);
    let options =
        RunOptions { folder: Some(folder.clone()), restart: true, ..RunOptions::default() };
    let outcome = run(&of(deck), &options, &mut Quiet);
    assert_eq!(outcome.status, Status::Completed, "{:?}", outcome.diagnostics);
    assert_eq!(outcome.totals.increments, uninterrupted.totals.increments);
    assert!(outcome.totals.increments > 2);
    for name in files {
        let of = |folder: &Path| std::fs::read(folder.join(name)).unwrap();
        assert!(of(&folder) == of(&whole), "{name}");
    }
}

const FILES: [&str; 4] = ["job.history.csv", "job.energy.csv", "job.msg", "job.pvd"];

#[test]
fn what_was_left_is_finished() {
    finishes("finished", DECK, &[&FILES[..], &["job.contact.csv", "job.pair.csv"]].concat());
}

/// Requirement: motions along axes of their own are remembered along these: what is said of their noise does not depend
/// on where a run was left. Tolerance: rounding of the sums along the axes.
#[test]
fn motions_along_own_axes_are_remembered() {
    let deck = DECK
        .replace("*STEP, NLGEOM", "*NSET, NSET=TOOL\n9\n*TRANSFORM, NSET=TOOL\n0.6, 0.8, 0.0, -0.8, 0.6, 0.0\n*STEP, NLGEOM")
        .replace("9, 1, 1, 1.0E-3\n9, 2, 2, 1.2E-4", "9, 1, 1, 7.0E-4\n9, 2, 2, -7.3E-4")
        .replace("0.25, 1.0", "0.1, 1.0, 0.1, 0.1");
    finishes("turned", &deck, &FILES);
    let roughness = |name: &str| {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name).join("job.json");
        let text = std::fs::read_to_string(path).unwrap();
        let noise = text.split("\"noise\"").nth(1).unwrap().to_owned();
        ["9.RF1", "9.RF2"].map(|dof| -> f64 {
            let of_dof = noise.split(&format!("\"{dof}\"")).nth(1).unwrap();
            let value = of_dof.split("\"roughness\":").nth(1).unwrap();
            value.split(',').next().unwrap().trim().parse().unwrap()
        })
    };
    let (left, whole) = (roughness("turned"), roughness("turned_whole"));
    assert!(whole.iter().any(|own| *own > 1e-6), "{whole:?}");
    for (a, b) in left.iter().zip(whole) {
        assert!((a - b).abs() < 1e-9, "{left:?} {whole:?}");
    }
}

/// Two rows of which one yields, at temperatures that turn back.
const HOT: &str = "*RESTART, WRITE
*NODE, NSET=ALL
1, 0.0, 0.0
2, 1.0, 0.0
3, 2.0, 0.0
4, 0.0, 1.0
5, 1.0, 1.0
6, 2.0, 1.0
*ELEMENT, TYPE=CPS4, ELSET=E
1, 1, 2, 5, 4
2, 2, 3, 6, 5
*SOLID SECTION, ELSET=E, MATERIAL=M
0.5
*MATERIAL, NAME=M
*ELASTIC
100.0, 0.3, 0.0
80.0, 0.3, 100.0
*PLASTIC
2.0, 0.0, 0.0
4.0, 0.1, 0.0
1.0, 0.0, 100.0
3.0, 0.1, 100.0
*EXPANSION
2.0E-4, 0.0
3.0E-4, 100.0
*AMPLITUDE, NAME=A
0.0, 0.0, 0.5, 1.0, 1.0, 0.2
*INITIAL CONDITIONS, TYPE=TEMPERATURE
ALL, 15.0
*STEP, NLGEOM
*STATIC
0.25, 1.0, 1.0E-5, 0.25
*BOUNDARY
1, 1, 2
4, 1
3, 1
6, 1
*TEMPERATURE, AMPLITUDE=A
ALL, 90.0
6, 120.0
*NODE PRINT, NSET=ALL
U, NT
*END STEP
";

/// Requirement: a run goes on at the temperatures at which it was left, with its plastic strains,
/// and ends with the bits of one that was never left.
#[test]
fn what_was_left_hot_is_finished() {
    finishes("hot", HOT, &[&FILES[..], &["job.dat"]].concat());
    let printed = Path::new(env!("CARGO_TARGET_TMPDIR")).join("hot/job.dat");
    let text = std::fs::read_to_string(printed).unwrap();
    assert!(text.contains("NT11"), "{text}");
}

/// Two tetrahedra whose edges cross, pressed together and drawn along one another.
const CROSSED: &str = "*RESTART, WRITE
*NODE, NSET=ALL
1, 0.1, -1.0, 0.0
2, 0.1, 1.0, 0.0
3, 1.1, 0.0, -1.0
4, -0.9, 0.0, -1.0
11, -1.0, 0.1, 0.0
12, 1.0, 0.1, 0.0
13, 0.0, 1.1, 1.0
14, 0.0, -0.9, 1.0
*ELEMENT, TYPE=C3D4, ELSET=E
1, 1, 2, 3, 4
2, 11, 12, 13, 14
*SOLID SECTION, ELSET=E, MATERIAL=M
*MATERIAL, NAME=M
*ELASTIC
100.0, 0.3
*SURFACE, NAME=LOW
1, S1
1, S2
*SURFACE, NAME=UP
2, S1
2, S2
*SURFACE INTERACTION, NAME=I
*FRICTION
0.2
*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE
UP, LOW
*STEP, NLGEOM
*STATIC
0.125, 1.0, , 0.125
*BOUNDARY
3, 1, 3
4, 1, 3
13, 1, 1, 0.2
13, 2, 2, 0.1
13, 3, 3, -0.05
14, 1, 1, 0.2
14, 2, 2, 0.1
14, 3, 3, -0.05
*OUTPUT, FIELD
*CONTACT OUTPUT
CSTRESS, CDISP
*END STEP
";

/// Requirement: edges that cross go on with their friction where a run was left, to the bits of one that was not; their
/// forces are in the sums of the pair and in its rows.
#[test]
fn what_was_left_with_edges_crossed_is_finished() {
    let files = ["job.contact.csv", "job.pair.csv"];
    finishes("crossed", CROSSED, &[&FILES[..], &files].concat());
    let read = |name: &str| {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("crossed").join(name);
        std::fs::read_to_string(path).unwrap()
    };
    let of = |text: &str, column: &str| -> f64 {
        let mut lines = text.lines();
        let place = lines.next().unwrap().split(',').position(|own| own == column);
        let place = place.unwrap_or_else(|| panic!("{column}: {text}"));
        lines.last().unwrap().split(',').nth(place).unwrap().parse().unwrap()
    };
    let (pairs, points) = (read("job.pair.csv"), read("job.contact.csv"));
    let (force, pressed) = (of(&pairs, "force_z"), of(&points, "CPRESS") * of(&points, "area"));
    assert!(force > 0.01 && (force / pressed - 1.0).abs() < 0.1, "{force} {pressed}");
}
