//! The direction of the profile of a surface of revolution, seen from above its axis.
//!
//! ```text
//!            o now             over an increment the profile is that of the meridian through the middle of
//!           /                  both places; a point that leaves the pole goes along its profile
//!    axis  +---- middle
//!           \
//!            o before
//! ```
//!
//! [docs/theory.md, section 7]

use super::swept::{ON_AXIS, Sweep, Swept};
use crate::vector::{Vector, dot, sub};

/// A place on a swept surface: its chart and the coordinates there.
pub type SweptPlace = (usize, [f64; 2]);

impl Swept {
    /// Whether a place of a surface of revolution is in a pole, where the profile has no direction.
    pub fn is_pole(&self, place: SweptPlace) -> bool {
        let [x, y] = self.across_axis(place);
        self.sweep == Sweep::Around && x.hypot(y) <= self.rounding(place)
    }

    /// The direction of the profile where a point stands that stood elsewhere `before`, in space; `normal` is
    /// that of the surface now [1]. `None` where it has no direction, and of a surface drawn along a line.
    pub fn profile_of_way(
        &self,
        (markers, normal): (&[Vector], Vector),
        [before, now]: [SweptPlace; 2],
    ) -> Option<Vector> {
        if self.sweep == Sweep::Along {
            return None;
        }
        let (from, to) = (self.across_axis(before), self.across_axis(now));
        let middle = [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])];
        let unit = |[x, y]: [f64; 2], least: f64| {
            let size = x.hypot(y);
            (size > least).then(|| [x / size, y / size])
        };
        let least = self.rounding(before).max(self.rounding(now));
        let away = unit(middle, least)?;
        let along = |k: usize| dot(normal, sub(markers[k + 1], markers[0])) / self.length;
        // the normal is on the left of the profile's travel
        let outward = unit(to, 0.0).map_or(0.0, |own| own[0] * along(0) + own[1] * along(1));
        let (radial, axial) = (along(2), -outward);
        Some(self.direction(markers, [radial * away[0], radial * away[1], axial]))
    }

    /// Coordinates across the axis over the distance of the markers [1].
    fn across_axis(&self, (chart, at): SweptPlace) -> [f64; 2] {
        let [x, y, _] = self.chart(chart).coordinates(at);
        [x.value, y.value]
    }

    /// What counts as on the axis over the distance of the markers [1].
    fn rounding(&self, (chart, _): SweptPlace) -> f64 {
        ON_AXIS * self.size(chart / 2) / self.length
    }
}
