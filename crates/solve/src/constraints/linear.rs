//! Dofs that follow others linearly, u = c + sum a u_k.
//!
//! ```text
//!   o a      o b        of an *EQUATION: as it says
//!    \____o___/         of a tie: the shape functions of the face
//! ```

use crate::dofs::DofMap;
use slideline_model::Model;

/// A dof that follows others.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct LinearConstraint {
    /// The dof that follows.
    pub dependent: usize,
    /// Dofs that it follows, each with the index of its term in the model.
    pub terms: Vec<(usize, usize)>,
    /// Index of the constraint in the model.
    pub index: usize,
}

/// The linear constraints of a model, each behind those that it follows; one
/// that follows itself by way of others is left out.
pub(super) fn resolve(model: &Model, dofs: &DofMap) -> Vec<LinearConstraint> {
    let mut open: Vec<LinearConstraint> = Vec::new();
    for (index, said) in model.linear_constraints.iter().enumerate() {
        let Some(dependent) = dofs.find(said.dependent.0, said.dependent.1) else { continue };
        let terms = said.terms.iter().enumerate();
        let terms = terms.filter_map(|(term, &(node, dof, _))| Some((dofs.find(node, dof)?, term)));
        open.push(LinearConstraint { dependent, terms: terms.collect(), index });
    }
    let mut ordered = Vec::with_capacity(open.len());
    loop {
        let waiting: std::collections::HashSet<usize> =
            open.iter().map(|constraint| constraint.dependent).collect();
        let follows = |constraint: &LinearConstraint| {
            constraint.terms.iter().any(|(dof, _)| waiting.contains(dof))
        };
        let (later, now): (Vec<_>, Vec<_>) = open.into_iter().partition(follows);
        if now.is_empty() {
            return ordered;
        }
        ordered.extend(now);
        open = later;
    }
}

impl LinearConstraint {
    /// Moves the dependent dof to where the others take it: u = c + sum a u_k.
    pub fn enforce(&self, coefficients: &[f64], constant: f64, u: &mut [f64]) {
        let terms = self.terms.iter().zip(coefficients);
        let sum: f64 = terms.map(|(&(dof, _), a)| a * u[dof]).sum();
        u[self.dependent] = constant + sum;
    }

    /// Hands a force on the dependent dof to those that it follows.
    pub fn carry(&self, coefficients: &[f64], force: &mut [f64]) {
        let own = std::mem::take(&mut force[self.dependent]);
        let terms = self.terms.iter().zip(coefficients);
        terms.for_each(|(&(dof, _), a)| force[dof] += a * own);
    }
}
