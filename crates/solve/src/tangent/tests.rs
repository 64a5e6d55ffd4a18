//! The assembled tangent of a small model held against differences of its residual.

use super::*;
use crate::dofs::DofMap;
use crate::evaluate::evaluate;
use crate::linear_systems::LinearSystems;
use crate::plan::{Coupling, Plan};
use crate::problem::Means;
use crate::stabilise::Dashpots;
use crate::start::Start;
use crate::structure::Ambient;
use crate::values::Values;
use slideline_diag::Span;
use slideline_mech::contact::tangential::Tangential;
use slideline_mech::material::Elastic;
use slideline_model::*;

const AT: Span = Span { file: slideline_diag::FileId(0), start: 0, end: 0 };

fn prescribed(node: NodeIndex, dof: Dof) -> Prescribed {
    Prescribed { node, dof, value: 0.0, amplitude: None, fixed: false, origin: AT }
}

/// The first step of a model, prepared.
pub(crate) struct Prepared {
    pub plan: Plan,
    pub values: Values,
    coupling: Coupling,
    start: Start<'static>,
    pub linear_systems: LinearSystems,
}

impl Prepared {
    pub(crate) fn new(model: &Model) -> Self {
        let (plan, mut values) = (Plan::of(model), Values::default());
        values.take(&plan, model, &crate::users::UserFrictions::default()).unwrap();
        let coupling = plan.steps[0].coupling.clone().unwrap();
        let (mut start, linear_systems) = (Start::default(), LinearSystems::default());
        let state = State::undeformed(plan.dofs.len(), 0, (0, 0));
        start.take(&state, &plan.steps[0].constraints);
        Self { plan, values, coupling, start, linear_systems }
    }

    pub(crate) fn problem<'a>(&'a self, model: &'a Model) -> Problem<'a> {
        let means = Means { pool: None, linear_systems: &self.linear_systems };
        let taken = (&*self.plan, &self.values);
        Problem::new((model, 0), taken, &self.coupling, &self.start, means)
    }
}

/// A curved chain of six beams along x, and a free rigid body above it
/// with three slaves on its rim; `line`: the beams are the master,
/// otherwise an arc of the body is.
#[allow(clippy::too_many_lines)] // one model, told in one piece
pub(crate) fn model(line: bool, offset: Offset) -> Model {
    let mut model = Model::default();
    let mut node = |label: u64, x: f64, y: f64| {
        model.nodes.insert(Node { label, position: [x, y, 0.0], origin: AT })
    };
    let beam: Vec<_> =
        (0..7).map(|k| node(k + 1, k as f64, 0.05 * (k as f64 - 3.0).powi(2))).collect();
    let body = node(100, 3.2, 1.0);
    let rim: Vec<_> = [-0.5_f64, 0.0, 0.5]
        .iter()
        .zip(201..)
        .map(|(&t, label)| node(label, 3.2 + t.sin(), 1.0 - t.cos()))
        .collect();
    let section = BeamSection {
        shape: slideline_model::Shape::Rectangle { width: 1.0, height: 0.2 },
        heat: None,
        poisson: 0.0,
        material: Elastic { modulus: 1e3, poisson: 0.3 },
        shear: ShearRule::default(),
        first_axis: BeamSection::FIRST_AXIS,
    };
    let elements = (0..6).map(|k| (k as u64 + 1, [beam[k], beam[k + 1]]));
    let block = ElementBlock::new(&types::B21, "B", Section::Beam(section), AT);
    model.blocks.push(block.with(elements));
    model.rigid_links =
        rim.iter().map(|&dependent| RigidLink::welded(dependent, body, AT)).collect();
    let pairs = |nodes: &[NodeIndex]| -> Vec<ContactElement> {
        let of = |w: &[NodeIndex]| ContactElement {
            label: 1,
            nodes: [w[0], w[1]],
            lumping: slideline_model::Lumping::Halves,
            origin: AT,
        };
        nodes.windows(2).map(of).collect()
    };
    let (elements, master) = if line {
        let nodes = beam.clone();
        let line =
            SlideLine { nodes, middles: Vec::new(), smooth: Some(0.3), extension: 0.1, origin: AT };
        (pairs(&rim), Master::SlideLine(line))
    } else {
        let end = [4.2, 1.0];
        let segments = vec![
            SurfaceSegment::Circle { end: [3.2, 0.0], centre: [3.2, 1.0] },
            SurfaceSegment::Circle { end: [2.2, 1.0], centre: [3.2, 1.0] },
        ];
        let surface =
            RigidSurface { reference: body, start: end, segments, extension: 0.0, origin: AT };
        (pairs(&beam), Master::RigidSurface(surface))
    };
    let interaction = Interaction {
        width: 1.0,
        normal: NormalLaw::Exponential { clearance: 0.1, pressure: 2.0 },
        friction: Friction::Coulomb {
            coefficient: 0.4,
            second: None,
            limit: None,
            decay: None,
            stick: StickRule::ElasticSlip(0.05),
        },
        origin: AT,
        no_separation: false,
        normal_origin: None,
        friction_origin: None,
    };
    let name = "C".to_string();
    let formulation = Formulation::NodeToSurface;
    let origin = AT;
    let pair = ContactPair {
        is_piece: false,
        profile: None,
        of_solids: false,
        adjust: slideline_model::Adjust::Nothing,
        axes: [None; 2],
        left_out: Vec::new(),
        corners: Vec::new(),
        offset,
        slaves: Vec::new(),
        counts_sides: false,
        name,
        formulation,
        vocabulary: slideline_model::Vocabulary::Elements,
        faces: Vec::new(),
        elements,
        master,
        interaction,
        origin,
    };
    model.contact_pairs.push(pair);
    let fixed = [Dof::U1, Dof::U2, Dof::UR3];
    model.steps.push(Step {
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
        prescribed: fixed.iter().map(|&dof| prescribed(beam[0], dof)).collect(),
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
    });
    model
}

/// Requirement: the tangent is the derivative of the residual, with
/// beams, rigid links under a free rotation, normal rotation, curvature,
/// the exponential law, friction (stick and slip), surfaces that stand off and stabilisation
/// together.
/// Extrapolated differences with a step of 1e-7 leave 1e-9 by rounding;
/// tolerance 1e-7 of the largest entry of its kind.
#[test]
fn assembled_tangent_by_differences() {
    let standing = Offset { slave: 0.05, master: 0.03 };
    let cases = [(true, 0.3), (true, 0.02), (false, 0.3), (false, -0.02)];
    let cases = cases.into_iter().flat_map(|case| [(case, Offset::NONE), (case, standing)]);
    for ((line, direction), offset) in cases {
        let model = model(line, offset);
        let (dofs, points) =
            (DofMap::new(&model).len(), model.contact_pairs[0].slave_nodes().len());
        let mut committed = State::undeformed(dofs, points, (0, 0));
        let prepared = Prepared::new(&model);
        let plan = prepared.problem(&model);
        let mut evaluation = Evaluation::default();
        evaluation.fit(&plan);
        let (positions, kinematics) = (&mut MasterPositions::default(), &mut evaluation.kinematics);
        crate::commit::locate_points(plan.contact, None, &mut committed, (positions, kinematics));
        let body = model.nodes.find(100).unwrap();
        let mut u: Vec<f64> =
            (0..dofs).map(|k| 0.02 * ((k * 7919 % 13) as f64 / 6.0 - 1.0)).collect();
        u[..3].fill(0.0);
        let body = plan.dofs.of_node(body);
        u[body].copy_from_slice(&[direction, -0.06, 0.1 * direction]);
        plan.constraints.enforce(&[], &mut u);
        let mut dashpots = Dashpots::default();
        committed.stabilised = true;
        let halfway = (0.5, 0.5);
        crate::stabilise::fill(&plan, &committed, halfway, &mut dashpots);
        // as stiff as the contact itself, lest the differences miss it
        dashpots.scale_to(1.0);
        let (none, untouched) = (vec![0.0; points], vec![Tangential::ZERO; points]);
        let stresses = vec![0.0; plan.structure.stress_room()];
        let load = vec![0.0; dofs];
        let trial = Trial {
            faces: &[],
            stresses: &stresses,
            u: &u,
            load: &load,
            pressures: &none,
            tractions: &untouched,
            standing: &[],
            held: &[],
            dashpots: &dashpots,
            ambient: Ambient::default(),
            time: 1.0,
            dt: 1.0,
        };
        evaluate(&plan, &committed, &trial, &mut evaluation);
        assert!(evaluation.points.iter().any(|point| point.closed && point.traction.size() != 0.0));
        assert!(evaluation.damping.iter().any(|force| force.abs() > 1e-3));
        let place = Place { plan: &plan, committed: &committed, trial, evaluation: &evaluation };
        let report = check(&place, (1, 1));
        assert!(report.off < 1e-7, "{line} {direction}: {report:?}");
        assert!(fault(&plan, &report).is_none());
    }
}

/// Requirement: a point that was left alone and touches is found before a
/// state is taken, under a soft law and under a hard one, whose pressure is
/// zero until the contact step gives it one.
#[test]
fn idle_points_that_touch_are_found() {
    for law in [NormalLaw::Exponential { clearance: 0.1, pressure: 2.0 }, NormalLaw::Hard] {
        let mut model = model(true, Offset::NONE);
        model.contact_pairs[0].interaction.normal = law;
        let (dofs, points) =
            (DofMap::new(&model).len(), model.contact_pairs[0].slave_nodes().len());
        let mut committed = State::undeformed(dofs, points, (0, 0));
        let prepared = Prepared::new(&model);
        let plan = prepared.problem(&model);
        let mut evaluation = Evaluation::default();
        evaluation.fit(&plan);
        let (positions, kinematics) = (&mut MasterPositions::default(), &mut evaluation.kinematics);
        crate::commit::locate_points(plan.contact, None, &mut committed, (positions, kinematics));
        let (none, untouched) = (vec![0.0; points], vec![Tangential::ZERO; points]);
        let stresses = vec![0.0; plan.structure.stress_room()];
        let (mut u, load) = (vec![0.0; dofs], vec![0.0; dofs]);
        let body = plan.dofs.of_node(model.nodes.find(100).unwrap());
        let mut touches = |down: f64| {
            u[body.start + 1] = down;
            plan.constraints.enforce(&[], &mut u);
            let trial = Trial {
                faces: &[],
                stresses: &stresses,
                u: &u,
                load: &load,
                pressures: &none,
                tractions: &untouched,
                standing: &[],
                held: &[],
                dashpots: &Dashpots::default(),
                ambient: Ambient::default(),
                time: 1.0,
                dt: 1.0,
            };
            evaluation.look.forget();
            evaluate(&plan, &committed, &trial, &mut evaluation);
            evaluation.look.idle.fill(true);
            !crate::evaluate::complete(&plan, &committed, &trial, &mut evaluation)
        };
        assert!(!touches(0.5), "far above");
        assert!(touches(-0.1), "pressed in");
    }
}
