//! Loads and motions on degrees of freedom that nothing has.
//!
//! ```text
//!   o-----o  <- a moment       o <- a force
//!   |     |     solids do        a node of
//!   o-----o     not turn         no element
//! ```

use crate::finding::Finding;
use crate::start::Start;
use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{Dof, NodeIndex};
use slideline_solve::Idle;

/// SL0427: lines of loads and motions that act on nothing, each by its first node.
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    let nodes = &start.model.nodes;
    let mut told: Vec<(Span, Dof, Idle, NodeIndex, usize)> = Vec::new();
    for (idle, (node, dof), origin) in slideline_solve::without_effect(start.model) {
        let same = |own: &&mut (Span, Dof, Idle, NodeIndex, usize)| (own.0, own.1) == (origin, dof);
        match told.iter_mut().find(same) {
            Some(line) => line.4 += 1,
            None => told.push((origin, dof, idle, node, 0)),
        }
    }
    for (origin, dof, idle, node, others) in told {
        let what = match idle {
            Idle::Load => "load",
            Idle::Motion => "motion",
        };
        let others = match others {
            0 => String::new(),
            count => format!(" (and {count} more)"),
        };
        let (name, dof) = (nodes.name(node), dof.number());
        let message = format!(
            "the {what} on degree of freedom {dof} of node {name}{others} has no effect: nothing \
             gives that node such a motion"
        );
        let help = match dof {
            4.. => {
                "solids do not turn: *COUPLING with *DISTRIBUTING or *KINEMATIC hands a moment \
                 at a reference node to a face"
            }
            _ => "the node belongs to no element, body or equation: is its number right?",
        };
        let said = Diagnostic::warning(Code("SL0427"), message).at(origin).help(help);
        findings.push(Finding::said(said));
    }
}
