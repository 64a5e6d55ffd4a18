//! A matrix that is nearly symmetric, as its symmetric part and the little that is left.
//!
//! ```text
//!   K = S + N,   S = (K + K')/2,   N = (K - K')/2:   few entries, N_ij = -N_ji
//! ```
//!
//! Friction leaves the laws of contact to a problem of their own; of K it makes unsymmetric only what
//! the turning of tractions with the surface gives. S is factored, at half the work and memory, and
//! iterations bring N in.

use crate::pattern::Pattern;

/// Half differences that are rounding of the sums of the matrix, relative to its diagonal [1].
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// The part N of a matrix.
#[derive(Clone, Debug, Default)]
pub(crate) struct Skew {
    /// Row, column, and what N has below the diagonal: at (column, row).
    entries: Vec<(u32, u32, f64)>,
    /// Next entry of each row that mirrors one of those above.
    next: Vec<usize>,
    diagonal: Vec<usize>,
}

impl Skew {
    /// Leaves the symmetric part in `values` and takes the rest.
    pub fn split(&mut self, pattern: &Pattern, values: &mut [f64]) {
        let n = pattern.size();
        if self.diagonal.len() != n {
            self.diagonal.clear();
            self.diagonal.extend((0..n).filter_map(|i| pattern.position(i, i)));
        }
        self.entries.clear();
        self.next.clear();
        self.next.extend_from_slice(&pattern.row_start()[..n]);
        for i in 0..n {
            // rows come in ascending order: the entries (j, i) of row j do, too
            let own = self.diagonal[i];
            for (at, &j) in (own + 1..).zip(&pattern.row(i)[own + 1 - pattern.row_start()[i]..]) {
                let mirrored = self.next[j];
                self.next[j] += 1;
                let (above, below) = (values[at], values[mirrored]);
                if above == below {
                    continue;
                }
                let mean = 0.5 * (above + below);
                let half = 0.5 * (below - above);
                let size = (values[own] * values[self.diagonal[j]]).abs().sqrt();
                (values[at], values[mirrored]) = (mean, mean);
                if half.abs() > ROUNDING * size {
                    self.entries.push((i as u32, j as u32, half));
                }
            }
        }
    }

    /// Puts N back to S; it is empty then.
    pub fn join(&mut self, pattern: &Pattern, values: &mut [f64]) {
        for (i, j, half) in self.entries.drain(..) {
            for (row, column, value) in [(i, j, -half), (j, i, half)] {
                if let Some(at) = pattern.position(row as usize, column as usize) {
                    values[at] += value;
                }
            }
        }
    }

    /// Whether nothing is left beside the symmetric part.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// Forgets it.
    pub fn clear(&mut self) {
        self.entries.clear();
    }

    /// y += factor N x.
    pub fn add_product(&self, factor: f64, x: &[f64], y: &mut [f64]) {
        for &(i, j, half) in &self.entries {
            let (i, j, half) = (i as usize, j as usize, factor * half);
            y[i] -= half * x[j];
            y[j] += half * x[i];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::Matrix;

    /// Requirement: both parts together give the products of the matrix, the symmetric part is
    /// symmetric to the bit, rounding counts as symmetric, and joined again they are the matrix.
    #[test]
    fn both_parts_are_the_matrix() {
        let n = 50;
        let pattern = Pattern::from_pairs(n, (0..n).flat_map(|i| [(i, i + 1), (i, i * 7 % n)]));
        let value = |i: usize, j: usize| match (i == j, i.is_multiple_of(5) && i < j) {
            (true, _) => 9.0,
            (_, true) => -1.25,
            _ => -1.0 + if i < j { 0.0 } else { f64::EPSILON },
        };
        let rows = (0..n).flat_map(|i| pattern.row(i).iter().map(move |&j| (i, j)));
        let whole: Vec<f64> = rows.clone().map(|(i, j)| value(i, j)).collect();
        let (mut values, mut skew) = (whole.clone(), Skew::default());
        skew.split(&pattern, &mut values);
        let at = |i: usize, j: usize| values[pattern.position(i, j).unwrap()];
        assert!(rows.clone().all(|(i, j)| at(i, j).to_bits() == at(j, i).to_bits()));
        let turned = rows.filter(|&(i, j)| i < j && i % 5 == 0).count();
        assert!(turned > 5 && skew.entries.len() == turned, "{}", skew.entries.len());
        let x: Vec<f64> = (0..n).map(|i| ((i * 31) % 17) as f64 - 8.0).collect();
        let (mut product, mut wanted) = (vec![0.0; n], vec![0.0; n]);
        Matrix::new(&pattern, &whole).multiply(&x, &mut wanted);
        Matrix::new(&pattern, &values).multiply(&x, &mut product);
        skew.add_product(1.0, &x, &mut product);
        assert!(product.iter().zip(&wanted).all(|(p, w)| (p - w).abs() < 1e-13));
        skew.join(&pattern, &mut values);
        assert!(skew.is_empty() && values.iter().zip(&whole).all(|(v, w)| (v - w).abs() < 1e-15));
    }
}
