//! The centre of an undeformed element, about which incompatible modes stand.

use super::place::{Place, Reference};
use super::recipe::Recipe;

/// The centre of an undeformed element.
#[derive(Debug, Clone, Copy)]
pub(super) struct Centre<const D: usize, const N: usize> {
    /// The point there; its weight is the volume a weight of the rule.
    pub place: Place<D, N>,
    /// (dX/dxi)^-1 there.
    pub inverse: [[f64; D]; D],
}

impl<const D: usize, const N: usize> Centre<D, N> {
    /// That of an element on the positions of its nodes [L].
    pub fn new(nodes: &[[f64; D]; N], at: &Reference<D, N>, recipe: &Recipe) -> Self {
        let (place, inverse) = Place::new(nodes, at, recipe);
        Self { place, inverse }
    }
}
