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

use crate::kernel::{BLOCK, dot_from_far, padded, subtract_columns, subtract_lanes, widened};

/// Growth of the terms of a diagonal, relative to the size of its equation, beyond which the
/// factorisation is given up: leaves a backward error of 1e-10 at worst, which one step of
/// refinement removes.
const LARGEST_GROWTH: f64 = 1e6;

/// Columns that are eliminated together from those behind them. A stored column has so many zeros
/// behind its band, and as many more as fill blocks.
const TOGETHER: usize = 4;

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
        let width = half_bandwidth + TOGETHER + BLOCK - 1;
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
        widened(
            #[inline(always)]
            || self.factor_columns(size),
        )
    }

    #[inline(always)]
    fn factor_columns(&mut self, size: impl Fn(usize) -> f64) -> Option<Pivots> {
        if self.n == 0 {
            return None;
        }
        for (terms, column) in self.terms.iter_mut().zip(self.column.chunks_exact(self.width)) {
            *terms = column[0].abs();
        }
        let mut pivots = Pivots { negative: 0, smallest_ratio: f64::INFINITY, smallest: 0 };
        for first in (0..self.n).step_by(TOGETHER) {
            let end = self.n.min(first + TOGETHER);
            let mut inverse = [0.0; TOGETHER];
            for j in first..end {
                inverse[j - first] = 1.0 / self.note(j, size(j), &mut pivots)?;
                self.eliminate_near(j, end, inverse[j - first]);
            }
            if end < self.n {
                self.eliminate_beyond(first, &inverse);
            }
            for (column, inverse) in
                self.column[first * self.width..].chunks_exact_mut(self.width).zip(inverse)
            {
                column[1..=self.half_bandwidth].iter_mut().for_each(|c| *c *= inverse);
                column[0] = inverse;
            }
        }
        Some(pivots)
    }

    /// The pivot of a column, noted; `None` where it cannot be used.
    fn note(&self, j: usize, size: f64, pivots: &mut Pivots) -> Option<f64> {
        let (pivot, terms) = (self.column[j * self.width], self.terms[j]);
        let usable = pivot != 0.0 && terms <= LARGEST_GROWTH * size;
        if !usable {
            return None;
        }
        if pivot.abs() < pivots.smallest_ratio * terms {
            pivots.smallest_ratio = pivot.abs() / terms;
            pivots.smallest = j;
        }
        pivots.negative += usize::from(pivot < 0.0);
        Some(pivot)
    }

    /// Eliminates column `j` from those up to `end`.
    #[inline(always)]
    fn eliminate_near(&mut self, j: usize, end: usize, inverse: f64) {
        let width = self.width;
        let (head, tail) = self.column.split_at_mut((j + 1) * width);
        let column = &head[j * width..];
        let terms = &mut self.terms[j + 1..end];
        for ((p, target), terms) in (1..).zip(tail.chunks_exact_mut(width)).zip(terms) {
            let factor = column[p] * inverse;
            *terms += (factor * column[p]).abs();
            subtract_columns(&mut target[..width - p], [&column[p..]], [factor]);
        }
    }

    /// Eliminates the columns from `first` on, which are done with one another, from those behind
    /// them: every entry is read and written once, and the columns subtracted in their order.
    #[inline(always)]
    fn eliminate_beyond(&mut self, first: usize, inverse: &[f64; TOGETHER]) {
        let (width, behind) = (self.width, first + TOGETHER);
        let (head, tail) = self.column.split_at_mut(behind * width);
        let columns: [&[f64]; TOGETHER] =
            std::array::from_fn(|m| &head[(first + m) * width..(first + m + 1) * width]);
        let targets = tail.chunks_exact_mut(width).zip(&mut self.terms[behind..]);
        for (i, (target, terms)) in targets.take(self.half_bandwidth).enumerate() {
            // what is behind the band are zeros
            let length = padded(self.half_bandwidth - i);
            let from: [&[f64]; TOGETHER] =
                std::array::from_fn(|m| &columns[m][TOGETHER - m + i..][..length]);
            let factors = std::array::from_fn(|m| from[m][0] * inverse[m]);
            for m in 0..TOGETHER {
                *terms += (factors[m] * from[m][0]).abs();
            }
            if factors != [0.0; TOGETHER] {
                subtract_columns(&mut target[..length], from, factors);
            }
        }
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

#[cfg(test)]
mod tests {
    use super::*;

    /// The lower triangle of a band, row after row: its diagonal is as large as the rest of a row.
    fn entry(i: usize, j: usize) -> f64 {
        let random = ((i * 7919 + j * 104_729) % 1009) as f64 / 1009.0 - 0.5;
        if i == j { 20.0 + random } else { random }
    }

    /// Column after column, each from all behind it as soon as it is known.
    fn one_by_one(n: usize, band: usize) -> Vec<Vec<f64>> {
        let within = |i: usize, j: usize| i >= j && i - j <= band;
        let row = |i| (0..n).map(|j| if within(i, j) { entry(i, j) } else { 0.0 }).collect();
        let mut all: Vec<Vec<f64>> = (0..n).map(row).collect();
        for j in 0..n {
            let inverse = 1.0 / all[j][j];
            for i in j + 1..n {
                let factor = all[i][j] * inverse;
                (i..n).for_each(|k| all[k][i] -= factor * all[k][j]);
            }
            (j + 1..n).for_each(|i| all[i][j] *= inverse);
            all[j][j] = inverse;
        }
        all
    }

    /// Requirement: columns that are eliminated together give the bits of columns that are eliminated
    /// one by one, for bands narrower and wider than so many and of any number of columns.
    #[test]
    fn columns_together_have_the_bits_of_columns_one_by_one() {
        for (n, band) in
            [(1, 0), (5, 0), (6, 1), (7, 2), (9, 3), (13, 4), (30, 5), (31, 17), (8, 7)]
        {
            let mut own = BandLdlt::new(n, band);
            own.clear();
            for j in 0..n {
                (j..n.min(j + band + 1)).for_each(|i| own.set(own.place(i, j), entry(i, j)));
            }
            let pivots = own.factor(|_| 40.0).unwrap();
            assert_eq!(pivots.negative, 0);
            let all = one_by_one(n, band);
            for (i, row) in all.iter().enumerate() {
                for (j, entry) in row.iter().enumerate().take(i + 1).skip(i.saturating_sub(band)) {
                    let bits = own.column[own.place(i, j)].to_bits();
                    assert_eq!(bits, entry.to_bits(), "{n} {band}: {i} {j}");
                }
            }
        }
    }

    /// Requirement: negative pivots are counted wherever they stand among columns that go together, and a zero one ends it.
    #[test]
    fn pivots_are_judged_one_by_one() {
        let (n, band) = (11, 3);
        for odd in 0..n {
            for (diagonal, expected) in [(-20.0, Some(1)), (0.0, None)] {
                let mut own = BandLdlt::new(n, band);
                own.clear();
                for j in 0..n {
                    for i in j..n.min(j + band + 1) {
                        let apart = i != j && i.max(j) != odd && i.min(j) != odd;
                        let value = match i == j {
                            true => {
                                if j == odd {
                                    diagonal
                                } else {
                                    entry(j, j)
                                }
                            }
                            false => {
                                if apart {
                                    entry(i, j)
                                } else {
                                    0.0
                                }
                            }
                        };
                        own.set(own.place(i, j), value);
                    }
                }
                let pivots = own.factor(|_| 40.0);
                assert_eq!(pivots.map(|pivots| pivots.negative), expected, "{odd} {diagonal}");
            }
        }
    }
}
