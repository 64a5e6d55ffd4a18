//! Integrated contact: slave elements as segments of integration points.
//!
//! ```text
//!   o==:==:==:==:==:==:==:==o   a segment: smooth line over a slave element, in cells
//!              [x x x]          integration points follow the closed part of their cell
//!            ___________
//!           /  master   \
//! ```

use super::shear::{Shear, TURNS};
use super::stencil::{SectionTurn, Stencil};
use crate::state::PointState;
use slideline_mech::contact::gap::offset::Offset;
use slideline_mech::contact::points::integration_points::{
    GAUSS, HermiteLine, POINTS, closed_part_between,
};

/// Cells of a slave element along which contact is integrated.
pub const CELLS: usize = 8;

/// A slave element along which contact is integrated.
#[derive(Clone, Debug)]
pub struct SlaveSegment {
    /// Place of its pair in the model.
    pub pair: usize,
    /// Places of its nodes among the slave nodes of its pair.
    pub rows: [usize; 2],
    /// Its smooth line.
    pub line: HermiteLine,
    /// Dofs of both nodes.
    pub dofs: [usize; 6],
    /// What turns its tangents beyond its nodes, of shear-flexible beams.
    pub shear: Option<Shear>,
    /// Out-of-plane width [L].
    pub width: f64,
    /// How far surfaces stand off its line and its master.
    pub offset: Offset,
    /// Its first point; cell by cell, Gauss point by Gauss point.
    pub first: usize,
}

/// Points of a segment.
pub const SEGMENT_POINTS: usize = CELLS * POINTS;

impl SlaveSegment {
    /// Place on the element of one of its integration points while its cell is closed.
    pub fn resting_place(integration_point: usize) -> f64 {
        ((integration_point / POINTS) as f64 + GAUSS[integration_point % POINTS].0) / CELLS as f64
    }

    /// Areas of its points, with its cells wholly closed [L2].
    pub fn areas(&self) -> impl Iterator<Item = f64> {
        let whole = self.width * self.line.length();
        let cells = (0..CELLS).flat_map(|_| GAUSS);
        cells.map(move |(_, weight)| whole * weight / CELLS as f64)
    }

    /// Displacements and turns of both ends of its line.
    pub fn ends(&self, u: &[f64]) -> [f64; 6] {
        let mut ends = self.dofs.map(|dof| u[dof]);
        if let Some(shear) = &self.shear {
            let turns = shear.turns(&self.dofs, u);
            for (turn, by_shear) in TURNS.into_iter().zip(turns) {
                ends[turn] += by_shear;
            }
        }
        ends
    }

    /// Corners of boxes about its line at displacements of both ends of a way.
    pub fn hull(&self, u: &[Vec<f64>; 2]) -> [[[f64; 3]; 4]; 2] {
        [0, 1].map(|end| self.line.corners(&self.dofs.map(|dof| u[end][dof])))
    }

    /// The stencil of its integration point at `xi`, its ends known.
    pub fn stencil(&self, ends: &[f64; 6], xi: f64) -> Stencil<'_> {
        let mut stencil = Stencil::new(self.line.bent(ends).position(xi));
        stencil.add(&self.dofs, *ends);
        stencil.shear = self.shear.as_ref();
        stencil.offset = self.offset;
        stencil.section = self.section_turn(xi);
        stencil
    }

    /// The rotation of the section at `xi`, as the rotations of its nodes make it.
    fn section_turn(&self, xi: f64) -> SectionTurn {
        let [first, last] = TURNS.map(|turn| self.dofs[turn]);
        let rest = 1.0 - xi;
        match self.shear.as_ref().and_then(Shear::middle) {
            None => [(first, rest), (last, xi), (last, 0.0)],
            Some(middle) => [
                (first, rest * (1.0 - 2.0 * xi)),
                (middle, 4.0 * xi * rest),
                (last, xi * (2.0 * xi - 1.0)),
            ],
        }
    }

    /// All dofs that its line follows.
    pub fn all_dofs(&self) -> impl Iterator<Item = &usize> {
        let further = self.shear.iter().flat_map(|shear| &shear.further);
        self.dofs.iter().chain(further)
    }

    /// The part of a cell, in its own coordinate, whose points were closed at the last commit.
    pub(super) fn closed_before(&self, cell: usize, points: &[PointState]) -> Option<(f64, f64)> {
        let own = points.get(self.first + cell * POINTS..)?.get(..POINTS)?;
        if !own.iter().any(|point| point.closed) {
            return None;
        }
        let at = |point: &PointState| point.xi * CELLS as f64 - cell as f64;
        let (first, last) = (at(&own[0]), at(&own[POINTS - 1]));
        let length = (last - first) / (GAUSS[POINTS - 1].0 - GAUSS[0].0);
        let begin = first - GAUSS[0].0 * length;
        Some((begin.clamp(0.0, 1.0), (begin + length).clamp(0.0, 1.0)))
    }

    /// Places the integration points of the segment where `beyond`, the overclosure
    /// beyond the point where contact begins at a place on it, lets them
    /// follow the closed part of their cells, joined with what `kept` of a cell does not separate, and
    /// says which integration points contact may reach in an iteration:
    /// `place(integration_point, xi, area)`.
    pub(super) fn place_integration_points(
        &self,
        beyond: impl Fn(f64) -> f64,
        kept: impl Fn(usize) -> Option<(f64, f64)>,
        mut place: impl FnMut(usize, f64, f64),
    ) {
        let length = self.line.length();
        let is_far = |ends: [f64; 3]| top_of_parabola(ends) < -NEAR * length;
        let all_far = is_far([beyond(0.0), beyond(0.5), beyond(1.0)]);
        for cell in 0..CELLS {
            let kept = kept(cell);
            if all_far && kept.is_none() {
                continue;
            }
            let at = |t: f64| (cell as f64 + t) / CELLS as f64;
            let ends = [beyond(at(0.0)), beyond(at(0.5)), beyond(at(1.0))];
            if is_far(ends) && kept.is_none() {
                continue;
            }
            let part = closed_part_between(|t| beyond(at(t)), ends);
            let both = part.into_iter().chain(kept);
            let both = both.reduce(|one, other| (one.0.min(other.0), one.1.max(other.1)));
            let (begin, end) = both.unwrap_or((0.0, 1.0));
            for (k, (t, weight)) in GAUSS.into_iter().enumerate() {
                let area = self.width * length * weight * (end - begin) / CELLS as f64;
                place(cell * POINTS + k, at(begin + t * (end - begin)), area);
            }
        }
    }
}

/// How far beyond the reach of contact a cell is looked at, in lengths of its
/// element: what an iteration may move it.
const NEAR: f64 = 0.1;

/// Largest value on [0, 1] of the parabola through values at 0, 1/2 and 1.
fn top_of_parabola([left, middle, right]: [f64; 3]) -> f64 {
    let largest = left.max(middle).max(right);
    let bend = left - 2.0 * middle + right;
    let slope = right - left;
    if bend.is_nan() || bend >= 0.0 || slope.abs() >= -2.0 * bend {
        return largest;
    }
    middle - slope * slope / (8.0 * bend)
}
