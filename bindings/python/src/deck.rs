//! A deck that was read.

use crate::arrays::shaped;
use crate::diagnosis::Diagnosis;
use crate::friction::{Failures, frictions};
use crate::options::read_options;
use crate::recording::{Keep, Recording};
use crate::run::Run;
use crate::table::Table;
use crate::watch::Watch;
use numpy::PyArrayDyn;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use slideline::{Job, Read, SolveOptions, advise, initial_gaps};
use std::path::PathBuf;
use std::sync::Arc;

/// A deck with everything that reading had to say.
#[pyclass(frozen, module = "slideline._core")]
pub(crate) struct Deck {
    pub(crate) read: Arc<Read>,
}

/// Reads the deck at a path and everything that it includes; what stands against it is among the
/// diagnoses.
#[pyfunction]
#[pyo3(signature = (path, parameters, dialect=None, friction_onset=None))]
pub(crate) fn read(
    py: Python<'_>,
    path: PathBuf,
    parameters: Vec<(String, String)>,
    dialect: Option<&str>,
    friction_onset: Option<&str>,
) -> PyResult<Deck> {
    let options = read_options(parameters, dialect, friction_onset)?;
    let read = py.detach(|| Job::read(&path, &options));
    Ok(Deck { read: Arc::new(read) })
}

/// Reads the text of a deck, which can include nothing.
#[pyfunction]
#[pyo3(signature = (name, text, parameters, dialect=None, friction_onset=None))]
pub(crate) fn read_text(
    py: Python<'_>,
    name: &str,
    text: &str,
    parameters: Vec<(String, String)>,
    dialect: Option<&str>,
    friction_onset: Option<&str>,
) -> PyResult<Deck> {
    let options = read_options(parameters, dialect, friction_onset)?;
    let read = py.detach(|| Job::read_text(name, text, &options));
    Ok(Deck { read: Arc::new(read) })
}

#[pymethods]
impl Deck {
    /// Name of the job: the deck's without `.inp`.
    #[getter]
    fn name(&self) -> String {
        self.read.job.stem.to_string_lossy().into_owned()
    }

    /// Path of the deck.
    #[getter]
    fn path(&self) -> String {
        self.read.job.deck.display().to_string()
    }

    /// Paths of the deck and of everything that it includes.
    #[getter]
    fn files(&self) -> Vec<String> {
        self.read.sources.files().iter().map(|file| file.name.clone()).collect()
    }

    /// SHA-256 over all texts of the deck.
    #[getter]
    fn hash(&self) -> &str {
        &self.read.deck_hash
    }

    /// Whether there is a model to be run.
    #[getter]
    fn is_sound(&self) -> bool {
        self.read.model.is_some()
    }

    /// What reading had to say.
    #[getter]
    fn diagnoses(&self) -> Vec<Diagnosis> {
        Diagnosis::all(&self.read.diagnostics, &self.read.sources)
    }

    /// Labels of the nodes of a set, or of all; None: there is no such set.
    #[pyo3(signature = (name=None))]
    fn node_labels(&self, name: Option<&str>) -> Option<Vec<u64>> {
        let model = self.read.model.as_ref()?;
        let Some(name) = name else {
            return Some((0..model.nodes.len()).map(|node| model.nodes.label(node)).collect());
        };
        let set = model.node_sets.iter().find(|set| set.name.eq_ignore_ascii_case(name))?;
        Some(set.members.iter().map(|&node| model.nodes.label(node)).collect())
    }

    /// Where all nodes stand before the first step [L], (nodes, 3); None without a model.
    fn coordinates(&self, py: Python<'_>) -> PyResult<Option<Py<PyArrayDyn<f64>>>> {
        let Some(model) = &self.read.model else { return Ok(None) };
        let all: Vec<f64> = model.nodes.iter().flat_map(|node| node.position).collect();
        shaped(py, &[model.nodes.len(), 3], all).map(Some)
    }

    /// Advice on the model, beside what reading had to say.
    fn advice(&self, py: Python<'_>) -> Vec<Diagnosis> {
        let said = py.detach(|| advise(&self.read));
        Diagnosis::all(&said, &self.read.sources)
    }

    /// Contact points before anything moves, with their gaps; None without a model.
    fn initial_gaps(&self, py: Python<'_>) -> PyResult<Option<Table>> {
        let Some(model) = &self.read.model else { return Ok(None) };
        let from = self.read.from.as_ref().and_then(|from| from.checkpoint.as_ref());
        let gaps = py.detach(|| initial_gaps(model, &SolveOptions::default(), from));
        gaps.map(|gaps| Table::of_gaps(py, model, &gaps.points)).transpose()
    }

    /// Runs every step. `folder`: where the files go; None writes none. `told` is called after every
    /// increment with step, increment, total time and iterations. `laws` are functions of friction
    /// by their names.
    #[pyo3(signature = (folder, threads, all_frames, told, laws))]
    fn run(
        &self,
        folder: Option<PathBuf>,
        threads: usize,
        all_frames: bool,
        told: Option<Py<PyAny>>,
        laws: &Bound<'_, PyDict>,
    ) -> PyResult<Run> {
        let py = laws.py();
        let failures = Arc::new(Failures::default());
        let solve = SolveOptions {
            threads,
            user_frictions: frictions(laws, &failures)?,
            ..SolveOptions::default()
        };
        let keep = if all_frames { Keep::All } else { Keep::Last };
        let mut watch = Watch::new(Recording::new(keep), told, failures.clone());
        let read = self.read.clone();
        let ended = py.detach(|| crate::run::ended(&read, folder, solve, &mut watch));
        Run::new(py, read, ended, watch)
    }

    fn __repr__(&self) -> String {
        format!("<Deck {}>", self.read.job.deck.display())
    }
}
