//! The elements of a step: numbered by the plan, made of their kernels, gathered.
//!
//! ```text
//!   u --> element 1 --> [force | tangent]  \
//!   u --> element 2 --> [force | tangent]   >-- gather in fixed order --> f, K
//!   u --> element 3 --> [force | tangent]  /
//! ```
//!
//! Elements write forces of their own and a gather in fixed order sums them, so that
//! the sum has the same bits on any number of threads. Tangents are gathered a few
//! elements at a time, and never all stored. The dofs of all elements lie behind one
//! another: an element takes as much as it needs. What an element is, only its block's
//! kernel knows.

mod block;
mod evaluate;
mod flux;
mod kernels;
mod numbering;
#[cfg(test)]
mod tests;

pub use evaluate::{FailedElement, Gather, Product};
pub use flux::Flux;
pub use kernels::Kernels;
pub use numbering::ElementNumbering;

use crate::observe::BlockResults;
use block::Block;
use slideline_mech::element::{
    Failure, Kernel, MOST_NODES, MOST_VARIABLES, Strains, Surroundings, Temperature,
};
use slideline_mech::material::Clock;
use slideline_mech::turn::Turn;

/// All elements of a step at work: numbering of the plan, kernels of the values.
#[derive(Clone, Copy, Debug)]
pub struct Structure<'a> {
    /// Where elements stand and which dofs they have.
    pub numbering: &'a ElementNumbering,
    /// What they are.
    pub kernels: &'a Kernels,
    /// Elements with dofs that follow others.
    pub dependent: &'a [usize],
    /// Index of each tangent entry among the matrix values, element by element and row
    /// by row; `u32::MAX`: none.
    pub entries: &'a [u32],
    /// Temperatures of all nodes before the first step; empty: all are zero.
    pub initial: &'a [Temperature],
    /// Whether displacements may be large.
    pub nlgeom: bool,
    /// Largest EA/l [F/L], for the rounding floor of the residual.
    pub stiffest: f64,
    /// Length of the element that has it [L].
    pub stiffest_length: f64,
}

/// What is around the elements.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ambient<'a> {
    /// Temperatures, a node each; empty: all are zero and were.
    pub temperatures: &'a [Temperature],
    /// What rotations in space count from, a node each; empty: all from rest.
    pub turns: &'a [Turn],
    /// What the clock shows to the materials.
    pub clock: Clock,
}

/// What elements respond to.
#[derive(Clone, Copy, Debug)]
pub struct Configuration<'a> {
    /// Displacements and rotations, a dof each [L or 1].
    pub u: &'a [f64],
    /// Estimated stresses that the geometric stiffness is made of, where they are
    /// not those of the strains.
    pub stresses: Option<&'a [f64]>,
    /// Committed state variables of all elements.
    pub state: &'a [f64],
    /// Temperatures and time.
    pub ambient: Ambient<'a>,
}

/// What every element contributes, in dofs of its own.
#[derive(Clone, Debug, Default)]
pub struct Contributions {
    /// Forces of all elements, one after the other [F or F L].
    force: Vec<f64>,
    /// Strain energy of each element [F L], or why it has none.
    energy: Vec<Result<f64, Failure>>,
    /// State variables of the elements, one after the other, were this state
    /// committed.
    state: Vec<f64>,
    /// Tangents of the elements that are gathered at a time.
    few: Vec<f64>,
    /// Tangents of those with dofs that follow others, which are gathered last.
    last: Vec<f64>,
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

/// What the nodes of an element are in: temperatures now and before the first step, and what their
/// rotations count from.
struct AtNodes {
    now: [Temperature; MOST_NODES],
    initial: [Temperature; MOST_NODES],
    heated: usize,
    turns: [Turn; MOST_NODES],
    turning: usize,
}

impl Default for AtNodes {
    fn default() -> Self {
        let none = [Temperature::default(); MOST_NODES];
        let turns = [Turn::REST; MOST_NODES];
        Self { now: none, initial: none, heated: 0, turns, turning: 0 }
    }
}

impl AtNodes {
    /// What an element responds under.
    fn under<'a>(&'a self, strains: Strains<'a>, clock: Clock) -> Surroundings<'a> {
        let (temperatures, initial) = (&self.now[..self.heated], &self.initial[..self.heated]);
        Surroundings { strains, temperatures, initial, turns: self.turns(), clock }
    }

    fn turns(&self) -> &[Turn] {
        &self.turns[..self.turning]
    }
}

impl Structure<'_> {
    /// Room for what the elements contribute, empty.
    pub fn room(&self) -> Contributions {
        let mut room = Contributions::default();
        room.fit(self.numbering);
        room
    }

    /// All elements, each with its block and kernel.
    fn elements(&self) -> impl Iterator<Item = (&Block, &dyn Kernel, usize)> {
        let blocks = self.numbering.blocks.iter().zip(self.kernels.iter());
        blocks.flat_map(|(block, kernel)| block.elements.clone().map(move |e| (block, kernel, e)))
    }

    /// The block of an element, and its kernel.
    fn element(&self, element: usize) -> (&Block, &dyn Kernel) {
        let at = self.numbering.blocks.partition_point(|block| block.elements.end <= element);
        (&self.numbering.blocks[at], self.kernels.of(at))
    }

    /// The dofs of an element.
    fn own(&self, block: &Block, element: usize) -> &[usize] {
        &self.numbering.own[block.own(element)]
    }

    /// Room for the stresses of every element; none where strains are linear,
    /// for then there is no geometric stiffness.
    pub fn stress_room(&self) -> usize {
        if self.nlgeom { self.numbering.stresses } else { 0 }
    }

    /// The stresses that a linear solution with the `change` of all dofs
    /// arrives at from displacements `u`: docs/theory.md eq. (3.27).
    pub fn stresses_after(
        &self,
        u: &[f64],
        change: &[f64],
        ambient: &Ambient<'_>,
        into: &mut [f64],
    ) {
        if into.is_empty() {
            return;
        }
        let mut nodes = AtNodes::default();
        let (mut q, mut moved) = ([0.0; MOST_VARIABLES], [0.0; MOST_VARIABLES]);
        for (block, kernel, element) in self.elements() {
            let own = self.own(block, element);
            let (q, moved) = (&mut q[..own.len()], &mut moved[..own.len()]);
            for ((q, moved), &dof) in q.iter_mut().zip(&mut *moved).zip(own) {
                (*q, *moved) = (u[dof], change[dof]);
            }
            let into = &mut into[block.stresses(element)];
            let nodal = self.at_nodes(block, element, ambient, &mut nodes);
            let under = nodal.under(self.strains(), ambient.clock);
            kernel.stresses_after(block.number(element), q, moved, &under, into);
        }
    }

    /// Raises axial stresses that are next to none, in a model of size `reach`
    /// [L], to a slight tension: docs/theory.md eq. (3.30).
    pub fn tighten(&self, reach: f64, stresses: &mut [f64]) {
        if stresses.is_empty() {
            return;
        }
        for (block, kernel, element) in self.elements() {
            let own = &mut stresses[block.stresses(element)];
            kernel.tighten(block.number(element), reach, own);
        }
    }

    /// The largest turn of an element's nodes against each other [1], of the
    /// changes `of` the dofs.
    pub fn largest_bend(&self, of: impl Fn(usize) -> f64) -> f64 {
        let blocks = self.numbering.blocks.iter();
        let turning = blocks.filter(|block| block.translations < block.dofs.len());
        let elements = turning.flat_map(|block| block.elements.clone().map(move |e| (block, e)));
        let bend = |(block, element): (&Block, usize)| block.bend(self.own(block, element), &of);
        elements.map(bend).fold(0.0, f64::max)
    }

    /// What is around the nodes of an element.
    fn at_nodes<'n>(
        &self,
        block: &Block,
        element: usize,
        ambient: &Ambient<'_>,
        into: &'n mut AtNodes,
    ) -> &'n AtNodes {
        (into.heated, into.turning) = (0, 0);
        let nodes = &self.numbering.nodes[block.nodes(element)];
        if !ambient.temperatures.is_empty() {
            let of = |list: &[Temperature], node: usize| list.get(node).copied();
            for &node in nodes {
                into.now[into.heated] = of(ambient.temperatures, node).unwrap_or_default();
                into.initial[into.heated] = of(self.initial, node).unwrap_or_default();
                into.heated += 1;
            }
        }
        if !ambient.turns.is_empty() && block.turns_in_space() {
            for &node in nodes {
                into.turns[into.turning] = ambient.turns.get(node).copied().unwrap_or_default();
                into.turning += 1;
            }
        }
        into
    }

    /// How strains follow displacements in this step.
    fn strains(&self) -> Strains<'static> {
        if self.nlgeom { Strains::Exact } else { Strains::Linear }
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

    /// Adds the forces on dependent dofs with which a tangent turns: those of
    /// the stresses that its geometric stiffness is made of.
    pub fn turning_forces(
        &self,
        (u, turns): (&[f64], &[Turn]),
        stresses: Option<&[f64]>,
        from: &Contributions,
        into: &mut [f64],
    ) {
        let mut nodes = AtNodes::default();
        let ambient = Ambient { turns, ..Ambient::default() };
        let (mut q, mut own_force) = ([0.0; MOST_VARIABLES], [0.0; MOST_VARIABLES]);
        for &element in self.dependent {
            let (block, kernel) = self.element(element);
            let own = self.own(block, element);
            let (q, force) = (&mut q[..own.len()], &mut own_force[..own.len()]);
            q.iter_mut().zip(own).for_each(|(q, &dof)| *q = u[dof]);
            let estimated = stresses.filter(|_| self.nlgeom).is_some_and(|stresses| {
                let stresses = &stresses[block.stresses(element)];
                let turns = self.at_nodes(block, element, &ambient, &mut nodes).turns();
                kernel.force_of_stresses(block.number(element), (q, turns), stresses, force)
            });
            if !estimated {
                force.copy_from_slice(&from.force[block.own(element)]);
            }
            own.iter().zip(&*force).for_each(|(&dof, value)| into[dof] += value);
        }
    }

    /// Mean magnitude of the nodal forces and of the nodal moments of all
    /// elements, with the number of nodal vectors counted: the flux q.
    pub fn flux(&self, from: &Contributions) -> Flux {
        let mut flux = Flux::default();
        for (block, _, element) in self.elements() {
            block.count(&from.force[block.own(element)], &mut flux);
        }
        flux
    }

    /// Energy that the elements have taken for good [F L].
    pub fn dissipated(&self, u: &[f64], (state, ambient): (&[f64], Ambient<'_>)) -> f64 {
        let mut nodes = AtNodes::default();
        let mut variables = [0.0; MOST_VARIABLES];
        let blocks = self.numbering.blocks.iter().zip(self.kernels.iter());
        let mut sum = 0.0;
        for (block, kernel) in blocks {
            let q = &mut variables[..block.variables];
            for element in block.elements.clone() {
                let own = self.own(block, element);
                q.iter_mut().zip(own).for_each(|(q, &dof)| *q = u[dof]);
                let (number, state) = (block.number(element), &state[block.state(element)]);
                let nodal = self.at_nodes(block, element, &ambient, &mut nodes);
                let under = nodal.under(self.strains(), ambient.clock);
                sum += kernel.dissipated(number, q, state, &under);
            }
        }
        sum
    }

    /// By how much the creep strains of the increment that led to a state differ at most, taken by
    /// the conditions at its two ends [1].
    pub fn creep_difference(&self, state: &[f64]) -> f64 {
        let each = self.elements().filter(|(block, ..)| block.states > 0);
        let own = each.map(|(block, kernel, element)| {
            kernel.creep_difference(block.number(element), &state[block.state(element)])
        });
        own.fold(0.0, f64::max)
    }

    /// Results of all elements, block by block; room that `into` has is used again.
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
            into.members.clone_from(&block.members);
            into.values.resize(block.results * block.elements.len(), 0.0);
            let q = &mut variables[..block.variables];
            let values = into.values.chunks_exact_mut(block.results.max(1));
            for (element, values) in block.elements.clone().zip(values) {
                let own = self.own(block, element);
                q.iter_mut().zip(own).for_each(|(q, &dof)| *q = u[dof]);
                let (number, state) = (block.number(element), &state[block.state(element)]);
                let nodal = self.at_nodes(block, element, &ambient, &mut nodes);
                let under = nodal.under(self.strains(), ambient.clock);
                kernel.results(number, q, state, &under, values);
            }
        }
    }
}
