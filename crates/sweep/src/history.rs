//! Curves of a run, kept while it runs.

use crate::curve::{Curve, Source};
use crate::expression::{Count, Measure};
use slideline::observe::{Frame, Sensitivity};
use slideline::{Colour, Event, Judge, Model, Observer, Stop};
use slideline_measures::{maximum, peaks, roughness, work};
use std::ops::{ControlFlow, Range};

/// By what share of the analysis a time may lie beyond its end and still be it [1].
pub(crate) const AT_END: f64 = 1e-9;

/// Curves of one run, and room for those of the next.
#[derive(Default)]
pub(crate) struct History {
    sources: Vec<Source>,
    curves: Vec<Vec<f64>>,
    times: Vec<f64>,
    /// Rows where steps end, past the last one.
    ends: Vec<usize>,
    /// Derivatives of the curves by every parameter, row by row; not a number where there is none.
    rates: Vec<Vec<Vec<f64>>>,
    iterations: usize,
    cutbacks: usize,
    /// The largest strain of plane beams, with its row and the place of its beam.
    fibre_strain: Option<(f64, usize, usize)>,
    /// Its derivatives by every parameter.
    strain_rates: Vec<f64>,
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
        self.rates.clear();
        self.strain_rates.clear();
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
        let (row, known) = (self.times.len(), self.fibre_strain);
        self.times.push(frame.total_time);
        for (place, beam) in frame.beams.iter().enumerate() {
            if self.fibre_strain.is_none_or(|(most, ..)| beam.fibre_strain > most) {
                self.fibre_strain = Some((beam.fibre_strain, row, place));
            }
        }
        if self.fibre_strain != known {
            self.strain_rates.fill(f64::NAN);
        }
    }

    /// Prepares for derivatives by so many parameters.
    pub fn differentiate(&mut self, parameters: usize) {
        self.rates.resize(parameters, vec![Vec::new(); self.curves.len()]);
        self.strain_rates.resize(parameters, f64::NAN);
    }

    /// Takes how the last row follows a parameter.
    fn take_rates(&mut self, parameter: usize, told: &Sensitivity<'_>) {
        let Some(rates) = self.rates.get_mut(parameter) else { return };
        let row = self.times.len() - 1;
        for (source, rates) in self.sources.iter().zip(rates) {
            rates.resize(row, f64::NAN);
            rates.push(told.of(|frame| source.value(frame)));
        }
        if let Some((_, strained, place)) = self.fibre_strain
            && strained == row
        {
            self.strain_rates[parameter] = told.of(|frame| frame.beams[place].fibre_strain);
        }
    }

    /// Derivatives of a curve by a parameter at some rows. The start of a run depends on nothing.
    fn rates(&self, curve: usize, parameter: usize, rows: Range<usize>) -> Option<Vec<f64>> {
        let own = self.rates.get(parameter)?.get(curve)?;
        let rate = |row: usize| match row {
            0 => 0.0,
            row => own.get(row).copied().unwrap_or(f64::NAN),
        };
        Some(rows.map(rate).collect())
    }

    /// The derivative of a measure by a parameter: that of the value which is measured.
    pub fn rate_measured(
        &self,
        measure: Measure,
        curve: usize,
        step: Option<usize>,
        parameter: usize,
    ) -> Option<f64> {
        let rows = self.rows(step)?;
        let (values, rates) =
            (&self.curves[curve][rows.clone()], self.rates(curve, parameter, rows)?);
        let first = |better: fn(f64, f64) -> bool| {
            let each = values.iter().enumerate().filter(|(_, own)| !own.is_nan());
            each.reduce(|best, own| if better(*own.1, *best.1) { own } else { best })
        };
        let (row, way) = match measure {
            Measure::Max => (first(|a, b| a > b)?.0, 1.0),
            Measure::Min => (first(|a, b| a < b)?.0, 1.0),
            Measure::Peak => {
                let (row, value) = first(|a, b| a.abs() > b.abs())?;
                (row, value.signum())
            }
            Measure::Last => (values.len().checked_sub(1)?, 1.0),
            Measure::Roughness => return None,
        };
        Some(way * rates[row])
    }

    /// The derivative of a value at a total time.
    pub fn rate_at(&self, curve: usize, time: f64, parameter: usize) -> Option<f64> {
        let time = self.at_end(time);
        let after = self.times.partition_point(|&own| own < time);
        let end = *self.times.get(after)?;
        let Some(before) = after.checked_sub(1) else {
            return self.rates(curve, parameter, after..after + 1)?.first().copied();
        };
        let share = (time - self.times[before]) / (end - self.times[before]);
        let both = self.rates(curve, parameter, before..after + 1)?;
        Some(both[0] + share * (both[1] - both[0]))
    }

    /// The derivative of a work, which is linear in force and motion.
    pub fn rate_of_work(
        &self,
        [force, motion]: [usize; 2],
        step: Option<usize>,
        parameter: usize,
    ) -> Option<f64> {
        let rows = self.rows(step)?;
        let by_force = self.rates(force, parameter, rows.clone())?;
        let by_motion = self.rates(motion, parameter, rows.clone())?;
        let [force, motion] = [force, motion].map(|curve| &self.curves[curve][rows.clone()]);
        Some(work(&by_force, motion)? + work(force, &by_motion)?)
    }

    /// The derivative of the largest strain: that of the beam and the increment that have it.
    pub fn rate_counted(&self, count: Count, parameter: usize) -> Option<f64> {
        match count {
            Count::FibreStrain => self.strain_rates.get(parameter).copied(),
            _ => None,
        }
    }

    /// A total time, which is that of the last row where rounding lies between them.
    fn at_end(&self, time: f64) -> f64 {
        let last = self.times.last().copied().unwrap_or(0.0);
        if time <= last * (1.0 + AT_END) { time.min(last) } else { time }
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
        let time = self.at_end(time);
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
            Count::FibreStrain => self.fibre_strain.map(|(most, ..)| most),
            Count::Utilisation => self.utilisation,
            Count::StrainMargin => self.utilisation.map(|used| 1.0 / used - 1.0),
            Count::Verdict => self.colour.map(|colour| f64::from(colour as u8)),
        }
    }
}

/// Watches a run for a history.
pub(crate) struct Watch<'a> {
    pub history: &'a mut History,
    /// Which parameter each of those is that the run is differentiated by.
    pub by: &'a [usize],
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
            Event::Sensitivity(told) => {
                if let Some(&parameter) = self.by.get(told.parameter) {
                    self.history.take_rates(parameter, told);
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
