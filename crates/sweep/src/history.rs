//! Curves of a run, kept while it runs.

use crate::curve::{Curve, Source};
use crate::expression::{Count, Measure};
use slideline::observe::Frame;
use slideline::{Colour, Event, Judge, Model, Observer, Stop};
use slideline_measures::{maximum, peaks, roughness, work};
use std::ops::{ControlFlow, Range};

/// Curves of one run, and room for those of the next.
#[derive(Default)]
pub(crate) struct History {
    sources: Vec<Source>,
    curves: Vec<Vec<f64>>,
    times: Vec<f64>,
    /// Rows where steps end, past the last one.
    ends: Vec<usize>,
    iterations: usize,
    cutbacks: usize,
    fibre_strain: Option<f64>,
    utilisation: Option<f64>,
    colour: Option<Colour>,
}

impl History {
    /// Forgets a run and prepares for one of a model; whether it has all that the curves name.
    pub fn begin(&mut self, curves: &[Curve], model: &Model) -> bool {
        self.sources.clear();
        self.sources.extend(curves.iter().map_while(|curve| curve.source(model)));
        self.curves.resize(curves.len(), Vec::new());
        self.curves.iter_mut().for_each(Vec::clear);
        self.times.clear();
        self.ends.clear();
        (self.iterations, self.cutbacks, self.fibre_strain) = (0, 0, None);
        (self.utilisation, self.colour) = (None, None);
        self.sources.len() == curves.len()
    }

    /// Takes a row.
    fn take(&mut self, frame: &Frame<'_>) {
        for (source, values) in self.sources.iter().zip(&mut self.curves) {
            values.push(source.value(frame));
        }
        self.times.push(frame.total_time);
        let strains = frame.beams.iter().map(|beam| beam.fibre_strain);
        self.fibre_strain = strains.chain(self.fibre_strain).reduce(f64::max);
    }

    /// Rows of a step, with the one in which it begins; `None`: all.
    fn rows(&self, step: Option<usize>) -> Option<Range<usize>> {
        let Some(step) = step else { return Some(0..self.times.len()) };
        let end = *self.ends.get(step - 1)?;
        let begin = if step == 1 { 0 } else { self.ends[step - 2] - 1 };
        Some(begin..end)
    }

    pub fn measured(&self, measure: Measure, curve: usize, step: Option<usize>) -> Option<f64> {
        let rows = self.rows(step)?;
        let (values, times) = (&self.curves[curve][rows.clone()], &self.times[rows]);
        match measure {
            Measure::Max => peaks(values, times).map(|own| own.max.value),
            Measure::Min => peaks(values, times).map(|own| own.min.value),
            Measure::Peak => maximum(values),
            Measure::Last => values.last().copied(),
            Measure::Roughness => roughness(values),
        }
    }

    /// Value at a total time [T], linear between increments; `None` before the first or after the
    /// last one.
    pub fn at(&self, curve: usize, time: f64) -> Option<f64> {
        let (values, after) = (&self.curves[curve], self.times.partition_point(|&own| own < time));
        let end = *self.times.get(after)?;
        let Some(before) = after.checked_sub(1) else {
            return (end <= time).then(|| values[after]);
        };
        let share = (time - self.times[before]) / (end - self.times[before]);
        Some(values[before] + share * (values[after] - values[before]))
    }

    /// Work [F L] of a force over a motion.
    pub fn work(&self, [force, motion]: [usize; 2], step: Option<usize>) -> Option<f64> {
        let rows = self.rows(step)?;
        work(&self.curves[force][rows.clone()], &self.curves[motion][rows])
    }

    #[allow(clippy::cast_precision_loss)] // counts are small
    pub fn counted(&self, count: Count) -> Option<f64> {
        match count {
            Count::Increments => Some(self.times.len().saturating_sub(1) as f64),
            Count::Iterations => Some(self.iterations as f64),
            Count::Cutbacks => Some(self.cutbacks as f64),
            Count::FibreStrain => self.fibre_strain,
            Count::Utilisation => self.utilisation,
            Count::StrainMargin => self.utilisation.map(|used| 1.0 / used - 1.0),
            Count::Verdict => self.colour.map(|colour| f64::from(colour as u8)),
        }
    }
}

/// Watches a run for a history.
pub(crate) struct Watch<'a> {
    pub history: &'a mut History,
    /// Who judges it, where a response asks for that.
    pub judge: Option<Judge<'a>>,
    /// Whether the user wants it to end.
    pub stops: &'a (dyn Fn() -> bool + Sync),
}

impl Observer for Watch<'_> {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match &event {
            Event::StepBegin(step) if self.history.times.is_empty() => {
                self.history.take(&step.start);
            }
            Event::Iteration(_) => self.history.iterations += 1,
            Event::AttemptFailed(_) => self.history.cutbacks += 1,
            Event::Committed(frame) => {
                self.history.take(frame);
                if frame.last_of_step {
                    self.history.ends.push(self.history.times.len());
                }
                if (self.stops)() {
                    return ControlFlow::Break(Stop::Interrupted);
                }
            }
            _ => {}
        }
        let Some(judge) = &mut self.judge else { return ControlFlow::Continue(()) };
        let goes_on = judge.event(event);
        let found = (judge.utilisation(), judge.colour());
        (self.history.utilisation, self.history.colour) = found;
        goes_on
    }
}
