//! Error bars of reactions: the same model on finer meshes, and again in
//! shorter increments.
//!
//! ```text
//!   model --refine--> half --refine--> quarter       mesh, or increments
//!     |                |                 |       reactions of the same nodes
//!     '--- run --------'------ run ------'-----> bar, an increment and component
//! ```

use slideline_diag::{Code, Diagnostic, Severity};
use slideline_measures::error_bar;
use slideline_model::{Dof, Model, NodeIndex, refine};
use slideline_output::{BarRows, JobFiles, WriteError, add_error_bars};
use slideline_solve::Options;
use slideline_solve::observe::{Ending, Event, Observer, Stop};
use std::collections::HashSet;
use std::ops::ControlFlow;

/// Reactions of the history nodes of a model, increment by increment.
#[derive(Clone, Debug, Default)]
pub struct Reactions {
    nodes: Vec<NodeIndex>,
    labels: Vec<u64>,
    dofs: Vec<Dof>,
    /// How many nodes the model has.
    count_of_nodes: usize,
    /// Total times of the increments [T].
    times: Vec<f64>,
    /// One curve a node and dof, node by node [F or F L].
    curves: Vec<Vec<f64>>,
}

impl Reactions {
    /// None yet, of the nodes of `JOB.history.csv`.
    pub fn of(model: &Model) -> Self {
        let nodes = model.history_nodes();
        let labels = nodes.iter().map(|&node| model.nodes.label(node)).collect();
        let dofs = model.directions().to_vec();
        let curves = vec![Vec::new(); nodes.len() * dofs.len()];
        let count_of_nodes = model.nodes.len();
        Self { nodes, labels, dofs, count_of_nodes, times: Vec::new(), curves }
    }

    /// Number of increments that were taken down.
    pub fn count(&self) -> usize {
        self.times.len()
    }

    /// An observer that takes them down and passes everything on.
    pub fn watch<'a>(&'a mut self, observer: &'a mut dyn Observer) -> Recorder<'a> {
        Recorder { reactions: self, observer }
    }

    fn emptied(&self) -> Self {
        let curves = vec![Vec::new(); self.curves.len()];
        Self { times: Vec::new(), curves, ..self.clone() }
    }

    /// A curve at other times, linear between increments.
    fn at(&self, curve: usize, times: &[f64]) -> Vec<f64> {
        let values = &self.curves[curve];
        let value = |&time: &f64| {
            let after = self.times.partition_point(|&t| t < time);
            let known = |place: usize| Some((*self.times.get(place)?, *values.get(place)?));
            match (after.checked_sub(1).and_then(known), known(after)) {
                (_, Some((t1, v1))) if t1 == time => v1,
                (Some((t0, v0)), Some((t1, v1))) => v0 + (v1 - v0) * (time - t0) / (t1 - t0),
                (None, Some((t1, v1))) => v1 * time / t1,
                (Some((_, last)), None) => last,
                (None, None) => 0.0,
            }
        };
        times.iter().map(value).collect()
    }
}

/// Takes reactions down as a run goes.
pub struct Recorder<'a> {
    reactions: &'a mut Reactions,
    observer: &'a mut dyn Observer,
}

impl Observer for Recorder<'_> {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = &event {
            self.reactions.times.push(frame.total_time);
            let Reactions { nodes, dofs, curves, .. } = &mut *self.reactions;
            let (nodes, dofs) = (&*nodes, &*dofs);
            let pairs = nodes.iter().flat_map(|&node| dofs.iter().map(move |&dof| (node, dof)));
            for (curve, (node, dof)) in curves.iter_mut().zip(pairs) {
                curve.push(frame.nodal.reaction(node, dof));
            }
        }
        self.observer.event(event)
    }
}

/// Estimated errors of the reactions of the history nodes.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorBars {
    /// Labels of the nodes.
    pub nodes: Vec<u64>,
    /// Dofs of each that have reactions.
    pub dofs: Vec<Dof>,
    /// One curve a node and dof, node by node [F or F L].
    pub bars: Vec<Vec<f64>>,
}

impl ErrorBars {
    /// Bars of one reaction, a value an increment [F or F L].
    pub fn of(&self, label: u64, dof: Dof) -> Option<&[f64]> {
        let node = self.nodes.iter().position(|&node| node == label)?;
        let place = self.dofs.iter().position(|&own| own == dof)?;
        self.bars.get(node * self.dofs.len() + place).map(Vec::as_slice)
    }

    fn rows<'a>(&'a self, method: &'a str, columns: &'a [String]) -> BarRows<'a> {
        BarRows { method, nodes: &self.nodes, columns, bars: &self.bars }
    }
}

/// Adds error bars of the mesh, and those in time, to the result files of the
/// job.
///
/// # Errors
/// When a file cannot be read or written.
pub fn write_error_bars(
    files: &JobFiles,
    mesh: Option<&ErrorBars>,
    time: Option<&ErrorBars>,
) -> Result<(), WriteError> {
    let names = |bars: Option<&ErrorBars>, kind: &str| -> Vec<String> {
        let dofs = bars.map_or(&[][..], |bars| &bars.dofs);
        dofs.iter().map(|dof| format!("{}_{kind}", dof.reaction_name())).collect()
    };
    let (of_mesh, in_time) = (names(mesh, "error"), names(time, "time_error"));
    let mesh = mesh.map(|bars| bars.rows("halved and quartered mesh", &of_mesh));
    let time = time.map(|bars| bars.rows("halved and quartered increments", &in_time));
    add_error_bars(files, mesh.as_ref(), time.as_ref())
}

/// Estimates the discretisation error of the reactions of a finished run:
/// `found` on the model's own mesh, against the same on meshes of half and a
/// quarter of the width (docs/theory.md, "Error bars"). `observer` sees both
/// runs.
///
/// # Errors
/// A warning that says why there are none: the mesh cannot be halved, or a
/// finer one did not converge.
pub fn error_bars(
    model: &Model,
    found: &Reactions,
    options: &Options,
    observer: &mut dyn Observer,
) -> Result<ErrorBars, Box<Diagnostic>> {
    let as_warning =
        |said: Box<Diagnostic>| Box::new(Diagnostic { severity: Severity::Warning, ..*said });
    let half = refine(model).map_err(as_warning)?;
    let quarter = refine(&half).map_err(as_warning)?;
    let ways = [
        "the run with half the element length",
        "the run with a quarter of the element \
                                                         length",
    ];
    compare(found, [&half, &quarter], ways, options, observer)
}

/// Estimates the error of the reactions of a finished run that comes from its
/// increments: `found` in the deck's own, against the same in increments of
/// half and a quarter of the length (docs/theory.md, "Error bars").
///
/// # Errors
/// A warning that says why there are none: one of the runs did not converge.
pub fn time_error_bars(
    model: &Model,
    found: &Reactions,
    options: &Options,
    observer: &mut dyn Observer,
) -> Result<ErrorBars, Box<Diagnostic>> {
    let (half, quarter) = (shortened(model, 2), shortened(model, 4));
    let ways = [
        "the run with half the increment size",
        "the run with a quarter of the increment \
                                                         size",
    ];
    compare(found, [&half, &quarter], ways, options, observer)
}

/// The model with so many increments for each of its own.
fn shortened(model: &Model, times: u32) -> Model {
    let mut model = model.clone();
    for step in &mut model.steps {
        let procedure = &mut step.procedure;
        let lengths = [&mut procedure.initial, &mut procedure.minimum, &mut procedure.maximum];
        lengths.into_iter().for_each(|length| *length /= f64::from(times));
        step.max_increments = step.max_increments.saturating_mul(times as usize);
    }
    model
}

/// Dofs of the nodes whose support is shared with a node that only the finer mesh has: on a solid
/// the part of a single node grows smaller with the mesh and is no result.
fn shared(finer: &Model, found: &Reactions) -> HashSet<(NodeIndex, Dof)> {
    let known: HashSet<NodeIndex> = found.nodes.iter().copied().collect();
    let held: HashSet<(NodeIndex, Dof)> = finer
        .steps
        .iter()
        .flat_map(|step| &step.prescribed)
        .filter(|own| own.node >= found.count_of_nodes)
        .map(|own| (own.node, own.dof))
        .collect();
    let solids = finer.blocks.iter().filter(|block| !block.kind.cell.faces.is_empty());
    let mut shared = HashSet::new();
    for element in solids.flat_map(|block| &block.elements) {
        let own = element.nodes.iter().filter(|node| known.contains(node));
        for (&node, &dof) in own.flat_map(|node| found.dofs.iter().map(move |dof| (node, dof))) {
            if element.nodes.iter().any(|&other| held.contains(&(other, dof))) {
                shared.insert((node, dof));
            }
        }
    }
    shared
}

/// Bars from two finer runs.
fn compare(
    found: &Reactions,
    models: [&Model; 2],
    ways: [&str; 2],
    options: &Options,
    observer: &mut dyn Observer,
) -> Result<ErrorBars, Box<Diagnostic>> {
    let shared = shared(models[0], found);
    let mut finer = Vec::with_capacity(2);
    for (model, way) in models.into_iter().zip(ways) {
        let mut reactions = found.emptied();
        let ending = slideline_solve::run(model, options, &mut reactions.watch(observer));
        if !matches!(ending, Ending::Completed(_)) {
            let message = format!("no error bars: {way} was not completed");
            let said = Diagnostic::warning(Code("SL0602"), message)
                .help("Smaller increments may help; the results of the deck itself are valid.");
            return Err(Box::new(said));
        }
        finer.push(reactions);
    }
    let kinds = found.dofs.len().max(1);
    let bars = found.curves.iter().enumerate().map(|(place, coarse)| {
        let (node, dof) = (found.nodes[place / kinds], found.dofs[place % kinds]);
        if shared.contains(&(node, dof)) {
            return vec![f64::NAN; coarse.len()];
        }
        let [half, quarter] = [0, 1].map(|k: usize| finer[k].at(place, &found.times));
        error_bar(coarse, &half, &quarter).unwrap_or_default()
    });
    Ok(ErrorBars { nodes: found.labels.clone(), dofs: found.dofs.clone(), bars: bars.collect() })
}
