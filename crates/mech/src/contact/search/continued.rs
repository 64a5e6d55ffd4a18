//! Segments that continue a chain beyond its ends: the other end of a ring, the image in a plane of symmetry.
//!
//! ```text
//!    4 5 [0 1 2 3 4 5] 0 1      a ring is met at its own segments; those beside its seam tell its curves there
//!    2'1'[0 1 2 3 . .           an image is met too
//! ```
//!
//! docs/theory.md section 5.3.

use super::chain::{Chain, Piece, PieceKind, flat};
use super::{cross, dot, project_line, sub};

impl Chain {
    /// So many segments before and behind continue it: the arc begins behind the former, and what a ring is met at are
    /// its own segments.
    pub fn continue_by(&mut self, [before, behind]: [usize; 2]) {
        self.own = before..self.lengths.len() - behind;
        let begin = self.arc[before];
        self.arc.iter_mut().for_each(|arc| *arc -= begin);
    }

    /// Whether a segment is one of its own.
    pub fn is_own(&self, index: usize) -> bool {
        self.own.contains(&index)
    }

    /// Whether points are met at a segment, and at the corner where that begins: a ring has each once.
    pub(super) fn is_met(&self, index: usize) -> bool {
        !self.is_ring || self.is_own(index)
    }

    /// The segment of a ring, or the node at which that begins, for which one that continues it stands.
    pub(super) fn met(&self, index: usize) -> usize {
        match self.is_met(index) {
            true => index,
            false => {
                let (start, count) = (self.own.start, self.own.len());
                start + (index + count - start % count) % count
            }
        }
    }

    /// The same of a piece.
    pub fn met_piece(&self, piece: Piece) -> Piece {
        let index = self.met(piece.index);
        let kind = match (piece.kind, self.curve(index)) {
            (PieceKind::Curve { .. }, Some(curve)) => PieceKind::Curve { first: curve.first },
            (kind, _) => kind,
        };
        Piece { index, kind, parameter: piece.parameter }
    }

    /// Overclosure [L] that a point beyond an end would have against the straight line that prolongs
    /// the nearer end; `None` where no end lies behind it.
    pub fn beyond_end(&self, positions: &[[f64; 3]], point: [f64; 3]) -> Option<f64> {
        let point = flat(point);
        if self.own.len() < self.lengths.len() && self.is_ring {
            return None;
        }
        let last = self.lengths.len().checked_sub(1)?;
        let ends = [(0, 0.0), (last, 1.0)].into_iter().filter_map(|(index, end)| {
            let (a, b) = (flat(*positions.get(index)?), flat(*positions.get(index + 1)?));
            let xi = project_line(a, b, point)?;
            let beyond = if end == 0.0 { xi < 0.0 } else { xi > 1.0 };
            let apart = sub(point, if end == 0.0 { a } else { b });
            let overclosure = -cross(sub(b, a), sub(point, a)) / sub(b, a)[0].hypot(sub(b, a)[1]);
            beyond.then_some((dot(apart, apart), overclosure))
        });
        ends.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, overclosure)| overclosure)
    }
}
