//! What is seen of a run while it goes on.
//!
//! ```text
//!    STEP   INC  ATT  SDI  EQU         TIME  CLOSED       9999.U2      9999.RF2
//!       1     1    1    2    4         0.05       1       -0.0015   -0.01203451
//! ```
//!
//! On a terminal the table is narrower, has the residual, and a last line
//! below it tells how far the run is ([`Live`]).

use crate::live::{self, Live, Row};
use crate::{interrupt, screen};
use slideline::diag::{Diagnostic, Sources};
use slideline::model::{Dof, Model, NodeIndex};
use slideline::observe::{
    AttemptReport, Event, FieldReport, Frame, FrictionCall, IterationReport, Observer, Status,
    StepReport, Stop, TangentReport,
};
use slideline::output::json::{self, Value, json};
use slideline::output::number::general;
use slideline::output::record;
use std::fmt::Write as _;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

/// How progress is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mode {
    /// Not at all.
    Silent,
    /// A line per increment.
    Lines,
    /// The same with a last line that follows the iterations.
    Live,
    /// JSON objects, one a line.
    Json,
}

/// Text waits no longer than this.
const PATIENCE: Duration = Duration::from_millis(50);

/// Shows a run and ends it when the user asks.
pub(crate) struct Progress<'a> {
    mode: Mode,
    sources: &'a Sources,
    /// Driven dofs: at most two are shown in the table.
    driven: Vec<(NodeIndex, Dof)>,
    labels: Vec<u64>,
    /// Names of the contact pairs.
    pairs: Vec<String>,
    waiting: String,
    shown: Instant,
    live: Live,
    /// Largest residual of the last iteration [F].
    residual: f64,
}

impl<'a> Progress<'a> {
    pub fn new(mode: Mode, sources: &'a Sources) -> Self {
        let (driven, labels, pairs) = (Vec::new(), Vec::new(), Vec::new());
        let waiting = String::new();
        let (shown, live, residual) = (Instant::now(), Live::new(), 0.0);
        Self { mode, sources, driven, labels, pairs, waiting, shown, live, residual }
    }

    fn begin(&mut self, report: &StepReport<'_>) {
        let model = report.model;
        self.labels = model.nodes.iter().map(|node| node.label).collect();
        self.pairs = model.contact_pairs.iter().map(|pair| pair.name.clone()).collect();
        self.driven = driven(report.model, report.step);
        if self.mode == Mode::Json {
            return;
        }
        self.clear_line();
        let title = model.steps.get(report.step - 1).map_or("", |step| step.title.as_str());
        let _ = writeln!(
            self.waiting,
            "step {}  {}  ({} equations)",
            report.step,
            title.replace('\n', " / "),
            report.equations
        ); // a String takes any text
        if self.mode == Mode::Live {
            self.begin_live(report);
            return;
        }
        let _ = write!(
            self.waiting,
            "{:>5} {:>6} {:>4} {:>4} {:>4} {:>12} {:>7}",
            "STEP", "INC", "ATT", "SDI", "EQU", "TIME", "CLOSED"
        );
        for &(node, dof) in self.driven.iter().take(2) {
            for name in [dof.name(), dof.reaction_name()] {
                let _ = write!(self.waiting, " {:>14}", format!("{}.{name}", self.labels[node]));
            }
        }
        self.waiting.push('\n');
    }

    /// Head of the table of a terminal.
    fn begin_live(&mut self, report: &StepReport<'_>) {
        let names = self.driven.first().map(|&(node, dof)| {
            [dof.name(), dof.reaction_name()].map(|name| format!("{}.{name}", self.labels[node]))
        });
        self.waiting.push_str(&live::heading(screen::output_width(), names.as_ref()));
        self.waiting.push('\n');
        let whole = report.model.steps.iter().map(|step| step.procedure.period).sum();
        self.live.step(whole, names.map(|[_, reaction]| reaction));
    }

    /// A row of the table of a terminal.
    fn increment_live(&mut self, frame: &Frame<'_>, closed: usize) {
        let driven = self.driven.first().map(|&(node, dof)| {
            let [moved, reaction, _] = frame.nodal.named(node, dof);
            [moved, reaction]
        });
        let row = Row {
            step: frame.step,
            increment: frame.increment,
            time: frame.total_time,
            iterations: frame.severe_iterations + frame.equilibrium_iterations,
            closed,
            residual: self.residual,
            driven,
        };
        self.waiting.push_str(&row.line(screen::output_width()));
        self.waiting.push('\n');
        self.live.increment(frame.total_time, driven.map(|[_, reaction]| reaction));
    }

    fn increment(&mut self, frame: &Frame<'_>) {
        if self.mode == Mode::Json {
            self.json(&increment_object(frame, &self.driven));
            return;
        }
        self.clear_line();
        let closed = frame.contact.iter().filter(|row| row.status != Status::Open).count();
        if self.mode == Mode::Live {
            self.increment_live(frame, closed);
            return;
        }
        let _ = write!(
            self.waiting,
            "{:>5} {:>6} {:>4} {:>4} {:>4} {:>12} {closed:>7}",
            frame.step,
            frame.increment,
            frame.attempt,
            frame.severe_iterations,
            frame.equilibrium_iterations,
            general(frame.total_time, 7),
        ); // a String takes any text
        for &(node, dof) in self.driven.iter().take(2) {
            let [moved, force, _] = frame.nodal.named(node, dof);
            let _ = write!(self.waiting, " {:>14} {:>14}", general(moved, 7), general(force, 7));
        }
        self.waiting.push('\n');
    }

    fn failed(&mut self, attempt: &AttemptReport) {
        if self.mode == Mode::Json {
            self.json(&attempt_object(attempt));
            return;
        }
        self.clear_line();
        let next = attempt.next.map_or_else(
            || "no further attempt".to_owned(),
            |next| format!("next time increment {}", general(next, 6)),
        );
        let _ = writeln!(
            self.waiting,
            "{:>5} {:>6} {:>4} {:>4} {:>4} {:>12}  {}; {next}",
            attempt.step,
            attempt.increment,
            format!("{}U", attempt.attempt),
            attempt.severe_iterations,
            attempt.equilibrium_iterations,
            general(attempt.total_time, 7),
            attempt.reason,
        ); // a String takes any text
    }

    fn iteration(&mut self, report: &IterationReport) {
        self.residual = report.force.residual;
        match self.mode {
            Mode::Json => self.json(&iteration_object(report, &self.labels)),
            Mode::Live if self.shown.elapsed() >= PATIENCE => {
                self.clear_line();
                let width = screen::output_width();
                let line = self.live.line(width);
                let more =
                    format!("  increment {}, iteration {}", report.increment, report.iteration);
                self.waiting.push_str(&line);
                if line.chars().count() + more.len() < width {
                    self.waiting.push_str(&more);
                }
                self.show();
            }
            _ => {}
        }
    }

    fn tangent(&mut self, report: &TangentReport) {
        let entry = report.entry(&self.labels, &self.pairs);
        if self.mode == Mode::Json {
            self.json(&json!({
                "event": "tangent",
                "step": report.step,
                "increment": report.increment,
                "equations": report.equations,
                "off": report.off,
                "entry": entry,
                "assembled": report.assembled,
                "difference": report.difference,
            }));
            return;
        }
        self.clear_line();
        let _ = writeln!(
            self.waiting,
            "      tangent of increment {}: off by {} at {entry}",
            report.increment,
            general(report.off, 3),
        ); // a String takes any text
    }

    fn clear_line(&mut self) {
        if self.mode == Mode::Live {
            self.waiting.push_str("\r\x1b[K");
        }
    }

    fn json(&mut self, object: &Value) {
        self.waiting.push_str(&json::text(object));
        self.waiting.push('\n');
    }

    fn show(&mut self) {
        screen::print(&self.waiting);
        self.waiting.clear();
        self.shown = Instant::now();
    }

    fn take(&mut self, event: &Event<'_>) {
        match event {
            Event::StepBegin(report) => self.begin(report),
            Event::Iteration(report) => self.iteration(report),
            Event::AttemptFailed(attempt) => self.failed(attempt),
            Event::Committed(frame) => self.increment(frame),
            Event::Tangent(report) => self.tangent(report),
            Event::Diagnosed(said) if self.mode == Mode::Json => {
                self.json(&diagnosis(said, self.sources));
            }
            Event::Diagnosed(_)
            | Event::Checkpoint(_)
            | Event::Unconverged(_)
            | Event::Sensitivity(_) => {}
            Event::End(_) => self.clear_line(),
        }
        let over = matches!(event, Event::End(_));
        if !self.waiting.is_empty() && (over || self.shown.elapsed() >= PATIENCE) {
            self.close_with_line(over);
            self.show();
        }
    }

    /// On a terminal the last line stands below whatever is shown, until the
    /// run is over.
    fn close_with_line(&mut self, over: bool) {
        if self.mode == Mode::Live && !over {
            let line = self.live.line(screen::output_width());
            self.waiting.push_str(&line);
        }
    }
}

impl Observer for Progress<'_> {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if self.mode != Mode::Silent {
            self.take(&event);
        }
        let between = matches!(event, Event::Committed(_) | Event::AttemptFailed(_));
        if between && interrupt::asked() {
            return ControlFlow::Break(Stop::Interrupted);
        }
        ControlFlow::Continue(())
    }
}

/// Dofs that the step prescribes and that it or another step moves, each
/// once: a step that brings a motion back to zero drives it too.
fn driven(model: &Model, step: usize) -> Vec<(NodeIndex, Dof)> {
    let Some(step) = model.steps.get(step - 1) else { return Vec::new() };
    let mut driven: Vec<(NodeIndex, Dof)> = Vec::new();
    let moves = |place: (NodeIndex, Dof)| {
        let mut all = model.steps.iter().flat_map(|step| &step.prescribed);
        all.any(|motion| (motion.node, motion.dof) == place && motion.moves())
    };
    let moving = step.prescribed.iter().filter(|motion| moves((motion.node, motion.dof)));
    for place in moving.map(|motion| (motion.node, motion.dof)) {
        if !driven.contains(&place) {
            driven.push(place);
        }
    }
    driven
}

/// What was said as an event of the stream.
pub(crate) fn diagnosis(said: &Diagnostic, sources: &Sources) -> Value {
    json::joined(json!({"event": "diagnosis"}), record(said, sources))
}

fn iteration_object(report: &IterationReport, labels: &[u64]) -> Value {
    let field = |field: &FieldReport| {
        let at = field.residual_at.map_or(Value::Null, |(node, dof)| {
            json!({"node": labels.get(node).copied().unwrap_or_default(), "dof": dof.number()})
        });
        let more = json!({
            "average": field.average,
            "allowed": field.allowed,
            "correction": field.correction,
        });
        json::joined(json::joined(json!({"residual": field.residual}), at), more)
    };
    json!({
        "event": "iteration",
        "step": report.step,
        "increment": report.increment,
        "attempt": report.attempt,
        "iteration": report.iteration,
        "severe": report.severe,
        "equilibrium": report.equilibrium,
        "contact_changes": report.contact_changes.len(),
        "closed": report.closed,
        "force": field(&report.force),
        "moment": field(&report.moment),
        "converged": report.converged,
    })
}

fn increment_object(frame: &Frame<'_>, driven: &[(NodeIndex, Dof)]) -> Value {
    let values = driven.iter().flat_map(|&(node, dof)| {
        let label = frame.model.nodes.label(node);
        let [moved, reaction, _] = frame.nodal.named(node, dof);
        [
            (format!("{label}.{}", dof.name()), moved.into()),
            (format!("{label}.{}", dof.reaction_name()), reaction.into()),
        ]
    });
    let closed = frame.contact.iter().filter(|row| row.status != Status::Open);
    let dropped = frame.contact.iter().filter(|row| row.friction == FrictionCall::Dropped);
    json!({
        "event": "increment",
        "step": frame.step,
        "increment": frame.increment,
        "attempt": frame.attempt,
        "severe_iterations": frame.severe_iterations,
        "equilibrium_iterations": frame.equilibrium_iterations,
        "total_time": frame.total_time,
        "step_time": frame.step_time,
        "time_increment": frame.time_increment,
        "closed": closed.count(),
        "friction_dropped": dropped.count(),
        "values": values.collect::<json::Map<String, Value>>(),
    })
}

fn attempt_object(attempt: &AttemptReport) -> Value {
    json!({
        "event": "attempt_failed",
        "step": attempt.step,
        "increment": attempt.increment,
        "attempt": attempt.attempt,
        "severe_iterations": attempt.severe_iterations,
        "equilibrium_iterations": attempt.equilibrium_iterations,
        "total_time": attempt.total_time,
        "step_time": attempt.step_time,
        "time_increment": attempt.time_increment,
        "reason": attempt.reason,
        "next_time_increment": attempt.next,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: a step that ends at zero keeps the columns of what it
    /// drives; what no step moves has none.
    #[test]
    fn a_way_back_to_zero_is_driven() {
        let deck = concat!(env!("CARGO_MANIFEST_DIR"), "/../../corpus/tutorial/snap_fit.inp");
        let read = slideline::Job::read(deck.as_ref(), &slideline::ReadOptions::default());
        let model = read.model.unwrap_or_default();
        let names = |step| -> Vec<_> {
            let list = driven(&model, step).into_iter();
            list.map(|(node, dof)| (model.nodes.label(node), dof)).collect()
        };
        assert_eq!(names(1), [(100, Dof::U1)]);
        assert_eq!(names(2), [(100, Dof::U1)]);
        assert!(names(3).is_empty());
    }

    /// Requirement: the last line is there whatever event it was that let the
    /// text go, and gone at the end; in a pipe it never is.
    #[test]
    fn the_last_line_stands_below_until_the_end() {
        let sources = Sources::default();
        let shown = |mode, over| {
            let mut progress = Progress::new(mode, &sources);
            progress.live.step(1.0, None);
            progress.waiting.push_str("row\n");
            progress.close_with_line(over);
            progress.waiting
        };
        let line = shown(Mode::Live, false);
        assert!(line.starts_with("row\n[") && line.ends_with("  0 %"), "{line}");
        assert_eq!(shown(Mode::Live, true), "row\n");
        assert_eq!(shown(Mode::Lines, false), "row\n");
    }
}
