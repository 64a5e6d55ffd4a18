//! Relaxation: from where no equilibrium is near, downhill to the next one.
//!
//! ```text
//!   force |   .-.                 the path ends at a limit point: the part springs
//!         |  /   \      /         to another state, however short the increment
//!         | /     '-.__/
//!         |/   x - - - >o         pseudo-time steps of r(u) + mu D (u - u_k) = 0,
//!         +---------------> u     mu as large as keeps a step short, then to nothing
//! ```
//!
//! An implicit Euler step of the gradient flow D du/ds = -r(u), with pseudo-time
//! steps 1/mu. D is the stiffness of the stiffest element at every unknown, in
//! its natural unit, so that the way does not depend on how forces and lengths
//! are measured. What is judged is the residual without D: the state that is
//! found is an equilibrium of the model as it is. docs/theory.md eq. (9.4). [kelley1998]

use super::outcome::{Outcome, Progress};
use super::scratch::Scratch;
use crate::contact::Sweep;
use crate::increments::Verdict;
use crate::observe::reports::IterationReport;
use crate::problem::Problem;
use crate::state::State;
use crate::target::Target;

/// Stiffness of relaxation at first, in those of the stiffest element [1].
const FIRST: f64 = 1e-3;
/// Greater than this it holds everything where it is [1].
const GREATEST: f64 = 1e3;
/// Largest turn of a step [1], and largest way in lengths of the stiffest
/// element.
const LONGEST: f64 = 0.5;
/// Part of the longest step that the next one aims at [1].
const AIMED: f64 = 0.7;
/// Largest factor between the stiffnesses of two steps.
const CHANGE: f64 = 8.0;
/// The most steps.
const STEPS: usize = 600;
/// Steps of a round, and the part of their longest way that the state must get away in it [1]: downhill
/// there is no way back, and a state that goes to and fro or stands still gets nowhere.
const ROUND: usize = 40;
const PROGRESS: f64 = 0.1;
/// Factor by which the way of a round exceeds that of the one before where the state departs [1].
const GROWTH: f64 = 2.0;
/// Newton iterations of a step, and the part of its way that the last correction may be [1].
const ITERATIONS: usize = 4;
const SOLVED: f64 = 0.1;

/// Walks one increment downhill. `watch` sees every iteration; on success the
/// workspace holds the converged trial.
pub fn relax(
    plan: &Problem<'_>,
    committed: &State,
    target: &Target,
    work: &mut Scratch,
    watch: &mut dyn FnMut(&IterationReport),
) -> Outcome {
    work.begin(plan, committed, target);
    let mut progress = Progress::default();
    work.relaxation.set_out(FIRST);
    let verdict = work.relax(plan, committed, (target, &mut progress), watch);
    work.relaxation.stiffness = 0.0;
    Outcome { leapt: true, ..progress.end(verdict, None) }
}

impl Scratch {
    fn relax(
        &mut self,
        plan: &Problem<'_>,
        committed: &State,
        (target, progress): (&Target, &mut Progress),
        watch: &mut dyn FnMut(&IterationReport),
    ) -> Verdict {
        self.relaxation.round.clone_from(&self.u);
        for step in 0..STEPS {
            self.note_anchor();
            if step > 0 && step.is_multiple_of(ROUND) && self.gets_nowhere(plan) {
                return Verdict::TooSlow;
            }
            let before = self.evaluation.points.clone();
            let mut solved = false;
            for _ in 0..ITERATIONS {
                let iterated = self.iterate(plan, committed, target.dt);
                if self.outside() {
                    // nothing moves until the pattern has been made anew
                    return Verdict::Broken;
                }
                if iterated.is_err() || self.evaluation.failed.is_some() {
                    solved = false;
                    break;
                }
                solved = self.correction_of_step(plan) <= SOLVED * self.way_of_step(plan);
                if !self.complete(plan, committed) {
                    self.evaluate(plan, committed, target.dt);
                }
                let report = self.judge(plan, committed, target, progress);
                watch(&report);
                let settled = report.converged && self.way_of_step(plan) <= LONGEST;
                let small = report.force.correction <= report.force.increment * SETTLED;
                progress.last = Some(report);
                if settled {
                    return Verdict::Converged { iterations: progress.equilibrium };
                }
                let moved = self.move_multipliers(plan, progress.allowed_force());
                if small && !moved {
                    solved = true;
                    break;
                }
            }
            let sweep = Sweep {
                turns: &self.turns,
                constraints: plan.constraints,
                rotations: plan.dofs.rotations(),
                from: &self.relaxation.anchor,
                to: &self.u,
                before: &before,
                now: &self.evaluation.points,
            };
            let through = plan.contact.passed_through(&sweep, &mut self.sweep).is_some();
            self.follow_way(plan, committed, (target.dt, solved, through));
            if self.relaxation.stiffness > GREATEST {
                return Verdict::TooSlow;
            }
        }
        Verdict::TooSlow
    }

    /// Whether the round of steps that ends with this one has gone nowhere; the next one begins. Where
    /// a path has just ended next to nothing drives at first, and straight ways grow from round to round.
    fn gets_nowhere(&mut self, plan: &Problem<'_>) -> bool {
        let least = PROGRESS * ROUND as f64 * AIMED * LONGEST;
        let away = self.way(plan, &self.relaxation.round);
        let before = std::mem::replace(&mut self.relaxation.away, away);
        let walked = std::mem::take(&mut self.relaxation.walked);
        let departs = away > PROGRESS * walked && away > GROWTH * before;
        self.relaxation.round.clone_from(&self.u);
        away < least && !departs
    }

    /// Chooses the stiffness of the next step by the way of this one; takes it back where it was not
    /// `solved`, went too far, or went `through` something.
    fn follow_way(
        &mut self,
        plan: &Problem<'_>,
        committed: &State,
        (dt, solved, through): (f64, bool, bool),
    ) {
        let way = self.way_of_step(plan);
        let faulty = self.evaluation.fault.is_some() || self.evaluation.failed.is_some();
        let lost = faulty || !self.contact.is_solved();
        // the way is short in proportion to the stiffness
        let aimed = way / (AIMED * LONGEST);
        let by = if way.is_nan() || lost || through {
            CHANGE * CHANGE
        } else if way > LONGEST {
            aimed.min(CHANGE * CHANGE)
        } else if !solved {
            CHANGE
        } else {
            self.relaxation.walk(way, aimed.clamp(1.0 / CHANGE, CHANGE));
            return;
        };
        self.return_to_anchor(plan, committed, dt);
        // what contact finds no answer to is not the stiffness
        let was_weak = !solved && !lost && !through;
        self.relaxation.take_back(by, was_weak);
    }

    fn note_anchor(&mut self) {
        self.relaxation.estimates = self.estimates();
        self.relaxation.anchor.clone_from(&self.u);
    }

    fn return_to_anchor(&mut self, plan: &Problem<'_>, committed: &State, dt: f64) {
        let relaxation = std::mem::take(&mut self.relaxation);
        self.go_back(&relaxation.anchor, &relaxation.estimates);
        self.relaxation = relaxation;
        self.evaluate(plan, committed, dt);
    }

    /// Largest way since the beginning of the step, as [`Self::way`].
    fn way_of_step(&self, plan: &Problem<'_>) -> f64 {
        self.way(plan, &self.relaxation.anchor)
    }

    /// Largest correction of the last iteration, as [`Self::way`].
    fn correction_of_step(&self, plan: &Problem<'_>) -> f64 {
        longest(plan, self.correction.iter().copied())
    }

    /// Largest way since a state in lengths of the stiffest element, or turn [1].
    fn way(&self, plan: &Problem<'_>, from: &[f64]) -> f64 {
        let dofs = plan.constraints.dof_of_equation.iter();
        longest(plan, dofs.map(|&dof| self.u[dof] - from[dof]))
    }
}

/// The largest of changes, one an equation, in lengths of the stiffest element, or as a turn [1]; not a
/// number where one is none.
fn longest(plan: &Problem<'_>, changes: impl Iterator<Item = f64>) -> f64 {
    let sizes = changes
        .zip(plan.units)
        .map(|(change, &unit)| change.abs() * if unit == 1.0 { 1.0 / plan.lever } else { 1.0 });
    sizes.fold(0.0, |largest, size| if size <= largest { largest } else { size })
}

/// A correction below this part of the increment ends the iterations of a step [1].
const SETTLED: f64 = 1e-6;
