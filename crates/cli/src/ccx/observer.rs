//! A run on standard output as ccx tells it: increments, iterations, forces.

use crate::{interrupt, screen};
use slideline::model::Dof;
use slideline::model::{Model, NodeIndex};
use slideline::observe::{
    AttemptReport, Event, FieldReport, IterationReport, Observer, StepReport, Stop,
};
use slideline::output::fixed::push_exponent;
use std::fmt::Write as _;
use std::ops::ControlFlow;

/// Tells a run in the words of ccx.
#[derive(Debug, Default)]
pub(super) struct Told {
    labels: Vec<u64>,
    /// Step and increment that the last iteration belonged to, and its attempt.
    at: Option<[usize; 3]>,
    waiting: String,
}

impl Told {
    fn begin(&mut self, report: &StepReport<'_>) {
        let model: &Model = report.model;
        self.labels = model.nodes.iter().map(|node| node.label).collect();
        let nonlinear = model.steps.get(report.step - 1).is_some_and(|step| step.nlgeom);
        let geometry =
            if nonlinear { " Nonlinear geometric effects are taken into account\n\n" } else { "" };
        // a String takes any text
        let _ = write!(
            self.waiting,
            "\n STEP {:>12}\n\n Static analysis was selected\n\n{geometry} number of equations\n {}\n\n",
            report.step, report.equations
        );
    }

    fn iteration(&mut self, own: &IterationReport) {
        let at = [own.step, own.increment, own.attempt];
        if self.at != Some(at) {
            self.at = Some(at);
            let _ = writeln!(self.waiting, " increment {} attempt {} ", own.increment, own.attempt);
        }
        let FieldReport {
            residual,
            residual_at,
            average,
            correction,
            correction_at,
            increment,
            ..
        } = own.force;
        let [residual, average, correction, increment] =
            [residual, average, correction, increment].map(number);
        let ending = if own.converged { "convergence" } else { "no convergence" };
        let _ = write!(
            self.waiting,
            "\n iteration {}\n\n time avg. forc= {average}\n \
             largest residual force= {residual}{}\n \
             largest increment of disp= {increment}\n \
             largest correction to disp= {correction}{}\n closed contact points= {}\n\n {ending}\n",
            own.iteration,
            self.place(residual_at),
            self.place(correction_at),
            own.closed,
        );
    }

    fn place(&self, at: Option<(NodeIndex, Dof)>) -> String {
        at.map_or_else(String::new, |(node, dof)| {
            let label = self.labels.get(node).copied().unwrap_or_default();
            format!(" in node {label} and dof {}", dof.number())
        })
    }

    fn given_up(&mut self, own: &AttemptReport) {
        let _ = write!(self.waiting, "\n attempt given up: {}\n", own.reason);
        if let Some(next) = own.next {
            let _ = writeln!(self.waiting, " the increment is tried again with {}", number(next));
        }
    }

    fn committed(&mut self, times: [f64; 3]) {
        let [size, step, total] = times.map(number);
        let _ = write!(
            self.waiting,
            "\n increment size= {size}\n actual step time={step}\n \
             actual total time={total}\n\n"
        );
    }
}

/// As C writes it.
fn number(value: f64) -> String {
    let mut text = String::new();
    push_exponent(&mut text, value, 6);
    text.trim_start().to_owned()
}

impl Observer for Told {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match &event {
            Event::StepBegin(report) => self.begin(report),
            Event::Iteration(own) => self.iteration(own),
            Event::AttemptFailed(own) => self.given_up(own),
            Event::Committed(own) => {
                self.committed([own.time_increment, own.step_time, own.total_time]);
            }
            _ => {}
        }
        let between = matches!(event, Event::Committed(_) | Event::AttemptFailed(_));
        if between || matches!(event, Event::End(_)) {
            screen::print(&std::mem::take(&mut self.waiting));
        }
        if between && interrupt::asked() {
            return ControlFlow::Break(Stop::Interrupted);
        }
        ControlFlow::Continue(())
    }
}
