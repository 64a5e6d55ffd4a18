//! Stresses of the elements that are estimated apart from their strains.

use super::contributions::Contributions;
use super::elements::{Ambient, AtNodes, Structure};
use slideline_mech::element::MOST_VARIABLES;
use slideline_mech::turn::Turn;

impl Structure<'_> {
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
        for (block, kernel) in self.numbering.blocks.iter().zip(self.kernels.iter()) {
            if !kernel.estimates() {
                continue;
            }
            let (q, moved) = (&mut q[..block.variables], &mut moved[..block.variables]);
            for element in block.elements.clone().filter(|&element| self.has(element)) {
                self.read(block, element, u, q);
                let own = self.own(block, element);
                moved.iter_mut().zip(own).for_each(|(moved, &dof)| *moved = change[dof]);
                let into = &mut into[block.stresses(element)];
                let nodal = self.at_nodes(block, element, ambient, &mut nodes);
                let under = nodal.under(self.strains(), ambient.clock);
                kernel.stresses_after(block.number(element), q, moved, &under, into);
            }
        }
    }

    /// Raises axial stresses that are next to none, in a model of size `reach`
    /// [L], to a slight tension: docs/theory.md eq. (3.30).
    pub fn tighten(&self, reach: f64, stresses: &mut [f64]) {
        if stresses.is_empty() {
            return;
        }
        for (block, kernel, element) in self.present() {
            let own = &mut stresses[block.stresses(element)];
            kernel.tighten(block.number(element), reach, own);
        }
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
        for &element in self.dependent.iter().filter(|&&element| self.has(element)) {
            let (block, kernel) = self.element(element);
            let own = self.own(block, element);
            let (q, force) = (&mut q[..own.len()], &mut own_force[..own.len()]);
            self.read(block, element, u, q);
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
}
