//! A deck's text, run, as one row an increment.

use slideline::model::Dof;
use slideline::observe::{
    BeamRow, ContactRow, Ending, Energies, Frame, IterationReport, Nodal, Totals,
};
use slideline::{
    Diagnostic, Event, Job, Model, Observer, ReadOptions, Severity, SolveOptions, Stop,
};
use std::ops::ControlFlow;

/// A converged increment.
#[derive(Clone, Debug)]
pub struct Row {
    /// Step, from 1.
    pub step: usize,
    /// Increment of the step, from 1.
    pub increment: usize,
    /// Total time [T].
    pub time: f64,
    /// Equilibrium iterations.
    pub equilibrium: usize,
    /// Severe discontinuity iterations.
    pub severe: usize,
    /// Displacements [L] and rotations [1] of every node, U1 to UR3, in model order.
    pub displacement: Vec<[f64; 6]>,
    /// Reactions [F] and their moments [F L] of every node, RF1 to RM3, in model order.
    pub reaction: Vec<[f64; 6]>,
    /// Contact points.
    pub contact: Vec<ContactRow>,
    /// Beams.
    pub beams: Vec<BeamRow>,
    /// Energies as the program gives them.
    pub energy: Energies,
}

/// All converged increments of a run that came to its end.
#[derive(Clone, Debug)]
pub struct Curve {
    /// The model that was run.
    pub model: Model,
    /// Rows of all steps.
    pub rows: Vec<Row>,
    /// Every Newton iteration.
    pub iterations: Vec<IterationReport>,
    /// Counts of the run.
    pub totals: Totals,
    /// What was said on reading and during the run.
    pub diagnostics: Vec<Diagnostic>,
}

impl Curve {
    /// U1 to UR3 (`dof` 1 to 6) of the node `label` [L or 1]; empty if there is none.
    pub fn displacement(&self, label: u64, dof: usize) -> Vec<f64> {
        self.column(label, dof, |row| &row.displacement)
    }

    /// RF1 to RM3 (`dof` 1 to 6) of the node `label` [F or F L]; empty if there is none.
    pub fn reaction(&self, label: u64, dof: usize) -> Vec<f64> {
        self.column(label, dof, |row| &row.reaction)
    }

    /// Iterations of both kinds, summed over the rows, per increment.
    pub fn mean_iterations(&self) -> f64 {
        let sum: usize = self.rows.iter().map(|row| row.equilibrium + row.severe).sum();
        sum as f64 / self.rows.len() as f64
    }

    /// Strain energy of the beams [F L], from their strains and section forces.
    pub fn beam_energy(&self, row: &Row) -> f64 {
        let nodes = &self.model.nodes;
        let energy = |beam: &BeamRow| {
            let [a, b] = beam.nodes.map(|node| nodes.position(node));
            let [axial, shear, curvature] = beam.strains;
            0.5 * (b[0] - a[0]).hypot(b[1] - a[1])
                * (beam.axial_force * axial
                    + beam.shear_force * shear
                    + beam.bending_moment * curvature)
        };
        row.beams.iter().map(energy).sum()
    }

    fn column(&self, label: u64, dof: usize, of: impl Fn(&Row) -> &Vec<[f64; 6]>) -> Vec<f64> {
        let place = dof - 1;
        match self.model.nodes.find(label) {
            Some(node) => self.rows.iter().map(|row| of(row)[node][place]).collect(),
            None => Vec::new(),
        }
    }
}

/// Reads and runs a deck on one thread.
///
/// # Errors
/// What the program says where the deck has errors or the run does not reach
/// its end.
pub fn run(deck: &str) -> Result<Curve, String> {
    run_on(deck, 1)
}

/// As [`run`], on `threads` threads.
///
/// # Errors
/// As [`run`].
pub fn run_on(deck: &str, threads: usize) -> Result<Curve, String> {
    let read = Job::read_text("claim", deck, &ReadOptions::default());
    let Some(model) = read.model else {
        return Err(words(&read.diagnostics));
    };
    let mut watch = Watch { diagnostics: read.diagnostics, ..Watch::default() };
    let options = SolveOptions { threads, ..SolveOptions::default() };
    match slideline::solve(&model, &options, &mut watch) {
        Ending::Completed(totals) => Ok(Curve {
            model,
            rows: watch.rows,
            iterations: watch.iterations,
            totals,
            diagnostics: watch.diagnostics,
        }),
        other => Err(format!(
            "{} increments converged, then: {}\n{other:?}",
            watch.rows.len(),
            watch.failures.join("; ")
        )),
    }
}

fn words(diagnostics: &[Diagnostic]) -> String {
    let errors = diagnostics.iter().filter(|said| said.severity == Severity::Error);
    let lines: Vec<String> =
        errors.map(|said| format!("{:?}: {}", said.code, said.message)).collect();
    lines.join("\n")
}

#[derive(Default)]
struct Watch {
    rows: Vec<Row>,
    iterations: Vec<IterationReport>,
    diagnostics: Vec<Diagnostic>,
    failures: Vec<String>,
}

impl Observer for Watch {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::Iteration(report) => self.iterations.push(report.clone()),
            Event::Committed(frame) => self.rows.push(row(frame)),
            Event::AttemptFailed(report) => self.failures.push(report.reason.clone()),
            Event::Diagnosed(said) => self.diagnostics.push(said.clone()),
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

fn row(frame: &Frame<'_>) -> Row {
    let nodes = 0..frame.model.nodes.len();
    let read = |value: fn(&Nodal<'_>, usize, Dof) -> f64| {
        nodes.clone().map(|node| Dof::ALL.map(|dof| value(&frame.nodal, node, dof))).collect()
    };
    Row {
        step: frame.step,
        increment: frame.increment,
        time: frame.total_time,
        equilibrium: frame.equilibrium_iterations,
        severe: frame.severe_iterations,
        displacement: read(|nodal, node, dof| nodal.displacement(node, dof)),
        reaction: read(|nodal, node, dof| nodal.reaction(node, dof)),
        contact: frame.contact.to_vec(),
        beams: frame.beams.to_vec(),
        energy: frame.energy,
    }
}
