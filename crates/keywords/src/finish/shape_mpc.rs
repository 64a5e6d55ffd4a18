//! `*MPC` of types that keep a shape: STRAIGHT, PLANE, MEANROT, LINEAR, LINK, for small and large displacements.
//!
//! ```text
//!   STRAIGHT   1 ----- k ----- 2     k stays on the line through 1 and 2
//!   PLANE      k in 1, 2, 3          k stays in the plane of 1, 2 and 3
//!   LINK       k ----- l             k stays as far from l as it is
//!   MEANROT    o  o                  the mean rotation of nodes about an axis
//!              o  o                  is dof 1 of the last one
//! ```
//! docs/theory.md eqs (4.13), (4.14), (4.16), (4.17).

use slideline_mech::vector::{cross, dot};
use std::collections::HashSet;

use slideline_diag::{Code, Diagnostic};
use slideline_mech::kept_shape;
use slideline_model::{Dof, KeptShape, NodeIndex, NumberedSet};

use super::equations::{add, solve};
use crate::constraints::{Shape, ShapeMpc};
use crate::draft::Draft;
use crate::rule::Subject;

type Vector = [f64; 3];
type Term = (NodeIndex, Dof, f64);

/// Equations `sum a u = 0` for small displacements that share their first node, and what they keep
/// in large ones.
struct Group {
    rows: Vec<Vec<Term>>,
    kept: Option<Kept>,
}

/// What a group keeps in large displacements.
struct Kept {
    what: What,
    /// Its nodes, in the order that the shape has.
    nodes: Vec<NodeIndex>,
    /// The node whose first dof is the mean turn.
    angle: Option<NodeIndex>,
}

#[derive(Clone, Copy)]
enum What {
    Line,
    Plane,
    Distance,
    MeanTurn(Vector),
}

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

fn one(mpc: &ShapeMpc, prescribed: &NumberedSet<(NodeIndex, Dof)>, draft: &mut Draft) {
    let mut nodes: Vec<NodeIndex> = Vec::new();
    let mut seen = HashSet::new();
    for (target, span) in &mpc.nodes {
        let found = draft.nodes_of(target, *span);
        nodes.extend(found.into_iter().filter(|&node| seen.insert(node)));
    }
    let large = draft.steps.iter().any(|step| step.nlgeom);
    let has_own_axes = |node: &NodeIndex| draft.model.axes_of(*node).is_some();
    if large && mpc.shape != Shape::Linear && nodes.iter().any(has_own_axes) {
        let message = format!(
            "*MPC of type {} with NLGEOM is not supported on nodes of *TRANSFORM",
            mpc.shape.word()
        );
        let error = Diagnostic::error(Code("SL0221"), message).at(mpc.origin);
        draft
            .consequence(Subject::Links, error.help("name their dofs along the axes of the model"));
        return;
    }
    let rows = match mpc.shape {
        Shape::Straight => straight(&nodes, draft),
        Shape::Plane => plane(&nodes, draft),
        Shape::MeanRotation => mean_rotation(&nodes, draft),
        Shape::Linear => linear(&nodes, draft),
        Shape::Link => links(&nodes, draft),
    };
    let Some(rows) = rows.filter(|rows| !rows.is_empty()) else {
        let message = format!("these nodes make no *MPC of type {}", mpc.shape.word());
        let error = Diagnostic::error(Code("SL0347"), message).at(mpc.origin);
        draft.consequence(Subject::Links, error.help(mpc.shape.needs()));
        return;
    };
    for group in rows {
        eliminate(mpc, group, (prescribed, large), draft);
    }
}

/// Lets dofs follow by equations `sum a u = 0` that share their first node.
fn eliminate(
    mpc: &ShapeMpc,
    Group { rows, kept }: Group,
    (prescribed, large): (&NumberedSet<(NodeIndex, Dof)>, bool),
    draft: &mut Draft,
) {
    let Some(&(first, ..)) = rows.first().and_then(|row| row.first()) else { return };
    let group: Vec<Vec<Term>> = rows.into_iter().map(|row| draft.along_own_axes(row)).collect();
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
    let followers: Vec<(NodeIndex, Dof)> = pivots.iter().map(|&pivot| names[pivot]).collect();
    if let Some(kept) = kept.filter(|_| large) {
        keep(mpc, &kept, &followers, draft);
    }
    for (pivot, row) in solved {
        let others = row.iter().enumerate().filter(|(c, a)| !pivots.contains(c) && **a != 0.0);
        let mut terms: Vec<Term> = others.map(|(c, a)| (names[c].0, names[c].1, -a)).collect();
        let named = |(node, dof): &(NodeIndex, Dof)| {
            (*node, *dof) == names[pivot] || terms.iter().any(|own| (own.0, own.1) == (*node, *dof))
        };
        let others: Vec<(NodeIndex, Dof)> =
            dofs_of_shape(draft).into_iter().filter(|own| !named(own)).collect();
        // they have no part in it where the nodes stand at first
        terms.extend(others.into_iter().map(|(node, dof)| (node, dof, 0.0)));
        add(draft, names[pivot], terms, mpc.origin);
    }
}

/// Notes what the constraints that come next, of these followers, keep in large displacements.
fn keep(mpc: &ShapeMpc, kept: &Kept, followers: &[(NodeIndex, Dof)], draft: &mut Draft) {
    let next = draft.model.linear_constraints.len();
    let directions = |own: usize| {
        let taken = |dof: usize| followers.iter().any(|other| other.1 as usize == dof);
        (0..3).find(|&dof| dof != own && !taken(dof))
    };
    let last = kept.nodes.last().copied();
    for (place, &(node, dof)) in followers.iter().enumerate() {
        let shape = match kept.what {
            What::Plane => kept_shape::KeptShape::Plane,
            What::Distance => kept_shape::KeptShape::Distance,
            What::MeanTurn(axis) => kept_shape::KeptShape::MeanTurn(axis),
            What::Line => match directions(dof as usize).filter(|_| Some(node) == last) {
                Some(other) if draft.model.is_in_space() || other < 2 => {
                    kept_shape::KeptShape::Line(dof as usize, other)
                }
                _ => {
                    let message = "too many dofs of this *MPC are prescribed or follow others";
                    let error = Diagnostic::error(Code("SL0315"), message).at(mpc.origin);
                    let help = "leave the dofs of the nodes between the first two free";
                    draft.consequence(Subject::Links, error.help(help));
                    return;
                }
            },
        };
        let (nodes, angle) = (kept.nodes.clone(), kept.angle);
        draft.model.shapes.push(KeptShape { constraint: next + place, shape, nodes, angle });
    }
}

/// Dofs of the shape that the constraint that comes next keeps; none where it keeps none.
fn dofs_of_shape(draft: &Draft) -> Vec<(NodeIndex, Dof)> {
    let next = draft.model.linear_constraints.len();
    let Some(own) = draft.model.shapes.iter().find(|own| own.constraint == next) else {
        return Vec::new();
    };
    let moves = draft.model.directions().iter().filter(|dof| !dof.is_rotation());
    let seen = |dof: &&Dof| own.shape.sees(**dof as usize);
    let moves: Vec<Dof> = moves.filter(seen).copied().collect();
    own.nodes.iter().flat_map(|&node| moves.iter().map(move |&dof| (node, dof))).collect()
}

fn less(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|k| a[k] - b[k])
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
fn straight(nodes: &[NodeIndex], draft: &Draft) -> Option<Vec<Group>> {
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
        let rows = normals.iter().map(row).collect();
        let kept = Kept { what: What::Line, nodes: vec![first, second, node], angle: None };
        groups.push(Group { rows, kept: Some(kept) });
    }
    Some(groups)
}

/// One equation a node: n . (u_k - sum l_i u_i) = 0 with its area coordinates l_i.
fn plane(nodes: &[NodeIndex], draft: &Draft) -> Option<Vec<Group>> {
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
        let [a, b, c] = corners;
        let kept = Kept { what: What::Plane, nodes: vec![a, b, c, node], angle: None };
        groups.push(Group { rows: vec![row], kept: Some(kept) });
    }
    Some(groups)
}

/// The last node is no point: its coordinates are the axis, and its dof 1 is the mean of the turns
/// (a x r_i) . (u_i - mean u)/|a x r_i|^2 of the others about their centre.
fn mean_rotation(nodes: &[NodeIndex], draft: &Draft) -> Option<Vec<Group>> {
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
    let kept = Kept { what: What::MeanTurn(axis), nodes: cloud.to_vec(), angle: Some(pilot) };
    (row.len() > 1).then(|| vec![Group { rows: vec![row], kept: Some(kept) }])
}

/// One equation a node: n . (u_k - u_l) = 0 along the line from the last node to it.
fn links(nodes: &[NodeIndex], draft: &Draft) -> Option<Vec<Group>> {
    let (&last, others) = nodes.split_last()?;
    let at = |node| draft.model.nodes.position(node);
    let group = |&node: &NodeIndex| {
        let n = unit(less(at(node), at(last)))?;
        let mut row = along(node, n, 1.0, draft);
        row.extend(along(last, n, -1.0, draft));
        let kept = Kept { what: What::Distance, nodes: vec![last, node], angle: None };
        Some(Group { rows: vec![row], kept: Some(kept) })
    };
    others.iter().map(group).collect()
}

/// u = (1 - t) u_a + t u_b for the place of the first node between the two others.
fn linear(nodes: &[NodeIndex], draft: &Draft) -> Option<Vec<Group>> {
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
    Some(vec![Group { rows: moves.map(row).collect(), kept: None }])
}
