//! How deep an edge may stand in an edge that it crosses before it is held, where the pair carries already.
//!
//! docs/theory.md section 5.18

use super::places::Found;
use super::sides::{EdgeCrossings, EdgeSide};
use crate::contact::before::Before;
use crate::contact::held_edges::depth_allowed;
use crate::contact::pairs::Contact;
use crate::state::PointState;
use slideline_mech::contact::gap::edges::EdgeGap;
use slideline_mech::vector::{Vector, dot};

/// Cosine of the angle between the normals of a point and of a crossing from which on its gap is another one [1]: 45 degrees.
const ALONG: f64 = std::f64::consts::FRAC_1_SQRT_2;

impl Contact {
    /// What a crossing is allowed in the next increment [L]. docs/theory.md eqs (5.49) and (5.53)
    pub(super) fn crossing_allowance(
        &self,
        own: &EdgeCrossings,
        (place, found): (usize, &Found),
        before: Before<'_>,
    ) -> f64 {
        let Some(now) = before.points.get(place) else { return 0.0 };
        let stood = now.footing.filter(|_| now.opening.is_finite() && now.along.is_some());
        let stood =
            stood.map(|own| own.place).filter(|_| self.continues(own, place, found, before));
        let (edges, at, gap, normal) = match stood {
            Some(stood) => (own.edges(stood.face), stood.at, now.opening - now.allowed, now.normal),
            None => match gap_before(own, found, before) {
                Some(gap) => (found.edges, gap.at, gap.gap, gap.normal),
                None => return 0.0,
            },
        };
        let raw = |point: usize| self.gap_along(point, normal, before.points);
        let means = own.sides().into_iter().zip(edges).zip(at);
        let means = means.filter_map(|((side, edge), share)| mean(side, (edge, share), raw));
        means.reduce(f64::min).map_or(0.0, |mean| depth_allowed(mean, gap, self.spacing[own.of]))
    }

    /// The gap of a point that faces the other side within 45 degrees of the normal of a crossing [L]: what stands before
    /// a flank of an edge says nothing of the edge.
    fn gap_along(&self, point: usize, normal: Vector, before: &[PointState]) -> Option<f64> {
        let now = before.get(point).filter(|now| now.opening.is_finite())?;
        let sign = if self.is_reversed(self.points[point].pair) { -1.0 } else { 1.0 };
        (sign * dot(now.normal, normal) > ALONG).then_some(now.opening - now.allowed)
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

/// The gap of two edges at the last commit, along the normal on the side of the one of now.
fn gap_before(own: &EdgeCrossings, found: &Found, before: Before<'_>) -> Option<EdgeGap> {
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
