//! What a step removes from the model, and what it adds.
//!
//! ```text
//!   force |o        what was removed exerted, off over the step
//!         |  \
//!         |    \__  what comes back with strain exerts at once, less the same ramp
//!         '------o t
//! ```
//!
//! docs/theory.md section 9.1.

use super::analysis::{Analysis, Left};
use crate::constraints::{ConstraintNumbering, Role};
use crate::observe::Event;
use crate::start::Start;
use crate::state::State;
use crate::structure::{Ambient, FailedElement, Held, Kernels, Reference, Structure};
use slideline_diag::{Code, Diagnostic};
use slideline_mech::element::solid::smallest_jacobian;
use slideline_mech::material::Clock;
use slideline_model::{ChangedSection, ElementIndex, Kinematics, Section, Step};

/// What a step changes.
struct Change {
    /// Elements that were there, by their index in the structure.
    removed: Vec<usize>,
    /// Elements that come back with their strain.
    returned: Vec<usize>,
    /// Elements that begin.
    begun: Vec<usize>,
    /// Contact pairs that were there.
    pairs: Vec<usize>,
}

impl Change {
    fn is_nothing(&self) -> bool {
        let Self { removed, returned, begun, pairs } = self;
        [removed, returned, begun, pairs].into_iter().all(Vec::is_empty)
    }
}

impl Analysis<'_> {
    /// Lets elements and contact pairs leave and come before a step. What is no longer exerted, or
    /// is exerted from now on, becomes a load that ramps off; the energy that goes with it is
    /// counted apart.
    pub(super) fn change_model(
        &mut self,
        number: usize,
        start: &mut Start<'static>,
    ) -> Result<(), Left> {
        let change = self.change(number);
        if change.is_nothing() {
            return Ok(());
        }
        // the step has a number from 2 on: before the first nothing leaves
        let (before, now) = (number - 2, number - 1);
        let mut force = vec![0.0; self.plan.dofs.len()];
        let removed = self.exerted((before, start), &change.removed, |dof, f| force[dof] -= f);
        let removed = removed.map_err(|failed| self.collapsed(number, &failed))?;
        let contact = self.values.contact.of_step((self.model, self.plan.dofs.len()), before);
        let held = contact.release(&change.pairs, (&mut *self.committed, -1.0), &mut force);
        self.begin_elements(&change.begun, start);
        self.judge_beginnings(number, start)?;
        let returned = self.exerted((now, start), &change.returned, |dof, f| force[dof] += f);
        let returned = returned.map_err(|failed| self.collapsed(number, &failed))?;
        let numbering = &self.plan.steps[self.plan.of_step[now]].constraints;
        self.let_go_of_moments(number, &mut force);
        ramp_off(force, numbering, (start, self.committed));
        let energy = &mut self.committed.energy;
        energy.strain_energy += returned.stored - removed.stored;
        energy.material_dissipation += returned.dissipated - removed.dissipated;
        energy.contact_energy -= held.laws;
        energy.friction_elastic -= held.slip;
        let gone = removed.stored + removed.dissipated - returned.stored - returned.dissipated;
        energy.removed_energy += gone + held.laws + held.slip;
        Ok(())
    }

    fn change(&self, number: usize) -> Change {
        let (model, plan) = (self.model, self.plan);
        let none = || Change { removed: vec![], returned: vec![], begun: vec![], pairs: vec![] };
        let Some(before) = number.checked_sub(2) else { return none() };
        let (old, new) = (&model.steps[before].presence, &model.steps[number - 1].presence);
        let [was, is] = [before, number - 1].map(|step| {
            let absent = &plan.absent[step];
            move |element: &usize| absent.get(*element).is_some_and(|&absent| absent)
        });
        let all = 0..plan.elements.count();
        let index = |&own: &ElementIndex| plan.elements.index_of(own);
        let begun: Vec<usize> = new.begun.iter().filter_map(index).collect();
        let other = self.other_sections((before, number - 1));
        let other = |own: &usize| other.iter().any(|block| block.contains(own));
        // another section: the element with the old one leaves, that with the new one comes
        let returned =
            all.clone().filter(|own| !begun.contains(own) && !is(own) && (was(own) || other(own)));
        let pairs = new.absent_pairs.iter().filter(|&&pair| old.has_pair(pair));
        Change {
            returned: returned.collect(),
            removed: all.filter(|own| !was(own) && (is(own) || other(own))).collect(),
            begun,
            pairs: pairs.copied().collect(),
        }
    }

    /// The elements of the blocks that have another section in a step than in the one before.
    fn other_sections(&self, (before, now): (usize, usize)) -> Vec<std::ops::Range<usize>> {
        let [before, now] = [before, now].map(|step| &self.model.steps[step].sections);
        let named = before.iter().chain(now).map(|own| own.block);
        let other = named.filter(|&block| self.section(before, block) != self.section(now, block));
        other.filter_map(|block| self.plan.elements.of_block(block)).collect()
    }

    /// The section of a block where those are changed.
    fn section<'b>(&'b self, changed: &'b [ChangedSection], block: usize) -> &'b Section {
        let other = changed.iter().find(|own| own.block == block);
        other.map_or(&self.model.blocks[block].section, |own| &own.section)
    }

    /// The kernels of a step, where they are not those of the model: elements begin where they
    /// stand, or have other sections.
    ///
    /// # Errors
    /// The block with an element that cannot begin where it stands.
    pub(super) fn own_kernels(
        &self,
        step: &Step,
        references: &[Reference],
    ) -> Result<Option<Kernels>, usize> {
        let references = if step.nlgeom { references } else { &[] };
        if references.is_empty() && step.sections.is_empty() {
            return Ok(None);
        }
        let mut kernels = Kernels::default();
        kernels.take(&self.plan.elements, self.model, (references, &step.sections))?;
        Ok(Some(kernels))
    }

    /// Forces and energy of elements in the committed state, by the kinematics of a step.
    pub(super) fn exerted(
        &self,
        (step, start): (usize, &Start<'_>),
        elements: &[usize],
        mut call: impl FnMut(usize, f64),
    ) -> Result<Held, FailedElement> {
        let mut sum = Held::default();
        if elements.is_empty() {
            return Ok(sum);
        }
        let step = &self.model.steps[step];
        let own = self.own_kernels(step, &start.references).ok().flatten();
        let structure = self.structure(step, own.as_ref(), &start.references);
        let state = (&self.committed.displacement[..], &self.committed.elements[..]);
        let ambient = self.ambient();
        for &element in elements {
            let held = structure.exert(element, (state.0, state.1, &ambient), &mut call)?;
            sum.stored += held.stored;
            sum.dissipated += held.dissipated;
        }
        Ok(sum)
    }

    fn ambient(&self) -> Ambient<'_> {
        let (temperatures, turns) = (&self.committed.temperatures[..], &self.committed.turns[..]);
        Ambient { temperatures, turns, clock: Clock::default() }
    }

    /// The elements alone, whether they are there or not: nothing is gathered from them.
    fn structure<'b>(
        &'b self,
        step: &Step,
        own: Option<&'b Kernels>,
        references: &'b [Reference],
    ) -> Structure<'b> {
        let kernels = &self.values.kernels;
        Structure {
            numbering: &self.plan.elements,
            kernels: own.unwrap_or(kernels),
            dependent: &[],
            entries: &[],
            absent: &[],
            references,
            initial: &self.model.initial_temperatures,
            nlgeom: step.nlgeom,
            stiffest: kernels.stiffest,
            stiffest_length: kernels.stiffest_length,
        }
    }

    /// Elements begin where their nodes stand, without stress and history.
    fn begin_elements(&mut self, begun: &[usize], start: &mut Start<'static>) {
        if begun.is_empty() {
            return;
        }
        let mut states = std::mem::take(&mut self.committed.elements);
        let structure = self.structure(&self.model.steps[0], None, &[]);
        let ambient = self.ambient();
        let references = start.references.to_mut();
        for &element in begun {
            let own = structure.begin(element, &self.committed.displacement, &ambient);
            match references.binary_search_by_key(&element, |own| own.element) {
                Ok(at) => references[at] = own,
                Err(at) => references.insert(at, own),
            }
            structure.renew(element, &mut states);
        }
        self.committed.elements = states;
    }

    /// SL0524: an element whose nodes stand where it would be folded or have no length.
    fn judge_beginnings(&mut self, number: usize, start: &Start<'_>) -> Result<(), Left> {
        let step = &self.model.steps[number - 1];
        if !step.nlgeom {
            return Ok(());
        }
        let spoilt = step.presence.begun.iter().find(|&&own| !self.may_begin(own, start));
        let Some(&(block, member)) = spoilt else { return Ok(()) };
        let block = &self.model.blocks[block];
        let element = block.elements.get(member);
        let message = format!(
            "element {} ({}) cannot begin in step {number}: on the present places of its nodes it \
             is folded or has no length",
            element.label,
            block.word(),
        );
        let said = Diagnostic::error(Code("SL0524"), message).at(step.presence.origin);
        let said = said.label(element.origin, "the element").help(
            "its own nodes stay where they are while it is absent, those that it shares move on: \
             lead its own nodes along by *BOUNDARY in the steps before, or add it with its strain: \
             *MODEL CHANGE, ADD=WITH STRAIN",
        );
        Err(self.fails(said))
    }

    fn may_begin(&self, (block, member): ElementIndex, start: &Start<'_>) -> bool {
        let own = &self.model.blocks[block];
        let Some(index) = self.plan.elements.index_of((block, member)) else { return true };
        let found = start.references.iter().find(|own| own.element == index);
        let Some(reference) = found else { return true };
        let nodes = own.elements.get(member).nodes.iter().enumerate();
        let places: Vec<[f64; 3]> = nodes
            .map(|(number, &node)| {
                let moved = reference.translation(number, own.dofs());
                let at = self.model.nodes.position(node);
                std::array::from_fn(|k| at[k] + moved[k])
            })
            .collect();
        match own.kind.kinematics {
            Kinematics::Solid { rule, .. } => smallest_jacobian(own.kind.cell, rule, &places) > 0.0,
            Kinematics::Spring | Kinematics::Gap => true,
            _ => places.first() != places.last(),
        }
    }

    /// SL0524: an element that has no answer where it comes back or leaves.
    fn collapsed(&mut self, number: usize, failed: &FailedElement) -> Left {
        let block = &self.model.blocks[failed.block];
        let element = block.elements.get(failed.member);
        let message = format!(
            "element {} ({}) cannot come back in step {number}: with the strain that its nodes \
             have had it collapses",
            element.label,
            block.word(),
        );
        let origin = self.model.steps[number - 1].presence.origin;
        let said = Diagnostic::error(Code("SL0524"), message).at(origin);
        let said = said.label(element.origin, "the element");
        self.fails(said.help("add it free of strain: *MODEL CHANGE, ADD=STRAIN FREE"))
    }

    fn fails(&mut self, said: Diagnostic) -> Left {
        match self.tell(Event::Diagnosed(&said)) {
            Ok(()) => Left::Failed(Box::new(said)),
            Err(left) => left,
        }
    }
}

/// Forces that are no longer there, or are from now on, ramp off over the step as loads, which act
/// at its beginning already. Where nothing that is there moves a dof nothing feels them, and a
/// support holds no more than the load there.
fn ramp_off(
    mut force: Vec<f64>,
    numbering: &ConstraintNumbering,
    (start, committed): (&mut Start<'static>, &mut State),
) {
    let released = start.released.to_mut();
    for &dof in &numbering.deserted {
        (force[dof], released[dof]) = (0.0, 0.0);
        committed.reaction[dof] = match numbering.roles[dof] {
            Role::Prescribed(_) => -committed.load[dof],
            _ => 0.0,
        };
    }
    let loads = released.iter_mut().zip(&mut committed.load);
    for ((released, load), own) in loads.zip(force) {
        *released += own;
        *load += own;
    }
}
