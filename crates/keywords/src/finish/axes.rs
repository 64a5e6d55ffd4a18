//! Which nodes have axes of their own, and what that makes of conditions along the axes of the
//! model.

use std::collections::HashMap;

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{Axes, Dof, NodeIndex, System, Transform};

use crate::draft::Draft;
use crate::log::Target;
use crate::rule::Subject;

/// Roundings that products of axes may leave of a factor that is zero [1].
const ROUNDINGS: f64 = 8.0;

/// A dof with a factor.
pub(super) type Term = (NodeIndex, Dof, f64);

/// Gives the nodes of every `*TRANSFORM` their axes.
pub(super) fn transforms(draft: &mut Draft) {
    let said = std::mem::take(&mut draft.transforms);
    let mut owner: HashMap<NodeIndex, (usize, Span)> = HashMap::new();
    for (place, transform) in said.iter().enumerate() {
        let nodes = draft.nodes_of(&Target::Set(transform.set.clone()), transform.set_span);
        for node in nodes {
            on_axis(node, transform.system, transform.origin, draft);
            if let Some((earlier, first)) = owner.insert(node, (place, transform.origin))
                && earlier != place
            {
                let name = draft.model.nodes.name(node);
                let message =
                    format!("node {name} has axes of its own already: these replace them");
                let warning = Diagnostic::warning(Code("SL0349"), message).at(transform.origin);
                draft.consequence(Subject::Links, warning.label(first, "given here first"));
            }
        }
    }
    for (place, transform) in said.into_iter().enumerate() {
        let own = owner.iter().filter(|(_, (owner, _))| *owner == place);
        let mut nodes: Vec<NodeIndex> = own.map(|(&node, _)| node).collect();
        nodes.sort_unstable();
        if !nodes.is_empty() {
            give(nodes, transform.system, transform.origin, draft);
        }
    }
}

/// Gives nodes that have none the axes of a system.
pub(super) fn give(nodes: Vec<NodeIndex>, system: System, origin: Span, draft: &mut Draft) {
    if out_of_plane(&nodes, &system, origin, draft) {
        return;
    }
    let axes = nodes.iter().map(|&node| (node, system.at(draft.model.nodes.position(node))));
    let axes: Vec<(NodeIndex, Axes)> = axes.collect();
    draft.axes.extend(axes);
    draft.model.transforms.push(Transform { nodes, system, origin });
}

fn on_axis(node: NodeIndex, system: System, origin: Span, draft: &mut Draft) {
    if system.is_on_axis(draft.model.nodes.position(node)) {
        let name = draft.model.nodes.name(node);
        let message = format!("node {name} is on the axis: no direction is radial there");
        let warning = Diagnostic::warning(Code("SL0232"), message).at(origin);
        let help = "its axis 1 is taken as near to x as can be; leave it out of the set if that \
                    is not meant";
        draft.consequence(Subject::Nodes, warning.help(help));
    }
}

/// In a plane model axis 3 is the one out of the plane.
fn out_of_plane(nodes: &[NodeIndex], system: &System, origin: Span, draft: &mut Draft) -> bool {
    let position = |&node: &NodeIndex| draft.model.nodes.position(node);
    let tilted = |axes: Axes| axes[2][2].abs() < 1.0 - 1e-12;
    let out =
        !draft.model.is_in_space() && nodes.iter().map(position).any(|x| tilted(system.at(x)));
    if out {
        let message = "axis 3 of these axes is not along z: the model is plane";
        let error = Diagnostic::error(Code("SL0232"), message).at(origin);
        draft.consequence(
            Subject::Nodes,
            error.help("give points a and b so that 1 and 2 are in the plane"),
        );
    }
    out
}

impl Draft {
    /// The axes along which the dofs of a node are named.
    pub(super) fn axes_of(&self, node: NodeIndex) -> Option<&Axes> {
        self.axes.get(&node)
    }

    /// The direction along which a dof of a node is named.
    pub(super) fn direction(&self, node: NodeIndex, dof: Dof) -> [f64; 3] {
        let plain = || slideline_mech::axes::PLAIN;
        self.axes_of(node).copied().unwrap_or_else(plain)[dof as usize % 3]
    }

    /// Terms along the axes of the model as terms along those in which dofs are named. What rounding of
    /// the axes leaves of a term is none: two nodes with the same axes follow one another dof by dof.
    pub(super) fn along_own_axes(&self, terms: Vec<Term>) -> Vec<Term> {
        if self.axes.is_empty() {
            return terms;
        }
        let mut sizes: HashMap<NodeIndex, f64> = HashMap::new();
        for (node, _, factor) in terms.iter().filter(|(node, ..)| self.axes_of(*node).is_some()) {
            *sizes.entry(*node).or_default() += factor.abs();
        }
        let directions = self.model.directions();
        let mut named: Vec<Term> = Vec::with_capacity(terms.len());
        for (node, dof, factor) in terms {
            let Some(axes) = self.axes_of(node) else {
                named.push((node, dof, factor));
                continue;
            };
            let alike = directions.iter().filter(|own| own.is_rotation() == dof.is_rotation());
            for &own in alike {
                let part = factor * axes[own as usize % 3][dof as usize % 3];
                let known = named.iter_mut().find(|(n, d, _)| (*n, *d) == (node, own));
                match known {
                    Some((.., sum)) => *sum += part,
                    None if part != 0.0 => named.push((node, own, part)),
                    None => {}
                }
            }
        }
        let least = |node| ROUNDINGS * f64::EPSILON * sizes.get(&node).copied().unwrap_or_default();
        named.retain(|&(node, _, factor)| factor.abs() >= least(node));
        named
    }

    /// What a dof of a node follows, as it is named, where the dofs along the axes of the model
    /// follow `terms`.
    pub(super) fn followed(
        &self,
        (node, dof): (NodeIndex, Dof),
        terms: impl Fn(Dof) -> Vec<Term>,
    ) -> Vec<Term> {
        if self.axes_of(node).is_none() {
            return self.along_own_axes(terms(dof));
        }
        let direction = self.direction(node, dof);
        let first = dof as usize - dof as usize % 3;
        let mut sum: Vec<Term> = Vec::new();
        for &own in
            self.model.directions().iter().filter(|own| own.is_rotation() == dof.is_rotation())
        {
            let cosine = direction[own as usize - first];
            for (node, dof, factor) in terms(own) {
                match sum.iter_mut().find(|(n, d, _)| (*n, *d) == (node, dof)) {
                    Some((.., known)) => *known += cosine * factor,
                    None => sum.push((node, dof, cosine * factor)),
                }
            }
        }
        self.along_own_axes(sum)
    }
}
