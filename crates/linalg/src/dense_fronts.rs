//! Dense work of one front: elimination of its columns, and what is left for its parent.
//!
//! ```text
//!            columns  rows
//!           +--------+-----+     panel   = columns, all of them: L below, U (or D) on and above
//!   columns | L\U    | U12 |     above   = U12, of unsymmetric fronts
//!           +--------+-----+     update  = the Schur complement, handed to the parent
//!   rows    | L21    | F22 |
//!           +--------+-----+     all column after column
//! ```
//!
//! Pivots are sought among the front's own columns only (static structure); what is too small is
//! replaced and reported. Columns are halved until they are few [toledo1997], so that nearly all
//! work is matrix products.

use crate::kernel::widened;
use crate::precision::Real;
use faer::linalg::matmul::{matmul, triangular};
use faer::linalg::triangular_solve::solve_unit_lower_triangular_in_place;
use faer::prelude::{Reborrow, ReborrowMut};
use faer::{Accum, MatMut, MatRef, Par};

/// Number of columns that are eliminated one by one.
const NARROW: usize = 8;
/// Rows of them that are eliminated together.
const ROWS: usize = 8;
/// Rows and columns of a product that one thread makes at a time.
const TILE: usize = 512;
/// Part of the largest candidate from which on the diagonal is kept as pivot: a front keeps its
/// order, and nearly symmetric matrices their structure of errors.
const KEPT: f64 = 0.1;

/// Pivots so far.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pivots {
    pub negative: usize,
    pub smallest_ratio: f64,
    /// Position of the smallest in the order of elimination.
    pub smallest: usize,
}

impl Pivots {
    pub const NONE: Self = Self { negative: 0, smallest_ratio: f64::INFINITY, smallest: 0 };

    /// Pivots of other equations with these.
    pub fn with(self, other: Self) -> Self {
        let order = other.smallest_ratio.total_cmp(&self.smallest_ratio);
        let smaller = order.then(other.smallest.cmp(&self.smallest)).is_lt();
        let smallest = if smaller { other } else { self };
        Self { negative: self.negative + other.negative, ..smallest }
    }

    /// Notes a pivot of the equation at position `at`; returns it, or where it is no more than
    /// rounding what replaces it: half of all digits of the equation's size, the best compromise
    /// between growth and error [li1998]. What is no number counts as negative.
    fn note<T: Real>(&mut self, entry: T, size: f64, at: usize) -> T {
        let pivot = entry.to_double();
        let ratio = pivot.abs() / size;
        let usual = ratio >= self.smallest_ratio;
        if !usual {
            (self.smallest_ratio, self.smallest) = (ratio, at);
        }
        self.negative += usize::from(pivot < 0.0 || pivot.is_nan());
        match ratio > T::ROUNDING {
            true => entry,
            false => T::from_double((T::HALF * size).copysign(pivot)),
        }
    }
}

/// A front at work: its columns are at positions from `first` on.
pub(crate) struct DenseFront<'a, T> {
    pub panel: &'a mut [T],
    /// Empty for symmetric fronts.
    pub above: &'a mut [T],
    pub update: &'a mut [T],
    pub columns: usize,
    pub rows: usize,
    /// Position of the first column.
    pub first: usize,
    /// Whether threads share the products.
    pub threads: bool,
}

impl<T: Real> DenseFront<'_, T> {
    fn height(&self) -> usize {
        self.columns + self.rows
    }

    /// P A = L U of the columns with exchanges among them, then U12 and F22. `size` holds the sizes
    /// of the front's equations; `exchange` receives the row that each column was exchanged with.
    pub fn factor_lu(&mut self, size: &[f64], exchange: &mut [u32], pivots: &mut Pivots) {
        self.lu_of_columns(0, self.columns, size, exchange, pivots);
        let (k, r) = (self.columns, self.rows);
        if r == 0 {
            return;
        }
        if exchange.iter().enumerate().any(|(j, &row)| row as usize != j) {
            for column in self.above.chunks_exact_mut(k) {
                exchange.iter().enumerate().for_each(|(j, &row)| column.swap(j, row as usize));
            }
        }
        let panel = MatRef::from_column_major_slice(self.panel, k + r, k);
        let (l11, l21) = panel.split_at_row(k);
        let mut u12 = MatMut::from_column_major_slice_mut(self.above, k, r);
        solve_unit_lower_triangular_in_place(l11, u12.rb_mut(), Par::Seq);
        let update = MatMut::from_column_major_slice_mut(self.update, r, r);
        subtract_product(update, l21, u12.rb(), self.threads);
    }

    fn lu_of_columns(
        &mut self,
        from: usize,
        to: usize,
        size: &[f64],
        exchange: &mut [u32],
        pivots: &mut Pivots,
    ) {
        if to - from <= NARROW {
            for j in from..to {
                exchange[j] = self.exchange_rows(j) as u32;
                self.eliminate_column(j, to, size[j], pivots);
            }
            return;
        }
        let (height, middle) = (self.height(), middle(from, to));
        self.lu_of_columns(from, middle, size, exchange, pivots);
        let (left, right) = self.panel.split_at_mut(middle * height);
        let left = MatRef::from_column_major_slice(&left[from * height..], height, middle - from);
        let (_, left) = left.split_at_row(from);
        let (l11, l21) = left.split_at_row(middle - from);
        let right = &mut right[..(to - middle) * height];
        let right = MatMut::from_column_major_slice_mut(right, height, to - middle);
        let (_, right) = right.split_at_row_mut(from);
        let (mut u12, a22) = right.split_at_row_mut(middle - from);
        solve_unit_lower_triangular_in_place(l11, u12.rb_mut(), Par::Seq);
        subtract_product(a22, l21, u12.rb(), self.threads);
        self.lu_of_columns(middle, to, size, exchange, pivots);
    }

    /// Brings the pivot of column j to the diagonal; returns the row it came from.
    fn exchange_rows(&mut self, j: usize) -> usize {
        let height = self.height();
        let candidates = &self.panel[j * height + j..j * height + self.columns];
        let (mut best, mut largest) = (0, 0.0);
        for (p, entry) in candidates.iter().enumerate() {
            let size = entry.to_double().abs();
            if size > largest {
                (best, largest) = (p, size);
            }
        }
        if best == 0 || candidates[0].to_double().abs() >= KEPT * largest {
            return j;
        }
        for column in self.panel.chunks_exact_mut(height) {
            column.swap(j, j + best);
        }
        j + best
    }

    /// Divides column j by its pivot and subtracts it from the columns up to `to`.
    fn eliminate_column(&mut self, j: usize, to: usize, size: f64, pivots: &mut Pivots) {
        let height = self.height();
        let (head, tail) = self.panel.split_at_mut((j + 1) * height);
        let column = &mut head[j * height + j..];
        column[0] = pivots.note(column[0], size, self.first + j);
        let inverse = T::ONE / column[0];
        let column = &mut column[1..];
        column.iter_mut().for_each(|l| *l *= inverse);
        for target in tail.chunks_exact_mut(height).take(to - j - 1) {
            subtract_from(&mut target[j..], column);
        }
    }

    /// A = L D L' of the columns without exchanges, then the lower triangle of F22. `scratch` has
    /// room for columns times the height.
    pub fn factor_ldlt(&mut self, size: &[f64], scratch: &mut [T], pivots: &mut Pivots) {
        self.ldlt_of_columns(0, self.columns, size, scratch, pivots);
        let (k, r) = (self.columns, self.rows);
        if r == 0 {
            return;
        }
        let l21 = MatRef::from_column_major_slice(self.panel, k + r, k).split_at_row(k).1;
        let weighted = weigh(self.panel, k + r, (0, k), (k, k + r), scratch);
        let update = MatMut::from_column_major_slice_mut(self.update, r, r);
        subtract_lower(update, l21, weighted, self.threads);
    }

    fn ldlt_of_columns(
        &mut self,
        from: usize,
        to: usize,
        size: &[f64],
        scratch: &mut [T],
        pivots: &mut Pivots,
    ) {
        if to - from <= NARROW {
            (from..to).for_each(|j| self.eliminate_square(j, to, size[j], pivots));
            widened(
                #[inline(always)]
                || self.eliminate_below(from, to),
            );
            return;
        }
        let (height, middle) = (self.height(), middle(from, to));
        self.ldlt_of_columns(from, middle, size, scratch, pivots);
        let (left, right) = self.panel.split_at_mut(middle * height);
        let weighted = weigh(left, height, (from, middle), (middle, to), scratch);
        let left = MatRef::from_column_major_slice(&left[from * height..], height, middle - from);
        let (_, left) = left.split_at_row(middle);
        let (square, below) = left.split_at_row(to - middle);
        let right = &mut right[..(to - middle) * height];
        let right = MatMut::from_column_major_slice_mut(right, height, to - middle);
        let (_, right) = right.split_at_row_mut(middle);
        let (own, rest) = right.split_at_row_mut(to - middle);
        subtract_lower(own, square, weighted, self.threads);
        subtract_product(rest, below, weighted, self.threads);
        self.ldlt_of_columns(middle, to, size, scratch, pivots);
    }

    /// Eliminates column j from the columns up to `to`, in the rows of these alone.
    fn eliminate_square(&mut self, j: usize, to: usize, size: f64, pivots: &mut Pivots) {
        let height = self.height();
        let (head, tail) = self.panel.split_at_mut((j + 1) * height);
        let column = &mut head[j * height + j..j * height + to];
        column[0] = pivots.note(column[0], size, self.first + j);
        let inverse = T::ONE / column[0];
        let column = &mut column[1..];
        for (p, target) in tail.chunks_exact_mut(height).take(to - j - 1).enumerate() {
            let factor = column[p] * inverse;
            for (t, &l) in target[j + 1 + p..to].iter_mut().zip(&column[p..]) {
                *t -= factor * l;
            }
        }
        column.iter_mut().for_each(|l| *l *= inverse);
    }

    /// Eliminates the narrow columns `from` to `to`, whose square is done, from the rows below it:
    /// a few rows at a time, which are read and written once.
    #[inline(always)]
    fn eliminate_below(&mut self, from: usize, to: usize) {
        let height = self.height();
        let panel = &mut self.panel[from * height..to * height];
        let whole = to + (height - to) / ROWS * ROWS;
        let mut square = [[T::ZERO; NARROW]; NARROW];
        for (p, column) in panel.chunks_exact(height).enumerate() {
            (p..to - from).for_each(|j| square[j][p] = column[from + j]);
        }
        for row in (to..whole).step_by(ROWS) {
            match to - from {
                NARROW => eliminate_rows::<T, ROWS>(panel, height, row, (&square, NARROW)),
                width => eliminate_rows::<T, ROWS>(panel, height, row, (&square, width)),
            }
        }
        let width = to - from;
        (whole..height)
            .for_each(|row| eliminate_rows::<T, 1>(panel, height, row, (&square, width)));
    }
}

/// Rows of narrow columns from `row` on; `square` holds L, and D on its diagonal.
#[inline(always)]
fn eliminate_rows<T: Real, const M: usize>(
    panel: &mut [T],
    height: usize,
    row: usize,
    (square, width): (&[[T; NARROW]; NARROW], usize),
) {
    let mut entries = [[T::ZERO; M]; NARROW];
    for j in 0..width {
        let at = j * height + row;
        let mut own = [T::ZERO; M];
        own.copy_from_slice(&panel[at..at + M]);
        for p in 0..j {
            for lane in 0..M {
                own[lane] -= square[j][p] * entries[p][lane];
            }
        }
        entries[j] = own;
        let inverse = T::ONE / square[j][j];
        panel[at..at + M].iter_mut().zip(own).for_each(|(l, entry)| *l = entry * inverse);
    }
}

/// Where columns are halved: the left half is whole narrow blocks.
fn middle(from: usize, to: usize) -> usize {
    from + ((to - from) / 2).next_multiple_of(NARROW)
}

/// target[1..] -= target[0] * column.
fn subtract_from<T: Real>(target: &mut [T], column: &[T]) {
    let factor = target[0];
    if factor != T::ZERO {
        target[1..].iter_mut().zip(column).for_each(|(t, &l)| *t -= factor * l);
    }
}

/// D L' for the columns `of` and the rows `over` of L, transposed in scratch.
fn weigh<'a, T: Real>(
    panel: &[T],
    height: usize,
    of: (usize, usize),
    over: (usize, usize),
    scratch: &'a mut [T],
) -> MatRef<'a, T> {
    let (count, width) = (of.1 - of.0, over.1 - over.0);
    let scratch = &mut scratch[..count * width];
    for (target, j) in scratch.chunks_exact_mut(width).zip(of.0..of.1) {
        let column = &panel[j * height..(j + 1) * height];
        let pivot = column[j];
        target.iter_mut().zip(&column[over.0..over.1]).for_each(|(t, &l)| *t = pivot * l);
    }
    MatRef::from_column_major_slice(scratch, width, count).transpose()
}

/// target -= left * right, the lower triangle of it, in parts that threads may share.
fn subtract_lower<T: Real>(
    target: MatMut<'_, T>,
    left: MatRef<'_, T>,
    right: MatRef<'_, T>,
    threads: bool,
) {
    use triangular::BlockStructure::{Rectangular, TriangularLower};
    let n = target.nrows();
    if n > TILE {
        let middle = halved(n);
        let (upper, _, lower_left, lower) = target.split_at_mut(middle, middle);
        let (above, below) = left.split_at_row(middle);
        let (first, second) = right.split_at_col(middle);
        let square = || {
            both(
                threads,
                || subtract_lower(upper, above, first, threads),
                || subtract_lower(lower, below, second, threads),
            );
        };
        return both(threads, || subtract_product(lower_left, below, first, threads), square);
    }
    triangular::matmul(
        target,
        TriangularLower,
        Accum::Add,
        left,
        Rectangular,
        right,
        Rectangular,
        -T::ONE,
        Par::Seq,
    );
}

/// target -= left * right, in parts that threads may share: the same parts on any number of them.
fn subtract_product<T: Real>(
    target: MatMut<'_, T>,
    left: MatRef<'_, T>,
    right: MatRef<'_, T>,
    threads: bool,
) {
    let (rows, columns) = (target.nrows(), target.ncols());
    if rows.max(columns) <= TILE {
        return matmul(target, Accum::Add, left, right, -T::ONE, Par::Seq);
    }
    if rows >= columns {
        let (upper, lower) = target.split_at_row_mut(halved(rows));
        let (above, below) = left.split_at_row(halved(rows));
        let first = || subtract_product(upper, above, right, threads);
        return both(threads, first, || subtract_product(lower, below, right, threads));
    }
    let (before, behind) = target.split_at_col_mut(halved(columns));
    let (first, second) = right.split_at_col(halved(columns));
    let own = || subtract_product(before, left, first, threads);
    both(threads, own, || subtract_product(behind, left, second, threads));
}

/// Where a long side is divided: the first part is whole tiles.
fn halved(length: usize) -> usize {
    (length / 2).next_multiple_of(TILE)
}

/// Does both, in either order or at once.
fn both(threads: bool, first: impl FnOnce() + Send, second: impl FnOnce() + Send) {
    if threads {
        rayon::join(first, second);
    } else {
        first();
        second();
    }
}
