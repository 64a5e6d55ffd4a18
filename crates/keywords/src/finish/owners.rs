//! Which rigid body an analytical surface belongs to.

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::NodeIndex;

use crate::draft::Draft;
use crate::log::Target;
use crate::rule::Subject;
use crate::surfaces::NamedSurface;

impl Draft {
    /// The single node a rigid body moves with.
    pub(super) fn reference_of(&mut self, target: &Target, span: Span) -> Option<NodeIndex> {
        let nodes = self.nodes_of(target, span);
        if nodes.len() > 1 {
            let message = format!("REF NODE must be one node, but this set has {}", nodes.len());
            let error = Diagnostic::error(Code("SL0317"), message).at(span);
            self.consequence(Subject::Links, error);
        }
        match *nodes {
            [node] => Some(node),
            _ => None,
        }
    }
}

/// The rigid body of an analytical surface, by its place, and its reference node.
pub(super) fn owner(
    surface: &NamedSurface,
    user: Span,
    draft: &mut Draft,
) -> Option<(usize, NodeIndex)> {
    let name = &surface.named.name;
    let owns = |body: &crate::surfaces::RigidBody| {
        body.surface.as_ref().is_some_and(|named| named.name == *name)
    };
    let Some(place) = draft.bodies.iter().position(owns) else {
        if draft.is_complete(Subject::Contact) {
            let message = format!("the analytical surface {name} belongs to no rigid body");
            let error = Diagnostic::error(Code("SL0333"), message).at(user);
            let error = error.label(surface.origin, "the surface");
            let help = format!("add *RIGID BODY, ANALYTICAL SURFACE={name}, REF NODE=...");
            draft.consequence(Subject::Links, error.help(help));
        }
        return None;
    };
    let body = draft.bodies[place].clone();
    Some((place, draft.reference_of(&body.reference, body.reference_span)?))
}

/// Each rigid body names an analytical surface of its own.
pub(super) fn bodies(draft: &mut Draft) {
    let mut owners: Vec<(String, Span)> = Vec::new();
    for body in draft.bodies.clone() {
        let Some(named) = body.surface else { continue };
        let Some(surface) = draft.surface(&named) else { continue };
        if !surface.extent.is_analytical() {
            let message = format!("the surface {} is not analytical", named.name);
            let error = Diagnostic::error(Code("SL0332"), message).at(named.span);
            let help = "only *SURFACE of TYPE=SEGMENTS, CYLINDER or REVOLUTION is; nodes and elements belong to the body by \
                        TIE NSET= and ELSET=";
            draft.consequence(Subject::Contact, error.label(surface.origin, "here").help(help));
        }
        if let Some((_, first)) = owners.iter().find(|(name, _)| *name == named.name) {
            let message = format!("the surface {} belongs to two rigid bodies", named.name);
            let error = Diagnostic::error(Code("SL0334"), message).at(named.span);
            draft.consequence(Subject::Links, error.label(*first, "the first one"));
        }
        owners.push((named.name, named.span));
    }
}
