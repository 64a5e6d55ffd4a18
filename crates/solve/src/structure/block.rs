//! The elements of a block: where they stand among all others.

use super::flux::Flux;
use slideline_model::Dof;
use std::ops::Range;

/// Elements of one type and section. All have the same numbers of everything, so
/// that the first index of each list leads to all.
#[derive(Clone, Debug)]
pub struct Block {
    /// Indices among the structure's elements.
    pub elements: Range<usize>,
    /// Dofs of every node, translations first.
    pub dofs: &'static [Dof],
    /// How many of those are translations.
    pub translations: usize,
    /// Number of an element's variables, and of its stresses that may be estimated.
    pub variables: usize,
    pub estimates: usize,
    /// Where the nodes of the first element begin, and how many an element has.
    pub first_node: usize,
    pub width: usize,
    /// Where the dofs, tangent entries and stresses of the first element begin.
    pub first_own: usize,
    pub first_entry: usize,
    pub first_stress: usize,
    /// Index of their block in the model, and of each element in that block.
    pub block: usize,
    pub members: Vec<usize>,
    /// Where the state variables of the model's block begin, and how many an element
    /// has.
    pub first_state: usize,
    pub states: usize,
    /// Number of results of an element.
    pub results: usize,
}

impl Block {
    /// Whether its nodes have rotations in space.
    pub fn turns_in_space(&self) -> bool {
        self.dofs.len() >= self.translations + 3
    }

    pub fn own(&self, element: usize) -> Range<usize> {
        let first = self.first_own + self.variables * (element - self.elements.start);
        first..first + self.variables
    }

    pub fn nodes(&self, element: usize) -> Range<usize> {
        let first = self.first_node + self.width * (element - self.elements.start);
        first..first + self.width
    }

    pub fn entries(&self, element: usize) -> Range<usize> {
        let size = self.variables * self.variables;
        let first = self.first_entry + size * (element - self.elements.start);
        first..first + size
    }

    pub fn stresses(&self, element: usize) -> Range<usize> {
        let first = self.first_stress + self.estimates * (element - self.elements.start);
        first..first + self.estimates
    }

    /// Its number in the kernel.
    pub fn number(&self, element: usize) -> usize {
        element - self.elements.start
    }

    /// State variables of an element among those of the model.
    pub fn state(&self, element: usize) -> Range<usize> {
        let first = self.first_state + self.states * self.members[self.number(element)];
        first..first + self.states
    }

    /// Counts the forces and moments at the nodes of an element.
    pub fn count(&self, force: &[f64], flux: &mut Flux) {
        for node in force.chunks_exact(self.dofs.len().max(1)) {
            let (forces, moments) = node.split_at(self.translations);
            if !forces.is_empty() {
                flux.force(forces.iter().map(|f| f * f).sum::<f64>().sqrt());
            }
            moments.iter().for_each(|moment| flux.moment(moment.abs()));
        }
    }

    /// The largest difference between rotations of an element's nodes about one axis.
    pub fn bend(&self, own: &[usize], of: impl Fn(usize) -> f64) -> f64 {
        let width = self.dofs.len();
        let mut largest = 0.0_f64;
        for axis in self.translations..width {
            let turns = own.iter().skip(axis).step_by(width).map(|&dof| of(dof));
            let (low, high) = turns.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), turn| {
                (l.min(turn), h.max(turn))
            });
            largest = largest.max(high - low);
        }
        largest
    }
}
