//! Stress and plastic strain before the first step.
//!
//! ```text
//!   residual |o        what the initial stress leaves unbalanced
//!            |  \
//!            |    \__  off over the first step
//!            '------o t
//! ```
//!
//! docs/theory.md section 9.2.

use super::analysis::Analysis;
use crate::constraints::Role;
use crate::start::Start;
use crate::structure::Held;
use slideline_mech::material::Conditions;
use slideline_model::{ElementBlock, ElementIndex, InitialStress, Section};

impl Analysis<'_> {
    /// Elements begin with their initial stresses. What these leave unbalanced at dofs that are free
    /// becomes a load that ramps off over the first step.
    pub(super) fn begin_stressed(&mut self, start: &mut Start<'static>) {
        self.place_hardening();
        if self.model.initial_stresses.is_empty() {
            return;
        }
        self.place_stresses();
        let mut force = vec![0.0; self.plan.dofs.len()];
        let mut held = Held::default();
        let absent = &self.plan.absent[0];
        let there = |element: &usize| !absent.get(*element).is_some_and(|&absent| absent);
        for element in (0..self.plan.elements.count()).filter(there) {
            // an element without an answer is found by the first increment
            if let Ok(own) = self.exerted((0, start), &[element], |dof, f| force[dof] += f) {
                held.stored += own.stored;
                held.dissipated += own.dissipated;
            }
        }
        let numbering = &self.plan.steps[self.plan.of_step[0]].constraints;
        let released = start.released.to_mut();
        for (dof, role) in numbering.roles.iter().enumerate() {
            match role {
                Role::Prescribed(_) => self.committed.reaction[dof] = force[dof],
                _ => {
                    released[dof] += force[dof];
                    self.committed.load[dof] += force[dof];
                }
            }
        }
        let energy = &mut self.committed.energy;
        energy.strain_energy += held.stored;
        energy.material_dissipation += held.dissipated;
    }

    /// Writes plastic strains before the first step into the state of their elements.
    fn place_hardening(&mut self) {
        for own in &self.model.initial_hardening {
            let block = &self.model.blocks[own.element.0];
            let Section::Solid(section) = &block.section else { continue };
            let (first, width) = (self.first_state(own.element), block.point_states());
            for point in 0..block.kind.points {
                let at = first + width * point;
                let Some(state) = self.committed.elements.get_mut(at..at + width) else { break };
                section.material.harden(own.plastic_strain, &own.back_stress, state);
            }
        }
    }

    /// Where the state variables of an element begin.
    fn first_state(&self, (block, member): ElementIndex) -> usize {
        let before = self.model.blocks[..block].iter();
        let before: usize = before.map(|own| own.states() * own.elements.len()).sum();
        before + self.model.blocks[block].states() * member
    }

    /// Writes the initial stresses into the state of their elements.
    fn place_stresses(&mut self) {
        let large = self.model.steps[0].nlgeom;
        for own in &self.model.initial_stresses {
            let (block, member) = own.element;
            let model = &self.model.blocks[block];
            let first = self.first_state((block, member));
            let width = model.point_states();
            let state = self.committed.elements.get(first..first + width).unwrap_or(&[]);
            let Some(strain) = strain_before(model, own, large, state) else { continue };
            let points = own.point.map_or(0..model.kind.points, |point| point..point + 1);
            for point in points {
                let at = first + width * point;
                self.committed.elements[at..at + strain.len()].copy_from_slice(&strain);
            }
        }
    }
}

/// What a point of this state has been strained by before it is undeformed; `None`: its material
/// takes no stress.
fn strain_before(
    block: &ElementBlock,
    own: &InitialStress,
    large: bool,
    state: &[f64],
) -> Option<[f64; 6]> {
    let Section::Solid(section) = &block.section else { return None };
    let under = Conditions { large, ..Conditions::default() };
    section.material.strain_before(&own.stress, &under, state)
}
