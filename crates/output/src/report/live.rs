//! What a report shows, collected while a run goes on: no file is read or written.
//!
//! ```text
//!   events --> Results --+--> data at the start, a state for each increment
//!                        `--> at the end: verdict in words, key figures, the page
//! ```

use super::contact::{Contacts, Places};
use super::data::{data, state};
use super::iterations::iterated;
use super::options::Options;
use super::page::page;
use super::results::Results;
use super::verdict::{headline, judged, sentences, tiles};
use crate::echo::model_echo;
use crate::json::{Value, json};
use crate::msg::given_up;
use crate::reading::summary::{Driven, driven, loaded};
use crate::summary::Summary;
use crate::verdict::attached;
use crate::vtu::Grid;
use slideline_measures::Taken;
use slideline_solve::observe::{Event, Frame, StepReport};

/// Numbers of displacements that are kept of one run, and so many states at least.
const MOST: (usize, usize) = (2_000_000, 100);

/// What a report shows of a run so far.
pub(crate) struct Live {
    results: Results,
    places: Places,
    grid: Option<Grid>,
    /// Increments from one state that is kept to the next; `None`: shapes are not shown.
    stride: Option<usize>,
}

/// What a report says of a run that is over.
#[derive(Clone, Debug)]
pub struct Told {
    /// `JOB.json`.
    pub summary: Value,
    /// What the colour of the verdict means.
    pub headline: &'static str,
    /// The verdict in short sentences, as on the page.
    pub sentences: Vec<String>,
    /// Key figures as the page has them: what it is, its value, a note.
    pub tiles: Vec<[String; 3]>,
    /// Which of the driven motions does most work, in the order of the model.
    pub driven: Option<usize>,
    /// Which way it goes in: 1 or -1.
    pub inward: f64,
    /// Places of the largest push and pull in its curve, 0 for the start.
    pub places: [Option<usize>; 2],
}

/// The opening of `JOB.dat`.
fn echo(heading: String, step: &StepReport<'_>) -> String {
    let echo = model_echo(step.model, &step.start);
    format!("{heading}\n\n{}", echo.trim_end())
}

impl Live {
    /// One of a run that has not begun; with or without its shapes.
    pub fn new(shapes: bool) -> Self {
        let results = Results { contacts: Contacts::begun(), ..Results::default() };
        Self { results, places: Places::default(), grid: None, stride: shapes.then_some(1) }
    }

    /// Takes note of an event, after the summary has.
    pub fn watch(&mut self, event: &Event<'_>, summary: &Summary<'_>) {
        match event {
            Event::StepBegin(step) if self.results.frames.written.is_empty() => {
                self.begin(step, summary);
            }
            Event::Iteration(report) => iterated(&mut self.results.attempts, report),
            Event::AttemptFailed(report) => {
                if let Some(last) = self.results.attempts.last_mut() {
                    last.reason = Some(given_up(report));
                }
            }
            Event::Committed(frame) => self.follow(frame, summary),
            _ => {}
        }
    }

    fn begin(&mut self, step: &StepReport<'_>, summary: &Summary<'_>) {
        let results = &mut self.results;
        results.frames.written.push(0);
        results.summary = summary.running();
        results.driven = driven(&results.summary);
        results.loaded = loaded(&results.summary);
        results.echo = echo(summary.heading(), step);
        results.history = summary.curves().1.clone();
        results.energies = summary.curves().0.clone();
        if self.stride.is_none() {
            return;
        }
        let grid = Grid::new(step.model);
        for number in 1..=step.model.steps.len() {
            if let Some(there) = grid.presence(step.model, number) {
                results.frames.change(there.into_iter().map(|own| own != 0).collect());
            }
        }
        let start = grid.drawn_whole(&step.start);
        // arrays of ours fit one another
        let _ = results.frames.topology(&start);
        let _ = results.frames.add(&start, 0);
        let numbers = results.frames.reference.len() + results.frames.depth.len();
        let expected = (MOST.0 / numbers.max(1)).max(MOST.1);
        let most = step.model.steps.iter().map(|step| step.max_increments).sum::<usize>();
        self.stride = Some(most / expected + 1);
        self.grid = Some(grid);
    }

    fn follow(&mut self, frame: &Frame<'_>, summary: &Summary<'_>) {
        let Some(stride) = self.stride else { return };
        let results = &mut self.results;
        let place = summary.curves().0.times.len();
        results.contacts.follow(&mut self.places, place.saturating_sub(1), frame);
        let due = place.is_multiple_of(stride) || frame.last_of_step;
        if let Some(grid) = self.grid.as_ref().filter(|_| due) {
            // as above
            let _ = results.frames.add(&grid.drawn(frame), place);
            results.frames.written.push(place);
        }
    }

    /// What is driven, in the order of the model: node, its name in words, motion, reaction.
    pub fn driven(&self) -> Value {
        let own = self.results.driven.iter().map(|own| {
            json!({
                "node": own.nodes.first(),
                "who": own.words(),
                "motion": own.motion,
                "reaction": own.reaction,
            })
        });
        own.collect()
    }

    /// Motion and reaction of what is driven, in the same order, after the last increment.
    pub fn row(&self, summary: &Summary<'_>) -> Vec<[f64; 2]> {
        let history = summary.curves().1;
        let last = |node, name: &str| history.column(node, name).and_then(<[f64]>::last).copied();
        let row = |own: &Driven| {
            if !own.along.is_empty() {
                let stroke = history.stroke(own).unwrap_or_default();
                return stroke.map(|own| own.last().copied().unwrap_or(0.0));
            }
            let reactions = own.nodes.iter().filter_map(|&node| last(node, &own.reaction));
            let motion = own.nodes.first().and_then(|&node| last(node, &own.motion));
            // added up as the report adds them
            [motion.unwrap_or(0.0), reactions.fold(0.0, |sum, own| sum + own)]
        };
        self.results.driven.iter().map(row).collect()
    }

    /// What the page of the report draws, as it stands at the start.
    pub fn start(&self) -> String {
        let results = &self.results;
        data("", results, &judged(results), None)
    }

    /// The state of an increment that was followed; `None`: it is not kept.
    pub fn state(&self, frame: &Frame<'_>, increments: usize) -> Option<Value> {
        let kept = self.results.frames.states.last() == Some(&increments);
        kept.then(|| state(&self.results, frame))
    }

    /// Takes in what stands in the summary of a run that is over.
    pub fn end(&mut self, object: Value, summary: &Summary<'_>) -> Told {
        let (energies, history) = summary.curves();
        let results = &mut self.results;
        results.summary = attached(object, energies, history);
        (results.energies, results.history) = (energies.clone(), history.clone());
        results.contacts.over(energies.times.len());
        let judged = judged(results);
        let stroke = judged.strokes.first().map(|(_, own)| own);
        let at = |taken: Option<Taken>| taken.map(|own| own.place);
        let most = judged.strokes.first().map(|(own, _)| own);
        Told {
            summary: results.summary.clone(),
            headline: headline(judged.verdict.colour),
            sentences: sentences(results, &judged),
            tiles: tiles(results, &judged),
            driven: most.and_then(|most| results.driven.iter().position(|own| own == most)),
            inward: stroke.map_or(1.0, |own| own.inward),
            places: [at(stroke.and_then(|own| own.push)), at(stroke.and_then(|own| own.pull))],
        }
    }

    /// The page of a run that is over.
    pub fn page(&self, job: &str, options: &Options<'_>) -> String {
        page(job, &self.results, None, options, &[])
    }
}
