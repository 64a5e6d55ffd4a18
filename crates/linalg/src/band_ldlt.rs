//! Symmetric banded factorisation without pivoting, A = L D L'.
//!
//! ```text
//!   a                    column j is stored as  [ d_j | l_{j+1,j} ... l_{j+b,j} ]
//!   x a                  one after the other, so that all loops run over contiguous memory
//!   x x a
//!   . x x a   b = 2
//! ```
//!
//! Without pivoting the backward error is bounded by eps |L||D||L'|, whose diagonal is summed on
//! the way: growth beyond a limit ends the factorisation, so that accuracy is never lost silently.

use crate::kernel::{BLOCK, dot_from_far, padded, subtract, subtract_lanes};

/// Growth of the terms of a diagonal, relative to the size of its equation, beyond which the
/// factorisation is given up: leaves a backward error of 1e-10 at worst, which one step of
/// refinement removes.
const LARGEST_GROWTH: f64 = 1e6;

/// Storage and factors of a symmetric band.
#[derive(Clone, Debug, Default)]
pub(crate) struct BandLdlt {
    n: usize,
    half_bandwidth: usize,
    /// Length of a stored column, with padding.
    width: usize,
    /// Columns; each begins with the inverse of its pivot once factored.
    column: Vec<f64>,
    /// Sum of magnitudes of the terms each diagonal is made of.
    terms: Vec<f64>,
}

/// Pivots of a finished factorisation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pivots {
    pub negative: usize,
    pub smallest_ratio: f64,
    pub smallest: usize,
}

impl BandLdlt {
    pub fn new(n: usize, half_bandwidth: usize) -> Self {
        let width = half_bandwidth + BLOCK;
        Self { n, half_bandwidth, width, column: vec![0.0; n * width + 1], terms: vec![0.0; n] }
    }

    /// Place of entry (i, j), i >= j, in the storage.
    pub fn place(&self, i: usize, j: usize) -> usize {
        j * self.width + (i - j)
    }

    /// A place behind the matrix, for entries that do not belong to it.
    pub fn nowhere(&self) -> usize {
        self.n * self.width
    }

    /// The storage, set to zero, to be filled with the lower triangle.
    pub fn clear(&mut self) -> &mut [f64] {
        self.column.fill(0.0);
        &mut self.column
    }

    /// Sets one entry by its place.
    pub fn set(&mut self, place: usize, value: f64) {
        self.column[place] = value;
    }

    /// Factors in place; `size` gives the size of each equation. `None` when a pivot is zero or the
    /// terms grow too much.
    pub fn factor(&mut self, size: impl Fn(usize) -> f64) -> Option<Pivots> {
        if self.n == 0 {
            return None;
        }
        for (terms, column) in self.terms.iter_mut().zip(self.column.chunks_exact(self.width)) {
            *terms = column[0].abs();
        }
        let mut pivots = Pivots { negative: 0, smallest_ratio: f64::INFINITY, smallest: 0 };
        for j in 0..self.n {
            let (pivot, terms) = (self.column[j * self.width], self.terms[j]);
            let usable = pivot != 0.0 && terms <= LARGEST_GROWTH * size(j);
            if !usable {
                return None;
            }
            if pivot.abs() < pivots.smallest_ratio * terms {
                pivots.smallest_ratio = pivot.abs() / terms;
                pivots.smallest = j;
            }
            pivots.negative += usize::from(pivot < 0.0);
            self.eliminate(j, 1.0 / pivot);
        }
        Some(pivots)
    }

    fn eliminate(&mut self, j: usize, inverse: f64) {
        let width = self.width;
        let (head, tail) = self.column.split_at_mut((j + 1) * width);
        let reach = self.half_bandwidth.min(self.n - 1 - j);
        let column = &mut head[j * width..];
        let terms = &mut self.terms[j + 1..=j + reach];
        for ((p, target), terms) in (1..).zip(tail.chunks_exact_mut(width)).zip(terms) {
            let factor = column[p] * inverse;
            if factor != 0.0 {
                *terms += (factor * column[p]).abs();
                let length = padded(reach - p + 1);
                subtract(&mut target[..length], factor, &column[p..p + length]);
            }
        }
        column[1..=reach].iter_mut().for_each(|c| *c *= inverse);
        column[0] = inverse;
    }

    /// Solves in place, for every lane.
    pub fn solve<const M: usize>(&self, x: &mut [[f64; M]]) {
        let (n, width) = (self.n, self.width);
        for j in 0..n {
            let reach = self.half_bandwidth.min(n - 1 - j);
            let column = &self.column[j * width..][..=reach];
            let x_j = x[j];
            for (x_i, l) in x[j + 1..=j + reach].iter_mut().zip(&column[1..]) {
                subtract_lanes(x_i, *l, &x_j);
            }
        }
        for j in (0..n).rev() {
            let reach = self.half_bandwidth.min(n - 1 - j);
            let column = &self.column[j * width..][..=reach];
            let known = dot_from_far(&column[1..], &x[j + 1..=j + reach]);
            for (x_j, known) in x[j].iter_mut().zip(known) {
                *x_j = *x_j * column[0] - known;
            }
        }
    }
}
