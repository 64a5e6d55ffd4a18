//! Studies and evaluations at points that others choose.

use crate::arrays::shaped;
use crate::arrays::values;
use crate::deck::Deck;
use crate::diagnosis::Diagnosis;
use crate::table::{Table, Values};
use numpy::PyArrayDyn;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use slideline::Diagnostic;
use slideline::diag::Sources;
use slideline_sweep::{Failure, Number, Row, StudyFile, SweepOptions};
use std::ops::Range;
use std::path::PathBuf;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::Duration;

/// How often signals are looked for.
const PAUSE: Duration = Duration::from_millis(20);

/// Either what was asked for, or what stands against it.
type Found<T> = (Option<T>, Vec<Diagnosis>);

fn refused<T>(said: &[Diagnostic], sources: &Sources) -> Found<T> {
    (None, Diagnosis::all(said, sources))
}

/// Works on a thread of its own while this one looks for signals, and asks for an end where one
/// comes: `work` is told how to find out. Says in the end what was raised.
fn interruptible<T: Send>(
    py: Python<'_>,
    told: impl Fn(Python<'_>) -> PyResult<()>,
    work: impl FnOnce(&(dyn Fn() -> bool + Sync)) -> T + Send,
) -> PyResult<T> {
    let stop = AtomicBool::new(false);
    let stops = || stop.load(Ordering::Relaxed);
    std::thread::scope(|scope| {
        let worker = scope.spawn(|| work(&stops));
        let mut raised = None;
        while !worker.is_finished() {
            py.detach(|| park(&worker));
            if let Err(why) = py.check_signals().and_then(|()| told(py)) {
                stop.store(true, Ordering::Relaxed);
                raised.get_or_insert(why);
            }
        }
        let found = py.detach(|| worker.join());
        match (found, raised) {
            (_, Some(raised)) => Err(raised),
            (Ok(found), None) => Ok(found),
            (Err(fault), None) => std::panic::resume_unwind(fault),
        }
    })
}

/// Waits a little; for what is done soon, less.
fn park<T>(worker: &std::thread::ScopedJoinHandle<'_, T>) {
    let mut waited = Duration::from_micros(50);
    let mut all = Duration::ZERO;
    while all < PAUSE && !worker.is_finished() {
        std::thread::sleep(waited);
        all += waited;
        waited *= 2;
    }
}

/// Responses of points, their derivatives, and the codes of what stands against the points.
type Differentiated = (Py<PyArrayDyn<f64>>, Py<PyArrayDyn<f64>>, Vec<Option<String>>);

/// Responses of points, and the codes of what stands against them.
type Evaluated = (Py<PyArrayDyn<f64>>, Vec<Option<String>>);

/// A deck whose responses can be asked for at any values of its parameters.
#[pyclass(frozen, module = "slideline._core")]
pub(crate) struct Evaluator {
    evaluator: slideline_sweep::Evaluator,
    whole: Vec<bool>,
    responses: usize,
}

/// An evaluator of a deck, or what stands against it. `whole` says of every parameter whether it
/// is a whole number, such as a number of elements.
#[pyfunction]
pub(crate) fn evaluator(
    deck: &Deck,
    parameters: Vec<String>,
    whole: Vec<bool>,
    responses: Vec<(String, String)>,
) -> Found<Evaluator> {
    let mut sources = deck.read.sources.clone();
    let count = responses.len();
    let made = slideline_sweep::Evaluator::new(&deck.read, &parameters, &responses, &mut sources);
    match made {
        Ok(evaluator) => (Some(Evaluator { evaluator, whole, responses: count }), Vec::new()),
        Err(said) => refused(&said, &sources),
    }
}

#[pymethods]
impl Evaluator {
    /// Responses (points, responses) at values of the parameters (points, parameters), not a number
    /// where there are none; and the codes of what stands against points.
    fn evaluate(
        &self,
        py: Python<'_>,
        points: &Bound<'_, PyAny>,
        threads: usize,
    ) -> PyResult<Evaluated> {
        let rows = self.rows(py, &values(points, "X")?, threads, false)?;
        let found = numbers(&rows, 0..self.responses);
        let codes = rows.iter().map(|row| row.code.clone()).collect();
        Ok((shaped(py, &[rows.len(), self.responses], found)?, codes))
    }

    /// Responses (points, responses), their derivatives (points, responses, parameters) at values of
    /// the parameters, and the codes of what stands against points.
    fn jacobian(
        &self,
        py: Python<'_>,
        points: &Bound<'_, PyAny>,
        threads: usize,
    ) -> PyResult<Differentiated> {
        let rows = self.rows(py, &values(points, "X")?, threads, true)?;
        let (count, all) = (self.responses, self.responses * (1 + self.whole.len()));
        let (found, rates) = (numbers(&rows, 0..count), numbers(&rows, count..all));
        let codes = rows.iter().map(|row| row.code.clone()).collect();
        let shape = [rows.len(), self.responses, self.whole.len()];
        Ok((shaped(py, &shape[..2], found)?, shaped(py, &shape, rates)?, codes))
    }
}

impl Evaluator {
    /// The rows of points, with derivatives or without.
    fn rows(
        &self,
        py: Python<'_>,
        points: &[f64],
        threads: usize,
        differentiated: bool,
    ) -> PyResult<Vec<Row>> {
        let points: Vec<Vec<Number>> =
            points.chunks_exact(self.whole.len()).map(|point| self.point(point)).collect();
        interruptible(
            py,
            |_| Ok(()),
            |stops| match differentiated {
                true => self.evaluator.differentiate(&points, threads, stops),
                false => self.evaluator.evaluate(&points, threads, stops),
            },
        )
    }

    fn point(&self, values: &[f64]) -> Vec<Number> {
        values.iter().zip(&self.whole).map(|(&value, &whole)| number(value, whole)).collect()
    }
}

/// Some of the responses of all rows, not a number where there are none.
fn numbers(rows: &[Row], places: Range<usize>) -> Vec<f64> {
    let found = rows.iter().flat_map(|row| &row.responses[places.clone()]);
    found.map(|value| value.unwrap_or(f64::NAN)).collect()
}

#[allow(clippy::cast_possible_truncation)] // rounded, and clipped by the cast
fn number(value: f64, whole: bool) -> Number {
    if whole { Number::Whole(value.round() as i64) } else { Number::Real(value) }
}

/// A study that was read.
#[pyclass(frozen, module = "slideline._core")]
pub(crate) struct Study {
    study: StudyFile,
    sources: Mutex<Sources>,
}

/// Reads the text of a study as if it stood at a path, or says what stands against it.
#[pyfunction]
pub(crate) fn read_study(path: PathBuf, text: &str) -> Found<Study> {
    let mut sources = Sources::default();
    match slideline_sweep::read_study_text(&path, text, &mut sources) {
        Ok(study) => (Some(Study { study, sources: Mutex::new(sources) }), Vec::new()),
        Err(said) => refused(&said, &sources),
    }
}

#[pymethods]
impl Study {
    /// Number of cases.
    #[getter]
    fn cases(&self) -> u64 {
        self.study.study.cases()
    }

    /// The deck.
    #[getter]
    fn deck(&self) -> String {
        self.study.deck.display().to_string()
    }

    /// Names of the parameters.
    #[getter]
    fn parameters(&self) -> Vec<String> {
        self.study.parameters.iter().map(|(name, _)| name.clone()).collect()
    }

    /// Names of the responses.
    #[getter]
    fn responses(&self) -> Vec<String> {
        self.study.responses.clone()
    }

    /// Runs the cases from `begin` up to `end` without files: their rows, or what stands against the
    /// study. `told` is called with the number of cases done.
    #[pyo3(signature = (begin, end, threads, told=None))]
    fn run(
        &self,
        py: Python<'_>,
        begin: u64,
        end: u64,
        threads: usize,
        told: Option<Py<PyAny>>,
    ) -> PyResult<Found<Table>> {
        let mut sources = self.sources()?;
        let deck = match slideline_sweep::prepared(&self.study, &mut sources) {
            Ok((deck, _)) => deck,
            Err(failure) => return Ok(failed(failure, &sources)),
        };
        let done = AtomicU64::new(0);
        let all = end.min(self.cases()).saturating_sub(begin);
        let rows = interruptible(
            py,
            |py| tell(py, told.as_ref(), &done, all),
            |stops| {
                let count = |_| {
                    done.fetch_add(1, Ordering::Relaxed);
                };
                let study = &self.study.study;
                slideline_sweep::run(study, &deck, begin..end, threads, (&count, stops))
            },
        )?;
        Ok((Some(self.table(py, &rows)?), Vec::new()))
    }

    /// Runs the cases that are not in a folder yet, those of one part of its shards, and returns
    /// all rows that are there.
    #[pyo3(signature = (folder, threads, part=(0, 1), told=None))]
    fn run_in(
        &self,
        py: Python<'_>,
        folder: PathBuf,
        threads: usize,
        part: (u64, u64),
        told: Option<Py<PyAny>>,
    ) -> PyResult<Found<Table>> {
        if part.0 >= part.1 {
            return Err(PyValueError::new_err("part is (i, n) with i below n"));
        }
        let mut sources = self.sources()?;
        let options = SweepOptions { folder: folder.clone(), threads, part, csv: false };
        let (done, all) = (AtomicU64::new(0), AtomicU64::new(0));
        let tells = |py: Python<'_>| tell(py, told.as_ref(), &done, all.load(Ordering::Relaxed));
        let study = &self.study;
        let ended = interruptible(py, tells, |stops| {
            let count = |_: u64, of: u64| {
                done.fetch_add(1, Ordering::Relaxed);
                all.store(of, Ordering::Relaxed);
            };
            let mut texts = sources.clone();
            let outcome = slideline_sweep::sweep(study, &mut texts, &options, &count, stops)
                .and_then(|outcome| {
                    slideline_sweep::rows(study, &mut texts, &folder).map(|rows| (outcome, rows))
                });
            (outcome, texts)
        })?;
        sources = ended.1;
        match ended.0 {
            Ok((outcome, rows)) => {
                let said = Diagnosis::all(&outcome.said, &sources);
                Ok((Some(self.table(py, &rows)?), said))
            }
            Err(failure) => Ok(failed(failure, &sources)),
        }
    }
}

impl Study {
    /// A copy, so that calls from several threads do not wait for one another.
    fn sources(&self) -> PyResult<Sources> {
        let sources = self.sources.lock().map_err(|_| PyValueError::new_err("a thread failed"))?;
        Ok(sources.clone())
    }

    fn table(&self, py: Python<'_>, rows: &[Row]) -> PyResult<Table> {
        let cases = rows.iter().map(|row| row.case.cast_signed()).collect();
        let mut columns = vec![("case".to_owned(), Values::Whole(cases))];
        for (place, (name, _)) in self.study.parameters.iter().enumerate() {
            let values = rows.iter().map(|row| row.values[place]).collect();
            columns.push((name.clone(), Values::Real(values)));
        }
        for (place, name) in self.study.responses.iter().enumerate() {
            let values = rows.iter().map(|row| row.responses[place].unwrap_or(f64::NAN)).collect();
            columns.push((name.clone(), Values::Real(values)));
        }
        let codes = rows.iter().map(|row| row.code.clone()).collect();
        columns.push(("code".to_owned(), Values::Word(codes)));
        Table::new(py, columns)
    }
}

fn failed<T>(failure: Failure, sources: &Sources) -> Found<T> {
    match failure {
        Failure::Input(said) => refused(&said, sources),
        Failure::Output(said) => refused(&[*said], sources),
    }
}

fn tell(py: Python<'_>, told: Option<&Py<PyAny>>, done: &AtomicU64, all: u64) -> PyResult<()> {
    match told {
        Some(told) => told.call1(py, (done.load(Ordering::Relaxed), all)).map(drop),
        None => Ok(()),
    }
}
