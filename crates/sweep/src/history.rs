//! Curves of a run, kept while it runs.

use crate::expression::{Count, Curve, Measure};
use slideline::observe::Frame;
use slideline::{Event, Model, Observer, Stop};
use slideline_measures::{maximum, peaks, roughness, work};
use std::ops::{ControlFlow, Range};

/// Curves of one run, and room for those of the next.
#[derive(Default)]
pub(crate) struct History {
    nodes: Vec<usize>,
    curves: Vec<Vec<f64>>,
    times: Vec<f64>,
    /// Rows where steps end, past the last one.
    ends: Vec<usize>,
    iterations: usize,
    cutbacks: usize,
    fibre_strain: Option<f64>,
}

/// The node that a curve is of; `None`: the model has no such node or set of one node.
pub(crate) fn node_of(curve: &Curve, model: &Model) -> Option<usize> {
    if let Ok(label) = curve.node.parse() {
        return model.nodes.find(label);
    }
    let set = model.node_sets.iter().find(|set| set.name.eq_ignore_ascii_case(&curve.node))?;
    match set.members[..] {
        [node] => Some(node),
        _ => None,
    }
}

impl History {
    /// Forgets a run and prepares for one of a model; whether it has all nodes of the curves.
    pub fn begin(&mut self, curves: &[Curve], model: &Model) -> bool {
        self.nodes.clear();
        self.nodes.extend(curves.iter().map_while(|curve| node_of(curve, model)));
        self.curves.resize(curves.len(), Vec::new());
        self.curves.iter_mut().for_each(Vec::clear);
        self.times.clear();
        self.ends.clear();
        (self.iterations, self.cutbacks, self.fibre_strain) = (0, 0, None);
        self.nodes.len() == curves.len()
    }

    /// Takes a row.
    fn take(&mut self, frame: &Frame<'_>, curves: &[Curve]) {
        for ((curve, &node), values) in curves.iter().zip(&self.nodes).zip(&mut self.curves) {
            values.push(if curve.is_reaction {
                frame.nodal.reaction(node, curve.dof)
            } else {
                frame.nodal.displacement(node, curve.dof)
            });
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
        }
    }
}

/// Watches a run for a history.
pub(crate) struct Watch<'a> {
    pub history: &'a mut History,
    pub curves: &'a [Curve],
    /// Whether the user wants it to end.
    pub stops: &'a (dyn Fn() -> bool + Sync),
}

impl Observer for Watch<'_> {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::StepBegin(step) if self.history.times.is_empty() => {
                self.history.take(&step.start, self.curves);
            }
            Event::Iteration(_) => self.history.iterations += 1,
            Event::AttemptFailed(_) => self.history.cutbacks += 1,
            Event::Committed(frame) => {
                self.history.take(frame, self.curves);
                if frame.last_of_step {
                    self.history.ends.push(self.history.times.len());
                }
                if (self.stops)() {
                    return ControlFlow::Break(Stop::Interrupted);
                }
            }
            _ => {}
        }
        ControlFlow::Continue(())
    }
}
