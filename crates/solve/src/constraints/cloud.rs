//! The numbers of a cloud of nodes whose mean motion others follow.
//!
//! ```text
//!     o   o
//!       + . . R     arms from the weighted centre, that of the reference node with them
//!     o   o
//! ```

use slideline_mech::axes::PLAIN;
use slideline_mech::vector::{Vector, sub};
use slideline_model::{Axes, MeanMotion, Model};

/// A cloud in its undeformed shape.
#[derive(Clone, Debug, Default)]
pub(super) struct Cloud {
    /// Weights, of the sum one [1].
    pub weights: Vec<f64>,
    /// Arms of its nodes [L].
    pub arms: Vec<Vector>,
    /// That of the reference node [L].
    pub lever: Vector,
    /// The longest of all arms [L].
    pub size: f64,
}

impl Cloud {
    /// That of a mean motion of a model.
    pub fn of(model: &Model, mean: &MeanMotion) -> Self {
        let total: f64 = mean.cloud.iter().map(|(_, weight)| weight).sum();
        let weights: Vec<f64> = mean.cloud.iter().map(|(_, weight)| weight / total).collect();
        let nodes = mean.cloud.iter().map(|&(node, _)| node);
        let first = nodes.clone().next().unwrap_or(mean.reference);
        // from one of its nodes, so that no distant origin is rounded
        let origin = model.nodes.position(first);
        let place = |node| sub(model.nodes.position(node), origin);
        let places: Vec<Vector> = nodes.map(place).collect();
        let sum = |k: usize| weights.iter().zip(&places).map(|(w, at)| w * at[k]).sum();
        let centre: Vector = [0, 1, 2].map(sum);
        let arms: Vec<Vector> = places.iter().map(|&at| sub(at, centre)).collect();
        let lever = sub(place(mean.reference), centre);
        let longest = |most: f64, arm: &Vector| most.max(slideline_mech::vector::size(*arm));
        let size = arms.iter().fold(0.0, longest);
        Self { weights, arms, lever, size: longest(size, &lever) }
    }
}

/// A cloud with the own axes of nodes that have some.
#[derive(Clone, Copy, Debug)]
pub(super) struct CloudNumbers<'a> {
    /// The cloud.
    pub cloud: &'a Cloud,
    /// All own axes.
    pub axes: &'a [Axes],
}

impl CloudNumbers<'_> {
    /// The axes of a node by its place among those with axes of their own.
    pub fn axes_of(&self, place: Option<usize>) -> Axes {
        place.and_then(|place| self.axes.get(place)).copied().unwrap_or(PLAIN)
    }
}
