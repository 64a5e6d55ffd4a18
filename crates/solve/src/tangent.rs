//! The tangent of the residual, and its check against differences.
//!
//! ```text
//!   r(u) = f_int(u) + sum A (p a + tau b) - f_ext
//!   K    = dr/du = elements + geometry + sum A [ p' a a' + b (tau_s s + tau_p p' a)' ]
//! ```
//!
//! The contact step never forms K: it keeps the laws (see
//! [`crate::linearised`]). It is formed here to be held against differences
//! of the residual, law and geometry, friction and rigid links together.

use crate::contact::GeometryScratch;
use crate::evaluate::{Evaluation, Trial, evaluate};
use crate::plan::Plan;
use crate::state::State;
use slideline_mech::contact::pair::{PointTrial, UserMemory};

/// A dense tangent, row-major over the equations.
#[derive(Clone, Debug)]
pub struct Tangent {
    /// Number of equations.
    pub equations: usize,
    /// Entries [F/L and the like].
    pub entries: Vec<f64>,
}

/// The tangent at a trial state of soft laws and elastic stick, with the
/// evaluation of that state.
pub fn tangent(
    plan: &Plan<'_>,
    committed: &State,
    trial: &Trial<'_>,
    evaluation: &Evaluation,
) -> Tangent {
    let n = plan.layout.equations();
    let mut values = vec![0.0; plan.pattern.entries()];
    plan.structure.gather_tangent(&evaluation.contributions, &mut values);
    let mut entries = vec![0.0; n * n];
    for i in 0..n {
        let start = plan.pattern.row_start()[i];
        for (k, &j) in plan.pattern.row(i).iter().enumerate() {
            entries[i * n + j] = values[start + k];
        }
    }
    let mut tangent = Tangent { equations: n, entries };
    for place in 0..plan.contact.points.len() {
        tangent.add_point(plan, committed, trial, evaluation, place);
    }
    tangent
}

impl Tangent {
    fn add_point(
        &mut self,
        plan: &Plan<'_>,
        committed: &State,
        trial: &Trial<'_>,
        evaluation: &Evaluation,
        place: usize,
    ) {
        let point = &plan.contact.points[place];
        let (meeting, now) = (&evaluation.meetings[place], &evaluation.points[place]);
        if !now.closed {
            return;
        }
        let laws = &plan.contact.laws[point.pair];
        let before = &committed.points[place];
        let slip = plan.contact.slip(place, &before.history(), meeting, &committed.displacement);
        let response = laws.respond(
            &before.history(),
            &PointTrial {
                overclosure: meeting.overclosure,
                slip,
                pressure: now.pressure,
                traction: now.traction,
                stiffness: 0.0,
                dt: trial.dt,
            },
            &mut UserMemory {
                time: trial.time,
                committed: &committed.memory[point.memory..point.memory + point.memory_size],
                state: &mut vec![0.0; point.memory_size],
                fault: &mut None,
            },
        );
        let slope = laws.normal.pressure(meeting.overclosure).map_or(0.0, |(_, slope)| slope);
        let traction = response.traction;
        let mut scratch = GeometryScratch::new(&plan.contact);
        plan.contact.fill_scratch(trial.u, &mut scratch);
        let forces = (now.area * now.pressure, now.area * now.traction);
        plan.contact.geometric_tangent(place, trial.u, meeting, forces, &mut scratch);
        let geometry = &scratch.tangent;
        let (a, b, drag) = (&meeting.gradient, &meeting.slip_gradient, &meeting.drag);
        for i in 0..meeting.width {
            let Some(row) = plan.layout.equation(meeting.slots[i]) else { continue };
            for j in 0..meeting.width {
                let Some(column) = plan.layout.equation(meeting.slots[j]) else { continue };
                let by_slip = traction.d_tau_d_slip * b[j];
                let by_pressure = traction.d_tau_d_pressure * slope * a[j];
                let law = slope * a[i] * a[j] + drag[i] * (by_slip + by_pressure);
                self.entries[row * self.equations + column] +=
                    geometry[meeting.width * i + j] + now.area * law;
            }
        }
    }
}

/// A column of the tangent by central differences of the residual.
pub fn column_by_differences(
    plan: &Plan<'_>,
    committed: &State,
    trial: &Trial<'_>,
    equation: usize,
    step: f64,
) -> Vec<f64> {
    let mut evaluation = Evaluation::new(plan);
    let mut residual = |sign: f64| -> Vec<f64> {
        let mut u = trial.u.to_vec();
        u[plan.layout.slot_of_equation[equation]] += sign * step;
        plan.layout.follow_links(&mut u);
        evaluate(plan, committed, &Trial { u: &u, ..*trial }, &mut evaluation);
        let at = |&slot: &usize| evaluation.internal[slot] + evaluation.contact[slot];
        plan.layout.slot_of_equation.iter().map(at).collect()
    };
    let (up, down) = (residual(1.0), residual(-1.0));
    up.iter().zip(down).map(|(u, d)| (u - d) / (2.0 * step)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use slideline_diag::Span;
    use slideline_mech::material::Elastic;
    use slideline_model::*;

    const AT: Span = Span { file: slideline_diag::FileId(0), start: 0, end: 0 };

    fn prescribed(node: NodeIndex, dof: Dof) -> Prescribed {
        Prescribed { node, dof, value: 0.0, amplitude: None, origin: AT }
    }

    /// A curved chain of six beams along x, and a free rigid body above it
    /// with three slaves on its rim; `line`: the beams are the master,
    /// otherwise an arc of the body is.
    #[allow(clippy::too_many_lines)] // one model, told in one piece
    fn model(line: bool) -> Model {
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
            width: 1.0,
            height: 0.2,
            poisson: 0.0,
            material: Elastic { modulus: 1e3, poisson: 0.3 },
            shear: ShearRule::default(),
        };
        let elements = (0..6).map(|k| BeamElement {
            label: k as u64 + 1,
            nodes: [beam[k], beam[k + 1]],
            middle: None,
            origin: AT,
        });
        let block =
            BeamBlock { name: "B".into(), section, elements: elements.collect(), origin: AT };
        model.blocks.push(ElementBlock::B21(block));
        model.rigid_links = rim
            .iter()
            .map(|&dependent| RigidLink { dependent, master: body, origin: AT })
            .collect();
        let pairs = |nodes: &[NodeIndex]| -> Vec<ContactElement> {
            let of = |w: &[NodeIndex]| ContactElement { label: 1, nodes: [w[0], w[1]], origin: AT };
            nodes.windows(2).map(of).collect()
        };
        let (elements, master) = if line {
            let nodes = beam.clone();
            let line = SlideLine { nodes, smooth: 0.3, extension: 0.1, origin: AT };
            (pairs(&rim), Master::SlideLine(line))
        } else {
            let end = [4.2, 1.0];
            let segments = vec![
                SurfaceSegment::Circle { end: [3.2, 0.0], centre: [3.2, 1.0] },
                SurfaceSegment::Circle { end: [2.2, 1.0], centre: [3.2, 1.0] },
            ];
            let surface = RigidSurface { reference: body, start: end, segments, origin: AT };
            (pairs(&beam), Master::RigidSurface(surface))
        };
        let interaction = Interaction {
            width: 1.0,
            normal: NormalLaw::Exponential { clearance: 0.1, pressure: 2.0 },
            friction: Friction::Coulomb {
                coefficient: 0.4,
                limit: None,
                decay: None,
                stick: StickRule::ElasticSlip(0.05),
            },
            origin: AT,
            normal_origin: None,
            friction_origin: None,
        };
        let name = "C".to_string();
        let formulation = Formulation::NodeToSurface;
        let origin = AT;
        let pair = ContactPair { name, formulation, elements, master, interaction, origin };
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
                origin: None,
            },
            prescribed: fixed.iter().map(|&dof| prescribed(beam[0], dof)).collect(),
            loads: vec![],
            controls: Controls::default(),
            output: OutputRequests::default(),
            origin: AT,
        });
        model
    }

    /// Requirement: the tangent is the derivative of the residual, with
    /// beams, rigid links under a free rotation, normal rotation, curvature,
    /// the exponential law and friction (stick and slip) together. Central
    /// differences with a step of 1e-6 leave 1e-9 by truncation and rounding;
    /// tolerance 1e-6 of the largest entry.
    #[test]
    fn assembled_tangent_by_differences() {
        for (line, drag) in [(true, 0.3), (true, 0.02), (false, 0.3), (false, -0.02)] {
            let model = model(line);
            let (slots, points) =
                (model.nodes.len() * 3, model.contact_pairs[0].slave_nodes().len());
            let start = vec![0.0; slots];
            let users = crate::users::UserFrictions::default();
            let plan = Plan::new(&model, &model.steps[0], (&start, &start), &users, None);
            let mut committed = State::undeformed(slots, points, 0);
            let mut work = crate::newton::Workspace::new(&plan);
            crate::commit::locate_points(&plan, &mut committed, &mut work);
            let body = model.nodes.find(100).unwrap();
            let mut u: Vec<f64> =
                (0..slots).map(|k| 0.02 * ((k * 7919 % 13) as f64 / 6.0 - 1.0)).collect();
            u[..3].fill(0.0);
            u[3 * body] = drag;
            u[3 * body + 1] = -0.06;
            u[3 * body + 2] = 0.1 * drag;
            plan.layout.follow_links(&mut u);
            let none = vec![0.0; points];
            let load = vec![0.0; slots];
            let trial = Trial {
                u: &u,
                load: &load,
                pressures: &none,
                tractions: &none,
                time: 1.0,
                dt: 1.0,
            };
            let mut evaluation = Evaluation::new(&plan);
            evaluate(&plan, &committed, &trial, &mut evaluation);
            assert!(evaluation.points.iter().any(|point| point.closed && point.traction != 0.0));
            let tangent = tangent(&plan, &committed, &trial, &evaluation);
            let n = tangent.equations;
            let largest = tangent.entries.iter().fold(0.0_f64, |most, k| most.max(k.abs()));
            for j in 0..n {
                let column = column_by_differences(&plan, &committed, &trial, j, 1e-6);
                for (i, difference) in column.iter().enumerate() {
                    let off = (difference - tangent.entries[i * n + j]).abs();
                    assert!(
                        off < 1e-6 * largest,
                        "{line} {drag} ({i}, {j}): {off:e} of {largest:e}"
                    );
                }
            }
        }
    }
}
