//! Every type of element together, through the lists of dofs.

use super::*;
use crate::constraints::{ConstraintNumbering, Constraints, Motion, Rows};
use crate::dofs::DofMap;
use crate::observe::results::BlockResults;
use slideline_diag::{FileId, Span};
use slideline_linalg::Pattern;
use slideline_mech::material::Elastic;
use slideline_model::*;

const AT: Span = Span { file: FileId(0), start: 0, end: 0 };

fn beams<const N: usize>(kind: &'static ElementType, nodes: Vec<[NodeIndex; N]>) -> ElementBlock {
    let material = Elastic { modulus: 1e3, poisson: 0.3 };
    let shear = ShearRule::default();
    let shape = slideline_model::Shape::Rectangle { width: 1.0, height: 0.2 };
    let (poisson, heat, first_axis) = (0.0, None, BeamSection::FIRST_AXIS);
    let section = BeamSection { shape, poisson, material, heat, shear, first_axis };
    let block = ElementBlock::new(kind, "B", Section::Beam(section), AT);
    block.with(nodes.into_iter().map(|nodes| (1, nodes)))
}

fn step() -> Step {
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
        prescribed: vec![],
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

/// A chain of `count` nodes on a parabola, the last of them and the first of
/// the springs riding on a body.
fn model(count: usize) -> Model {
    let mut model = Model::default();
    let mut node = |k: usize| {
        let x = k as f64;
        let position = [x, 0.02 * x * (6.0 - x), 0.0];
        model.nodes.insert(Node { label: k as u64 + 1, position, origin: AT })
    };
    let n: Vec<NodeIndex> = (0..count + 2).map(&mut node).collect();
    let (rider, body) = (n[count], n[count + 1]);
    let spring = Section::Spring(SpringSection {
        law: slideline_model::SpringLaw::Linear(7.0),
        way: slideline_model::SpringWay::Line { in_space: false },
    });
    let spring = ElementBlock::new(&types::SPRINGA, "S", spring, AT);
    let row = n[..count].windows(2).map(|w| [w[0], w[1]]);
    model.blocks = vec![
        beams(&types::B22, vec![[n[0], n[1], n[2]], [n[2], n[3], rider]]),
        beams(&types::B23, vec![[n[0], n[2]], [n[1], rider]]),
        spring.with([(1, [n[1], rider])]),
        beams(&types::B21, row.collect()),
    ];
    model.rigid_links = vec![RigidLink::welded(rider, body, AT)];
    model
}

fn at<'a>(u: &'a [f64], stresses: Option<&'a [f64]>) -> Configuration<'a> {
    Configuration { u, stresses, state: &[], ambient: Ambient::default() }
}

struct Built {
    dofs: DofMap,
    constraints: ConstraintNumbering,
    motion: Motion,
    elements: ElementNumbering,
    kernels: Kernels,
    dependent: Vec<usize>,
    entries: Vec<u32>,
    pattern: Pattern,
    nlgeom: bool,
}

impl Built {
    fn constraints(&self) -> Constraints<'_> {
        Constraints { numbering: &self.constraints, motion: &self.motion }
    }

    fn structure(&self) -> Structure<'_> {
        Structure {
            absent: &[],
            references: &[],
            initial: &[],
            numbering: &self.elements,
            kernels: &self.kernels,
            dependent: &self.dependent,
            entries: &self.entries,
            nlgeom: self.nlgeom,
            stiffest: self.kernels.stiffest,
            stiffest_length: self.kernels.stiffest_length,
        }
    }

    /// Matrix values of the elements at `u`, and what they do with `vector`.
    fn gathered(
        &self,
        (u, stresses): (&[f64], Option<&[f64]>),
        vector: &[f64],
        pool: Option<&rayon::ThreadPool>,
    ) -> (Vec<f64>, Contributions, Vec<f64>) {
        let (structure, constraints) = (self.structure(), self.constraints());
        let (mut room, mut rows) = (structure.room(), Rows::default());
        let (mut values, mut into) = (vec![0.0; self.pattern.entries()], vec![0.0; u.len()]);
        constraints.linearise((u, &[]), &mut rows);
        let gather = Gather {
            constraints,
            rows: &rows,
            pattern: &self.pattern,
            values: &mut values,
            product: Some(Product { vector, into: &mut into }),
            keep: None,
        };
        structure.evaluate(&at(u, stresses), &mut room, gather, pool);
        (values, room, into)
    }

    /// Matrix values at `u`, with what the turning of the arm makes of the
    /// forces of the stresses.
    fn tangent(&self, u: &[f64], stresses: Option<&[f64]>) -> (Vec<f64>, Contributions) {
        let (mut values, room, _) = self.gathered((u, stresses), u, None);
        let mut force = vec![0.0; u.len()];
        self.structure().turning_forces((u, &[]), stresses, &room, &mut force);
        let mut rows = Rows::default();
        self.constraints().linearise((u, &[]), &mut rows);
        self.constraints().turning(&rows, (u, &[]), &mut force, |dof, _, stiffness| {
            let own = self.constraints.equation(dof).unwrap();
            values[self.pattern.position(own, own).unwrap()] += stiffness;
        });
        (values, room)
    }

    /// Energy and carried force.
    fn force(&self, u: &[f64]) -> (f64, Vec<f64>) {
        let (mut room, mut force) = (self.structure().room(), vec![0.0; u.len()]);
        self.structure().evaluate_forces(&at(u, None), &mut room, None);
        let energy = self.structure().gather_force(&room, &mut force);
        let mut rows = Rows::default();
        self.constraints().linearise((u, &[]), &mut rows);
        self.constraints().carry(&rows, &mut force);
        (energy, force)
    }
}

fn build(model: &Model, nlgeom: bool) -> Built {
    let dofs = DofMap::new(model);
    let constraints = ConstraintNumbering::new(model, &step(), &dofs);
    let elements = ElementNumbering::new(model, &dofs, &constraints);
    let dependent = elements.dependent(&constraints);
    let equations = |own: &[usize]| -> Vec<usize> {
        let mut into = Vec::new();
        own.iter().for_each(|&dof| constraints.equations_of(dof, &mut into));
        into
    };
    let pattern = Pattern::from_cliques(constraints.equations(), elements.cliques().map(equations));
    let entries = elements.entries(&dependent, &constraints, &pattern);
    let (mut motion, mut kernels) = (Motion::default(), Kernels::default());
    motion.take(&constraints, model);
    kernels.take(&elements, model, (&[], &[])).unwrap();
    Built { dofs, constraints, motion, elements, kernels, dependent, entries, pattern, nlgeom }
}

fn motion(built: &Built) -> Vec<f64> {
    let count = built.dofs.len();
    let mut u: Vec<f64> = (0..count).map(|k| 0.03 * ((k * 7919 % 13) as f64 / 6.0 - 1.0)).collect();
    built.constraints().enforce(&[], &mut u);
    u
}

/// Requirement: the gathered tangent is the derivative of the gathered force,
/// K v its product, and the force the derivative of the energy, with a node
/// on a rigid arm. Central differences of step 1e-6; tolerance 1e-6 of the
/// largest entry.
#[test]
fn gathered_tangent_by_differences() {
    let model = model(4);
    let built = build(&model, true);
    let (constraints, pattern) = (built.constraints(), &built.pattern);
    let u = motion(&built);
    let (values, _) = built.tangent(&u, None);
    let largest = values.iter().fold(0.0_f64, |most, k| most.max(k.abs()));
    let here = built.force(&u).1;
    let mut rows = Rows::default();
    constraints.linearise((&u, &[]), &mut rows);
    // without the turning of the arm: the product of K of the elements alone
    let (flat, ..) = built.gathered((&u, None), &u, None);
    for column in 0..constraints.equations() {
        let dof = constraints.dof_of_equation[column];
        let moved = |sign: f64| {
            let mut moved = u.clone();
            moved[dof] += sign * 1e-6;
            constraints.enforce(&[], &mut moved);
            built.force(&moved)
        };
        let (up, down) = (moved(1.0), moved(-1.0));
        assert!(((up.0 - down.0) / 2e-6 - here[dof]).abs() < 1e-6 * largest, "{dof}");
        for row in 0..constraints.equations() {
            let at = constraints.dof_of_equation[row];
            let difference = (up.1[at] - down.1[at]) / 2e-6;
            let entry = pattern.position(row, column).map_or(0.0, |place| values[place]);
            assert!((difference - entry).abs() < 1e-6 * largest, "{row} {column}");
        }
        let mut unit = vec![0.0; u.len()];
        unit[dof] = 1.0;
        constraints.expand(&rows, &mut unit);
        let (.., mut product) = built.gathered((&u, None), &unit, None);
        constraints.carry(&rows, &mut product);
        for row in 0..constraints.equations() {
            let entry = pattern.position(row, column).map_or(0.0, |place| flat[place]);
            let off = product[constraints.dof_of_equation[row]] - entry;
            assert!(off.abs() < 1e-13 * largest, "{row} {column}");
        }
    }
}

/// Requirement: without NLGEOM the force is the tangent times u.
#[test]
fn linear_kinematics() {
    let model = model(4);
    let built = build(&model, false);
    let (constraints, structure) = (built.constraints(), built.structure());
    let mut u = motion(&built);
    u[3 * 5..].fill(0.0); // a rigid arm turns by a finite angle all the same
    constraints.enforce(&[], &mut u);
    let (_, room, product) = built.gathered((&u, None), &u, None);
    let mut force = vec![0.0; u.len()];
    let energy = structure.gather_force(&room, &mut force);
    let work: f64 = force.iter().zip(&u).map(|(f, u)| f * u).sum();
    assert!((work - 2.0 * energy).abs() < 1e-12 * energy, "{work} {energy}");
    let free = constraints.dof_of_equation.iter().filter(|&&dof| dof < 12);
    for &dof in free {
        assert!((force[dof] - product[dof]).abs() < 1e-10, "{dof}");
    }
    let mut results = Vec::new();
    structure.results(&u, (&[], Ambient::default()), &mut results);
    let of = |block: &BlockResults| block.elements(&model).count();
    assert_eq!(results.iter().map(of).collect::<Vec<_>>(), [2, 2, 0, 3], "springs have no results");
    // SF1, SF2, SM1, SE1, SE2, SK1
    let (_, b23) = results[1].elements(&model).next().unwrap();
    assert!(b23.len() == 6 && b23[4] == 0.0 && b23[1] != 0.0, "B23 has V without strain");
}

/// Requirement: the same bits on one thread and on several.
#[test]
fn threads_change_nothing() {
    let model = model(evaluate::PARALLEL + 300);
    let built = build(&model, true);
    let u = motion(&built);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().unwrap();
    let stresses = vec![0.3; built.structure().stress_room()];
    let (values, one, product) = built.gathered((&u, Some(&stresses)), &u, None);
    let (others, many, other) = built.gathered((&u, Some(&stresses)), &u, Some(&pool));
    assert!(one.force == many.force && one.energy == many.energy);
    assert!(values == others && product == other);
    assert!(one.force.iter().any(|&f| f != 0.0));
}

/// Requirement: with the stresses of the strains the mixed tangent is the
/// tangent, with a node on a rigid arm; force and energy have the same bits
/// whatever the stresses; the tangent is linear in them. Tolerance: rounding
/// of sums in another order.
#[test]
fn mixed_tangent_with_own_stresses() {
    let model = model(4);
    let built = build(&model, true);
    let structure = built.structure();
    let u = motion(&built);
    let tangent = |stresses: Option<&[f64]>| built.tangent(&u, stresses);
    let (exact, room) = tangent(None);
    let largest = exact.iter().fold(0.0_f64, |most, k| most.max(k.abs()));
    let mut own = vec![0.0; structure.stress_room()];
    assert!(own.len() > 12);
    structure.stresses_after(&u, &vec![0.0; u.len()], &Ambient::default(), &mut own);
    let (mixed, _) = tangent(Some(&own));
    let off = |a: f64, b: f64| assert!((a - b).abs() < 1e-12 * largest, "{a} {b}");
    mixed.iter().zip(&exact).for_each(|(&a, &b)| off(a, b));
    let other: Vec<f64> = (0..own.len()).map(|k| own[k] + 10.0 * (k as f64).sin()).collect();
    let half: Vec<f64> = own.iter().zip(&other).map(|(a, b)| 0.5 * (a + b)).collect();
    let (other, far) = tangent(Some(&other));
    assert!(far.force.iter().zip(&room.force).all(|(a, b)| (a - b).abs() < 1e-12 * largest));
    assert_eq!(far.energy, room.energy);
    assert!(other.iter().zip(&exact).any(|(a, b)| (a - b).abs() > 1e-6 * largest));
    let (half, _) = tangent(Some(&half));
    for ((a, b), middle) in exact.iter().zip(&other).zip(half) {
        off(0.5 * (a + b), middle);
    }
}

/// Requirement: stresses arrive where their derivative along the correction
/// leads, dependent nodes following their masters. Central differences of
/// step 1e-6; tolerance 1e-6 of the largest.
#[test]
fn stresses_after_by_differences() {
    let model = model(4);
    let built = build(&model, true);
    let (constraints, structure) = (built.constraints(), built.structure());
    let u = motion(&built);
    let mut change = vec![0.0; u.len()];
    for (k, &dof) in constraints.dof_of_equation.iter().enumerate() {
        change[dof] = 0.1 * (k as f64 + 0.3).sin();
    }
    let mut rows = Rows::default();
    constraints.linearise((&u, &[]), &mut rows);
    constraints.expand(&rows, &mut change);
    let still = vec![0.0; u.len()];
    let at = |t: f64| {
        let mut moved: Vec<f64> = u.iter().zip(&change).map(|(u, du)| u + t * du).collect();
        constraints.enforce(&[], &mut moved);
        let mut stresses = vec![0.0; structure.stress_room()];
        structure.stresses_after(&moved, &still, &Ambient::default(), &mut stresses);
        stresses
    };
    let (here, up, down) = (at(0.0), at(1e-6), at(-1e-6));
    let mut arrived = vec![0.0; structure.stress_room()];
    structure.stresses_after(&u, &change, &Ambient::default(), &mut arrived);
    let largest = arrived.iter().fold(0.0_f64, |most, s| most.max(s.abs()));
    for k in 0..here.len() {
        let line = here[k] + (up[k] - down[k]) / 2e-6;
        assert!((arrived[k] - line).abs() < 1e-6 * largest, "{k}: {} {line}", arrived[k]);
    }
}

/// Requirement: tangents that are kept do with a vector what those of all elements do, and blocks alone
/// have the forces and energies that they have among all.
#[test]
fn parts_are_those_of_the_whole() {
    let built = build(&model(4), true);
    let u = motion(&built);
    let (structure, constraints) = (built.structure(), built.constraints());
    let (mut rows, mut values) = (Rows::default(), vec![0.0; built.pattern.entries()]);
    constraints.linearise((&u, &[]), &mut rows);
    let all: Vec<usize> = (0..structure.numbering.count).collect();
    let mut tangents = Vec::new();
    let gather = Gather {
        constraints,
        rows: &rows,
        pattern: &built.pattern,
        values: &mut values,
        product: None,
        keep: Some(Keep { elements: &all, into: &mut tangents }),
    };
    let (mut whole, mut parts) = (structure.room(), structure.room());
    structure.evaluate(&at(&u, None), &mut whole, gather, None);
    let (.., product) = built.gathered((&u, None), &u, None);
    let mut kept = vec![0.0; u.len()];
    structure.multiply_kept((&all, &tangents), &u, &mut kept);
    assert_eq!(product, kept);
    let (mut force, mut of_parts) = (vec![0.0; u.len()], vec![0.0; u.len()]);
    let stored = structure.gather_force(&whole, &mut force);
    let mut sum = 0.0;
    for (number, _) in structure.blocks() {
        structure.evaluate_block(number, &at(&u, None), &mut parts, None);
        sum += structure.add_block(number, (2.0, &parts), &mut of_parts).unwrap();
    }
    assert!((sum - 2.0 * stored).abs() <= 1e-14 * stored);
    force.iter().zip(&of_parts).for_each(|(one, two)| assert_eq!(2.0 * one, *two));
}
