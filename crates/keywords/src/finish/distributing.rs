//! `*DISTRIBUTING`: a reference node that follows the mean motion of a cloud of nodes.
//!
//! ```text
//!      o   o          u_ref = mean displacement + mean rotation x arm
//!    o   R   o        mean rotation: of the least squares of w |u_i - rigid motion|^2
//!      o   o
//! ```
//! docs/theory.md section 4.2. The rotation of these equations is that of small turns of the cloud; where motion is
//! large `turned_means.rs` says what follows what. The older card follows the mean displacement alone in CalculiX: a
//! force on its node is spread without its lever arm.

use slideline_diag::{Code, Diagnostic, Span};
use slideline_mech::vector::{cross, dot};
use slideline_model::{Dof, LinearMeanTurn, NodeIndex};

use super::equations::{add, solve};
use crate::constraints::OpenMean;
use crate::draft::Draft;
use crate::rule::Subject;

/// Lever of a reference node that stands in the centre of its cloud, over its place: rounding [1].
const ROUNDING: f64 = 1e-9;

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
    let about = Cloud::new(cloud, mean, draft);
    let Some((about, rows)) = about.map(|own| (own, own.rows(reference, &wanted, cloud, draft)))
    else {
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
    let Some(solved) = solve(rows.clone(), wanted.len(), &taken) else {
        let message = "too many dofs of this coupling are prescribed or follow others";
        let error = Diagnostic::error(Code("SL0315"), message).at(origin);
        draft.consequence(Subject::Links, error.help("leave some nodes of its surface free"));
        return;
    };
    let first = draft.model.linear_constraints.len();
    let pivots: Vec<usize> = solved.iter().map(|(pivot, _)| *pivot).collect();
    for (pivot, row) in solved {
        let others = row.iter().enumerate().filter(|(c, a)| !pivots.contains(c) && **a != 0.0);
        let terms = others.map(|(c, a)| (names[c].0, names[c].1, -a)).collect();
        add(draft, names[pivot], terms, origin);
    }
    let is_large = draft.steps.iter().any(|step| step.nlgeom);
    if !is_large || mean == Mean::Displacement || !about.sees_turns(reference, &wanted, draft) {
        return;
    }
    let turns = |dofs: &[Dof]| dofs.iter().filter(|dof| dof.is_rotation()).count();
    let is_whole = [0, turns(directions)].contains(&turns(&wanted));
    let turns = cloud.iter().map(|&own| (own.0, about.turns(own, draft))).collect();
    let linear = LinearMeanTurn { reference, turns, origin };
    // a step of small motion beside others wants the mean that is linear, and leaves nothing else
    if !is_whole || !draft.steps.iter().all(|step| step.nlgeom) {
        draft.model.linear_mean_turns.push(linear);
        return;
    }
    let cloud = cloud.iter().copied().filter(|(_, weight)| *weight != 0.0).collect();
    let constraints = first..draft.model.linear_constraints.len();
    let own = wanted.len();
    draft.means.push(OpenMean { cloud, rows, names, own, pivots, constraints, linear });
}

/// A cloud of nodes about its centre.
#[derive(Clone, Copy)]
struct Cloud {
    centre: [f64; 3],
    /// Sum of the weights.
    total: f64,
    /// The inverse of its inertia; zero where the mean does not turn.
    inverse: [[f64; 3]; 3],
}

impl Cloud {
    /// `None` where the cloud has no rotation.
    fn new(cloud: &[(NodeIndex, f64)], mean: Mean, draft: &Draft) -> Option<Self> {
        let at = |node: NodeIndex| draft.model.nodes.get(node).position;
        let total: f64 = cloud.iter().map(|(_, weight)| weight).sum();
        let centre: [f64; 3] = std::array::from_fn(|k| {
            cloud.iter().map(|&(node, weight)| weight * at(node)[k]).sum::<f64>() / total
        });
        let mut own = Self { centre, total, inverse: [[0.0; 3]; 3] };
        if mean == Mean::Motion {
            let arms = cloud.iter().map(|&(node, weight)| (own.arm(node, draft), weight));
            own.inverse = inertia(arms, axes(draft))?;
        }
        Some(own)
    }

    /// Whether what of the reference node follows depends on the turn: a rotation, or a displacement away from the centre.
    fn sees_turns(&self, reference: NodeIndex, wanted: &[Dof], draft: &Draft) -> bool {
        let lever = self.arm(reference, draft).map(f64::abs).into_iter().fold(0.0, f64::max);
        let place = self.centre.map(f64::abs).into_iter().fold(lever, f64::max);
        wanted.iter().any(|dof| dof.is_rotation()) || lever > ROUNDING * place
    }

    fn arm(&self, node: NodeIndex, draft: &Draft) -> [f64; 3] {
        let at = draft.model.nodes.get(node).position;
        std::array::from_fn(|k| at[k] - self.centre[k])
    }

    /// Rotation of the cloud by a weighted displacement of a node.
    fn turn(&self, node: NodeIndex, moved: [f64; 3], draft: &Draft) -> [f64; 3] {
        times(&self.inverse, cross(self.arm(node, draft), moved))
    }

    /// Rotation of the cloud by the displacement of a node along the axes of the model, a row a direction of it [1/L].
    fn turns(&self, (node, weight): (NodeIndex, f64), draft: &Draft) -> [[f64; 3]; 3] {
        let by = [0, 1, 2].map(|axis| {
            let mut moved = [0.0; 3];
            moved[axis] = weight;
            self.turn(node, moved, draft)
        });
        std::array::from_fn(|row| [0, 1, 2].map(|axis| by[axis][row]))
    }

    /// One equation for each dof of the reference node: its own dof with factor -1 first, then the
    /// displacements of the cloud.
    fn rows(
        &self,
        reference: NodeIndex,
        wanted: &[Dof],
        cloud: &[(NodeIndex, f64)],
        draft: &Draft,
    ) -> Vec<Vec<f64>> {
        let lever = self.arm(reference, draft);
        let row = |(place, &dof): (usize, &Dof)| {
            let mut row = vec![0.0; wanted.len()];
            row[place] = -1.0;
            let seen = draft.direction(reference, dof);
            for &(node, weight) in cloud {
                for &axis in &Dof::ALL[..axes(draft)] {
                    let moved = draft.direction(node, axis).map(|part| weight * part);
                    let turn = self.turn(node, moved, draft);
                    row.push(match dof.is_rotation() {
                        true => dot(seen, turn),
                        false => dot(seen, moved) / self.total + dot(seen, cross(turn, lever)),
                    });
                }
            }
            row
        };
        wanted.iter().enumerate().map(row).collect()
    }
}

/// Directions in which nodes move.
fn axes(draft: &Draft) -> usize {
    draft.model.directions().iter().filter(|dof| !dof.is_rotation()).count()
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
