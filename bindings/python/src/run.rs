//! A run and what came of it.

use crate::arrays::{line, shaped};
use crate::diagnosis::Diagnosis;
use crate::fields::{self, ElementField};
use crate::recording::Recording;
use crate::table::{Table, Values};
use crate::watch::Watch;
use numpy::{PyArray1, PyArrayDyn};
use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;
use slideline::observe::{BlockResults, Ending, Totals};
use slideline::output::report::{self, Options};
use slideline::output::{JobFiles, verdict_of};
use slideline::{Diagnostic, Event, Observer, Read, RunOptions, SolveOptions, Status, Stop};
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

/// How a run ended.
pub(crate) struct Ended {
    status: Status,
    totals: Totals,
    said: Vec<Diagnostic>,
    files: Option<JobFiles>,
    failure: Option<String>,
    seconds: f64,
}

/// Runs a deck that was read, with its files where there is a folder for them.
pub(crate) fn ended(
    read: &Read,
    folder: Option<PathBuf>,
    solve: SolveOptions,
    watch: &mut Watch,
) -> Ended {
    let began = Instant::now();
    let mut ended = match folder {
        Some(folder) => {
            let options = RunOptions { folder: Some(folder), solve, ..RunOptions::default() };
            let outcome = slideline::run(read, &options, watch);
            Ended {
                status: outcome.status,
                totals: outcome.totals,
                said: outcome.diagnostics,
                files: Some(outcome.files),
                failure: outcome.output_failure,
                seconds: 0.0,
            }
        }
        None => without_files(read, &solve, watch),
    };
    ended.seconds = began.elapsed().as_secs_f64();
    ended
}

fn without_files(read: &Read, solve: &SolveOptions, watch: &mut Watch) -> Ended {
    let refused = |said| Ended {
        status: Status::InputError,
        totals: Totals::default(),
        said,
        files: None,
        failure: None,
        seconds: 0.0,
    };
    let Some(model) = &read.model else { return refused(Vec::new()) };
    let missing = solve.user_frictions.missing(model);
    if !missing.is_empty() {
        return refused(missing);
    }
    let mut heard = Heard { watch, said: Vec::new() };
    let from = read.from.as_ref().and_then(|from| from.checkpoint.as_ref());
    let ending = match from {
        None => Some(slideline::solve(model, solve, &mut heard)),
        Some(from) => slideline::run_from(model, solve, from, &mut heard),
    };
    let Some(ending) = ending else {
        let message = "the saved state of the previous job is not one of this model";
        return refused(vec![Diagnostic::error(slideline::diag::Code("SL0708"), message)]);
    };
    let (Ending::Completed(totals) | Ending::NotConverged(totals, _) | Ending::Stopped(totals, _)) =
        &ending;
    let (status, totals) = (Status::of(&ending), *totals);
    Ended { status, totals, said: heard.said, files: None, failure: None, seconds: 0.0 }
}

/// Keeps what is said.
struct Heard<'a> {
    watch: &'a mut Watch,
    said: Vec<Diagnostic>,
}

impl Observer for Heard<'_> {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Diagnosed(said) = event {
            self.said.push(said.clone());
        }
        self.watch.event(event)
    }
}

/// Named histories of a node.
type Columns = Vec<(&'static str, Py<PyArray1<f64>>)>;

/// What came of a run. Arrays belong to it: they are handed out without copies and cannot be
/// written.
#[pyclass(frozen, module = "slideline._core")]
pub(crate) struct Run {
    read: Arc<Read>,
    ended: Ended,
    raised: Option<Py<PyAny>>,
    steps: Py<PyArray1<i64>>,
    increments: Py<PyArray1<i64>>,
    times: Py<PyArray1<f64>>,
    frames: Py<PyArray1<i64>>,
    labels: Py<PyArray1<i64>>,
    dofs: Vec<&'static str>,
    motions: Py<PyArrayDyn<f64>>,
    reactions: Py<PyArrayDyn<f64>>,
    elements: Vec<Vec<BlockResults>>,
    histories: Vec<(u64, Columns)>,
    history: Py<Table>,
    contact: Py<Table>,
    energy: Py<Table>,
}

impl Run {
    pub fn new(py: Python<'_>, read: Arc<Read>, ended: Ended, watch: Watch) -> PyResult<Self> {
        let raised = watch.failure().or(watch.raised);
        let recording = watch.recording;
        let (states, nodes, dofs) = (recording.frames.len(), recording.nodes, recording.dofs.len());
        let shape = [states, nodes, dofs];
        let history = Py::new(py, history_table(py, &recording)?)?;
        let contact = Py::new(py, contact_table(py, &recording)?)?;
        let energy = Py::new(py, energy_table(py, &recording)?)?;
        let labels = read.model.as_ref().map_or(Vec::new(), |model| {
            (0..model.nodes.len()).map(|node| model.nodes.label(node).cast_signed()).collect()
        });
        let names = recording.components.iter().map(|own| own.name());
        let mut histories = Vec::with_capacity(recording.histories.len());
        for own in recording.histories {
            let columns = own.columns.into_iter().map(|column| line(py, column));
            let columns: Vec<_> = columns.collect::<PyResult<_>>()?;
            histories.push((own.label, names.clone().zip(columns).collect()));
        }
        Ok(Self {
            read,
            ended,
            raised: raised.map(|raised| raised.into_value(py).into_any()),
            steps: line(py, recording.steps)?,
            increments: line(py, recording.increments)?,
            times: line(py, recording.times)?,
            frames: line(py, recording.frames)?,
            labels: line(py, labels)?,
            dofs: recording.dofs.iter().map(|dof| dof.name()).collect(),
            motions: shaped(py, &shape, recording.motions)?,
            reactions: shaped(py, &shape, recording.reactions)?,
            elements: recording.elements,
            histories,
            history,
            contact,
            energy,
        })
    }
}

/// Step, increment and time of states, as columns.
fn states(recording: &Recording, places: &[usize]) -> Vec<(String, Values)> {
    let whole = |values: &[i64]| Values::Whole(places.iter().map(|&own| values[own]).collect());
    vec![
        ("step".into(), whole(&recording.steps)),
        ("increment".into(), whole(&recording.increments)),
        ("time".into(), Values::Real(places.iter().map(|&own| recording.times[own]).collect())),
    ]
}

/// That of JOB.history.csv: no row of the start.
fn history_table(py: Python<'_>, recording: &Recording) -> PyResult<Table> {
    let nodes = recording.histories.len();
    let rows = || (1..recording.times.len()).flat_map(|state| (0..nodes).map(move |k| (state, k)));
    let places: Vec<usize> = rows().map(|(state, _)| state).collect();
    let mut columns = states(recording, &places);
    let labels = rows().map(|(_, k)| recording.histories[k].label.cast_signed()).collect();
    columns.push(("node".into(), Values::Whole(labels)));
    for (place, own) in recording.components.iter().enumerate() {
        let value = |(state, k): (usize, usize)| recording.histories[k].columns[place][state];
        columns.push((own.name().into(), Values::Real(rows().map(value).collect())));
    }
    Table::new(py, columns)
}

/// That of JOB.contact.csv, with rows of the start where points are closed there.
fn contact_table(py: Python<'_>, recording: &Recording) -> PyResult<Table> {
    let rows = &recording.contact;
    let words = |list: &[&str]| Values::Word(list.iter().map(|own| Some((*own).into())).collect());
    let mut columns = states(recording, &rows.states);
    columns.push(("pair".into(), Values::Word(rows.pairs.iter().cloned().map(Some).collect())));
    columns.push(("node".into(), Values::Whole(rows.nodes.clone())));
    columns.push(("status".into(), words(&rows.statuses)));
    let friction = columns.len() + rows.before;
    for (name, values) in rows.names.iter().zip(&rows.values) {
        columns.push(((*name).into(), Values::Real(values.clone())));
    }
    columns.insert(friction.min(columns.len()), ("friction".into(), words(&rows.frictions)));
    Table::new(py, columns)
}

/// That of JOB.energy.csv: no row of the start.
fn energy_table(py: Python<'_>, recording: &Recording) -> PyResult<Table> {
    let places: Vec<usize> = (1..recording.times.len()).collect();
    let mut columns = states(recording, &places);
    for (name, values) in recording.energy_names.iter().zip(&recording.energy) {
        columns.push(((*name).into(), Values::Real(values.iter().skip(1).copied().collect())));
    }
    Table::new(py, columns)
}

#[pymethods]
impl Run {
    /// `completed`, `not_converged`, `input_error`, `output_error`, `interrupted` or
    /// `internal_error`.
    #[getter]
    fn status(&self) -> &'static str {
        self.ended.status.word()
    }

    /// Converged increments of all steps.
    #[getter]
    fn increment_count(&self) -> usize {
        self.ended.totals.increments
    }

    /// Newton iterations, those of failed attempts among them.
    #[getter]
    fn iterations(&self) -> usize {
        self.ended.totals.iterations
    }

    /// Failed attempts.
    #[getter]
    fn cutbacks(&self) -> usize {
        self.ended.totals.cutbacks
    }

    /// Wall time of the run [s].
    #[getter]
    fn seconds(&self) -> f64 {
        self.ended.seconds
    }

    /// What the run had to say.
    #[getter]
    fn diagnoses(&self) -> Vec<Diagnosis> {
        Diagnosis::all(&self.ended.said, &self.read.sources)
    }

    /// Why files are incomplete; None where they are not.
    #[getter]
    fn failure(&self) -> Option<&str> {
        self.ended.failure.as_deref()
    }

    /// The exception that ended the run: of a signal, of progress or of a law.
    #[getter]
    fn raised(&self, py: Python<'_>) -> Option<Py<PyAny>> {
        self.raised.as_ref().map(|raised| raised.clone_ref(py))
    }

    /// Colour and reasons; None where no files were written.
    #[getter]
    fn verdict(&self) -> Option<(String, Vec<String>)> {
        verdict_of(self.ended.files.as_ref()?)
    }

    /// Writes JOB.html from the files of the run; its path, None where there are no files.
    fn write_report(&self, py: Python<'_>) -> PyResult<Option<String>> {
        let Some(files) = &self.ended.files else { return Ok(None) };
        let written = py.detach(|| report::write(files, &Options::default()));
        let written = written.map_err(|problem| PyOSError::new_err(problem.to_string()))?;
        Ok(Some(written.path.display().to_string()))
    }

    /// Step of the start and of every converged increment, (states,).
    #[getter]
    fn steps(&self, py: Python<'_>) -> Py<PyArray1<i64>> {
        self.steps.clone_ref(py)
    }

    /// Increment within its step, (states,); 0 is the start.
    #[getter]
    fn increments(&self, py: Python<'_>) -> Py<PyArray1<i64>> {
        self.increments.clone_ref(py)
    }

    /// Total time [T], (states,).
    #[getter]
    fn times(&self, py: Python<'_>) -> Py<PyArray1<f64>> {
        self.times.clone_ref(py)
    }

    /// Places in the times of the states whose fields are kept, (frames,).
    #[getter]
    fn frames(&self, py: Python<'_>) -> Py<PyArray1<i64>> {
        self.frames.clone_ref(py)
    }

    /// Labels of the nodes, (nodes,).
    #[getter]
    fn labels(&self, py: Python<'_>) -> Py<PyArray1<i64>> {
        self.labels.clone_ref(py)
    }

    /// Names of the dofs, the last index of motions and reactions.
    #[getter]
    fn dofs(&self) -> Vec<&'static str> {
        self.dofs.clone()
    }

    /// Motions [L or 1] along the axes of the model, (frames, nodes, dofs).
    #[getter]
    fn motions(&self, py: Python<'_>) -> Py<PyArrayDyn<f64>> {
        self.motions.clone_ref(py)
    }

    /// Reactions [F or F L] along the axes of the model, (frames, nodes, dofs).
    #[getter]
    fn reactions(&self, py: Python<'_>) -> Py<PyArrayDyn<f64>> {
        self.reactions.clone_ref(py)
    }

    /// Labels of the nodes that have histories, as JOB.history.csv has them.
    #[getter]
    fn history_nodes(&self) -> Vec<u64> {
        self.histories.iter().map(|(label, _)| *label).collect()
    }

    /// The history of a node, (states,); None where it has none.
    fn history_of(&self, label: u64, name: &str) -> Option<Py<PyArray1<f64>>> {
        let (_, columns) = self.histories.iter().find(|(own, _)| *own == label)?;
        let (_, found) = columns.iter().find(|(own, _)| own.eq_ignore_ascii_case(name))?;
        Some(Python::attach(|py| found.clone_ref(py)))
    }

    /// The rows of JOB.history.csv.
    #[getter]
    fn history(&self, py: Python<'_>) -> Py<Table> {
        self.history.clone_ref(py)
    }

    /// The rows of JOB.contact.csv.
    #[getter]
    fn contact(&self, py: Python<'_>) -> Py<Table> {
        self.contact.clone_ref(py)
    }

    /// The rows of JOB.energy.csv.
    #[getter]
    fn energy(&self, py: Python<'_>) -> Py<Table> {
        self.energy.clone_ref(py)
    }

    /// Names of the fields that elements offer.
    fn element_field_names(&self) -> Vec<&'static str> {
        self.read.model.as_ref().map_or(Vec::new(), fields::names)
    }

    /// A field of the elements in a frame, one entry a type and section that has it.
    fn element_fields(
        &self,
        py: Python<'_>,
        frame: usize,
        name: &str,
    ) -> PyResult<Vec<ElementField>> {
        match (&self.read.model, self.elements.get(frame)) {
            (Some(model), Some(results)) => fields::of(py, model, results, name),
            _ => Ok(Vec::new()),
        }
    }

    fn __repr__(&self) -> String {
        format!("<Run {} after {} increments>", self.status(), self.increment_count())
    }
}
