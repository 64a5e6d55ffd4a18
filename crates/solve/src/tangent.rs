//! The tangent of the residual, and its check against differences.
//!
//! ```text
//!   r(u) = f_int(u) + sum A (p a + tau b) - f_ext
//!   K    = dr/du = elements + geometry + loads
//!                + sum A [ p' a a' + b (tau_s s + tau_p p' a)' ]
//! ```
//!
//! The contact step never forms K: it keeps the laws (see
//! [`crate::linearised`]). It is formed here, of the same parts, to be held
//! against differences of the residual, law and geometry, friction and rigid
//! links together. What the contact step solves for on its own stays as it
//! is: hard pressures, exact stick, whether friction is called, and where the
//! integration_points of integrated contact stand on their elements.

use crate::constraints::Rows;
use crate::contact::{
    Before, ContactKinematics, GeometryScratch, MasterPositions, PointKinematics, PointRows,
};
use crate::evaluate::{Evaluation, Trial};
use crate::moments::{self, turn_moments};
use crate::observe::reports::TangentReport;
use crate::observe::results::{FrictionCall, Status};
use crate::problem::Problem;
use crate::state::State;
use crate::structure::{Configuration, Contributions, Gather, Keep};
use slideline_diag::{Code, Diagnostic};
use slideline_mech::contact::friction::Traction;
use slideline_mech::contact::pair::{Laws, PointTrial, UserState};
use slideline_mech::contact::tangential::Tangential;
use slideline_model::{Dof, NodeIndex};

mod kept;

pub use kept::Kept;

/// Differences of a displacement, in sizes of the model, and of a rotation.
/// Their square over that of a clearance is what truncation leaves; eps over
/// them is what rounding does.
const STEP: f64 = 1e-7;

/// A disagreement beyond this fraction of the largest entry of its kind is a
/// fault.
pub const TOLERANCE: f64 = 1e-5;

/// Where a tangent is checked: the state, and what it is judged against.
#[derive(Clone, Copy)]
pub struct Place<'a> {
    /// The step.
    pub plan: &'a Problem<'a>,
    /// The state before the increment.
    pub committed: &'a State,
    /// The converged trial.
    pub trial: Trial<'a>,
    /// Its evaluation.
    pub evaluation: &'a Evaluation,
}

/// Holds the assembled tangent against differences, column by column.
/// `numbers` are those of step and increment.
pub fn check(place: &Place<'_>, (step, increment): (usize, usize)) -> TangentReport {
    let plan = place.plan;
    let values = assembled(place, &mut Kept::default());
    let mut differences = Differences::new(place);
    let n = plan.constraints.equations();
    let mut column = vec![0.0; n];
    let mut largest = [[f64::MIN_POSITIVE; 2]; 2];
    let mut worst = [[Worst::default(); 2]; 2];
    for j in 0..n {
        column.fill(0.0);
        for &i in plan.pattern.row(j) {
            column[i] = plan.pattern.position(i, j).map_or(0.0, |at| values[at]);
        }
        differences.column(j);
        for (i, &entry) in column.iter().enumerate() {
            let (a, b) = (place.kind(i), place.kind(j));
            let difference = differences.best[i];
            let size = entry.abs().max(difference.abs());
            largest[a][b] = f64::max(largest[a][b], size);
            let off = differences.distance(i, entry);
            if off > worst[a][b].off {
                worst[a][b] = Worst { off, row: i, column: j, entry, difference };
            }
        }
    }
    let kinds = worst.into_iter().flatten().zip(largest.into_iter().flatten());
    let relative = kinds.map(|(worst, largest)| (worst.off / largest, worst));
    let none = (0.0, Worst::default());
    let (off, worst) = relative.fold(none, |a, b| if b.0 > a.0 { b } else { a });
    place.report((step, increment), off, &worst)
}

/// The entry that disagrees most.
#[derive(Clone, Copy, Debug, Default)]
struct Worst {
    off: f64,
    row: usize,
    column: usize,
    entry: f64,
    difference: f64,
}

/// What is said of a tangent that is wrong; `None` where it is right.
pub fn fault(plan: &Problem<'_>, report: &TangentReport) -> Option<Diagnostic> {
    if report.off <= TOLERANCE {
        return None;
    }
    let labels: Vec<u64> = plan.model.nodes.iter().map(|node| node.label).collect();
    let pairs: Vec<String> = (0..plan.contact.pair_count())
        .map(|pair| plan.model.contact_pairs[plan.contact.parent(pair)].name.clone())
        .collect();
    let message = format!(
        "the tangent of step {} increment {} disagrees with differences of the residual by {:.1e} \
         of its largest entry: {} is assembled as {:.6e}, differences give {:.6e}",
        report.step,
        report.increment,
        report.off,
        report.entry(&labels, &pairs),
        report.assembled,
        report.difference,
    );
    Some(Diagnostic::warning(Code("SL0906"), message).help(
        "converged increments are still right, because only the residual decides; please report \
         this together with the deck",
    ))
}

impl Place<'_> {
    /// 0: force and displacement, 1: moment and rotation.
    fn kind(&self, equation: usize) -> usize {
        usize::from(self.name(equation).1.is_rotation())
    }

    fn name(&self, equation: usize) -> (NodeIndex, Dof) {
        self.plan.dofs.name(self.plan.constraints.dof_of_equation[equation])
    }

    fn report(&self, numbers: (usize, usize), off: f64, worst: &Worst) -> TangentReport {
        let equations = self.plan.constraints.equations();
        let mut report = TangentReport {
            step: numbers.0,
            increment: numbers.1,
            equations,
            off,
            assembled: worst.entry,
            difference: worst.difference,
            ..TangentReport::default()
        };
        if equations > 0 {
            let at = (self.name(worst.row), self.name(worst.column));
            report.at = Some(at);
            report.element = self.element([at.0.0, at.1.0]);
            report.contact = self.point([worst.row, worst.column]);
        }
        report
    }

    /// Label of the first element that couples two nodes.
    fn element(&self, nodes: [NodeIndex; 2]) -> Option<u64> {
        let constraints = &self.plan.constraints;
        let joins = |own: &[NodeIndex]| {
            nodes.iter().all(|node| own.iter().any(|&own| constraints.carrier(own) == *node))
        };
        let mut elements = self.plan.model.blocks.iter().flat_map(|block| &block.elements);
        elements.find(|element| joins(element.nodes)).map(|element| element.label)
    }

    /// Pair and slave node of the first closed point that couples two
    /// equations.
    fn point(&self, equations: [usize; 2]) -> Option<(usize, NodeIndex)> {
        let places = self.evaluation.kinematics.iter().zip(&self.evaluation.points);
        let points = self.plan.contact.points.iter().zip(places);
        let couples = |kinematics: &PointRows<'_>| {
            let mut own = Vec::new();
            for &dof in kinematics.rows.unknowns {
                self.plan.constraints.equations_of(dof, &mut own);
            }
            equations.iter().all(|equation| own.contains(equation))
        };
        let found =
            points.into_iter().find(|(_, (kinematics, now))| now.closed && couples(kinematics));
        found.map(|(point, _)| (point.pair, point.node))
    }
}

/// Values of the tangent in the places of the pattern [F/L and the like]; `kept` gets what has no
/// place there.
pub fn assembled(place: &Place<'_>, kept: &mut Kept) -> Vec<f64> {
    let Place { plan, trial, .. } = place;
    let mut values = vec![0.0; plan.pattern.entries()];
    // The geometric stiffness of the iteration is that of estimated stresses.
    let mut contributions = plan.structure.room();
    let (state, ambient) = (&place.committed.elements[..], trial.ambient);
    let at = Configuration { u: trial.u, stresses: None, state, ambient };
    let rows = &place.evaluation.rows;
    kept.begin(trial.load.len());
    let Kept { elements, tangents, .. } = &mut *kept;
    let keep = Some(Keep { elements, into: tangents });
    let gather = Gather { keep, ..plan.gather(rows, &mut values) };
    plan.structure.evaluate(&at, &mut contributions, gather, plan.means.pool);
    plan.structure.gather_force(&contributions, &mut kept.force);
    trial.dashpots.stiffen(plan, rows, &mut values);
    plan.stiffen_by_faces(rows, (trial.faces, trial.u, ambient.turns), &mut values);
    moments::stiffen(plan, rows, trial.load, (trial.u, ambient.turns), &mut values);
    // Every force on a dependent dof turns with those that it follows.
    let mut force = vec![0.0; trial.load.len()];
    plan.faces.press(trial.faces, (trial.u, ambient.turns), &mut force);
    force.iter_mut().zip(trial.load).for_each(|(force, load)| *force = -(*force + load));
    force.iter_mut().zip(&kept.force).for_each(|(force, own)| *force += own);
    place.add_contact_force(&place.evaluation.kinematics, trial.u, &mut force);
    plan.stiffen_by_turning(rows, ((trial.u, ambient.turns), &mut force), &mut values);
    let mut scratch = GeometryScratch::default();
    for point in 0..plan.contact.points.len() {
        if place.add_point(point, &mut scratch, &mut values) {
            kept.keep_point(point, &scratch.tangent);
        }
    }
    place.add_faces(&mut scratch, &mut values);
    values
}

impl Place<'_> {
    /// Adds a point, if it is closed; then its geometric tangent is left in the scratch.
    fn add_point(&self, place: usize, scratch: &mut GeometryScratch, values: &mut [f64]) -> bool {
        let Place { plan, trial, evaluation, committed } = self;
        let before = &committed.points[place];
        let (kinematics, now) = (evaluation.kinematics.at(place), &evaluation.points[place]);
        if !now.closed {
            return false;
        }
        let ((pressure, traction), slope) = self.law(place, &kinematics);
        let forces = (now.area * pressure, now.area * traction.tau);
        let at = (trial.u, evaluation.positions(), before);
        plan.contact.geometric_tangent(place, at, &kinematics, forces, scratch);
        let (geometry, rows) = (&scratch.tangent, kinematics.rows);
        let a = rows.normal();
        let by_friction = |i: usize, j: usize, k: usize| {
            let by_slip = |l: usize| traction.d_tau_d_slip.at(k, l) * rows.slip(l)[j];
            let by_slip: f64 = (0..rows.directions()).map(by_slip).sum();
            rows.force(k)[i] * (by_slip + traction.d_tau_d_pressure[k] * slope * a[j])
        };
        let entry = |i: usize, j: usize| {
            let friction: f64 = (0..rows.directions()).map(|k| by_friction(i, j, k)).sum();
            geometry[rows.width() * i + j] + now.area * (slope * a[i] * a[j] + friction)
        };
        plan.scatter(&evaluation.rows, rows.unknowns, entry, values);
        true
    }

    /// Adds the geometry of faces in space that contact is spread over.
    fn add_faces(&self, scratch: &mut GeometryScratch, values: &mut [f64]) {
        let Place { plan, evaluation, .. } = self;
        let forces = |place: usize| {
            let (kinematics, now) = (evaluation.kinematics.at(place), &evaluation.points[place]);
            let ((pressure, traction), _) = self.law(place, &kinematics);
            now.closed.then(|| (now.area * pressure, now.area * traction.tau))
        };
        let kinematics = &evaluation.kinematics;
        plan.contact.tangents_of_faces(kinematics, forces, scratch, |dofs, tangent| {
            let at = |i: usize, j: usize| tangent[dofs.len() * i + j];
            plan.scatter(&evaluation.rows, dofs, at, values);
        });
    }

    /// Adds the forces of points as they stand at displacements `u`, and those
    /// of dashpots.
    fn add_contact_force(&self, kinematics: &ContactKinematics, u: &[f64], force: &mut [f64]) {
        for (place, kinematics) in kinematics.iter().enumerate().filter(|(_, m)| m.faces) {
            let ((pressure, traction), _) = self.law(place, &kinematics);
            let area = kinematics.area;
            kinematics.push(area * pressure, area * traction.tau, force);
        }
        self.trial.dashpots.press(u, &self.committed.displacement, force, |_| {});
    }

    /// Pressure and traction of a point at a kinematics, and the slope of the
    /// pressure; whether friction is called, and whether it sticks exactly, is
    /// as in the converged state.
    pub fn law(&self, place: usize, kinematics: &PointKinematics) -> ((f64, Traction), f64) {
        let before = &self.committed.points[place].history();
        let u = &self.committed.displacement;
        self.law_with(place, kinematics, self.plan.contact.slip(place, before, kinematics, u))
    }

    /// The same where the slip of the increment is known.
    pub fn law_with(
        &self,
        place: usize,
        kinematics: &PointKinematics,
        slip: Tangential,
    ) -> ((f64, Traction), f64) {
        let Place { plan, committed, trial, evaluation } = self;
        let point = &plan.contact.points[place];
        let laws: &Laws = plan.contact.laws_of(point.pair, &committed.points[place]);
        let (before, now) = (&committed.points[place].history(), &evaluation.points[place]);
        let slope = match kinematics.faces {
            true => laws.normal.pressure(kinematics.overclosure).map_or(0.0, |(_, slope)| slope),
            false => 0.0,
        };
        let pressure = laws.pressure(kinematics.overclosure, now.pressure);
        if now.friction != FrictionCall::Called || pressure == 0.0 {
            return ((pressure, Traction::ZERO), slope);
        }
        if laws.user.is_none() && laws.friction.needs_multiplier() {
            let stick = Traction { tau: now.traction, ..Traction::ZERO };
            if now.status != Status::Slip {
                return ((pressure, stick), slope);
            }
            // twice the traction is beyond the limit on either side
            let sliding = laws.friction.project(pressure, 2.0 * now.traction, slip, trial.dt);
            let traction = Traction {
                tau: sliding.tau,
                d_tau_d_pressure: sliding.by_pressure,
                d_tau_d_slip: sliding.by_slip,
                ..Traction::ZERO
            };
            return ((pressure, traction), slope);
        }
        let state_variables = point.state_variables..point.state_variables + point.state_size;
        let estimate = PointTrial {
            overclosure: kinematics.overclosure,
            slip,
            pressure: now.pressure,
            traction: now.traction,
            stiffness: 0.0,
            dt: trial.dt,
        };
        let response = laws.respond(
            before,
            &estimate,
            &mut UserState {
                time: trial.time,
                committed: &committed.state_variables[state_variables],
                state: &mut vec![0.0; point.state_size],
                fault: &mut None,
            },
        );
        ((response.pressure, response.traction), slope)
    }
}

/// Differences of the residual with two steps, for one column at a time.
pub struct Differences<'a> {
    place: &'a Place<'a>,
    contributions: Contributions,
    force: Vec<f64>,
    rows: Rows,
    kinematics: ContactKinematics,
    positions: MasterPositions,
    u: Vec<f64>,
    middle: Vec<f64>,
    /// The column by central differences, extrapolated [F/L and the like].
    pub best: Vec<f64>,
    /// Between which slopes it lies where the residual has a kink.
    between: Vec<(f64, f64)>,
}

impl<'a> Differences<'a> {
    /// Room, and the residual of the state itself.
    pub fn new(place: &'a Place<'a>) -> Self {
        let (dofs, n) = (place.plan.dofs.len(), place.plan.constraints.equations());
        let mut new = Self {
            place,
            contributions: place.plan.structure.room(),
            force: vec![0.0; dofs],
            rows: Rows::default(),
            kinematics: place.evaluation.kinematics.clone(),
            positions: MasterPositions::default(),
            u: place.trial.u.to_vec(),
            middle: Vec::new(),
            best: vec![0.0; n],
            between: vec![(0.0, 0.0); n],
        };
        new.middle = new.residual();
        new
    }

    /// Finds the column of an equation.
    pub fn column(&mut self, equation: usize) {
        let plan = self.place.plan;
        let h = if self.place.kind(equation) == 1 { STEP } else { STEP * plan.reach };
        let [up, down] = [h, -h].map(|step| self.moved(equation, step));
        let [near_up, near_down] = [0.5 * h, -0.5 * h].map(|step| self.moved(equation, step));
        for (i, &middle) in self.middle.iter().enumerate() {
            let wide = (up[i] - down[i]) / (2.0 * h);
            let near = (near_up[i] - near_down[i]) / h;
            let best = (4.0 * near - wide) / 3.0;
            let sides = ((near_up[i] - middle) / (0.5 * h), (middle - near_down[i]) / (0.5 * h));
            // Of a smooth residual both sides draw together with the step.
            let gap = (up[i] - 2.0 * middle + down[i]).abs() / h;
            let kink = (sides.0 - sides.1).abs() > 0.75 * gap && gap > TOLERANCE * best.abs();
            self.best[i] = best;
            self.between[i] = if kink { sides } else { (best, best) };
        }
    }

    /// How far an entry is from what differences allow [F/L and the like].
    fn distance(&self, i: usize, entry: f64) -> f64 {
        let (a, b) = self.between[i];
        (a.min(b) - entry).max(entry - a.max(b)).max(0.0)
    }

    fn moved(&mut self, equation: usize, step: f64) -> Vec<f64> {
        let Place { plan, trial, .. } = self.place;
        self.u.copy_from_slice(trial.u);
        self.u[plan.constraints.dof_of_equation[equation]] += step;
        plan.constraints.enforce(trial.ambient.turns, &mut self.u);
        self.residual()
    }

    fn residual(&mut self) -> Vec<f64> {
        let Place { plan, trial, evaluation, committed } = self.place;
        let (state, ambient) = (&committed.elements[..], trial.ambient);
        let at = Configuration { u: &self.u, stresses: None, state, ambient };
        plan.structure.evaluate_forces(&at, &mut self.contributions, plan.means.pool);
        self.force.fill(0.0);
        plan.faces.press(trial.faces, (&self.u, trial.ambient.turns), &mut self.force);
        let loads = self.force.iter_mut().zip(trial.load);
        loads.for_each(|(force, load)| *force = -(*force + load));
        let at = (&self.u[..], trial.ambient.turns);
        turn_moments(plan, trial.load, at, |dof, beyond| self.force[dof] -= beyond);
        let _energy = plan.structure.gather_force(&self.contributions, &mut self.force);
        self.kinematics.copy_from(&evaluation.kinematics);
        let at = (&self.u[..], Before::of(committed).held_by(trial.standing));
        plan.contact.locate_in_place(at, &mut self.positions, &mut self.kinematics);
        self.place.add_contact_force(&self.kinematics, &self.u, &mut self.force);
        plan.constraints.linearise((&self.u, trial.ambient.turns), &mut self.rows);
        plan.constraints.carry(&self.rows, &mut self.force);
        plan.constraints.dof_of_equation.iter().map(|&dof| self.force[dof]).collect()
    }
}

#[cfg(test)]
pub(crate) mod tests;
