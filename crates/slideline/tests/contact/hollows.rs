//! Parts with holes in the plane: what stands outside meets the outside, what stands in a hole meets its wall, and nothing sees
//! one through the other.
//!
//! ```text
//!     ___________
//!    |  _______  |   s       the whole outline of a part is a master of two lines
//!    | |   p   | |
//!    | |_______| |
//!    |___________|
//! ```
//!
//! docs/theory.md section 5.12

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::space_decks::{Last, solved};
use slideline::{Job, ReadOptions};
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// Nodes and elements of a plane part of unit cells, those that `is_there` has, with corners at whole numbers; the labels of nodes.
fn part(
    text: &mut String,
    (name, base): (&str, u64),
    is_there: impl Fn(i32, i32) -> bool,
    place: impl Fn(i32, i32) -> [f64; 2],
) -> BTreeMap<(i32, i32), u64> {
    let (mut nodes, mut elements) = (BTreeMap::new(), Vec::new());
    for (i, j) in
        (-9..9).flat_map(|i| (-9..9).map(move |j| (i, j))).filter(|&(i, j)| is_there(i, j))
    {
        let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|at| {
            let next = base + nodes.len() as u64;
            *nodes.entry(at).or_insert(next)
        });
        elements.push(corners);
    }
    let _ = writeln!(text, "*NODE");
    for (&(i, j), label) in &nodes {
        let [x, y] = place(i, j);
        let _ = writeln!(text, "{label}, {x:?}, {y:?}");
    }
    let _ = writeln!(text, "*ELEMENT, TYPE=CPE4, ELSET={name}");
    for (k, [a, b, c, d]) in elements.iter().enumerate() {
        let _ = writeln!(text, "{}, {a}, {b}, {c}, {d}", base + k as u64);
    }
    let _ = writeln!(text, "*SOLID SECTION, ELSET={name}, MATERIAL=M\n1.");
    nodes
}

fn set(name: &str, nodes: impl Iterator<Item = u64>) -> String {
    let list: String = nodes.map(|label| format!("{label},\n")).collect();
    format!("*NSET, NSET={name}\n{list}")
}

/// A frame of one cell about a hole of three by three.
fn is_frame(i: i32, j: i32) -> bool {
    (-2..3).contains(&i) && (-2..3).contains(&j) && !((-1..2).contains(&i) && (-1..2).contains(&j))
}

/// How contact is asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Asked {
    /// Between whole outlines, in this form.
    Pair(&'static str),
    /// Of the faces that face the block alone.
    Named(&'static str),
    General,
}

/// A block pressed on the outside of the frame, or within it on its wall; the force on what is moved.
fn pressed(asked: Asked, inside: bool) -> Last {
    let mut text = "*HEADING\nframe\n".to_owned();
    let frame = part(&mut text, ("FRAME", 1), is_frame, |i, j| [f64::from(i), f64::from(j)]);
    // smaller cells, so that the frame is the master wherever that is left open
    let low = if inside { 1.2 } else { 3.01 };
    let place = |i: i32, j: i32| [0.45 * f64::from(i) + 0.1, low + 0.39 * f64::from(j)];
    let block =
        part(&mut text, ("BLOCK", 1001), |i, j| (0..2).contains(&i) && (0..2).contains(&j), place);
    text += &set("BASE", frame.iter().filter(|((_, j), _)| *j == -2).map(|(_, label)| *label));
    text += &set(
        "HEAD",
        block.iter().filter(|((_, j), _)| *j == if inside { 0 } else { 2 }).map(|(_, l)| *l),
    );
    text +=
        "*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n*SURFACE INTERACTION, NAME=I\n*FRICTION\n0.1\n";
    text += match asked {
        Asked::General => {
            "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\n, , I\n".to_owned()
        }
        Asked::Pair(form) => format!(
            "*SURFACE, NAME=ALL\nFRAME,\n*SURFACE, NAME=OWN\nBLOCK,\n*CONTACT PAIR, INTERACTION=I, TYPE={form}\nOWN, ALL\n"
        ),
        Asked::Named(form) => {
            // cells of the upper row, left to right, as they were numbered
            let cells = (-9..9).flat_map(|i| (-9..9).map(move |j| (i, j)));
            let cells = (1..).zip(cells.filter(|&(i, j)| is_frame(i, j)));
            let row = cells.filter(|(_, (i, j))| *j == 2 && (!inside || (-1..2).contains(i)));
            let labels: Vec<i32> = row.map(|(label, _)| label).collect();
            let face = if inside { "S1" } else { "S3" };
            let list: String = labels.iter().map(|label| format!("{label}, {face}\n")).collect();
            format!(
                "*SURFACE, NAME=ALL\n{list}*SURFACE, NAME=OWN\nBLOCK,\n*CONTACT PAIR, INTERACTION=I, TYPE={form}\nOWN, ALL\n"
            )
        }
    }
    .as_str();
    let stroke = if inside { 0.06 } else { -0.05 };
    let _ = write!(
        text,
        "*BOUNDARY\nBASE, 1, 2\nHEAD, 1, 1\n*STEP, NLGEOM\n*STATIC\n.25, 1.\n*BOUNDARY\nHEAD, 2, 2, {stroke:?}\n*END STEP\n"
    );
    solved(&text)
}

/// Requirement: the whole outline of a part with a hole is a master; what is pressed on it from outside or from within the hole has
/// the force of the faces that it meets. Source: the same pair with those faces alone. Tolerance: 1e-4, what the ends of a line
/// change of its smoothed corners. Such masters were refused (SL0329).
#[test]
fn the_whole_outline_of_a_part_with_a_hole_is_a_master() {
    for inside in [false, true] {
        for form in ["NODE TO SURFACE", "SURFACE TO SURFACE"] {
            let whole = pressed(Asked::Pair(form), inside).force()[1];
            let named = pressed(Asked::Named(form), inside).force()[1];
            assert!(whole.abs() > 1.0, "{inside} {form}: {whole}");
            assert!((whole - named).abs() < 1e-4 * named.abs(), "{inside} {form}: {whole} {named}");
        }
        let general = pressed(Asked::General, inside).force()[1];
        let named = pressed(Asked::Named("SURFACE TO SURFACE"), inside).force()[1];
        assert!((general - named).abs() < 1e-4 * named.abs(), "{inside}: {general} {named}");
    }
}

/// Requirement: general contact makes one pair of a block and a part with a hole, of what can meet: outside, in the hole, and as a
/// plug that is wider than the hole. Source: counted; the wall is where the hole is.
#[test]
fn general_contact_pairs_what_can_meet() {
    let wall = |low: f64, size: f64| {
        let mut text = "*HEADING\npairs\n".to_owned();
        part(&mut text, ("FRAME", 1), is_frame, |i, j| [f64::from(i), f64::from(j)]);
        let place = |i: i32, j: i32| [low + size * f64::from(i), low + size * f64::from(j)];
        part(&mut text, ("BLOCK", 1001), |i, j| i == 0 && j == 0, place);
        text += "*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n*CONTACT\n*CONTACT INCLUSIONS\nFRAMES, BLOCKS\n\
                 *SURFACE, NAME=FRAMES\nFRAME,\n*SURFACE, NAME=BLOCKS\nBLOCK,\n*STEP\n*STATIC\n*END STEP\n";
        let read = Job::read_text("pairs", &text, &ReadOptions::default());
        let model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
        let [pair] = &model.contact_pairs[..] else { panic!("{}", model.contact_pairs.len()) };
        let of_frame = |node: &usize| model.nodes.label(*node) < 1000;
        let nodes = pair.slave_nodes().into_iter().chain(pair.master.deforming_nodes());
        nodes.filter(of_frame).all(|node| {
            let [x, y, _] = model.nodes.position(node);
            (-1.0..=2.0).contains(&x) && (-1.0..=2.0).contains(&y)
        })
    };
    assert_eq!([wall(3.01, 0.5), wall(0.2, 0.5), wall(-1.05, 3.1)], [false, true, true]);
}
