//! Masters that are narrow for the slave where contact is at its nodes, and corners that smoothing takes off.
//!
//! Source: docs/theory.md section 5.20.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::noise::{RIDGE, codes, folder, run_in};
use crate::space_decks::{Block, Kind};
use slideline::{Job, ReadOptions, Status};

/// [`RIDGE`] with contact at the nodes, and the stroke.
fn at_nodes(stroke: f64) -> String {
    let deck = RIDGE.replace("TYPE=SURFACE TO SURFACE", "TYPE=NODE TO SURFACE");
    deck.replace("9, 2, 2, 0.03", &format!("9, 2, 2, {stroke}"))
}

/// [`at_nodes`] against two rigid elements, whose ridge is so much higher than their ends.
fn meshed(stroke: f64, (at, rise): (f64, f64), smooth: &str) -> String {
    let deck = at_nodes(stroke).replace("TO SURFACE\n", &format!("TO SURFACE{smooth}\n"));
    let (before, rest) = deck.split_once("*SURFACE, NAME=R").unwrap();
    let (_, rest) = rest.split_once("REF NODE=9\n").unwrap();
    let low = -0.01 - rise;
    format!(
        "{before}*NODE\n11, -0.6, {low}\n12, {at}, -0.01\n13, 1.8, {low}\n\
         *ELEMENT, TYPE=R2D2, ELSET=R\n11, 11, 12\n12, 12, 13\n*SURFACE, NAME=R\nR, SPOS\n\
         *RIGID BODY, ELSET=R, REF NODE=9\n{rest}"
    )
}

pub fn told(name: &str, deck: &str) -> Vec<String> {
    let outcome = run_in(&folder(name), &Job::read_text("ridge", deck, &ReadOptions::default()));
    assert_eq!(outcome.status, Status::Completed, "{name}: {:?}", codes(&outcome));
    codes(&outcome).iter().map(|&own| own.to_owned()).collect()
}

/// Requirement: the ridge of an analytical surface in a face none of whose nodes touches is told of from a tenth of the
/// face on, where contact is at nodes; one that does not come so far is not.
#[test]
fn a_ridge_between_slave_nodes_is_told() {
    let said = |name: &str, stroke| told(name, &at_nodes(stroke)).contains(&"SL0620".to_owned());
    assert!(said("ridge_nodes_deep", 0.08));
    assert!(!said("ridge_nodes_shallow", 0.03));
}

/// Requirement: a ridge that is narrow for the faces of the slave is told of where a node holds it, analytical or meshed,
/// and where an edge of the mesh is held between nodes; a flat one that is pressed far is not.
#[test]
fn a_ridge_that_is_narrow_for_the_slave_is_told() {
    let said = |name: &str, deck: &str| told(name, deck).contains(&"SL0621".to_owned());
    assert!(said("ridge_on_node", &on_node()));
    assert!(said("ridge_on_node_meshed", &meshed(0.03, (0.4, 0.3), ", SMOOTH=0")));
    assert!(said("ridge_edge_held", &meshed(0.03, (0.6, 0.7), "")));
    let flat = on_node().replace("-0.34", "-0.012");
    assert!(!said("ridge_flat", &flat));
}

/// Requirement: a corner of a meshed master that smoothing moves by much of the stroke is told of; without smoothing
/// nothing is.
#[test]
fn a_corner_that_is_smoothed_away_is_told() {
    let said = |name: &str, smooth| {
        let deck = meshed(0.06, (0.4, 0.08), smooth);
        told(name, &deck).contains(&"SL0622".to_owned())
    };
    assert!(said("ridge_smoothed", ", SMOOTH=0.2"));
    assert!(!said("ridge_not_smoothed", ", SMOOTH=0"));
    assert!(!said("ridge_as_drawn", ""));
}

/// [`at_nodes`] with the ridge under a node.
fn on_node() -> String {
    at_nodes(0.03).replace("LINE, 0.6, -0.01", "LINE, 0.4, -0.01")
}

/// Requirement: what a pair missed where it carried most is told when the analysis ends within a step, and when the
/// parts have left one another at its end.
#[test]
fn a_narrow_ridge_is_told_however_the_analysis_ends() {
    let early = on_node().replace("*STEP, NLGEOM", "*STEP, NLGEOM, INC=2");
    let read = Job::read_text("ridge", &early, &ReadOptions::default());
    let outcome = run_in(&folder("ridge_early"), &read);
    assert_ne!(outcome.status, Status::Completed);
    assert!(codes(&outcome).contains(&"SL0621"), "{:?}", codes(&outcome));
    let back =
        on_node().replace("*STEP", "*AMPLITUDE, NAME=A\n0.0, 0.0, 0.5, 1.0, 1.0, 0.0\n*STEP");
    let back = back.replace("9, 2, 2, 0.03", "*BOUNDARY, AMPLITUDE=A\n9, 2, 2, 0.03\n*BOUNDARY");
    assert!(told("ridge_back", &back).contains(&"SL0621".to_owned()));
}

/// The last number of a column of `JOB.pair.csv`.
fn last(name: &str, deck: &str, column: &str) -> f64 {
    let folder = folder(name);
    run_in(&folder, &Job::read_text("ridge", deck, &ReadOptions::default()));
    let text = std::fs::read_to_string(folder.join("ridge.pair.csv")).unwrap();
    let place = text.lines().next().unwrap().split(',').position(|own| own == column).unwrap();
    text.lines().last().unwrap().split(',').nth(place).unwrap().parse().unwrap()
}

/// Requirement: what is missed does not depend on the order of the elements, about a node whose faces differ; and is by
/// hand the mean over both faces of half of each, down the flatter flank.
#[test]
fn what_is_missed_does_not_depend_on_the_numbering() {
    let graded =
        on_node().replace("3, 0.8, 0.0", "3, 0.6, 0.0").replace("7, 0.8, 0.4", "7, 0.6, 0.4");
    let graded = graded.replace("9, 2, 2, 0.03", "9, 2, 2, 1.00001E-2");
    let [first, third] = ["1, 1, 2, 6, 5\n", "3, 3, 4, 8, 7\n"];
    let middle = "2, 2, 3, 7, 6\n";
    let straight = [first, middle, third].concat();
    assert!(graded.contains(&straight));
    let turned = graded.replace(&straight, &[third, middle, first].concat());
    let [one, other] = [("ridge_one", &graded), ("ridge_other", &turned)]
        .map(|(name, deck)| last(name, deck, "falls_away"));
    assert!((one - other).abs() < 1e-9 * one, "{one} {other}");
    // flanks of 0.33 over 0.4 and over 0.8; distances are across the flank
    let flank = 0.33 / 0.33f64.hypot(0.8);
    let expected = 0.5 * (0.2 + 0.1) * flank;
    assert!((one / expected - 1.0).abs() < 1e-3, "{one} {expected}");
}

/// Two blocks of tetrahedra on one another, three by three faces each; the lower one ends in a ridge that is so high.
fn blocks_of_tetrahedra(ridge: f64) -> String {
    let block = |name, base| Block { name, base, cells: [3, 3, 1], kind: Kind::C3d4 };
    let (upper, lower) = (block("B", 0), block("F", 1000));
    let mut deck = String::from("*HEADING\n");
    upper.write(&mut deck, |[x, y, z]| [6.0 * x, 6.0 * y, 3.0 + 3.0 * z]);
    // its second row of nodes is the crest
    let fall = |x: f64| ridge * (3.0 * x - 1.0).abs();
    lower.write(&mut deck, |[x, y, z]| [6.0 * x, 6.0 * y, z * (3.0 - fall(x))]);
    deck.push_str(&upper.surface("SLAVE", |at| at[2] == 0.0));
    deck.push_str(&lower.surface("MASTER", |at| at[2] == 1.0));
    deck.push_str(&upper.set("TOP", |at| at[2] == 1.0));
    deck.push_str(&lower.set("LOW", |at| at[2] == 0.0));
    deck + "*SOLID SECTION, ELSET=B, MATERIAL=M\n*SOLID SECTION, ELSET=F, MATERIAL=M\n*MATERIAL, NAME=M\n\
            *ELASTIC\n1000., 0.\n*SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\n\
            SLAVE, MASTER\n*STEP, NLGEOM\n*STATIC\n0.5, 1.\n*BOUNDARY\nLOW, 1, 3\nTOP, 1, 2\nTOP, 3, 3, -0.06\n\
            *END STEP\n"
}

/// Requirement: blocks of tetrahedra that are flat where they meet miss nothing, though beyond their corners, where
/// every way across a triangle of the slave leads, the master has no face; a ridge under a row of their nodes
/// is told.
#[test]
fn what_is_flat_is_not_narrow_for_triangles() {
    let said =
        |name: &str, ridge| told(name, &blocks_of_tetrahedra(ridge)).contains(&"SL0621".to_owned());
    assert!(!said("flat_tetrahedra", 0.0));
    assert!(said("ridge_of_tetrahedra", 0.4));
}

/// An arm of so many elements that a round bump goes under, contact over its faces.
fn arm(elements: usize) -> String {
    let mut text = "*HEADING\narm\n*NODE\n9999, 0., 0.\n".to_owned();
    let node = |i: usize, j: usize| 1 + i + j * (elements + 1);
    for (i, j) in (0..3).flat_map(|j| (0..=elements).map(move |i| (i, j))) {
        text += &format!("{}, {:?}, {j}.\n", node(i, j), 60.0 * i as f64 / elements as f64);
    }
    text += "*ELEMENT, TYPE=CPS4I, ELSET=ARM\n";
    for (i, j) in (0..2).flat_map(|j| (0..elements).map(move |i| (i, j))) {
        let corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
        let [a, b, c, d] = corners.map(|[i, j]| node(i, j));
        text += &format!("{}, {a}, {b}, {c}, {d}\n", 1 + i + j * elements);
    }
    text += "*SURFACE, NAME=LOWER\n";
    (elements / 2..elements).for_each(|i| text += &format!("{}, S1\n", 1 + i));
    let held = [0, 1, 2].map(|j| node(0, j));
    text + &format!(
        "*SURFACE, NAME=BUMP, TYPE=SEGMENTS\nSTART, 61., -0.5\nCIRCL, 62., 0.5, 62., -0.5\n\
         CIRCL, 63., -0.5, 62., -0.5\n*RIGID BODY, REF NODE=9999, ANALYTICAL SURFACE=BUMP\n\
         *SOLID SECTION, ELSET=ARM, MATERIAL=M\n10.\n*MATERIAL, NAME=M\n*ELASTIC\n2000., .3\n\
         *SURFACE INTERACTION, NAME=I\n*FRICTION\n.1\n*CONTACT PAIR, INTERACTION=I, \
         TYPE=SURFACE TO SURFACE\nLOWER, BUMP\n*NSET, NSET=HELD\n{}, {}, {}\n*BOUNDARY\nHELD, 1, 2\n\
         9999, 2, 2\n9999, 6, 6\n*STEP, NLGEOM, INC=400\n*STATIC\n.02, 1., , .02\n*BOUNDARY\n\
         9999, 1, 1, -10.\n*END STEP\n",
        held[0], held[1], held[2]
    )
}

/// Requirement: a bump between the nodes of a flexible arm, unseen by a mean over its faces, is told of where these are wide
/// for it. Source: with elements of 4 and 2 the bump of radius 1 lifts the arm by two thirds of what it does with elements of a
/// quarter; faces show by less than a tenth of their size.
#[test]
fn a_bump_between_the_nodes_of_an_arm_is_told() {
    for elements in [15, 30] {
        assert!(told(&format!("arm_{elements}"), &arm(elements)).contains(&"SL0615".to_owned()));
    }
}
