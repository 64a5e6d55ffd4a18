//! Why an increment could not be found, in physical words.
//!
//! ```text
//!   iterations --> iteration_history (status, way and gap of every point; residual;
//!                  pivots; null motion; contradictions)  --> the first cause
//!                                                            that it proves
//! ```
//!
//! What nothing proves is called unknown.

mod contact;
mod element;
mod law;
mod passed;
mod structure;

pub use contact::slid_off;
pub use structure::step_too_large;

use crate::increments::{StopReason, Verdict};
use crate::newton::{Outcome, Scratch};
use crate::problem::Problem;
use crate::state::State;
use slideline_diag::{Code, Diagnostic, Place};
use slideline_linalg::SolveError;
use slideline_model::{Extrapolation, Friction, Name, NodeIndex, Step};

/// An attempt that failed, with all that its iterations left.
pub struct Case<'a> {
    /// The step.
    pub plan: &'a Problem<'a>,
    /// The state that it began from.
    pub committed: &'a State,
    /// Its last iteration.
    pub work: &'a Scratch,
    /// How it ended.
    pub outcome: &'a Outcome,
    /// Why no shorter increment is tried.
    pub stop: StopReason,
    /// The increment that was tried [T].
    pub dt: f64,
}

/// An attempt's end in a few words, with those of the linear solver in the deck's own.
pub fn reason(plan: &Problem<'_>, outcome: &Outcome) -> String {
    let words = match outcome.verdict {
        Verdict::Converged { .. } => "converged",
        Verdict::Diverging => "the residual grew in two consecutive iterations",
        Verdict::TooSlow => "convergence is too slow",
        Verdict::Discontinuous => "the contact status kept changing",
        Verdict::Collapsed => "an element collapsed",
        Verdict::Broken => "the equations could not be solved",
        Verdict::TooCoarse { .. } => {
            "the creep strains of the increment, by the conditions at its two ends, differ by more \
             than CETOL"
        }
        Verdict::PassedThrough { .. } => "contact was passed through in the increment",
    };
    match &outcome.fault {
        Some(fault) => format!("{words} ({})", in_words(plan, fault)),
        None => words.to_string(),
    }
}

/// What the linear solver says, with the node and the degree of freedom that an equation is of.
fn in_words(plan: &Problem<'_>, fault: &SolveError) -> String {
    let of = |equation: usize| {
        let (node, dof) = plan.dofs.name(*plan.constraints.dof_of_equation.get(equation)?);
        Some(format!("node {}, {}", plan.model.nodes.name(node), dof.name()))
    };
    let said = match *fault {
        SolveError::Singular { equation, ratio } => of(equation).map(|place| {
            format!(
                "the tangent is singular: {place}, has no usable pivot, {ratio:.1e} of the size \
                 of its equation"
            )
        }),
        SolveError::NotFinite { equation } => {
            of(equation).map(|place| format!("the equation of {place}, holds no finite number"))
        }
        _ => None,
    };
    said.unwrap_or_else(|| fault.to_string())
}

/// The diagnosis of a run that ends early: the first cause that is proved.
pub fn failure(case: &Case<'_>) -> Diagnostic {
    if case.stop == StopReason::TooManyIncrements {
        return case.too_many_increments();
    }
    let causes: [fn(&Case<'_>) -> Option<Diagnostic>; 13] = [
        |case| case.too_coarse(),
        |case| case.passed_through(),
        |case| case.no_room(),
        |case| case.user_fault(),
        |case| case.failed_element(),
        |case| case.off_the_end(),
        |case| case.unheld(),
        |case| case.overconstrained(),
        |case| case.wrong_law(),
        |case| case.jam(),
        |case| case.snap_through(),
        |case| case.chattering(),
        |case| case.wavering(),
    ];
    causes.iter().find_map(|cause| cause(case)).unwrap_or_else(|| case.unknown())
}

/// Whether what is said of an attempt's end is but what a jam may do: contact
/// that wavers, or nothing.
pub fn may_be_a_jam(said: &Diagnostic) -> bool {
    ["SL0501", "SL0513", "SL0515", "SL0519"].contains(&said.code.0)
}

/// Whether an attempt that ended for this cause may have another equilibrium:
/// nothing, a snap-through, contact that wavers, an element that collapses or too
/// long an increment was proved.
pub fn may_end_elsewhere(said: &Diagnostic) -> bool {
    ["SL0501", "SL0511", "SL0512", "SL0513", "SL0515", "SL0522"].contains(&said.code.0)
}

/// A jam at points that the first iteration of an attempt showed locked.
pub fn jam_at_first(case: &Case<'_>, jammed: &[usize]) -> Option<Diagnostic> {
    case.jam_of(jammed)
}

/// Whether a diagnosis proves no cause.
pub fn is_unknown(said: &Diagnostic) -> bool {
    said.code == Code("SL0501")
}

/// The most nodes that a message names.
const NAMED: usize = 4;

impl Case<'_> {
    /// The node in the deck's words.
    fn label(&self, node: NodeIndex) -> Name<'_> {
        self.plan.model.nodes.name(node)
    }

    /// `node 4`, or `nodes 4, 5, 6, 7 and others`, of contact points.
    fn nodes(&self, places: &[usize]) -> String {
        let mut nodes: Vec<NodeIndex> =
            places.iter().map(|&place| self.plan.contact.points[place].node).collect();
        nodes.dedup();
        let labels: Vec<String> =
            nodes.iter().take(NAMED).map(|&node| self.label(node).to_string()).collect();
        let more = if nodes.len() > NAMED { " and others" } else { "" };
        let word = if nodes.len() > 1 { "nodes" } else { "node" };
        format!("{word} {}{more}", labels.join(", "))
    }

    /// `beyond total time 0.25`.
    fn beyond(&self) -> String {
        format!("beyond total time {:.6}", self.committed.total_time)
    }

    fn unknown(&self) -> Diagnostic {
        let ended = match self.stop {
            StopReason::TooManyAttempts => "every shorter increment failed as well",
            StopReason::TooSmall => "the next increment would be shorter than the smallest allowed",
            StopReason::Fixed => "shorter increments than *STATIC, DIRECT fixes failed as well",
            StopReason::TooManyIncrements => "the limit of increments was reached",
        };
        let place = self.outcome.last.as_ref().and_then(|report| {
            let (node, dof) = report.force.residual_at?;
            Some(format!(
                "; the largest residual force, {:.3e}, is at node {}, {}",
                report.force.residual,
                self.label(node),
                dof.name()
            ))
        });
        let message = format!(
            "no equilibrium was found {}, and the cause is not known: {}, and {ended}{}",
            self.beyond(),
            reason(self.plan, self.outcome),
            place.unwrap_or_default()
        );
        Diagnostic::error(Code("SL0501"), message).at(self.plan.step.origin).help(format!(
            "the results up to that time are kept; let *STATIC start with a shorter increment and \
             allow smaller ones, or soften the contact with {}",
            self.plan.model.vocabulary().softened()
        ))
    }

    /// The embedding program's friction law failed.
    fn user_fault(&self) -> Option<Diagnostic> {
        let fault = self.work.evaluation.fault.as_ref()?;
        let message = format!("the user friction law failed {}: {}", self.beyond(), fault.message);
        let mut pairs = self.plan.model.contact_pairs.iter();
        let user = pairs.find(|p| matches!(p.interaction.friction, Friction::User { .. }));
        let said = Diagnostic::error(Code("SL0505"), message)
            .at(user.and_then(|pair| pair.interaction.friction_origin));
        Some(said.help(
            "the results up to that time are kept; the law must return a result for any pressure \
             and slip",
        ))
    }

    fn too_many_increments(&self) -> Diagnostic {
        let step = self.plan.step;
        let (reached, period) = (self.committed.step_time, step.procedure.period);
        let message = format!(
            "INC={} increments were made and the step has only reached time {reached:.6} of \
             {period:.6}",
            step.max_increments
        );
        let each = reached / step.max_increments.max(1) as f64;
        let needed = (2.0 * period / each).min(1e6).ceil() as usize; // a card, not a promise
        Diagnostic::error(Code("SL0502"), message)
            .at(step.origin)
            .help(format!("raise INC on *STEP to {needed}, or allow longer increments on *STATIC"))
            .card(Place::Instead(step.origin), step_card(step, None, needed))
    }
}

/// The `*STEP` card with another word on symmetry or number of increments.
fn step_card(step: &Step, unsymmetric: Option<bool>, increments: usize) -> String {
    let mut card = String::from("*STEP");
    if step.nlgeom {
        card.push_str(", NLGEOM");
    }
    card.push_str(&format!(", INC={}", increments));
    match unsymmetric.or(step.unsymmetric) {
        Some(true) => card.push_str(", UNSYMM=YES"),
        Some(false) => card.push_str(", UNSYMM=NO"),
        None => {}
    }
    match step.extrapolation {
        Extrapolation::Linear => {}
        Extrapolation::Parabolic => card.push_str(", EXTRAPOLATION=PARABOLIC"),
        Extrapolation::None => card.push_str(", EXTRAPOLATION=NO"),
    }
    if step.at_once {
        card.push_str(", AMPLITUDE=STEP");
    }
    card.push('\n');
    for line in step.title.lines() {
        card.push_str(line);
        card.push('\n');
    }
    card
}
