//! The verdict of a run without files.

use crate::version::VERSION;
use slideline_advice::Noise;
use slideline_diag::{Diagnostic, Sources};
use slideline_measures::Colour;
use slideline_model::Model;
use slideline_output::report::Told;
use slideline_output::{Facts, Formats, Records, dropped_friction};
use slideline_solve::observe::{Ending, Event, Observer, Stop};
use std::ops::ControlFlow;

/// Watches a run and judges it as `JOB.json` would.
pub struct Judge<'a> {
    records: Records<'a>,
    noise: Noise,
    model: &'a Model,
    dropped_work: f64,
    colour: Option<Colour>,
    told: Option<Told>,
}

fn facts<'a>(
    model: &Model,
    (said, sources): (&'a [Diagnostic], &'a Sources),
    deck_hash: &'a str,
) -> Facts<'a> {
    Facts {
        version: VERSION,
        deck_hash,
        sources,
        diagnostics: said,
        dialect: Some(model.dialect),
        friction_onset: Some(model.friction_onset),
        formats: Formats::default(),
        own_texts: 0,
        parameters: &[],
        sensitivities: &[],
        earlier: None,
    }
}

impl<'a> Judge<'a> {
    /// One for a run of a model. `said`: what was said about the model before, such as by reading
    /// and by [`objections`]; it counts as warnings and advice do.
    pub fn new(model: &'a Model, (said, sources): (&'a [Diagnostic], &'a Sources)) -> Self {
        Self::with(model, Records::new(facts(model, (said, sources), "")))
    }

    /// The same for a job of that name, whose report is shown while it runs. `deck_hash`: that of
    /// its text. `shapes`: whether states are drawn.
    pub fn showing(
        model: &'a Model,
        said: (&'a [Diagnostic], &'a Sources),
        (job, deck_hash, shapes): (&str, &'a str, bool),
    ) -> Self {
        Self::with(model, Records::shown(job, facts(model, said, deck_hash), shapes))
    }

    fn with(model: &'a Model, records: Records<'a>) -> Self {
        let (told, noise) = (None, Noise::of(model));
        Self { records, noise, model, dropped_work: 0.0, colour: None, told }
    }

    /// What is known so far.
    pub fn records(&self) -> &Records<'a> {
        &self.records
    }

    /// What the report says at the end of a run that is shown.
    pub fn told(&self) -> Option<&Told> {
        self.told.as_ref()
    }

    /// The verdict; none before the end of the run.
    pub fn colour(&self) -> Option<Colour> {
        self.colour
    }

    /// Largest strain or stress over the allowable one so far [1]; none without an allowable one.
    pub fn utilisation(&self) -> Option<f64> {
        self.records.utilisation()
    }

    /// What can only be said at the end, and the verdict.
    fn close(&mut self, ending: &Ending) {
        let totals = match ending {
            Ending::Completed(totals)
            | Ending::NotConverged(totals, _)
            | Ending::Stopped(totals, _) => totals,
        };
        let points = totals.dropped_points;
        let dropped = dropped_friction(self.model.friction_onset, points, self.dropped_work);
        let noise = self.noise.summary();
        self.records.measured(&noise);
        for said in dropped.into_iter().chain(self.noise.findings(&noise)) {
            self.records.watch(&Event::Diagnosed(&said));
        }
        self.colour = Some(self.records.judged(ending));
        self.told = self.records.told(ending);
    }
}

impl Observer for Judge<'_> {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        self.noise.watch(&event);
        match event {
            Event::Committed(frame) => self.dropped_work = frame.energy.dropped_friction,
            Event::End(ending) => self.close(ending),
            _ => {}
        }
        self.records.watch(&event);
        ControlFlow::Continue(())
    }
}

/// What the adviser says about a model, without edits of a deck.
pub fn objections(model: &Model) -> Vec<Diagnostic> {
    slideline_advice::advise(model).into_iter().map(|finding| finding.diagnostic).collect()
}
