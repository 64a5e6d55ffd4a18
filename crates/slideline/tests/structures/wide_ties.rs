//! Ties across gaps whose nodes stay where they are: rigid motions strain nothing, and moments balance.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::joined_forces::{End, solved};
use slideline::{Job, ReadOptions};

/// Two bricks above one another with a gap between, the upper one further along and coarser than its
/// master, in axes that are turned.
const PLACES: [[f64; 3]; 20] = [
    [0., 0., 0.],
    [1., 0., 0.],
    [2., 0., 0.],
    [0., 2., 0.],
    [1., 2., 0.],
    [2., 2., 0.],
    [0., 0., 1.],
    [1., 0., 1.],
    [2., 0., 1.],
    [0., 2., 1.],
    [1., 2., 1.],
    [2., 2., 1.],
    [0.3, 0.2, 1.4],
    [2.2, 0.2, 1.4],
    [2.2, 1.9, 1.4],
    [0.3, 1.9, 1.4],
    [0.3, 0.2, 2.],
    [2.2, 0.2, 2.],
    [2.2, 1.9, 2.],
    [0.3, 1.9, 2.],
];

fn turned([x, y, z]: [f64; 3]) -> [f64; 3] {
    let [x, y] = [0.6 * x - 0.8 * y, 0.8 * x + 0.6 * y];
    [x, 0.28 * y - 0.96 * z, 0.96 * y + 0.28 * z]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn run(kind: &str, base: impl Fn([f64; 3]) -> [f64; 3], loads: &str) -> End {
    let mut deck = String::from("*NODE, NSET=ALL\n");
    for (place, at) in PLACES.iter().enumerate() {
        let [x, y, z] = turned(*at);
        deck += &format!("{}, {x}, {y}, {z}\n", place + 1);
    }
    deck += &format!(
        "*ELEMENT, TYPE=C3D8, ELSET=E\n1, 1, 2, 5, 4, 7, 8, 11, 10\n2, 2, 3, 6, 5, 8, 9, 12, 11\n\
         3, 13, 14, 15, 16, 17, 18, 19, 20\n*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n\
         *SOLID SECTION, ELSET=E, MATERIAL=M\n*SURFACE, NAME=LOWER\n1, S2\n2, S2\n\
         *SURFACE, NAME=UPPER\n3, S1\n\
         *TIE, NAME=T, ADJUST=NO, POSITION TOLERANCE=.7, TYPE={kind}\nUPPER, LOWER\n\
         *STEP\n*STATIC\n*BOUNDARY\n"
    );
    for (place, at) in PLACES.iter().enumerate().take(6) {
        for (axis, way) in base(turned(*at)).into_iter().enumerate() {
            deck += &format!("{}, {axis}, {axis}, {way}\n", place + 1, axis = axis + 1);
        }
    }
    solved(&format!("{deck}{loads}*END STEP\n"))
}

const KINDS: [&str; 2] = ["NODE TO SURFACE", "SURFACE TO SURFACE"];

/// Requirement: what is turned as a whole stays as it is.
#[test]
fn a_turn_of_the_master_takes_the_slave_along() {
    let moves = |at: [f64; 3]| cross([1e-3, -2e-3, 3e-3], at);
    for kind in KINDS {
        let End(end) = run(kind, moves, "");
        for (place, at) in PLACES.iter().enumerate() {
            let [moved, carried] = end[&(place as u64 + 1)];
            let expected = moves(turned(*at));
            for axis in 0..3 {
                assert!((moved[axis] - expected[axis]).abs() < 1e-10, "{kind} {place} {moved:?}");
                assert!(carried[axis].abs() < 1e-8, "{kind} {place} {carried:?}");
            }
        }
    }
}

/// Requirement: forces on the slave reach the supports with their moments.
#[test]
fn a_force_across_the_gap_has_its_moment_at_the_supports() {
    for kind in KINDS {
        let End(end) = run(kind, |_| [0.0; 3], "*CLOAD\n19, 1, 2.\n17, 2, 3.\n18, 3, -1.\n");
        let loads = [(18, [2.0, 0.0, 0.0]), (16, [0.0, 3.0, 0.0]), (17, [0.0, 0.0, -1.0])];
        let supports = (0..6).map(|place| (place, end[&(place as u64 + 1)][1]));
        let mut sum = [[0.0; 3]; 2];
        for (place, force) in loads.into_iter().chain(supports) {
            let moment = cross(turned(PLACES[place]), force);
            for axis in 0..3 {
                sum[0][axis] += force[axis];
                sum[1][axis] += moment[axis];
            }
        }
        assert!(sum.as_flattened().iter().all(|left| left.abs() < 1e-6), "{kind}: {sum:?}");
    }
}

/// Requirement: what bridges a gap and may turn far is in doubt.
#[test]
fn wide_gaps_in_large_steps_are_in_doubt() {
    let deck = include_str!("../../../../corpus/advice/SL0430-tied-across-a-gap-mm.inp");
    let codes = |deck: &str| -> Vec<&'static str> {
        let job = Job::read_text("gap", deck, &ReadOptions::default());
        assert!(job.model.is_some());
        job.diagnostics.iter().map(|said| said.code.0).collect()
    };
    assert!(codes(deck).contains(&"SL0430"));
    assert!(!codes(&deck.replace(", NLGEOM", "")).contains(&"SL0430"));
    assert!(!codes(&deck.replace(", ADJUST=NO", "")).contains(&"SL0430"));
}
