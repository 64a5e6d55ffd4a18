//! Contact at all nodes of three-node beams.
//!
//! Requirement: a beam that a uniform load presses on a flat bed of springs carries the same pressure
//! at every node, ends and middle nodes alike, and does not bend. Source: theory, areas (Simpson's
//! weights). Tolerance: convergence.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::{Job, Quiet, ReadOptions, RunOptions, Status, run};
use std::path::Path;

const DECK: &str = "*NODE, NSET=BEAM
1, 0.0, 0.0
5, 4.0, 0.0
*NGEN, NSET=BEAM
1, 5
*ELEMENT, TYPE=B22, ELSET=BEAM
1, 1, 2, 3
2, 3, 4, 5
*BEAM SECTION, SECTION=RECT, ELSET=BEAM, MATERIAL=STEEL
0.5, 0.1
*MATERIAL, NAME=STEEL
*ELASTIC
210.0E3, 0.3
*NODE
100, 2.0, -1.0
*SURFACE, NAME=BEAM
BEAM,
*SURFACE, NAME=BED, TYPE=SEGMENTS
START, -1.0, 0.001
LINE, 5.0, 0.001
*RIGID BODY, REF NODE=100, ANALYTICAL SURFACE=BED
*SURFACE INTERACTION, NAME=SPRINGS
0.5
*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR
1000.0
*CONTACT PAIR, INTERACTION=SPRINGS
BEAM, BED
*STEP, NLGEOM
*STATIC
0.5, 1.0
*BOUNDARY
100, 1, 6
1, 1
*CLOAD
1, 2, -1.0
2, 2, -4.0
3, 2, -2.0
4, 2, -4.0
5, 2, -1.0
*END STEP
";

#[test]
fn a_uniform_load_gives_a_uniform_pressure() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("middle-nodes");
    let _ = std::fs::remove_dir_all(&folder);
    let read = Job::read_text("bed", DECK, &ReadOptions::default());
    assert!(read.model.is_some(), "{:?}", read.diagnostics);
    let options = RunOptions { folder: Some(folder.clone()), ..RunOptions::default() };
    assert_eq!(run(&read, &options, &mut Quiet).status, Status::Completed);
    let text = std::fs::read_to_string(folder.join("bed.contact.csv")).unwrap();
    let mut lines = text.lines();
    let columns: Vec<&str> = lines.next().unwrap().split(',').collect();
    let place = |name: &str| columns.iter().position(|column| *column == name).unwrap();
    let (increment, pressure) = (place("increment"), place("CPRESS"));
    let last = lines.filter_map(|line| {
        let cells: Vec<&str> = line.split(',').collect();
        (cells[increment] == "2").then(|| cells[pressure].parse::<f64>().unwrap())
    });
    let pressures: Vec<f64> = last.collect();
    // 12 over 4 by 0.5
    assert_eq!(pressures.len(), 5, "{text}");
    assert!(pressures.iter().all(|p| (p - 6.0).abs() < 1e-6), "{pressures:?}");
}
