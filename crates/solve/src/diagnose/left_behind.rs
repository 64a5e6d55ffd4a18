//! Nodes that are left without an element and are joined to others in the mean alone.
//!
//! ```text
//!   o----o----o    the elements above leave: what follows the mean motion of the cloud
//!        :         holds three of its nodes together as one, not each of them
//!        o~~~ spring
//! ```

use super::case::Case;
use slideline_diag::{Code, Diagnostic};
use slideline_linalg::SolveError;
use slideline_model::{MeanMotion, NodeIndex};

impl Case<'_> {
    /// The tangent is singular at a node that has lost all its elements: what follows it asks for
    /// the mean motion of its cloud, which leaves the nodes free against one another.
    pub(super) fn left_behind(&self) -> Option<Diagnostic> {
        let Some(SolveError::Singular { equation, .. }) = self.outcome.fault else { return None };
        let (plan, presence) = (self.plan, &self.plan.step.presence);
        let (node, dof) = plan.dofs.name(*plan.constraints.dof_of_equation.get(equation)?);
        if !self.has_lost_its_elements(node) {
            return None;
        }
        let model = plan.model;
        let joins = model.linear_constraints.iter().find(|own| {
            own.dependent.0 == node || own.terms.iter().any(|&(term, ..)| term == node)
        });
        let in_cloud = |own: &&MeanMotion| own.cloud.iter().any(|&(other, _)| other == node);
        let of_mean = model.mean_motions.iter().find(in_cloud).map(|own| own.origin);
        let origin = of_mean.or(joins.map(|own| own.origin))?;
        let message = format!(
            "node {} can move along {} without any resistance {}: all its elements are absent, and \
             the coupling or equation that joins it to others asks for a mean of several nodes alone",
            self.label(node),
            dof.name(),
            self.beyond(),
        );
        let said = Diagnostic::error(Code("SL0503"), message).at(origin);
        let said = match presence.origin {
            Some(origin) => said.label(origin, "the elements leave here"),
            None => said,
        };
        Some(said.help(
            "couple the reference node to nodes that keep an element, couple it by *KINEMATIC, or \
             let what hangs on it leave as well",
        ))
    }

    fn has_lost_its_elements(&self, node: NodeIndex) -> bool {
        let blocks = &self.plan.model.blocks;
        let presence = &self.plan.step.presence;
        let is_of = |&(block, member): &(usize, usize)| {
            let own = blocks.get(block);
            own.is_some_and(|own| own.elements.get(member).nodes.contains(&node))
        };
        presence.absent.iter().any(is_of)
            && !presence.elements(blocks).any(|(_, element)| element.nodes.contains(&node))
    }
}
