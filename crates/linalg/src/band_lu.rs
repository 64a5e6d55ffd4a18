//! Banded factorisation with partial pivoting, P A = L U.
//!
//! ```text
//!   row i:   columns  i-b .... i .... i+b .... i+2b
//!                     [ lower  | upper | fill by row exchanges ]
//! ```
//!
//! Rows are contiguous: an exchange swaps two short slices and an elimination subtracts one from
//! another. Multipliers are kept apart, column after column, and exchanges are replayed on the
//! right-hand side, as in LAPACK's `gbtrf`.

use crate::kernel::{BLOCK, dot_from_far, padded, subtract, subtract_lanes};

/// Evaluates an expression for a half-bandwidth, with loops of fixed lengths for those of plane beams,
/// alone and against a line with smoothed corners.
macro_rules! with_band {
    ($half_bandwidth:expr, $b:ident => $body:expr) => {
        match $half_bandwidth {
            5 => {
                let $b = 5;
                $body
            }
            7 => {
                let $b = 7;
                $body
            }
            8 => {
                let $b = 8;
                $body
            }
            $b => $body,
        }
    };
}

/// Length of a stored row, with padding.
#[inline(always)]
fn width(half_bandwidth: usize) -> usize {
    3 * half_bandwidth + BLOCK
}

/// Subtracts the multiples of an unknown from those behind it, in whole blocks where there are as many:
/// multipliers behind the band are zero.
#[inline(always)]
fn subtract_below<const M: usize>(x_j: &[f64; M], multipliers: &[f64], x: &mut [[f64; M]]) {
    if x.len() < multipliers.len() {
        for (x_i, l) in x.iter_mut().zip(multipliers) {
            subtract_lanes(x_i, *l, x_j);
        }
        return;
    }
    let blocks = x.as_chunks_mut::<BLOCK>().0.iter_mut();
    for (x_i, l) in blocks.zip(multipliers.as_chunks::<BLOCK>().0) {
        for k in 0..BLOCK {
            subtract_lanes(&mut x_i[k], l[k], x_j);
        }
    }
}

/// Storage and factors of a general band with equal half-bandwidths below and above.
#[derive(Clone, Debug, Default)]
pub(crate) struct BandLu {
    n: usize,
    half_bandwidth: usize,
    /// Rows; each diagonal holds the inverse of its pivot once factored.
    row: Vec<f64>,
    /// Multipliers, column after column, each padded with zeros to whole blocks.
    multiplier: Vec<f64>,
    exchange: Vec<u32>,
    /// Number of entries of each row of U.
    length: Vec<u32>,
    /// Inverse of the size of each row's diagonal before elimination.
    inverse_diagonal: Vec<f64>,
}

/// Smallest pivot of a factorisation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SmallestPivot {
    pub ratio: f64,
    pub at: usize,
}

impl BandLu {
    pub fn new(n: usize, half_bandwidth: usize) -> Self {
        Self {
            n,
            half_bandwidth,
            row: vec![0.0; n * width(half_bandwidth) + 1],
            multiplier: vec![0.0; n * padded(half_bandwidth)],
            exchange: vec![0; n],
            length: vec![0; n],
            inverse_diagonal: vec![0.0; n],
        }
    }

    /// Place of entry (i, j), |i - j| <= b, in the storage.
    pub fn place(&self, i: usize, j: usize) -> usize {
        i * width(self.half_bandwidth) + (j + self.half_bandwidth - i)
    }

    /// A place behind the matrix, for entries that do not belong to it.
    pub fn nowhere(&self) -> usize {
        self.n * width(self.half_bandwidth)
    }

    /// The storage, set to zero, to be filled with the matrix.
    pub fn clear(&mut self) -> &mut [f64] {
        self.row.fill(0.0);
        &mut self.row
    }

    /// Sets one entry by its place.
    pub fn set(&mut self, place: usize, value: f64) {
        self.row[place] = value;
    }

    /// Factors in place; `size` gives the size of each equation. The ratio of the smallest pivot is
    /// zero when a column had none; the factors are then of no use.
    pub fn factor(&mut self, size: impl Fn(usize) -> f64) -> SmallestPivot {
        self.note_diagonal();
        with_band!(self.half_bandwidth, b => self.factor_columns(b, size))
    }

    #[inline(always)]
    fn factor_columns(&mut self, b: usize, size: impl Fn(usize) -> f64) -> SmallestPivot {
        let mut smallest = SmallestPivot { ratio: f64::INFINITY, at: 0 };
        let mut last_column = 0;
        let mut judge = |j: usize, pivot: f64| {
            let (pivot, size) = (pivot.abs(), size(j));
            if pivot < smallest.ratio * size {
                smallest = SmallestPivot { ratio: pivot / size, at: j };
            }
            let usable = pivot > 0.0 && pivot.is_finite();
            if !usable {
                smallest = SmallestPivot { ratio: 0.0, at: j };
            }
            usable
        };
        let whole = self.n.saturating_sub(b);
        for j in 0..whole {
            let pivot = self.pivot(b, (j, b), &mut last_column);
            if !judge(j, pivot) {
                return smallest;
            }
            self.eliminate(b, (j, b));
        }
        for j in whole..self.n {
            let below = self.n - 1 - j;
            let pivot = self.pivot(b, (j, below), &mut last_column);
            if !judge(j, pivot) {
                return smallest;
            }
            self.eliminate(b, (j, below));
        }
        smallest
    }

    /// Exchanges the row to eliminate column `j` with, of so many below, to its place; its pivot.
    #[inline(always)]
    fn pivot(&mut self, b: usize, (j, below): (usize, usize), last_column: &mut usize) -> f64 {
        let pivot_row = self.find_pivot(b, (j, below));
        *last_column = (*last_column).max((pivot_row + b).min(self.n - 1));
        let length = *last_column - j + 1;
        self.exchange[j] = pivot_row as u32;
        self.length[j] = length as u32;
        if pivot_row != j {
            self.exchange_rows(j, pivot_row, length);
            self.inverse_diagonal.swap(j, pivot_row);
        }
        self.row[j * width(b) + b]
    }

    /// The row to eliminate column j with: the largest a_ij^2/|d_i|, with the row's own diagonal d_i
    /// before elimination. In a system of forces and moments that ratio compares energies, so that
    /// the choice does not depend on the units.
    #[inline(always)]
    fn find_pivot(&self, b: usize, (j, below): (usize, usize)) -> usize {
        let step = width(b) - 1;
        let column = &self.row[j * width(b) + b..][..=below * step];
        let inverse = &self.inverse_diagonal[j..=j + below];
        let merit = |p: usize| column[p * step] * column[p * step] * inverse[p];
        let (mut best, mut largest) = (0, merit(0));
        for p in 1..=below {
            let candidate = merit(p);
            if candidate > largest {
                (best, largest) = (p, candidate);
            }
        }
        j + best
    }

    /// Inverse magnitudes of the diagonal; where it is zero, of the row's largest entry.
    fn note_diagonal(&mut self) {
        let rows = self.row.chunks_exact(width(self.half_bandwidth));
        for ((i, row), inverse) in rows.enumerate().zip(&mut self.inverse_diagonal) {
            let own = row[self.half_bandwidth].abs();
            let first = self.half_bandwidth.saturating_sub(i);
            let last = self.half_bandwidth + self.half_bandwidth.min(self.n - 1 - i);
            let largest = || row[first..=last].iter().fold(0.0_f64, |a, entry| a.max(entry.abs()));
            let size = if own > 0.0 { own } else { largest() };
            *inverse = if size > 0.0 { 1.0 / size } else { 1.0 };
        }
    }

    fn exchange_rows(&mut self, j: usize, pivot_row: usize, length: usize) {
        let (from, to) = (self.place(j, j), self.place(pivot_row, j));
        let (head, tail) = self.row.split_at_mut(to);
        head[from..from + length].swap_with_slice(&mut tail[..length]);
    }

    #[inline(always)]
    fn eliminate(&mut self, b: usize, (j, below): (usize, usize)) {
        let step = width(b) - 1;
        let first = j * width(b) + b;
        let length = self.length[j] as usize;
        let (head, tail) = self.row.split_at_mut((j + 1) * width(b));
        let source = &mut head[first..];
        let inverse = 1.0 / source[0];
        source[0] = inverse;
        if below == 0 {
            return; // the last row, and every row of a diagonal matrix
        }
        let others = padded(length - 1);
        let source = &source[1..=others];
        let multipliers = &mut self.multiplier[j * padded(b)..][..below];
        // In the row p + 1 below, column j is stored one place further left for each row.
        let offset = first + step - (j + 1) * width(b);
        for (p, multiplier) in multipliers.iter_mut().enumerate() {
            let target = &mut tail[offset + p * step..][..=others];
            let factor = target[0] * inverse;
            *multiplier = factor;
            if factor != 0.0 {
                subtract(&mut target[1..], factor, source);
            }
        }
    }

    /// Solves in place, for every lane.
    pub fn solve<const M: usize>(&self, x: &mut [[f64; M]]) {
        with_band!(self.half_bandwidth, b => self.solve_columns(b, x))
    }

    #[inline(always)]
    fn solve_columns<const M: usize>(&self, b: usize, x: &mut [[f64; M]]) {
        let n = self.n;
        let columns = self.multiplier.chunks_exact(padded(b).max(1));
        for (j, multipliers) in (0..n).zip(columns) {
            let pivot_row = self.exchange[j] as usize;
            if pivot_row != j {
                x.swap(j, pivot_row);
            }
            let x_j = x[j];
            subtract_below(&x_j, multipliers, &mut x[j + 1..]);
        }
        for j in (0..n).rev() {
            let length = self.length[j] as usize;
            let row = &self.row[j * width(b) + b..][..length];
            let known = dot_from_far(&row[1..], &x[j + 1..j + length]);
            for (x_j, known) in x[j].iter_mut().zip(known) {
                *x_j = (*x_j - known) * row[0];
            }
        }
    }

    /// Solves the transposed system in place, for every lane: U' first, then L' with the exchanges
    /// in reverse.
    pub fn solve_transpose<const M: usize>(&self, x: &mut [[f64; M]]) {
        let (n, b) = (self.n, self.half_bandwidth);
        for j in 0..n {
            let length = self.length[j] as usize;
            let row = &self.row[self.place(j, j)..][..length];
            let x_j = x[j].map(|x_j| x_j * row[0]);
            x[j] = x_j;
            for (x_i, u) in x[j + 1..j + length].iter_mut().zip(&row[1..]) {
                subtract_lanes(x_i, *u, &x_j);
            }
        }
        for j in (0..n).rev() {
            let below = b.min(n - 1 - j);
            let multipliers = &self.multiplier[j * padded(b)..][..below];
            let known = dot_from_far(multipliers, &x[j + 1..=j + below]);
            x[j].iter_mut().zip(known).for_each(|(x_j, known)| *x_j -= known);
            let pivot_row = self.exchange[j] as usize;
            if pivot_row != j {
                x.swap(j, pivot_row);
            }
        }
    }
}
