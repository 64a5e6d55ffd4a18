//! A run on a linear system that the embedding program brings.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::linalg::{
    Analyse, DenseLu, Description, FactorReport, Kind, LinearSystem, Matrix, Pattern, SolveError,
};
use slideline::model::Dof;
use slideline::observe::Ending;
use slideline::{Event, Job, LinearSystems, Model, Observer, ReadOptions, SolveOptions, Stop};
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Dense elimination, and a count of its factorisations.
#[derive(Default)]
struct Dense {
    factored: Arc<AtomicUsize>,
}

struct DenseSystem {
    n: usize,
    kind: Kind,
    plain: DenseLu,
    transposed: DenseLu,
    factored: Arc<AtomicUsize>,
}

impl Analyse for Dense {
    fn analyse(&self, pattern: &Pattern, kind: Kind) -> Result<Box<dyn LinearSystem>, SolveError> {
        let (plain, transposed) = (DenseLu::default(), DenseLu::default());
        let factored = self.factored.clone();
        Ok(Box::new(DenseSystem { n: pattern.size(), kind, plain, transposed, factored }))
    }
}

impl LinearSystem for DenseSystem {
    fn description(&self) -> Description {
        Description::external("dense", self.kind, self.n)
    }

    fn scatter(&mut self, matrix: Matrix<'_>) {
        let plain = self.plain.matrix_mut(self.n);
        let transposed = self.transposed.matrix_mut(self.n);
        for i in 0..self.n {
            let (columns, values) = matrix.row(i);
            for (&j, &a) in columns.iter().zip(values) {
                plain[i * self.n + j] = a;
                transposed[j * self.n + i] = a;
            }
        }
    }

    fn factor(&mut self, _: Matrix<'_>, _: &[f64]) -> Result<FactorReport, SolveError> {
        self.factored.fetch_add(1, Ordering::Relaxed);
        self.plain.factor();
        self.transposed.factor();
        match self.plain.first_dependent() {
            Some(equation) => Err(SolveError::Singular { equation, ratio: 0.0 }),
            None => Ok(FactorReport {
                negative_pivots: None,
                smallest_pivot_ratio: 1.0,
                smallest_pivot: 0,
            }),
        }
    }

    fn solve(&mut self, block: &mut [f64], _columns: usize) -> Result<(), SolveError> {
        block.chunks_exact_mut(self.n).try_for_each(|column| self.plain.solve(column))
    }

    fn solve_transpose(&mut self, block: &mut [f64], _columns: usize) -> Result<(), SolveError> {
        block.chunks_exact_mut(self.n).try_for_each(|column| self.transposed.solve(column))
    }
}

const DOFS: [Dof; 3] = Dof::PLANE;

/// Reactions of the history nodes, increment by increment.
#[derive(Default)]
struct History(Vec<Vec<f64>>);

impl Observer for History {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            let nodes = frame.model.history_nodes();
            let of_node = |node| DOFS.map(|dof| frame.nodal.reaction(node, dof));
            self.0.push(nodes.into_iter().flat_map(of_node).collect());
        }
        ControlFlow::Continue(())
    }
}

fn history(model: &Model, options: &SolveOptions) -> Vec<Vec<f64>> {
    let mut history = History::default();
    let ending = slideline::solve(model, options, &mut history);
    assert!(matches!(ending, Ending::Completed(_)), "{ending:?}");
    history.0
}

/// Requirement: a run on an external linear system gives the history of the own one to 1e-9 of its
/// peak: both meet the same equations, R_n = 1e-10 of the mean force.
#[test]
fn a_deck_runs_on_an_external_linear_system() {
    let deck =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../corpus/diehl1995/isl_coarse_mu03.inp");
    let read = Job::read(&deck, &ReadOptions::default());
    let mut model = read.model.unwrap();
    for step in &mut model.steps {
        step.controls.field.r_n = 1e-10;
    }
    let own = history(&model, &SolveOptions::default());
    let dense = Dense::default();
    let factored = dense.factored.clone();
    let linear_systems = LinearSystems::external(Arc::new(dense));
    let options = SolveOptions { linear_systems, ..SolveOptions::default() };
    let other = history(&model, &options);
    assert!(factored.load(Ordering::Relaxed) > own.len());
    let peak = own.iter().flatten().fold(0.0_f64, |a, b| a.max(b.abs()));
    assert_eq!(own.len(), other.len());
    for (a, b) in own.iter().flatten().zip(other.iter().flatten()) {
        assert!((a - b).abs() <= 1e-9 * peak, "{a} {b}");
    }
}
