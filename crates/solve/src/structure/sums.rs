//! What the elements come to together: forces, states, flux, dissipation, results.

use super::block::Block;
use super::contributions::Contributions;
use super::elements::{Ambient, AtNodes, Structure};
use super::flux::Flux;
use crate::observe::results::BlockResults;
use slideline_mech::element::MOST_VARIABLES;

impl Structure<'_> {
    /// The largest turn of an element's nodes against each other [1], of the
    /// changes `of` the dofs.
    pub fn largest_bend(&self, of: impl Fn(usize) -> f64) -> f64 {
        let blocks = self.numbering.blocks.iter();
        let turning = blocks.filter(|block| block.translations < block.dofs.len());
        let elements = turning.flat_map(|block| block.elements.clone().map(move |e| (block, e)));
        let elements = elements.filter(|&(_, element)| self.has(element));
        let bend = |(block, element): (&Block, usize)| block.bend(self.own(block, element), &of);
        elements.map(bend).fold(0.0, f64::max)
    }

    /// Copies the trial state of the elements to where a commit keeps it.
    pub fn gather_state(&self, from: &Contributions, into: &mut [f64]) {
        let mut rest: &[f64] = &from.state;
        for (block, _, element) in self.elements().filter(|(block, ..)| block.states > 0) {
            let (own, behind) = rest.split_at(block.states);
            into[block.state(element)].copy_from_slice(own);
            rest = behind;
        }
    }

    /// Sums forces into the full vector; returns the strain energy [F L].
    pub fn gather_force(&self, from: &Contributions, force: &mut [f64]) -> f64 {
        for (&dof, value) in self.numbering.own.iter().zip(&from.force) {
            force[dof] += value;
        }
        from.energy()
    }

    /// Mean magnitude of the nodal forces and of the nodal moments of all
    /// elements, with the number of nodal vectors counted: the flux q.
    pub fn flux(&self, from: &Contributions) -> Flux {
        let mut flux = Flux::default();
        for (block, _, element) in self.present() {
            block.count(&from.force[block.own(element)], &mut flux);
        }
        flux
    }

    /// By how much the creep strains of the increment that led to a state differ at most, taken by
    /// the conditions at its two ends [1].
    pub fn creep_difference(&self, state: &[f64]) -> f64 {
        let each = self.present().filter(|(block, ..)| block.states > 0);
        let own = each.map(|(block, kernel, element)| {
            kernel.creep_difference(block.number(element), &state[block.state(element)])
        });
        own.fold(0.0, f64::max)
    }

    /// Energy that the elements have taken for good [F L].
    pub fn dissipated(&self, u: &[f64], (state, ambient): (&[f64], Ambient<'_>)) -> f64 {
        if state.is_empty() {
            return 0.0; // what remembers nothing has taken nothing
        }
        let mut nodes = AtNodes::default();
        let mut variables = [0.0; MOST_VARIABLES];
        let blocks = self.numbering.blocks.iter().zip(self.kernels.iter());
        let mut sum = 0.0;
        for (block, kernel) in blocks {
            let q = &mut variables[..block.variables];
            for element in block.elements.clone().filter(|&element| self.has(element)) {
                self.read(block, element, u, q);
                let (number, state) = (block.number(element), &state[block.state(element)]);
                let nodal = self.at_nodes(block, element, &ambient, &mut nodes);
                let under = nodal.under(self.strains(), ambient.clock);
                sum += kernel.dissipated(number, q, state, &under);
            }
        }
        sum
    }

    /// Results of the elements that are there, block by block; room that `into` has is used again.
    pub fn results(
        &self,
        u: &[f64],
        (state, ambient): (&[f64], Ambient<'_>),
        into: &mut Vec<BlockResults>,
    ) {
        let mut nodes = AtNodes::default();
        into.resize_with(self.numbering.blocks.len(), BlockResults::default);
        let mut variables = [0.0; MOST_VARIABLES];
        let blocks = self.numbering.blocks.iter().zip(self.kernels.iter());
        for ((block, kernel), into) in blocks.zip(into) {
            into.block = block.block;
            let there = || block.elements.clone().filter(|&element| self.has(element));
            into.members.clear();
            into.members.reserve(block.elements.len());
            into.members.extend(there().map(|element| block.members[block.number(element)]));
            into.values.resize(block.results * into.members.len(), 0.0);
            let q = &mut variables[..block.variables];
            let values = into.values.chunks_exact_mut(block.results.max(1));
            for (element, values) in there().zip(values) {
                self.read(block, element, u, q);
                let (number, state) = (block.number(element), &state[block.state(element)]);
                let nodal = self.at_nodes(block, element, &ambient, &mut nodes);
                let under = nodal.under(self.strains(), ambient.clock);
                kernel.results(number, q, state, &under, values);
            }
        }
    }
}
