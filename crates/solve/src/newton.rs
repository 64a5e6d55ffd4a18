//! One attempt at an increment: Newton's method with contact solved exactly
//! in every linearisation.
//!
//! ```text
//!   predict -> evaluate -> [ assemble -> factor -> linearised contact
//!                            -> move -> evaluate -> judge ] ... -> verdict
//! ```
//!
//! Newton knows nothing of time: it is told the state to start from and the
//! values to reach.

mod assembly;
mod measures;
mod questions;
mod relax;
mod search;
mod stresses;
mod turns;

use crate::contact::{GeometryScratch, Missed, Sweep, SweepScratch};
use crate::convergence::{Field, FieldHistory, Measures, judge};
use crate::evaluate::{Evaluation, Trial, complete, evaluate, look_at};
use crate::increments::Verdict;
use crate::iteration_history::IterationHistory;
use crate::linearised::{LinearPoints, LinearisedContact, Stiffness};
use crate::observe::{ContactChange, IterationReport};
use crate::plan::Plan;
use crate::predict;
use crate::stabilise::{self, Dashpots};
use crate::state::State;
use crate::structure::Configuration;
pub use assembly::TOUCH;
use assembly::context;
use relax::Relaxation;
pub use relax::relax;
use slideline_linalg::{SolveError, Solver};
use slideline_mech::contact::enforcement::Enforcement;
use slideline_mech::contact::tangential::Tangential;

/// The most points whose contact is solved with its matrix where the other way is
/// lost: the cost grows with their cube.
const MOST_DENSE: usize = 1000;

/// Equations of a contact point that room is kept for.
const ROWS: usize = 18;

/// What an attempt aims at.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// Step number from 1.
    pub step: usize,
    /// Increment number from 1.
    pub increment: usize,
    /// Attempt number from 1.
    pub attempt: usize,
    /// Time in the step at the end of the increment [T].
    pub step_time: f64,
    /// The increment [T].
    pub dt: f64,
}

/// How an attempt ended.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// For the increment control.
    pub verdict: Verdict,
    /// Severe discontinuity iterations.
    pub severe: usize,
    /// Equilibrium iterations.
    pub equilibrium: usize,
    /// What the linear solver said, where it failed.
    pub fault: Option<SolveError>,
    /// The last iteration, where there was one.
    pub last: Option<IterationReport>,
    /// Contact that was passed through on the way to an equilibrium.
    pub missed: Option<Missed>,
}

/// Scratch of a step's iterations.
pub struct Workspace {
    /// Trial displacements.
    pub u: Vec<f64>,
    /// Trial loads.
    pub load: Vec<f64>,
    /// The evaluation of the trial state.
    pub evaluation: Evaluation,
    /// The factored tangent.
    pub solver: Solver,
    /// The tangent without augmentation, and with it.
    values: Vec<f64>,
    augmented: Vec<f64>,
    /// Whether contact couples what the pattern does not hold.
    pub outside: bool,
    /// How the condensed contact problem of the iteration is solved.
    enforcement: Enforcement,
    /// Whether the rest of the attempt goes the dense way.
    only_dense: bool,
    /// The increment [T].
    dt: f64,
    correction: Vec<f64>,
    correction_dofs: Vec<f64>,
    residual: Vec<f64>,
    /// Forces on dependent dofs with which the tangent turns, a dof each.
    turning: Vec<f64>,
    increment: Vec<f64>,
    /// Stresses of the elements as the linear solutions arrive at them.
    stresses: Vec<f64>,
    /// No motion, a dof each.
    still: Vec<f64>,
    arrived: Vec<f64>,
    pressures: Vec<f64>,
    tractions: Vec<Tangential>,
    points: LinearPoints,
    contact: LinearisedContact,
    geometry: GeometryScratch,
    sweep: SweepScratch,
    dashpots: Dashpots,
    was_closed: Vec<bool>,
    /// Most negative pivots of a symmetric factorisation in this attempt:
    /// directions in which the structure gives way.
    pub negative_pivots: usize,
    /// What the iterations of this attempt showed of every contact point.
    pub iteration_history: IterationHistory,
    /// Whether corrections are shortened until they lessen the residual.
    pub line_search: bool,
    /// Fraction of the last correction that was taken [1].
    step_length: f64,
    /// Whether every facing point augments its stiffness in this attempt.
    augment_all: bool,
    /// What holds the state back on its way downhill.
    relaxation: Relaxation,
    /// The list of changes of the last report, to be used again.
    changes: Vec<ContactChange>,
}

impl Workspace {
    /// Room for a plan; the symbolic factorisation happens here.
    pub fn new(plan: &Plan<'_>) -> Self {
        let (dofs, equations) = (plan.dofs.len(), plan.constraints.equations());
        let points = plan.contact.points.len();
        let mut contact = LinearisedContact::default();
        contact.reserve(points, equations);
        let mut linear = LinearPoints::default();
        linear.reserve(points, ROWS);
        Self {
            u: vec![0.0; dofs],
            load: vec![0.0; dofs],
            evaluation: Evaluation::new(plan),
            solver: plan.analyse(),
            values: vec![0.0; plan.pattern.entries()],
            augmented: vec![0.0; plan.pattern.entries()],
            outside: false,
            enforcement: Enforcement::default(),
            only_dense: false,
            dt: 0.0,
            correction: vec![0.0; equations],
            correction_dofs: vec![0.0; dofs],
            residual: vec![0.0; dofs],
            turning: vec![0.0; dofs],
            increment: vec![0.0; dofs],
            stresses: plan.structure.stress_room(),
            still: vec![0.0; dofs],
            arrived: plan.structure.stress_room(),
            pressures: vec![0.0; points],
            tractions: vec![Tangential::ZERO; points],
            points: linear,
            contact,
            geometry: GeometryScratch::default(),
            sweep: SweepScratch::default(),
            dashpots: Dashpots::default(),
            was_closed: vec![false; points],
            negative_pivots: 0,
            iteration_history: IterationHistory::new(points),
            line_search: false,
            step_length: 1.0,
            augment_all: false,
            relaxation: Relaxation::default(),
            changes: Vec::with_capacity(points),
        }
    }
}

/// Walks one increment. `watch` sees every iteration; on success the
/// workspace holds the converged trial.
pub fn attempt(
    plan: &Plan<'_>,
    committed: &State,
    target: &Target,
    work: &mut Workspace,
    watch: &mut dyn FnMut(&IterationReport),
) -> Outcome {
    work.begin(plan, committed, target);
    let limits = match work.line_search {
        false => plan.step.controls.effective_time(),
        true => search::limits(&plan.step.controls.effective_time()),
    };
    let mut progress = Progress::default();
    loop {
        if let Err(fault) = work.iterate(plan, committed, target.dt) {
            work.complete(plan, committed);
            return progress.end(Verdict::Broken, Some(fault));
        }
        if work.outside || work.evaluation.fault.is_some() {
            work.complete(plan, committed);
            return progress.end(Verdict::Broken, None);
        }
        let mut report = work.judge(plan, committed, target, &mut progress);
        if report.converged && !work.complete(plan, committed) {
            // one that was left alone touches after all: its pressure comes next
            work.evaluate(plan, committed, target.dt);
            report.converged = false;
        }
        watch(&report);
        let verdict = progress.verdict(&report, &limits);
        progress.last = Some(report);
        if let Some(verdict) = verdict {
            work.complete(plan, committed);
            let missed = match verdict {
                Verdict::Converged { .. } => work.missed(plan, committed),
                _ => None,
            };
            return match missed {
                Some(missed) => progress.end_with(missed),
                None => progress.end(verdict, None),
            };
        }
    }
}

/// Counts and histories of an attempt.
#[derive(Debug, Default)]
struct Progress {
    severe: u32,
    equilibrium: u32,
    since_change: u32,
    force: FieldHistory,
    moment: FieldHistory,
    last: Option<IterationReport>,
}

impl Progress {
    fn end(self, verdict: Verdict, fault: Option<SolveError>) -> Outcome {
        let (severe, equilibrium) = (self.severe as usize, self.equilibrium as usize);
        Outcome { verdict, severe, equilibrium, fault, last: self.last, missed: None }
    }

    /// Equilibrium was found beyond contact that was passed through.
    fn end_with(self, missed: Missed) -> Outcome {
        let percent = (100.0 * missed.fraction).clamp(1.0, 100.0) as u8;
        Outcome { missed: Some(missed), ..self.end(Verdict::PassedThrough { percent }, None) }
    }

    /// Whether the attempt is over. Semantics of increments: divergence is
    /// looked for from I_0 on, the rate from I_R on.
    fn verdict(
        &self,
        report: &IterationReport,
        limits: &slideline_model::TimeIncrementation,
    ) -> Option<Verdict> {
        if !report.force.residual.is_finite() || !report.moment.residual.is_finite() {
            return Some(Verdict::Broken);
        }
        if report.converged {
            return Some(Verdict::Converged { iterations: self.equilibrium });
        }
        if report.severe {
            return (self.severe > limits.i_s).then_some(Verdict::Discontinuous);
        }
        let i = self.since_change;
        let fields = [(&self.force, &report.force), (&self.moment, &report.moment)];
        let open = || fields.iter().filter(|(_, report)| !report.converged);
        if i >= limits.i_0 && open().any(|(history, _)| history.growing >= 2) {
            return Some(Verdict::Diverging);
        }
        if i >= limits.i_c {
            return Some(Verdict::TooSlow);
        }
        let promised = |(history, report): &(&FieldHistory, &crate::observe::FieldReport)| {
            let rate = history.rate().unwrap_or(0.0);
            if report.residual <= report.allowed || rate <= 0.0 {
                return 0.0;
            }
            if rate >= 1.0 {
                return f64::INFINITY;
            }
            f64::from(i) + (report.allowed / report.residual).ln() / rate.ln()
        };
        let slow = i >= limits.i_r && open().any(|f| promised(f) > f64::from(limits.i_c));
        slow.then_some(Verdict::TooSlow)
    }
}

impl Workspace {
    /// The first guess, evaluated.
    fn begin(&mut self, plan: &Plan<'_>, committed: &State, target: &Target) {
        self.augment_all = false;
        self.only_dense = false;
        // the last attempt's list went with its outcome
        self.changes.reserve(plan.contact.points.len());
        self.dt = target.dt;
        self.negative_pivots = 0;
        let times = (target.step_time, target.dt);
        stabilise::fill(plan, committed, times, &mut self.dashpots);
        self.u.copy_from_slice(&committed.displacement);
        predict::extrapolate(plan, committed, target.dt, &mut self.u);
        plan.prescribe(target.step_time, &mut self.u);
        plan.load(target.step_time, &mut self.load);
        plan.constraints.enforce(&mut self.u);
        for (place, point) in committed.points.iter().enumerate() {
            self.pressures[place] = point.pressure;
            self.tractions[place] = point.traction;
            self.was_closed[place] = point.closed;
        }
        if committed.increment_time.0 == 0.0 {
            self.spread_prescribed(plan, committed, target);
        }
        self.first_stresses(plan, committed, target.dt);
        look_at(plan, committed, &mut self.evaluation);
        self.evaluate(plan, committed, target.dt);
        self.iteration_history.begin(&self.evaluation.points);
    }

    /// Without a last increment to repeat, what is prescribed on the
    /// structure is spread over it linearly, lest one element takes it all.
    fn spread_prescribed(&mut self, plan: &Plan<'_>, committed: &State, target: &Target) {
        let change = &mut self.correction_dofs;
        for (dof, value) in change.iter_mut().enumerate() {
            *value = self.u[dof] - committed.displacement[dof];
        }
        let from = &committed.displacement;
        let at = Configuration { u: from, stresses: None, state: &committed.elements };
        plan.structure.evaluate(&at, &mut self.evaluation.contributions, plan.pool);
        plan.constraints.linearise(from, &mut self.evaluation.rows);
        self.residual.fill(0.0);
        plan.structure.multiply(&self.evaluation.contributions, change, &mut self.residual);
        plan.constraints.carry(&self.evaluation.rows, &mut self.residual);
        for (equation, &dof) in plan.constraints.dof_of_equation.iter().enumerate() {
            self.correction[equation] = -self.residual[dof];
        }
        if self.correction.iter().all(|&value| value == 0.0) {
            return;
        }
        self.values.fill(0.0);
        let Evaluation { contributions, rows, .. } = &self.evaluation;
        plan.gather_tangent(contributions, rows, &mut self.values);
        let factored = self.solver.refactor(&plan.pattern, &self.values);
        if factored.is_ok() && self.solver.solve(&mut self.correction).is_ok() {
            for (equation, &dof) in plan.constraints.dof_of_equation.iter().enumerate() {
                self.u[dof] += self.correction[equation];
            }
            plan.constraints.enforce(&mut self.u);
            plan.prescribe(target.step_time, &mut self.u);
        }
    }

    /// The trial state that was evaluated last.
    pub fn trial(&self, committed: &State, dt: f64) -> Trial<'_> {
        Trial {
            u: &self.u,
            load: &self.load,
            stresses: &self.stresses,
            pressures: &self.pressures,
            tractions: &self.tractions,
            dashpots: &self.dashpots,
            time: committed.total_time + dt,
            dt,
        }
    }

    fn evaluate(&mut self, plan: &Plan<'_>, committed: &State, dt: f64) {
        if self.line_search {
            self.follow_law(plan);
        }
        let trial = Trial {
            u: &self.u,
            load: &self.load,
            stresses: &self.stresses,
            pressures: &self.pressures,
            tractions: &self.tractions,
            dashpots: &self.dashpots,
            time: committed.total_time + dt,
            dt,
        };
        evaluate(plan, committed, &trial, &mut self.evaluation);
    }

    /// The correction that the factored tangent and contact, solved exactly,
    /// answer the residual with.
    fn contact_step(
        &mut self,
        plan: &Plan<'_>,
        committed: &State,
        dt: f64,
    ) -> Result<(), SolveError> {
        for (equation, &dof) in plan.constraints.dof_of_equation.iter().enumerate() {
            self.correction[equation] = -self.evaluation.structure[dof];
        }
        if !self.dashpots.is_empty() {
            for (equation, &dof) in plan.constraints.dof_of_equation.iter().enumerate() {
                self.correction[equation] -= self.evaluation.damping[dof];
            }
        }
        self.hold_back(plan);
        let context = context(plan, committed, dt);
        let Self { contact, enforcement, values, augmented, solver, points, correction, .. } = self;
        let (pattern, symmetrised) = (&plan.pattern, plan.symmetrised());
        let mut stiffness = Stiffness { pattern, values, augmented, solver, symmetrised };
        contact.solve(points, &context, (*enforcement, &mut stiffness), correction)
    }

    /// Factors and solves the linearised problem. Where the way without the matrix
    /// of contact is lost, the rest of the attempt goes the other one, which can
    /// pivot, as long as its cost allows.
    fn linear_step(
        &mut self,
        plan: &Plan<'_>,
        committed: &State,
        dt: f64,
    ) -> Result<(), SolveError> {
        let mut done = self.factor(plan, committed);
        if done.is_ok() && !self.outside {
            done = self.contact_step(plan, committed, dt);
        }
        let free = self.enforcement == Enforcement::MatrixFree && plan.enforcement.is_none();
        let lost = done.is_err() || !self.contact.is_solved();
        if self.outside || !free || !lost || self.points.len() > MOST_DENSE {
            return done;
        }
        self.only_dense = true;
        self.factor(plan, committed)?;
        self.contact_step(plan, committed, dt)
    }

    /// One Newton iteration: assemble, factor, solve, move, evaluate.
    fn iterate(&mut self, plan: &Plan<'_>, committed: &State, dt: f64) -> Result<(), SolveError> {
        self.linear_step(plan, committed, dt)?;
        if !self.outside && !self.leaves_idle(plan) {
            // what was left alone may touch within this step
            self.evaluation.look.forget();
            self.evaluate(plan, committed, dt);
            self.linear_step(plan, committed, dt)?;
        }
        if self.outside {
            return Ok(());
        }
        let length = self.limit_turns(plan);
        if self.line_search {
            self.search(plan, committed, (dt, length));
        } else {
            self.advance(plan, length);
            self.evaluate(plan, committed, dt);
        }
        Ok(())
    }

    /// Whether the whole correction leaves idle points open.
    fn leaves_idle(&mut self, plan: &Plan<'_>) -> bool {
        if !self.evaluation.look.idle.contains(&true) {
            return true;
        }
        self.residual.copy_from_slice(&self.u);
        for (equation, &dof) in plan.constraints.dof_of_equation.iter().enumerate() {
            self.residual[dof] += self.correction[equation];
        }
        plan.constraints.enforce(&mut self.residual);
        let Evaluation { kinematics, look, .. } = &self.evaluation;
        plan.contact.stay_idle(kinematics, &self.residual, look)
    }

    /// Looks at the points that iterations have left alone; says whether none of
    /// them touches.
    fn complete(&mut self, plan: &Plan<'_>, committed: &State) -> bool {
        let trial = Trial {
            u: &self.u,
            load: &self.load,
            stresses: &self.stresses,
            pressures: &self.pressures,
            tractions: &self.tractions,
            dashpots: &self.dashpots,
            time: committed.total_time + self.dt,
            dt: self.dt,
        };
        complete(plan, committed, &trial, &mut self.evaluation)
    }

    /// Contact that the way from the last commit to the trial passes through.
    fn missed(&mut self, plan: &Plan<'_>, committed: &State) -> Option<Missed> {
        let sweep = Sweep {
            constraints: &plan.constraints,
            rotations: plan.dofs.rotations(),
            from: &committed.displacement,
            to: &self.u,
            before: &committed.points,
            now: &self.evaluation.points,
        };
        let through = plan.contact.passed_through(&sweep, &mut self.sweep);
        through.or_else(|| plan.contact.passed_between(&sweep))
    }

    /// Moves by a fraction of the correction.
    fn advance(&mut self, plan: &Plan<'_>, length: f64) {
        self.step_length = length;
        self.correction_dofs.fill(0.0);
        for (equation, &dof) in plan.constraints.dof_of_equation.iter().enumerate() {
            self.correction_dofs[dof] = self.correction[equation];
        }
        plan.constraints.expand(&self.evaluation.rows, &mut self.correction_dofs);
        self.move_stresses(plan, length);
        for (dof, change) in self.correction_dofs.iter_mut().enumerate() {
            *change *= length;
            self.u[dof] += *change;
        }
        for linear in self.points.iter() {
            let place = linear.place;
            let pressure = &mut self.pressures[place];
            *pressure += length * (linear.pressure - *pressure);
            let old = &mut self.tractions[place];
            *old += length * (linear.traction() - *old);
        }
        plan.constraints.enforce(&mut self.u);
    }

    /// Measures the trial state and judges it.
    fn judge(
        &mut self,
        plan: &Plan<'_>,
        committed: &State,
        target: &Target,
        progress: &mut Progress,
    ) -> IterationReport {
        let mut report = IterationReport {
            step: target.step,
            increment: target.increment,
            attempt: target.attempt,
            iteration: 0,
            severe: false,
            equilibrium: 0,
            contact_changes: self.empty_changes(progress),
            closed: self.evaluation.points.iter().filter(|point| point.closed).count(),
            force: self.measure(plan, committed, Field::Force),
            moment: self.measure(plan, committed, Field::Moment),
            contact_defect: self.evaluation.penetration.max(self.evaluation.stick_slip),
            step_length: self.step_length,
            enforcement: self.enforcement,
            solutions: self.contact.solutions(),
            converged: false,
        };
        let flux = [self.evaluation.flux.mean_force(), self.evaluation.flux.mean_moment()];
        let controls = &plan.step.controls.field;
        let averages = [0, 1].map(|field| committed.flux[field].with(flux[field], controls));
        self.note_changes(plan, controls.r_n * averages[0], &mut report);
        self.iteration_history.note(&self.evaluation.points);
        if report.severe {
            progress.severe += 1;
            progress.since_change = 0;
            progress.force = FieldHistory::default();
            progress.moment = FieldHistory::default();
        } else {
            progress.equilibrium += 1;
            progress.since_change += 1;
            progress.force.push(report.force.residual);
            progress.moment.push(report.moment.residual);
        }
        report.iteration = (progress.severe + progress.equilibrium) as usize;
        report.equilibrium = progress.equilibrium as usize;
        let floors = self.floors(plan, committed);
        let late = plan.step.controls.effective_time().i_p;
        for field in [0, 1] {
            let measures = Measures {
                flux: flux[field],
                average: averages[field],
                floor: floors[field],
                iteration: progress.since_change,
                late,
            };
            let (own, history) = match field {
                0 => (&mut report.force, &progress.force),
                _ => (&mut report.moment, &progress.moment),
            };
            judge(own, history, &measures, controls);
        }
        report.converged = !report.severe
            && report.force.converged
            && report.moment.converged
            && self.contact_settled(plan, report.force.allowed);
        report
    }
}
