//! What `JOB.json` would say of a run, and what its report would show, kept in memory.

use crate::facts::{Facts, Status};
use crate::job::JobFiles;
use crate::json::Value;
use crate::report::{Live, Options, Told};
use crate::summary::Summary;
use slideline_measures::{Colour, NoiseSummary};
use slideline_solve::observe::{Ending, Event, Frame};
use std::path::Path;

/// Collects what `JOB.json` would say, and where it is asked for what a report would show.
pub struct Records<'a> {
    summary: Summary<'a>,
    live: Option<Live>,
}

impl<'a> Records<'a> {
    /// Those of a run that has not begun.
    pub fn new(facts: Facts<'a>) -> Self {
        Self { summary: Summary::new(&JobFiles::new(Path::new(""), "job"), facts), live: None }
    }

    /// The same with what a report of a job of that name says, with or without its shapes.
    pub fn shown(job: &str, facts: Facts<'a>, shapes: bool) -> Self {
        let summary = Summary::new(&JobFiles::new(Path::new(""), job), facts);
        Self { summary, live: Some(Live::new(shapes)) }
    }

    /// Takes note of everything but the end.
    pub fn watch(&mut self, event: &Event<'_>) {
        self.summary.watch(event);
        if let Some(live) = &mut self.live {
            live.watch(event, &self.summary);
        }
    }

    /// Takes in the noise of the run.
    pub fn measured(&mut self, noise: &NoiseSummary) {
        self.summary.measured(noise);
    }

    /// The verdict of a run that is over.
    pub fn judged(&mut self, ending: &Ending) -> Colour {
        self.summary.judged(Status::of(ending), ending)
    }

    /// Largest strain or stress over the allowable one so far [1]; none without an allowable one.
    pub fn utilisation(&self) -> Option<f64> {
        self.summary.utilisation()
    }

    /// Converged increments so far.
    pub fn increments(&self) -> usize {
        self.summary.curves().0.times.len()
    }

    /// What is driven, in the order of the model, each `node`, `who`, `motion` and `reaction`; none
    /// where nothing is shown.
    pub fn driven(&self) -> Option<Value> {
        self.live.as_ref().map(Live::driven)
    }

    /// Motion and reaction of what is driven, in the same order, after the last increment: those
    /// of `JOB.history.csv`, reactions of several nodes added up.
    pub fn row(&self) -> Vec<[f64; 2]> {
        self.live.as_ref().map(|live| live.row(&self.summary)).unwrap_or_default()
    }

    /// What the report draws, as JSON, once a run has begun; none where nothing is shown.
    pub fn start(&self) -> Option<String> {
        self.live.as_ref().map(Live::start)
    }

    /// The state of the last increment as the report draws it; none where nothing is shown, or
    /// where a large model leaves states out.
    pub fn state(&self, frame: &Frame<'_>) -> Option<Value> {
        self.live.as_ref()?.state(frame, self.increments())
    }

    /// What the report says of a run that is over; none where nothing is shown.
    pub fn told(&mut self, ending: &Ending) -> Option<Told> {
        let object = self.summary.ended(Status::of(ending), ending);
        Some(self.live.as_mut()?.end(object, &self.summary))
    }

    /// The report of a run that was [`told`](Self::told) to be over; none where nothing is shown.
    pub fn page(&self, job: &str, options: &Options<'_>) -> Option<String> {
        Some(self.live.as_ref()?.page(job, options))
    }
}
