//! Arms of tied nodes that stay away from what they follow.
//!
//! ```text
//!        s  slave node, not moved onto the master     u_s = sum N_i u_i + w x d
//!      d |
//!   o----x-------o  master face, turned by w
//! ```
//!
//! docs/theory.md section 4.11

use slideline_diag::{Code, Diagnostic};
use slideline_mech::face_turn::{swing, turn};
use slideline_model::{Dof, NodeIndex};

use super::master::{Master, TOLERANCE, TOUCHING};
use super::means::Shares;
use crate::constraints::Tie;
use crate::draft::Draft;

/// Part of an arm below which a factor is rounding [1].
const NOTHING: f64 = 1e-12;

/// What an arm adds to what a displacement of a slave node follows; nothing where the node is at the place
/// itself.
pub(super) fn arm_terms(
    (node, (axis, row)): (NodeIndex, (usize, &Shares)),
    master: &Master,
    draft: &Draft,
) -> Vec<(NodeIndex, Dof, f64)> {
    let nodes = &draft.model.nodes;
    let at = nodes.position(node);
    let place =
        |k: usize| row.iter().map(|(own, share)| share * nodes.position(*own)[k]).sum::<f64>();
    let arm: [f64; 3] = std::array::from_fn(|k| at[k] - place(k));
    let long = arm.iter().map(|d| d * d).sum::<f64>().sqrt();
    if long <= TOUCHING * master.size {
        return Vec::new();
    }
    let Some(turn) = turn(&master.face, &master.x, at) else { return Vec::new() };
    let directions = draft.model.directions();
    let own = master.nodes.iter().zip(&turn).flat_map(|(&node, turn)| {
        let row = swing(turn, arm)[axis];
        let along = directions.iter().filter(|dof| !dof.is_rotation());
        along.map(move |&dof| (node, dof, row[dof as usize]))
    });
    own.filter(|(.., factor)| factor.abs() > NOTHING * long / master.size).collect()
}

/// Adds terms to others of the same dofs.
pub(super) fn join(terms: &mut Vec<(NodeIndex, Dof, f64)>, more: Vec<(NodeIndex, Dof, f64)>) {
    for (node, dof, factor) in more {
        match terms.iter_mut().find(|own| (own.0, own.1) == (node, dof)) {
            Some((.., sum)) => *sum += factor,
            None => terms.push((node, dof, factor)),
        }
    }
}

/// Advises where nodes hang at faces by long arms and may turn far: arms follow small turns. `gaps` are the
/// distances of nodes from what they are tied to, with the sizes of the faces there.
pub(super) fn judge_arms(tie: &Tie, gaps: impl Iterator<Item = (f64, f64)>, draft: &mut Draft) {
    if tie.adjust || !draft.steps.iter().any(|step| step.nlgeom) {
        return;
    }
    let most = gaps.map(|(gap, size)| gap / size).fold(0.0, f64::max);
    if most <= TOLERANCE {
        return;
    }
    let (slave, master) = (&tie.slave.name, &tie.master.name);
    let message = format!(
        "{slave} is tied to {master} across a gap of up to {:.0} % of a face: what bridges it follows small \
         turns only, and the steps have large ones",
        100.0 * most
    );
    let help = "leave out ADJUST=NO, so that the nodes are moved onto the master, or mesh what fills the gap; with \
                turns of less than some degrees the answer holds";
    draft.log.push(Diagnostic::advice(Code("SL0430"), message).at(tie.origin).help(help));
}
