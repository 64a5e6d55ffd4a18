//! The numbers of a cloud of nodes whose mean motion others follow.
//!
//! ```text
//!     o   o               s  hangs at a face: shares of its nodes
//!       + . . R           |  make the foot of the lever
//!     o   o            o--+----o
//! ```
//!
//! Arms are from the weighted centre, the lever of the reference node from where its shares take it.

use slideline_mech::axes::PLAIN;
use slideline_mech::best_fit::Matrix;
use slideline_mech::vector::{Vector, cross, scale, sub};
use slideline_model::{Axes, Hung, MeanMotion, Model};

/// A cloud in its undeformed shape.
#[derive(Clone, Debug, Default)]
pub(super) struct Cloud {
    /// Weights, of the sum one [1].
    pub weights: Vec<f64>,
    /// Shares in the displacement along each axis, of the sum one [1].
    pub shares: Vec<Vector>,
    /// Arms of its nodes [L].
    pub arms: Vec<Vector>,
    /// What each of them makes of a small turn, a row a direction of it, but for a factor [L].
    pub turns: Vec<Matrix>,
    /// Levers of the reference node along each axis [L].
    pub levers: [Vector; 3],
    /// The longest of all arms [L].
    pub size: f64,
    /// Whether it is of faces, whose turn is not the one that fits the weights best.
    pub is_of_faces: bool,
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
        let is_of_faces = !mean.hung.is_empty();
        let shares: Vec<Vector> = match is_of_faces {
            true => mean.hung.iter().map(|own| own.shares).collect(),
            false => weights.iter().map(|&weight| [weight; 3]).collect(),
        };
        let lever = |axis: usize| {
            let parts = shares.iter().zip(&places);
            let foot = |k: usize| parts.clone().map(|(own, at)| own[axis] * at[k]).sum();
            sub(place(mean.reference), [0, 1, 2].map(foot))
        };
        let levers = [0, 1, 2].map(lever);
        let longest = |most: f64, arm: &Vector| most.max(slideline_mech::vector::size(*arm));
        let size = arms.iter().chain(&levers).fold(0.0, longest);
        let turns = match is_of_faces {
            true => mean.hung.iter().map(|own| turn_of_face(own, size)).collect(),
            false => weights.iter().zip(&arms).map(|(&w, &arm)| best_fit(w, arm)).collect(),
        };
        Self { weights, shares, arms, turns, levers, size, is_of_faces }
    }
}

/// What the displacement of a node of a face makes of a turn [L].
fn turn_of_face(own: &Hung, size: f64) -> Matrix {
    own.turn.map(|row| scale(row, size * size))
}

/// What that of a node of a cloud makes of the turn that fits it best, w r x u [L].
fn best_fit(weight: f64, arm: Vector) -> Matrix {
    PLAIN.map(|axis| scale(cross(axis, arm), weight))
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
