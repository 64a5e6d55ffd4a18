//! What a model needs before any number of it is known: numbering, pattern, orders.
//!
//! ```text
//!   model --of--> Plan: dofs, equations of every step, elements, pattern
//!                   |
//!                   '--> Workspace (values of a model, scratch) --> run, again and again
//! ```
//!
//! A plan borrows nothing and holds no value: sections, materials, laws, friction,
//! positions, motions and amplitudes are values that a [`Workspace`](crate::Workspace)
//! takes from a model of the same outline.

mod coupling;
mod outline;

pub use coupling::Coupling;
pub use outline::{Part, PlanMismatch};

use crate::constraints::{ConstraintNumbering, Role};
use crate::contact::Contact;
use crate::dofs::DofMap;
use crate::restraint::Restraint;
use crate::restraint::clamped::all_are_clamped;
use crate::restraint::loose::LooseBodies;
use crate::structure::ElementNumbering;
use crate::users::UserFrictions;
use outline::Outline;
use slideline_model::{Model, Step};
use std::ops::Deref;
use std::sync::Arc;

/// Numbering, pattern and orders of an analysis. A copy shares the memory of the original.
#[derive(Clone, Debug)]
pub struct Plan(Arc<Numbering>);

/// What a plan holds.
#[derive(Debug)]
pub struct Numbering {
    outline: Outline,
    /// Dofs of all nodes.
    pub dofs: DofMap,
    /// Elements.
    pub elements: ElementNumbering,
    /// Dofs that belong to elements.
    pub elastic: Vec<bool>,
    /// Number of contact points, of state values of user friction laws, and of state
    /// variables of elements.
    pub sizes: [usize; 3],
    /// Steps that differ in their unknowns.
    pub steps: Vec<StepNumbering>,
    /// Which of them every step of the model is.
    pub of_step: Vec<usize>,
    /// Whether each element is absent, of every step; empty where none is.
    pub absent: Vec<Vec<bool>>,
    /// Bodies that contact alone holds, of every step.
    pub loose: Vec<LooseBodies>,
}

/// What steps with the same unknowns share.
#[derive(Debug)]
pub struct StepNumbering {
    /// Which dofs are unknown, and which ones the others follow.
    pub constraints: ConstraintNumbering,
    /// Elements with dofs that follow others.
    pub dependent: Vec<usize>,
    /// The pattern, where contact couples the same unknowns wherever it is.
    pub coupling: Option<Coupling>,
}

impl Plan {
    /// That of a model, and of all that differ from it in values only.
    pub fn of(model: &Model) -> Self {
        let dofs = DofMap::new(model);
        let (mut constraints, mut of_step) = (Vec::new(), Vec::with_capacity(model.steps.len()));
        for step in &model.steps {
            let own = ConstraintNumbering::new(model, step, &dofs);
            let known = constraints.iter().position(|known| *known == own);
            of_step.push(known.unwrap_or(constraints.len()));
            if known.is_none() {
                constraints.push(own);
            }
        }
        let loose = |(step, &own): (&Step, &usize)| {
            let numbering: &ConstraintNumbering = &constraints[own];
            let is_held =
                |dof: usize| matches!(numbering.roles[dof], Role::Prescribed(_) | Role::Inactive);
            if model.contact_pairs.is_empty() || all_are_clamped((model, step), (&dofs, is_held)) {
                return LooseBodies::default();
            }
            let is_unknown = |dof: usize| matches!(numbering.roles[dof], Role::Free(_));
            Restraint::of(model, step).loose_bodies((model, step), (&dofs, is_unknown))
        };
        let loose = model.steps.iter().zip(&of_step).map(loose).collect();
        let elements = constraints.first().map(|own| ElementNumbering::new(model, &dofs, own));
        let elements = elements.unwrap_or_default();
        // which unknowns contact couples does not depend on its laws
        let contact = Contact::new(model, &dofs, &UserFrictions::default());
        let number = |constraints: ConstraintNumbering| {
            let dependent = elements.dependent(&constraints);
            let coupling = (!contact.roams())
                .then(|| Coupling::new(&elements, &dependent, &constraints, (&contact, &[])));
            StepNumbering { constraints, dependent, coupling }
        };
        let steps = constraints.into_iter().map(number).collect();
        Self(Arc::new(Numbering {
            outline: Outline::of(model),
            absent: model.steps.iter().map(|own| elements.absent(&own.presence.absent)).collect(),
            elastic: elements.touched(dofs.len()),
            loose,
            dofs,
            elements,
            sizes: [contact.points.len(), contact.state_size, model.element_states()],
            steps,
            of_step,
        }))
    }

    /// Why the plan is not one of a model, if it is not.
    pub fn mismatch(&self, model: &Model) -> Option<PlanMismatch> {
        self.0.outline.mismatch(model)
    }
}

impl Deref for Plan {
    type Target = Numbering;

    fn deref(&self) -> &Numbering {
        &self.0
    }
}
