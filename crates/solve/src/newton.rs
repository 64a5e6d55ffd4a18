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
mod scratch;
mod search;
mod stresses;
mod turns;

use crate::contact::{Missed, Sweep};
use crate::convergence::{Field, FieldHistory, Measures, judge};
use crate::evaluate::{Evaluation, Trial, complete, evaluate, look_at};
use crate::increments::Verdict;
use crate::linearised::Stiffness;
use crate::observe::IterationReport;
use crate::predict;
use crate::problem::Problem;
use crate::stabilise;
use crate::state::State;
use crate::structure::{Ambient, Configuration, Gather, Product};
pub use assembly::TOUCH;
use assembly::context;
pub use relax::relax;
pub use scratch::Scratch;
use scratch::solver;
use slideline_linalg::SolveError;
use slideline_mech::contact::enforcement::Enforcement;
use slideline_mech::material::Clock;

/// The most points whose contact is solved with its matrix where the other way is
/// lost: the cost grows with their cube.
const MOST_DENSE: usize = 1000;

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

/// Walks one increment. `watch` sees every iteration; on success the
/// workspace holds the converged trial.
pub fn attempt(
    plan: &Problem<'_>,
    committed: &State,
    target: &Target,
    work: &mut Scratch,
    watch: &mut dyn FnMut(&IterationReport),
) -> Outcome {
    work.begin(plan, committed, target);
    let limits = match work.line_search {
        false => plan.step.controls.effective_time(),
        true => search::limits(&plan.step.controls.effective_time()),
    };
    let mut progress = Progress::default();
    if work.evaluation.failed.is_some() {
        work.complete(plan, committed);
        return progress.end(Verdict::Collapsed, None);
    }
    loop {
        if let Err(fault) = work.iterate(plan, committed, target.dt) {
            work.complete(plan, committed);
            return progress.end(Verdict::Broken, Some(fault));
        }
        if work.outside || work.evaluation.fault.is_some() {
            work.complete(plan, committed);
            return progress.end(Verdict::Broken, None);
        }
        if work.evaluation.failed.is_some() {
            work.complete(plan, committed);
            return progress.end(Verdict::Collapsed, None);
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

impl Scratch {
    /// The first guess, evaluated.
    fn begin(&mut self, plan: &Problem<'_>, committed: &State, target: &Target) {
        self.augment_all = false;
        self.only_dense = false;
        if self.changes.capacity() == 0 {
            // the last attempt's list went with its outcome
            self.changes = self.spare_changes.pop().unwrap_or_default();
        }
        self.changes.reserve(plan.contact.points.len());
        self.dt = target.dt;
        self.negative_pivots = 0;
        let times = (target.step_time, target.dt);
        stabilise::fill(plan, committed, times, &mut self.dashpots);
        self.u.copy_from_slice(&committed.displacement);
        predict::extrapolate(plan, committed, target.dt, &mut self.u);
        plan.prescribe(target.step_time, &mut self.u);
        plan.load(target.step_time, &mut self.load);
        self.faces.clear();
        self.faces.extend(plan.pressures(target.step_time));
        plan.temperatures(target.step_time, &mut self.temperatures);
        self.turns.clone_from(&committed.turns);
        self.clock = Clock {
            passed: plan.step.procedure.passage.of(target.dt),
            total: committed.total_time + target.dt,
        };
        plan.constraints.enforce(&self.turns, &mut self.u);
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
        if self.evaluation.failed.is_some() && committed.increment_time.0 > 0.0 {
            self.begin_at_rest(plan, committed, target);
        }
        self.iteration_history.begin(&self.evaluation.points);
    }

    /// Where the last increment cannot be repeated, for an element would fail: a first guess
    /// as if there had been none.
    fn begin_at_rest(&mut self, plan: &Problem<'_>, committed: &State, target: &Target) {
        self.u.copy_from_slice(&committed.displacement);
        plan.prescribe(target.step_time, &mut self.u);
        plan.constraints.enforce(&self.turns, &mut self.u);
        self.spread_prescribed(plan, committed, target);
        self.first_stresses(plan, committed, target.dt);
        self.evaluate(plan, committed, target.dt);
    }

    /// Without a last increment to repeat, what is prescribed on the
    /// structure is spread over it linearly, lest one element takes it all.
    fn spread_prescribed(&mut self, plan: &Problem<'_>, committed: &State, target: &Target) {
        let change = &mut self.correction_dofs;
        for (dof, value) in change.iter_mut().enumerate() {
            *value = self.u[dof] - committed.displacement[dof];
        }
        let from = &committed.displacement;
        let ambient =
            Ambient { temperatures: &self.temperatures, turns: &self.turns, clock: self.clock };
        let state = &committed.elements;
        let at = Configuration { u: from, stresses: None, state, ambient };
        plan.constraints.linearise((from, &self.turns), &mut self.evaluation.rows);
        self.residual.fill(0.0);
        let product = Product { vector: change, into: &mut self.residual };
        let gather = plan.gather(&self.evaluation.rows, &mut self.values);
        let gather = Gather { product: Some(product), ..gather };
        let contributions = &mut self.evaluation.contributions;
        plan.structure.evaluate(&at, contributions, gather, plan.means.pool);
        plan.constraints.carry(&self.evaluation.rows, &mut self.residual);
        for (equation, &dof) in plan.constraints.dof_of_equation.iter().enumerate() {
            self.correction[equation] = -self.residual[dof];
        }
        if self.correction.iter().all(|&value| value == 0.0) {
            return;
        }
        let solver = solver(&mut self.systems);
        let factored = solver.refactor(plan.pattern, &self.values);
        if factored.is_ok() && solver.solve(&mut self.correction).is_ok() {
            for (equation, &dof) in plan.constraints.dof_of_equation.iter().enumerate() {
                self.u[dof] += self.correction[equation];
            }
            plan.constraints.enforce(&self.turns, &mut self.u);
            plan.prescribe(target.step_time, &mut self.u);
        }
    }

    /// The trial state that was evaluated last.
    pub fn trial(&self, committed: &State, dt: f64) -> Trial<'_> {
        Trial {
            u: &self.u,
            load: &self.load,
            faces: &self.faces,
            stresses: &self.stresses,
            pressures: &self.pressures,
            tractions: &self.tractions,
            dashpots: &self.dashpots,
            ambient: Ambient {
                temperatures: &self.temperatures,
                turns: &self.turns,
                clock: self.clock,
            },
            time: committed.total_time + dt,
            dt,
        }
    }

    fn evaluate(&mut self, plan: &Problem<'_>, committed: &State, dt: f64) {
        if self.line_search {
            self.follow_law(plan);
        }
        self.evaluate_by(plan, committed, dt, evaluate);
    }

    /// Evaluates the trial state as it is, or a part of it.
    fn evaluate_by(
        &mut self,
        plan: &Problem<'_>,
        committed: &State,
        dt: f64,
        evaluate: fn(&Problem<'_>, &State, &Trial<'_>, &mut Evaluation),
    ) {
        let trial = Trial {
            u: &self.u,
            load: &self.load,
            faces: &self.faces,
            stresses: &self.stresses,
            pressures: &self.pressures,
            tractions: &self.tractions,
            dashpots: &self.dashpots,
            ambient: Ambient {
                temperatures: &self.temperatures,
                turns: &self.turns,
                clock: self.clock,
            },
            time: committed.total_time + dt,
            dt,
        };
        evaluate(plan, committed, &trial, &mut self.evaluation);
    }

    /// The correction that the factored tangent and contact, solved exactly,
    /// answer the residual with.
    fn contact_step(
        &mut self,
        plan: &Problem<'_>,
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
        let Self { contact, enforcement, values, augmented, systems, points, correction, .. } =
            self;
        let (pattern, symmetrised, solver) = (plan.pattern, plan.symmetrised(), solver(systems));
        let mut stiffness = Stiffness { pattern, values, augmented, solver, symmetrised };
        contact.solve(points, &context, (*enforcement, &mut stiffness), correction)
    }

    /// Factors and solves the linearised problem. Where the way without the matrix
    /// of contact is lost, the rest of the attempt goes the other one, which can
    /// pivot, as long as its cost allows.
    fn linear_step(
        &mut self,
        plan: &Problem<'_>,
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
    fn iterate(
        &mut self,
        plan: &Problem<'_>,
        committed: &State,
        dt: f64,
    ) -> Result<(), SolveError> {
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
    fn leaves_idle(&mut self, plan: &Problem<'_>) -> bool {
        if !self.evaluation.look.idle.contains(&true) {
            return true;
        }
        self.residual.copy_from_slice(&self.u);
        for (equation, &dof) in plan.constraints.dof_of_equation.iter().enumerate() {
            self.residual[dof] += self.correction[equation];
        }
        plan.constraints.enforce(&self.turns, &mut self.residual);
        let Evaluation { kinematics, look, .. } = &self.evaluation;
        plan.contact.stay_idle(kinematics, &self.residual, look)
    }

    /// Looks at the points that iterations have left alone; says whether none of
    /// them touches.
    fn complete(&mut self, plan: &Problem<'_>, committed: &State) -> bool {
        let trial = Trial {
            u: &self.u,
            load: &self.load,
            faces: &self.faces,
            stresses: &self.stresses,
            pressures: &self.pressures,
            tractions: &self.tractions,
            dashpots: &self.dashpots,
            ambient: Ambient {
                temperatures: &self.temperatures,
                turns: &self.turns,
                clock: self.clock,
            },
            time: committed.total_time + self.dt,
            dt: self.dt,
        };
        complete(plan, committed, &trial, &mut self.evaluation)
    }

    /// Contact that the way from the last commit to the trial passes through.
    fn missed(&mut self, plan: &Problem<'_>, committed: &State) -> Option<Missed> {
        let sweep = Sweep {
            constraints: plan.constraints,
            rotations: plan.dofs.rotations(),
            turns: &self.turns,
            from: &committed.displacement,
            to: &self.u,
            before: &committed.points,
            now: &self.evaluation.points,
        };
        let through = plan.contact.passed_through(&sweep, &mut self.sweep);
        through.or_else(|| plan.contact.passed_between(&sweep))
    }

    /// Moves by a fraction of the correction.
    fn advance(&mut self, plan: &Problem<'_>, length: f64) {
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
        plan.constraints.enforce(&self.turns, &mut self.u);
    }

    /// Measures the trial state and judges it.
    fn judge(
        &mut self,
        plan: &Problem<'_>,
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
