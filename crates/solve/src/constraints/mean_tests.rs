//! Mean motions that turn far, of clouds and of faces that nodes hang at: derivatives by differences, and what
//! they keep.

use super::tests::{AT, POINT_IN_SPACE, check_from, step, turn};
use super::{ConstraintNumbering, Constraints, Motion};
use crate::dofs::DofMap;
use slideline_mech::face_turn;
use slideline_mech::pressure::Face;
use slideline_mech::rotation;
use slideline_mech::turn::Turn;
use slideline_model::{Dof, Dof::*, Hung, MeanMotion, Model, Node, NodeIndex, Step};

/// A point that moves in the plane and gives no force.
static POINT_IN_PLANE: slideline_model::ElementType =
    slideline_model::ElementType { dofs: &[U1, U2, UR3], ..POINT_IN_SPACE };

/// The reference node; the nodes before it are its cloud.
const REFERENCE: NodeIndex = 6;

/// A cloud without a pattern. `coupled` of the reference node, `dependents` follow, `turning` of them follow
/// dofs of their own.
fn cloud(in_space: bool, coupled: &[Dof], follow: [&[(NodeIndex, Dof)]; 2]) -> Model {
    let mut model = Model::default();
    for label in 0..=REFERENCE {
        let x = label as f64;
        let z = if in_space { 0.4 * x } else { 0.0 };
        let position = [(1.3 * x).cos(), 2.0 * (0.9 * x).sin(), z];
        model.nodes.insert(Node { label: label as u64 + 1, position, origin: AT });
    }
    let section = slideline_model::Section::Properties(vec![]);
    let point = if in_space { &POINT_IN_SPACE } else { &POINT_IN_PLANE };
    let block = slideline_model::ElementBlock::new(point, "P", section, AT);
    model.blocks = vec![block.with((0..=REFERENCE).map(|node| (node as u64 + 1, [node])))];
    let mut is_coupled = [false; 6];
    coupled.iter().for_each(|dof| is_coupled[*dof as usize] = true);
    let [dependents, turning] = follow.map(<[_]>::to_vec);
    model.mean_motions.push(MeanMotion {
        reference: REFERENCE,
        coupled: is_coupled,
        cloud: (0..REFERENCE).map(|node| (node, 1.0 + 0.3 * node as f64)).collect(),
        hung: vec![],
        constraints: 0..0,
        dependents,
        turning,
        origin: AT,
    });
    model.steps.push(Step { prescribed: vec![], ..step() });
    model
}

/// The same node that hangs at a face of the first nodes, with other shares along each axis.
fn hanging(in_space: bool, coupled: &[Dof]) -> Model {
    let mut model = cloud(in_space, coupled, [&all(&[REFERENCE], coupled), &[]]);
    let count = if in_space { 4 } else { 2 };
    let face = Face::of(if in_space { 3 } else { 2 }, count, 1.0).unwrap();
    let x: Vec<[f64; 3]> = (0..count).map(|node| model.nodes.position(node)).collect();
    let turns = face_turn::turn(&face, &x, model.nodes.position(REFERENCE)).unwrap();
    let own = &mut model.mean_motions[0];
    for (place, (_, weight)) in own.cloud.iter_mut().enumerate() {
        let share = |axis: usize| [0.4, -0.1, 0.3, 0.2, 0.3, -0.1][(place + axis) % 6];
        let turn = turns.get(place).filter(|_| place < count).copied().unwrap_or_default();
        *weight = f64::from(place < count);
        own.hung.push(Hung { shares: [0, 1, 2].map(share), turn });
    }
    model
}

/// Those that are checked: all displacements follow, or a part.
fn all_hanging() -> [Model; 4] {
    [
        hanging(true, &[U1, U2, U3]),
        hanging(true, &[U1, U3]),
        hanging(false, &[U1, U2]),
        hanging(false, &[U2]),
    ]
}

/// All dofs of some nodes.
fn all(nodes: &[NodeIndex], dofs: &[Dof]) -> Vec<(NodeIndex, Dof)> {
    nodes.iter().flat_map(|&node| dofs.iter().map(move |&dof| (node, dof))).collect()
}

fn with<T>(model: &Model, ask: impl FnOnce(&DofMap, &Constraints<'_>) -> T) -> T {
    let dofs = DofMap::new(model);
    let numbering = ConstraintNumbering::new(model, &model.steps[0], &dofs);
    let mut motion = Motion::default();
    motion.take(&numbering, model);
    ask(&dofs, &Constraints { numbering: &numbering, motion: &motion })
}

/// The models that are checked: the reference node follows, nodes of the cloud do, some of both; with
/// rotations and without.
fn models() -> Vec<Model> {
    let (shifts, space) = ([U1, U2, U3], Dof::ALL);
    let reference = |dofs: &[Dof]| all(&[REFERENCE], dofs);
    let whole = all(&[0, 1, 2], &shifts);
    let turning = [(1, U1), (2, U1), (2, U2)];
    let mixed = [reference(&space[3..]), all(&[4], &shifts)].concat();
    let in_plane = all(&[1, 3], &[U1, U2]);
    vec![
        cloud(true, &space, [&reference(&space), &[]]),
        cloud(true, &space, [&whole, &turning]),
        cloud(true, &space, [&mixed, &[]]),
        cloud(true, &shifts, [&reference(&shifts), &[]]),
        cloud(true, &shifts, [&all(&[3], &shifts), &[]]),
        cloud(false, &[U1, U2, UR3], [&reference(&[U1, U2, UR3]), &[]]),
        cloud(false, &[U1, U2, UR3], [&in_plane, &[(3, U1)]]),
        cloud(false, &[U1, U2], [&reference(&[U1, U2]), &[]]),
    ]
}

/// Requirement: T is the derivative of the motion, its transpose carries forces of the same work, and the
/// turning is the derivative of T' f, also where the reference node has turned far, has turned before, or
/// nodes have axes of their own. Central differences of step 1e-6; tolerance 1e-6 of the derivative.
#[test]
fn means_by_differences() {
    for mut model in models() {
        for turned in [false, true] {
            if turned && model.is_in_space() {
                turn(&mut model, &[0, REFERENCE], [0.8, 0.6, -0.3]);
                turn(&mut model, &[3], [0.2, -0.5, 0.4]);
            }
            with(&model, |dofs, constraints| {
                for far in [0.0, 1.9] {
                    let mut u: Vec<f64> =
                        (0..dofs.len()).map(|k| 0.2 * (1.0 + k as f64).sin()).collect();
                    for dof in dofs.named_of_node(REFERENCE).filter(|&own| dofs.is_rotation(own)) {
                        u[dof] += far;
                    }
                    check_from(constraints, &[], u.clone(), 1e-6);
                    let before = rotation::quaternion(&[0.3, 1.0, -0.4]);
                    let mut turns = vec![Turn::REST; REFERENCE + 1];
                    turns[REFERENCE] = Turn { start: [0.1, 0.2, -0.3], before };
                    check_from(constraints, &turns, u, 1e-6);
                }
            });
        }
    }
}

/// Requirement: the same of nodes that hang at faces, where these are bent and have turned far, and with axes of
/// their own. Central differences of step 1e-6; tolerance 1e-6 of the derivative.
#[test]
fn hanging_nodes_by_differences() {
    for mut model in all_hanging() {
        for turned in [false, true] {
            if turned && model.is_in_space() {
                turn(&mut model, &[0, REFERENCE], [0.8, 0.6, -0.3]);
            }
            let about = if model.is_in_space() { [0.6, -1.1, 1.2] } else { [0.0, 0.0, 2.0] };
            with(&model, |dofs, constraints| {
                let mut u: Vec<f64> =
                    (0..dofs.len()).map(|k| 0.1 * (1.0 + k as f64).sin()).collect();
                for node in 0..REFERENCE {
                    let moved = rotation::displacement(&about, model.nodes.position(node));
                    for (axis, value) in moved.into_iter().enumerate() {
                        let dof = dofs.named(node, Dof::ALL[axis]);
                        dof.into_iter().for_each(|dof| u[dof] += value);
                    }
                }
                check_from(constraints, &[], u, 1e-6);
            });
        }
    }
}

/// Requirement: a cloud that moves rigidly, by any turn, takes the reference node with it as a rigid body
/// would, without rotations too; 1e-14 of its size.
#[test]
fn rigid_motion_is_kept() {
    let hanging = all_hanging();
    for model in models().iter().step_by(3).take(2).chain(&models()[5..6]).chain(&hanging) {
        with(model, |dofs, constraints| {
            let about = if model.is_in_space() { [0.6, -1.1, 1.2] } else { [0.0, 0.0, 2.5] };
            let mut u = vec![0.0; dofs.len()];
            let moved = |node: NodeIndex| {
                let turned = rotation::displacement(&about, model.nodes.position(node));
                [turned[0] + 3.0, turned[1] - 2.0, turned[2]]
            };
            for node in 0..REFERENCE {
                for (axis, value) in moved(node).into_iter().enumerate() {
                    dofs.find(node, Dof::ALL[axis]).into_iter().for_each(|dof| u[dof] = value);
                }
            }
            constraints.enforce(&[], &mut u);
            for (axis, value) in moved(REFERENCE).into_iter().enumerate() {
                let off = (dofs.read(&u, REFERENCE, Dof::ALL[axis]) - value).abs();
                assert!(!model.mean_motions[0].coupled[axis] || off < 1e-14, "{off:e}");
                let angle = dofs.read(&u, REFERENCE, Dof::ALL[3 + axis]);
                let coupled = model.mean_motions[0].coupled[3 + axis];
                assert!(!coupled || (angle - about[axis]).abs() < 1e-14, "{angle}");
            }
        });
    }
}
