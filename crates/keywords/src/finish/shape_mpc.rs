//! `*MPC` of types that keep a shape: STRAIGHT, PLANE, MEANROT, LINEAR, for small displacements.
//!
//! ```text
//!   STRAIGHT   1 ----- k ----- 2     k stays on the line through 1 and 2
//!   PLANE      k in 1, 2, 3          k stays in the plane of 1, 2 and 3
//!   MEANROT    o  o                  the mean rotation of nodes about an axis
//!              o  o                  is dof 1 of the last one
//! ```
//! docs/theory.md eqs (4.13), (4.14).

use std::collections::HashSet;

use slideline_diag::{Code, Diagnostic};
use slideline_model::{Dof, NodeIndex};

use super::equations::{add, solve};
use crate::constraints::{Shape, ShapeMpc};
use crate::draft::Draft;
use crate::rule::Subject;

type Vector = [f64; 3];
type Term = (NodeIndex, Dof, f64);

/// All of them.
pub(super) fn shapes(draft: &mut Draft) {
    let all = std::mem::take(&mut draft.shape_mpcs);
    if all.is_empty() {
        return;
    }
    let prescribed = super::steps::prescribed(draft);
    for mpc in &all {
        one(mpc, &prescribed, draft);
    }
}

fn one(mpc: &ShapeMpc, prescribed: &HashSet<(NodeIndex, Dof)>, draft: &mut Draft) {
    let mut nodes: Vec<NodeIndex> = Vec::new();
    let mut seen = HashSet::new();
    for (target, span) in &mpc.nodes {
        let found = draft.nodes_of(target, *span);
        nodes.extend(found.into_iter().filter(|&node| seen.insert(node)));
    }
    if draft.steps.iter().any(|step| step.nlgeom) && mpc.shape != Shape::Linear {
        let message = format!("*MPC of type {} is not supported with NLGEOM", mpc.shape.word());
        let error = Diagnostic::error(Code("SL0221"), message).at(mpc.origin);
        let help = "it is linear here: solve without NLGEOM, or use BEAM for what stays rigid";
        draft.consequence(Subject::Links, error.help(help));
        return;
    }
    let rows = match mpc.shape {
        Shape::Straight => straight(&nodes, draft),
        Shape::Plane => plane(&nodes, draft),
        Shape::MeanRotation => mean_rotation(&nodes, draft),
        Shape::Linear => linear(&nodes, draft),
    };
    let Some(rows) = rows.filter(|rows| !rows.is_empty()) else {
        let message = format!("these nodes make no *MPC of type {}", mpc.shape.word());
        let error = Diagnostic::error(Code("SL0347"), message).at(mpc.origin);
        draft.consequence(Subject::Links, error.help(mpc.shape.needs()));
        return;
    };
    for group in rows {
        eliminate(mpc, group, prescribed, draft);
    }
}

/// Lets dofs follow by equations `sum a u = 0` that share their first node.
fn eliminate(
    mpc: &ShapeMpc,
    group: Vec<Vec<Term>>,
    prescribed: &HashSet<(NodeIndex, Dof)>,
    draft: &mut Draft,
) {
    let Some(&(first, ..)) = group.first().and_then(|row| row.first()) else { return };
    let group: Vec<Vec<Term>> = group.into_iter().map(|row| draft.along_own_axes(row)).collect();
    let mut names: Vec<(NodeIndex, Dof)> = Vec::new();
    for &(node, dof, _) in group.iter().flatten() {
        if !names.contains(&(node, dof)) {
            names.push((node, dof));
        }
    }
    names.sort_by_key(|&(node, _)| node != first);
    let preferred = names.iter().filter(|&&(node, _)| node == first).count();
    let rows = group.iter().map(|row| {
        let of = |name: &(NodeIndex, Dof)| -> f64 {
            row.iter().filter(|term| (term.0, term.1) == *name).map(|term| term.2).sum()
        };
        names.iter().map(of).collect()
    });
    let is_taken =
        |name: &(NodeIndex, Dof)| draft.dependents.contains_key(name) || prescribed.contains(name);
    let taken: Vec<bool> = names.iter().map(is_taken).collect();
    let Some(solved) = solve(rows.collect(), preferred, &taken) else {
        let message = "too many dofs of this *MPC are prescribed or follow others";
        let error = Diagnostic::error(Code("SL0315"), message).at(mpc.origin);
        draft.consequence(Subject::Links, error.help("leave some dofs of its nodes free"));
        return;
    };
    let pivots: Vec<usize> = solved.iter().map(|(pivot, _)| *pivot).collect();
    for (pivot, row) in solved {
        let others = row.iter().enumerate().filter(|(c, a)| !pivots.contains(c) && **a != 0.0);
        let terms = others.map(|(c, a)| (names[c].0, names[c].1, -a)).collect();
        add(draft, names[pivot], terms, mpc.origin);
    }
}

fn less(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|k| a[k] - b[k])
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(a: Vector) -> Option<Vector> {
    let length = dot(a, a).sqrt();
    (length > 0.0).then(|| a.map(|x| x / length))
}

/// Terms of `factor n . u` of a node, along the directions that the model has.
fn along(node: NodeIndex, n: Vector, factor: f64, draft: &Draft) -> Vec<Term> {
    let moves = draft.model.directions().iter().filter(|dof| !dof.is_rotation());
    moves.map(|&dof| (node, dof, factor * n[dof as usize])).filter(|term| term.2 != 0.0).collect()
}

/// Distance from a shape that still counts as on it, as a part of its size.
const ON: f64 = 1e-6;

/// Two equations a node in space, one in the plane: n . (u_k - (1 - t) u_1 - t u_2) = 0.
fn straight(nodes: &[NodeIndex], draft: &Draft) -> Option<Vec<Vec<Vec<Term>>>> {
    let (&[first, second], others) = nodes.split_first_chunk::<2>()?;
    let at = |node| draft.model.nodes.position(node);
    let d = less(at(second), at(first));
    let size = dot(d, d);
    let tangent = unit(d)?;
    let normals = match draft.model.is_in_space() {
        true => {
            let least = (0..3).min_by(|&a, &b| d[a].abs().total_cmp(&d[b].abs()))?;
            let axis: Vector = std::array::from_fn(|k| f64::from(u8::from(k == least)));
            let n = unit(cross(tangent, axis))?;
            vec![n, cross(tangent, n)]
        }
        false => vec![[-tangent[1], tangent[0], 0.0]],
    };
    let mut groups = Vec::new();
    for &node in others {
        let arm = less(at(node), at(first));
        let t = dot(arm, d) / size;
        let off = less(arm, d.map(|x| t * x));
        if dot(off, off) > ON * ON * size {
            return None;
        }
        let row = |&n: &Vector| {
            let parts = [(node, 1.0), (first, t - 1.0), (second, -t)];
            parts.iter().flat_map(|&(own, factor)| along(own, n, factor, draft)).collect()
        };
        groups.push(normals.iter().map(row).collect());
    }
    Some(groups)
}

/// One equation a node: n . (u_k - sum l_i u_i) = 0 with its area coordinates l_i.
fn plane(nodes: &[NodeIndex], draft: &Draft) -> Option<Vec<Vec<Vec<Term>>>> {
    let (&corners, others) = nodes.split_first_chunk::<3>()?;
    if !draft.model.is_in_space() {
        return None;
    }
    let [a, b, c] = corners.map(|node| draft.model.nodes.position(node));
    let area = cross(less(b, a), less(c, a));
    let (size, n) = (dot(area, area), unit(area)?);
    let mut groups = Vec::new();
    for &node in others {
        let x = draft.model.nodes.position(node);
        if dot(less(x, a), n).powi(2) > ON * ON * size.sqrt() {
            return None;
        }
        let share = |p: Vector, q: Vector| dot(cross(less(p, x), less(q, x)), area) / size;
        let shares = [share(b, c), share(c, a), share(a, b)];
        let mut row = along(node, n, 1.0, draft);
        let of_corners = corners.iter().zip(shares);
        row.extend(of_corners.flat_map(|(&own, share)| along(own, n, -share, draft)));
        groups.push(vec![row]);
    }
    Some(groups)
}

/// The last node is no point: its coordinates are the axis, and its dof 1 is the mean of the turns
/// (a x r_i) . (u_i - mean u)/|a x r_i|^2 of the others about their centre.
fn mean_rotation(nodes: &[NodeIndex], draft: &Draft) -> Option<Vec<Vec<Vec<Term>>>> {
    let (&pilot, cloud) = nodes.split_last()?;
    let axis = unit(draft.model.nodes.position(pilot))?;
    let count = cloud.len() as f64;
    let at = |node: NodeIndex| draft.model.nodes.position(node);
    let centre: Vector =
        std::array::from_fn(|k| cloud.iter().map(|&node| at(node)[k]).sum::<f64>() / count);
    let mut turns: Vec<Vector> = Vec::with_capacity(cloud.len());
    for &node in cloud {
        let way = cross(axis, less(at(node), centre));
        let square = dot(way, way);
        turns.push(if square > 0.0 { way.map(|x| x / (square * count)) } else { return None });
    }
    let mean: Vector =
        std::array::from_fn(|k| turns.iter().map(|turn| turn[k]).sum::<f64>() / count);
    let mut row = vec![(pilot, Dof::U1, -1.0)];
    for (&node, turn) in cloud.iter().zip(turns) {
        row.extend(along(node, less(turn, mean), 1.0, draft));
    }
    // the pilot may be prescribed: then a node of the cloud follows
    (row.len() > 1).then(|| vec![vec![row]])
}

/// u = (1 - t) u_a + t u_b for the place of the first node between the two others.
fn linear(nodes: &[NodeIndex], draft: &Draft) -> Option<Vec<Vec<Vec<Term>>>> {
    let &[node, a, b] = nodes else { return None };
    let at = |node| draft.model.nodes.position(node);
    let d = less(at(b), at(a));
    let size = dot(d, d);
    if size == 0.0 {
        return None;
    }
    let t = dot(less(at(node), at(a)), d) / size;
    let moves = draft.model.directions().iter().filter(|dof| !dof.is_rotation());
    let row = |&dof: &Dof| vec![(node, dof, 1.0), (a, dof, t - 1.0), (b, dof, -t)];
    Some(vec![moves.map(row).collect()])
}
