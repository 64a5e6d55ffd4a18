//! A run on a linear system that the embedding program brings.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::linalg::{
    Analyse, BuiltIn, DenseLu, Description, FactorReport, Kind, LinearSystem, Matrix, Pattern,
    SolveError,
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

/// The system of the program with a count of its factorisations; it may hide what it is.
#[derive(Default)]
struct Counted {
    hidden: bool,
    factored: Arc<AtomicUsize>,
}

struct CountedSystem {
    own: Box<dyn LinearSystem>,
    hidden: bool,
    factored: Arc<AtomicUsize>,
}

impl Analyse for Counted {
    fn analyse(&self, pattern: &Pattern, kind: Kind) -> Result<Box<dyn LinearSystem>, SolveError> {
        let own = BuiltIn::default().analyse(pattern, kind)?;
        Ok(Box::new(CountedSystem { own, hidden: self.hidden, factored: self.factored.clone() }))
    }
}

impl LinearSystem for CountedSystem {
    fn description(&self) -> Description {
        let own = self.own.description();
        match self.hidden {
            true => Description::external("hidden", own.kind, own.equations),
            false => own,
        }
    }
    fn scatter(&mut self, matrix: Matrix<'_>) {
        self.own.scatter(matrix);
    }
    fn factor(&mut self, matrix: Matrix<'_>, size: &[f64]) -> Result<FactorReport, SolveError> {
        self.factored.fetch_add(1, Ordering::Relaxed);
        self.own.factor(matrix, size)
    }
    fn solve(&mut self, block: &mut [f64], columns: usize) -> Result<(), SolveError> {
        self.own.solve(block, columns)
    }
    fn solve_transpose(&mut self, block: &mut [f64], columns: usize) -> Result<(), SolveError> {
        self.own.solve_transpose(block, columns)
    }
}

/// A cube of bricks, held below, sheared and pressed above.
fn cube(side: usize) -> String {
    let node = |x: usize, y: usize, z: usize| 1 + x + (side + 1) * (y + (side + 1) * z);
    let all = |n: usize| (0..n.pow(3)).map(move |c| (c % n, c / n % n, c / (n * n)));
    let mut text = "*NODE, NSET=ALL\n".to_owned();
    for (x, y, z) in all(side + 1) {
        text += &format!("{}, {x}., {y}., {z}.\n", node(x, y, z));
    }
    text += "*ELEMENT, TYPE=C3D8, ELSET=BODY\n";
    for (e, (x, y, z)) in all(side).enumerate() {
        let corners = [
            (0, 0, 0),
            (1, 0, 0),
            (1, 1, 0),
            (0, 1, 0),
            (0, 0, 1),
            (1, 0, 1),
            (1, 1, 1),
            (0, 1, 1),
        ];
        let nodes = corners.map(|(i, j, k)| node(x + i, y + j, z + k).to_string());
        text += &format!("{}, {}\n", e + 1, nodes.join(", "));
    }
    let layer = (side + 1).pow(2);
    let top = (side + 1).pow(3) - layer;
    text += &format!(
        "*NSET, NSET=BELOW, GENERATE\n1, {layer}\n*NSET, NSET=ABOVE, GENERATE\n{}, {}\n",
        top + 1,
        top + layer
    );
    text +=
        "*MATERIAL, NAME=STEEL\n*ELASTIC\n2.1E5, 0.3\n*SOLID SECTION, ELSET=BODY, MATERIAL=STEEL\n";
    let part = side as f64 / 10.0;
    text + &format!(
        "*BOUNDARY\nBELOW, 1, 3\n*STEP, NLGEOM\n*STATIC, DIRECT\n0.5, 1.\n*BOUNDARY\n\
         ABOVE, 1, 1, {part}\nABOVE, 2, 2\nABOVE, 3, 3, {}\n*NODE PRINT, NSET=ABOVE\nRF\n*END STEP\n",
        -0.5 * part
    )
}

/// Requirement: in a large solid the iterations of an increment share the factors of its first one,
/// and the history is that of a run in which every iteration has its own, to 1e-10 of its peak.
#[test]
fn iterations_of_an_increment_share_factors() {
    let read = Job::read_text("cube", &cube(13), &ReadOptions::default());
    let model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
    let run = |hidden: bool| {
        let system = Counted { hidden, ..Counted::default() };
        let factored = system.factored.clone();
        let linear_systems = LinearSystems::external(Arc::new(system));
        let options = SolveOptions { linear_systems, ..SolveOptions::default() };
        (history(&model, &options), factored.load(Ordering::Relaxed))
    };
    let ((shared, few), (own, many)) = (run(false), run(true));
    // one before the first increment, and one in each
    assert!(few == 3 && many > few + 1, "{few} {many}");
    let peak = own.iter().flatten().fold(0.0_f64, |a, b| a.max(b.abs()));
    assert_eq!(own.len(), shared.len());
    for (a, b) in own.iter().flatten().zip(shared.iter().flatten()) {
        assert!((a - b).abs() <= 1e-10 * peak, "{a} {b}");
    }
}
