//! Jobs that the tests of restart run, and how their files are compared.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

pub const PROGRAM: &str = env!("CARGO_BIN_EXE_slideline");

pub fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(env!("CARGO_CRATE_NAME")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

pub fn slideline(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(PROGRAM).args(arguments).current_dir(folder).output().unwrap()
}

pub fn code(output: &Output) -> i32 {
    output.status.code().unwrap_or_else(|| panic!("{output:?}"))
}

pub fn corpus(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../corpus/diehl1995").join(name);
    std::fs::read_to_string(path).unwrap()
}

/// The files of a job but the report and the saved state; wall time blanked.
pub fn files(folder: &Path, job: &str) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        let aside = [".inp", ".html", ".rst"].iter().any(|ending| name.ends_with(ending));
        if !name.starts_with(job) || aside {
            continue;
        }
        let mut content = std::fs::read(&path).unwrap();
        if name.ends_with(".json") {
            let text = String::from_utf8(content).unwrap();
            let (before, after) = text.split_once("\"wall_seconds\":").unwrap();
            content = [before, &after[after.find(',').unwrap()..]].concat().into_bytes();
        }
        files.insert(name, content);
    }
    files
}

pub fn same(left: &BTreeMap<String, Vec<u8>>, right: &BTreeMap<String, Vec<u8>>, case: &str) {
    let names = |files: &BTreeMap<String, Vec<u8>>| files.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(left), names(right), "{case}");
    for (name, content) in left {
        assert!(*content == right[name], "{case}: {name} differs");
    }
}

/// A column that is pressed on a plane and dragged along it with friction, in
/// three steps: press, drag, drag back.
pub fn columns(increments: usize, restart: &str, contact: &str) -> String {
    let steps: String = MOTIONS.iter().map(|&to| step(increments, to)).collect();
    model(restart, contact) + &steps
}

/// Where the plane of the columns stands at the end of each step.
pub const MOTIONS: [(f64, f64); 3] = [(0.0, 1.2e-4), (1.0e-3, 1.2e-4), (-5.0e-4, 1.25e-4)];

/// The columns without any step.
pub fn model(restart: &str, contact: &str) -> String {
    format!(
        "*HEADING
columns on a plane
{restart}*NODE, NSET=ALL
1, 0.0, 0.1
2, 0.0, 0.0
3, 0.01, 0.1
4, 0.01, 0.0
9, 0.0, 0.0
21, -1.0, -1.0E-4
22, 0.0, -1.0E-4
23, 1.0, -1.0E-4
*ELEMENT, TYPE=B21, ELSET=BEAMS
1, 1, 2
2, 3, 4
*BEAM SECTION, SECTION=RECT, ELSET=BEAMS, MATERIAL=M
0.01, 0.01
*MATERIAL, NAME=M
*ELASTIC
1.0E9, 0.3
{contact}*NSET, NSET=PLANE
9
*MPC
BEAM, 21, 9
BEAM, 22, 9
BEAM, 23, 9
"
    )
}

/// A step that takes the plane to a place.
pub fn step(increments: usize, (x, y): (f64, f64)) -> String {
    let dt = 1.0 / increments as f64;
    format!(
        "*STEP, NLGEOM, INC=10000
PRESS, DRAG
*STATIC
{dt:?}, 1.0, 1.0E-9, {dt:?}
*BOUNDARY
1, 1, 6
3, 1, 6
9, 1, 1, {x:?}
9, 2, 2, {y:?}
9, 6, 6
*NODE PRINT, NSET=PLANE
U, RF
*END STEP
"
    )
}

pub const LAWS: &str = "*INTERFACE, ELSET=TIPS
0.025
*FRICTION
0.3
*SURFACE CONTACT, SOFTENED
1.0E-5, 4.8E6
";

pub fn irs() -> String {
    format!(
        "*RIGID SURFACE, TYPE=SEGMENTS, ELSET=TIPS
START, -1.0, -1.0E-4
LINE, 1.0, -1.0E-4
*ELEMENT, TYPE=IRS21, ELSET=TIPS
11, 2, 4, 9
{LAWS}"
    )
}

pub fn isl() -> String {
    format!(
        "*ELEMENT, TYPE=ISL21, ELSET=TIPS
11, 2, 4
*SLIDE LINE, ELSET=TIPS, TYPE=LINEAR
21, 22, 23
{LAWS}"
    )
}

pub const WRITE: &str = "*RESTART, WRITE\n";

pub fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// CRC-32 (IEEE), written again.
fn checksum(bytes: &[u8]) -> u32 {
    let step = |sum: u32| sum >> 1 ^ if sum & 1 == 1 { 0xedb8_8320 } else { 0 };
    let byte = |sum: u32, byte: &u8| (0..8).fold(sum ^ u32::from(*byte), |sum, _| step(sum));
    !bytes.iter().fold(!0_u32, byte)
}

/// Bytes of the head of a `JOB.rst`: its name, its format, two marks.
pub const HEAD: usize = 22 + 2 * 12;

/// First byte of every section of a `JOB.rst` (the preface, then a state each)
/// and the end of the last.
pub fn sections(file: &[u8]) -> Vec<usize> {
    let word = |at: usize| u64::from_le_bytes(*file[at..].first_chunk().unwrap()) as usize;
    let (mut places, valid) = (vec![HEAD], word(22).max(word(34)));
    while *places.last().unwrap() < valid {
        let start = *places.last().unwrap();
        places.push(start + 12 + word(start));
    }
    places
}

/// A `JOB.rst` whose head says that it ends after the state of that number.
pub fn up_to_state(file: &[u8], number: usize) -> Vec<u8> {
    let end = sections(file)[number + 1] as u64;
    let mark = [&end.to_le_bytes()[..], &checksum(&end.to_le_bytes()).to_le_bytes()].concat();
    [&file[..22], &mark, &mark, &file[HEAD..]].concat()
}
