//! The elements of a step, each with its own dof for force and tangent.
//!
//! ```text
//!   u --> element 1 --> [force | tangent]  \
//!   u --> element 2 --> [force | tangent]   >-- gather in fixed order --> f, K
//!   u --> element 3 --> [force | tangent]  /
//! ```
//!
//! Elements write dofs of their own and a gather in fixed order sums them,
//! so that the sum has the same bits on any number of threads. The dofs of all
//! elements lie behind one another: an element takes as much as it needs. What an
//! element is, only its block's kernel knows.

mod block;
mod flux;
mod place;
#[cfg(test)]
mod tests;

pub use flux::Flux;

use crate::constraints::{Constraints, Rows};
use crate::observe::BlockResults;
use block::Block;
use rayon::ThreadPool;
use slideline_linalg::Pattern;
use slideline_mech::element::{MOST_VARIABLES, Response, Strains};
use std::ops::Range;

/// From this number of elements on, threads pay.
const PARALLEL: usize = 2000;
/// Elements that one thread takes at a time.
const SHARE: usize = 256;

/// All elements of a step.
#[derive(Clone, Debug, Default)]
pub struct Structure {
    blocks: Vec<Block>,
    /// Number of elements.
    count: usize,
    /// Dofs of the elements' own variables, element by element.
    own: Vec<usize>,
    /// Index of each tangent entry among the matrix values, row by row;
    /// `usize::MAX`: none.
    entries: Vec<usize>,
    /// Elements with dofs that follow others.
    dependent: Vec<usize>,
    nlgeom: bool,
    /// How many stresses the elements have.
    stresses: usize,
    /// Largest EA/l [F/L], for the rounding floor of the residual.
    pub stiffest: f64,
    /// Length of the element that has it [L].
    pub stiffest_length: f64,
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
}

/// What every element contributes, in dofs of its own.
#[derive(Clone, Debug)]
pub struct Contributions {
    /// Laid out as [`Structure::own`].
    force: Vec<f64>,
    /// Laid out as [`Structure::entries`].
    tangent: Vec<f64>,
    /// Strain energy of each element [F L].
    energy: Vec<f64>,
    /// State variables of the elements, one after the other, were this state
    /// committed.
    state: Vec<f64>,
}

impl Structure {
    /// Room for what the elements contribute, empty.
    pub fn room(&self) -> Contributions {
        let states = self.blocks.iter().map(|block| block.states * block.elements.len());
        Contributions {
            force: vec![0.0; self.own.len()],
            tangent: vec![0.0; self.entries.len()],
            energy: vec![0.0; self.count],
            state: vec![0.0; states.sum()],
        }
    }

    /// All elements, each with its block.
    fn elements(&self) -> impl Iterator<Item = (&Block, usize)> {
        self.blocks.iter().flat_map(|block| block.elements.clone().map(move |e| (block, e)))
    }

    /// An element with its block.
    fn element(&self, element: usize) -> (&Block, usize) {
        let at = self.blocks.partition_point(|block| block.elements.end <= element);
        (&self.blocks[at], element)
    }

    /// The elements with dofs that follow others.
    fn dependent(&self) -> impl Iterator<Item = (&Block, usize)> {
        self.dependent.iter().map(|&element| self.element(element))
    }

    /// Sets of dofs that couple.
    pub fn cliques(&self) -> impl Iterator<Item = &[usize]> {
        self.elements().map(|(block, element)| &self.own[block.own(element)])
    }

    /// How many sets [`Self::cliques`] gives, and their members in all.
    pub fn size_of_cliques(&self) -> (usize, usize) {
        (self.count, self.own.len())
    }

    /// Finds every tangent entry's place in the matrix.
    pub fn find_entries(&mut self, constraints: &Constraints, pattern: &Pattern) {
        let Self { blocks, own, entries, dependent, .. } = self;
        let elements =
            blocks.iter().flat_map(|block| block.elements.clone().map(move |e| (block, e)));
        for (block, element) in elements {
            if dependent.binary_search(&element).is_ok() {
                continue;
            }
            let own = &own[block.own(element)];
            let entries = &mut entries[block.entries(element)];
            let pairs = own.iter().flat_map(|&i| own.iter().map(move |&j| (i, j)));
            for (entry, (i, j)) in entries.iter_mut().zip(pairs) {
                *entry = match (constraints.equation(i), constraints.equation(j)) {
                    (Some(row), Some(column)) => {
                        pattern.position(row, column).unwrap_or(usize::MAX)
                    }
                    _ => usize::MAX,
                };
            }
        }
    }

    /// Whether each dof belongs to an element (rounding grows with those).
    pub fn touched(&self, dofs: usize) -> Vec<bool> {
        let mut touched = vec![false; dofs];
        for &dof in &self.own {
            touched[dof] = true;
        }
        touched
    }

    /// Room for the stresses of every element; none where strains are linear,
    /// for then there is no geometric stiffness.
    pub fn stress_room(&self) -> Vec<f64> {
        vec![0.0; if self.nlgeom { self.stresses } else { 0 }]
    }

    /// The stresses that a linear solution with the `change` of all dofs
    /// arrives at from displacements `u`: docs/theory.md eq. (3.27).
    pub fn stresses_after(&self, u: &[f64], change: &[f64], into: &mut [f64]) {
        if into.is_empty() {
            return;
        }
        let (mut q, mut moved) = ([0.0; MOST_VARIABLES], [0.0; MOST_VARIABLES]);
        for (block, element) in self.elements() {
            let own = &self.own[block.own(element)];
            let (q, moved) = (&mut q[..own.len()], &mut moved[..own.len()]);
            for ((q, moved), &dof) in q.iter_mut().zip(&mut *moved).zip(own) {
                (*q, *moved) = (u[dof], change[dof]);
            }
            let into = &mut into[block.stresses(element)];
            block.kernel.stresses_after(block.number(element), q, moved, into);
        }
    }

    /// Raises axial stresses that are next to none, in a model of size `reach`
    /// [L], to a slight tension: docs/theory.md eq. (3.30).
    pub fn tighten(&self, reach: f64, stresses: &mut [f64]) {
        if stresses.is_empty() {
            return;
        }
        for (block, element) in self.elements() {
            let own = &mut stresses[block.stresses(element)];
            block.kernel.tighten(block.number(element), reach, own);
        }
    }

    /// The largest turn of an element's nodes against each other [1], of the
    /// changes `of` the dofs.
    pub fn largest_bend(&self, of: impl Fn(usize) -> f64) -> f64 {
        let bend =
            |(block, element): (&Block, usize)| block.bend(&self.own[block.own(element)], &of);
        let turning = self.blocks.iter().filter(|block| block.translations < block.dofs.len());
        let elements = turning.flat_map(|block| block.elements.clone().map(move |e| (block, e)));
        elements.map(bend).fold(0.0, f64::max)
    }

    /// Evaluates every element, each into its own place; with estimates of the
    /// stresses these make the geometric stiffness.
    pub fn evaluate(
        &self,
        at: &Configuration<'_>,
        into: &mut Contributions,
        pool: Option<&ThreadPool>,
    ) {
        let at = Configuration { stresses: at.stresses.filter(|_| self.nlgeom), ..*at };
        let part = Part {
            elements: 0..self.count,
            force: &mut into.force,
            tangent: Some(&mut into.tangent),
            energy: &mut into.energy,
            state: &mut into.state,
        };
        self.evaluate_all(&at, part, pool);
    }

    /// Evaluates forces, energies and states alone: tangents stay as they are. The
    /// bits are those of [`Structure::evaluate`].
    pub fn evaluate_forces(
        &self,
        at: &Configuration<'_>,
        into: &mut Contributions,
        pool: Option<&ThreadPool>,
    ) {
        let at = Configuration { stresses: None, ..*at };
        let part = Part {
            elements: 0..self.count,
            force: &mut into.force,
            tangent: None,
            energy: &mut into.energy,
            state: &mut into.state,
        };
        self.evaluate_all(&at, part, pool);
    }

    fn evaluate_all(&self, at: &Configuration<'_>, part: Part<'_>, pool: Option<&ThreadPool>) {
        match pool.filter(|_| self.count >= PARALLEL) {
            Some(pool) => pool.install(|| self.evaluate_shared(at, part)),
            None => self.evaluate_part(at, part),
        }
    }

    /// Halves a part until one thread can take it.
    fn evaluate_shared(&self, at: &Configuration<'_>, part: Part<'_>) {
        if part.elements.len() <= SHARE {
            return self.evaluate_part(at, part);
        }
        let (first, second) = self.halve(part);
        rayon::join(|| self.evaluate_shared(at, first), || self.evaluate_shared(at, second));
    }

    fn halve<'a>(&self, part: Part<'a>) -> (Part<'a>, Part<'a>) {
        let Range { start, end } = part.elements;
        let middle = start + (end - start) / 2;
        let [mut width, mut square, mut states] = [0; 3];
        for block in &self.blocks {
            let own = block.elements.start.max(start)..block.elements.end.min(middle);
            width += own.len() * block.variables;
            square += own.len() * block.variables * block.variables;
            states += own.len() * block.states;
        }
        let (force, other_force) = part.force.split_at_mut(width);
        let (tangent, other_tangent) = part.tangent.map(|all| all.split_at_mut(square)).unzip();
        let (energy, other_energy) = part.energy.split_at_mut(middle - start);
        let (state, other_state) = part.state.split_at_mut(states);
        (
            Part { elements: start..middle, force, tangent, energy, state },
            Part {
                elements: middle..end,
                force: other_force,
                tangent: other_tangent,
                energy: other_energy,
                state: other_state,
            },
        )
    }

    fn evaluate_part(&self, at: &Configuration<'_>, mut part: Part<'_>) {
        let mut variables = [0.0; MOST_VARIABLES];
        let first = self.blocks.partition_point(|block| block.elements.end <= part.elements.start);
        for block in &self.blocks[first..] {
            let elements = block.elements.start.max(part.elements.start)
                ..block.elements.end.min(part.elements.end);
            let (kernel, width) = (&*block.kernel, block.variables);
            let q = &mut variables[..width];
            for element in elements {
                let own = &self.own[block.own(element)];
                q.iter_mut().zip(own).for_each(|(q, &dof)| *q = at.u[dof]);
                let strains = match at.stresses {
                    Some(stresses) => Strains::Mixed(&stresses[block.stresses(element)]),
                    None => self.strains(),
                };
                let Some((energy, into)) = part.take(width, block.states) else { return };
                let committed = &at.state[block.state(element)];
                *energy = kernel.respond(block.number(element), q, committed, strains, into);
            }
        }
    }

    /// How strains follow displacements in this step.
    fn strains(&self) -> Strains<'static> {
        if self.nlgeom { Strains::Exact } else { Strains::Linear }
    }

    /// Copies the trial state of the elements to where a commit keeps it.
    pub fn gather_state(&self, from: &Contributions, into: &mut [f64]) {
        let mut rest: &[f64] = &from.state;
        for (block, element) in self.elements().filter(|(block, _)| block.states > 0) {
            let (own, behind) = rest.split_at(block.states);
            into[block.state(element)].copy_from_slice(own);
            rest = behind;
        }
    }

    /// Sums forces into the full vector; returns the strain energy [F L].
    pub fn gather_force(&self, from: &Contributions, force: &mut [f64]) -> f64 {
        for (&dof, value) in self.own.iter().zip(&from.force) {
            force[dof] += value;
        }
        from.energy.iter().fold(0.0, |sum, energy| sum + energy)
    }

    /// Sums tangents into the matrix values of a pattern.
    pub fn gather_tangent(
        &self,
        from: &Contributions,
        (constraints, rows, pattern): (&Constraints, &Rows, &Pattern),
        values: &mut [f64],
    ) {
        for (&entry, value) in self.entries.iter().zip(&from.tangent) {
            if let Some(sum) = values.get_mut(entry) {
                *sum += value;
            }
        }
        for (block, element) in self.dependent() {
            let own = &self.own[block.own(element)];
            let tangent = &from.tangent[block.entries(element)];
            let at = |i: usize, j: usize| tangent[i * own.len() + j];
            constraints.scatter((rows, pattern), own, at, values);
        }
    }

    /// Adds the forces on dependent dofs with which a tangent turns: those of
    /// the stresses that its geometric stiffness is made of.
    pub fn turning_forces(
        &self,
        u: &[f64],
        stresses: Option<&[f64]>,
        from: &Contributions,
        into: &mut [f64],
    ) {
        let (mut q, mut own_force) = ([0.0; MOST_VARIABLES], [0.0; MOST_VARIABLES]);
        for (block, element) in self.dependent() {
            let own = &self.own[block.own(element)];
            let (q, force) = (&mut q[..own.len()], &mut own_force[..own.len()]);
            q.iter_mut().zip(own).for_each(|(q, &dof)| *q = u[dof]);
            let estimated = stresses.filter(|_| self.nlgeom).is_some_and(|stresses| {
                let stresses = &stresses[block.stresses(element)];
                block.kernel.force_of_stresses(block.number(element), q, stresses, force)
            });
            if !estimated {
                force.copy_from_slice(&from.force[block.own(element)]);
            }
            own.iter().zip(&*force).for_each(|(&dof, value)| into[dof] += value);
        }
    }

    /// Sums K v for a full vector v of dofs into `product` (a first guess of
    /// what a prescribed motion does).
    pub fn multiply(&self, from: &Contributions, v: &[f64], product: &mut [f64]) {
        for (block, element) in self.elements() {
            let own = &self.own[block.own(element)];
            let rows = from.tangent[block.entries(element)].chunks_exact(block.variables);
            for (&target, row) in own.iter().zip(rows) {
                let sum: f64 = row.iter().zip(own).map(|(k, &dof)| k * v[dof]).sum();
                product[target] += sum;
            }
        }
    }

    /// Mean magnitude of the nodal forces and of the nodal moments of all
    /// elements, with the number of nodal vectors counted: the flux q.
    pub fn flux(&self, from: &Contributions) -> Flux {
        let mut flux = Flux::default();
        for (block, element) in self.elements() {
            block.count(&from.force[block.own(element)], &mut flux);
        }
        flux
    }

    /// Results of all elements, block by block; room that `into` has is used again.
    pub fn results(&self, u: &[f64], state: &[f64], into: &mut Vec<BlockResults>) {
        into.resize_with(self.blocks.len(), BlockResults::default);
        let mut variables = [0.0; MOST_VARIABLES];
        for (block, into) in self.blocks.iter().zip(into) {
            into.block = block.block;
            into.members.clone_from(&block.members);
            into.values.resize(block.results * block.elements.len(), 0.0);
            let q = &mut variables[..block.variables];
            let values = into.values.chunks_exact_mut(block.results.max(1));
            for (element, values) in block.elements.clone().zip(values) {
                let own = &self.own[block.own(element)];
                q.iter_mut().zip(own).for_each(|(q, &dof)| *q = u[dof]);
                let (number, state) = (block.number(element), &state[block.state(element)]);
                block.kernel.results(number, q, state, self.strains(), values);
            }
        }
    }
}

/// Elements that lie together, with their dofs.
struct Part<'a> {
    elements: Range<usize>,
    force: &'a mut [f64],
    /// `None`: forces only.
    tangent: Option<&'a mut [f64]>,
    energy: &'a mut [f64],
    state: &'a mut [f64],
}

impl<'a> Part<'a> {
    /// The dofs of the next element.
    fn take(&mut self, width: usize, states: usize) -> Option<(&'a mut f64, Response<'a>)> {
        let force = self.force.split_off_mut(..width)?;
        let tangent = match &mut self.tangent {
            Some(rest) => Some(rest.split_off_mut(..width * width)?),
            None => None,
        };
        let state = self.state.split_off_mut(..states)?;
        Some((self.energy.split_off_first_mut()?, Response { force, tangent, state }))
    }
}
