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
    /// Dofs that it follows, with their coefficients [1, L or 1/L].
    pub terms: Vec<(usize, f64)>,
    /// What is added [L or 1].
    pub constant: f64,
}

/// The linear constraints of a model, each behind those that it follows; one
/// that follows itself by way of others is left out.
pub(super) fn resolve(model: &Model, dofs: &DofMap) -> Vec<LinearConstraint> {
    let mut open: Vec<LinearConstraint> = Vec::new();
    for said in &model.linear_constraints {
        let Some(dependent) = dofs.find(said.dependent.0, said.dependent.1) else { continue };
        let term = |&(node, dof, a)| Some((dofs.find(node, dof)?, a));
        let terms = said.terms.iter().filter_map(term).collect();
        open.push(LinearConstraint { dependent, terms, constant: said.constant });
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
    /// Moves the dependent dof to where the others take it.
    pub fn enforce(&self, u: &mut [f64]) {
        let sum: f64 = self.terms.iter().map(|&(dof, a)| a * u[dof]).sum();
        u[self.dependent] = self.constant + sum;
    }

    /// Hands a force on the dependent dof to those that it follows.
    pub fn carry(&self, force: &mut [f64]) {
        let own = std::mem::take(&mut force[self.dependent]);
        self.terms.iter().for_each(|&(dof, a)| force[dof] += a * own);
    }
}
