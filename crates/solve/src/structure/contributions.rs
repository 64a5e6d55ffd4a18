//! What every element contributes.

use super::numbering::ElementNumbering;
use crate::constraints::Carried;
use slideline_mech::element::Failure;

/// What every element contributes, in dofs of its own.
#[derive(Clone, Debug, Default)]
pub struct Contributions {
    /// Forces of all elements, one after the other [F or F L].
    pub(super) force: Vec<f64>,
    /// Strain energy of each element [F L], or why it has none.
    pub(super) energy: Vec<Result<f64, Failure>>,
    /// State variables of the elements, one after the other, were this state
    /// committed.
    pub(super) state: Vec<f64>,
    /// Tangents of the elements that are gathered at a time.
    pub(super) few: Vec<f64>,
    /// Tangents of those with dofs that follow others, which are gathered last.
    pub(super) last: Vec<f64>,
    /// Room to carry them over to what is followed.
    pub(super) carried: Carried,
}

impl Contributions {
    /// Strain energy of all elements [F L].
    pub fn energy(&self) -> f64 {
        self.energy.iter().flatten().fold(0.0, |sum, energy| sum + energy)
    }

    /// Makes room for the elements of a numbering.
    pub fn fit(&mut self, numbering: &ElementNumbering) {
        let states = numbering.blocks.iter().map(|block| block.states * block.elements.len());
        self.force.resize(numbering.own.len(), 0.0);
        self.energy.resize(numbering.count, Ok(0.0));
        self.state.resize(states.sum(), 0.0);
    }
}
