//! What `JOB.json` would say of a run, kept in memory.

use crate::facts::{Facts, Status};
use crate::job::JobFiles;
use crate::summary::Summary;
use slideline_measures::{Colour, NoiseSummary};
use slideline_solve::observe::{Ending, Event};
use std::path::Path;

/// Collects what `JOB.json` would say.
pub struct Records<'a>(Summary<'a>);

impl<'a> Records<'a> {
    /// Those of a run that has not begun.
    pub fn new(facts: Facts<'a>) -> Self {
        Self(Summary::new(&JobFiles::new(Path::new(""), "job"), facts))
    }

    /// Takes note of everything but the end.
    pub fn watch(&mut self, event: &Event<'_>) {
        self.0.watch(event);
    }

    /// Takes in the noise of the run.
    pub fn measured(&mut self, noise: &NoiseSummary) {
        self.0.measured(noise);
    }

    /// The verdict of a run that is over.
    pub fn judged(&mut self, ending: &Ending) -> Colour {
        self.0.judged(Status::of(ending), ending)
    }

    /// Largest strain or stress over the allowable one so far [1]; none without an allowable one.
    pub fn utilisation(&self) -> Option<f64> {
        self.0.utilisation()
    }
}
