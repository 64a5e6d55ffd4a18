//! How deep an edge may stand in an edge that it crosses before it is held, where the pair carries already.
//!
//! docs/theory.md section 5.18

use super::places::Found;
use super::sides::{EdgeCrossings, EdgeSide};
use crate::contact::before::Before;
use crate::contact::held_edges::EdgeStand;
use crate::contact::pairs::Contact;
use crate::state::{PointState, State};
use slideline_mech::contact::gap::edges::EdgeGap;
use slideline_mech::contact::search::faces::FacePlace;
use slideline_mech::vector::{Vector, dot};

/// Cosine of the angle between the normals of a point and of a crossing from which on its gap is another one [1]: 45 degrees.
const ALONG: f64 = std::f64::consts::FRAC_1_SQRT_2;

impl Contact {
    /// What a crossing is allowed [L]. docs/theory.md eqs (5.49) and (5.53)
    pub(super) fn crossing_allowance(
        &self,
        own: &EdgeCrossings,
        (place, found): (usize, &Found),
        before: Before<'_>,
    ) -> f64 {
        let stood = match self.continues(own, place, found, before) {
            true => before.points.get(place).and_then(CrossingStood::of),
            false => None,
        };
        let came = || {
            let gap = gap_before(own, found, before)?;
            let place = FacePlace { face: own.number(found.edges), at: gap.at };
            Some(CrossingStood { place, gap: gap.gap, normal: gap.normal, is_held: false })
        };
        let stand =
            stood.or_else(came).and_then(|stood| self.stand_of_edges(own, &stood, before.points));
        stand.map_or(0.0, |stand| self.allowance(&stand, own.of))
    }

    /// How a crossing of a state stands in the other side.
    fn stand_of_crossing(&self, place: usize, points: &[PointState]) -> Option<EdgeStand> {
        let first = self.pair_count() - self.crossings.len();
        let own = self.crossings.get(self.points[place].pair.checked_sub(first)?)?;
        let stood = CrossingStood::of(points.get(place)?)?;
        self.stand_of_edges(own, &stood, points)
    }

    /// Notes which edges of pairs that do not separate stand by themselves in a state.
    pub fn note_alone(&self, state: &mut State) {
        for place in self.places_of_edges() {
            let point = &self.points[place];
            if self.keeps[point.pair] && state.points[place].closed {
                let stand = match point.is_crossing {
                    true => self.stand_of_crossing(place, &state.points),
                    false => self.stand_of_edge(place, &state.points),
                };
                let alone = stand.is_none_or(|stand| stand.is_alone());
                state.points[place].stands_alone = alone;
            }
        }
    }

    fn stand_of_edges(
        &self,
        own: &EdgeCrossings,
        stood: &CrossingStood,
        points: &[PointState],
    ) -> Option<EdgeStand> {
        let FacePlace { face, at } = stood.place;
        let raw = |point: usize| self.gap_along(point, stood.normal, points);
        let means = own.sides().into_iter().zip(own.edges(face)).zip(at);
        let means = means.filter_map(|((side, edge), share)| mean(side, (edge, share), raw));
        let (mean, size) = (means.reduce(f64::min)?, self.spacing[own.of]);
        Some(EdgeStand { mean, gap: stood.gap, size, is_held: stood.is_held })
    }

    /// The gap of a point that faces the other side within 45 degrees of the normal of a crossing [L]: what stands before
    /// a flank of an edge says nothing of the edge.
    fn gap_along(&self, point: usize, normal: Vector, points: &[PointState]) -> Option<f64> {
        let now = points.get(point).filter(|now| now.opening.is_finite())?;
        let sign = if self.is_reversed(self.points[point].pair) { -1.0 } else { 1.0 };
        (sign * dot(now.normal, normal) > ALONG).then_some(now.raw_gap())
    }

    /// Whether a point at the last commit was the same crossing: of the same lines.
    pub(super) fn continues(
        &self,
        own: &EdgeCrossings,
        place: usize,
        found: &Found,
        before: Before<'_>,
    ) -> bool {
        let stood = before.points.get(place).and_then(|point| point.footing);
        stood.is_some_and(|stood| own.lines(own.edges(stood.place.face)) == own.lines(found.edges))
    }
}

/// Where a crossing stood.
struct CrossingStood {
    /// The number of its edges, and the place on both.
    place: FacePlace,
    /// [L]
    gap: f64,
    normal: Vector,
    is_held: bool,
}

impl CrossingStood {
    /// That of a state which faces anything.
    fn of(point: &PointState) -> Option<Self> {
        let footing = point.footing.filter(|_| point.opening.is_finite() && point.along.is_some());
        let (place, gap) = (footing?.place, point.raw_gap());
        Some(Self { place, gap, normal: point.normal, is_held: point.closed })
    }
}

/// The gap of two edges at the last commit, along the normal on the side of the one of now.
pub(super) fn gap_before(
    own: &EdgeCrossings,
    found: &Found,
    before: Before<'_>,
) -> Option<EdgeGap> {
    let is_known = !before.u.is_empty();
    is_known.then(|| EdgeGap::new(own.ends(found.edges, before.u), found.gap.normal)).flatten()
}

/// The mean gap that nodes about a place of an edge show by those of their points, where these have any [L].
/// docs/theory.md eq. (5.53)
fn mean(
    side: &EdgeSide,
    (edge, share): (usize, f64),
    gap: impl Fn(usize) -> Option<f64>,
) -> Option<f64> {
    let own = &side.edges[edge];
    let long = own.part.end - own.part.start;
    let share = (own.part.start + share.clamp(0.0, 1.0) * long).clamp(0.0, 1.0);
    let (mut shares, mut gaps) = (0.0, 0.0);
    for (corner, share) in own.corners.into_iter().zip([1.0 - share, share]) {
        let points = side.nodes[corner].points.iter();
        let least = points.filter_map(|&point| gap(point)).reduce(f64::min);
        if let Some(least) = least.filter(|_| share > 0.0) {
            (shares, gaps) = (shares + share, gaps + share * least);
        }
    }
    (shares > 0.0).then(|| gaps / shares)
}
