//! Steps and their increments, one after the other.

use super::analysis::{Analysis, Left};
use crate::checkpoint::Checkpoint;
use crate::contact::{Contact, NearContact, Reached};
use crate::increments::{Control, Decision, Verdict};
use crate::newton::Scratch;
use crate::observe::Ending;
use crate::problem::{self, Problem};
use crate::start::Start;
use crate::structure::Structure;
use crate::target::Target;
use slideline_model::Static;

/// States of one increment that the pattern follows; beyond, the tangent may do
/// without couplings of contact that roams.
const MOST_REACHED: usize = 12;

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

/// What the next attempt aims at.
fn aim(step: usize, control: &Control, procedure: &Static) -> Target {
    Target {
        step,
        increment: control.committed + 1,
        attempt: control.attempts as usize + 1,
        step_time: control.target(procedure),
        dt: control.target(procedure) - control.time,
    }
}

impl Analysis<'_> {
    /// All steps.
    pub fn steps(&mut self, work: &mut Scratch) -> Ending {
        self.ending(1, work)
    }

    /// The rest of the step of a checkpoint, then the others.
    pub fn go_on(&mut self, from: &Checkpoint<'_>, work: &mut Scratch) -> Ending {
        self.committed.clone_from(from.state.as_ref());
        self.rows.heaviest.begin(&from.heaviest);
        self.overpulled = from.overpulled;
        self.start.references = from.start.references.clone().into_owned().into();
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

    /// One step: increments until its end, or until none can be found.
    fn step(&mut self, number: usize, work: &mut Scratch) -> Result<(), Left> {
        self.note_before();
        let mut start = std::mem::take(self.start);
        let changed = self.open_step(number, &mut start);
        let done = changed.and_then(|()| self.all_increments(number, (&start, None), work));
        *self.start = start;
        done
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
        let contact = &*values.contact.of_step((model, plan.dofs.len()), number - 1);
        // where an element cannot begin, that was said before the step
        let own = self.own_kernels(step, &start.references).ok().flatten();
        let kernels = own.as_ref().unwrap_or(&values.kernels);
        let kind = problem::kind(model, step, contact);
        let nearly = problem::is_nearly_symmetric(model, step, contact);
        let at_once = Control::begin(&step.procedure);
        let mut control = from.map_or(Some(at_once), |from| from.control);
        // within an increment what it has touched on its way stays
        let mut count = 0;
        let mut begun = false;
        loop {
            let own = (plan, plan.of_step[number - 1]);
            let left = from.filter(|_| !begun).map(|from| &from.near);
            self.near(contact, (left, count), work);
            let systems = self.means.linear_systems;
            let coupling = work.couple(own, (values, contact), (kind, nearly), systems);
            let means = self.means;
            let at = (model, number - 1);
            let problem = Problem::new(at, (plan, values), &coupling, start, means);
            // a pattern that may be left is not made anew in its step
            let was_lenient = from.is_some_and(|from| from.near.is_lenient);
            let is_lenient = was_lenient || count > MOST_REACHED;
            let structure = Structure { kernels, ..problem.structure };
            let enforcement = self.enforcement;
            let problem = Problem { is_lenient, enforcement, contact, structure, ..problem };
            work.fit(&problem);
            work.tell_use(&problem);
            if begun || from.is_some() {
                crate::newton::recall_points(self.committed, work);
            } else {
                let before = number.checked_sub(2).map(|before| &model.steps[before].presence);
                crate::commit::locate_points(contact, before, self.committed, work.places());
                self.differentiate_beginning(number);
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
            if count == self.reached.len() {
                self.reached.push(Reached::default());
            }
            let reached = &mut self.reached[count];
            reached.displacement.clone_from(&work.u);
            reached.met.clone_from(&work.met);
            count += 1;
            control = Some(outside);
        }
    }

    /// Finds which contact the pattern is to hold: near the committed state and where contact
    /// reached in `count` states, or what it held where the run was `left`.
    fn near(
        &self,
        contact: &Contact,
        (left, count): (Option<&NearContact<'_>>, usize),
        work: &mut Scratch,
    ) {
        let (here, points) = (&self.committed.displacement[..], &self.committed.points[..]);
        match left.filter(|own| contact.may_have(&own.candidates, here.len())) {
            Some(own) => work.recall_near(&own.candidates),
            None => work.find_near(contact, (here, &self.reached[..count], points)),
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
        let step = plan.step;
        loop {
            let mut target = aim(number, &control, &step.procedure);
            // what changes over the step is that of the end of the increment
            let times = (self.committed.step_time, target.step_time);
            let changed = plan.contact.at(times, step.procedure.period);
            let plan = &Problem { contact: changed.as_ref().unwrap_or(plan.contact), ..*plan };
            let mut outcome = self.attempt(plan, &target, work)?;
            if work.outside() {
                work.take_back(outcome);
                return Ok(Some(control));
            }
            if self.stabilise(plan, (&target, &outcome), work)? {
                continue;
            }
            let mut decision = self.decide(plan, (&control, &target), &mut outcome, work);
            let mut diagnosis = None;
            let converged = matches!(outcome.verdict, Verdict::Converged { .. });
            if let (Decision::Stop(reason), false) = (decision, converged) {
                let cause = self.diagnosis(plan, &target, &outcome, reason, work);
                if outcome.verdict.may_be_searched() {
                    self.fail(plan, (&target, &outcome), Some(target.dt))?;
                    target.attempt += 1;
                    outcome = self.last_resorts(plan, (&mut target, &cause), work)?;
                    if work.outside() {
                        work.take_back(outcome);
                        return Ok(Some(control));
                    }
                    let found = self.decide(plan, (&control, &target), &mut outcome, work);
                    decision = begin_again(found, &step.procedure);
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
                    let found = match diagnosis {
                        Some(found) => *found,
                        None => self.diagnosis(plan, &target, &outcome, reason, work),
                    };
                    return Err(self.tell_cause(plan, &outcome, found)?);
                }
            }
            work.take_back(outcome);
        }
    }
}
