//! T and its derivatives, by differences and as transposes.

use super::*;
use crate::dofs::DofMap;
use slideline_diag::{FileId, Span};
use slideline_linalg::Pattern;
use slideline_mech::turn::Turn;
use slideline_model::{
    ContactElement, ContactPair, Controls, Dof, Extrapolation, Formulation, Friction, Interaction,
    Lumping, Master, Model, Node, NodeIndex, NormalLaw, OutputRequests, Passage, Prescribed,
    RigidSurface, Static, Step, Vocabulary,
};

pub(super) const AT: Span = Span { file: FileId(0), start: 0, end: 0 };

/// A body of node 0 that carries nodes 1 and 2 (2 by way of 1); node 3 follows
/// node 2 and node 4 linearly, node 5 follows node 3; of node 4 U1 is prescribed.
fn model() -> Model {
    let mut model = Model::default();
    for label in 0..6 {
        let position = [label as f64, 0.3 * (label as f64).powi(2), 0.0];
        model.nodes.insert(Node { label: label + 1, position, origin: AT });
    }
    let link = |dependent, master| slideline_model::RigidLink::welded(dependent, master, AT);
    model.rigid_links = vec![link(2, 1), link(1, 0)];
    let follow = |node, terms: &[(NodeIndex, Dof, f64)], constant| {
        let (dependent, terms) = ((node, Dof::U2), terms.to_vec());
        slideline_model::LinearConstraint { dependent, terms, constant, origin: AT }
    };
    // the last in the list comes first: order must not matter
    model.linear_constraints = vec![
        follow(5, &[(3, Dof::U2, -0.7), (4, Dof::U1, 2.0)], 0.0),
        follow(3, &[(2, Dof::U2, 0.25), (4, Dof::U2, 1.5)], 0.125),
    ];
    model.contact_pairs.push(contact());
    model.steps.push(step());
    model
}

/// A contact pair on nodes 3 to 5: their displacements are unknowns.
fn contact() -> ContactPair {
    let element = |nodes| ContactElement { label: 1, nodes, lumping: Lumping::Halves, origin: AT };
    ContactPair {
        profile: None,
        of_solids: false,
        name: String::new(),
        is_piece: false,
        formulation: Formulation::NodeToSurface,
        vocabulary: Vocabulary::Elements,
        adjust: slideline_model::Adjust::Nothing,
        axes: [None; 2],
        left_out: Vec::new(),
        corners: Vec::new(),
        offset: slideline_model::Offset::NONE,
        slaves: Vec::new(),
        counts_sides: false,
        faces: Vec::new(),
        elements: vec![element([3, 4]), element([4, 5])],
        master: Master::RigidSurface(RigidSurface {
            reference: 0,
            start: [0.0; 2],
            segments: vec![],
            extension: 0.0,
            origin: AT,
        }),
        interaction: Interaction {
            width: 1.0,
            normal: NormalLaw::Hard,
            friction: Friction::Frictionless,
            origin: AT,
            no_separation: false,
            normal_origin: None,
            friction_origin: None,
        },
        origin: AT,
    }
}

pub(super) fn step() -> Step {
    let prescribed =
        |node, dof| Prescribed { node, dof, value: 0.4, amplitude: None, fixed: false, origin: AT };
    Step {
        title: String::new(),
        nlgeom: true,
        max_increments: 1,
        unsymmetric: None,
        extrapolation: Extrapolation::None,
        at_once: false,
        procedure: Static {
            initial: 1.0,
            period: 1.0,
            minimum: 1.0,
            maximum: 1.0,
            direct: true,
            passage: Passage::default(),
            creep_tolerance: None,
            origin: None,
        },
        prescribed: vec![prescribed(4, Dof::U1)],
        loads: vec![],
        temperatures: vec![],
        controls: Controls::default(),
        presence: Default::default(),
        frictions: vec![],
        pressures: vec![],
        sections: vec![],
        interferences: vec![],
        stabilisation: None,
        distributed: Default::default(),
        output: OutputRequests::default(),
        origin: AT,
    }
}

struct Built {
    dofs: DofMap,
    numbering: ConstraintNumbering,
    motion: Motion,
    u: Vec<f64>,
    rows: Rows,
}

impl Built {
    fn constraints(&self) -> Constraints<'_> {
        Constraints { numbering: &self.numbering, motion: &self.motion }
    }
}

/// Gives nodes of a model axes of their own.
pub(super) fn turn(model: &mut Model, nodes: &[NodeIndex], way: [f64; 3]) {
    let system = slideline_model::System::rectangular(way, [-way[1], way[0], 0.3 * way[2]]);
    let transform =
        slideline_model::Transform { nodes: nodes.to_vec(), system: system.unwrap(), origin: AT };
    model.transforms.push(transform);
}

fn build() -> Built {
    let mut model = model();
    built(&mut model)
}

/// The same where a master, nodes of the body, and nodes of equations have axes of their own.
fn build_turned() -> Built {
    let mut model = model();
    turn(&mut model, &[0, 1, 5], [0.8, 0.6, 0.0]);
    turn(&mut model, &[2, 3], [-0.3, 0.7, 0.0]);
    built(&mut model)
}

fn built(model: &mut Model) -> Built {
    let dofs = DofMap::new(model);
    let numbering = ConstraintNumbering::new(model, &model.steps[0], &dofs);
    let mut motion = Motion::default();
    motion.take(&numbering, model);
    let constraints = Constraints { numbering: &numbering, motion: &motion };
    let mut u: Vec<f64> = (0..dofs.len()).map(|k| 0.3 * (1.0 + k as f64).sin()).collect();
    constraints.enforce(&[], &mut u);
    let mut rows = Rows::default();
    constraints.linearise((&u, &[]), &mut rows);
    Built { dofs, numbering, motion, u, rows }
}

/// Requirement: du = T dq is the derivative of the motion, through rigid links,
/// chains of them, and chains of linear constraints. Central differences of step
/// 1e-6; tolerance 1e-9.
#[test]
fn changes_by_differences() {
    [build(), build_turned()].iter().for_each(check_changes_by_differences);
}

fn check_changes_by_differences(built: &Built) {
    let (constraints, Built { u, rows, .. }) = (built.constraints(), built);
    assert_eq!(constraints.equations(), 3 + 2 + 1, "body, U1 of 3 and 5, U2 of 4");
    for &dof in &constraints.dof_of_equation {
        let moved = |by: f64| {
            let mut moved = u.clone();
            moved[dof] += by;
            constraints.enforce(&[], &mut moved);
            moved
        };
        let (up, down) = (moved(1e-6), moved(-1e-6));
        let mut change = vec![0.0; u.len()];
        change[dof] = 1.0;
        constraints.expand(rows, &mut change);
        for k in 0..u.len() {
            let difference = (up[k] - down[k]) / 2e-6;
            assert!((change[k] - difference).abs() < 1e-9, "{k} by {dof}: {}", change[k]);
        }
    }
}

/// Requirement: forces are handed over as T says, f . T dq = T' f . dq, and the
/// rows by equation are the same T.
#[test]
fn forces_are_the_transpose() {
    [build(), build_turned()].iter().for_each(check_forces_are_the_transpose);
}

fn check_forces_are_the_transpose(built: &Built) {
    let (constraints, Built { u, rows, .. }) = (built.constraints(), built);
    let force: Vec<f64> = (0..u.len()).map(|k| (0.7 * k as f64).cos()).collect();
    let mut carried = force.clone();
    constraints.carry(rows, &mut carried);
    for (equation, &dof) in constraints.dof_of_equation.iter().enumerate() {
        let mut change = vec![0.0; u.len()];
        change[dof] = 1.0;
        constraints.expand(rows, &mut change);
        let work: f64 = force.iter().zip(&change).map(|(f, du)| f * du).sum();
        assert!((carried[dof] - work).abs() < 1e-13, "{dof}");
        let mut by_rows = 0.0;
        for (k, f) in force.iter().enumerate() {
            let add = &mut |e: usize, a: f64| by_rows += if e == equation { a * f } else { 0.0 };
            constraints.for_each_equation(rows, k, add);
        }
        assert!((carried[dof] - by_rows).abs() < 1e-13, "{dof}");
    }
    let left = (0..u.len()).filter(|&dof| constraints.is_dependent(dof));
    assert!(left.into_iter().all(|dof| carried[dof] == 0.0));
}

/// Requirement: summed before entries are looked up, T' K T is what it is term by term.
#[test]
fn elements_are_carried_as_a_sum() {
    for built in [build(), build_turned()] {
        let (constraints, Built { u, rows, .. }) = (built.constraints(), &built);
        let dofs: Vec<usize> = (0..u.len()).collect();
        let tangent: Vec<f64> = (0..u.len() * u.len()).map(|k| (0.3 * k as f64).sin()).collect();
        let equations: Vec<usize> = (0..constraints.equations()).collect();
        let pattern = Pattern::from_cliques(equations.len(), [equations].iter());
        let mut values = [vec![0.0; pattern.entries()], vec![0.0; pattern.entries()]];
        let at = |i: usize, j: usize| tangent[i * dofs.len() + j];
        constraints.scatter((rows, &pattern), &dofs, at, &mut values[0]);
        let [by_terms, summed] = &mut values;
        super::carried::sum_of(&constraints, (rows, &pattern), (&dofs, &tangent), summed);
        let off = by_terms.iter().zip(summed).map(|(a, b)| (a - *b).abs());
        assert!(off.fold(0.0, f64::max) < 1e-12);
        assert!(by_terms.iter().any(|value| value.abs() > 0.1));
    }
}

/// Requirement: of forces that stay, T' f changes by the turning alone. Central
/// differences of step 1e-6; tolerance 1e-8.
#[test]
fn turning_by_differences() {
    [build(), build_turned()].iter().for_each(check_turning_by_differences);
}

fn check_turning_by_differences(built: &Built) {
    let (constraints, Built { dofs, u, .. }) = (built.constraints(), built);
    let force: Vec<f64> = (0..u.len()).map(|k| (0.7 * k as f64).cos()).collect();
    let carried = |by: f64, dof: usize| {
        let (mut moved, mut carried, mut rows) = (u.clone(), force.clone(), Rows::default());
        moved[dof] += by;
        constraints.enforce(&[], &mut moved);
        constraints.linearise((&moved, &[]), &mut rows);
        constraints.carry(&rows, &mut carried);
        carried
    };
    let turn = dofs.named(0, Dof::UR3).unwrap();
    let mut stiffness = 0.0;
    let mut rows = Rows::default();
    constraints.linearise((u, &[]), &mut rows);
    constraints.turning(&rows, (u, &[]), &mut force.clone(), |_, _, k| stiffness += k);
    for &dof in &constraints.dof_of_equation {
        let (up, down) = (carried(1e-6, dof), carried(-1e-6, dof));
        for &row in &constraints.dof_of_equation {
            let difference = (up[row] - down[row]) / 2e-6;
            let expected = if (row, dof) == (turn, turn) { stiffness } else { 0.0 };
            assert!((difference - expected).abs() < 1e-8, "{row} {dof}: {difference}");
        }
    }
}

/// A point that moves in space and gives no force: dofs without physics.
pub(super) static POINT_IN_SPACE: slideline_model::ElementType = slideline_model::ElementType {
    names: ["POINT"; 2],
    cell: &slideline_mech::element::cell::POINT,
    dofs: &Dof::ALL,
    kinematics: slideline_model::Kinematics::Other,
    points: 0,
    states: |_| 0,
    fields: &[],
    at_nodes: slideline_model::mean_at_nodes,
    kernel: |_, _| None,
};

/// A body in space whose rotation is the displacement of node 3; node 1 is welded to it, node 2
/// pinned to it, and U3 of node 4 follows node 1 and U1 of node 4.
fn in_space() -> Model {
    let mut model = Model::default();
    for label in 0..5 {
        let x = f64::from(label);
        let position = [x, 0.3 * x * x, 1.0 - 0.2 * x];
        model.nodes.insert(Node { label: label as u64 + 1, position, origin: AT });
    }
    let section = slideline_model::Section::Properties(vec![]);
    let block = slideline_model::ElementBlock::new(&POINT_IN_SPACE, "P", section, AT);
    model.blocks = vec![block.with((0..5).map(|node| (node as u64 + 1, [node])))];
    let link = |dependent, follows| slideline_model::RigidLink {
        dependent,
        master: 0,
        follows,
        turn: Some(3),
        origin: AT,
    };
    use slideline_model::RigidLink as Link;
    model.rigid_links = vec![link(1, Link::WELDED), link(2, Link::PINNED)];
    model.linear_constraints = vec![slideline_model::LinearConstraint {
        dependent: (4, Dof::U3),
        terms: vec![(1, Dof::U3, 0.5), (4, Dof::U1, -0.3)],
        constant: 0.1,
        origin: AT,
    }];
    model.steps.push(Step { prescribed: vec![], ..step() });
    model
}

/// Requirement: in space too T is the derivative of the motion and its transpose carries forces,
/// with a rotation node, pinned nodes and equations; the turning is the derivative of T' f.
/// Central differences of step 1e-6; tolerance 1e-8.
#[test]
fn bodies_in_space_by_differences() {
    check_bodies_in_space(&in_space());
    let mut turned = in_space();
    turn(&mut turned, &[0, 4], [0.8, 0.6, -0.3]);
    turn(&mut turned, &[1, 3], [0.2, -0.5, 0.4]);
    turn(&mut turned, &[2], [0.1, 0.9, 0.7]);
    // of the pinned node one component of its own axes follows
    turned.rigid_links[1].follows = [false, true, false, false, false, false];
    check_bodies_in_space(&turned);
}

fn check_bodies_in_space(model: &Model) {
    let dofs = DofMap::new(model);
    let numbering = ConstraintNumbering::new(model, &model.steps[0], &dofs);
    let mut motion = Motion::default();
    motion.take(&numbering, model);
    let constraints = Constraints { numbering: &numbering, motion: &motion };
    // the body 3, the rotation node 6 (its own rotations stay free), pinned 3 or 5, others 6 - 1
    let pinned = if model.transforms.is_empty() { 3 } else { 5 };
    assert_eq!(constraints.equations(), 6 + 6 + pinned + 5);
    check_by_differences(&constraints, dofs.len());
}

/// T at displacements without a pattern is the derivative of the motion, its transpose carries forces
/// of the same work, and the turning is the derivative of T' f.
fn check_by_differences(constraints: &Constraints<'_>, count: usize) {
    let u = (0..count).map(|k| 0.3 * (1.0 + k as f64).sin()).collect();
    check_from(constraints, &[], u, 1e-8);
}

/// The same from displacements, to a part of one or of the derivative.
pub(super) fn check_from(
    constraints: &Constraints<'_>,
    turns: &[Turn],
    mut u: Vec<f64>,
    part: f64,
) {
    let count = u.len();
    let same = |a: f64, b: f64| (a - b).abs() < part * b.abs().max(1.0);
    constraints.enforce(turns, &mut u);
    let force: Vec<f64> = (0..u.len()).map(|k| (0.7 * k as f64).cos()).collect();
    let at = |by: f64, dof: usize| {
        let (mut moved, mut carried, mut rows) = (u.clone(), force.clone(), Rows::default());
        moved[dof] += by;
        constraints.enforce(turns, &mut moved);
        constraints.linearise((&moved, turns), &mut rows);
        constraints.carry(&rows, &mut carried);
        (moved, carried)
    };
    let mut rows = Rows::default();
    constraints.linearise((&u, turns), &mut rows);
    let mut stiffness = vec![0.0; count * count];
    constraints.turning(&rows, (&u, turns), &mut force.clone(), |i, j, k| {
        constraints.for_each_equation(&rows, i, &mut |i, a| {
            constraints.for_each_equation(&rows, j, &mut |j, b| {
                let [i, j] = [i, j].map(|equation| constraints.dof_of_equation[equation]);
                stiffness[i * count + j] += a * b * k;
            });
        });
    });
    for &dof in &constraints.dof_of_equation {
        let ((up, force_up), (down, force_down)) = (at(1e-6, dof), at(-1e-6, dof));
        let mut change = vec![0.0; count];
        change[dof] = 1.0;
        constraints.expand(&rows, &mut change);
        for k in 0..count {
            let difference = (up[k] - down[k]) / 2e-6;
            assert!(same(change[k], difference), "{k} by {dof}: {} {difference}", change[k]);
        }
        let work: f64 = force.iter().zip(&change).map(|(f, du)| f * du).sum();
        assert!((at(0.0, dof).1[dof] - work).abs() < 1e-5 * part * work.abs().max(1.0));
        for &row in &constraints.dof_of_equation {
            let difference = (force_up[row] - force_down[row]) / 2e-6;
            let stiffness = stiffness[row * count + dof];
            assert!(same(stiffness, difference), "{row} {dof}: {stiffness} {difference}");
        }
    }
}

/// Nodes 0 to 2 on a line, node 5 in the plane of 0, 2 and 4, and a mean turn of 0, 2, 4 and 6, the
/// angle of which is U1 of node 7: a chain of all three; node 3 is linked to
/// node 1.
fn keeping_shapes(follower: (NodeIndex, Dof)) -> Model {
    use slideline_mech::kept_shape::KeptShape as Shape;
    let mut model = Model::default();
    for label in 0..8 {
        let x = label as f64;
        let position = match label {
            0..3 => [x, 0.5 * x, 1.0 - 0.2 * x],
            _ => [(1.3 * x).cos(), 2.0 * (0.9 * x).sin(), 0.4 * x],
        };
        model.nodes.insert(Node { label: label + 1, position, origin: AT });
    }
    let section = slideline_model::Section::Properties(vec![]);
    let block = slideline_model::ElementBlock::new(&POINT_IN_SPACE, "P", section, AT);
    model.blocks = vec![block.with((0..8).map(|node| (node as u64 + 1, [node])))];
    let mut keep = |dependent, shape, nodes: &[NodeIndex], angle| {
        let (terms, constraint) = (Vec::new(), model.linear_constraints.len());
        let own = slideline_model::LinearConstraint { dependent, terms, constant: 0.0, origin: AT };
        model.linear_constraints.push(own);
        let nodes = nodes.to_vec();
        model.shapes.push(slideline_model::KeptShape { constraint, shape, nodes, angle });
    };
    keep(follower, Shape::MeanTurn([0.0, 0.6, 0.8]), &[0, 2, 4, 6], Some(7));
    keep((3, Dof::U1), Shape::Distance, &[1, 3], None);
    keep((5, Dof::U3), Shape::Plane, &[0, 2, 4, 5], None);
    keep((2, Dof::U2), Shape::Line(1, 0), &[0, 1, 2], None);
    keep((2, Dof::U3), Shape::Line(2, 0), &[0, 1, 2], None);
    model.steps.push(Step { prescribed: vec![], nlgeom: true, ..step() });
    model
}

/// Requirement: what keeps a line, a plane or a mean turn moves and turns as differences say, in a
/// chain and whichever dof follows; without large motion nothing is kept but the equations.
/// Central differences of step 1e-6; tolerance 1e-8.
#[test]
fn kept_shapes_by_differences() {
    for follower in [(7, Dof::U1), (6, Dof::U1)] {
        let mut model = keeping_shapes(follower);
        let dofs = DofMap::new(&model);
        let check = |model: &Model, shapes: bool| {
            let numbering = ConstraintNumbering::new(model, &model.steps[0], &dofs);
            assert_eq!(numbering.turns(), shapes);
            let mut motion = Motion::default();
            motion.take(&numbering, model);
            let constraints = Constraints { numbering: &numbering, motion: &motion };
            check_by_differences(&constraints, dofs.len());
        };
        check(&model, true);
        model.steps[0].nlgeom = false;
        check(&model, false);
    }
}
