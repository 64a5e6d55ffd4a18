//! `*DISTRIBUTING`: a reference node that follows the mean motion of a cloud of nodes.
//!
//! ```text
//!      o   o          u_ref = mean displacement + mean rotation x arm
//!    o   R   o        mean rotation: of the least squares of w |u_i - rigid motion|^2
//!      o   o
//! ```
//! docs/theory.md section 4.2. The rotation is that of small turns of the cloud. The older card follows the
//! mean displacement alone in CalculiX: a force on its node is spread without its lever arm.

use slideline_diag::{Code, Diagnostic, Span};
use slideline_mech::vector::{cross, dot};
use slideline_model::{Dof, NodeIndex};

use super::equations::{add, solve};
use crate::draft::Draft;
use crate::rule::Subject;

/// What of a cloud its reference node follows.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Mean {
    /// The mean displacement, wherever the reference node is.
    Displacement,
    /// The rigid motion that fits the cloud best.
    Motion,
}

/// Makes the reference node follow the cloud; dofs of it that a step prescribes stay its own, and
/// dofs of the cloud follow instead.
pub(super) fn distribute(
    (reference, mean): (NodeIndex, Mean),
    dofs: [bool; 6],
    cloud: &[(NodeIndex, f64)],
    origin: Span,
    draft: &mut Draft,
) {
    let directions = draft.model.directions();
    let follows = |dof: &Dof| match dof.is_rotation() {
        true => mean == Mean::Motion && dofs[*dof as usize],
        false => dofs[*dof as usize],
    };
    let wanted: Vec<Dof> = directions.iter().copied().filter(follows).collect();
    let Some(rows) = rows((reference, mean), &wanted, cloud, draft) else {
        let message = "the nodes of *DISTRIBUTING do not define a rotation: they are too few or \
                       lie on one line";
        let error = Diagnostic::error(Code("SL0347"), message).at(origin);
        draft.consequence(Subject::Links, error.help("couple more nodes, or use *KINEMATIC"));
        return;
    };
    let axes: Vec<Dof> = directions.iter().copied().filter(|dof| !dof.is_rotation()).collect();
    let mut names: Vec<(NodeIndex, Dof)> = wanted.iter().map(|&dof| (reference, dof)).collect();
    names.extend(cloud.iter().flat_map(|&(node, _)| axes.iter().map(move |&axis| (node, axis))));
    let prescribed = super::steps::prescribed(draft);
    let is_taken =
        |name: &(NodeIndex, Dof)| draft.dependents.contains_key(name) || prescribed.contains(name);
    let taken: Vec<bool> = names.iter().map(is_taken).collect();
    let Some(solved) = solve(rows, wanted.len(), &taken) else {
        let message = "too many dofs of this coupling are prescribed or follow others";
        let error = Diagnostic::error(Code("SL0315"), message).at(origin);
        draft.consequence(Subject::Links, error.help("leave some nodes of its surface free"));
        return;
    };
    let pivots: Vec<usize> = solved.iter().map(|(pivot, _)| *pivot).collect();
    for (pivot, row) in solved {
        let others = row.iter().enumerate().filter(|(c, a)| !pivots.contains(c) && **a != 0.0);
        let terms = others.map(|(c, a)| (names[c].0, names[c].1, -a)).collect();
        add(draft, names[pivot], terms, origin);
    }
}

/// One equation for each dof of the reference node: its own dof with factor -1 first, then the
/// displacements of the cloud. `None` where the cloud has no rotation.
fn rows(
    (reference, mean): (NodeIndex, Mean),
    wanted: &[Dof],
    cloud: &[(NodeIndex, f64)],
    draft: &Draft,
) -> Option<Vec<Vec<f64>>> {
    let at = |node: NodeIndex| draft.model.nodes.get(node).position;
    let total: f64 = cloud.iter().map(|(_, weight)| weight).sum();
    let axes = draft.model.directions().iter().filter(|dof| !dof.is_rotation()).count();
    let centre: [f64; 3] = std::array::from_fn(|k| {
        cloud.iter().map(|&(node, weight)| weight * at(node)[k]).sum::<f64>() / total
    });
    let arm = |node: NodeIndex| -> [f64; 3] { std::array::from_fn(|k| at(node)[k] - centre[k]) };
    let inverse = match mean {
        Mean::Motion => inertia(cloud.iter().map(|&(node, w)| (arm(node), w)), axes)?,
        Mean::Displacement => [[0.0; 3]; 3],
    };
    let lever = arm(reference);
    let mut rows = Vec::with_capacity(wanted.len());
    for (place, &dof) in wanted.iter().enumerate() {
        let mut row = vec![0.0; wanted.len()];
        row[place] = -1.0;
        let seen = draft.direction(reference, dof);
        for &(node, weight) in cloud {
            for &axis in &Dof::ALL[..axes] {
                // rotation of the cloud by a unit displacement of this node along the axis
                let moved = draft.direction(node, axis).map(|part| weight * part);
                let turn = times(&inverse, cross(arm(node), moved));
                row.push(match dof.is_rotation() {
                    true => dot(seen, turn),
                    false => dot(seen, moved) / total + dot(seen, cross(turn, lever)),
                });
            }
        }
        rows.push(row);
    }
    Some(rows)
}

/// The inverse of sum w (r.r 1 - r r'); in the plane of its last entry alone.
fn inertia(arms: impl Iterator<Item = ([f64; 3], f64)>, axes: usize) -> Option<[[f64; 3]; 3]> {
    let mut sum = [[0.0; 3]; 3];
    for (r, weight) in arms {
        let square = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
        for i in 0..3 {
            for j in 0..3 {
                sum[i][j] += weight * (if i == j { square } else { 0.0 } - r[i] * r[j]);
            }
        }
    }
    if axes == 2 {
        let mut inverse = [[0.0; 3]; 3];
        inverse[2][2] = 1.0 / sum[2][2];
        return (sum[2][2] > 0.0).then_some(inverse);
    }
    let [a, b, c] = sum;
    let columns = [cross(b, c), cross(c, a), cross(a, b)];
    let determinant: f64 = (0..3).map(|k| a[k] * columns[0][k]).sum();
    let scale = sum[0][0] + sum[1][1] + sum[2][2];
    let sound = determinant > 1e-12 * scale * scale * scale;
    let entry = |i: usize, j: usize| columns[j][i] / determinant;
    sound.then(|| std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j))))
}

fn times(matrix: &[[f64; 3]; 3], vector: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| (0..3).map(|j| matrix[i][j] * vector[j]).sum())
}
