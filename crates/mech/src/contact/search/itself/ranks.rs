//! Which of two nodes of a line that meet is the slave.
//!
//! ```text
//!    o sharp edge    o fine    o coarse    o - o - o in their order
//!      first                                 last
//! ```
//!
//! docs/theory.md section 5.12. (derived)

use super::{Itself, Part, along_of, size};
use crate::contact::search::{cross, dot, sub};

/// Faces on either side of a node whose mean length tells how fine it is.
const ABOUT: usize = 4;
/// Turn at a node of the undeformed surface from which on it is a sharp edge [rad].
const SHARP: f64 = 50.0 * std::f64::consts::PI / 180.0;

impl Itself {
    /// Sharp edges that stand out come first, then what has shorter faces, in classes of twice the
    /// length, then all in their order: pointed and fine are the slaves of flat and coarse.
    pub(super) fn rank(&mut self) {
        let sizes: Vec<f64> = self.seats.iter().map(|&seat| self.fineness(seat)).collect();
        let longest = sizes.iter().copied().fold(0.0, f64::max);
        let class = |number: usize| -((longest / sizes[number]).log2() + 0.5).floor() as i64;
        let mut order: Vec<usize> = (0..self.seats.len()).collect();
        order.sort_by_key(|&number| (!self.is_edge(self.seats[number]), class(number), number));
        for (rank, number) in order.into_iter().enumerate() {
            self.ranks[number] = rank;
        }
    }

    /// Mean length of the faces about a seat [L].
    fn fineness(&self, seat: usize) -> f64 {
        let about = seat.saturating_sub(ABOUT)..(seat + ABOUT).min(self.parts.len());
        let own = about.filter(|&part| self.parts[part] != Part::Gap);
        let lengths = own.map(|part| size(sub(self.reference[part + 1], self.reference[part])));
        let (sum, count) = lengths.fold((0.0, 0), |(sum, count), l| (sum + l, count + 1));
        sum / f64::from(count)
    }

    /// Whether the surface turns away sharply at a seat: it stands out there.
    fn is_edge(&self, seat: usize) -> bool {
        self.turn(seat) < -SHARP
    }

    /// Angle by which the undeformed surface turns at a seat, to the left, where the outside is: an
    /// edge that stands out is negative, a valley positive; zero at an end [rad].
    pub(super) fn turn(&self, seat: usize) -> f64 {
        let mut sides = self.beside(seat).map(|side| along_of(&self.reference, side));
        let (Some(before), Some(behind)) = (sides.next(), sides.next()) else { return 0.0 };
        cross(before, behind).atan2(dot(before, behind))
    }
}
