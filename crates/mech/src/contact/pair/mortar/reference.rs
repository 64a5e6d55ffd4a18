//! A slave face before any motion: what an integral along it is weighted with.
//!
//! Pressures are forces on undeformed area, as everywhere in contact here, so that the measure of
//! an integral over a slave face does not change as it deforms.
//! [docs/theory.md, eq. (5.21)]

use super::super::super::points::Across;
use super::curve::{Curve, Place, dot};
use crate::differentiate::Real;

/// A slave face, undeformed, and how far contact reaches across the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reference {
    curve: Curve<f64>,
    across: Across,
}

impl Reference {
    /// The face over control points, of which there are two or three.
    pub fn new(controls: &[[f64; 3]], across: Across) -> Self {
        let at = |k: usize| controls.get(k).map_or([0.0; 2], |&[x, y, _]| [x, y]);
        let controls_of = std::array::from_fn(at);
        let curve = Curve { controls: controls_of, count: controls.len().clamp(2, 3), weight: 1.0 };
        Self { curve, across }
    }

    /// Number of control points.
    pub fn count(&self) -> usize {
        self.curve.count
    }

    /// Area of a stretch dt of the parameter at t, and its derivative [L2].
    pub fn measure<R: Real>(&self, t: R) -> [R; 2] {
        let constant = |place: Place<f64>| place.map(R::from_f64);
        let controls = self.curve.controls.map(constant);
        let curve = Curve { controls, count: self.curve.count, weight: 1.0 };
        let own = curve.shapes(t);
        let along = curve.blend(&own.slope);
        let length = dot(along, along).sqrt();
        let by_t = match self.curve.count {
            2 => R::from_f64(0.0),
            _ => dot(along, curve.blend(&[2.0, -4.0, 2.0].map(R::from_f64))) / length,
        };
        match self.across {
            Across::Width(width) => [length, by_t].map(|own| R::from_f64(width) * own),
            Across::Ring => {
                let turn = R::from_f64(std::f64::consts::TAU);
                let radius = curve.blend(&own.value)[0];
                [turn * radius * length, turn * (along[0] * length + radius * by_t)]
            }
        }
    }
}
