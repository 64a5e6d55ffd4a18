//! Tied nodes that hang at faces, however far these turn.
//!
//! ```text
//!       s                  o
//!     d |           s    /       x_s = sum N_i x_i + R d
//!   o---x---o        `-x         R: the frame in which the face has not turned
//!                     /
//!                    o
//! ```
//!
//! docs/theory.md section 4.11

use std::collections::{BTreeSet, HashSet};

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{Dof, Hung, LinearConstraint, MeanMotion, NodeIndex};

use super::super::equations::in_circles;
use super::super::turned_means::{in_large_motion, replaced};
use super::arms::{Arms, NOTHING};
use super::means::Shares;
use crate::draft::Draft;

/// The motion of a node that follows a row along each axis and hangs at the faces of its arms; its constraints,
/// of these dofs, are the last ones.
pub(super) fn hanging(
    (node, dofs): (NodeIndex, &[Dof]),
    rows: [&Shares; 3],
    arms: Arms,
    (origin, draft): (Span, &Draft),
) -> MeanMotion {
    let mut nodes: Vec<(NodeIndex, f64, Hung)> = Vec::new();
    for (own, turn) in arms.turns {
        nodes.push((own, 1.0, Hung { turn, ..Hung::default() }));
    }
    let axes = draft.model.directions().iter().filter(|dof| !dof.is_rotation()).count();
    for (axis, row) in rows.into_iter().enumerate().take(axes) {
        for &(own, share) in row.iter().filter(|(_, share)| share.abs() > NOTHING) {
            let known = nodes.iter().position(|known| known.0 == own);
            let place = known.unwrap_or(nodes.len());
            if known.is_none() {
                nodes.push((own, 0.0, Hung::default()));
            }
            nodes[place].2.shares[axis] += share;
        }
    }
    let mut coupled = [false; 6];
    dofs.iter().for_each(|dof| coupled[*dof as usize] = true);
    let end = draft.model.linear_constraints.len();
    MeanMotion {
        reference: node,
        coupled,
        cloud: nodes.iter().map(|&(own, weight, _)| (own, weight)).collect(),
        hung: nodes.into_iter().map(|(.., hung)| hung).collect(),
        constraints: end.saturating_sub(dofs.len())..end,
        dependents: dofs.iter().map(|&dof| (node, dof)).collect(),
        turning: Vec::new(),
        origin,
    }
}

/// Lets what hangs at faces turn with them, but for nodes without arms, and for those that would follow themselves
/// by way of nodes that small turns of the face do not move them by: these keep arms that are linear.
pub(super) fn turn_far(
    mut hanging: Vec<MeanMotion>,
    without: &BTreeSet<NodeIndex>,
    draft: &mut Draft,
) {
    let constraints = &draft.model.linear_constraints;
    let is_there = |own: &MeanMotion| {
        let found = constraints.get(own.constraints.clone()).unwrap_or_default();
        found.iter().map(|row| row.dependent).eq(own.dependents.iter().copied())
    };
    hanging.retain(|own| !without.contains(&own.reference) && is_there(own));
    let mut linear: Vec<MeanMotion> = Vec::new();
    while !hanging.is_empty() {
        let large = hanging.iter().map(|own| in_large_motion(own, draft)).collect::<Vec<_>>();
        let rows: Vec<LinearConstraint> = replaced(&draft.model.linear_constraints, &large);
        let circular: HashSet<NodeIndex> =
            in_circles(&rows).into_iter().map(|place| rows[place].dependent.0).collect();
        let (closing, open): (Vec<_>, Vec<_>) =
            hanging.into_iter().partition(|own| circular.contains(&own.reference));
        hanging = open;
        if closing.is_empty() {
            break;
        }
        linear.extend(closing);
    }
    draft.model.mean_motions.extend(hanging);
    stay_linear(&linear, draft);
}

/// Advises where arms follow small turns only.
fn stay_linear(linear: &[MeanMotion], draft: &mut Draft) {
    let Some(first) = linear.first() else { return };
    let name = draft.model.nodes.name(first.reference);
    let message = format!(
        "the faces that {} tied nodes hang at, such as node {name}, follow these nodes when they turn far: what \
         bridges the gap follows small turns only",
        linear.len()
    );
    let said = Diagnostic::advice(Code("SL0430"), message).at(first.origin);
    let help = "make one side the slave of the other in all ties, or leave out ADJUST=NO";
    draft.log.push(said.help(help));
}
