//! Conjugate gradients with a multigrid cycle: smoothed aggregation with rigid motions.
//!
//! ```text
//!   fine    o o o o o o o o o      x --smooth--> residual        + correction --smooth--> x
//!           \___/ \___/ \___/                        \ P'          / P
//!   coarse    A     B     C                            A_c e = P' r   (six motions a vertex)
//! ```
//!
//! [vanek1996]: vertices (the equations of a node) that hang together become one vertex of the next
//! level, whose unknowns are the motions that cost no energy there; one Jacobi step smooths them.
//! [adams2003] for the polynomial smoother. For definite matrices only: where the iteration meets a
//! direction of no or negative curvature, or does not converge, the direct factorisation takes over.
//! Solutions are accurate to a tolerance near rounding, and have the same bits on any number of
//! threads.

mod aggregates;
mod hierarchy;
mod rows;

use crate::conjugate::{Conjugate, Definite};
use crate::error::{FactorReport, SolveError};
use crate::krylov::Stop;
use crate::pattern::{Matrix, Pattern};
use crate::sparse::Sparse;
use crate::system::{BackEnd, Description, Kind, LinearSystem};
use hierarchy::{Hierarchy, Room};
use rayon::ThreadPool;
use std::sync::Arc;

/// Part of the right-hand side that the residual of a solution may be, and the iterations after
/// which the direct factorisation is the better choice.
const ENOUGH: Stop = Stop { tolerance: 1e-11, iterations: 120 };
/// Seconds of a factorisation with one solution, for each entry of the pattern (measured).
const SECONDS: f64 = 1e-6;
/// Bytes for each entry of the pattern.
const BYTES: f64 = 40.0;

/// Conjugate gradients with a multigrid cycle, and what takes their place where they fail.
pub(crate) struct Multigrid {
    pattern: Pattern,
    values: Vec<f64>,
    /// Rigid motions of the unknowns, a column each.
    motions: Vec<f64>,
    hierarchy: Option<Hierarchy>,
    direct: Sparse,
    /// Whether the direct factorisation has been made of these values.
    factored: bool,
    row_size: Vec<f64>,
    pool: Option<Arc<ThreadPool>>,
}

impl Multigrid {
    /// Beside a direct factorisation that has been analysed.
    pub fn new(pattern: &Pattern, direct: Sparse, pool: Option<Arc<ThreadPool>>) -> Self {
        Self {
            pattern: pattern.clone(),
            values: Vec::new(),
            motions: Vec::new(),
            hierarchy: None,
            direct,
            factored: false,
            row_size: Vec::new(),
            pool,
        }
    }

    /// Rough time of a factorisation with one solution [s].
    pub fn seconds(pattern: &Pattern) -> f64 {
        SECONDS * pattern.entries() as f64
    }

    /// Solves by iteration; false where that does not get to the tolerance.
    fn iterate(&self, b: &mut [f64]) -> bool {
        let Some(hierarchy) = &self.hierarchy else { return false };
        let mut cycle = Cycle { hierarchy, room: hierarchy.room() };
        let mut solve = || Conjugate::default().solve(b, ENOUGH, &mut cycle);
        match &self.pool {
            Some(pool) => pool.install(solve),
            None => solve(),
        }
    }

    fn factor_directly(&mut self) -> Result<FactorReport, SolveError> {
        self.hierarchy = None; // its memory is needed now
        let matrix = Matrix::new(&self.pattern, &self.values);
        self.direct.scatter(matrix);
        let report = self.direct.factor(matrix, &self.row_size)?;
        self.factored = true;
        Ok(report)
    }
}

/// The finest matrix of a hierarchy and a cycle as what is near its inverse.
struct Cycle<'a> {
    hierarchy: &'a Hierarchy,
    room: Room,
}

impl Definite for Cycle<'_> {
    fn multiply(&mut self, x: &[f64], y: &mut [f64]) {
        self.hierarchy.multiply(x, y);
    }

    fn precondition(&mut self, r: &[f64], z: &mut [f64]) -> bool {
        self.hierarchy.precondition(r, z, &mut self.room);
        true
    }
}

impl LinearSystem for Multigrid {
    fn scatter(&mut self, matrix: Matrix<'_>) {
        self.values.clear();
        self.values.extend_from_slice(matrix.values);
        self.factored = false;
        self.hierarchy = None;
    }

    fn factor(&mut self, _: Matrix<'_>, row_size: &[f64]) -> Result<FactorReport, SolveError> {
        self.row_size.clear();
        self.row_size.extend_from_slice(row_size);
        let make =
            || Hierarchy::new(&self.pattern, &self.values, &self.motions, self.pool.is_some());
        self.hierarchy = match &self.pool {
            Some(pool) => pool.install(make),
            None => make(),
        };
        let sign = |i: usize| if (i * 7 + i / 3) % 5 < 2 { -1.0 } else { 1.0 };
        let mut trial: Vec<f64> = row_size.iter().enumerate().map(|(i, r)| sign(i) * r).collect();
        match self.hierarchy.is_some() && self.iterate(&mut trial) {
            true => Ok(FactorReport { negative_pivots: None, ..FactorReport::EMPTY }),
            false => self.factor_directly(),
        }
    }

    fn solve(&mut self, block: &mut [f64], columns: usize) -> Result<(), SolveError> {
        let n = self.pattern.size();
        for column in block.chunks_exact_mut(n.max(1)).take(columns) {
            if self.factored || !self.iterate(column) {
                if !self.factored {
                    self.factor_directly()?;
                }
                self.direct.solve(column, 1)?;
            }
        }
        Ok(())
    }

    fn solve_transpose(&mut self, block: &mut [f64], columns: usize) -> Result<(), SolveError> {
        self.solve(block, columns)
    }

    fn take_motions(&mut self, motions: &[f64]) {
        self.motions.clear();
        self.motions.extend_from_slice(motions);
    }

    fn description(&self) -> Description {
        let direct = self.direct.description();
        match self.motions.is_empty() || self.factored {
            true => direct,
            false => Description {
                back_end: BackEnd::Multigrid,
                kind: Kind::Symmetric,
                bytes: BYTES * self.pattern.entries() as f64,
                ..direct
            },
        }
    }
}

#[cfg(test)]
mod tests;
