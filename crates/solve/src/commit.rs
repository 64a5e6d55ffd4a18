//! A converged trial becomes the state that history goes on from.

use crate::layout::Role;
use crate::newton::{Target, Workspace};
use crate::observe::Energies;
use crate::plan::Plan;
use crate::state::State;

/// Writes the state after an increment into `trial` (every field).
pub fn commit(
    plan: &Plan<'_>,
    committed: &State,
    target: &Target,
    work: &Workspace,
    trial: &mut State,
) {
    let evaluation = &work.evaluation;
    trial.total_time = committed.total_time + target.dt;
    trial.step_time = target.step_time;
    trial.displacement.copy_from_slice(&work.u);
    for (slot, increment) in trial.increment.iter_mut().enumerate() {
        *increment = work.u[slot] - committed.displacement[slot];
    }
    trial.increment_before.copy_from_slice(&committed.increment);
    trial.increment_time = [target.dt, committed.increment_time[0]];
    trial.load.copy_from_slice(&work.load);
    for (slot, role) in plan.layout.roles.iter().enumerate() {
        trial.reaction[slot] = match role {
            Role::Prescribed(_) => evaluation.unbalanced(slot),
            _ => 0.0,
        };
    }
    trial.points.copy_from_slice(&evaluation.points);
    trial.stabilised = committed.stabilised;
    trial.damping.clear();
    if crate::stabilise::settings(plan, committed).is_some() {
        trial.damping.extend_from_slice(&evaluation.damping);
    }
    trial.memory.copy_from_slice(&evaluation.memory);
    count_slip(plan, committed, work, trial);
    let controls = &plan.step.controls.field;
    trial.flux = committed.flux;
    trial.flux[0].commit(evaluation.flux.mean_force(), controls);
    trial.flux[1].commit(evaluation.flux.mean_moment(), controls);
    account(plan, committed, work, trial);
}

/// Slip of closed points without friction, which no law has asked for.
fn count_slip(plan: &Plan<'_>, committed: &State, work: &Workspace, trial: &mut State) {
    for (place, point) in plan.contact.points.iter().enumerate() {
        let (now, before) = (&mut trial.points[place], &committed.points[place]);
        if now.closed && !plan.contact.laws[point.pair].has_friction() {
            let meeting = &work.evaluation.meetings[place];
            let history = before.history();
            now.slip =
                before.slip + plan.contact.slip(place, &history, meeting, &committed.displacement);
        }
    }
}

/// Energies after the increment: work by the trapezoidal rule, dissipation
/// as the mean of the traction magnitudes at both ends times the slip.
fn account(plan: &Plan<'_>, committed: &State, work: &Workspace, trial: &mut State) {
    let before = &committed.energy;
    let mut energy = Energies {
        external_work: before.external_work,
        strain_energy: work.evaluation.strain_energy,
        contact_energy: work.evaluation.contact_energy,
        friction_dissipation: before.friction_dissipation,
        friction_elastic: work.evaluation.elastic_slip_energy,
        dropped_friction: before.dropped_friction,
        stabilisation: before.stabilisation + damped(committed, trial),
        balance: 0.0,
    };
    for slot in 0..plan.layout.slots() {
        let mean_reaction = 0.5 * (committed.reaction[slot] + trial.reaction[slot]);
        let mean_load = 0.5 * (committed.load[slot] + trial.load[slot]);
        energy.external_work += (mean_reaction + mean_load) * trial.increment[slot];
    }
    for place in 0..plan.contact.points.len() {
        let (old, new) = (&committed.points[place], &trial.points[place]);
        let mean = 0.5 * (old.traction.abs() + new.traction.abs());
        energy.friction_dissipation += mean * new.dissipated * new.area;
        energy.dropped_friction += new.dropped_work;
    }
    let stored = energy.strain_energy
        + energy.contact_energy
        + energy.friction_elastic
        + energy.friction_dissipation
        + energy.stabilisation;
    let unbalanced = energy.external_work - stored;
    let origin = *trial.balance_origin.insert(committed.balance_origin.unwrap_or(unbalanced));
    energy.balance = unbalanced - origin;
    trial.energy = energy;
}

/// Energy that the dashpots of stabilisation took, by the trapezoidal rule as
/// the external work.
fn damped(committed: &State, trial: &State) -> f64 {
    let at = |state: &State, slot: usize| state.damping.get(slot).copied().unwrap_or(0.0);
    let slots = 0..committed.damping.len().max(trial.damping.len());
    let mean = |slot| 0.5 * (at(committed, slot) + at(trial, slot));
    slots.map(|slot| mean(slot) * trial.increment[slot]).sum()
}

/// Fills in where the contact points of a committed state stand, without
/// touching their history: the gaps of the start, and the origin of slip for
/// points that close in the first increment.
pub fn locate_points(plan: &Plan<'_>, committed: &mut State, work: &mut Workspace) {
    let mut positions = Vec::with_capacity(plan.contact.chain_nodes());
    plan.contact.meet(&committed.displacement, &mut positions, &mut work.evaluation.meetings);
    for (point, meeting) in committed.points.iter_mut().zip(&work.evaluation.meetings) {
        point.opening = -meeting.overclosure;
        point.along = meeting.faces.then_some(meeting.along);
        point.position = meeting.position;
        point.normal = meeting.normal;
        point.area = meeting.area;
        point.xi = meeting.xi;
    }
}

/// The places of a committed state as the evaluation that led to it left
/// them, so that points without a master keep what was last said of them.
pub fn recall_points(committed: &State, work: &mut Workspace) {
    for (point, meeting) in committed.points.iter().zip(&mut work.evaluation.meetings) {
        meeting.position = point.position;
        meeting.normal = point.normal;
        meeting.area = point.area;
        meeting.xi = point.xi;
    }
}
