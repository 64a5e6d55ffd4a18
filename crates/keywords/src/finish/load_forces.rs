//! Forces on nodes that distributed loads become, and loads that leave a plane.

use slideline_diag::{Code, Diagnostic};
use slideline_mech::turning::Turning;
use slideline_model::{Dof, NodeIndex, Pressed};

use crate::distributed::{Distributed, Key, Kind};
use crate::draft::Draft;
use crate::rule::Subject;

/// Of what a load consists.
pub(super) enum What {
    Pressure(Pressed, Vec<NodeIndex>),
    /// Forces of a unit load.
    Forces(Vec<(NodeIndex, Dof, f64)>),
}

/// What a line loads, by element and kind.
pub(super) type Resolved = Vec<((usize, Key), What)>;

/// Where nodes are [L].
pub(super) fn places(nodes: &[NodeIndex], draft: &Draft) -> Vec<[f64; 3]> {
    nodes.iter().map(|&node| draft.model.nodes.get(node).position).collect()
}

/// Forces on nodes, those that are zero or out of a plane model left out.
pub(super) fn shares(
    nodes: &[NodeIndex],
    forces: &[[f64; 3]],
    draft: &Draft,
) -> Vec<(NodeIndex, Dof, f64)> {
    let axes = draft.model.directions();
    let each = nodes
        .iter()
        .zip(forces)
        .flat_map(|(&node, force)| (0..3).map(move |k| (node, Dof::ALL[k], force[k])));
    each.filter(|(_, dof, share)| *share != 0.0 && axes.contains(dof)).collect()
}

/// A direction has the length 1.
pub(super) const NOUGHT: f64 = 1e-12;

/// Why a weight does not act in the plane, or not evenly round the axis.
pub(super) fn weight_leaves(kind: Kind, ring: bool) -> Option<&'static str> {
    match kind {
        Kind::Gravity([x, _, z]) if ring => {
            (x.abs().max(z.abs()) > NOUGHT).then_some("takes gravity along its axis alone")
        }
        Kind::Gravity([_, _, z]) => (z.abs() > NOUGHT).then_some("takes no load out of its plane"),
        Kind::Centrifugal([x, _, z], [a, _, c]) if ring => {
            (x != 0.0 || z != 0.0 || a.abs().max(c.abs()) > NOUGHT)
                .then_some("turns about its own axis alone")
        }
        // about an axis along z, or about one within the plane
        Kind::Centrifugal([_, _, z], [a, b, c]) => (a.abs().max(b.abs()) > NOUGHT
            && (c.abs() > NOUGHT || z != 0.0))
            .then_some("takes no load out of its plane"),
        _ => None,
    }
}

pub(super) fn refuse(why: &str, name: &str, ring: bool, line: &Distributed, draft: &mut Draft) {
    let message = format!("a {name} element {why}");
    let error = Diagnostic::error(Code("SL0251"), message).at(line.origin);
    let help = match ring {
        true => "the axis of rings is that of y, x is their radius",
        false => "leave out the part of the load along z",
    };
    draft.consequence(Subject::Elements, error.help(help));
}

/// A load of turning, as masses of pairs of nodes [M], where the places of nodes count: some step
/// has nonlinear kinematics.
pub(super) fn turned(
    kind: Kind,
    nodes: &[NodeIndex],
    draft: &Draft,
    masses: impl FnOnce() -> Option<Vec<f64>>,
) -> Option<What> {
    let Kind::Centrifugal(point, axis) = kind else { return None };
    if !draft.large {
        return None;
    }
    let turning = Turning::new(masses()?, point, axis);
    Some(What::Pressure(Pressed::Turning(turning), nodes.to_vec()))
}

/// The force per volume of a unit load at a place [F/L3].
pub(super) fn per_volume(
    (kind, along): (Kind, Option<usize>),
    density: f64,
    at: [f64; 3],
) -> [f64; 3] {
    match kind {
        Kind::Body(_) => std::array::from_fn(|k| if Some(k) == along { 1.0 } else { 0.0 }),
        Kind::Gravity(direction) => direction.map(|d| density * d),
        Kind::Centrifugal(point, axis) => {
            let arm: [f64; 3] = std::array::from_fn(|k| at[k] - point[k]);
            let along: f64 = (0..3).map(|k| arm[k] * axis[k]).sum();
            std::array::from_fn(|k| density * (arm[k] - along * axis[k]))
        }
        _ => [0.0; 3],
    }
}
