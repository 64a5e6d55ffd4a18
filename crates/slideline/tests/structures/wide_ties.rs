//! Ties across gaps whose nodes stay where they are: rigid motions strain nothing, however far they turn, and moments
//! balance.

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
    let mut deck = model(kind, &PLACES) + "*STEP\n*STATIC\n*BOUNDARY\n";
    for (place, at) in PLACES.iter().enumerate().take(6) {
        for (axis, way) in base(turned(*at)).into_iter().enumerate() {
            deck += &format!("{}, {axis}, {axis}, {way}\n", place + 1, axis = axis + 1);
        }
    }
    solved(&format!("{deck}{loads}*END STEP\n"))
}

/// The two bricks, tied.
fn model(kind: &str, places: &[[f64; 3]]) -> String {
    let mut deck = String::from("*NODE, NSET=ALL\n");
    for (place, at) in places.iter().enumerate() {
        let [x, y, z] = turned(*at);
        deck += &format!("{}, {x}, {y}, {z}\n", place + 1);
    }
    deck += &format!(
        "*ELEMENT, TYPE=C3D8, ELSET=E\n1, 1, 2, 5, 4, 7, 8, 11, 10\n2, 2, 3, 6, 5, 8, 9, 12, 11\n\
         3, 13, 14, 15, 16, 17, 18, 19, 20\n*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n\
         *SOLID SECTION, ELSET=E, MATERIAL=M\n*SURFACE, NAME=LOWER\n1, S2\n2, S2\n\
         *SURFACE, NAME=UPPER\n3, S1\n\
         *TIE, NAME=T, ADJUST=NO, POSITION TOLERANCE=.7, TYPE={kind}\nUPPER, LOWER\n"
    );
    deck
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

/// The base, held by a node 50.
const HELD: &str = "*NSET, NSET=BASE\n1, 2, 3, 4, 5, 6\n*SURFACE, NAME=BASE, TYPE=NODE\nBASE\n\
    *COUPLING, CONSTRAINT NAME=C, REF NODE=50, SURFACE=BASE\n*KINEMATIC\n1, 6\n";

/// Requirement: what turns as a whole by 2 rad is not strained and is where it turned to, be the gap as uneven
/// as it may; 1e-9 of the size and the stiffness.
#[test]
fn a_master_that_turns_far_takes_the_slave_along() {
    let mut places = PLACES;
    places[12..16].iter_mut().for_each(|at| at[2] += 0.1 * at[0] - 0.05 * at[1]);
    let about = [0.96, -1.2, 1.28];
    for kind in KINDS {
        let [x, y, z] = about;
        let End(end) = solved(&format!(
            "{}*NODE, NSET=PILOT\n50, 0, 0, 0\n{HELD}*STEP, NLGEOM\n*STATIC\n0.1, 1.\n*BOUNDARY\n\
             50, 1, 3\n50, 4, 4, {x}\n50, 5, 5, {y}\n50, 6, 6, {z}\n*END STEP\n",
            model(kind, &places)
        ));
        for (place, at) in places.iter().enumerate() {
            let [moved, carried] = end[&(place as u64 + 1)];
            let expected = slideline_mech::rotation::displacement(&about, turned(*at));
            for axis in 0..3 {
                assert!((moved[axis] - expected[axis]).abs() < 1e-9, "{kind} {place} {moved:?}");
                assert!(carried[axis].abs() < 1e-6, "{kind} {place} {carried:?}");
            }
        }
    }
}

/// Requirement: the same in the plane, above an edge between faces.
#[test]
fn in_the_plane_too() {
    for kind in KINDS {
        let End(end) = solved(&format!(
            "*NODE, NSET=ALL\n1, 0, 0\n2, 1, 0\n3, 2, 0\n4, 0, 1\n5, 1, 1.2\n6, 2, 1\n11, .2, 1.5\n\
             12, 1, 1.6\n13, 1.8, 1.4\n14, .2, 2\n15, 1, 2\n16, 1.8, 2\n50, 0, 0\n\
             *ELEMENT, TYPE=CPS4, ELSET=E\n1, 1, 2, 5, 4\n2, 2, 3, 6, 5\n3, 11, 12, 15, 14\n\
             4, 12, 13, 16, 15\n*SOLID SECTION, ELSET=E, MATERIAL=M\n*MATERIAL, NAME=M\n\
             *ELASTIC\n1000., .3\n*SURFACE, NAME=LOWER\n1, S3\n2, S3\n*SURFACE, NAME=UPPER\n\
             3, S1\n4, S1\n*TIE, NAME=T, ADJUST=NO, POSITION TOLERANCE=.7, TYPE={kind}\n\
             UPPER, LOWER\n*NSET, NSET=BASE\n1, 2, 3\n*SURFACE, NAME=BASE, TYPE=NODE\nBASE\n\
             *COUPLING, CONSTRAINT NAME=C, REF NODE=50, SURFACE=BASE\n*KINEMATIC\n1, 6\n\
             *STEP, NLGEOM\n*STATIC\n0.1, 1.\n*BOUNDARY\n50, 1, 2\n50, 6, 6, 2.\n*END STEP\n"
        ));
        let places = [(14, [0.2, 2.0]), (16, [1.8, 2.0]), (12, [1.0, 1.6])];
        for (label, [x, y]) in places {
            let [moved, carried] = end[&label];
            let (s, c) = 2.0_f64.sin_cos();
            let off = [moved[0] + x - (c * x - s * y), moved[1] + y - (s * x + c * y)];
            assert!(off.iter().all(|off| off.abs() < 1e-9), "{kind} {label} {off:?}");
            assert!(carried.iter().all(|own| own.abs() < 1e-6), "{kind} {label} {carried:?}");
        }
    }
}

/// Requirement: forces that bend what they act on far reach the supports with their moments where they stand then.
#[test]
fn moments_balance_in_large_motion() {
    let loads = [(19, [20.0, 0.0, 0.0]), (17, [0.0, 30.0, 0.0]), (18, [0.0, 0.0, -10.0])];
    let load = |(node, force): &(u64, [f64; 3])| -> String {
        (0..3).map(|k| format!("{node}, {}, {}\n", k + 1, force[k])).collect()
    };
    let load: String = loads.iter().map(load).collect();
    for kind in KINDS {
        let End(end) = solved(&format!(
            "{}*STEP, NLGEOM\n*STATIC\n0.25, 1.\n*BOUNDARY\n1, 1, 3\n2, 1, 3\n3, 1, 3\n4, 1, 3\n\
             5, 1, 3\n6, 1, 3\n*CLOAD\n{load}*END STEP\n",
            model(kind, &PLACES)
        ));
        let supports = (1..=6).map(|label| (label, end[&label][1]));
        let mut sum = [[0.0; 3]; 2];
        for (label, force) in loads.into_iter().chain(supports) {
            let (at, moved) = (turned(PLACES[label as usize - 1]), end[&label][0]);
            let moment = cross([0, 1, 2].map(|k| at[k] + moved[k]), force);
            for axis in 0..3 {
                sum[0][axis] += force[axis];
                sum[1][axis] += moment[axis];
            }
        }
        assert!(end[&19][0].iter().any(|moved| moved.abs() > 0.1), "{:?}", end[&19][0]);
        assert!(sum.as_flattened().iter().all(|left| left.abs() < 1e-5), "{kind}: {sum:?}");
    }
}

/// Requirement: what bridges a gap beside steps of small motion is in doubt where others turn far.
#[test]
fn wide_gaps_in_steps_of_both_kinds_are_in_doubt() {
    let deck = include_str!("../../../../corpus/advice/SL0430-tied-across-a-gap-mm.inp");
    let codes = |deck: &str| -> Vec<&'static str> {
        let job = Job::read_text("gap", deck, &ReadOptions::default());
        assert!(job.model.is_some());
        job.diagnostics.iter().map(|said| said.code.0).collect()
    };
    assert!(codes(deck).contains(&"SL0430"));
    assert!(!codes(&deck.replace("*STEP\n", "*STEP, NLGEOM\n")).contains(&"SL0430"));
    assert!(!codes(&deck.replace(", NLGEOM", "")).contains(&"SL0430"));
    assert!(!codes(&deck.replace(", ADJUST=NO", "")).contains(&"SL0430"));
}

/// Kind of solid, its upper and lower side, the one above a ridge, and supports of the ridge.
const ABOVE_IN_SPACE: [&str; 5] = [
    "C3D8",
    "S5",
    "S3",
    "31, 1, 1.6, 1.3\n32, 1.6, 1.6, 1.3\n33, 1.6, 1.6, 1.9\n34, 1, 1.6, 1.9\n35, 1, 1, 1.3\n\
     36, 1.6, 1, 1.3\n37, 1.6, 1, 1.9\n38, 1, 1, 1.9\n*ELEMENT, TYPE=C3D8, ELSET=UP\n\
     9, 31, 32, 33, 34, 35, 36, 37, 38\n",
    "1, 1, 3\n2, 1, 3\n3, 1, 3\n7, 1, 3\n8, 1, 3\n9, 1, 3\n13, 1, 3\n14, 1, 3\n15, 1, 3\n",
];
const ABOVE_IN_PLANE: [&str; 5] = [
    "CPS4",
    "S3",
    "S1",
    "31, 1, 1.3\n32, 1.6, 1.3\n33, 1.6, 1.9\n34, 1, 1.9\n*ELEMENT, TYPE=CPS4, ELSET=UP\n\
     9, 31, 32, 33, 34\n",
    "1, 1, 2\n2, 1, 2\n3, 1, 2\n",
];

/// A ridge of solids along x = 1, and one solid above with corners straight above the ridge; `order` is that of
/// the solids of the ridge.
fn above_a_ridge(in_space: bool, order: &[usize]) -> [f64; 3] {
    let height = [0.7, 1.0, 0.8];
    let mut nodes = String::new();
    let rows = if in_space { 3 } else { 1 };
    for (j, i, k) in (0..rows).flat_map(|j| (0..6).map(move |own| (j, own % 3, own / 3))) {
        let (number, up) = (1 + i + 3 * k + 6 * j, k as f64 * height[i]);
        let last = if in_space { format!("{j}, {up}") } else { format!("{up}") };
        nodes += &format!("{number}, {i}, {last}\n");
    }
    let corners = |i: usize, j: usize| [0, 1, 4, 3].map(|own| 1 + i + 6 * j + own);
    let row = |own: &[usize]| own.iter().map(usize::to_string).collect::<Vec<_>>().join(", ");
    let elements = order.iter().enumerate().map(|(label, own)| {
        let (i, j) = (own % 2, own / 2);
        let own = match in_space {
            true => [corners(i, j + 1), corners(i, j)].concat(),
            false => corners(i, j).to_vec(),
        };
        format!("{}, {}\n", label + 1, row(&own))
    });
    let elements: String = elements.collect();
    let [kind, top, bottom, upper, base] = if in_space { ABOVE_IN_SPACE } else { ABOVE_IN_PLANE };
    let end = solved(&format!(
        "*NODE, NSET=ALL\n{nodes}*ELEMENT, TYPE={kind}, ELSET=LOW\n{elements}*NODE\n{upper}\
         *ELSET, ELSET=E\nLOW, UP\n*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n\
         *SOLID SECTION, ELSET=E, MATERIAL=M\n*SURFACE, NAME=LOWER\nLOW, {top}\n\
         *SURFACE, NAME=UPPER\nUP, {bottom}\n\
         *TIE, NAME=T, ADJUST=NO, POSITION TOLERANCE=.9, TYPE=NODE TO SURFACE\nUPPER, LOWER\n\
         *STEP\n*STATIC\n*BOUNDARY\n{base}*CLOAD\n33, 1, 2.\n34, 2, 1.\n*END STEP\n"
    ));
    end.0[&33][0]
}

/// Requirement: of faces that are equally near none comes first.
#[test]
fn the_order_of_faces_below_an_edge_changes_nothing() {
    for (in_space, orders) in [
        (true, [[0, 1, 2, 3], [3, 2, 1, 0]].map(Vec::from)),
        (false, [[0, 1], [1, 0]].map(Vec::from)),
    ] {
        let [one, other] = orders.map(|order| above_a_ridge(in_space, &order));
        let far = one.iter().zip(other).any(|(one, other)| (one - other).abs() > 1e-9);
        assert!(!far && one[0].abs() > 1e-4, "{one:?} {other:?}");
    }
}

/// Requirement: arms that would make two ties follow one another are left out, or stay linear where that is enough,
/// and that is said.
#[test]
fn arms_close_no_circle() {
    // in turned axes, so that arms move across and along
    let places = [(1, 0., 0.), (2, 1., 0.), (3, 1., 1.), (4, 0., 1.)];
    let upper = [(11, 0., 1.2), (12, 1.2, 1.2), (13, 1.2, 2.), (14, 0., 2.)];
    let node = |(label, x, y): (u8, f64, f64)| {
        format!("{label}, {}, {}\n", 0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y)
    };
    let nodes: String = places.into_iter().chain(upper).map(node).collect();
    let cards = "*ELEMENT, TYPE=CPS4, ELSET=E\n1, 1, 2, 3, 4\n2, 11, 12, 13, 14\n\
        *MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n*SOLID SECTION, ELSET=E, MATERIAL=M\n\
        *SURFACE, NAME=LOW\n1, S3\n*SURFACE, NAME=UP\n2, S1\n\
        *SURFACE, NAME=LEFT, TYPE=NODE\n11\n*SURFACE, NAME=RIGHT, TYPE=NODE\n3\n\
        *TIE, NAME=T, ADJUST=NO, POSITION TOLERANCE=.5\nLEFT, LOW\n\
        *TIE, NAME=U, ADJUST=NO, POSITION TOLERANCE=.5\nRIGHT, UP\n\
        *STEP\n*STATIC\n*BOUNDARY\n1, 1, 2\n2, 1, 2\n*CLOAD\n13, 2, 1.\n*END STEP\n";
    let deck = format!("*NODE, NSET=ALL\n{nodes}{cards}");
    let job = Job::read_text("circle", &deck, &ReadOptions::default());
    let codes: Vec<&str> = job.diagnostics.iter().map(|said| said.code.0).collect();
    assert!(job.model.is_some() && codes.contains(&"SL0430"), "{:?}", job.diagnostics);
    // along the axes arms of small turns close none, those that turn far would: they stay linear
    let straight: String = places
        .into_iter()
        .chain(upper)
        .map(|(label, x, y)| format!("{label}, {x}, {y}\n"))
        .collect();
    let deck = format!("*NODE, NSET=ALL\n{straight}{cards}").replace("*STEP\n", "*STEP, NLGEOM\n");
    let job = Job::read_text("circle", &deck, &ReadOptions::default());
    let told = |text: &str| job.diagnostics.iter().any(|said| said.message.contains(text));
    assert!(told("follows small turns only"), "{:?}", job.diagnostics);
    assert!(job.model.is_some_and(|model| model.mean_motions.is_empty()));
}
