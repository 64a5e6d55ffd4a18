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

mod questions;
mod search;

use crate::contact::{GeometryScratch, Meeting, STRIP_POINTS, SlavePoint};
use crate::convergence::{Field, FieldHistory, Measures, judge, largest_nodal};
use crate::evaluate::{Evaluation, Trial, evaluate};
use crate::evidence::Evidence;
use crate::increments::Verdict;
use crate::linearised::{Circumstances, LinearPoint, LinearisedContact, MOST_DOFS, Sliding};
use crate::observe::{ContactChange, IterationReport};
use crate::plan::Plan;
use crate::predict;
use crate::stabilise::{self, Dashpot};
use crate::state::State;
use slideline_linalg::{SolveError, Solver};

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
    values: Vec<f64>,
    correction: Vec<f64>,
    correction_slots: Vec<f64>,
    residual: Vec<f64>,
    increment: Vec<f64>,
    pressures: Vec<f64>,
    tractions: Vec<f64>,
    points: Vec<LinearPoint>,
    contact: LinearisedContact,
    geometry: GeometryScratch,
    dashpots: Vec<Dashpot>,
    chain_positions: Vec<[f64; 2]>,
    was_closed: Vec<bool>,
    /// Most negative pivots of a symmetric factorisation in this attempt:
    /// directions in which the structure gives way.
    pub negative_pivots: usize,
    /// What the iterations of this attempt showed of every contact point.
    pub evidence: Evidence,
    /// Whether corrections are shortened until they lessen the residual.
    pub line_search: bool,
    /// Fraction of the last correction that was taken [1].
    step_length: f64,
    /// Whether every facing point lends its stiffness in this attempt.
    lend_to_all: bool,
    /// The list of changes of the last report, to be used again.
    changes: Vec<ContactChange>,
}

/// The largest rotation that one iteration may add [1].
const LARGEST_ROTATION: f64 = 0.5;
/// How far apart, in sizes of the model, points still count as touching when
/// stiffness is lent.
const TOUCH: f64 = 1e-9;
/// Stiffness lent to a closed point, as a fraction of the stiffest element.
const LENT: f64 = 0.1;

impl Workspace {
    /// Room for a plan; the symbolic factorisation happens here.
    pub fn new(plan: &Plan<'_>) -> Self {
        let (slots, equations) = (plan.layout.slots(), plan.layout.equations());
        let points = plan.contact.points.len();
        let mut contact = LinearisedContact::default();
        contact.reserve(points, equations);
        Self {
            u: vec![0.0; slots],
            load: vec![0.0; slots],
            evaluation: Evaluation::new(plan),
            solver: plan.analyse(),
            values: vec![0.0; plan.pattern.entries()],
            correction: vec![0.0; equations],
            correction_slots: vec![0.0; slots],
            residual: vec![0.0; slots],
            increment: vec![0.0; slots],
            pressures: vec![0.0; points],
            tractions: vec![0.0; points],
            points: Vec::with_capacity(points),
            contact,
            geometry: GeometryScratch::new(&plan.contact),
            dashpots: Vec::new(),
            chain_positions: Vec::new(),
            was_closed: vec![false; points],
            negative_pivots: 0,
            evidence: Evidence::new(points),
            line_search: false,
            step_length: 1.0,
            lend_to_all: false,
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
            return progress.end(Verdict::Broken, Some(fault));
        }
        if work.evaluation.fault.is_some() {
            return progress.end(Verdict::Broken, None);
        }
        let report = work.judge(plan, committed, target, &mut progress);
        watch(&report);
        let verdict = progress.verdict(&report, &limits);
        progress.last = Some(report);
        if let Some(verdict) = verdict {
            return progress.end(verdict, None);
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
        Outcome { verdict, severe, equilibrium, fault, last: self.last }
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
        self.lend_to_all = false;
        self.negative_pivots = 0;
        let times = (target.step_time, target.dt);
        stabilise::fill(plan, committed, times, &mut self.chain_positions, &mut self.dashpots);
        self.u.copy_from_slice(&committed.displacement);
        predict::extrapolate(plan, committed, target.dt, &mut self.u);
        plan.prescribe(target.step_time, &mut self.u);
        plan.load(target.step_time, &mut self.load);
        plan.layout.follow_links(&mut self.u);
        for (place, point) in committed.points.iter().enumerate() {
            self.pressures[place] = point.pressure;
            self.tractions[place] = point.traction;
            self.was_closed[place] = point.closed;
        }
        if committed.increment_time[0] == 0.0 {
            self.spread_prescribed(plan, committed, target);
        }
        self.evaluate(plan, committed, target.dt);
        self.evidence.begin(&self.evaluation.points);
    }

    /// Without a last increment to repeat, what is prescribed on the
    /// structure is spread over it linearly, lest one element takes it all.
    fn spread_prescribed(&mut self, plan: &Plan<'_>, committed: &State, target: &Target) {
        let change = &mut self.correction_slots;
        for (slot, value) in change.iter_mut().enumerate() {
            *value = self.u[slot] - committed.displacement[slot];
        }
        let from = &committed.displacement;
        plan.structure.evaluate(from, &mut self.evaluation.contributions, plan.pool);
        self.residual.fill(0.0);
        plan.structure.multiply(&self.evaluation.contributions, change, &mut self.residual);
        for (equation, &slot) in plan.layout.slot_of_equation.iter().enumerate() {
            self.correction[equation] = -self.residual[slot];
        }
        if self.correction.iter().all(|&value| value == 0.0) {
            return;
        }
        self.values.fill(0.0);
        plan.structure.gather_tangent(&self.evaluation.contributions, &mut self.values);
        let factored = self.solver.refactor(&plan.pattern, &self.values);
        if factored.is_ok() && self.solver.solve(&mut self.correction).is_ok() {
            for (equation, &slot) in plan.layout.slot_of_equation.iter().enumerate() {
                self.u[slot] += self.correction[equation];
            }
            plan.layout.follow_links(&mut self.u);
            plan.prescribe(target.step_time, &mut self.u);
        }
    }

    /// The trial state that was evaluated last.
    pub fn trial(&self, committed: &State, dt: f64) -> Trial<'_> {
        Trial {
            u: &self.u,
            load: &self.load,
            pressures: &self.pressures,
            tractions: &self.tractions,
            dashpots: &self.dashpots,
            time: committed.total_time + dt,
            dt,
        }
    }

    fn evaluate(&mut self, plan: &Plan<'_>, committed: &State, dt: f64) {
        let trial = Trial {
            u: &self.u,
            load: &self.load,
            pressures: &self.pressures,
            tractions: &self.tractions,
            dashpots: &self.dashpots,
            time: committed.total_time + dt,
            dt,
        };
        evaluate(plan, committed, &trial, &mut self.evaluation);
    }

    /// One Newton iteration: assemble, factor, solve, move, evaluate.
    fn iterate(&mut self, plan: &Plan<'_>, committed: &State, dt: f64) -> Result<(), SolveError> {
        self.factor(plan, committed)?;
        for (equation, &slot) in plan.layout.slot_of_equation.iter().enumerate() {
            self.correction[equation] =
                self.evaluation.external[slot] - self.evaluation.internal[slot];
        }
        if !self.dashpots.is_empty() {
            for (equation, &slot) in plan.layout.slot_of_equation.iter().enumerate() {
                self.correction[equation] -= self.evaluation.damping[slot];
            }
        }
        self.contact.solve(
            &mut self.points,
            &circumstances(plan, committed, dt),
            &mut self.solver,
            &mut self.correction,
        )?;
        let length = self.limit_turns(plan);
        if self.line_search {
            self.search(plan, committed, (dt, length));
        } else {
            self.advance(plan, length);
            self.evaluate(plan, committed, dt);
        }
        Ok(())
    }

    /// Assembles and factors. Where nothing but contact that is still open
    /// would hold the model, stiffness is lent to every point that faces its
    /// master, and the contact step closes the gap.
    fn factor(&mut self, plan: &Plan<'_>, committed: &State) -> Result<(), SolveError> {
        loop {
            self.linearise_points(plan, committed);
            self.assemble(plan);
            if plan.symmetrised() {
                plan.symmetrise(&mut self.values);
            }
            match self.solver.refactor(&plan.pattern, &self.values) {
                Ok(report) => {
                    let negative = report.negative_pivots.unwrap_or(0);
                    self.negative_pivots = self.negative_pivots.max(negative);
                    return Ok(());
                }
                Err(SolveError::Singular { .. }) if !self.lend_to_all => self.lend_to_all = true,
                Err(fault) => return Err(fault),
            }
        }
    }

    /// Contact points as the small system wants them.
    fn linearise_points(&mut self, plan: &Plan<'_>, committed: &State) {
        self.points.clear();
        for (place, point) in plan.contact.points.iter().enumerate() {
            let meeting = &self.evaluation.meetings[place];
            if point.is_station() && !meeting.faces {
                self.pressures[place] = 0.0;
                self.tractions[place] = 0.0;
                continue;
            }
            let before = &committed.points[place];
            let laws = &plan.contact.laws[point.pair];
            let touching = meeting.faces
                && (self.lend_to_all
                    || self.pressures[place] > 0.0
                    || meeting.overclosure > laws.normal.contact_begins() - TOUCH * plan.reach);
            let lent = if touching { lent_stiffness(plan, point) } else { 0.0 };
            let called = laws.has_friction() && laws.onset.called(before.closed, true);
            let sliding = (called && meeting.faces).then(|| Sliding {
                slip: plan.contact.slip(place, &before.history(), meeting, &committed.displacement),
                elastic_slip: before.elastic_slip,
                traction: self.tractions[place],
                stiffness: lent,
                memory: (point.memory, point.memory_size),
            });
            let mut linear = LinearPoint {
                place,
                pair: point.pair,
                area: meeting.area,
                integrated: point.is_station(),
                width: 0,
                equations: [0; MOST_DOFS],
                normal: [0.0; MOST_DOFS],
                tangential: [0.0; MOST_DOFS],
                drag: [0.0; MOST_DOFS],
                overclosure: meeting.overclosure,
                pressure: if meeting.faces { self.pressures[place] } else { 0.0 },
                stiffness: lent,
                sliding,
            };
            for k in 0..meeting.width {
                if let Some(equation) = plan.layout.equation(meeting.slots[k]) {
                    linear.equations[linear.width] = equation;
                    linear.normal[linear.width] = meeting.gradient[k];
                    linear.tangential[linear.width] = meeting.slip_gradient[k];
                    linear.drag[linear.width] = meeting.drag[k];
                    linear.width += 1;
                }
            }
            self.points.push(linear);
        }
    }

    /// Elements, geometry of contact, and the stiffness lent to closed points.
    fn assemble(&mut self, plan: &Plan<'_>) {
        self.values.fill(0.0);
        plan.structure.gather_tangent(&self.evaluation.contributions, &mut self.values);
        for (slot, stiffness) in plan.layout.load_stiffness(&self.u, &self.load) {
            let equation = plan.layout.equation(slot);
            if let Some(at) = equation.and_then(|e| plan.pattern.position(e, e)) {
                self.values[at] += stiffness;
            }
        }
        self.dashpots.iter().for_each(|dashpot| dashpot.stiffen(plan, &mut self.values));
        plan.contact.fill_scratch(&self.u, &mut self.geometry);
        for k in 0..self.points.len() {
            if self.points[k].pressure == 0.0 && self.points[k].stiffness == 0.0 {
                continue;
            }
            self.add_geometry(plan, self.points[k].place);
            let linear = &self.points[k];
            let sliding_stiffness = linear.sliding.map_or(0.0, |sliding| sliding.stiffness);
            for i in 0..linear.width {
                for j in 0..linear.width {
                    let at = plan.pattern.position(linear.equations[i], linear.equations[j]);
                    if let Some(at) = at {
                        self.values[at] += linear.area
                            * (linear.stiffness * linear.normal[i] * linear.normal[j]
                                + sliding_stiffness * linear.drag[i] * linear.tangential[j]);
                    }
                }
            }
        }
    }

    fn add_geometry(&mut self, plan: &Plan<'_>, place: usize) {
        let meeting: &Meeting = &self.evaluation.meetings[place];
        let width = meeting.width;
        let forces = (meeting.area * self.pressures[place], meeting.area * self.tractions[place]);
        let geometry = &mut self.geometry;
        plan.contact.geometric_tangent(place, &self.u, meeting, forces, geometry);
        for i in 0..width {
            let Some(row) = plan.layout.equation(meeting.slots[i]) else { continue };
            for j in 0..width {
                let Some(column) = plan.layout.equation(meeting.slots[j]) else { continue };
                if let Some(at) = plan.pattern.position(row, column) {
                    self.values[at] += geometry.tangent[width * i + j];
                }
            }
        }
    }

    /// Fraction of the correction at which no node turns too far.
    fn limit_turns(&self, plan: &Plan<'_>) -> f64 {
        let mut turn = 0.0_f64;
        for (equation, &slot) in plan.layout.slot_of_equation.iter().enumerate() {
            if plan.layout.name(slot).1.is_rotation() {
                turn = turn.max(self.correction[equation].abs());
            }
        }
        if turn > LARGEST_ROTATION { LARGEST_ROTATION / turn } else { 1.0 }
    }

    /// Moves by a fraction of the correction.
    fn advance(&mut self, plan: &Plan<'_>, length: f64) {
        self.step_length = length;
        self.correction_slots.fill(0.0);
        for (equation, &slot) in plan.layout.slot_of_equation.iter().enumerate() {
            self.correction_slots[slot] = self.correction[equation];
        }
        for (slot, change) in self.correction_slots.iter_mut().enumerate() {
            *change *= length;
            self.u[slot] += *change;
        }
        for linear in &self.points {
            let place = linear.place;
            let pressure = &mut self.pressures[place];
            *pressure += length * (linear.pressure - *pressure);
            let traction = linear.sliding.map_or(0.0, |sliding| sliding.traction);
            let old = &mut self.tractions[place];
            *old += length * (traction - *old);
        }
        plan.layout.follow_links(&mut self.u);
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
            converged: false,
        };
        let flux = [self.evaluation.flux.mean_force(), self.evaluation.flux.mean_moment()];
        let controls = &plan.step.controls.field;
        let averages = [0, 1].map(|field| committed.flux[field].with(flux[field], controls));
        self.note_changes(plan, controls.r_n * averages[0], &mut report);
        self.evidence.note(&self.evaluation.points);
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
        let floors = self.floors(plan);
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

    /// The list of the report before, emptied: iterations allocate nothing.
    fn empty_changes(&mut self, progress: &mut Progress) -> Vec<ContactChange> {
        if let Some(last) = progress.last.take() {
            self.changes = last.contact_changes;
        }
        self.changes.clear();
        std::mem::take(&mut self.changes)
    }

    fn measure(
        &mut self,
        plan: &Plan<'_>,
        committed: &State,
        field: Field,
    ) -> crate::observe::FieldReport {
        let layout = &plan.layout;
        for slot in 0..layout.slots() {
            self.residual[slot] =
                self.evaluation.internal[slot] + self.evaluation.contact[slot] - self.load[slot];
            self.increment[slot] = self.u[slot] - committed.displacement[slot];
        }
        let free = |slot: usize| layout.equation(slot).is_some();
        let (residual, at) = largest_nodal(layout, field, &self.residual, free);
        let (correction, moved) = largest_nodal(layout, field, &self.correction_slots, free);
        let (increment, _) = largest_nodal(layout, field, &self.increment, |_| true);
        crate::observe::FieldReport {
            residual,
            residual_at: at.map(|slot| layout.name(slot)),
            correction,
            correction_at: moved.map(|slot| layout.name(slot)),
            increment,
            ..crate::observe::FieldReport::default()
        }
    }

    /// What rounding leaves of a residual: 50 eps EA max|u| / l of the
    /// elements, and what the rounding of positions makes of contact.
    /// Moments: the same times their levers.
    fn floors(&self, plan: &Plan<'_>) -> [f64; 2] {
        let mut moved = 0.0_f64;
        let mut reach = plan.reach;
        for (slot, &u) in self.u.iter().enumerate() {
            if !plan.layout.name(slot).1.is_rotation() {
                reach = reach.max(u.abs());
                if plan.elastic[slot] {
                    moved = moved.max(u.abs());
                }
            }
        }
        let elastic = 50.0 * f64::EPSILON * plan.structure.stiffest * moved;
        let contact = 4.0 * f64::EPSILON * self.contact_size(plan, reach);
        [elastic + contact, elastic * plan.structure.stiffest_length + contact * reach]
    }

    /// Largest contact force, and largest change of one when positions
    /// change by the size of the model [F].
    fn contact_size(&self, plan: &Plan<'_>, reach: f64) -> f64 {
        let mut largest = 0.0_f64;
        for (place, point) in self.evaluation.points.iter().enumerate() {
            if point.closed {
                let laws = &plan.contact.laws[plan.contact.points[place].pair];
                let slope = laws.normal.pressure(-point.opening).map_or(0.0, |(_, slope)| slope);
                largest = largest.max(point.area * (point.pressure.abs() + slope * reach));
            }
        }
        largest
    }

    /// Notes points whose contact changed since the last iteration by more
    /// than the residual tolerance: below it a change is no discontinuity.
    fn note_changes(&mut self, plan: &Plan<'_>, negligible: f64, report: &mut IterationReport) {
        for (place, point) in self.evaluation.points.iter().enumerate() {
            if point.closed == self.was_closed[place] || plan.contact.points[place].is_station() {
                continue;
            }
            let own = &plan.contact.points[place];
            report.contact_changes.push(ContactChange {
                pair: own.pair,
                node: own.node,
                closed: point.closed,
            });
            report.severe |= !point.closed || point.area * point.pressure > negligible;
            self.was_closed[place] = point.closed;
        }
    }

    /// Hard contact and exact stick have no stiffness that would turn a
    /// defect into a residual: it is held against the structure's own.
    fn contact_settled(&self, plan: &Plan<'_>, allowed: f64) -> bool {
        let tolerance = self.contact_tolerance(plan, allowed);
        self.evaluation.penetration <= tolerance && self.evaluation.stick_slip <= tolerance
    }

    /// Overclosure that the structure would answer with the residual allowed,
    /// or that rounding leaves [L].
    fn contact_tolerance(&self, plan: &Plan<'_>, allowed: f64) -> f64 {
        let moved = self.u.iter().fold(0.0_f64, |largest, u| largest.max(u.abs()));
        let rounding = 8.0 * f64::EPSILON * (plan.reach + moved);
        let stiffest = plan.structure.stiffest;
        let by_force = if stiffest > 0.0 { allowed / stiffest } else { 0.0 };
        by_force.max(rounding)
    }
}

fn circumstances<'a>(plan: &'a Plan<'_>, committed: &'a State, dt: f64) -> Circumstances<'a> {
    Circumstances {
        laws: &plan.contact.laws,
        time: committed.total_time + dt,
        dt,
        committed: &committed.memory,
        symmetrised: plan.symmetrised(),
        rounding: 8.0 * f64::EPSILON * plan.reach,
    }
}

fn lent_stiffness(plan: &Plan<'_>, point: &SlavePoint) -> f64 {
    if plan.structure.stiffest > 0.0 && point.area > 0.0 {
        let points = if point.is_station() { STRIP_POINTS as f64 } else { 1.0 };
        LENT * plan.structure.stiffest / (points * point.area)
    } else {
        1.0
    }
}
