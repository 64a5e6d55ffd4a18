//! Heading, nodes and elements.

use super::results::push_node;
use crate::date;
use crate::facts::Formats;
use crate::fixed::push_whole;
use crate::outline::{Drawing, Owner, Piece};
use slideline_model::Model;
use std::collections::HashSet;
use std::fmt::Write as _;

/// Most nodes of an element on one line.
const NODES_A_LINE: usize = 10;

/// Places of a text in a line of the heading.
const WIDTH: usize = 66;

/// Names of the job, its heading, the program and the sections; in the file of ccx also the day and
/// the time, which programs read. A String takes any text.
pub(super) fn push_heading(
    text: &mut String,
    model: &Model,
    job: &str,
    version: &str,
    formats: Formats,
) {
    push_line(text, "1C", job);
    model.heading.lines().for_each(|line| push_line(text, "1U", line));
    if formats == Formats::Ccx {
        let [day, time] = date::now();
        push_line(text, "1UDATE", &format!("{:14}{day}", ""));
        push_line(text, "1UTIME", &format!("{:14}{time}", ""));
    }
    push_line(text, "1UPGM", &format!("{:15}slideline", ""));
    push_line(text, "1UVERSION", &format!("{:11}Version {version}", ""));
    for (place, block) in model.blocks.iter().enumerate() {
        push_line(text, "1UMAT", &format!("{:>5}{}", place + 1, block.name));
    }
}

/// A line of the heading: readers count bytes, so that other than plain letters are left out.
fn push_line(text: &mut String, key: &str, content: &str) {
    let content: String = content.chars().filter(char::is_ascii).take(WIDTH).collect();
    let _ = writeln!(text, "    {key}{content:<WIDTH$}"); // a String takes any text
}

/// Nodes and elements: a beam of three nodes is two lines. A String takes any text.
pub(super) fn push_mesh(
    text: &mut String,
    drawing: &Drawing,
    left_out: &HashSet<u64>,
    model: &Model,
) {
    let nodes = drawing.labels.len() - left_out.len();
    let _ = writeln!(text, "    2C{:18}{nodes:>12}{:37}1", "", "");
    let points = drawing.labels.iter().zip(drawing.still(model));
    for (&label, position) in points.filter(|(label, _)| !left_out.contains(label)) {
        push_node(text, label, &position);
    }
    text.push_str(" -3\n");
    let _ = writeln!(text, "    3C{:18}{:>12}{:37}1", "", drawing.pieces.len(), "");
    for (piece, number) in drawing.pieces.iter().zip(numbers(&drawing.pieces)) {
        let Piece { kind, frd: (shape, points), .. } = piece;
        let (group, section) = (*kind as u32, section(piece));
        let _ = writeln!(text, " -1{number:>10}{shape:>5}{group:>5}{section:>5}");
        for line in points.chunks(NODES_A_LINE) {
            text.push_str(" -2");
            for &point in line {
                push_whole(text, drawing.labels[point], 10);
            }
            text.push('\n');
        }
    }
    text.push_str(" -3\n");
}

/// Number of the section in the heading; of surfaces 1.
fn section(piece: &Piece) -> usize {
    match piece.owner {
        Owner::Element((block, _)) => block + 1,
        Owner::Pair(_) | Owner::Body => 1,
    }
}

/// A number of its own for each piece: that of its element, and behind all of them for the second
/// piece of an element and for surfaces.
fn numbers(pieces: &[Piece]) -> Vec<u64> {
    let labels = pieces.iter().map(|piece| piece.label);
    let mut next = labels.max().unwrap_or_default();
    let mut taken = HashSet::new();
    let number = |piece: &Piece| {
        let is_element = matches!(piece.owner, Owner::Element(_));
        if is_element && taken.insert(piece.label) {
            return piece.label;
        }
        next += 1;
        next
    };
    pieces.iter().map(number).collect()
}
