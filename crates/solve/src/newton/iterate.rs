//! One iteration: assemble, factor, solve, move, evaluate.

use super::multipliers::context;
use super::scratch::{Scratch, solver};
use crate::evaluate::Evaluation;
use crate::linearised::Stiffness;
use crate::problem::Problem;
use crate::state::State;
use slideline_linalg::SolveError;
use slideline_mech::contact::enforcement::Enforcement;

/// The most points whose contact is solved with its matrix where the other way is
/// lost: the cost grows with their cube.
const MOST_DENSE: usize = 1000;
/// Sizes of the model by which a correction may move a node [1]. One that moves it further answers
/// nothing: it goes along a motion that nothing holds, where rounding has left a pivot, or where contact
/// that was thought to hold turned out to be open.
const FAR: f64 = 1e2;
/// Rounds in which an iteration takes in points that it had left alone, before it takes in all.
const WAKINGS: usize = 3;

/// So many times the stiffness that holds loose bodies, one after the other, where the contact problem is not solved with it [1].
/// (choice)
const FIRMER: &[f64] = &[1e3, 1e6];

impl Scratch {
    /// The correction that the factored tangent and contact, solved exactly,
    /// answer the residual with.
    pub(super) fn contact_step(
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
        contact.solve(points, &context, (*enforcement, &mut stiffness), correction)?;
        self.count_negative_pivots();
        Ok(())
    }

    /// Factors the linearised problem and solves it, if the pattern holds what contact couples.
    pub(super) fn factor_and_solve(
        &mut self,
        plan: &Problem<'_>,
        committed: &State,
        dt: f64,
    ) -> Result<(), SolveError> {
        self.factor(plan, committed)?;
        match self.outside() {
            true => Ok(()),
            false => self.contact_step(plan, committed, dt),
        }
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
        self.hold = self.least_hold;
        let mut done = self.factor_and_solve(plan, committed, dt);
        if done.is_ok() && !self.outside() && !plan.inserts_laws() && self.opens_pairs() {
            done = self.factor_and_solve(plan, committed, dt);
        }
        self.opened.fill(false);
        let free = self.enforcement == Enforcement::MatrixFree && plan.enforcement.is_none();
        let lost = done.is_err() || !self.contact.is_solved();
        if !self.outside() && free && lost && self.points.len() <= MOST_DENSE {
            self.only_dense = true;
            done = self.factor_and_solve(plan, committed, dt);
        }
        done?;
        self.hold_loose_firmer(plan, committed, dt)
    }

    /// Solves once more with loose bodies held firmer where the contact problem was not solved: the stiffness that is lent to
    /// their points is next to all that they feel.
    fn hold_loose_firmer(
        &mut self,
        plan: &Problem<'_>,
        committed: &State,
        dt: f64,
    ) -> Result<(), SolveError> {
        for times in FIRMER {
            if self.outside() || self.contact.is_solved() || !self.holds_loose(plan) {
                break;
            }
            self.hold = times * self.least_hold;
            self.factor_and_solve(plan, committed, dt)?;
        }
        Ok(())
    }

    /// Whether the solution opens pairs that pressed; they are noted. Their geometry, taken at
    /// pressures that are no more, goes with them: it can be what opened them, docs/theory.md eq. (8.36).
    fn opens_pairs(&mut self) -> bool {
        let Self { points, pressures, opened, .. } = self;
        for point in points.iter() {
            opened[point.pair] |= pressures[point.place] != 0.0;
        }
        for point in points.iter() {
            opened[point.pair] &= point.pressure == 0.0;
        }
        opened.contains(&true)
    }

    /// One Newton iteration: assemble, factor, solve, move, evaluate.
    pub(super) fn iterate(
        &mut self,
        plan: &Problem<'_>,
        committed: &State,
        dt: f64,
    ) -> Result<(), SolveError> {
        self.stand();
        self.solve_awake(plan, committed, dt)?;
        if let Some(fault) = self.falls(plan, committed) {
            // what hangs on a support is led nowhere by points far from it
            if self.is_thrown_round(plan) {
                return Err(fault);
            }
            self.augment(plan, committed, fault)?;
            self.solve_awake(plan, committed, dt)?;
        }
        if self.evaluation.failed.is_some() {
            return Ok(());
        }
        self.stay_near(plan)?;
        if self.outside() {
            return Ok(());
        }
        let length = self.limit_turns(plan);
        if self.line_search {
            self.search(plan, committed, (dt, length));
        } else {
            match length == 1.0 {
                true => self.follow_secants(plan),
                false => self.secants.forget(),
            }
            self.advance(plan, length);
            match self.nearly_there {
                true => self.evaluate_without_tangent(plan, committed, dt),
                false => self.evaluate(plan, committed, dt),
            }
        }
        Ok(())
    }

    /// The linear step, with all that it may close: what was left alone may touch within it, and hold what it throws.
    fn solve_awake(
        &mut self,
        plan: &Problem<'_>,
        committed: &State,
        dt: f64,
    ) -> Result<(), SolveError> {
        for round in 0.. {
            self.linear_step(plan, committed, dt)?;
            let has_failed = self.evaluation.failed.is_some(); // the tangent, which was left until now
            if has_failed || self.outside() || !self.wakes_idle(plan) {
                break;
            }
            // a step of inserted laws is a direction that is searched, along which all are asked
            if round == WAKINGS || plan.inserts_laws() {
                self.evaluation.look.forget();
            }
            self.evaluate(plan, committed, dt);
        }
        Ok(())
    }

    /// Takes a system of parts in contact whose correction throws a node far out of the model for
    /// singular; the correction is the motion that nothing holds.
    fn stay_near(&mut self, plan: &Problem<'_>) -> Result<(), SolveError> {
        self.thrown = false;
        if self.outside() || plan.contact.points.is_empty() {
            return Ok(());
        }
        let far = FAR * plan.reach;
        let size = |&equation: &usize| self.correction[equation].abs();
        let moves = |equation: &usize| {
            !plan.dofs.name(plan.constraints.dof_of_equation[*equation]).1.is_rotation()
        };
        // no finite number: the system has no answer at all, which is told elsewhere
        let is_beyond = |equation: &usize| size(equation) > far && size(equation).is_finite();
        let beyond = (0..self.correction.len()).filter(is_beyond).filter(moves);
        let Some(equation) = beyond.max_by(|a, b| size(a).total_cmp(&size(b))) else {
            return Ok(());
        };
        self.thrown = true;
        Err(SolveError::Singular { equation, ratio: plan.reach / size(&equation) })
    }

    /// Replaces a correction by a step along the secants of the last iterations, where these converge slowly and the step
    /// leads nowhere far.
    fn follow_secants(&mut self, plan: &Problem<'_>) {
        // without contact the tangent lacks nothing; downhill every step has a stiffness of its own
        let is_downhill = self.relaxation.stiffness > 0.0;
        if !self.secants.is_wanted || plan.contact.points.is_empty() || is_downhill {
            return;
        }
        let Self { secants, correction, points, pressures, tractions, .. } = self;
        secants.note(correction, points, (&pressures[..], &tractions[..]));
        let of_dof = &plan.constraints.dof_of_equation;
        let moves = |equation: usize| !plan.dofs.name(of_dof[equation]).1.is_rotation();
        if !secants.follow(moves, correction, points) {
            return;
        }
        let moved = correction.iter().enumerate().filter(|own| moves(own.0));
        let is_far = moved.fold(0.0_f64, |most, own| most.max(own.1.abs())) > plan.reach;
        match is_far || self.limit_turns(plan) < 1.0 {
            true => self.secants.take_back(&mut self.correction, &mut self.points),
            false => self.secants.were_followed = true,
        }
    }

    /// Whether steps along secants were taken in the last attempt.
    pub fn followed_secants(&self) -> bool {
        self.secants.were_followed
    }

    /// Lets the faces on which points stand hold them in this iteration.
    fn stand(&mut self) {
        let points = self.evaluation.kinematics.points();
        for (standing, point) in self.standing.iter_mut().zip(points) {
            *standing = point.stands_on();
        }
    }

    /// Whether the whole correction may close points that are left alone; these wake.
    fn wakes_idle(&mut self, plan: &Problem<'_>) -> bool {
        if !self.evaluation.look.idle.contains(&true) {
            return false;
        }
        self.residual.copy_from_slice(&self.u);
        for (equation, &dof) in plan.constraints.dof_of_equation.iter().enumerate() {
            self.residual[dof] += self.correction[equation];
        }
        plan.constraints.enforce(&self.turns, &mut self.residual);
        let Evaluation { kinematics, look, .. } = &mut self.evaluation;
        plan.contact.wake(kinematics, &self.residual, look)
    }
}
