//! What a diagnosis asks of an attempt that has failed.

use super::multipliers::context;
use super::scratch::Scratch;
use crate::iteration_history::IterationHistory;
use crate::linearised::Contradiction;
use crate::problem::Problem;
use crate::state::State;
use crate::target::Target;
use slideline_mech::contact::tangential::Tangential;
use slideline_model::NodeIndex;

/// Rounds of inverse iteration for the null motion: each gains the ratio of
/// the shift to the next eigenvalue, many decades.
const ROUNDS: usize = 3;
/// Shift of the diagonal that makes a singular matrix regular [1].
const SHIFT: f64 = 1e-9;

/// A point that friction locks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jammed {
    /// Place of the point.
    pub place: usize,
    /// The coefficient of friction from which on it is locked [1].
    pub from: f64,
}

impl Scratch {
    /// Points, closed at the last commit, whose friction locks them: by the
    /// equations of the last iteration and the way they went until then.
    pub fn jammed(&self, plan: &Problem<'_>, committed: &State) -> Vec<Jammed> {
        let around = context(plan, committed, 1.0);
        let locked = |own: usize| {
            // the points of an iteration are some of those of the model
            let point = &self.points[own];
            let before = committed.points.get(point.place)?;
            let trial = point.sliding.map_or(Tangential::ZERO, |sliding| sliding.slip);
            let way = if trial.size() > around.rounding { trial } else { before.traction };
            let from =
                self.contact.jams_from(&self.points, own, (way, before.pressure), &around)?;
            Some(Jammed { place: point.place, from })
        };
        (0..self.points.len()).filter_map(locked).collect()
    }

    /// The same by the equations with which the attempt began: a trial that
    /// friction has thrown off its master shows no more of it. The trial is
    /// left as it is.
    pub fn jammed_at_first(
        &mut self,
        plan: &Problem<'_>,
        committed: &State,
        target: &Target,
    ) -> Vec<Jammed> {
        let room = IterationHistory::new(plan.contact.points.len());
        let iteration_history = std::mem::replace(&mut self.iteration_history, room);
        let (u, load, negative_pivots) = (self.u.clone(), self.load.clone(), self.negative_pivots);
        let (pressures, tractions) = (self.pressures.clone(), self.tractions.clone());
        let (evaluation, points) = (self.evaluation.clone(), self.points.clone());
        self.begin(plan, committed, target);
        let solved = self.factor_and_solve(plan, committed, target.dt).is_ok();
        let found = if solved { self.jammed(plan, committed) } else { Vec::new() };
        (self.u, self.load, self.negative_pivots) = (u, load, negative_pivots);
        (self.pressures, self.tractions) = (pressures, tractions);
        (self.evaluation, self.points) = (evaluation, points);
        self.iteration_history = iteration_history;
        found
    }

    /// Hard points whose place is prescribed, as that of their master is, and
    /// that stand too deep in it.
    pub fn told_apart(&self, plan: &Problem<'_>, committed: &State) -> Option<Contradiction> {
        let tolerance = self.contact_tolerance(plan, 0.0);
        let (mut places, mut left) = (Vec::new(), 0.0_f64);
        for (place, point) in plan.contact.points.iter().enumerate() {
            let kinematics = &self.evaluation.kinematics.at(place);
            let law = &plan.contact.laws[point.pair].normal;
            let yields = plan.contact_yields(kinematics, &self.evaluation.rows);
            let deep = kinematics.faces
                && kinematics.overclosure > tolerance
                && !self.stands_held(plan, committed, place);
            if deep && !yields && !point.is_integration_point() && law.pressure(0.0).is_none() {
                places.push(place);
                left = left.max(kinematics.overclosure);
            }
        }
        (!places.is_empty()).then_some(Contradiction { places, left })
    }

    /// Whether a point and its master are held where they are.
    pub fn stands_held(&self, plan: &Problem<'_>, committed: &State, place: usize) -> bool {
        let evaluation = &self.evaluation;
        let at = (&evaluation.kinematics.at(place), &evaluation.rows);
        plan.stands_held(place, at, (&self.u, &committed.displacement))
    }

    /// Hard points that contradict one another in the last iteration.
    pub fn contradiction(
        &self,
        plan: &Problem<'_>,
        committed: &State,
        dt: f64,
    ) -> Option<Contradiction> {
        let tolerance = self.contact_tolerance(plan, 0.0);
        if self.evaluation.penetration <= tolerance {
            return None;
        }
        self.contact.contradiction(&self.points, &context(plan, committed, dt), tolerance)
    }

    /// What moves without resistance under the tangent that was assembled
    /// last: its null vector, by inverse iteration from an equation without
    /// pivot; the last correction, if that went along one.
    pub fn null_mode(&self, plan: &Problem<'_>, equation: usize) -> Option<Vec<f64>> {
        if self.thrown {
            let size = self.correction.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
            return Some(self.correction.iter().map(|value| value / size).collect());
        }
        let kept = [&self.augmented, &self.values, &self.evaluation.tangent];
        let mut values = kept.into_iter().find(|values| !values.is_empty())?.clone();
        let unit = |e: usize| plan.units[e];
        let diagonal = || {
            let own = |e| plan.pattern.position(e, e).map(|at| (e, at));
            (0..plan.constraints.equations()).filter_map(own)
        };
        // in the units of the equations, the same for forces and moments
        let own = |(e, at): (usize, usize)| (values[at] * unit(e) * unit(e)).abs();
        let largest = diagonal().map(own).fold(0.0_f64, f64::max);
        let shift = SHIFT * if largest > 0.0 { largest } else { 1.0 };
        for (e, at) in diagonal() {
            values[at] += shift / (unit(e) * unit(e));
        }
        let mut solver = plan.analyse();
        solver.refactor(plan.pattern, &values).ok()?;
        let mut mode = vec![0.0; plan.constraints.equations()];
        *mode.get_mut(equation)? = 1.0;
        for _ in 0..ROUNDS {
            solver.solve(&mut mode).ok()?;
            let size = mode.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
            mode.iter_mut().for_each(|value| *value /= size);
        }
        mode.iter().all(|value| value.is_finite()).then_some(mode)
    }

    /// The node that a mode moves most, of those with equations.
    pub fn moves_most(&self, plan: &Problem<'_>, mode: &[f64]) -> Option<NodeIndex> {
        let size = |equation: usize| (mode[equation] / plan.units[equation]).abs();
        let largest = (0..mode.len()).max_by(|&a, &b| size(a).total_cmp(&size(b)))?;
        Some(plan.dofs.name(plan.constraints.dof_of_equation[largest]).0)
    }

    /// Forces that nothing balances in the trial state, a dof each; zero
    /// where supports balance them [F or F L].
    pub fn residuals(&self, plan: &Problem<'_>) -> Vec<f64> {
        let force = |dof: usize| match plan.constraints.equation(dof) {
            Some(_) => self.evaluation.unbalanced(dof),
            None => 0.0,
        };
        (0..plan.dofs.len()).map(force).collect()
    }
}
