//! Dense border of a banded system and its Schur complement.

use crate::band_ldlt::{BandLdlt, Pivots};
use crate::band_lu::{BandLu, SmallestPivot};
use crate::kernel::{dot, dot_lanes, subtract_lanes};
use crate::pattern::Pattern;

/// Rows and columns set apart from the band, dense: `count` columns B, `count` rows C (each of the
/// length of the band) and the corner D.
#[derive(Clone, Debug)]
pub(crate) struct Border {
    band: usize,
    count: usize,
    /// inv(A) B, column after column.
    reduced: Vec<f64>,
    /// C, row after row.
    left: Vec<f64>,
    /// Schur complement, row after row.
    corner: Vec<f64>,
    reduced_place: Vec<(u32, u32)>,
    left_place: Vec<(u32, u32)>,
    corner_place: Vec<(u32, u32)>,
    /// A band as wide as the matrix is a dense matrix.
    schur: BandLu,
    symmetric: BandLdlt,
}

impl Border {
    /// Border of the equations whose place is `band` or beyond.
    pub fn new(pattern: &Pattern, place: &[usize], band: usize) -> Self {
        let count = pattern.size() - band;
        let mut border = Self {
            band,
            count,
            reduced: vec![0.0; band * count],
            left: vec![0.0; band * count],
            corner: vec![0.0; count * count],
            reduced_place: Vec::new(),
            left_place: Vec::new(),
            corner_place: Vec::new(),
            schur: BandLu::new(count, count.saturating_sub(1)),
            symmetric: BandLdlt::new(count, count.saturating_sub(1)),
        };
        let mut entry = 0u32;
        for i in 0..pattern.size() {
            for &j in pattern.row(i) {
                border.place_entry(entry, place[i], place[j]);
                entry += 1;
            }
        }
        border
    }

    fn place_entry(&mut self, entry: u32, row: usize, column: usize) {
        let band = self.band;
        match (row >= band, column >= band) {
            (false, false) => {}
            (false, true) => {
                self.reduced_place.push((entry, ((column - band) * band + row) as u32));
            }
            (true, false) => self.left_place.push((entry, ((row - band) * band + column) as u32)),
            (true, true) => {
                let at = (row - band) * self.count + column - band;
                self.corner_place.push((entry, at as u32));
            }
        }
    }

    /// Takes B, C and D from the values of the matrix.
    pub fn load(&mut self, values: &[f64]) {
        load(values, &self.reduced_place, &mut self.reduced);
        load(values, &self.left_place, &mut self.left);
        load(values, &self.corner_place, &mut self.corner);
    }

    /// inv(A) B and the Schur complement D - C inv(A) B, with the band's solution given.
    pub fn reduce(&mut self, solve_band: impl Fn(&mut [[f64; 1]])) {
        let (band, count) = (self.band, self.count);
        for q in 0..count {
            let column = &mut self.reduced[q * band..(q + 1) * band];
            solve_band(column.as_chunks_mut().0);
            for p in 0..count {
                self.corner[p * count + q] -= dot(&self.left[p * band..(p + 1) * band], column);
            }
        }
    }

    /// Factors the Schur complement with partial pivoting.
    pub fn factor(&mut self, size: impl Fn(usize) -> f64) -> SmallestPivot {
        let mut storage = std::mem::take(&mut self.schur);
        storage.clear();
        for p in 0..self.count {
            for q in 0..self.count {
                let at = storage.place(p, q);
                storage.set(at, self.corner[p * self.count + q]);
            }
        }
        let smallest = storage.factor(size);
        self.schur = storage;
        smallest
    }

    /// Signs of the pivots of the Schur complement, taken as symmetric.
    pub fn factor_symmetric(&mut self, size: impl Fn(usize) -> f64) -> Option<Pivots> {
        let count = self.count;
        self.symmetric.clear();
        for q in 0..count {
            for p in q..count {
                let at = self.symmetric.place(p, q);
                self.symmetric.set(at, self.corner[p * count + q]);
            }
        }
        self.symmetric.factor(size)
    }

    /// Completes a solution: `x` holds inv(A) f and `y` the border's right-hand side g.
    pub fn solve<const M: usize>(&self, x: &mut [[f64; M]], y: &mut [[f64; M]]) {
        let band = self.band;
        for (p, y_p) in y.iter_mut().enumerate() {
            let known = dot_lanes(&self.left[p * band..(p + 1) * band], x);
            y_p.iter_mut().zip(known).for_each(|(y_p, known)| *y_p -= known);
        }
        self.schur.solve(y);
        for (q, y_q) in y.iter().enumerate() {
            for (x_i, w) in x.iter_mut().zip(&self.reduced[q * band..(q + 1) * band]) {
                subtract_lanes(x_i, *w, y_q);
            }
        }
    }

    /// Prepares a solution of the transposed system: `y` becomes the border's unknowns, and `x`, the
    /// band's right-hand side f, becomes f - C' y, which the band then solves with A'.
    pub fn solve_transpose<const M: usize>(&self, x: &mut [[f64; M]], y: &mut [[f64; M]]) {
        let band = self.band;
        for (q, y_q) in y.iter_mut().enumerate() {
            let known = dot_lanes(&self.reduced[q * band..(q + 1) * band], x);
            y_q.iter_mut().zip(known).for_each(|(y_q, known)| *y_q -= known);
        }
        self.schur.solve_transpose(y);
        for (p, y_p) in y.iter().enumerate() {
            for (x_i, c) in x.iter_mut().zip(&self.left[p * band..(p + 1) * band]) {
                subtract_lanes(x_i, *c, y_p);
            }
        }
    }
}

fn load(values: &[f64], place: &[(u32, u32)], storage: &mut [f64]) {
    storage.fill(0.0);
    for &(entry, at) in place {
        storage[at as usize] = values[entry as usize];
    }
}
