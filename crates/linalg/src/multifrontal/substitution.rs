//! Solutions with the factors, front by front: upwards to the roots, then downwards.

use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::{
    solve_lower_triangular_in_place, solve_unit_lower_triangular_in_place,
    solve_unit_upper_triangular_in_place, solve_upper_triangular_in_place,
};
use faer::prelude::{Reborrow, ReborrowMut};
use faer::{Accum, MatMut, MatRef, Par};

use super::Multifrontal;
use super::layout::Storage;
use crate::fronts::Front;
use crate::kernel::{dot, dot_columns, subtract_columns, widened};
use crate::precision::Real;

impl Multifrontal {
    /// Solves in place for a block of right-hand sides.
    pub fn solve(&mut self, block: &mut [f64], columns: usize, transposed: bool) {
        let n = self.layout.fronts.order.len().max(1);
        if columns == 1 {
            return self.solve_one(block, |_, b| b, |_, x| x, transposed);
        }
        self.x.resize(self.x.len().max(n * columns), 0.0);
        let largest = self.layout.fronts.front.iter().map(|front| front.rows).max().unwrap_or(0);
        self.rows.resize(self.rows.len().max(largest * columns), 0.0);
        let mut x = std::mem::take(&mut self.x);
        let mut rows = std::mem::take(&mut self.rows);
        for (b, x) in block.chunks_exact(n).zip(x.chunks_exact_mut(n)) {
            x.iter_mut().zip(&self.layout.fronts.order).for_each(|(x, &equation)| *x = b[equation]);
        }
        let transposed = transposed && !self.layout.symmetric;
        let (x_used, work) = (&mut x[..n * columns], &mut rows[..]);
        let fronts = 0..self.layout.storage.len();
        fronts.clone().for_each(|f| self.forward(f, x_used, work, transposed));
        fronts.rev().for_each(|f| self.backward(f, x_used, work, transposed));
        for (b, x) in block.chunks_exact_mut(n).zip(x.chunks_exact(n)) {
            x.iter().zip(&self.layout.fronts.order).for_each(|(x, &equation)| b[equation] = *x);
        }
        (self.x, self.rows) = (x, rows);
    }

    /// Eliminates a front's unknowns from the right-hand sides.
    fn forward(&self, f: usize, x: &mut [f64], work: &mut [f64], transposed: bool) {
        let front = &self.layout.fronts.front[f];
        let (n, k, r) = (self.layout.fronts.order.len(), front.columns, front.rows);
        let columns = x.len() / n;
        let Parts { l11, l21, above } = self.parts(f);
        if !transposed {
            self.exchange_rows(front, x, false);
        }
        let mut all = MatMut::from_column_major_slice_mut(x, n, columns);
        let mut own = all.rb_mut().subrows_mut(front.first, k);
        match transposed {
            false => solve_unit_lower_triangular_in_place(l11, own.rb_mut(), Par::Seq),
            true => solve_lower_triangular_in_place(l11.transpose(), own.rb_mut(), Par::Seq),
        }
        if r == 0 {
            return;
        }
        let work = &mut work[..r * columns];
        let coupling = if transposed { above.transpose() } else { l21 };
        let product = MatMut::from_column_major_slice_mut(work, r, columns);
        matmul(product, Accum::Replace, coupling, own.rb(), 1.0, Par::Seq);
        for (x, product) in x.chunks_exact_mut(n).zip(work.chunks_exact(r)) {
            for (&row, p) in self.layout.fronts.rows_of(front).iter().zip(product) {
                x[row as usize] -= p;
            }
        }
    }

    /// Finds a front's unknowns, those of its rows being known.
    fn backward(&self, f: usize, x: &mut [f64], work: &mut [f64], transposed: bool) {
        let front = &self.layout.fronts.front[f];
        let (n, k, r) = (self.layout.fronts.order.len(), front.columns, front.rows);
        let columns = x.len() / n;
        let Parts { l11, l21, above } = self.parts(f);
        if self.layout.symmetric {
            self.divide(front, l11, x);
        }
        let work = &mut work[..r * columns];
        for (x, known) in x.chunks_exact(n).zip(work.chunks_exact_mut(r.max(1))) {
            for (&row, known) in self.layout.fronts.rows_of(front).iter().zip(known) {
                *known = x[row as usize];
            }
        }
        let mut all = MatMut::from_column_major_slice_mut(x, n, columns);
        let mut own = all.rb_mut().subrows_mut(front.first, k);
        let from_below = self.layout.symmetric || transposed;
        if r > 0 {
            let known = MatRef::from_column_major_slice(work, r, columns);
            let coupling = if from_below { l21.transpose() } else { above };
            matmul(own.rb_mut(), Accum::Add, coupling, known, -1.0, Par::Seq);
        }
        match from_below {
            true => solve_unit_upper_triangular_in_place(l11.transpose(), own, Par::Seq),
            false => solve_upper_triangular_in_place(l11, own, Par::Seq),
        }
        if transposed {
            self.exchange_rows(front, x, true);
        }
    }

    fn divide(&self, front: &Front, l11: MatRef<'_, f64>, x: &mut [f64]) {
        for x in x.chunks_exact_mut(self.layout.fronts.order.len()) {
            for (j, x) in x[front.first..front.first + front.columns].iter_mut().enumerate() {
                *x /= l11[(j, j)];
            }
        }
    }

    fn parts(&self, f: usize) -> Parts<'_> {
        let Front { columns, rows, .. } = self.layout.fronts.front[f];
        let (panel, above) = self.blocks(f);
        let panel = MatRef::from_column_major_slice(panel, columns + rows, columns);
        let (l11, l21) = panel.split_at_row(columns);
        let rows = if self.layout.symmetric { 0 } else { rows };
        let above = MatRef::from_column_major_slice(above, columns, rows);
        Parts { l11, l21, above }
    }
}

impl<T: Real> Multifrontal<T> {
    /// Solves in place for one right-hand side: `enter` makes a number of an equation's entry,
    /// `leave` an entry of the solution.
    pub fn solve_one(
        &mut self,
        b: &mut [f64],
        enter: impl Fn(usize, f64) -> T,
        leave: impl Fn(usize, T) -> f64,
        transposed: bool,
    ) {
        let mut x = std::mem::take(&mut self.x);
        let mut rows = std::mem::take(&mut self.rows);
        let used = &mut x[..self.layout.fronts.order.len()];
        for (x, &equation) in used.iter_mut().zip(&self.layout.fronts.order) {
            *x = enter(equation, b[equation]);
        }
        let transposed = transposed && !self.layout.symmetric;
        let fronts = 0..self.layout.storage.len();
        fronts.clone().for_each(|f| self.forward_one(f, used, &mut rows, transposed));
        fronts.rev().for_each(|f| self.backward_one(f, used, &mut rows, transposed));
        for (&x, &equation) in used.iter().zip(&self.layout.fronts.order) {
            b[equation] = leave(equation, x);
        }
        (self.x, self.rows) = (x, rows);
    }

    /// As [`Multifrontal::forward`] for one right-hand side, for which matrix products do not pay.
    pub(super) fn forward_one(&self, f: usize, x: &mut [T], work: &mut [T], transposed: bool) {
        let front = &self.layout.fronts.front[f];
        let (k, r) = (front.columns, front.rows);
        let (panel, above) = self.blocks(f);
        if !transposed {
            self.exchange_rows(front, x, false);
        }
        let work = &mut work[..r];
        work.fill(T::ZERO);
        let own = &mut x[front.first..front.first + k];
        if transposed {
            for (j, column) in panel.chunks_exact(k + r).enumerate() {
                own[j] = (own[j] - dot(&column[..j], &own[..j])) / column[j];
            }
            for (sum, column) in work.iter_mut().zip(above.chunks_exact(k)) {
                *sum = -dot(column, own);
            }
        } else {
            widened(
                #[inline(always)]
                || eliminate_below(panel, own, work),
            );
        }
        for (&row, &sum) in self.layout.fronts.rows_of(front).iter().zip(&*work) {
            x[row as usize] += sum;
        }
    }

    /// As [`Multifrontal::backward`] for one right-hand side.
    pub(super) fn backward_one(&self, f: usize, x: &mut [T], work: &mut [T], transposed: bool) {
        let front = &self.layout.fronts.front[f];
        let (k, r) = (front.columns, front.rows);
        let (panel, above) = self.blocks(f);
        let work = &mut work[..r];
        for (&row, known) in self.layout.fronts.rows_of(front).iter().zip(work.iter_mut()) {
            *known = x[row as usize];
        }
        let own = &mut x[front.first..front.first + k];
        let from_below = self.layout.symmetric || transposed;
        if !from_below {
            for (&known, column) in work.iter().zip(above.chunks_exact(k)) {
                own.iter_mut().zip(column).for_each(|(x, &u)| *x -= u * known);
            }
        }
        if from_below {
            if self.layout.symmetric {
                let pivots = panel.chunks_exact(k + r).enumerate().map(|(j, column)| column[j]);
                own.iter_mut().zip(pivots).for_each(|(x, pivot)| *x /= pivot);
            }
            widened(
                #[inline(always)]
                || find_from_below(panel, own, work),
            );
        } else {
            for (j, column) in panel.chunks_exact(k + r).enumerate().rev() {
                let x_j = own[j] / column[j];
                own[j] = x_j;
                own[..j].iter_mut().zip(column).for_each(|(x, &u)| *x -= u * x_j);
            }
        }
        if transposed {
            self.exchange_rows(front, x, true);
        }
    }

    /// Replays the exchanges of a front, or undoes them.
    fn exchange_rows(&self, front: &Front, x: &mut [T], undo: bool) {
        let exchange = &self.exchange[front.first..front.first + front.columns];
        if self.layout.symmetric || exchange.iter().enumerate().all(|(j, &row)| row as usize == j) {
            return;
        }
        for x in x.chunks_exact_mut(self.layout.fronts.order.len()) {
            let own = &mut x[front.first..front.first + front.columns];
            let swaps = exchange.iter().enumerate();
            match undo {
                false => swaps.for_each(|(j, &row)| own.swap(j, row as usize)),
                true => swaps.rev().for_each(|(j, &row)| own.swap(j, row as usize)),
            }
        }
    }

    /// The panel of a front and what is above its update.
    fn blocks(&self, f: usize) -> (&[T], &[T]) {
        let Storage { panel, above, end, .. } = self.layout.storage[f];
        (&self.factor[panel..above], &self.factor[above..end])
    }
}

/// Columns that are substituted together: they share the unknowns that they meet.
const TOGETHER: usize = 4;

/// Columns of a panel from `first` on, each from the row behind the last of them on.
#[inline(always)]
fn columns_below<T: Real, const M: usize>(panel: &[T], height: usize, first: usize) -> [&[T]; M] {
    std::array::from_fn(|m| &panel[(first + m) * height + first + M..(first + m + 1) * height])
}

/// Eliminates a front's unknowns from its own equations and from the rows below (unit lower
/// triangle): what is to be added to these.
#[inline(always)]
fn eliminate_below<T: Real>(panel: &[T], own: &mut [T], below: &mut [T]) {
    // plain loops: what adapters of iterators call need not be in the wide vectors of who calls them
    let whole = own.len() / TOGETHER;
    for j in 0..whole {
        eliminate::<T, TOGETHER>(panel, own, below, TOGETHER * j);
    }
    for j in TOGETHER * whole..own.len() {
        eliminate::<T, 1>(panel, own, below, j);
    }
}

#[inline(always)]
fn eliminate<T: Real, const M: usize>(panel: &[T], own: &mut [T], below: &mut [T], first: usize) {
    let height = own.len() + below.len();
    let (known, behind) = own[first..].split_at_mut(M);
    for m in 0..M {
        let column = &panel[(first + m) * height + first..];
        for i in m + 1..M {
            known[i] -= column[i] * known[m];
        }
    }
    let known: [T; M] = std::array::from_fn(|m| known[m]);
    let columns = columns_below::<T, M>(panel, height, first);
    subtract_columns(behind, columns, known);
    subtract_columns(below, columns.map(|column| &column[behind.len()..]), known);
}

/// Finds a front's unknowns, those below being known (unit lower triangle, transposed).
#[inline(always)]
fn find_from_below<T: Real>(panel: &[T], own: &mut [T], below: &[T]) {
    let whole = own.len() / TOGETHER;
    for j in (TOGETHER * whole..own.len()).rev() {
        find::<T, 1>(panel, own, below, j);
    }
    for j in (0..whole).rev() {
        find::<T, TOGETHER>(panel, own, below, TOGETHER * j);
    }
}

#[inline(always)]
fn find<T: Real, const M: usize>(panel: &[T], own: &mut [T], below: &[T], first: usize) {
    let height = own.len() + below.len();
    let (unknown, behind) = own[first..].split_at_mut(M);
    let columns = columns_below::<T, M>(panel, height, first);
    let of_own = dot_columns(columns, behind);
    let of_rows = dot_columns(columns.map(|column| &column[behind.len()..]), below);
    for m in (0..M).rev() {
        let column = &panel[(first + m) * height + first..];
        let mut value = unknown[m] - of_own[m] - of_rows[m];
        for i in m + 1..M {
            value -= column[i] * unknown[i];
        }
        unknown[m] = value;
    }
}

/// Blocks of a factored front.
struct Parts<'a> {
    l11: MatRef<'a, f64>,
    l21: MatRef<'a, f64>,
    above: MatRef<'a, f64>,
}
