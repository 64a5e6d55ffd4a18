//! Files of a run, made through the library.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::observe::{Event, Observer, Stop};
use slideline::{Job, Quiet, Read, ReadOptions, RunOptions, Status, run};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// A circle of radius 5 mm, pushed on two columns and turned a little.
const DECK: &str = "*NODE
1, 0.0, 0.1
2, 0.0, 0.0
3, 0.01, 0.1
4, 0.01, 0.0
9, 0.0, -5.0E-3
*ELEMENT, TYPE=B21, ELSET=BEAMS
1, 1, 2
2, 3, 4
*BEAM SECTION, SECTION=RECT, ELSET=BEAMS, MATERIAL=M
0.01, 0.01
*MATERIAL, NAME=M
*ELASTIC
1.0E9, 0.3
*RIGID SURFACE, TYPE=SEGMENTS, ELSET=TIPS
START, -5.0E-3, -5.0E-3
CIRCL, 0.0, 0.0, 0.0, -5.0E-3
CIRCL, 5.0E-3, -5.0E-3, 0.0, -5.0E-3
*ELEMENT, TYPE=IRS21, ELSET=TIPS
11, 2, 4, 9
*INTERFACE, ELSET=TIPS
0.025
*SURFACE CONTACT, SOFTENED
1.0E-5, 4.8E6
*STEP, NLGEOM
*STATIC
0.5, 1.0
*BOUNDARY
1, 1, 6
3, 1, 6
2, 1
2, 6
9, 1
9, 2, 2, 2.0E-5
9, 6, 6, 0.5
*END STEP
";

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    folder
}

fn job() -> Read {
    let read = Job::read_text("circle", DECK, &ReadOptions::default());
    assert!(read.model.is_some(), "{:?}", read.diagnostics);
    read
}

fn options(folder: &Path) -> RunOptions {
    RunOptions { folder: Some(folder.to_owned()), ..RunOptions::default() }
}

/// Base64 back to bytes, for the test alone.
fn decode(text: &str) -> Vec<u8> {
    let value = |c: u8| match c {
        b'A'..=b'Z' => c - b'A',
        b'a'..=b'z' => c - b'a' + 26,
        b'0'..=b'9' => c - b'0' + 52,
        b'+' => 62,
        _ => 63,
    };
    let mut bytes = Vec::new();
    for quad in text.as_bytes().chunks(4) {
        let word = quad
            .iter()
            .fold(0_u32, |word, &c| word << 6 | if c == b'=' { 0 } else { u32::from(value(c)) });
        let count = 3 - quad.iter().filter(|&&c| c == b'=').count();
        bytes.extend_from_slice(&word.to_be_bytes()[1..=count]);
    }
    bytes
}

/// An array of a state, the leading byte count checked.
fn array(file: &str, name: &str) -> Vec<u8> {
    let begin = file.find(&format!("Name=\"{name}\"")).unwrap_or_else(|| panic!("no {name}"));
    let data = &file[begin..];
    let data = &data[data.find('>').unwrap() + 1..data.find("</DataArray>").unwrap()];
    let bytes = decode(data);
    let (length, bytes) = bytes.split_first_chunk::<4>().unwrap();
    assert_eq!(u32::from_le_bytes(*length) as usize, bytes.len(), "{name}");
    bytes.to_vec()
}

fn floats(file: &str, name: &str) -> Vec<f64> {
    let bytes = array(file, name);
    bytes.chunks_exact(8).map(|eight| f64::from_le_bytes(eight.try_into().unwrap())).collect()
}

fn integers(file: &str, name: &str) -> Vec<i64> {
    let bytes = array(file, name);
    bytes.chunks_exact(8).map(|eight| i64::from_le_bytes(eight.try_into().unwrap())).collect()
}

/// Requirement: the last state shows the deck's motion: centre raised by
/// 20 um, circle turned by 0.5; every chord point on the circle. Tolerance:
/// rounding of coordinates of 5e-3.
#[test]
fn states_show_nodes_rigid_surfaces_and_contact() {
    let folder = folder("states");
    let outcome = run(&job(), &options(&folder), &mut Quiet);
    assert_eq!(outcome.status, Status::Completed);
    let state = std::fs::read_to_string(folder.join("circle_0002.vtu")).unwrap();
    let points = floats(&state, "Points");
    let count = points.len() / 3;
    let centre = [points[12], points[13]]; // the fifth node
    assert_eq!(centre, [0.0, -5.0e-3 + 2.0e-5]);
    for point in points.chunks_exact(3).skip(5) {
        let radius = (point[0] - centre[0]).hypot(point[1] - centre[1]);
        assert!((radius - 5.0e-3).abs() < 1e-17, "{radius}");
    }
    let angle = (points[16] - centre[1]).atan2(points[15] - centre[0]);
    assert!((angle - (0.5 - std::f64::consts::PI)).abs() < 1e-12, "START turns with the body");

    let cells = integers(&state, "offsets").len();
    let connectivity = integers(&state, "connectivity");
    assert_eq!(connectivity.len(), 2 * cells);
    assert!(connectivity.iter().all(|&point| (0..count as i64).contains(&point)));
    assert_eq!(array(&state, "types"), vec![3; cells]);
    assert_eq!(integers(&state, "node")[..5], [1, 2, 3, 4, 9]);

    let pressure = floats(&state, "contact_pressure");
    assert!(pressure[1] > 0.0 && pressure[3] == 0.0, "tip 2 is pressed, tip 4 is out of reach");
    assert!(floats(&state, "contact_opening")[0].is_nan(), "node 1 is no contact point");
    let axial = floats(&state, "axial_force");
    let force = floats(&state, "reaction_force")[3 * 4 + 1];
    assert!((axial[0] + force).abs() < 1e-9 * force, "column 1 carries what the circle pushes");
}

#[test]
fn start_and_increments_are_listed_with_their_times() {
    let folder = folder("list");
    run(&job(), &options(&folder), &mut Quiet);
    let list = std::fs::read_to_string(folder.join("circle.pvd")).unwrap();
    for (time, name) in [("0", "circle_0000"), ("0.5", "circle_0001"), ("1", "circle_0002")] {
        assert!(list.contains(&format!("timestep=\"{time}\" part=\"0\" file=\"{name}.vtu\"")));
    }
}

struct StopAfter(usize);

impl Observer for StopAfter {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if matches!(event, Event::Committed(frame) if frame.increment == self.0) {
            return ControlFlow::Break(Stop::Interrupted);
        }
        ControlFlow::Continue(())
    }
}

/// Requirement: a job of two steps in which only loads move anything lists its start once, and its
/// report is written. Source: a deck of somebody else, which ended with SL0702.
#[test]
fn steps_of_loads_alone_have_one_start() {
    let load = |size: f64| format!("*STEP\n*STATIC\n0.5, 1.0\n*CLOAD\n3, 1, {size}\n*END STEP\n");
    let deck = format!(
        "*NODE\n1, 0., 0.\n2, 1., 0.\n3, 1., 1.\n4, 0., 1.\n*ELEMENT, TYPE=CPS4, ELSET=E\n1, 1, 2, 3, 4\n\
         *SOLID SECTION, ELSET=E, MATERIAL=M\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n\
         *BOUNDARY\n1, 1, 2\n4, 1\n2, 2\n{}{}",
        load(1.0),
        load(2.0)
    );
    let folder = folder("loads-alone");
    let read = Job::read_text("loads", &deck, &ReadOptions::default());
    let outcome = run(&read, &options(&folder), &mut Quiet);
    assert_eq!(outcome.status, Status::Completed, "{:#?} {outcome:#?}", read.diagnostics);
    let list = std::fs::read_to_string(folder.join("loads.pvd")).unwrap();
    assert_eq!(list.matches("<DataSet ").count(), 5);
}

#[test]
fn an_observer_may_stop_a_run() {
    let folder = folder("stop");
    let outcome = run(&job(), &options(&folder), &mut StopAfter(1));
    assert_eq!((outcome.status, outcome.totals.increments), (Status::Interrupted, 1));
    let summary = std::fs::read_to_string(folder.join("circle.json")).unwrap();
    assert!(summary.contains("\"status\":\"interrupted\",\"increments\":1"), "{summary}");
}

struct Faulty;

impl Observer for Faulty {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        assert!(!matches!(event, Event::Committed(_)), "a fault in the embedding program");
        ControlFlow::Continue(())
    }
}

#[test]
fn a_panic_leaves_a_summary_that_says_so() {
    let folder = folder("panic");
    let fault = std::panic::catch_unwind(|| run(&job(), &options(&folder), &mut Faulty));
    assert!(fault.is_err());
    let summary = std::fs::read_to_string(folder.join("circle.json")).unwrap();
    assert!(summary.contains("\"status\":\"internal_error\""), "{summary}");
}

/// Requirement: the same bits on every run; only the clock differs.
#[test]
fn two_runs_write_the_same_files() {
    let folders = [folder("first"), folder("second")];
    for folder in &folders {
        run(&job(), &options(folder), &mut Quiet);
    }
    let mut compared = 0;
    for entry in std::fs::read_dir(&folders[0]).unwrap() {
        let name = entry.unwrap().file_name();
        if name != "circle.json" {
            let [first, second] =
                [0, 1].map(|place: usize| std::fs::read(folders[place].join(&name)).unwrap());
            assert!(first == second, "{name:?} differs");
            compared += 1;
        }
    }
    assert_eq!(compared, 8 + 3);
}
