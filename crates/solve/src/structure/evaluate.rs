//! Every element evaluated, a few at a time, their tangents gathered in order.
//!
//! ```text
//!   elements   |  0 .. 31  | 32 .. 63  | ...      forces: each its own place
//!   tangents   [ the same room, again and again ] --> matrix values
//! ```
//!
//! With threads more elements are taken at a time and shared out; what is summed, and in
//! which order, is the same.

use super::contributions::Contributions;
use super::elements::{AtNodes, Configuration, Structure};
use crate::constraints::{Carried, Constraints, Rows};
use rayon::ThreadPool;
use slideline_linalg::Pattern;
use slideline_mech::element::{Failure, Kernel, MOST_VARIABLES, Response, Strains, Surroundings};
use std::ops::Range;

/// From this number of elements on, threads pay.
pub(super) const PARALLEL: usize = 2000;
/// Elements that one thread takes at a time.
const SHARE: usize = 32;
/// Elements whose tangents one thread gathers at a time: they stay in the cache next to
/// it.
const FEW: usize = 32;
/// Shares that threads work on before their tangents are gathered.
const SHARES: usize = 16;

/// Where tangents are summed.
pub struct Gather<'a> {
    /// How dependent dofs follow the others.
    pub constraints: Constraints<'a>,
    /// The same at this configuration.
    pub rows: &'a Rows,
    /// The pattern of the values.
    pub pattern: &'a Pattern,
    /// Matrix values, overwritten [F/L and the like].
    pub values: &'a mut [f64],
    /// What the tangents do with a vector, where that is wanted too.
    pub product: Option<Product<'a>>,
    /// Tangents that are kept too, where that is wanted.
    pub keep: Option<Keep<'a>>,
}

/// Elements whose tangents are kept.
pub struct Keep<'a> {
    /// The elements, ascending.
    pub elements: &'a [usize],
    /// Where their tangents are written, one after the other, row by row.
    pub into: &'a mut Vec<f64>,
}

/// K v of all elements, in all dofs.
pub struct Product<'a> {
    /// v, a dof each.
    pub vector: &'a [f64],
    /// Where K v is added.
    pub into: &'a mut [f64],
}

impl Structure<'_> {
    /// Evaluates every element: forces, energies and states each into its own place,
    /// tangents into the sums of `gather`. With estimates of the stresses these make the
    /// geometric stiffness.
    pub fn evaluate(
        &self,
        at: &Configuration<'_>,
        into: &mut Contributions,
        mut gather: Gather<'_>,
        pool: Option<&ThreadPool>,
    ) {
        let at = Configuration { stresses: at.stresses.filter(|_| self.nlgeom), ..*at };
        let pool = pool.filter(|_| self.numbering.count >= PARALLEL);
        let few = if pool.is_some() { SHARES * SHARE } else { FEW };
        let Contributions { force, energy, state, few: room, last, carried } = into;
        last.clear();
        gather.values.fill(0.0);
        let mut rest =
            Part { elements: 0..self.numbering.count, force, tangent: None, energy, state };
        while !rest.elements.is_empty() {
            let (mut now, later) = self.split(rest, few);
            let [_, square, _] = self.sizes(now.elements.clone());
            // all of it is written before it is read
            if room.len() < square {
                room.resize(square, 0.0);
            }
            let elements = now.elements.clone();
            now.tangent = Some(&mut room[..square]);
            self.evaluate_all(&at, now, pool);
            self.gather_tangents(elements, room, &mut gather, last);
            rest = later;
        }
        self.gather_last(last, &mut gather, carried);
    }

    /// Evaluates forces, energies and states alone. The bits are those of
    /// [`Structure::evaluate`].
    pub fn evaluate_forces(
        &self,
        at: &Configuration<'_>,
        into: &mut Contributions,
        pool: Option<&ThreadPool>,
    ) {
        let at = Configuration { stresses: None, ..*at };
        let Contributions { force, energy, state, .. } = into;
        let part = Part { elements: 0..self.numbering.count, force, tangent: None, energy, state };
        self.evaluate_all(&at, part, pool.filter(|_| self.numbering.count >= PARALLEL));
    }

    pub(super) fn evaluate_all(
        &self,
        at: &Configuration<'_>,
        part: Part<'_>,
        pool: Option<&ThreadPool>,
    ) {
        match pool {
            Some(pool) => pool.install(|| self.evaluate_shared(at, part)),
            None => self.evaluate_part(at, part),
        }
    }

    /// Halves a part until one thread can take it.
    fn evaluate_shared(&self, at: &Configuration<'_>, part: Part<'_>) {
        if part.elements.len() <= SHARE {
            return self.evaluate_part(at, part);
        }
        let half = part.elements.len() / 2;
        let (first, second) = self.split(part, half);
        rayon::join(|| self.evaluate_shared(at, first), || self.evaluate_shared(at, second));
    }

    /// Forces, tangent entries and states of elements that lie together.
    pub(super) fn sizes(&self, elements: Range<usize>) -> [usize; 3] {
        let mut sizes = [0; 3];
        for block in &self.numbering.blocks {
            let (start, end) = (block.elements.start, block.elements.end);
            let own = start.max(elements.start)..end.min(elements.end);
            let width = block.variables;
            for (sum, each) in sizes.iter_mut().zip([width, width * width, block.states]) {
                *sum += own.len() * each;
            }
        }
        sizes
    }

    /// The first `count` elements of a part, and the others.
    fn split<'a>(&self, part: Part<'a>, count: usize) -> (Part<'a>, Part<'a>) {
        let Range { start, end } = part.elements;
        let middle = end.min(start + count);
        let [width, square, states] = self.sizes(start..middle);
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
        let mut nodes = AtNodes::default();
        let all = part.elements.clone();
        let blocks = self.numbering.blocks.iter().zip(self.kernels.iter());
        for (block, kernel) in blocks.skip_while(|(block, _)| block.elements.end <= all.start) {
            let elements = block.elements.start.max(all.start)..block.elements.end.min(all.end);
            let width = block.variables;
            let q = &mut variables[..width];
            for element in elements {
                let Some((energy, into)) = part.take(width, block.states) else { return };
                let committed = &at.state[block.state(element)];
                if !self.has(element) {
                    *energy = absent(committed, into);
                    continue;
                }
                self.read(block, element, at.u, q);
                let strains = match at.stresses {
                    Some(stresses) => Strains::Mixed(&stresses[block.stresses(element)]),
                    None => self.strains(),
                };
                let nodal = self.at_nodes(block, element, &at.ambient, &mut nodes);
                let under = nodal.under(strains, at.ambient.clock);
                *energy = ask(kernel, (block.number(element), q), (committed, &under), into);
            }
        }
    }

    /// Sums the tangents of elements that lie together; keeps those with dofs that follow
    /// others.
    fn gather_tangents(
        &self,
        elements: Range<usize>,
        tangents: &[f64],
        gather: &mut Gather<'_>,
        last: &mut Vec<f64>,
    ) {
        let mut rest = tangents;
        for block in &self.numbering.blocks {
            let (start, end) = (block.elements.start, block.elements.end);
            let own = start.max(elements.start)..end.min(elements.end);
            if own.is_empty() {
                continue;
            }
            let square = block.variables * block.variables;
            let (tangents, behind) = rest.split_at(own.len() * square);
            rest = behind;
            let entries = &self.entries[block.entries(own.start).start..][..tangents.len()];
            for (&entry, value) in entries.iter().zip(tangents) {
                if let Some(sum) = gather.values.get_mut(entry as usize) {
                    *sum += value;
                }
            }
            let begin = self.dependent.partition_point(|&element| element < own.start);
            for &element in self.dependent[begin..].iter().take_while(|e| own.contains(e)) {
                let at = (element - own.start) * square;
                last.extend_from_slice(&tangents[at..at + square]);
            }
            if let Some(Keep { elements, into }) = &mut gather.keep {
                let begin = elements.partition_point(|&element| element < own.start);
                for element in elements[begin..].iter().take_while(|e| own.contains(e)) {
                    let at = (element - own.start) * square;
                    into.extend_from_slice(&tangents[at..at + square]);
                }
            }
            if let Some(product) = &mut gather.product {
                let width = block.variables.max(1);
                let each = own.zip(tangents.chunks_exact(square.max(1)));
                each.for_each(|(e, tangent)| product.add(self.own(block, e), tangent, width));
            }
        }
    }

    /// Sums the tangents of elements with dofs that follow others.
    fn gather_last(&self, last: &[f64], gather: &mut Gather<'_>, carried: &mut Carried) {
        let mut rest = last;
        for &element in self.dependent {
            let (block, _) = self.element(element);
            let own = self.own(block, element);
            let (tangent, behind) = rest.split_at(own.len() * own.len());
            rest = behind;
            let onto = (gather.rows, gather.pattern);
            gather.constraints.scatter_element(onto, (own, tangent), gather.values, carried);
        }
    }
}

/// An element that has no answer where it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FailedElement {
    /// Index of its block in the model.
    pub block: usize,
    /// Its number among the elements of the block.
    pub member: usize,
    /// Why.
    pub failure: Failure,
}

impl Structure<'_> {
    /// The first element that has no answer.
    pub fn failed(&self, of: &Contributions) -> Option<FailedElement> {
        let failed = of.energy.iter().enumerate().find_map(|(e, energy)| Some((e, energy.err()?)));
        let (element, failure) = failed?;
        let (block, _) = self.element(element);
        let member = block.members[block.number(element)];
        Some(FailedElement { block: block.block, member, failure })
    }
}

/// What an absent element answers: nothing; its state waits.
fn absent(committed: &[f64], into: Response<'_>) -> Result<f64, Failure> {
    into.force.fill(0.0);
    if let Some(tangent) = into.tangent {
        tangent.fill(0.0);
    }
    into.state.copy_from_slice(committed);
    Ok(0.0)
}

/// The answer of an element; all of it is finite, and zero where there is none.
pub(super) fn ask(
    kernel: &dyn Kernel,
    (number, q): (usize, &[f64]),
    (committed, under): (&[f64], &Surroundings<'_>),
    into: Response<'_>,
) -> Result<f64, Failure> {
    let Response { force, mut tangent, state } = into;
    let room = Response { force: &mut *force, tangent: tangent.as_deref_mut(), state: &mut *state };
    let answer = kernel.respond(number, q, committed, under, room);
    let finite = |energy: &f64| {
        energy.is_finite() && all_finite(force) && tangent.as_deref().is_none_or(all_finite)
    };
    match answer {
        Ok(energy) if finite(&energy) => return answer,
        _ => force.fill(0.0),
    }
    if let Some(tangent) = tangent {
        tangent.fill(0.0);
    }
    state.copy_from_slice(committed);
    Err(answer.err().unwrap_or(Failure::NotFinite))
}

/// Whether no entry is infinite or no number; four at a time.
#[inline]
fn all_finite(list: &[f64]) -> bool {
    let (chunks, rest) = list.as_chunks::<4>();
    let mut sums = [0.0; 4];
    for chunk in chunks {
        sums.iter_mut().zip(chunk).for_each(|(sum, entry)| *sum += 0.0 * entry);
    }
    let sum = rest.iter().fold((sums[0] + sums[1]) + (sums[2] + sums[3]), |a, b| a + 0.0 * b);
    sum == 0.0
}

impl Product<'_> {
    pub(super) fn add(&mut self, own: &[usize], tangent: &[f64], width: usize) {
        for (&target, row) in own.iter().zip(tangent.chunks_exact(width)) {
            let sum: f64 = row.iter().zip(own).map(|(k, &dof)| k * self.vector[dof]).sum();
            self.into[target] += sum;
        }
    }
}

/// Elements that lie together, with their dofs.
pub(super) struct Part<'a> {
    pub elements: Range<usize>,
    pub force: &'a mut [f64],
    /// `None`: forces only.
    pub tangent: Option<&'a mut [f64]>,
    pub energy: &'a mut [Result<f64, Failure>],
    pub state: &'a mut [f64],
}

impl<'a> Part<'a> {
    /// The dofs of the next element.
    fn take(
        &mut self,
        width: usize,
        states: usize,
    ) -> Option<(&'a mut Result<f64, Failure>, Response<'a>)> {
        let force = self.force.split_off_mut(..width)?;
        let tangent = match &mut self.tangent {
            Some(rest) => Some(rest.split_off_mut(..width * width)?),
            None => None,
        };
        let state = self.state.split_off_mut(..states)?;
        Some((self.energy.split_off_first_mut()?, Response { force, tangent, state }))
    }
}
