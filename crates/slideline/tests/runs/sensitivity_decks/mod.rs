//! Runs differentiated, and held against differences of whole runs.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::Dof;
use slideline::observe::Frame;
use slideline::{
    Event, Job, Observer, Parameter, Parametric, Plan, ReadOptions, SolveOptions, Stop, Workspace,
    keywords::Setting,
};
use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Part of a response that a change of a parameter by its own size changes, below which the response
/// counts as independent [1].
const LEAST: f64 = 1e-3;

/// A response of a frame.
pub type Response = fn(&Frame<'_>) -> f64;

/// What was seen of a run: a row an increment, a column a response; and likewise their derivatives
/// by each parameter.
#[derive(Default)]
pub struct Seen {
    pub responses: Vec<Response>,
    pub rows: Vec<Vec<f64>>,
    pub times: Vec<f64>,
    pub rates: Vec<Vec<Vec<f64>>>,
    pub one_sided: Vec<Vec<bool>>,
    /// How many models of every parameter were asked for.
    pub models: Vec<usize>,
}

impl Observer for Seen {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::Committed(frame) => {
                self.rows.push(self.responses.iter().map(|of| of(frame)).collect());
                self.times.push(frame.total_time);
            }
            Event::Sensitivity(told) => {
                let own = self.responses.iter().map(|of| told.of(of)).collect();
                self.rates.resize(self.rates.len().max(told.parameter + 1), Vec::new());
                self.one_sided.resize(self.rates.len(), Vec::new());
                self.rates[told.parameter].push(own);
                self.one_sided[told.parameter].push(told.one_sided);
            }
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

/// A deck whose parameters are varied.
pub struct Varied {
    deck: Parametric,
    names: Vec<&'static str>,
    values: Vec<f64>,
    responses: Vec<Response>,
}

impl Varied {
    pub fn new(text: &str, parameters: &[(&'static str, f64)], responses: &[Response]) -> Self {
        let read = Job::read_text("varied", text, &ReadOptions::default());
        assert!(read.model.is_some(), "{:?}", read.diagnostics);
        let deck = Parametric::of(&read).unwrap();
        let (names, values) = parameters.iter().copied().unzip();
        Self { deck, names, values, responses: responses.to_vec() }
    }

    fn settings(&self, changed: usize, value: f64) -> Vec<Setting> {
        let all = self.names.iter().zip(&self.values).enumerate();
        all.map(|(k, (name, own))| {
            let value = if k == changed { value } else { *own };
            Setting { name: (*name).to_owned(), value: format!("{value:e}"), span: None }
        })
        .collect()
    }

    /// The run at its own values, differentiated.
    pub fn differentiated(&self) -> Seen {
        let model = self.deck.model(&self.settings(0, self.values[0])).unwrap();
        let asked: Vec<_> = self.names.iter().map(|_| Arc::new(AtomicUsize::new(0))).collect();
        let parameters: Vec<Parameter> = (0..self.names.len())
            .map(|k| {
                let (deck, settings) = (self.deck.clone(), self.settings(k, self.values[k]));
                let asked = Arc::clone(&asked[k]);
                let model = move |value: f64| {
                    asked.fetch_add(1, Ordering::Relaxed);
                    let mut own = settings.clone();
                    own[k].value = format!("{value:e}");
                    deck.model(&own).ok()
                };
                Parameter {
                    name: self.names[k].to_owned(),
                    value: self.values[k],
                    scale: self.values[k].abs(),
                    model: Arc::new(model),
                }
            })
            .collect();
        let mut seen = Seen { responses: self.responses.clone(), ..Seen::default() };
        let mut workspace = Workspace::new(&Plan::of(&model), &SolveOptions::default());
        let (varied, faults) = workspace.varied(&model, &parameters).unwrap();
        assert!(faults.is_empty(), "{faults:?}");
        let ending = workspace.run_varied(&model, varied, &mut seen).unwrap();
        assert!(matches!(ending, slideline::observe::Ending::Completed(_)), "{ending:?}");
        assert_eq!(seen.rates.len(), self.names.len());
        seen.models = asked.iter().map(|own| own.load(Ordering::Relaxed)).collect();
        seen
    }

    fn plain(&self, changed: usize, value: f64) -> Seen {
        let model = self.deck.model(&self.settings(changed, value)).unwrap();
        let mut seen = Seen { responses: self.responses.clone(), ..Seen::default() };
        slideline::solve(&model, &SolveOptions::default(), &mut seen);
        seen
    }

    /// The derivatives of all responses by one parameter, by differences of whole runs with four
    /// neighbours at `step` of the value.
    pub fn differences(&self, parameter: usize, step: f64) -> Vec<Vec<f64>> {
        let value = self.values[parameter];
        let h = step * value;
        let runs = [-2.0, -1.0, 1.0, 2.0].map(|k| self.plain(parameter, value + k * h));
        let same = runs.iter().all(|run| run.times.len() == runs[0].times.len());
        assert!(same, "the increments of {} differ", self.names[parameter]);
        (0..runs[0].rows.len())
            .map(|row| {
                (0..self.responses.len())
                    .map(|of| {
                        let [a, b, c, d] = runs.each_ref().map(|run| run.rows[row][of]);
                        (a - 8.0 * b + 8.0 * c - d) / (12.0 * h)
                    })
                    .collect()
            })
            .collect()
    }

    /// Holds all derivatives against differences: no further apart than `tolerance` of the largest
    /// of the response.
    pub fn check(&self, steps: &[f64], tolerance: f64) -> Seen {
        let seen = self.differentiated();
        let plain = self.plain(0, self.values[0]);
        assert_eq!(seen.rows, plain.rows, "the run itself has other bits");
        let mut wrong = String::new();
        for (k, name) in self.names.iter().enumerate() {
            let differences = self.differences(k, steps[k.min(steps.len() - 1)]);
            assert_eq!(seen.rates[k].len(), differences.len());
            for of in 0..self.responses.len() {
                let largest =
                    differences.iter().fold(0.0, |most: f64, row| most.max(row[of].abs()));
                let size = seen.rows.iter().fold(0.0, |most: f64, row| most.max(row[of].abs()));
                // what does not depend on a parameter has a derivative of rounding
                let largest = largest.max(LEAST * size / self.values[k].abs());
                let mut off = (0.0, 0);
                for (row, (own, by)) in seen.rates[k].iter().zip(&differences).enumerate() {
                    let apart = (own[of] - by[of]).abs() / largest.max(f64::MIN_POSITIVE);
                    if apart > off.0 || apart.is_nan() {
                        off = (apart, row);
                    }
                }
                let sides = seen.one_sided[k].iter().filter(|one| **one).count();
                let (own, by) = (seen.rates[k][off.1][of], differences[off.1][of]);
                let line = format!(
                    "{name}, response {of}: {:.1e} in increment {} ({own:.9e}, {by:.9e}; largest \
                     {largest:.3e}; {sides} of {} on one side)\n",
                    off.0,
                    off.1 + 1,
                    differences.len(),
                );
                print!("{line}");
                if off.0 > tolerance || off.0.is_nan() {
                    wrong += &line;
                }
            }
        }
        assert!(wrong.is_empty(), "\n{wrong}");
        seen
    }
}

/// A motion or reaction of a node.
pub fn motion(frame: &Frame<'_>, label: u64, dof: Dof) -> f64 {
    frame.nodal.displacement(frame.model.nodes.find(label).unwrap(), dof)
}

pub fn reaction(frame: &Frame<'_>, label: u64, dof: Dof) -> f64 {
    frame.nodal.reaction(frame.model.nodes.find(label).unwrap(), dof)
}
