//! A converged trial becomes the state that history goes on from.

use crate::account::account;
use crate::constraints::Role;
use crate::contact::{Before, Contact, ContactKinematics, MasterPositions};
use crate::dofs::DofMap;
use crate::moments::into_moments;
use crate::newton::Scratch;
use crate::observe::results::ContactRow;
use crate::problem::Problem;
use crate::rows::contact_rows;
use crate::state::State;
use crate::target::Target;
use crate::users::UserFrictions;
use slideline_mech::turn::Turn;
use slideline_model::{Model, Presence};

/// Writes the state after an increment into `trial` (every field).
pub fn commit(
    plan: &Problem<'_>,
    committed: &State,
    target: &Target,
    work: &Scratch,
    trial: &mut State,
) {
    let evaluation = &work.evaluation;
    trial.total_time = committed.total_time + target.dt;
    trial.step_time = target.step_time;
    trial.displacement.copy_from_slice(&work.u);
    come_to_rest(plan, trial);
    let ways = work.u.iter().zip(&committed.displacement);
    trial.increment.iter_mut().zip(ways).for_each(|(increment, (now, before))| {
        *increment = now - before;
    });
    trial.increment_before.copy_from_slice(&committed.increment);
    trial.increment_time = (target.dt, committed.increment_time.0);
    trial.load.copy_from_slice(&work.load);
    trial.load.iter_mut().zip(&evaluation.pressed).for_each(|(load, own)| *load += own);
    let roles = plan.constraints.roles.iter().enumerate();
    trial.reaction.iter_mut().zip(roles).for_each(|(reaction, (dof, role))| {
        *reaction = match role {
            Role::Prescribed(_) => evaluation.unbalanced(dof),
            _ => 0.0,
        };
    });
    trial.temperatures.clone_from(&work.temperatures);
    begin_turns(plan, committed, trial);
    trial.points.copy_from_slice(&evaluation.points);
    trial.stabilised = committed.stabilised;
    trial.by_secants = work.followed_secants();
    trial.damping.clear();
    if crate::stabilise::settings(plan, committed).is_some() {
        trial.damping.extend_from_slice(&evaluation.damping);
    }
    trial.state_variables.copy_from_slice(&evaluation.state_variables);
    trial.elements.copy_from_slice(&committed.elements);
    plan.structure.gather_state(&evaluation.contributions, &mut trial.elements);
    count_slip(plan, committed, work, trial);
    plan.contact.note_alone(trial);
    let controls = &plan.step.controls.field;
    trial.flux = committed.flux;
    trial.flux[0].commit(evaluation.flux.mean_force(), controls);
    trial.flux[1].commit(evaluation.flux.mean_moment(), controls);
    account(plan, committed, work, trial);
    // reactions of rotations that count from a new start are what works on these
    let axes = plan.constraints.motion.axes();
    let ended = (&trial.displacement[..], &committed.turns[..]);
    into_moments((plan.dofs, axes), ended, Some(&trial.turns), &mut trial.reaction);
}

/// What is free and returns to rest is at rest once its displacement is far
/// below the rounding of any position: it must not decay on through the
/// smallest numbers that there are.
fn come_to_rest(plan: &Problem<'_>, trial: &mut State) {
    let nothing = f64::EPSILON.powi(4);
    for &dof in &plan.constraints.dof_of_equation {
        let size = if plan.dofs.is_rotation(dof) { 1.0 } else { plan.reach };
        if trial.displacement[dof].abs() < nothing * size {
            trial.displacement[dof] = 0.0;
        }
    }
}

/// What rotations in space count from: anew where they have come far, docs/theory.md eq. (3.70).
fn begin_turns(plan: &Problem<'_>, committed: &State, trial: &mut State) {
    trial.turns.clone_from(&committed.turns);
    if !plan.step.nlgeom {
        return;
    }
    for (node, dofs) in plan.dofs.rotations_in_space() {
        let before = trial.turns.get(node).copied().unwrap_or_default();
        let now = before.committed(dofs.map(|dof| trial.displacement[dof]));
        if now != before && plan.constraints.may_turn_anew(node, plan.dofs) {
            trial.turns.resize(plan.model.nodes.len(), Turn::REST);
            trial.turns[node] = now;
        }
    }
}

/// Slip of closed points without friction, which no law has asked for.
fn count_slip(plan: &Problem<'_>, committed: &State, work: &Scratch, trial: &mut State) {
    for (place, point) in plan.contact.points.iter().enumerate() {
        let (now, before) = (&mut trial.points[place], &committed.points[place]);
        if now.closed && !plan.contact.laws[point.pair].has_friction() {
            let kinematics = &work.evaluation.kinematics.points()[place];
            let history = before.history();
            now.slip = before.slip
                + plan.contact.slip(place, &history, kinematics, &committed.displacement);
        }
    }
}

/// Fills in where the contact points of a committed state stand, without
/// touching their history: the gaps of the start, and the origin of slip for
/// points that close in the first increment. `before` is what the step before had of the model,
/// `positions` is scratch.
pub fn locate_points(
    contact: &Contact,
    before: Option<&Presence>,
    committed: &mut State,
    (positions, kinematics): (&mut MasterPositions, &mut ContactKinematics),
) {
    contact.locate((&committed.displacement, Before::of(committed)), &[], positions, kinematics);
    contact.stay_behind(before, (&committed.points, &committed.displacement), kinematics);
    for (point, kinematics) in committed.points.iter_mut().zip(kinematics.points()) {
        (point.opening, point.allowed) = (-kinematics.overclosure, kinematics.allowed);
        point.along = kinematics.faces.then_some(kinematics.along);
        point.position = kinematics.position;
        point.normal = kinematics.normal;
        point.area = kinematics.area;
        point.xi = kinematics.xi;
        (point.footing, point.segment) = (kinematics.footing, kinematics.segment());
    }
    if before.is_none() {
        contact.bond(&mut committed.points);
    }
}

/// The contact points of an undeformed model, a row a slave node of every pair:
/// gaps, facing places and areas.
pub fn initial_contact(model: &Model) -> Vec<ContactRow> {
    let mut rows = Vec::new();
    if model.steps.is_empty() {
        return rows;
    }
    let dofs = DofMap::new(model);
    let contact = Contact::new(model, &dofs, &UserFrictions::default());
    let points = contact.points.len();
    let mut state = State::undeformed(dofs.len(), points, (contact.state_size, 0));
    let mut kinematics = contact.nowhere();
    let places = (&mut MasterPositions::default(), &mut kinematics);
    locate_points(&contact, None, &mut state, places);
    contact_rows((model, &dofs), &contact, (&state, None), (&mut rows, &mut Vec::new()));
    rows
}
