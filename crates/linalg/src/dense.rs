//! Dense systems, small ones: elimination with row exchanges that bears dependent rows.
//!
//! ```text
//!   | 2 1 0 |       | 2 1 0 |     the last row is the sum of the others: nothing but rounding is
//!   | 1 3 1 |  -->  | . x 1 |     left of it, so its unknown is given the value zero and the others
//!   | 3 4 1 |       | . . 0 |     are solved without it
//! ```

use crate::error::SolveError;
use faer::linalg::matmul::matmul;
use faer::{Accum, MatMut, MatRef, Par};

/// Columns that are eliminated one by one; what they leave of the others is a matrix product.
const PANEL: usize = 48;
/// Pivot, relative to the largest entry of the matrix, below which a row depends on the others.
const DEPENDENT: f64 = 1e-14;

/// Factors of a dense matrix, P A = L U, and the memory for them, which is kept: factoring a matrix
/// no larger than one before allocates nothing.
#[derive(Clone, Debug, Default)]
pub struct DenseLu {
    n: usize,
    /// Row after row; multipliers below the diagonal.
    matrix: Vec<f64>,
    /// Of each column: the row it was exchanged with.
    exchange: Vec<usize>,
    /// Of each column: whether nothing was left to eliminate it with.
    dependent: Vec<bool>,
}

impl DenseLu {
    /// Room for `n` equations: a matrix of zeros, row after row, to be filled before
    /// [`DenseLu::factor`].
    pub fn matrix_mut(&mut self, n: usize) -> &mut [f64] {
        self.n = n;
        self.matrix.clear();
        self.matrix.resize(n * n, 0.0);
        &mut self.matrix
    }

    /// Factors what was filled in. Returns the number of columns that depend on the others.
    pub fn factor(&mut self) -> usize {
        let n = self.n;
        let scale = self.matrix.iter().fold(0.0_f64, |largest, entry| largest.max(entry.abs()));
        self.exchange.clear();
        self.dependent.clear();
        self.exchange.reserve(n);
        self.dependent.reserve(n);
        for from in (0..n).step_by(PANEL) {
            let to = (from + PANEL).min(n);
            for k in from..to {
                let size = |row: &usize| self.matrix[row * n + k].abs();
                let pivot = (k..n).max_by(|a, b| size(a).total_cmp(&size(b))).unwrap_or(k);
                self.exchange.push(pivot);
                if pivot != k {
                    let (upper, lower) = self.matrix.split_at_mut(pivot * n);
                    upper[k * n..(k + 1) * n].swap_with_slice(&mut lower[..n]);
                }
                let dependent = self.matrix[k * n + k].abs() <= DEPENDENT * scale;
                self.dependent.push(dependent);
                self.eliminate(k, to, dependent);
            }
            self.eliminate_behind(from, to);
        }
        self.dependent.iter().filter(|&&dependent| dependent).count()
    }

    /// The first column that depends on those before it.
    pub fn first_dependent(&self) -> Option<usize> {
        self.dependent.iter().position(|&dependent| dependent)
    }

    /// Eliminates column k from the columns up to `to`.
    fn eliminate(&mut self, k: usize, to: usize, dependent: bool) {
        let n = self.n;
        let (upper, lower) = self.matrix.split_at_mut((k + 1) * n);
        let source = &mut upper[k * n + k..k * n + to];
        if dependent {
            source.fill(0.0);
            source[0] = 1.0;
            lower.chunks_exact_mut(n).for_each(|row| row[k] = 0.0);
            return;
        }
        for row in lower.chunks_exact_mut(n) {
            let factor = row[k] / source[0];
            row[k] = factor;
            if factor != 0.0 {
                for (entry, s) in row[k + 1..to].iter_mut().zip(&source[1..]) {
                    *entry -= factor * s;
                }
            }
        }
    }

    /// Eliminates the columns `from` to `to`, whose factors are there, from all columns behind them.
    fn eliminate_behind(&mut self, from: usize, to: usize) {
        let n = self.n;
        if to == n {
            return;
        }
        let (upper, lower) = self.matrix.split_at_mut(to * n);
        for k in from..to {
            let (known, rest) = upper.split_at_mut(k * n);
            let (factors, own) = rest[..n].split_at_mut(to);
            for (row, &factor) in known.chunks_exact(n).skip(from).zip(&factors[from..k]) {
                own.iter_mut().zip(&row[to..]).for_each(|(entry, u)| *entry -= factor * u);
            }
            if self.dependent[k] {
                own.fill(0.0);
            }
        }
        let above = MatRef::from_row_major_slice(&upper[from * n..], to - from, n);
        let (_, above) = above.split_at_col(to);
        let below = MatMut::from_row_major_slice_mut(lower, n - to, n);
        let (left, right) = below.split_at_col_mut(to);
        let (_, left) = left.as_ref().split_at_col(from);
        matmul(right, Accum::Add, left, above, -1.0, Par::Seq);
    }

    /// Solves A x = b in place, with as many equations as were factored. The unknown of a dependent
    /// column is zero, and the row that is left over is not met.
    ///
    /// Errors: [`SolveError::Size`].
    pub fn solve(&self, rhs: &mut [f64]) -> Result<(), SolveError> {
        let n = self.n;
        if rhs.len() != n {
            return Err(SolveError::Size { expected: n, found: rhs.len() });
        }
        if self.exchange.len() != n {
            return Err(SolveError::NotFactored);
        }
        for (k, &pivot) in self.exchange.iter().enumerate() {
            rhs.swap(k, pivot);
        }
        let rows = || self.matrix.chunks_exact(n.max(1)).enumerate();
        for (i, row) in rows() {
            let (known, rest) = rhs.split_at_mut(i);
            for (l, x) in row.iter().zip(known) {
                rest[0] -= l * *x;
            }
            if self.dependent[i] {
                rest[0] = 0.0;
            }
        }
        for (i, row) in rows().rev() {
            let known: f64 = row[i + 1..].iter().zip(&rhs[i + 1..]).map(|(u, x)| u * x).sum();
            rhs[i] = (rhs[i] - known) / row[i];
        }
        Ok(())
    }
}

/// Reduces rows of `width` numbers, stored one after another, until each column that has a pivot has
/// no other entry (Gauss and Jordan, with row exchanges): first come the rows with pivots, in the
/// order of their columns, each holding its own multiple of the pivot. An entry not above `zero` is
/// no pivot; `pivots` receives the columns that have one, whose number is the rank.
///
/// A motion that the rows do not hinder: one at a column without pivot, and at the pivot of each row
/// minus that column's entry through the pivot.
pub fn reduce_rows(rows: &mut [f64], width: usize, zero: f64, pivots: &mut Vec<usize>) {
    pivots.clear();
    let count = rows.len() / width.max(1);
    for column in 0..width {
        let from = pivots.len();
        let size = |row: &usize| rows[row * width + column].abs();
        let largest = (from..count).max_by(|a, b| size(a).total_cmp(&size(b)));
        let Some(largest) = largest.filter(|row| size(row) > zero) else { continue };
        if largest != from {
            let (upper, lower) = rows.split_at_mut(largest * width);
            upper[from * width..][..width].swap_with_slice(&mut lower[..width]);
        }
        let (before, rest) = rows.split_at_mut(from * width);
        let (pivot, after) = rest.split_at_mut(width);
        for row in before.chunks_exact_mut(width).chain(after.chunks_exact_mut(width)) {
            let factor = row[column] / pivot[column];
            if factor != 0.0 {
                row.iter_mut().zip(&*pivot).for_each(|(entry, p)| *entry -= factor * p);
                row[column] = 0.0;
            }
        }
        pivots.push(column);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn solve(n: usize, matrix: &[f64], rhs: &[f64]) -> (usize, Vec<f64>) {
        let mut lu = DenseLu::default();
        lu.matrix_mut(n).copy_from_slice(matrix);
        let dependent = lu.factor();
        let mut x = rhs.to_vec();
        lu.solve(&mut x).unwrap();
        (dependent, x)
    }

    /// Requirement: a regular system that needs exchanges in every column is solved to rounding;
    /// integers make the answer exact to a few roundings.
    #[test]
    fn exchanges_are_replayed() {
        let matrix =
            [0.0, 2.0, 1.0, 3.0, 1.0, 0.0, 0.0, 1.0, 4.0, 0.0, 5.0, 2.0, 2.0, 3.0, 0.0, 1.0];
        let x = [1.0, -2.0, 3.0, 0.5];
        let b: Vec<f64> =
            matrix.chunks(4).map(|row| row.iter().zip(x).map(|(a, x)| a * x).sum()).collect();
        let (dependent, found) = solve(4, &matrix, &b);
        assert_eq!(dependent, 0);
        found.iter().zip(x).for_each(|(a, b)| assert!((a - b).abs() < 1e-14, "{found:?}"));
    }

    /// Requirement: a row that depends on the others gets a zero change, and the others are met;
    /// source: the treatment of overconstrained contact points.
    #[test]
    fn a_dependent_row_gets_zero() {
        let matrix = [2.0, 1.0, 0.0, 1.0, 3.0, 1.0, 3.0, 4.0, 1.0];
        let (dependent, x) = solve(3, &matrix, &[3.0, 4.0, 7.0]);
        assert_eq!((dependent, x[2]), (1, 0.0));
        assert!((2.0 * x[0] + x[1] - 3.0).abs() < 1e-14);
        assert!((x[0] + 3.0 * x[1] - 4.0).abs() < 1e-14);
        let (dependent, x) = solve(2, &[0.0; 4], &[1.0, 1.0]);
        assert_eq!((dependent, x), (2, vec![0.0, 0.0]));
    }

    /// Requirement: panels and what they leave of the columns behind them give what elimination one
    /// by one gives: regular systems of several panels are solved to rounding, and rows that depend on
    /// others within their panel and beyond it are found, get zero, and leave all other rows met.
    #[test]
    fn many_equations_are_solved_as_few() {
        let n = 3 * PANEL + 7;
        let mut seed = 7_u64;
        let mut random = || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        let mut matrix: Vec<f64> = (0..n * n).map(|_| random()).collect();
        let times = |matrix: &[f64], x: &[f64]| -> Vec<f64> {
            let row = |row: &[f64]| row.iter().zip(x).map(|(a, x)| a * x).sum();
            matrix.chunks(n).map(row).collect()
        };
        let x: Vec<f64> = (0..n).map(|_| random()).collect();
        let (dependent, found) = solve(n, &matrix, &times(&matrix, &x));
        assert_eq!(dependent, 0);
        found.iter().zip(&x).for_each(|(a, b)| assert!((a - b).abs() < 1e-10));
        // columns that are those before them, in the same panel and in earlier ones
        for (copy, of) in [(5, 2), (PANEL + 3, 9), (2 * PANEL + 1, 2 * PANEL), (n - 1, 0)] {
            matrix.chunks_mut(n).for_each(|row| row[copy] = row[of]);
        }
        let rhs = times(&matrix, &x);
        let (dependent, found) = solve(n, &matrix, &rhs);
        assert_eq!(dependent, 4);
        for copy in [5, PANEL + 3, 2 * PANEL + 1, n - 1] {
            assert_eq!(found[copy], 0.0);
        }
        let left = times(&matrix, &found);
        left.iter().zip(&rhs).for_each(|(a, b)| assert!((a - b).abs() < 1e-10, "{a} {b}"));
    }

    /// Requirement: memory is kept; wrong lengths are refused.
    #[test]
    fn memory_is_kept_and_lengths_are_checked() {
        let mut lu = DenseLu::default();
        let first = lu.matrix_mut(5).as_ptr();
        assert_eq!(lu.solve(&mut [0.0; 5]), Err(SolveError::NotFactored));
        lu.matrix_mut(3).copy_from_slice(&[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]);
        lu.factor();
        assert_eq!(lu.matrix.as_ptr(), first);
        assert_eq!(lu.solve(&mut [0.0; 5]), Err(SolveError::Size { expected: 3, found: 5 }));
        lu.matrix_mut(0);
        assert_eq!((lu.factor(), lu.solve(&mut [])), (0, Ok(())));
    }

    /// Requirement: rank and free motions of a body with supports; source: statics. Two supports in
    /// y at x = 0 and x = 2 leave the motion in x free (columns: u, v, turn).
    #[test]
    fn free_motions() {
        let mut pivots = Vec::new();
        let mut rows = [0.0, 1.0, 0.0, 0.0, 1.0, 2.0, 0.0, 2.0, 2.0];
        reduce_rows(&mut rows, 3, 1e-9, &mut pivots);
        assert_eq!(pivots, [1, 2]);
        let shares = [rows[1] / rows[1], rows[2], rows[4], rows[5] / rows[5]];
        assert_eq!((shares, rows[6..].to_vec()), ([1.0, 0.0, 0.0, 1.0], vec![0.0; 3]));
        let mut slanted = [1.0, 1.0, 0.0];
        reduce_rows(&mut slanted, 3, 1e-9, &mut pivots);
        assert_eq!((pivots.as_slice(), slanted), (&[0][..], [1.0, 1.0, 0.0]));
        reduce_rows(&mut [], 3, 1e-9, &mut pivots);
        assert!(pivots.is_empty());
    }
}
