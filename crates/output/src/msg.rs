//! `JOB.msg`: every iteration, and why a run failed if it did.

use crate::facts::Facts;
use crate::file::{Growing, WriteError};
use crate::job::JobFiles;
use crate::kept::Kept;
use crate::number::general;
use crate::writer::Writer;
use slideline_diag::{Diagnostic, Sources};
use slideline_model::{Dof, Model, NodeIndex};
use slideline_solve::Enforcement;
use slideline_solve::observe::{
    AttemptReport, ContactChange, Ending, Event, FieldReport, Frame, IterationReport, StepReport,
    TangentReport, Totals,
};
use std::fmt::Write as _;

/// Writes `JOB.msg`.
pub(crate) struct Msg<'a> {
    job: JobFiles,
    sources: &'a Sources,
    file: Option<Growing>,
    /// Labels by place, so that iterations can name nodes.
    labels: Vec<u64>,
    pairs: Vec<String>,
    list_changes: bool,
    /// Step, increment, attempt of the last heading.
    headed: (usize, usize, usize),
}

impl<'a> Msg<'a> {
    pub fn new(job: &JobFiles, facts: &Facts<'a>) -> Self {
        Self {
            job: job.clone(),
            sources: facts.sources,
            file: None,
            labels: Vec::new(),
            pairs: Vec::new(),
            list_changes: false,
            headed: (0, 0, 0),
        }
    }

    fn begin(&mut self, report: &StepReport<'_>) -> Result<(), WriteError> {
        let mut file = match self.file.take() {
            Some(file) => file,
            None => self.job.begin(".msg", "")?,
        };
        self.labels = report.model.nodes.iter().map(|node| node.label).collect();
        self.pairs = report.model.contact_pairs.iter().map(|pair| pair.name.clone()).collect();
        self.list_changes = step_of(report).is_some_and(|step| step.output.contact_changes);
        if !report.resumed {
            step_heading(&mut file.text, report);
        }
        file.flush()?;
        self.file = Some(file);
        Ok(())
    }

    fn iteration(&mut self, report: &IterationReport) {
        let Some(mut file) = self.file.take() else { return };
        let text = &mut file.text;
        let place = (report.step, report.increment, report.attempt);
        if self.headed != place {
            self.headed = place;
            let (step, increment, attempt) = place;
            line!(text, "\nSTEP {step}  INCREMENT {increment}  ATTEMPT {attempt}");
        }
        iteration_heading(text, report);
        self.field(text, "force", &report.force);
        self.field(text, "moment", &report.moment);
        if self.list_changes {
            self.changes(text, &report.contact_changes);
        }
        self.file = Some(file);
    }

    fn field(&self, text: &mut String, name: &str, field: &FieldReport) {
        line!(
            text,
            "    {name:<7} largest residual {:>11}{}  time-averaged {name} {:>11}  allowed \
                 {:>11}  largest correction {:>11}{}  largest increment {:>11}{}",
            general(field.residual, 4),
            self.place(field.residual_at),
            general(field.average, 4),
            general(field.allowed, 4),
            general(field.correction, 4),
            self.place(field.correction_at),
            general(field.increment, 4),
            if field.converged { "  ok" } else { "" }
        );
    }

    fn place(&self, at: Option<(NodeIndex, Dof)>) -> String {
        at.map_or_else(String::new, |(node, dof)| {
            format!(" at node {} dof {}", self.label(node), dof.number())
        })
    }

    fn label(&self, node: NodeIndex) -> u64 {
        self.labels.get(node).copied().unwrap_or_default()
    }

    fn changes(&self, text: &mut String, changes: &[ContactChange]) {
        for change in changes {
            let pair = self.pairs.get(change.pair).map_or("?", String::as_str);
            let now = if change.closed { "closes" } else { "opens" };
            line!(text, "    {pair} node {} {now}", self.label(change.node));
        }
    }

    fn tangent(&mut self, report: &TangentReport) -> Result<(), WriteError> {
        let text = format!(
            "  TANGENT of {} equations against differences: off by {} of the largest entry of its \
             kind at {}: assembled {}, by differences {}",
            report.equations,
            general(report.off, 3),
            report.entry(&self.labels, &self.pairs),
            general(report.assembled, 7),
            general(report.difference, 7),
        );
        self.with_file(|file| line!(file, "{text}"))
    }

    fn with_file(&mut self, write: impl FnOnce(&mut String)) -> Result<(), WriteError> {
        let Some(file) = &mut self.file else { return Ok(()) };
        write(&mut file.text);
        file.flush()
    }
}

fn step_of<'a>(report: &StepReport<'a>) -> Option<&'a slideline_model::Step> {
    let model: &'a Model = report.model;
    report.step.checked_sub(1).and_then(|place| model.steps.get(place))
}

fn step_heading(text: &mut String, report: &StepReport<'_>) {
    let step = step_of(report);
    let title = step.map_or("", |step| step.title.as_str()).replace('\n', " / ");
    line!(text, "\nSTEP {}  {title}", report.step);
    line!(
        text,
        "  {} equations, {} entries in the pattern, solved by: {}; the tangent is treated as {}",
        report.equations,
        report.entries,
        report.linear_solver,
        if report.unsymmetric { "unsymmetric" } else { "symmetric" }
    );
    let Some(step) = step else { return };
    let field = &step.controls.field;
    let time = step.controls.effective_time();
    let whose = if field.set_by_deck {
        "set by the deck's *CONTROLS"
    } else {
        "this program's own; *CONTROLS, PARAMETERS=FIELD sets another"
    };
    line!(
        text,
        "  residual tolerance R_n = {} of the time-averaged force ({whose}), R_p = {} after \
             {} iterations; correction tolerance C_n = {}",
        general(field.r_n, 4),
        general(field.r_p, 4),
        time.i_p,
        general(field.c_n, 4)
    );
    if step.controls.discontinuous {
        line!(text, "  ANALYSIS=DISCONTINUOUS: I_0 = {}, I_R = {}", time.i_0, time.i_r);
    }
}

fn iteration_heading(text: &mut String, report: &IterationReport) {
    let kind = if report.severe {
        "severe discontinuity iteration".to_owned()
    } else {
        format!("equilibrium iteration {}", report.equilibrium)
    };
    let shortened = if report.step_length < 1.0 {
        format!("; {} of the correction taken", general(report.step_length, 3))
    } else {
        String::new()
    };
    let way = match report.enforcement {
        Enforcement::Dense => String::new(),
        own @ Enforcement::Penalty => format!("; contact {}", own.word()),
        own @ Enforcement::Augmented => {
            format!("; contact {}, multipliers moved {} times", own.word(), report.moves)
        }
        own @ Enforcement::MatrixFree => {
            format!("; contact {}, {} solutions", own.word(), report.solutions)
        }
    };
    let changes = report.contact_changes.len();
    line!(
        text,
        "  ITERATION {}  {kind}; {changes} contact change{}, {} closed, contact defect \
             {}{way}{shortened}{}",
        report.iteration,
        if changes == 1 { "" } else { "s" },
        report.closed,
        general(report.contact_defect, 4),
        if report.converged { "; CONVERGED" } else { "" }
    );
}

fn committed(text: &mut String, frame: &Frame<'_>) {
    line!(
        text,
        "  INCREMENT {} IS DONE: time increment {}, step time {}, total time {}",
        frame.increment,
        general(frame.time_increment, 6),
        general(frame.step_time, 6),
        general(frame.total_time, 6)
    );
}

fn attempt_failed(text: &mut String, attempt: &AttemptReport) {
    line!(
        text,
        "  ATTEMPT {} OF INCREMENT {} IS GIVEN UP (time increment {}): {}",
        attempt.attempt,
        attempt.increment,
        general(attempt.time_increment, 6),
        given_up(attempt)
    );
}

/// Why an attempt is given up, and what follows.
pub(crate) fn given_up(attempt: &AttemptReport) -> String {
    let next = attempt.next.map_or_else(
        || "no further attempt".to_owned(),
        |next| format!("next attempt with time increment {}", general(next, 6)),
    );
    format!("{}; {next}", attempt.reason)
}

fn diagnosed(text: &mut String, said: &Diagnostic, sources: &Sources) {
    let place = said
        .span
        .and_then(|span| sources.locate(span))
        .map_or_else(String::new, |at| format!(" ({}, line {})", at.file, at.line));
    line!(text, "\n{} {}: {}{place}", said.severity.word(), said.code, said.message);
    for label in &said.labels {
        if let Some(at) = sources.locate(label.span) {
            line!(text, "  {}, line {}: {}", at.file, at.line, label.text);
        }
    }
    if let Some(help) = &said.help {
        line!(text, "  what to do: {help}");
    }
}

fn ended(text: &mut String, ending: &Ending) {
    let (word, totals) = match ending {
        Ending::Completed(totals) => ("THE RUN IS COMPLETE".to_owned(), totals),
        Ending::NotConverged(totals, why) => {
            (format!("THE RUN DID NOT CONVERGE: {}: {}", why.code, why.message), totals)
        }
        Ending::Stopped(totals, _) => ("THE RUN WAS STOPPED".to_owned(), totals),
    };
    let Totals { increments, cutbacks, iterations, .. } = totals;
    line!(
        text,
        "\n{word}\n  {increments} increments, {cutbacks} cutbacks, {iterations} iterations"
    );
}

impl Writer for Msg<'_> {
    fn event(&mut self, event: &Event<'_>) -> Result<(), WriteError> {
        let sources = self.sources;
        match event {
            Event::StepBegin(report) => self.begin(report),
            Event::Iteration(report) => {
                self.iteration(report);
                Ok(())
            }
            Event::Committed(frame) => self.with_file(|text| committed(text, frame)),
            Event::AttemptFailed(attempt) => self.with_file(|text| attempt_failed(text, attempt)),
            Event::Tangent(report) => self.tangent(report),
            Event::Checkpoint(_) | Event::Unconverged(_) => Ok(()),
            Event::Diagnosed(said) => self.with_file(|text| diagnosed(text, said, sources)),
            Event::End(ending) => self.with_file(|text| ended(text, ending)),
        }
    }

    fn keep(&self, kept: &mut Kept) {
        kept.file(".msg", self.file.as_ref());
    }
}
