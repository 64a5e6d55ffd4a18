//! The elements of a step, each with its own slot for force and tangent.
//!
//! ```text
//!   u --> element 1 --> [force | tangent]  \
//!   u --> element 2 --> [force | tangent]   >-- gather in fixed order --> f, K
//!   u --> element 3 --> [force | tangent]  /
//! ```
//!
//! Elements write slots of their own and a gather in fixed order sums them,
//! so that the sum has the same bits on any number of threads. The slots of all
//! elements lie behind one another: an element takes as much as it needs.

mod element;
mod flux;
mod place;
#[cfg(test)]
mod tests;

pub use flux::Flux;

use crate::constraints::{Constraints, Rows};
use crate::observe::BeamRow;
use element::{Kinematics, Placed};
use rayon::ThreadPool;
use slideline_linalg::Pattern;
use slideline_model::NodeIndex;

/// From this number of elements on, threads pay.
const PARALLEL: usize = 2000;
/// Elements that one thread takes at a time.
const SHARE: usize = 256;

/// A beam as output wants to see it.
#[derive(Clone, Debug)]
pub struct BeamReport {
    /// Place among the structure's elements.
    element: usize,
    /// Element label.
    pub label: u64,
    /// Its ends.
    pub nodes: [NodeIndex; 2],
    /// Half its height [L].
    pub half_height: f64,
}

/// All elements of a step.
#[derive(Clone, Debug)]
pub struct Structure {
    elements: Vec<Placed>,
    /// Slots of the elements' own variables, element by element.
    own: Vec<usize>,
    /// Index of each tangent entry among the matrix values, row by row;
    /// `usize::MAX`: none.
    entries: Vec<usize>,
    /// Elements with dofs that follow others.
    dependent: Vec<usize>,
    beams: Vec<BeamReport>,
    nlgeom: bool,
    /// How many stresses the elements have.
    stresses: usize,
    /// Largest EA/l [F/L], for the rounding floor of the residual.
    pub stiffest: f64,
    /// Length of the element that has it [L].
    pub stiffest_length: f64,
}

/// What every element contributes, in slots of its own.
#[derive(Clone, Debug)]
pub struct Contributions {
    /// Laid out as [`Structure::own`].
    force: Vec<f64>,
    /// Laid out as [`Structure::entries`].
    tangent: Vec<f64>,
    /// Strain energy of each element [F L].
    energy: Vec<f64>,
}

impl Structure {
    /// Room for what the elements contribute, empty.
    pub fn room(&self) -> Contributions {
        Contributions {
            force: vec![0.0; self.own.len()],
            tangent: vec![0.0; self.entries.len()],
            energy: vec![0.0; self.elements.len()],
        }
    }

    /// Sets of slots that couple.
    pub fn cliques(&self) -> impl Iterator<Item = &[usize]> {
        self.elements.iter().map(|element| &self.own[element.own()])
    }

    /// Finds every tangent entry's place in the matrix.
    pub fn find_entries(&mut self, constraints: &Constraints, pattern: &Pattern) {
        for (place, element) in self.elements.iter().enumerate() {
            if self.dependent.binary_search(&place).is_ok() {
                continue;
            }
            let own = &self.own[element.own()];
            let entries = &mut self.entries[element.entries()];
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

    /// Whether each slot belongs to an element (rounding grows with those).
    pub fn touched(&self, slots: usize) -> Vec<bool> {
        let mut touched = vec![false; slots];
        for &slot in &self.own {
            touched[slot] = true;
        }
        touched
    }

    /// Room for the stresses of every element; none where strains are linear,
    /// for then there is no geometric stiffness.
    pub fn stress_room(&self) -> Vec<f64> {
        vec![0.0; if self.nlgeom { self.stresses } else { 0 }]
    }

    /// The stresses that a linear solution with the `change` of all slots
    /// arrives at from displacements `u`: docs/theory.md eq. (3.27).
    pub fn stresses_after(&self, u: &[f64], change: &[f64], into: &mut [f64]) {
        if into.is_empty() {
            return;
        }
        for element in &self.elements {
            let own = &self.own[element.own()];
            element.stresses_after((u, change), own, &mut into[element.stresses()]);
        }
    }

    /// Raises axial stresses that are next to none, in a model of size `reach`
    /// [L], to a slight tension: docs/theory.md eq. (3.30).
    pub fn tighten(&self, reach: f64, stresses: &mut [f64]) {
        if stresses.is_empty() {
            return;
        }
        for element in &self.elements {
            let least = element.shape.slight_tension(reach);
            for point in stresses[element.stresses()].as_chunks_mut::<3>().0 {
                if point[0].abs() < least {
                    point[0] = least;
                }
            }
        }
    }

    /// The largest turn of a beam's nodes against each other [1], of the
    /// changes `of` the slots.
    pub fn largest_bend(&self, of: impl Fn(usize) -> f64) -> f64 {
        let mut largest = 0.0_f64;
        for beam in &self.beams {
            let nodes = self.own[self.elements[beam.element].own()].as_chunks::<3>().0;
            let turns = || nodes.iter().map(|node| of(node[2]));
            let (low, high) =
                (turns().fold(f64::INFINITY, f64::min), turns().fold(f64::NEG_INFINITY, f64::max));
            largest = largest.max(high - low);
        }
        largest
    }

    /// Evaluates every element at displacements `u`, each into its own place;
    /// with estimates of the stresses these make the geometric stiffness.
    pub fn evaluate(
        &self,
        u: &[f64],
        stresses: Option<&[f64]>,
        into: &mut Contributions,
        pool: Option<&ThreadPool>,
    ) {
        let trial = (u, stresses.filter(|_| self.nlgeom));
        let part = Part {
            elements: &self.elements,
            force: &mut into.force,
            tangent: &mut into.tangent,
            energy: &mut into.energy,
        };
        match pool.filter(|_| self.elements.len() >= PARALLEL) {
            Some(pool) => pool.install(|| self.evaluate_shared(trial, part)),
            None => self.evaluate_part(trial, part),
        }
    }

    /// Halves a part until one thread can take it.
    fn evaluate_shared(&self, trial: Displacements<'_>, part: Part<'_>) {
        if part.elements.len() <= SHARE {
            return self.evaluate_part(trial, part);
        }
        let (first, second) = part.halve();
        rayon::join(|| self.evaluate_shared(trial, first), || self.evaluate_shared(trial, second));
    }

    fn evaluate_part(&self, (u, stresses): Displacements<'_>, part: Part<'_>) {
        let Part { elements, mut force, mut tangent, energy } = part;
        for (element, energy) in elements.iter().zip(energy) {
            let width = element.width();
            let (own_force, rest) = force.split_at_mut(width);
            force = rest;
            let (own_tangent, rest) = tangent.split_at_mut(width * width);
            tangent = rest;
            let own = &self.own[element.own()];
            let slots = (own_force, own_tangent);
            let kinematics = match stresses {
                Some(stresses) => Kinematics::Mixed(&stresses[element.stresses()]),
                None if self.nlgeom => Kinematics::Exact,
                None => Kinematics::Linear,
            };
            *energy = element.shape.evaluate(u, own, kinematics, slots);
        }
    }

    /// Sums forces into the full vector; returns the strain energy [F L].
    pub fn gather_force(&self, from: &Contributions, force: &mut [f64]) -> f64 {
        for (&slot, value) in self.own.iter().zip(&from.force) {
            force[slot] += value;
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
        for element in self.dependent.iter().map(|&element| &self.elements[element]) {
            let (own, tangent) = (&self.own[element.own()], &from.tangent[element.entries()]);
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
        let mut own_force = [0.0; element::WIDTH];
        for element in self.dependent.iter().map(|&element| &self.elements[element]) {
            let own = &self.own[element.own()];
            let force = &mut own_force[..own.len()];
            let kinematics = match stresses.filter(|_| self.nlgeom) {
                Some(stresses) => Kinematics::Mixed(&stresses[element.stresses()]),
                None => Kinematics::Exact,
            };
            if !element.shape.force_of_stresses(u, own, kinematics, force) {
                force.copy_from_slice(&from.force[element.own()]);
            }
            own.iter().zip(&*force).for_each(|(&dof, value)| into[dof] += value);
        }
    }

    /// Sums K v for a full vector v of slots into `product` (a first guess of
    /// what a prescribed motion does).
    pub fn multiply(&self, from: &Contributions, v: &[f64], product: &mut [f64]) {
        for element in &self.elements {
            let own = &self.own[element.own()];
            let rows = from.tangent[element.entries()].chunks_exact(element.width());
            for (&target, row) in own.iter().zip(rows) {
                let sum: f64 = row.iter().zip(own).map(|(k, &slot)| k * v[slot]).sum();
                product[target] += sum;
            }
        }
    }

    /// Mean magnitude of the nodal forces and of the nodal moments of all
    /// elements, with the number of nodal vectors counted: the flux q.
    pub fn flux(&self, from: &Contributions) -> Flux {
        let mut flux = Flux::default();
        let mut rest: &[f64] = &from.force;
        for element in &self.elements {
            let (own, behind) = rest.split_at(element.width());
            element.count(own, &mut flux);
            rest = behind;
        }
        flux
    }

    /// Section results of every beam.
    pub fn beam_rows<'a>(&'a self, u: &'a [f64]) -> impl Iterator<Item = BeamRow> + 'a {
        self.beams.iter().map(move |beam| {
            let placed = &self.elements[beam.element];
            let (strains, forces) =
                placed.section(u, &self.own[placed.own()], self.nlgeom).unwrap_or_default();
            BeamRow {
                label: beam.label,
                nodes: beam.nodes,
                axial_force: forces[0],
                shear_force: forces[1],
                bending_moment: forces[2],
                strains,
                fibre_strain: strains[0].abs() + strains[2].abs() * beam.half_height,
            }
        })
    }
}

/// Displacements, and the stresses that the geometric stiffness is made of
/// where they are not those of the strains.
type Displacements<'a> = (&'a [f64], Option<&'a [f64]>);

/// Elements that lie together, with their slots.
struct Part<'a> {
    elements: &'a [Placed],
    force: &'a mut [f64],
    tangent: &'a mut [f64],
    energy: &'a mut [f64],
}

impl Part<'_> {
    fn halve(self) -> (Self, Self) {
        let middle = self.elements.len() / 2;
        let (first, second) = self.elements.split_at(middle);
        let width: usize = first.iter().map(Placed::width).sum();
        let square: usize = first.iter().map(|element| element.width() * element.width()).sum();
        let (force, other_force) = self.force.split_at_mut(width);
        let (tangent, other_tangent) = self.tangent.split_at_mut(square);
        let (energy, other_energy) = self.energy.split_at_mut(middle);
        (
            Self { elements: first, force, tangent, energy },
            Self {
                elements: second,
                force: other_force,
                tangent: other_tangent,
                energy: other_energy,
            },
        )
    }
}
