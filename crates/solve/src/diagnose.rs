//! Why an increment could not be found, in physical words.

use crate::increments::{StopReason, Verdict};
use crate::newton::{Outcome, Workspace};
use crate::plan::Plan;
use crate::state::State;
use slideline_diag::{Code, Diagnostic};
use slideline_linalg::SolveError;
use slideline_model::{Dof, Master};

/// An attempt's end in a few words, with those of the linear solver.
pub fn reason(outcome: &Outcome) -> String {
    let words = match outcome.verdict {
        Verdict::Converged { .. } => "converged",
        Verdict::Diverging => "the residual grew in two consecutive iterations",
        Verdict::TooSlow => "convergence is too slow",
        Verdict::Discontinuous => "contact went on changing",
        Verdict::Broken => "the equations could not be solved",
    };
    match &outcome.fault {
        Some(fault) => format!("{words} ({fault})"),
        None => words.to_string(),
    }
}

/// The diagnosis of a run that ends early.
pub fn failure(
    plan: &Plan<'_>,
    committed: &State,
    work: &Workspace,
    outcome: &Outcome,
    stop: StopReason,
) -> Diagnostic {
    if stop == StopReason::TooManyIncrements {
        return too_many_increments(plan, committed);
    }
    if let Some(diagnosis) = unheld(plan, outcome) {
        return diagnosis;
    }
    if let Some(fault) = &work.evaluation.fault {
        return user_fault(plan, committed, &fault.message);
    }
    if let Some(diagnosis) = jam(plan, committed, work) {
        return diagnosis;
    }
    if let Some(diagnosis) = slid_off(plan, committed, &trial_points(committed, work)).pop() {
        return Diagnostic { severity: slideline_diag::Severity::Error, ..diagnosis };
    }
    if stop == StopReason::Fixed {
        return step_too_large(plan, committed, outcome);
    }
    if let Some(diagnosis) = snap_through(plan, committed, work) {
        return diagnosis;
    }
    if let Some(diagnosis) = chattering(plan, committed, outcome) {
        return diagnosis;
    }
    let ended = match stop {
        StopReason::TooManyAttempts => "every shorter increment failed as well",
        StopReason::TooSmall => "the next increment would be shorter than the smallest allowed",
        StopReason::Fixed => "*STATIC, DIRECT forbids a shorter increment",
        StopReason::TooManyIncrements => "the number of increments is used up",
    };
    let place = outcome.last.as_ref().and_then(|report| {
        let (node, dof) = report.force.residual_at?;
        Some(format!(
            "; the largest residual force, {:.3e}, stands at node {}, {}",
            report.force.residual,
            plan.model.nodes.label(node),
            dof.name()
        ))
    });
    let message = format!(
        "no equilibrium was found beyond total time {:.6}: {}, and {}{}",
        committed.total_time,
        reason(outcome),
        ended,
        place.unwrap_or_default()
    );
    Diagnostic::error(Code("SL0501"), message).at(plan.step.origin).help(
        "everything up to that time is kept; let *STATIC start with a shorter increment and allow \
         smaller ones, or soften the contact with *SURFACE CONTACT, SOFTENED",
    )
}

/// The most nodes that a message names.
const NAMED: usize = 4;

/// Points at which more pressure brings more friction than it opens.
fn jam(plan: &Plan<'_>, committed: &State, work: &Workspace) -> Option<Diagnostic> {
    let jammed = work.jammed(plan, committed);
    let first = &plan.contact.points[*jammed.first()?];
    let labels: Vec<String> = jammed
        .iter()
        .take(NAMED)
        .map(|&place| plan.model.nodes.label(plan.contact.points[place].node).to_string())
        .collect();
    let more = if jammed.len() > NAMED { " and others" } else { "" };
    let nodes = if labels.len() > 1 { "nodes" } else { "node" };
    let message = format!(
        "the contact jams at {nodes} {}{more} beyond total time {:.6}: there friction holds by \
         more than a greater contact pressure would free, so no force moves it on",
        labels.join(", "),
        committed.total_time
    );
    let origin = plan.model.contact_pairs[first.pair].interaction.friction_origin;
    Some(Diagnostic::error(Code("SL0506"), message).at(origin.unwrap_or(plan.step.origin)).help(
        "everything up to that time is kept; lower the coefficient of *FRICTION or the slope at \
         which the parts meet (mu tan a must stay below 1), or push from another side",
    ))
}

/// A structure that gives way under a load: its stiffness is no longer
/// positive, and no nearby state carries more.
fn snap_through(plan: &Plan<'_>, committed: &State, work: &Workspace) -> Option<Diagnostic> {
    let load = plan.step.loads.iter().max_by(|a, b| a.value.abs().total_cmp(&b.value.abs()))?;
    if work.negative_pivots == 0 || load.value == 0.0 {
        return None;
    }
    let label = plan.model.nodes.label(load.node);
    let dof = load.dof;
    let message = format!(
        "the structure snaps through beyond total time {:.6}: under the load at node {label}, {} it \
         gives way in {} direction{} instead of resisting",
        committed.total_time,
        dof.name(),
        work.negative_pivots,
        if work.negative_pivots == 1 { "" } else { "s" }
    );
    let help = format!(
        "everything up to that time is kept; drive the motion instead of the load: *BOUNDARY with \
         node {label}, degree of freedom {} in place of *CLOAD",
        dof.number()
    );
    Some(Diagnostic::error(Code("SL0511"), message).at(load.origin).help(help))
}

/// One fixed increment that Newton's method cannot walk.
fn step_too_large(plan: &Plan<'_>, committed: &State, outcome: &Outcome) -> Diagnostic {
    let procedure = &plan.step.procedure;
    let message = format!(
        "the fixed increment of {:.4e} beyond total time {:.6} is too large: {}",
        procedure.initial,
        committed.total_time,
        reason(outcome)
    );
    Diagnostic::error(Code("SL0512"), message)
        .at(procedure.origin.unwrap_or(plan.step.origin))
        .help(format!(
            "everything up to that time is kept; leave out DIRECT, or begin with *STATIC and an \
             increment of {:.3e}",
            0.1 * procedure.initial
        ))
}

/// Points that went on opening and closing.
fn chattering(plan: &Plan<'_>, committed: &State, outcome: &Outcome) -> Option<Diagnostic> {
    let changes = &outcome.last.as_ref()?.contact_changes;
    let first = changes.first().filter(|_| outcome.verdict == Verdict::Discontinuous)?;
    let labels: Vec<String> =
        changes.iter().take(5).map(|c| plan.model.nodes.label(c.node).to_string()).collect();
    let pair = &plan.model.contact_pairs[first.pair];
    let message = format!(
        "contact of {} chatters beyond total time {:.6}: in every iteration points open and close, \
         at last node{} {}",
        pair.name,
        committed.total_time,
        if labels.len() == 1 { "" } else { "s" },
        labels.join(", ")
    );
    Some(Diagnostic::error(Code("SL0513"), message).at(pair.interaction.origin).help(
        "everything up to that time is kept; soften the contact with *SURFACE CONTACT, SOFTENED",
    ))
}

/// The embedding program's friction law failed.
fn user_fault(plan: &Plan<'_>, committed: &State, words: &str) -> Diagnostic {
    let message = format!(
        "the user friction law gave no answer beyond total time {:.6}: {words}",
        committed.total_time
    );
    let user = |pair: &&slideline_model::ContactPair| {
        matches!(pair.interaction.friction, slideline_model::Friction::User { .. })
    };
    let origin = plan.model.contact_pairs.iter().find(user);
    Diagnostic::error(Code("SL0505"), message)
        .at(origin.and_then(|pair| pair.interaction.friction_origin))
        .help("everything up to that time is kept; the law must answer for any pressure and slip")
}

fn too_many_increments(plan: &Plan<'_>, committed: &State) -> Diagnostic {
    let message = format!(
        "INC={} increments were made and the step has only reached time {:.6} of {:.6}",
        plan.step.max_increments, committed.step_time, plan.step.procedure.period
    );
    Diagnostic::error(Code("SL0502"), message)
        .at(plan.step.origin)
        .help("raise INC on *STEP, or let *STATIC take longer increments")
}

/// A singular tangent: something can move without resistance.
fn unheld(plan: &Plan<'_>, outcome: &Outcome) -> Option<Diagnostic> {
    let equation = match outcome.fault.as_ref()? {
        SolveError::Singular { equation, .. } => *equation,
        _ => return None,
    };
    let &slot = plan.layout.slot_of_equation.get(equation)?;
    let (node, dof) = plan.layout.name(slot);
    let label = plan.model.nodes.label(node);
    let motion = if dof.is_rotation() { "turn" } else { "move" };
    let way = match dof {
        Dof::U1 => "along x",
        Dof::U2 => "along y",
        Dof::U3 => "along z",
        Dof::UR1 | Dof::UR2 | Dof::UR3 => "freely",
    };
    let message = format!(
        "nothing holds the model: node {label} can {motion} {way} ({}) without any resistance",
        dof.name()
    );
    Some(Diagnostic::error(Code("SL0503"), message).at(plan.model.nodes.get(node).origin).help(
        "hold that motion with *BOUNDARY, or attach a weak *SPRING; a body that is only \
                 held by contact must touch from the start",
    ))
}

/// Points that carried pressure at the last commit and now face no master:
/// they have slid off its end.
pub fn slid_off(plan: &Plan<'_>, committed: &State, now: &State) -> Vec<Diagnostic> {
    let mut left = Vec::new();
    for (place, point) in plan.contact.points.iter().enumerate() {
        if !committed.points[place].closed || now.points[place].along.is_some() {
            continue;
        }
        let pair = &plan.model.contact_pairs[point.pair];
        let label = plan.model.nodes.label(point.node);
        let (what, remedy, origin) = match &pair.master {
            Master::SlideLine(line) => (
                "the slide line",
                "add nodes to *SLIDE LINE, or prolong its ends with EXTENSION ZONE",
                line.origin,
            ),
            Master::RigidSurface(surface) => {
                ("the rigid surface", "prolong *RIGID SURFACE beyond the stroke", surface.origin)
            }
        };
        let message = format!(
            "node {label} has slid off the end of {what} between total time {:.6} and {:.6}",
            committed.total_time, now.total_time
        );
        left.push(Diagnostic::warning(Code("SL0504"), message).at(origin).help(remedy));
    }
    left
}

/// The contact points of a trial that did not converge.
fn trial_points(committed: &State, work: &Workspace) -> State {
    State {
        points: work.evaluation.points.clone(),
        total_time: committed.total_time,
        ..State::default()
    }
}
