//! The first guess of an increment.

use crate::problem::Problem;
use crate::restraint::loose::Stand;
use crate::stabilise;
use crate::state::{PointState, State};
use slideline_model::Extrapolation;

/// Adds to `u` what the unknowns did in the last increments, scaled with
/// time: nothing, a line, or a parabola through the last three states.
pub fn extrapolate(plan: &Problem<'_>, committed: &State, dt: f64, u: &mut [f64]) {
    let (last, before) = committed.increment_time;
    if last <= 0.0 || plan.step.extrapolation == Extrapolation::None {
        return;
    }
    let ratio = dt / last;
    let parabolic = plan.step.extrapolation == Extrapolation::Parabolic && before > 0.0;
    for &dof in &plan.constraints.dof_of_equation {
        let rate = committed.increment[dof];
        u[dof] += ratio * rate;
        if parabolic {
            // Newton's form: divided differences of the last two increments.
            let bend = (rate / last - committed.increment_before[dof] / before) / (last + before);
            u[dof] += bend * dt * (dt + last);
        }
    }
    let_go(plan, (committed, None), u);
}

/// Leaves bodies that contact alone would hold where they are: they had been pushed, and would fly on. At first those that it did
/// not touch; of a first guess, with its points, those that this takes out of contact. Whether there are such.
pub fn let_go(
    plan: &Problem<'_>,
    (committed, guess): (&State, Option<&[PointState]>),
    u: &mut [f64],
) -> bool {
    if plan.loose.is_empty() || stabilise::settings(plan, committed).is_some() {
        return false;
    }
    let (from, before) = (&committed.displacement[..], &committed.points[..]);
    let are_held = |now| plan.loose.are_held(plan.contact, (before, now), (from, u));
    let mut leaves = are_held(before);
    match guess.map(are_held) {
        None => leaves.iter_mut().for_each(|own| *own = !*own),
        Some(held) => leaves.iter_mut().zip(held).for_each(|(own, held)| *own &= !held),
    }
    let stand = Stand { model: plan.model, dofs: plan.dofs, u: from };
    let mut some = false;
    for (body, _) in plan.loose.iter().zip(leaves).filter(|own| own.1) {
        some |= body.stay(stand, u);
    }
    some
}
