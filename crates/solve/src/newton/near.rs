//! A trial near the converged one: of another model and another history, evaluated and not solved.

use super::recall::recall_points;
use super::scratch::{Scratch, solver};
use crate::evaluate::{evaluate_forces, follow_laws};
use crate::problem::Problem;
use crate::stabilise;
use crate::state::{PointState, State};
use crate::target::Target;
use slideline_linalg::{Interface, Kind, Pattern, SolveError, Solver, Use};
use slideline_mech::contact::tangential::Tangential;

/// How the unknowns of an increment follow a parameter.
#[derive(Clone, Debug, Default)]
pub struct Rates {
    /// Unknown displacements, an equation each.
    pub unknowns: Vec<f64>,
    /// Pressures that contact holds, a point each.
    pub pressures: Vec<f64>,
    /// Tractions likewise.
    pub tractions: Vec<Tangential>,
}

/// The linear system of a tangent as it is, where the run is solved by its symmetric part.
#[derive(Default)]
pub struct WholeTangent(Option<(Pattern, Solver)>);

impl WholeTangent {
    fn solver(&mut self, plan: &Problem<'_>) -> &mut Solver {
        let known = self.0.take().filter(|(pattern, _)| pattern == plan.pattern);
        let (_, solver) = self.0.insert(known.unwrap_or_else(|| {
            let (of, factory) = ((plan.pattern, Kind::Unsymmetric), plan.means.linear_systems);
            let new = Solver::analyse_for(of, factory.factory(), &Interface::default());
            (plan.pattern.clone(), new)
        }));
        solver.set_units(plan.units);
        solver
    }
}

impl Rates {
    /// What contact holds stays as it is, at so many points.
    pub fn still(&mut self, points: usize) {
        self.pressures.clear();
        self.pressures.resize(points, 0.0);
        self.tractions.clear();
        self.tractions.resize(points, Tangential::ZERO);
    }
}

impl Scratch {
    /// Evaluates a neighbour of the converged trial `of`: its unknowns moved by `h` times their
    /// rates, all else that of the neighbour. Open contact points that `alone` names are not looked
    /// at; empty: all are.
    pub fn evaluate_near(
        &mut self,
        plan: &Problem<'_>,
        committed: &State,
        target: &Target,
        (of, rates, h, alone): (&Self, &Rates, f64, &[bool]),
    ) {
        self.evaluation.look.forget();
        if !alone.is_empty() {
            self.evaluation.look.leave(alone);
        }
        self.u.clone_from(&of.u);
        for (&dof, rate) in plan.constraints.dof_of_equation.iter().zip(&rates.unknowns) {
            self.u[dof] += h * rate;
        }
        self.pressures.clone_from(&of.pressures);
        self.pressures.iter_mut().zip(&rates.pressures).for_each(|(p, rate)| *p += h * rate);
        self.tractions.clone_from(&of.tractions);
        let moved = self.tractions.iter_mut().zip(&rates.tractions);
        moved.for_each(|(traction, &rate)| *traction += h * rate);
        self.standing.clone_from(&of.standing);
        self.evaluate_there(plan, committed, target);
    }

    /// Forgets where faces stood at the last commit: another model is evaluated next.
    pub fn forget_places(&mut self) {
        self.evaluation.kinematics.forget_places();
    }

    /// Stands where the converged trial `of` stands, with all that the time prescribes in a
    /// neighbour; what follows other dofs stays where it is, and nothing is evaluated.
    pub fn stand_near(
        &mut self,
        plan: &Problem<'_>,
        committed: &State,
        target: &Target,
        of: &Self,
    ) {
        self.u.clone_from(&of.u);
        self.pressures.clone_from(&of.pressures);
        self.tractions.clone_from(&of.tractions);
        self.standing.clone_from(&of.standing);
        self.evaluation.points.clone_from(&of.evaluation.points);
        let points = self.evaluation.kinematics.points_mut();
        points.copy_from_slice(of.evaluation.kinematics.points());
        self.dashpots.forget(plan.contact);
        self.dt = target.dt;
        self.load.resize(self.u.len(), 0.0);
        self.set_time(plan, committed, target);
        self.held.hold(std::iter::empty());
    }

    /// Moves what contact holds by `h` times its rates, from where `of` has it.
    pub fn move_estimates(&mut self, of: &Self, (rates, h): (&Rates, f64)) {
        let pressures = of.pressures.iter().zip(&rates.pressures);
        self.pressures.clear();
        self.pressures.extend(pressures.map(|(pressure, rate)| pressure + h * rate));
        let tractions = of.tractions.iter().zip(&rates.tractions);
        self.tractions.clear();
        self.tractions.extend(tractions.map(|(&traction, &rate)| traction + h * rate));
    }

    /// Asks the laws of contact points whose kinematics, and maybe slips, are there already.
    pub fn follow_laws_at(
        &mut self,
        plan: &Problem<'_>,
        committed: &State,
        places: impl Iterator<Item = (usize, Option<Tangential>)>,
    ) {
        let mut evaluation = std::mem::take(&mut self.evaluation);
        let trial = self.trial(committed, self.dt);
        places.for_each(|own| follow_laws(plan, (committed, &trial), own, &mut evaluation));
        self.evaluation = evaluation;
    }

    /// Pressures on faces [F/L2].
    pub fn faces(&self) -> &[f64] {
        &self.faces
    }

    /// Whether contact is stabilised.
    pub fn is_stabilised(&self) -> bool {
        !self.dashpots.is_empty()
    }

    /// Changes evaluations with the scratch of the iterations, where that still stands at the trial
    /// that became `now`, and stands there; false where its room was used since.
    pub fn change_with(&mut self, plan: &Problem<'_>, of: &mut Self, now: &State) -> bool {
        let evaluation = &of.evaluation;
        let stood = |(one, other): (&PointState, &PointState)| {
            (one.closed, one.pressure, one.traction, one.opening, one.along)
                == (other.closed, other.pressure, other.traction, other.opening, other.along)
        };
        let points = evaluation.points.iter().zip(&now.points);
        let is_whole = !evaluation.look.idle.contains(&true) && evaluation.failed.is_none();
        if !is_whole
            || of.is_stabilised()
            || of.u != now.displacement
            || !points.into_iter().all(stood)
        {
            return false;
        }
        self.u.clone_from(&of.u);
        self.load.clone_from(&of.load);
        self.faces.clone_from(&of.faces);
        self.temperatures.clone_from(&of.temperatures);
        self.turns.clone_from(&of.turns);
        (self.clock, self.dt) = (of.clock, of.dt);
        self.dashpots.forget(plan.contact);
        self.held.hold(std::iter::empty());
        self.standing.clone_from(&of.standing);
        self.take_estimates(now);
        std::mem::swap(&mut self.evaluation, &mut of.evaluation);
        true
    }

    /// What contact holds is what it holds in a state.
    fn take_estimates(&mut self, now: &State) {
        self.pressures.clear();
        self.pressures.extend(now.points.iter().map(|point| point.pressure));
        self.tractions.clear();
        self.tractions.extend(now.points.iter().map(|point| point.traction));
    }

    /// Evaluates the state that an increment was committed with, once more: what was done since may
    /// have used the room of the iterations.
    pub fn evaluate_committed(
        &mut self,
        plan: &Problem<'_>,
        committed: &State,
        target: &Target,
        now: &State,
    ) {
        self.u.clone_from(&now.displacement);
        self.take_estimates(now);
        self.evaluation.look.forget();
        self.standing.clear();
        self.standing.extend(now.points.iter().map(PointState::stands_on));
        self.evaluate_there(plan, committed, target);
    }

    /// Evaluates unknowns and estimates that were set, with all that the time prescribes.
    fn evaluate_there(&mut self, plan: &Problem<'_>, committed: &State, target: &Target) {
        self.dashpots.forget(plan.contact);
        recall_points(committed, self);
        self.dt = target.dt;
        (self.line_search, self.augment_all) = (false, false);
        stabilise::fill(plan, committed, (target.step_time, target.dt), &mut self.dashpots);
        self.load.resize(self.u.len(), 0.0);
        self.follow_time(plan, committed, target);
        self.held.hold(std::iter::empty());
        self.evaluate_by(plan, committed, target.dt, evaluate_forces);
    }

    /// Makes room for the evaluations of neighbours in a step.
    pub fn fit_near(&mut self, plan: &Problem<'_>) {
        self.evaluation.fit(plan);
    }

    /// Factors the tangent of the converged trial with these values: all of it.
    ///
    /// Errors: the solver's.
    pub fn factor_converged<'a>(
        &'a mut self,
        plan: &Problem<'_>,
        values: &[f64],
        whole: &'a mut WholeTangent,
    ) -> Result<&'a mut Solver, SolveError> {
        let solver = match plan.is_solved_by_symmetric_part() {
            true => whole.solver(plan),
            false => solver(&mut self.systems),
        };
        solver.set_use(Use::Many);
        solver.refactor(plan.pattern, values)?;
        Ok(solver)
    }
}
