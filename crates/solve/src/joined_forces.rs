//! What the elements and contact carry at nodes that equations join to others.
//!
//! ```text
//!   support o-----o a ==equation== b o-----o    the support reacts to all of it;
//!                 f_a               f_b         at a and b stands what their own elements carry
//! ```
//! So CalculiX counts forces at nodes (docs/keywords/NODE-PRINT.md).

use crate::newton::Scratch;
use crate::problem::Problem;
use crate::state::State;
use slideline_mech::contact::tangential::Tangential;

/// Reaction and load of every dof of a state that was just committed, but at dofs that equations and
/// rigid bodies join to others the force of their own elements and contact, where no element has them
/// the reaction alone, and at the nodes of bodies the loads of all that follows too [F or F L]; nothing
/// where the dialect does not ask for it or nothing is joined.
pub fn joined_forces(plan: &Problem<'_>, state: &State, work: &Scratch, into: &mut Vec<f64>) {
    into.clear();
    let joined = &plan.constraints.joined;
    if joined.is_empty() {
        return;
    }
    let mut own = vec![0.0; state.load.len()];
    let evaluation = &work.evaluation;
    plan.structure.gather_force(&evaluation.contributions, &mut own);
    for (place, point) in evaluation.points.iter().enumerate().filter(|(_, own)| own.closed) {
        let traction: Tangential = point.area * point.traction;
        evaluation.kinematics.at(place).push(point.area * point.pressure, traction, &mut own);
    }
    into.extend(state.reaction.iter().zip(&state.load).map(|(reaction, load)| reaction + load));
    let mut has_element = vec![false; own.len()];
    plan.structure.numbering.own.iter().for_each(|&dof| has_element[dof] = true);
    for &dof in joined {
        let (node, _) = plan.dofs.name(dof);
        if plan.dofs.place_of_turned(node).is_none() {
            into[dof] = if has_element[dof] { own[dof] } else { state.reaction[dof] };
        } else if plan.dofs.of_node(node).any(|dof| has_element[dof]) {
            plan.dofs.named_of_node(node).for_each(|dof| into[dof] = 0.0);
            plan.dofs.of_node(node).for_each(|dof| into[dof] = own[dof]);
        } else {
            let all = plan.dofs.named_of_node(node).chain(plan.dofs.of_node(node));
            all.for_each(|dof| into[dof] = state.reaction[dof]);
        }
    }
    let mut carried = state.load.clone();
    plan.constraints.carry(&evaluation.rows, &mut carried);
    for &dof in &plan.constraints.of_bodies {
        // loads stand along the axes of their node
        let (node, own) = plan.dofs.name(dof);
        let named = plan.dofs.named(node, own).unwrap_or(dof);
        into[named] += carried[named] - state.load[named];
    }
}
