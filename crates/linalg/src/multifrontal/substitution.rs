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
use crate::kernel::dot;

impl Multifrontal {
    /// Solves in place for a block of right-hand sides.
    pub fn solve(&mut self, block: &mut [f64], columns: usize, transposed: bool) {
        let n = self.layout.fronts.order.len();
        self.x.resize(self.x.len().max(n * columns), 0.0);
        let largest = self.layout.fronts.front.iter().map(|front| front.rows).max().unwrap_or(0);
        self.rows.resize(self.rows.len().max(largest * columns), 0.0);
        let mut x = std::mem::take(&mut self.x);
        let mut rows = std::mem::take(&mut self.rows);
        for (b, x) in block.chunks_exact(n.max(1)).zip(x.chunks_exact_mut(n.max(1))) {
            x.iter_mut().zip(&self.layout.fronts.order).for_each(|(x, &equation)| *x = b[equation]);
        }
        let transposed = transposed && !self.layout.symmetric;
        let (x_used, work) = (&mut x[..n * columns], &mut rows[..]);
        for f in 0..self.layout.storage.len() {
            match columns {
                1 => self.forward_one(f, x_used, work, transposed),
                _ => self.forward(f, x_used, work, transposed),
            }
        }
        for f in (0..self.layout.storage.len()).rev() {
            match columns {
                1 => self.backward_one(f, x_used, work, transposed),
                _ => self.backward(f, x_used, work, transposed),
            }
        }
        for (b, x) in block.chunks_exact_mut(n.max(1)).zip(x.chunks_exact(n.max(1))) {
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

    /// As [`Multifrontal::forward`] for one right-hand side, for which matrix products do not pay.
    fn forward_one(&self, f: usize, x: &mut [f64], work: &mut [f64], transposed: bool) {
        let front = &self.layout.fronts.front[f];
        let (k, r) = (front.columns, front.rows);
        let (panel, above) = self.blocks(f);
        if !transposed {
            self.exchange_rows(front, x, false);
        }
        let work = &mut work[..r];
        work.fill(0.0);
        let own = &mut x[front.first..front.first + k];
        for (j, column) in panel.chunks_exact(k + r).enumerate() {
            if transposed {
                own[j] = (own[j] - dot(&column[..j], &own[..j])) / column[j];
                continue;
            }
            let x_j = own[j];
            let (l11, l21) = column[j + 1..].split_at(k - j - 1);
            own[j + 1..].iter_mut().zip(l11).for_each(|(x, l)| *x -= l * x_j);
            work.iter_mut().zip(l21).for_each(|(sum, l)| *sum += l * x_j);
        }
        if transposed {
            for (sum, column) in work.iter_mut().zip(above.chunks_exact(k)) {
                *sum = dot(column, own);
            }
        }
        for (&row, sum) in self.layout.fronts.rows_of(front).iter().zip(&*work) {
            x[row as usize] -= sum;
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

    /// As [`Multifrontal::backward`] for one right-hand side.
    fn backward_one(&self, f: usize, x: &mut [f64], work: &mut [f64], transposed: bool) {
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
            for (known, column) in work.iter().zip(above.chunks_exact(k)) {
                own.iter_mut().zip(column).for_each(|(x, u)| *x -= u * known);
            }
        }
        for (j, column) in panel.chunks_exact(k + r).enumerate().rev() {
            if from_below {
                let x_j = if self.layout.symmetric { own[j] / column[j] } else { own[j] };
                let (l11, l21) = column[j + 1..].split_at(k - j - 1);
                own[j] = x_j - dot(l11, &own[j + 1..]) - dot(l21, work);
                continue;
            }
            let x_j = own[j] / column[j];
            own[j] = x_j;
            own[..j].iter_mut().zip(column).for_each(|(x, u)| *x -= u * x_j);
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

    /// Replays the exchanges of a front, or undoes them.
    fn exchange_rows(&self, front: &Front, x: &mut [f64], undo: bool) {
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
    fn blocks(&self, f: usize) -> (&[f64], &[f64]) {
        let Storage { panel, above, end, .. } = self.layout.storage[f];
        (&self.factor[panel..above], &self.factor[above..end])
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

/// Blocks of a factored front.
struct Parts<'a> {
    l11: MatRef<'a, f64>,
    l21: MatRef<'a, f64>,
    above: MatRef<'a, f64>,
}
