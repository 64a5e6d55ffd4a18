//! Linear systems implemented outside the crate, used through `Solver` like its own: an iterative
//! one, and a direct one that is spread over processes (here threads), each of which assembles its
//! own rows.

// Helpers of tests may fail like tests.
#![allow(clippy::unwrap_used)]

use std::ops::Range;
use std::sync::{Arc, Barrier, Mutex};

use crate::common::*;
use slideline_linalg::krylov::{Stop, Workspace, gmres};
use slideline_linalg::*;

/// GMRES preconditioned by the diagonal.
struct Iterative {
    pattern: Pattern,
    values: Vec<f64>,
    diagonal: Vec<f64>,
    workspace: Workspace,
}

struct AnalyseIterative;

impl Analyse for AnalyseIterative {
    fn analyse(&self, pattern: &Pattern, _: Kind) -> Result<Box<dyn LinearSystem>, SolveError> {
        Ok(Box::new(Iterative {
            pattern: pattern.clone(),
            values: vec![0.0; pattern.entries()],
            diagonal: vec![0.0; pattern.size()],
            workspace: Workspace::default(),
        }))
    }
}

impl Iterative {
    fn iterate(&mut self, block: &mut [f64], transposed: bool) -> Result<(), SolveError> {
        let Self { pattern, values, diagonal, workspace } = self;
        let matrix = Matrix::new(pattern, values);
        for b in block.chunks_exact_mut(pattern.size()) {
            let mut x = vec![0.0; b.len()];
            let progress = gmres(
                |v, w| match transposed {
                    true => matrix.multiply_transpose(v, w),
                    false => matrix.multiply(v, w),
                },
                |v, z| (0..v.len()).for_each(|i| z[i] = v[i] / diagonal[i]),
                b,
                &mut x,
                Stop { tolerance: 1e-13, iterations: 500 },
                workspace,
            );
            if !progress.converged() {
                return Err(SolveError::External { reason: "no convergence" });
            }
            b.copy_from_slice(&x);
        }
        Ok(())
    }
}

impl LinearSystem for Iterative {
    fn description(&self) -> Description {
        Description::external("GMRES with diagonal", Kind::Unsymmetric, self.pattern.size())
    }
    fn scatter(&mut self, matrix: Matrix<'_>) {
        self.values.copy_from_slice(matrix.values);
    }
    fn factor(&mut self, matrix: Matrix<'_>, size: &[f64]) -> Result<FactorReport, SolveError> {
        let mut report =
            FactorReport { negative_pivots: None, smallest_pivot_ratio: 1.0, smallest_pivot: 0 };
        for (i, d) in self.diagonal.iter_mut().enumerate() {
            *d = matrix.values[matrix.pattern.position(i, i).unwrap()];
            let ratio = d.abs() / size[i];
            if ratio == 0.0 {
                return Err(SolveError::Singular { equation: i, ratio });
            }
            if ratio < report.smallest_pivot_ratio {
                (report.smallest_pivot_ratio, report.smallest_pivot) = (ratio, i);
            }
        }
        Ok(report)
    }
    fn solve(&mut self, block: &mut [f64], _columns: usize) -> Result<(), SolveError> {
        self.iterate(block, false)
    }
    fn solve_transpose(&mut self, block: &mut [f64], _columns: usize) -> Result<(), SolveError> {
        self.iterate(block, true)
    }
}

/// What the threads share: a place for the values that each brings to a reduction.
struct Exchange {
    brought: Mutex<Vec<Vec<f64>>>,
    barrier: Barrier,
}

/// Dense elimination of which every thread owns some rows.
struct Spread {
    n: usize,
    rows: Range<usize>,
    rank: usize,
    exchange: Arc<Exchange>,
    matrix: Vec<f64>,
}

impl Spread {
    fn reduce(&self, values: &mut [f64], join: impl Fn(f64, f64) -> f64) {
        self.exchange.brought.lock().unwrap()[self.rank] = values.to_vec();
        self.exchange.barrier.wait();
        let brought = self.exchange.brought.lock().unwrap().clone();
        for (i, value) in values.iter_mut().enumerate() {
            *value = brought[1..].iter().fold(brought[0][i], |all, one| join(all, one[i]));
        }
        self.exchange.barrier.wait();
    }

    fn eliminate(&self, block: &mut [f64], entry: impl Fn(usize, usize) -> f64) {
        for b in block.chunks_exact_mut(self.n) {
            // Only the owned rows of a right-hand side are ours to read.
            (0..self.n).filter(|i| !self.rows.contains(i)).for_each(|i| b[i] = 0.0);
            self.reduce_sum(b);
            let rows = (0..self.n).map(|i| (0..self.n).map(|j| entry(i, j)).collect()).collect();
            b.copy_from_slice(&eliminate(rows, b.to_vec()));
        }
    }
}

impl LinearSystem for Spread {
    fn description(&self) -> Description {
        Description::external("spread", Kind::Unsymmetric, self.n)
    }
    fn scatter(&mut self, matrix: Matrix<'_>) {
        self.matrix.fill(0.0);
        for i in self.rows.clone() {
            let (columns, values) = matrix.row(i);
            columns.iter().zip(values).for_each(|(j, a)| self.matrix[i * self.n + j] = *a);
        }
        let mut matrix = std::mem::take(&mut self.matrix);
        self.reduce_sum(&mut matrix);
        self.matrix = matrix;
    }
    fn factor(&mut self, _: Matrix<'_>, _: &[f64]) -> Result<FactorReport, SolveError> {
        Ok(FactorReport { negative_pivots: None, smallest_pivot_ratio: 1.0, smallest_pivot: 0 })
    }
    fn solve(&mut self, block: &mut [f64], _columns: usize) -> Result<(), SolveError> {
        self.eliminate(block, |i, j| self.matrix[i * self.n + j]);
        Ok(())
    }
    fn solve_transpose(&mut self, block: &mut [f64], _columns: usize) -> Result<(), SolveError> {
        self.eliminate(block, |i, j| self.matrix[j * self.n + i]);
        Ok(())
    }
    fn owned_rows(&self) -> Range<usize> {
        self.rows.clone()
    }
    fn reduce_sum(&self, values: &mut [f64]) {
        self.reduce(values, |a, b| a + b);
    }
    fn reduce_max(&self, values: &mut [f64]) {
        self.reduce(values, f64::max);
    }
}

fn system() -> (Pattern, Vec<f64>, Vec<f64>) {
    let (pattern, mut values) = grid(9);
    let mut numbers = Numbers(5);
    values.iter_mut().for_each(|v| *v *= 1.0 + 0.3 * numbers.next());
    let b = (0..pattern.size()).map(|_| numbers.next()).collect();
    (pattern, values, b)
}

/// Requirement: an implementation from outside serves every call of `Solver`, units included, and
/// its own errors come through. Tolerance: what GMRES was asked for, times the condition.
#[test]
fn an_iterative_system() {
    let (pattern, mut values, b) = system();
    let solver = Solver::analyse(&pattern, Kind::Unsymmetric, &AnalyseIterative);
    let unit = (0..b.len()).map(|i| if i % 3 == 0 { 0.25 } else { 1.0 }).collect();
    let mut solver = solver.with_units(unit);
    solver.refactor(&pattern, &values).unwrap();
    assert_eq!(solver.description().back_end, BackEnd::External("GMRES with diagonal"));
    let reference = eliminate(dense(&pattern, &values), b.clone());
    let mut block = [b.clone(), b.clone()].concat();
    solver.solve_many(&mut block, 2).unwrap();
    assert!(block.chunks(b.len()).all(|x| error(x, &reference) < 1e-11));
    let mut x = b.clone();
    solver.solve_transpose(&mut x).unwrap();
    let mut back = vec![0.0; b.len()];
    Matrix::new(&pattern, &values).multiply_transpose(&x, &mut back);
    assert!(error(&back, &b) < 1e-11);
    values[pattern.position(4, 4).unwrap()] = 0.0;
    let expected = Err(SolveError::Singular { equation: 4, ratio: 0.0 });
    assert_eq!(solver.refactor(&pattern, &values), expected);
}

/// Requirement: a factory that fails is heard when the system is factored.
#[test]
fn a_failed_analysis_is_told() {
    struct Fails;
    impl Analyse for Fails {
        fn analyse(&self, _: &Pattern, _: Kind) -> Result<Box<dyn LinearSystem>, SolveError> {
            Err(SolveError::External { reason: "no licence" })
        }
    }
    let (pattern, values, _) = system();
    let mut solver = Solver::analyse(&pattern, Kind::Symmetric, &Fails);
    let expected = Err(SolveError::External { reason: "no licence" });
    assert_eq!(solver.refactor(&pattern, &values), expected);
}

/// What each of two processes finds, with only its own rows' values and right-hand side right.
fn on_two_processes(
    work: impl Fn(Solver, &dyn Fn(usize) -> bool) -> (Result<(), SolveError>, Vec<f64>) + Sync,
) -> Vec<(Result<(), SolveError>, Vec<f64>)> {
    let (pattern, ..) = system();
    let n = pattern.size();
    let brought = Mutex::new(vec![Vec::new(); 2]);
    let exchange = Arc::new(Exchange { brought, barrier: Barrier::new(2) });
    std::thread::scope(|scope| {
        let threads = [0..n / 3, n / 3..n].into_iter().enumerate().map(|(rank, rows)| {
            let (exchange, pattern, work) = (exchange.clone(), pattern.clone(), &work);
            scope.spawn(move || {
                let matrix = vec![0.0; n * n];
                let own = rows.clone();
                let spread = Spread { n, rows, rank, exchange, matrix };
                work(Solver::new(&pattern, Box::new(spread)), &|i| own.contains(&i))
            })
        });
        let threads: Vec<_> = threads.collect();
        threads.into_iter().map(|thread| thread.join().unwrap()).collect()
    })
}

/// Requirement: with the rows spread over processes every process gets the whole solution, whatever
/// stands in the rows it does not own; plain, many at once and transposed.
#[test]
fn rows_spread_over_processes() {
    let (pattern, values, b) = system();
    let reference = eliminate(dense(&pattern, &values), b.clone());
    let found = on_two_processes(|mut solver, owns| {
        let mut own = values.clone();
        (0..b.len()).filter(|&i| !owns(i)).for_each(|i| {
            own[pattern.row_start()[i]..pattern.row_start()[i + 1]].fill(f64::NAN);
        });
        let rhs: Vec<f64> = (0..b.len()).map(|i| if owns(i) { b[i] } else { f64::NAN }).collect();
        solver.refactor(&pattern, &own).unwrap();
        let mut x = rhs.clone();
        let mut solved = solver.solve(&mut x);
        let mut block = [rhs.clone(), rhs.clone()].concat();
        solved = solved.and(solver.solve_many(&mut block, 2));
        assert_eq!(block, [x.clone(), x.clone()].concat());
        let mut transposed = b.clone();
        solved = solved.and(solver.solve_transpose(&mut transposed));
        let mut back = vec![0.0; b.len()];
        Matrix::new(&pattern, &values).multiply_transpose(&transposed, &mut back);
        assert!(error(&back, &b) < 1e-12);
        (solved, x)
    });
    for (solved, x) in found {
        assert_eq!(solved, Ok(()));
        assert!(error(&x, &reference) < 1e-12);
    }
}

/// Requirement: what one process sees wrong, all report alike, the first row first.
#[test]
fn failures_are_agreed_upon() {
    let (pattern, values, _) = system();
    for (bad, value) in [([7, 60], f64::NAN), ([60, 70], f64::INFINITY), ([7, 70], 0.0)] {
        let found = on_two_processes(|mut solver, _| {
            let mut own = values.clone();
            for i in bad {
                own[pattern.row_start()[i]..pattern.row_start()[i + 1]].fill(value);
            }
            (solver.refactor(&pattern, &own).map(|_| ()), Vec::new())
        });
        let expected = match value == 0.0 {
            true => SolveError::Singular { equation: bad[0], ratio: 0.0 },
            false => SolveError::NotFinite { equation: bad[0] },
        };
        assert!(found.iter().all(|(result, _)| *result == Err(expected)), "{found:?}");
    }
}
