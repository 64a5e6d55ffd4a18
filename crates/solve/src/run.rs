//! The whole analysis: steps, increments, commits.

mod jump;
mod recovery;
mod shown;

use crate::balance::pair_rows;
use crate::checkpoint::Checkpoint;
use crate::commit::commit;
use crate::convergence::FluxAverage;
use crate::diagnose;
use crate::increments::{Control, Decision, Verdict};
use crate::linear_systems::LinearSystems;
use crate::newton::{Outcome, Scratch, Target, attempt};
use crate::observe::{
    AttemptReport, Ending, Event, FrictionCall, IterationReport, Observer, Status, StepReport,
    Stop, Totals,
};
use crate::plan::{Numbering, Plan, PlanMismatch};
use crate::problem::{self, Means, Problem};
use crate::start::Start;
use crate::state::State;
use crate::tangent;
use crate::users::UserFrictions;
use crate::values::Values;
use crate::workspace::Workspace;
use shown::{Numbers, Rows, frame};
use slideline_diag::{Code, Diagnostic};
use slideline_linalg::Kind;
use slideline_mech::contact::enforcement::Enforcement;
use slideline_model::{Model, Static};
use std::borrow::Cow;
use std::ops::ControlFlow;

/// How to run.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Threads for the evaluation of elements; results do not depend on it.
    pub threads: usize,
    /// Friction laws of the embedding program.
    pub user_frictions: UserFrictions,
    /// Which tangents are held against differences.
    pub check_tangent: TangentCheck,
    /// How contact is solved; `None`: as its size asks for.
    pub enforcement: Option<Enforcement>,
    /// What makes the linear systems.
    pub linear_systems: LinearSystems,
}

/// Which tangents are held against differences of the residual.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum TangentCheck {
    /// None.
    #[default]
    Never,
    /// Those of every converged increment.
    Every,
    /// That of the increment with this number in every step.
    Increment(usize),
}

impl TangentCheck {
    fn is_due(self, increment: usize) -> bool {
        match self {
            Self::Never => false,
            Self::Every => true,
            Self::Increment(number) => number == increment,
        }
    }
}

impl Default for Options {
    fn default() -> Self {
        Self {
            threads: 1,
            user_frictions: UserFrictions::default(),
            check_tangent: TangentCheck::Never,
            enforcement: None,
            linear_systems: LinearSystems::default(),
        }
    }
}

/// Runs every step of a model and tells the observer.
pub fn run(model: &Model, options: &Options, observer: &mut dyn Observer) -> Ending {
    let run = Workspace::new(&Plan::of(model), options).run(model, observer);
    run.unwrap_or_else(|mismatch| impossible(&mismatch))
}

/// Goes on from a checkpoint of the same model and tells the observer; the
/// step it stands in begins anew for the observer, as resumed. `None` where
/// the checkpoint is not one of this model: nothing was told.
pub fn resume(
    model: &Model,
    options: &Options,
    from: Checkpoint<'static>,
    observer: &mut dyn Observer,
) -> Option<Ending> {
    go_on(model, options, &from, observer, (from.totals, true))
}

/// Walks what a model has behind a checkpoint, as a run of its own: the rest
/// of its step, where there is one, and the steps after it. Increments and
/// iterations count from zero, time and energies go on. `None` where the
/// checkpoint is not one of this model: nothing was told.
pub fn run_from(
    model: &Model,
    options: &Options,
    from: &Checkpoint<'_>,
    observer: &mut dyn Observer,
) -> Option<Ending> {
    let totals = Totals { dropped_points: from.totals.dropped_points, ..Totals::default() };
    go_on(model, options, from, observer, (totals, false))
}

/// The increments behind a checkpoint; `counts`: the totals so far, and whether the observer
/// has seen what came before.
fn go_on(
    model: &Model,
    options: &Options,
    from: &Checkpoint<'_>,
    observer: &mut dyn Observer,
    counts: (Totals, bool),
) -> Option<Ending> {
    if !from.fits(model) {
        return None;
    }
    let run = Workspace::new(&Plan::of(model), options).go_on(model, from, observer, counts);
    Some(run.unwrap_or_else(|mismatch| impossible(&mismatch)))
}

/// A model that is not of its own plan: a fault of this program.
fn impossible(mismatch: &PlanMismatch) -> Ending {
    let said = Diagnostic::error(Code("SL0901"), mismatch.to_string());
    Ending::NotConverged(Totals::default(), said)
}

/// After an increment that only a last resort has found, the next begins as a
/// step does: what made the one before short lies behind.
fn begin_again(decision: Decision, procedure: &Static) -> Decision {
    match decision {
        Decision::Continue(next) => {
            let begun = Control::begin(procedure);
            let left = procedure.period - next.time;
            Decision::Continue(Control { dt: begun.dt.min(left), quick: 0, ..next })
        }
        other => other,
    }
}

/// States of one increment that the pattern follows; beyond, the tangent may do
/// without couplings of contact that roams.
const MOST_REACHED: usize = 12;

/// Where the states and rows of a run stand, to be used again.
#[derive(Default)]
pub struct Room {
    committed: State,
    trial: State,
    rows: Rows,
    start: Start<'static>,
    /// States of an increment that the pattern follows.
    reached: Vec<Vec<f64>>,
}

impl Room {
    /// The undeformed model of a plan.
    pub fn begin(&mut self, plan: &Numbering) {
        let [points, state_variables, elements] = plan.sizes;
        let states = (state_variables, elements);
        self.committed.begin(plan.dofs.len(), points, states);
        self.trial.begin(plan.dofs.len(), points, states);
    }
}

/// A run under way.
pub struct Analysis<'a> {
    model: &'a Model,
    plan: &'a Numbering,
    values: &'a Values,
    means: Means<'a>,
    observer: &'a mut dyn Observer,
    committed: &'a mut State,
    trial: &'a mut State,
    start: &'a mut Start<'static>,
    reached: &'a mut Vec<Vec<f64>>,
    /// Counts of the run so far.
    pub totals: Totals,
    /// Whether the observer has seen what came before.
    pub resumes: bool,
    check_tangent: TangentCheck,
    enforcement: Option<Enforcement>,
    /// One fault of the tangent is enough to be told.
    tangent_is_wrong: bool,
    /// Whether it was said that masters leave no room.
    room_is_judged: bool,
    rows: &'a mut Rows,
}

/// Why a step was left before its end.
enum Left {
    Stopped(Stop),
    Failed(Box<Diagnostic>),
}

impl<'a> Analysis<'a> {
    /// A run from the undeformed model on.
    pub fn new(
        model: &'a Model,
        (plan, values): (&'a Numbering, &'a Values),
        (options, means): (&Options, Means<'a>),
        (room, observer): (&'a mut Room, &'a mut dyn Observer),
    ) -> Self {
        let Room { committed, trial, rows, start, reached } = room;
        Self {
            model,
            plan,
            values,
            means,
            observer,
            committed,
            trial,
            start,
            reached,
            totals: Totals::default(),
            resumes: false,
            check_tangent: options.check_tangent,
            enforcement: options.enforcement,
            tangent_is_wrong: false,
            room_is_judged: false,
            rows,
        }
    }

    /// All steps.
    pub fn steps(&mut self, work: &mut Scratch) -> Ending {
        self.ending(1, work)
    }

    /// The rest of the step of a checkpoint, then the others.
    pub fn go_on(&mut self, from: &Checkpoint<'_>, work: &mut Scratch) -> Ending {
        self.committed.clone_from(from.state.as_ref());
        if from.last_of_step() && !self.resumes {
            return self.ending(from.step + 1, work);
        }
        match self.rest_of_step(from, work) {
            Ok(()) => self.ending(from.step + 1, work),
            Err(left) => self.left(left),
        }
    }

    /// All steps from that number on.
    fn ending(&mut self, from: usize, work: &mut Scratch) -> Ending {
        for number in from..=self.model.steps.len() {
            if let Err(left) = self.step(number, work) {
                return self.left(left);
            }
        }
        Ending::Completed(self.totals)
    }

    fn left(&self, left: Left) -> Ending {
        match left {
            Left::Stopped(stop) => Ending::Stopped(self.totals, stop),
            Left::Failed(diagnosis) => Ending::NotConverged(self.totals, *diagnosis),
        }
    }

    /// One step: increments until its end, or until none can be found.
    fn step(&mut self, number: usize, work: &mut Scratch) -> Result<(), Left> {
        self.committed.step_time = 0.0;
        self.committed.increment_time = (0.0, 0.0);
        self.committed.flux.iter_mut().for_each(FluxAverage::begin_step);
        self.committed.damping.clear();
        self.committed.stabilised = false;
        let mut start = std::mem::take(self.start);
        let own = self.plan.of_step[number - 1];
        start.take(self.committed, &self.plan.steps[own].constraints);
        let walked = self.all_increments(number, (&start, None), work);
        *self.start = start;
        walked
    }

    /// What is left of a step.
    fn rest_of_step(&mut self, from: &Checkpoint<'_>, work: &mut Scratch) -> Result<(), Left> {
        self.all_increments(from.step, (&from.start, Some(from)), work)
    }

    /// Increments until the end of the step, from its beginning or from a checkpoint; where
    /// contact couples what the pattern does not hold, it is made anew.
    fn all_increments(
        &mut self,
        number: usize,
        (start, from): (&Start<'_>, Option<&Checkpoint<'_>>),
        work: &mut Scratch,
    ) -> Result<(), Left> {
        let (model, plan, values) = (self.model, self.plan, self.values);
        let step = &model.steps[number - 1];
        let kind = problem::kind(model, step, &values.contact);
        let at_once = Control::begin(&step.procedure);
        let mut control = from.map_or(Some(at_once), |from| from.control);
        // within an increment what it has touched on its way stays
        let mut count = 0;
        let mut begun = false;
        loop {
            let here = std::iter::once(&self.committed.displacement[..]);
            let states = here.chain(self.reached[..count].iter().map(Vec::as_slice));
            let own = (plan, plan.of_step[number - 1]);
            let states = (states, &self.committed.points[..]);
            let coupling = work.couple(own, (values, kind), states, self.means.linear_systems);
            let means = self.means;
            let at = (model, number - 1);
            let problem = Problem::new(at, (plan, values), &coupling, start, means);
            let is_lenient = count > MOST_REACHED;
            let problem = Problem { is_lenient, enforcement: self.enforcement, ..problem };
            work.fit(&problem);
            work.tell_motions(&problem);
            if begun || from.is_some() {
                crate::commit::recall_points(self.committed, work);
            } else {
                let (positions, kinematics) = work.places();
                let contact = &values.contact;
                crate::commit::locate_points(contact, self.committed, positions, kinematics);
            }
            if !begun {
                self.begin(&problem, number, from, work)?;
                begun = true;
            }
            let Some(from_here) = control else { return Ok(()) };
            let Some(outside) = self.increments(&problem, number, from_here, work)? else {
                return Ok(());
            };
            if outside.committed != from_here.committed {
                count = 0;
            }
            match self.reached.get_mut(count) {
                Some(room) => room.clone_from(&work.u),
                None => self.reached.push(work.u.clone()),
            }
            count += 1;
            control = Some(outside);
        }
    }

    /// Increments until the end of the step, or until none can be found, or until
    /// contact couples what the pattern does not hold: then, where it stands.
    fn increments(
        &mut self,
        plan: &Problem<'_>,
        number: usize,
        mut control: Control,
        work: &mut Scratch,
    ) -> Result<Option<Control>, Left> {
        let (step, limits) = (plan.step, plan.step.controls.effective_time());
        loop {
            let mut target = Target {
                step: number,
                increment: control.committed + 1,
                attempt: control.attempts as usize + 1,
                step_time: control.target(&step.procedure),
                dt: control.target(&step.procedure) - control.time,
            };
            let after =
                |verdict| control.after(verdict, &step.procedure, &limits, step.max_increments);
            let mut outcome = self.attempt(plan, &target, work)?;
            if work.outside {
                work.take_back(outcome);
                return Ok(Some(control));
            }
            if self.stabilise(plan, &outcome, work)? {
                continue;
            }
            let coarseness = self.coarseness(plan, (&target, &mut outcome), work);
            let mut decision = after(outcome.verdict);
            if let Some(part) = coarseness {
                decision = control.as_creep_allows(decision, part, &step.procedure, &limits);
            }
            let mut diagnosis = None;
            let converged = matches!(outcome.verdict, Verdict::Converged { .. });
            if let (Decision::Stop(reason), false) = (decision, converged) {
                let cause = self.diagnosis(plan, &target, &outcome, reason, work);
                if outcome.verdict.may_be_searched() {
                    self.fail(plan, (&target, &outcome), Some(target.dt))?;
                    target.attempt += 1;
                    outcome = self.last_resorts(plan, (&mut target, &cause), work)?;
                    decision = begin_again(after(outcome.verdict), &step.procedure);
                }
                diagnosis = Some(Box::new(cause));
            }
            if let Verdict::Converged { .. } = outcome.verdict {
                self.commit(plan, &target, &outcome, &decision, work)?;
            }
            match decision {
                Decision::StepDone => {
                    work.take_back(outcome);
                    return Ok(None);
                }
                Decision::Continue(next) => control = next,
                Decision::Cut(next) => {
                    self.fail(plan, (&target, &outcome), Some(next.dt))?;
                    control = next;
                }
                Decision::Stop(reason) => {
                    if !matches!(outcome.verdict, Verdict::Converged { .. }) {
                        self.fail(plan, (&target, &outcome), None)?;
                        self.show_unconverged(plan, &target, &outcome, work)?;
                    }
                    let diagnosis = match diagnosis {
                        Some(found) => found,
                        None => Box::new(self.diagnosis(plan, &target, &outcome, reason, work)),
                    };
                    self.tell(Event::Diagnosed(&diagnosis))?;
                    return Err(Left::Failed(diagnosis));
                }
            }
            work.take_back(outcome);
        }
    }

    fn attempt(
        &mut self,
        plan: &Problem<'_>,
        target: &Target,
        work: &mut Scratch,
    ) -> Result<Outcome, Left> {
        self.watched(|committed, watch| attempt(plan, committed, target, work, watch))
    }

    /// By which part of what `CETOL` allows the creep strains of an increment differ, taken by the
    /// conditions at its two ends; one that is too coarse is no longer taken for converged. `None`:
    /// nothing is asked.
    fn coarseness(
        &mut self,
        plan: &Problem<'_>,
        (target, outcome): (&Target, &mut Outcome),
        work: &Scratch,
    ) -> Option<f64> {
        let allowed = plan.step.procedure.creep_tolerance?;
        let converged = matches!(outcome.verdict, Verdict::Converged { .. });
        if !converged || target.dt <= 0.0 {
            return None;
        }
        let trial = &mut self.trial.elements;
        trial.copy_from_slice(&self.committed.elements);
        plan.structure.gather_state(&work.evaluation.contributions, trial);
        let part = plan.structure.creep_difference(trial) / allowed;
        if part > 1.0 && !plan.step.procedure.direct {
            outcome.verdict = Verdict::TooCoarse { percent: (100.0 * part) as u32 };
        }
        Some(part)
    }

    /// Iterations that are counted and shown.
    fn watched(
        &mut self,
        iterate: impl FnOnce(&State, &mut dyn FnMut(&IterationReport)) -> Outcome,
    ) -> Result<Outcome, Left> {
        let mut stop = None;
        let (observer, totals) = (&mut *self.observer, &mut self.totals);
        let mut watch = |report: &IterationReport| {
            totals.iterations += 1;
            if let ControlFlow::Break(reason) = observer.event(Event::Iteration(report)) {
                stop = Some(reason);
            }
        };
        let outcome = iterate(self.committed, &mut watch);
        match stop {
            Some(stop) => Err(Left::Stopped(stop)),
            None => Ok(outcome),
        }
    }

    fn fail(
        &mut self,
        plan: &Problem<'_>,
        (target, outcome): (&Target, &Outcome),
        next: Option<f64>,
    ) -> Result<(), Left> {
        self.totals.cutbacks += 1;
        let report = AttemptReport {
            step: target.step,
            increment: target.increment,
            attempt: target.attempt,
            severe_iterations: outcome.severe,
            equilibrium_iterations: outcome.equilibrium,
            total_time: self.committed.total_time + target.dt,
            step_time: target.step_time,
            time_increment: target.dt,
            reason: diagnose::reason(plan, outcome),
            next,
        };
        self.tell(Event::AttemptFailed(&report))
    }

    fn tell(&mut self, event: Event<'_>) -> Result<(), Left> {
        match self.observer.event(event) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(stop) => Err(Left::Stopped(stop)),
        }
    }

    /// Announces a step with the state it begins from, or goes on from.
    fn begin(
        &mut self,
        plan: &Problem<'_>,
        number: usize,
        from: Option<&Checkpoint<'_>>,
        work: &mut Scratch,
    ) -> Result<(), Left> {
        if let Some(said) = work.objection() {
            self.tell(Event::Diagnosed(&said))?;
            return Err(Left::Failed(Box::new(said)));
        }
        self.rows.fill(plan, self.committed);
        self.rows.pairs.clear();
        let increment = from.map_or(0, |from| from.increment);
        let numbers = Numbers { step: number, increment, ..Numbers::default() };
        let frame = frame(plan, self.committed, &numbers, self.rows);
        let report = StepReport {
            model: self.model,
            step: number,
            equations: plan.constraints.equations(),
            entries: plan.pattern.entries(),
            linear_solver: work.solver().description(),
            unsymmetric: plan.kind() == Kind::Unsymmetric,
            total_time: self.committed.total_time,
            start: frame,
            resumed: from.is_some() && self.resumes,
        };
        match self.observer.event(Event::StepBegin(&report)) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(stop) => Err(Left::Stopped(stop)),
        }
    }

    /// Makes the trial the committed state and shows it.
    fn commit(
        &mut self,
        plan: &Problem<'_>,
        target: &Target,
        outcome: &Outcome,
        decision: &Decision,
        work: &mut Scratch,
    ) -> Result<(), Left> {
        if self.check_tangent.is_due(target.increment) {
            self.check(plan, target, work)?;
        }
        commit(plan, self.committed, target, work, self.trial);
        let left = diagnose::slid_off(plan, self.committed, self.trial);
        std::mem::swap(self.committed, self.trial);
        self.totals.increments += 1;
        let Rows { contact, closed, .. } = &mut *self.rows;
        closed.clear();
        closed.extend(contact.iter().map(|row| row.status != Status::Open));
        let dropped = |point: &&crate::state::PointState| point.friction == FrictionCall::Dropped;
        self.totals.dropped_points += self.committed.points.iter().filter(dropped).count();
        self.rows.fill(plan, self.committed);
        let last = *decision == Decision::StepDone;
        let numbers = Numbers { last, ..Numbers::of(target, outcome) };
        let Rows { contact, closed, pairs, sums, .. } = &mut *self.rows;
        pair_rows(plan, self.committed, work, (contact, closed), (pairs, sums));
        let jumped = self.balance_books(plan, target, work);
        let frame = frame(plan, self.committed, &numbers, self.rows);
        // A wish to stop does not keep back what belongs to the increment.
        let mut told = match self.observer.event(Event::Committed(&frame)) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(stop) => Err(Left::Stopped(stop)),
        };
        if *decision == Decision::StepDone {
            told = told.and(self.judge_stabilisation(plan)).and(self.judge_balance(plan, target));
        }
        told = told.and(self.judge_room(plan));
        for diagnosis in jumped.iter().chain(&left) {
            told = told.and(self.tell(Event::Diagnosed(diagnosis)));
        }
        let kept = self.keep(plan, target, decision, told.is_err());
        told.and(kept)
    }

    /// Holds the tangent of the converged trial against differences.
    fn check(&mut self, plan: &Problem<'_>, target: &Target, work: &Scratch) -> Result<(), Left> {
        let trial = work.trial(self.committed, target.dt);
        let place =
            tangent::Place { plan, committed: self.committed, trial, evaluation: &work.evaluation };
        let report = tangent::check(&place, (target.step, target.increment));
        let fault = tangent::fault(plan, &report).filter(|_| !self.tangent_is_wrong);
        self.tell(Event::Tangent(&report))?;
        self.tangent_is_wrong |= fault.is_some();
        fault.iter().try_for_each(|said| self.tell(Event::Diagnosed(said)))
    }

    /// Shows the state that the run could go on from, if it goes on.
    fn keep(
        &mut self,
        plan: &Problem<'_>,
        target: &Target,
        decision: &Decision,
        stopping: bool,
    ) -> Result<(), Left> {
        let control = match decision {
            Decision::Continue(next) => Some(*next),
            Decision::StepDone => None,
            Decision::Cut(_) | Decision::Stop(_) => return Ok(()),
        };
        let checkpoint = Checkpoint {
            step: target.step,
            increment: target.increment,
            stopping,
            totals: self.totals,
            state: Cow::Borrowed(&*self.committed),
            start: plan.start.borrowed(),
            control,
        };
        match self.observer.event(Event::Checkpoint(&checkpoint)) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(stop) => Err(Left::Stopped(stop)),
        }
    }
}
