//! A solve that streams what it finds.
//!
//! ```text
//!   values -> Parametric -> model -> Workspace::run -> Stream --+--> begin, points, points ...
//!                                       ^                       `--> end, or overtaken
//!                                       `- say: a newer one is asked for
//! ```

use crate::answers::overtaken;
use crate::curves::Curves;
use crate::deck::Opened;
use crate::outcome::{ended, unread};
use crate::quiet::Quiet;
use crate::values::Values;
use serde_json::{Value, json};
use slideline::observe::{Ending, Frame};
use slideline::output::json::text;
use slideline::output::report::Options;
use slideline::{
    Diagnostic, Event, Judge, Model, Observer, Parameter, Plan, Severity, SolveOptions, Stop,
    Varied, Workspace, objections,
};
use std::ops::ControlFlow;

/// Time between two messages of points [ms].
const BATCH: f64 = 8.0;
/// Most rows of a message where there is no clock.
const MOST: usize = 16;

/// What a solve leaves to the next one.
#[derive(Default)]
pub(crate) struct Room(Option<Workspace>);

impl Room {
    /// Runs a model in the room of the one before, or in a new one where its outline is another.
    pub fn run(&mut self, model: &Model, observer: &mut dyn Observer) -> Option<Ending> {
        if let Some(workspace) = &mut self.0
            && let Ok(ending) = workspace.run(model, observer)
        {
            return Some(ending);
        }
        self.made(model).run(model, observer).ok()
    }

    /// The same with derivatives by what [`Room::varied`] gave for the model.
    pub fn run_varied(
        &mut self,
        model: &Model,
        varied: Varied,
        observer: &mut dyn Observer,
    ) -> Option<Ending> {
        self.0.as_mut()?.run_varied(model, varied, observer).ok()
    }

    /// What a model has derivatives by, of parameters.
    pub fn varied(&mut self, model: &Model, parameters: &[Parameter]) -> Option<Varied> {
        let known = self.0.as_ref().and_then(|own| own.varied(model, parameters).ok());
        let found = known.or_else(|| self.made(model).varied(model, parameters).ok());
        found.map(|(varied, _)| varied)
    }

    /// A new one.
    fn made(&mut self, model: &Model) -> &mut Workspace {
        self.0.insert(Workspace::new(&Plan::of(model), &SolveOptions::default()))
    }
}

/// The model of values with everything that is said about it before it runs. `Err`: the errors.
pub(crate) fn model(
    opened: &Opened,
    values: &Values,
) -> Result<(Model, Vec<Diagnostic>), Vec<Diagnostic>> {
    let Some(parametric) = &opened.parametric else { return Err(opened.read.diagnostics.clone()) };
    let (model, mut said) = parametric.read(&opened.places.settings(&opened.sliders, values)?)?;
    said.extend(objections(&model));
    // as a run has it: what is trivial goes below
    said.sort_by_key(|own| own.severity == Severity::Note);
    Ok((model, said))
}

/// Solves and says everything; the answer that is left to be said, if one is.
pub(crate) fn solve(
    opened: &Opened,
    values: &Values,
    room: &mut Room,
    (id, clock): (&Value, Option<&(dyn Fn() -> f64 + Send)>),
    say: &mut dyn FnMut(&str) -> bool,
) -> Option<Value> {
    let (model, said) = match model(opened, values) {
        Ok(found) => found,
        Err(errors) => return Some(unread(id, &errors, &opened.read.sources)),
    };
    let sources = &opened.read.sources;
    let job = (opened.job(), &*opened.read.deck_hash, true);
    let mut stream = Stream {
        judge: Judge::showing(&model, (&said, sources), job),
        curves: Curves::of(&model),
        all: Vec::new(),
        id,
        say,
        clock,
        rows: Vec::new(),
        frames: Vec::new(),
        sent: None,
        due: 1,
        begun: false,
        goes_on: true,
    };
    let ending = room.run(&model, &mut stream);
    stream.flush();
    match (ending, stream.judge.told()) {
        (Some(Ending::Stopped(..)) | None, _) | (_, None) => Some(overtaken(id)),
        (Some(ending), Some(told)) => {
            let quiet = Quiet::of(told.clone(), &stream.all, &stream.curves);
            Some(ended(&model, (id, &ending), &quiet))
        }
    }
}

/// Watches a run and says what it finds.
struct Stream<'a, 's> {
    judge: Judge<'a>,
    curves: Curves,
    /// Motion and load of what is loaded, a row an increment.
    all: Vec<Vec<[f64; 2]>>,
    id: &'s Value,
    say: &'s mut dyn FnMut(&str) -> bool,
    clock: Option<&'s (dyn Fn() -> f64 + Send)>,
    rows: Vec<Value>,
    frames: Vec<Value>,
    /// When the last message was sent.
    sent: Option<f64>,
    /// Rows of the next message, where there is no clock.
    due: usize,
    begun: bool,
    goes_on: bool,
}

impl Stream<'_, '_> {
    fn begin(&mut self, start: &Frame<'_>) {
        let records = self.judge.records();
        let parts = records.start().unwrap_or_default();
        let told = match self.curves.is_loaded() {
            true => self.curves.told(start.model),
            false => records.driven().unwrap_or_default(),
        };
        let zeros = vec![0.0; 2 * told.as_array().map_or(0, Vec::len)];
        let curves = text(&told);
        let id = text(self.id);
        // the parts are a text of their own already
        let message =
            format!("{{\"say\":\"begin\",\"id\":{id},\"curves\":{curves},\"parts\":{parts}}}");
        self.goes_on = (self.say)(&message);
        self.rows.push(row(start.total_time, [start.step, 0], &zeros));
        self.flush();
    }

    fn follow(&mut self, frame: &Frame<'_>) {
        let records = self.judge.records();
        let own = match self.curves.is_loaded() {
            true => self.curves.row(frame),
            false => records.row(),
        };
        self.rows.push(row(frame.total_time, [frame.step, frame.increment], &own.concat()));
        self.frames.extend(records.state(frame));
        self.all.push(own);
        let is_due = match (self.clock, self.sent) {
            (Some(clock), Some(sent)) => clock() - sent >= BATCH,
            (Some(_), None) => true,
            (None, _) => self.rows.len() >= self.due,
        };
        // the first point at once, whatever the clock says
        if is_due || records.increments() == 1 {
            self.due = (2 * self.due).min(MOST);
            self.flush();
        } else {
            self.goes_on = (self.say)("");
        }
    }

    fn flush(&mut self) {
        if self.rows.is_empty() {
            return;
        }
        let (rows, frames) = (std::mem::take(&mut self.rows), std::mem::take(&mut self.frames));
        let message = json!({"say": "points", "id": self.id, "rows": rows, "frames": frames});
        self.goes_on = (self.say)(&text(&message));
        self.sent = self.clock.map(|clock| clock());
    }
}

fn row(time: f64, [step, increment]: [usize; 2], values: &[f64]) -> Value {
    let mut row = vec![json!(time), json!(step), json!(increment)];
    row.extend(values.iter().map(|value| json!(value)));
    Value::Array(row)
}

impl Observer for Stream<'_, '_> {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        let (begun, committed) = match &event {
            Event::StepBegin(step) if !std::mem::replace(&mut self.begun, true) => {
                (Some(step.start), None)
            }
            Event::Committed(frame) => (None, Some(**frame)),
            Event::Iteration(_) => {
                self.goes_on = (self.say)("");
                (None, None)
            }
            _ => (None, None),
        };
        let _ = self.judge.event(event); // it never stops a run
        if let Some(start) = begun {
            self.begin(&start);
        }
        if let Some(frame) = committed {
            self.follow(&frame);
        }
        if self.goes_on { ControlFlow::Continue(()) } else { ControlFlow::Break(Stop::Interrupted) }
    }
}

/// Watches a run without saying anything but its end.
pub(crate) struct Silent<'a, 's> {
    judge: Judge<'a>,
    curves: Curves,
    say: &'s mut dyn FnMut(&str) -> bool,
    /// Motion and reaction of what is driven, from the start on, a row an increment.
    rows: Vec<Vec<[f64; 2]>>,
}

impl<'a, 's> Silent<'a, 's> {
    /// One that hands events to a judge.
    pub fn of(judge: Judge<'a>, model: &Model, say: &'s mut dyn FnMut(&str) -> bool) -> Self {
        Self { judge, curves: Curves::of(model), say, rows: Vec::new() }
    }

    /// The report of a run that came to its end; none of one that was stopped.
    pub fn page(&self, job: &str, options: &Options<'_>) -> Option<String> {
        let told = self.judge.told()?;
        let stopped = told.summary.get("status").and_then(Value::as_str) == Some("interrupted");
        self.judge.records().page(job, options).filter(|_| !stopped)
    }

    /// What a run that was completed came to.
    pub fn ended(&self) -> Result<Quiet, String> {
        let told = self.judge.told().cloned().ok_or_else(|| OVERTAKEN.to_owned())?;
        Ok(Quiet::of(told, &self.rows, &self.curves))
    }
}

impl Observer for Silent<'_, '_> {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        let committed = match &event {
            Event::Committed(frame) => Some(**frame),
            _ => None,
        };
        let asks = committed.is_some() || matches!(event, Event::Iteration(_));
        let _ = self.judge.event(event); // it never stops a run
        if let Some(frame) = committed {
            let loaded = self.curves.is_loaded();
            self.rows.push(if loaded {
                self.curves.row(&frame)
            } else {
                self.judge.records().row()
            });
        }
        let goes_on = !asks || (self.say)("");
        if goes_on { ControlFlow::Continue(()) } else { ControlFlow::Break(Stop::Interrupted) }
    }
}

/// Solves without saying anything. `Err`: why there is no result.
pub(crate) fn quietly(
    opened: &Opened,
    values: &Values,
    room: &mut Room,
    say: &mut dyn FnMut(&str) -> bool,
) -> Result<Quiet, String> {
    let (model, said) = model(opened, values).map_err(|errors| first_error(&errors))?;
    let job = (opened.job(), &*opened.read.deck_hash, false);
    let judge = Judge::showing(&model, (&said, &opened.read.sources), job);
    let mut silent = Silent::of(judge, &model, say);
    match room.run(&model, &mut silent) {
        Some(Ending::Completed(_)) => {}
        Some(Ending::NotConverged(_, said)) => return Err(because(&said)),
        Some(Ending::Stopped(..)) | None => return Err(OVERTAKEN.to_owned()),
    }
    silent.ended()
}

/// Why there is no model.
pub(crate) fn first_error(said: &[Diagnostic]) -> String {
    let first = said.iter().find(|own| own.severity == Severity::Error);
    first.map_or_else(|| "the deck has errors".to_owned(), because)
}

/// What is said, with its code.
pub(crate) fn because(said: &Diagnostic) -> String {
    format!("{} ({})", said.message, said.code.0)
}

/// Why a run has no end: something newer is asked for.
pub(crate) const OVERTAKEN: &str = "something newer was asked for";
