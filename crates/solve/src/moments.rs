//! Moments about fixed axes on nodes that turn in space.
//!
//! ```text
//!   m about axes that stay     rotations u count from a start: T(u - c)' m is what works on u
//! ```
//! docs/theory.md eq. (4.15).

use crate::constraints::Rows;
use crate::dofs::DofMap;
use crate::problem::Problem;
use slideline_linalg::Kind;
use slideline_mech::axes::Axes;
use slideline_mech::rotation;
use slideline_mech::turn::Turn;
use slideline_model::{Dof, NodeIndex};

/// A node with a moment in space.
struct Turned {
    /// Its rotations.
    dofs: [usize; 3],
    /// What they are away from where they count from.
    vector: [f64; 3],
    /// The moment on them along the axes of the model [F L].
    moment: [f64; 3],
}

/// Nodes with moments among the loads, where displacements may be large.
fn turned<'a>(
    plan: &'a Problem<'_>,
    load: &'a [f64],
    (u, turns): (&'a [f64], &'a [Turn]),
) -> impl Iterator<Item = Turned> + 'a {
    let nodes = plan.dofs.rotations_in_space().filter(|_| plan.step.nlgeom);
    nodes.filter_map(move |(node, dofs)| {
        let moment = moment((plan.dofs, plan.constraints.motion.axes()), load, (node, dofs));
        let vector = || turns.get(node).unwrap_or(&Turn::REST).vector(dofs.map(|dof| u[dof]));
        (moment != [0.0; 3]).then(|| Turned { dofs, vector: vector(), moment })
    })
}

/// The moment on a node, along the axes of the model: that on its dofs, and that along its own axes.
fn moment(
    (map, axes): (&DofMap, &[Axes]),
    load: &[f64],
    (node, dofs): (NodeIndex, [usize; 3]),
) -> [f64; 3] {
    let mut moment = dofs.map(|dof| load[dof]);
    let Some(axes) = map.place_of_turned(node).and_then(|place| axes.get(place)) else {
        return moment;
    };
    for (axis, kind) in axes.iter().zip([Dof::UR1, Dof::UR2, Dof::UR3]) {
        let Some(named) = map.named(node, kind) else { continue };
        (0..3).for_each(|k| moment[k] += axis[k] * load[named]);
    }
    moment
}

/// Puts moments about fixed axes [F L] in place of what works on the rotations `u` of nodes in
/// space, T'm; of all, or of those that count from somewhere else than in `now`.
pub fn into_moments(
    (map, axes): (&DofMap, &[Axes]),
    (u, turns): (&[f64], &[Turn]),
    now: Option<&[Turn]>,
    forces: &mut [f64],
) {
    for (node, dofs) in map.rotations_in_space() {
        let turn = turns.get(node).unwrap_or(&Turn::REST);
        if now.is_some_and(|now| now.get(node).unwrap_or(&Turn::REST) == turn) {
            continue;
        }
        let share = moment((map, axes), forces, (node, dofs));
        let moment = rotation::moment_of_share(turn.vector(dofs.map(|dof| u[dof])), share);
        (0..3).for_each(|k| forces[dofs[k]] += moment[k] - share[k]);
    }
}

/// Calls back with what moments do to the rotations of their nodes beyond what the loads say:
/// T'm - m [F L].
pub fn turn_moments(
    plan: &Problem<'_>,
    load: &[f64],
    at: (&[f64], &[Turn]),
    mut call: impl FnMut(usize, f64),
) {
    for Turned { dofs, vector, moment } in turned(plan, load, at) {
        let share = rotation::along_vector(&vector, &moment);
        (0..3).for_each(|k| call(dofs[k], share[k] - moment[k]));
    }
}

/// Takes the derivative of the moments from the tangent; half of it and of its transpose where the
/// matrix is symmetric.
pub fn stiffen(
    plan: &Problem<'_>,
    rows: &Rows,
    load: &[f64],
    at: (&[f64], &[Turn]),
    values: &mut [f64],
) {
    let symmetric = plan.kind() == Kind::Symmetric;
    for Turned { dofs, vector, moment } in turned(plan, load, at) {
        let slopes = rotation::along_vector_slopes(vector, moment);
        let entry = |i: usize, j: usize| match symmetric {
            true => -0.5 * (slopes[i][j] + slopes[j][i]),
            false => -slopes[i][j],
        };
        plan.scatter(rows, &dofs, entry, values);
    }
}
