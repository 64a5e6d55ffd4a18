//! Which of two nodes of a line that meet is the slave.
//!
//! ```text
//!    o sharp edge    o fine    o coarse    o - o - o in their order
//!      first                                 last
//! ```
//!
//! docs/theory.md section 5.12. (derived)

use super::undeformed::{Part, Undeformed, along_of, size};

/// Faces on either side of a node whose mean length tells how fine it is.
const ABOUT: usize = 4;
/// Turn at a node of the undeformed surface from which on it is a sharp edge [rad].
const SHARP: f64 = 50.0 * std::f64::consts::PI / 180.0;

/// Of every node by its seat: of two that meet, the lower one is the slave. Sharp edges that stand out
/// come first, then what has shorter faces, in classes of twice the length, then all in their order:
/// pointed and fine are the slaves of flat and coarse.
pub(super) fn ranks(line: &Undeformed, seats: &[usize]) -> Vec<usize> {
    let sizes: Vec<f64> = seats.iter().map(|&seat| fineness(line, seat)).collect();
    let longest = sizes.iter().copied().fold(0.0, f64::max);
    let class = |number: usize| -((longest / sizes[number]).log2() + 0.5).floor() as i64;
    let is_edge = |number: usize| line.turn(seats[number]) < -SHARP;
    let mut order: Vec<usize> = (0..seats.len()).collect();
    order.sort_by_key(|&number| (!is_edge(number), class(number), number));
    let mut ranks = vec![0; seats.len()];
    for (rank, number) in order.into_iter().enumerate() {
        ranks[number] = rank;
    }
    ranks
}

/// Mean length of the faces about a seat [L].
fn fineness(line: &Undeformed, seat: usize) -> f64 {
    let about = seat.saturating_sub(ABOUT)..(seat + ABOUT).min(line.parts.len());
    let own = about.filter(|&part| line.parts[part] != Part::Gap);
    let lengths = own.map(|part| size(along_of(&line.reference, part)));
    let (sum, count) = lengths.fold((0.0, 0), |(sum, count), l| (sum + l, count + 1));
    sum / f64::from(count)
}
