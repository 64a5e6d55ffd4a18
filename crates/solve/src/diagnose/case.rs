//! An attempt that failed, and the words for it.

use crate::increments::{StopReason, Verdict};
use crate::newton::{Outcome, Scratch};
use crate::problem::Problem;
use crate::state::State;
use slideline_linalg::SolveError;
use slideline_model::{Extrapolation, Name, NodeIndex, Step};

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
        Verdict::TooCoarse { .. } => {
            "the creep strains of the increment, by the conditions at its two ends, differ by more \
             than CETOL"
        }
        Verdict::Broken => "the equations could not be solved",
        Verdict::FlowsAway => {
            "an equilibrium was found only where metal has flowed away without end"
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

/// The most nodes that a message names.
const NAMED: usize = 4;

impl Case<'_> {
    /// The node in the deck's words.
    pub(super) fn label(&self, node: NodeIndex) -> Name<'_> {
        self.plan.model.nodes.name(node)
    }

    /// `node 4`, or `nodes 4, 5, 6, 7 and others`, of contact points.
    pub(super) fn nodes(&self, places: &[usize]) -> String {
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
    pub(super) fn beyond(&self) -> String {
        format!("beyond total time {:.6}", self.committed.total_time)
    }
}

/// The `*STEP` card with another word on symmetry or number of increments.
pub(super) fn step_card(step: &Step, unsymmetric: Option<bool>, increments: usize) -> String {
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

/// What a second coefficient of friction adds to its card and to the data line.
pub(super) fn second_coefficient(second: Option<f64>) -> (&'static str, String) {
    second.map_or_else(Default::default, |second| (", ANISOTROPIC", format!(", {second:.4}")))
}
