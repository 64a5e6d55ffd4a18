//! What elements exert that leave the model or come back to it.

use super::elements::{Ambient, AtNodes, Structure};
use super::evaluate::{FailedElement, ask};
use super::numbering::ElementNumbering;
use super::reference::Reference;
use slideline_mech::element::{MOST_VARIABLES, Response};
use slideline_model::ElementIndex;

/// Energy of elements [F L].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Held {
    /// What they would give back.
    pub stored: f64,
    /// What they have taken for good.
    pub dissipated: f64,
}

impl ElementNumbering {
    /// Number of elements.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Whether each element is one of `absent`, which ascend; empty where there are none.
    pub fn absent(&self, absent: &[ElementIndex]) -> Vec<bool> {
        let mut flags = Vec::new();
        if !absent.is_empty() {
            flags.resize(self.count, false);
            absent.iter().filter_map(|&own| self.index_of(own)).for_each(|own| flags[own] = true);
        }
        flags
    }

    /// The indices of the elements of a block of the model; `None`: they are rigid as a whole.
    pub fn of_block(&self, block: usize) -> Option<std::ops::Range<usize>> {
        self.blocks.iter().find(|own| own.block == block).map(|own| own.elements.clone())
    }

    /// The index of an element of the model; `None`: it is rigid as a whole.
    pub fn index_of(&self, (block, member): ElementIndex) -> Option<usize> {
        let own = self.blocks.iter().find(|own| own.block == block)?;
        let at = own.members.binary_search(&member).ok()?;
        Some(own.elements.start + at)
    }
}

impl Structure<'_> {
    /// Calls back with the forces of an element at a state, whether it is there or not, dof by dof
    /// [F or F L]; the energy that it holds.
    ///
    /// # Errors
    /// The element, where it has no answer.
    pub fn exert(
        &self,
        element: usize,
        (u, state, ambient): (&[f64], &[f64], &Ambient<'_>),
        mut call: impl FnMut(usize, f64),
    ) -> Result<Held, FailedElement> {
        let (block, kernel) = self.element(element);
        let mut nodes = AtNodes::default();
        let (mut q, mut force) = ([0.0; MOST_VARIABLES], [0.0; MOST_VARIABLES]);
        let (q, force) = (&mut q[..block.variables], &mut force[..block.variables]);
        self.read(block, element, u, q);
        let committed = &state[block.state(element)];
        let mut trial = vec![0.0; committed.len()];
        let under = self.at_nodes(block, element, ambient, &mut nodes);
        let under = under.under(self.strains(), ambient.clock);
        let into = Response { force: &mut *force, tangent: None, state: &mut trial };
        let number = block.number(element);
        let energy = ask(kernel, (number, q), (committed, &under), into);
        let energy = energy.map_err(|failure| {
            let member = block.members[number];
            FailedElement { block: block.block, member, failure }
        })?;
        let dissipated = kernel.dissipated(number, q, committed, &under);
        self.own(block, element).iter().zip(&*force).for_each(|(&dof, &f)| call(dof, f));
        Ok(Held { stored: energy - dissipated, dissipated })
    }

    /// The state variables of all elements, were they moved to `u` from `state`; those of an element
    /// that has no answer there stay.
    pub fn states_at(&self, u: &[f64], state: &[f64], ambient: &Ambient<'_>) -> Vec<f64> {
        let mut now = state.to_vec();
        let mut nodes = AtNodes::default();
        let (mut q, mut force) = ([0.0; MOST_VARIABLES], [0.0; MOST_VARIABLES]);
        for (block, kernel, element) in self.present().filter(|(block, ..)| block.states > 0) {
            let (q, force) = (&mut q[..block.variables], &mut force[..block.variables]);
            self.read(block, element, u, q);
            let under = self.at_nodes(block, element, ambient, &mut nodes);
            let under = under.under(self.strains(), ambient.clock);
            let own = block.state(element);
            let into = Response { force: &mut *force, tangent: None, state: &mut now[own.clone()] };
            let _ = ask(kernel, (block.number(element), q), (&state[own], &under), into);
        }
        now
    }

    /// The reference of an element that begins at a state.
    pub fn begin(&self, element: usize, u: &[f64], ambient: &Ambient<'_>) -> Reference {
        let (block, _) = self.element(element);
        let own = self.own(block, element);
        let nodes = &self.numbering.nodes[block.nodes(element)];
        let width = block.dofs.len().max(1);
        let turned = own.chunks_exact(width).zip(nodes).filter_map(|(own, &node)| {
            let rotations = own.get(block.translations..)?.first_chunk::<3>()?;
            let turn = ambient.turns.get(node).copied().unwrap_or_default();
            Some(turn.rotation(rotations.map(|dof| u[dof])))
        });
        let temperatures = nodes.iter().filter_map(|&node| ambient.temperatures.get(node).copied());
        Reference {
            element,
            displacement: own.iter().map(|&dof| u[dof]).collect(),
            turned: if block.turns_in_space() { turned.collect() } else { Vec::new() },
            temperatures: temperatures.collect(),
        }
    }

    /// The state variables of an element begin anew.
    pub fn renew(&self, element: usize, state: &mut [f64]) {
        let (block, _) = self.element(element);
        state[block.state(element)].fill(0.0);
    }
}
