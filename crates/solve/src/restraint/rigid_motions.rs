//! Rigid motions as rows of six numbers, and what rows leave of them.

use slideline_linalg::reduce_rows;
use slideline_model::{Dof, Model, NodeIndex};

/// Coefficients of a rigid motion: along the three axes, and about them.
pub type Motion = [f64; 6];

/// Part of the largest entry below which a row depends on the others [1].
pub const DEPENDENT: f64 = 1e-9;

/// What counts as nothing among these entries.
pub fn nothing_among(entries: &[f64]) -> f64 {
    DEPENDENT * entries.iter().fold(0.0_f64, |most, own| most.max(own.abs()))
}

/// What a dof of a rigid body sees of its motion, `arm` away from its root.
pub fn rigid_motion(dof: Dof, arm: [f64; 3]) -> Motion {
    let mut row = [0.0; 6];
    row[dof as usize] = 1.0;
    if !dof.is_rotation() {
        // u = t + omega x r
        let axis = dof as usize;
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        (row[3 + next], row[3 + last]) = (arm[last], -arm[next]);
    }
    row
}

/// What a dof of a node sees of the motion of the body whose root stands at `origin`.
pub fn seen(
    model: &Model,
    (node, dof): (NodeIndex, Dof),
    (origin, size): ([f64; 3], f64),
) -> Motion {
    let at = model.nodes.position(node);
    let arm: [f64; 3] = std::array::from_fn(|axis| match size > 0.0 {
        true => (at[axis] - origin[axis]) / size,
        false => 0.0,
    });
    named_motion(model, node, dof, arm)
}

/// The same of a dof as the deck names it: along the own axes of its node where it has some.
pub fn named_motion(model: &Model, node: NodeIndex, dof: Dof, arm: [f64; 3]) -> Motion {
    let Some(axes) = model.axes_of(node) else { return rigid_motion(dof, arm) };
    let first = dof as usize - dof as usize % 3;
    let mut row = [0.0; 6];
    for (k, cosine) in axes[dof as usize % 3].into_iter().enumerate() {
        let plain = rigid_motion(Dof::ALL[first + k], arm);
        row.iter_mut().zip(plain).for_each(|(sum, part)| *sum += cosine * part);
    }
    row
}

/// Motions along some of the unknowns that rows of a width do not hinder, but for entries up to `zero`: a base of all of
/// them.
pub fn null_motions(
    (mut rows, width): (Vec<f64>, usize),
    unknowns: impl Iterator<Item = usize>,
    zero: f64,
) -> Vec<Vec<f64>> {
    let mut pivots = Vec::with_capacity(width);
    reduce_rows(&mut rows, width, zero, &mut pivots);
    let free = unknowns.filter(|column| !pivots.contains(column));
    let motion = |column: usize| {
        let mut motion = vec![0.0; width];
        motion[column] = 1.0;
        for (&pivot, row) in pivots.iter().zip(rows.chunks_exact(width)) {
            motion[pivot] = -row[column] / row[pivot];
        }
        motion
    };
    free.map(motion).collect()
}

/// Rank of a few rows.
pub fn rank(rows: &[Motion]) -> usize {
    let mut rows = rows.as_flattened().to_vec();
    let zero = nothing_among(&rows);
    let mut pivots = Vec::with_capacity(6);
    reduce_rows(&mut rows, 6, zero, &mut pivots);
    pivots.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: rows of a clamp are of rank three, those of supports along one line of rank two,
    /// whatever the arm.
    #[test]
    fn ranks_of_supports() {
        let at = |dof, x, y, z| rigid_motion(dof, [x, y, z]);
        let (x, y) = (at(Dof::U1, 0.7, 0.3, 0.0), at(Dof::U2, 0.7, 0.3, 0.0));
        assert_eq!(rank(&[x, y, at(Dof::UR3, 0.7, 0.3, 0.0)]), 3);
        assert_eq!(rank(&[y, at(Dof::U2, 0.2, 0.0, 0.0)]), 2);
        assert_eq!(rank(&[x, at(Dof::U1, 0.1, 0.3, 0.0), y]), 2);
        assert_eq!(rank(&[]), 0);
        // three supports across a plane, two along it, one across that: 3-2-1
        let across = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(|[x, y]| at(Dof::U3, x, y, 0.5));
        let along =
            [at(Dof::U2, 0.0, 0.0, 0.0), at(Dof::U2, 1.0, 0.0, 0.0), at(Dof::U1, 0.0, 0.0, 0.0)];
        assert_eq!(rank(&[&across[..], &along].concat()), 6);
        assert_eq!(rank(&[&across[..], &along[..2]].concat()), 5);
    }

    /// Requirement: two hinges leave the turn about the line through them, which moves what is beside
    /// that line; clamps leave nothing.
    #[test]
    fn hinges_leave_a_turn() {
        let left = |rows: &[Motion]| {
            let rows = rows.as_flattened();
            null_motions((rows.to_vec(), 6), 0..6, nothing_among(rows))
        };
        let hinge = |x| [Dof::U1, Dof::U2, Dof::U3].map(|dof| rigid_motion(dof, [x, 0.5, 0.25]));
        let turns = left(&[hinge(0.0), hinge(1.0)].concat());
        assert_eq!(turns.len(), 1);
        let turn = &turns[0];
        // the line goes along x: it turns about x, and a point of the line stays
        assert!(turn[4].abs() < 1e-12 && turn[5].abs() < 1e-12 && turn[3].abs() > 0.1);
        let still = hinge(0.3).map(|row| row.iter().zip(turn).map(|(a, b)| a * b).sum::<f64>());
        assert!(still.iter().all(|u| u.abs() < 1e-12));
        let clamp = [Dof::UR1, Dof::UR2, Dof::UR3].map(|dof| rigid_motion(dof, [0.0; 3]));
        assert!(left(&[hinge(0.0), clamp].concat()).is_empty());
    }

    /// Requirement: what counts as nothing does so however small all of it is.
    #[test]
    fn what_hardly_hinders_leaves_a_motion() {
        let left = |hindered: f64| null_motions((vec![hindered], 1), 0..1, 1e-2).len();
        assert_eq!([1.0, 0.02, 1e-3, 0.0].map(left), [0, 0, 1, 1]);
    }

    /// Requirement: the row of a dof is its displacement under a rigid motion: about the third axis
    /// u = -w y, v = w x.
    #[test]
    fn rows_are_rigid_motions() {
        let arm = [2.0, 3.0, 5.0];
        assert_eq!(rigid_motion(Dof::U1, arm), [1.0, 0.0, 0.0, 0.0, 5.0, -3.0]);
        assert_eq!(rigid_motion(Dof::U2, arm), [0.0, 1.0, 0.0, -5.0, 0.0, 2.0]);
        assert_eq!(rigid_motion(Dof::U3, arm), [0.0, 0.0, 1.0, 3.0, -2.0, 0.0]);
        assert_eq!(rigid_motion(Dof::UR2, arm), [0.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
    }
}
