//! Sparse matrices of one level, row after row, and their products.

use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;
use std::ops::Range;

/// Rows that a thread takes at a time.
const SHARE: usize = 2048;

/// A sparse matrix, row after row.
#[derive(Clone, Debug, Default)]
pub(super) struct Rows {
    pub start: Vec<usize>,
    pub column: Vec<u32>,
    pub value: Vec<f64>,
    /// Number of columns.
    pub width: usize,
}

impl Rows {
    /// Without rows so far.
    pub fn empty(width: usize) -> Self {
        Self { start: vec![0], width, ..Self::default() }
    }

    pub fn size(&self) -> usize {
        self.start.len() - 1
    }

    pub fn row(&self, i: usize) -> impl Iterator<Item = (usize, f64)> {
        let range = self.start[i]..self.start[i + 1];
        let columns = self.column[range.clone()].iter().map(|&j| j as usize);
        columns.zip(self.value[range].iter().copied())
    }

    /// Ends the row that was pushed.
    pub fn end_row(&mut self) {
        self.start.push(self.column.len());
    }

    fn row_times(&self, i: usize, x: &[f64]) -> f64 {
        let range = self.start[i]..self.start[i + 1];
        let (columns, values) = (&self.column[range.clone()], &self.value[range]);
        let mut part = [0.0; 4];
        let (fours, rest) = columns.as_chunks::<4>();
        let (values, value_rest) = values.as_chunks::<4>();
        for (columns, values) in fours.iter().zip(values) {
            for lane in 0..4 {
                part[lane] += values[lane] * x[columns[lane] as usize];
            }
        }
        for (&j, a) in rest.iter().zip(value_rest) {
            part[0] += a * x[j as usize];
        }
        (part[0] + part[1]) + (part[2] + part[3])
    }

    /// y = A x; every entry is one sum, whoever makes it.
    pub fn multiply(&self, x: &[f64], y: &mut [f64], threads: bool) {
        if threads {
            y.par_chunks_mut(SHARE).enumerate().for_each(|(share, y)| {
                let rows = (share * SHARE..).zip(y);
                rows.for_each(|(i, y)| *y = self.row_times(i, x));
            });
        } else {
            y.iter_mut().enumerate().for_each(|(i, y)| *y = self.row_times(i, x));
        }
    }

    /// y = A' x.
    pub fn multiply_transposed(&self, x: &[f64], y: &mut [f64]) {
        y.fill(0.0);
        for (i, &x) in x.iter().enumerate() {
            self.row(i).for_each(|(j, a)| y[j] += a * x);
        }
    }

    pub fn transposed(&self) -> Self {
        let mut start = vec![0; self.width + 1];
        self.column.iter().for_each(|&j| start[j as usize + 1] += 1);
        for j in 0..self.width {
            start[j + 1] += start[j];
        }
        let (mut column, mut value) = (vec![0; self.column.len()], vec![0.0; self.value.len()]);
        let mut next = start.clone();
        for i in 0..self.size() {
            for (j, a) in self.row(i) {
                (column[next[j]], value[next[j]]) = (i as u32, a);
                next[j] += 1;
            }
        }
        Self { start, column, value, width: self.size() }
    }

    /// A B, in shares of rows that threads may take.
    pub fn times(&self, other: &Self, threads: bool) -> Self {
        let share = |begin: usize| self.rows_times(begin..self.size().min(begin + SHARE), other);
        let begins = 0..self.size().div_ceil(SHARE);
        let parts: Vec<Self> = match threads {
            true => begins.into_par_iter().map(|at| share(at * SHARE)).collect(),
            false => begins.map(|at| share(at * SHARE)).collect(),
        };
        let mut product = Self::empty(other.width);
        let entries = parts.iter().map(|part| part.column.len()).sum();
        product.column.reserve_exact(entries);
        product.value.reserve_exact(entries);
        for part in parts {
            let before = product.column.len();
            product.start.extend(part.start[1..].iter().map(|end| before + end));
            product.column.extend(part.column);
            product.value.extend(part.value);
        }
        product
    }

    /// Some rows of A B.
    fn rows_times(&self, rows: Range<usize>, other: &Self) -> Self {
        let mut product = Self::empty(other.width);
        let mut place = vec![usize::MAX; other.width];
        for i in rows {
            let begin = product.column.len();
            for (k, a) in self.row(i) {
                for (j, b) in other.row(k) {
                    if place[j] == usize::MAX || place[j] < begin {
                        place[j] = product.column.len();
                        product.column.push(j as u32);
                        product.value.push(0.0);
                    }
                    product.value[place[j]] += a * b;
                }
            }
            product.end_row();
        }
        product
    }

    /// The diagonal; zero where a row has none.
    pub fn diagonal(&self) -> Vec<f64> {
        let own = |i: usize| self.row(i).find(|&(j, _)| j == i).map_or(0.0, |(_, a)| a);
        (0..self.size()).map(own).collect()
    }
}
