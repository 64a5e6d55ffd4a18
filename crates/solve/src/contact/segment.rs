//! Integrated contact: slave elements, and parts of rigid profiles, as segments of integration points.
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
use slideline_mech::contact::pair::{CarriedStretch, Stretch};
use slideline_mech::contact::points::integration_points::{
    BentLine, GAUSS, HermiteLine, POINTS, closed_part_between, closed_part_of_one_top,
};
use slideline_mech::rigid::Attachment;

/// Cells of a slave element along which contact is integrated.
pub const CELLS: usize = 8;

/// Segments of a segment of a profile.
pub const STRETCHES: usize = 4;

/// What a segment lies along.
#[derive(Clone, Copy, Debug)]
#[allow(clippy::large_enum_variant)] // a box would allocate in the Newton loop
pub enum Along {
    /// A beam: the smooth line between its nodes.
    Beam(HermiteLine),
    /// A part of a profile, carried by the reference node of its body.
    Profile(Stretch),
}

/// The same in its current state.
pub enum Placed {
    /// A beam.
    Beam(BentLine),
    /// A part of a profile.
    Profile(CarriedStretch),
}

impl Placed {
    /// Position at `xi` in [0, 1] [L].
    #[inline]
    pub fn position(&self, xi: f64) -> [f64; 3] {
        match self {
            Self::Beam(line) => line.position(xi),
            Self::Profile(stretch) => stretch.position(xi),
        }
    }
}

impl Along {
    /// Undeformed length [L].
    pub fn length(&self) -> f64 {
        match self {
            Self::Beam(line) => line.length(),
            Self::Profile(stretch) => stretch.length(),
        }
    }

    /// Undeformed position at `xi` [L].
    pub fn reference(&self, xi: f64) -> [f64; 3] {
        let [x, y] = match self {
            Self::Beam(line) => line.reference(xi),
            Self::Profile(stretch) => stretch.reference(xi),
        };
        [x, y, 0.0]
    }

    /// It at displacements and turns of its ends, or of its body.
    #[inline]
    pub fn placed(&self, ends: &[f64; 6]) -> Placed {
        match self {
            Self::Beam(line) => Placed::Beam(line.bent(ends)),
            Self::Profile(stretch) => {
                let [x, y, turn, ..] = *ends;
                Placed::Profile(stretch.carried([x, y, turn]))
            }
        }
    }

    /// How the place at `xi` follows the dofs of its segment.
    pub fn attachment(&self, xi: f64) -> Attachment {
        match self {
            Self::Beam(line) => Attachment::Blend { blend: line.blend(xi), firsts: [0, 3] },
            Self::Profile(stretch) => stretch.attachment(xi),
        }
    }

    /// How far it leads on at `xi`, over its length [1].
    fn speed(&self, xi: f64) -> f64 {
        match self {
            Self::Beam(_) => 1.0,
            Self::Profile(stretch) => stretch.speed(xi),
        }
    }

    /// Number of dofs that it follows.
    fn width(&self) -> usize {
        match self {
            Self::Beam(_) => 6,
            Self::Profile(_) => 3,
        }
    }

    /// Corners of boxes about it for its dofs.
    fn corners(&self, ends: &[f64; 6]) -> [[f64; 3]; 4] {
        match self {
            Self::Beam(line) => line.corners(ends),
            Self::Profile(stretch) => {
                // no place is further from an end than its length
                let (placed, room) = (self.placed(ends), stretch.length());
                let [[a, b, _], [c, d, _]] = [0.0, 1.0].map(|end| placed.position(end));
                [
                    [a - room, b - room, 0.0],
                    [a + room, b + room, 0.0],
                    [c - room, d - room, 0.0],
                    [c + room, d + room, 0.0],
                ]
            }
        }
    }
}

/// A slave element along which contact is integrated, or a part of a profile.
#[derive(Clone, Debug)]
pub struct SlaveSegment {
    /// Place of its pair in the model.
    pub pair: usize,
    /// Places of its nodes among the slave nodes of its pair.
    pub rows: [usize; 2],
    /// What it lies along.
    pub line: Along,
    /// Dofs of both nodes; of a profile those of its body's reference node, twice.
    dofs: [usize; 6],
    /// What turns its tangents beyond its nodes, of shear-flexible beams.
    pub shear: Option<Shear>,
    /// Out-of-plane width [L].
    pub width: f64,
    /// How far surfaces stand off its line and its master.
    pub offset: Offset,
    /// How far beyond the reach of contact its cells are looked at [L].
    pub near: f64,
    /// Its first point; cell by cell, Gauss point by Gauss point.
    pub first: usize,
}

/// Points of a segment.
pub const SEGMENT_POINTS: usize = CELLS * POINTS;

impl SlaveSegment {
    /// That of a beam between nodes with these dofs.
    pub fn of_beam((pair, rows): (usize, [usize; 2]), dofs: [usize; 6], first: usize) -> Self {
        let line = Along::Beam(HermiteLine::new([[0.0; 3]; 2], [[0.0; 3]; 2]));
        let (shear, width, offset, near) = (None, 0.0, Offset::NONE, 0.0);
        Self { pair, rows, line, dofs, shear, width, offset, near, first }
    }

    /// A part of a profile that is carried by a node with these dofs.
    pub fn of_profile(
        pair: usize,
        stretch: Stretch,
        [x, y, turn]: [usize; 3],
        first: usize,
    ) -> Self {
        let (line, dofs, rows) = (Along::Profile(stretch), [x, y, turn, x, y, turn], [0, 0]);
        let (shear, width, offset, near) = (None, 0.0, Offset::NONE, 0.0);
        Self { pair, rows, line, dofs, shear, width, offset, near, first }
    }

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

    /// Whether it lies along a beam.
    pub fn is_of_beam(&self) -> bool {
        matches!(self.line, Along::Beam(_))
    }

    /// The dofs that it follows directly.
    pub fn own_dofs(&self) -> &[usize] {
        &self.dofs[..self.line.width()]
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

    /// Position at `xi` of a part of a profile [L]; none of a beam.
    pub fn place_on_profile(&self, xi: f64, u: &[f64]) -> Option<[f64; 3]> {
        matches!(self.line, Along::Profile(_)).then(|| self.line.placed(&self.ends(u)).position(xi))
    }

    /// Corners of boxes about its line at displacements of both ends of a way.
    pub fn hull(&self, u: &[Vec<f64>; 2]) -> [[[f64; 3]; 4]; 2] {
        [0, 1].map(|end| self.line.corners(&self.dofs.map(|dof| u[end][dof])))
    }

    /// The stencil of its integration point at `xi`, its ends known.
    pub fn stencil(&self, ends: &[f64; 6], xi: f64) -> Stencil<'_> {
        let mut stencil = Stencil::new(self.line.placed(ends).position(xi));
        stencil.add(self.own_dofs(), *ends);
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
        self.own_dofs().iter().chain(further)
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
        let is_far = |ends: [f64; 3], part: f64| match &self.line {
            Along::Beam(_) => top_of_parabola(ends) < -self.near,
            Along::Profile(_) => top_of_distance(ends, part * length) < -self.near,
        };
        let all_far = is_far([beyond(0.0), beyond(0.5), beyond(1.0)], 1.0);
        for cell in 0..CELLS {
            let kept = kept(cell);
            if all_far && kept.is_none() {
                continue;
            }
            let at = |t: f64| (cell as f64 + t) / CELLS as f64;
            let ends = [beyond(at(0.0)), beyond(at(0.5)), beyond(at(1.0))];
            if is_far(ends, 1.0 / CELLS as f64) && kept.is_none() {
                continue;
            }
            let of_cell = |t: f64| beyond(at(t));
            let part = match &self.line {
                Along::Beam(_) => closed_part_between(of_cell, ends),
                Along::Profile(_) => {
                    let (part, closed) = closed_part_of_one_top(of_cell, ends);
                    Some(part).filter(|_| closed || kept.is_none())
                }
            };
            let both = part.into_iter().chain(kept);
            let both = both.reduce(|one, other| (one.0.min(other.0), one.1.max(other.1)));
            let (begin, end) = both.unwrap_or((0.0, 1.0));
            for (k, (t, weight)) in GAUSS.into_iter().enumerate() {
                let xi = at(begin + t * (end - begin));
                let area = self.width * length * weight * (end - begin) / CELLS as f64;
                place(cell * POINTS + k, xi, area * self.line.speed(xi));
            }
        }
    }
}

/// How far beyond the reach of contact a cell is looked at, in lengths of its
/// element or of its profile: what an iteration may move it.
pub const NEAR: f64 = 0.1;

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

/// What a function that changes by no more than the way along a stretch of `length` [L] is at most, with
/// these values at 0, 1/2 and 1: the distance of a body from a place.
fn top_of_distance([left, middle, right]: [f64; 3], length: f64) -> f64 {
    let half = 0.5 * length;
    let between = |a: f64, b: f64| match (a.is_finite(), b.is_finite()) {
        (true, true) => 0.5 * (a + b + half),
        // one end faces nothing: the body ends between them
        _ => a.max(b) + half,
    };
    between(left, middle).max(between(middle, right))
}
