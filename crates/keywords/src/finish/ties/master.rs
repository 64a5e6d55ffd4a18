//! Faces that are tied to.
//!
//! ```text
//!    +--------------+
//!    |  o-------o   |   a face, the box around it, and how far from it
//!    +--------------+   slave nodes may lie
//! ```

use slideline_mech::pressure::{Face, Nearest};
use slideline_model::NodeIndex;

use crate::draft::Draft;

/// Fraction of the size of a master face within which slave nodes are tied, where the card gives no
/// tolerance. [Abaqus manual, `*TIE`]
pub(super) const TOLERANCE: f64 = 0.05;

/// The same of what touches: a tolerance of zero ties it, though rounding leaves a distance.
pub(super) const TOUCHING: f64 = 1e-6;

/// A face of the master with its nodes and the box around it [L].
pub(super) struct Master {
    pub face: Face,
    pub nodes: Vec<NodeIndex>,
    pub x: Vec<[f64; 3]>,
    pub low: [f64; 3],
    pub high: [f64; 3],
    /// Diagonal of the box [L].
    pub size: f64,
}

impl Master {
    pub fn new(face: Face, nodes: Vec<NodeIndex>, draft: &Draft) -> Self {
        let x: Vec<[f64; 3]> =
            nodes.iter().map(|&node| draft.model.nodes.get(node).position).collect();
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for k in 0..3 {
            low[k] = x.iter().fold(low[k], |low, x| low.min(x[k]));
            high[k] = x.iter().fold(high[k], |high, x| high.max(x[k]));
        }
        let size = (0..3).map(|k| (high[k] - low[k]).powi(2)).sum::<f64>().sqrt();
        Self { face, nodes, x, low, high, size }
    }

    /// How far away slave nodes may lie to be tied to it [L].
    pub fn reach(&self, tolerance: Option<f64>) -> f64 {
        tolerance.unwrap_or(TOLERANCE * self.size).max(TOUCHING * self.size)
    }

    /// Distance of a point from the box [L]: no place of a straight face is nearer.
    pub fn at_least(&self, point: [f64; 3]) -> f64 {
        let beyond = |k: usize| (self.low[k] - point[k]).max(point[k] - self.high[k]).max(0.0);
        (0..3).map(|k| beyond(k).powi(2)).sum::<f64>().sqrt()
    }

    /// How far a curved face may leave its box [L].
    pub fn bulge(&self) -> f64 {
        0.25 * self.size
    }
}

/// The master face that comes nearest to a point.
pub(super) fn nearest(masters: &[Master], point: [f64; 3]) -> Option<(usize, Nearest)> {
    let mut best: Option<(usize, Nearest)> = None;
    for (place, master) in masters.iter().enumerate() {
        let least = master.at_least(point) - master.bulge();
        if best.as_ref().is_some_and(|(_, own)| own.distance < least) {
            continue;
        }
        let near = master.face.nearest(&master.x, point);
        if best.as_ref().is_none_or(|(_, own)| near.distance < own.distance) {
            best = Some((place, near));
        }
    }
    best
}
