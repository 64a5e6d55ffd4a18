//! Normals of a slave surface at its nodes: means of the faces that meet there.
//!
//! ```text
//!            n
//!      .-----o-----.       n is across the sum of the unit vectors of both legs
//!    leg 1       leg 2
//! ```
//!
//! docs/theory.md eq. (5.22)

use super::curve::{Place, add_scaled, dot, scale, zero};
use crate::differentiate::Real;

/// The normal between legs, of which there are one or two.
#[derive(Debug, Clone, Copy)]
pub struct MeanNormal<R> {
    /// Outward unit normal: on the right of travel [1].
    pub normal: Place<R>,
    /// Unit vector along travel [1].
    tangent: Place<R>,
    /// Length of the sum of the legs' unit vectors [1].
    sum: R,
    /// Unit vectors of the legs with their lengths.
    legs: [Option<(Place<R>, R)>; 2],
}

impl<R: Real> MeanNormal<R> {
    /// The normal between legs [L]; `None` where they cancel or have no length.
    pub fn new(legs: [Option<Place<R>>; 2]) -> Option<Self> {
        let unit = |leg: Place<R>| {
            let length = dot(leg, leg).sqrt();
            (scale(R::from_f64(1.0) / length, leg), length)
        };
        let legs = legs.map(|leg| leg.map(unit));
        let all = legs.iter().flatten();
        let along = all.fold(zero(), |sum, &(leg, _)| add_scaled(sum, R::from_f64(1.0), leg));
        let sum = dot(along, along).sqrt();
        let sound = sum.value() > f64::EPSILON && sum.value().is_finite();
        let tangent = scale(R::from_f64(1.0) / sum, along);
        let normal = [tangent[1], -tangent[0]];
        sound.then_some(Self { normal, tangent, sum, legs })
    }

    /// What a derivative by the normal is by the legs.
    pub fn pull(&self, by_normal: Place<R>) -> [Place<R>; 2] {
        let by_tangent = [-by_normal[1], by_normal[0]];
        let across = |unit: Place<R>, by: Place<R>, size: R| {
            scale(R::from_f64(1.0) / size, add_scaled(by, -dot(unit, by), unit))
        };
        let by_sum = across(self.tangent, by_tangent, self.sum);
        self.legs.map(|leg| leg.map_or(zero(), |(unit, length)| across(unit, by_sum, length)))
    }
}
