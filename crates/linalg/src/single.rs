//! Symmetric factors in single precision, for iterations in double.
//!
//! ```text
//!   S A S = L D L'    S: powers of two that bring the diagonal to one,
//!                     so that no unit leaves the range of the format
//! ```
//!
//! Half the memory and half the time of factors in double. They are those of A + E with |E| of the
//! size of the format's rounding [higham2002]: where A has no pivot near zero, a preconditioner with
//! which conjugate gradients gain three or four digits an iteration.

use crate::error::FactorReport;
use crate::multifrontal::Multifrontal;
use crate::pattern::Matrix;

/// Part of its diagonal from which on the rounding of the format, summed over the terms of a pivot,
/// leaves no doubt about its sign: of a definite matrix no term exceeds the diagonal.
const SOUND: f64 = 1000.0 * f32::EPSILON as f64;

/// Factors in single precision of a matrix that is scaled.
pub(crate) struct Single {
    factors: Multifrontal<f32>,
    scale: Vec<f64>,
}

impl Single {
    /// In the order of factors in double precision; without memory of its own so far.
    pub fn new(of: &Multifrontal) -> Self {
        Self { factors: of.in_precision(), scale: Vec::new() }
    }

    /// Gives the memory of the factors back.
    pub fn release(&mut self) {
        self.factors.release();
    }

    /// Factors a matrix whose diagonal is at these places among the entries, all of it positive;
    /// `None`, and no memory held, where a pivot is negative or in doubt.
    pub fn factor(&mut self, matrix: Matrix<'_>, diagonal: &[usize]) -> Option<FactorReport> {
        let size = |i: usize| matrix.values[diagonal[i]];
        self.scale.clear();
        self.scale.extend((0..diagonal.len()).map(|i| power_of_two(1.0 / size(i).sqrt())));
        let scale = &self.scale[..];
        let scaled = (0..scale.len()).flat_map(|i| {
            let (columns, values) = matrix.row(i);
            let own = scale[i];
            columns.iter().zip(values).map(move |(&j, value)| (value * (own * scale[j])) as f32)
        });
        let factored = self.factors.scatter(scaled).ok().map(|()| {
            let pivots = self.factors.factor(|i| size(i) * (scale[i] * scale[i]));
            FactorReport {
                negative_pivots: Some(pivots.negative),
                smallest_pivot_ratio: pivots.smallest_ratio,
                smallest_pivot: self.factors.equation(pivots.smallest),
            }
        });
        let sound = factored.filter(|report| {
            report.negative_pivots == Some(0) && report.smallest_pivot_ratio >= SOUND
        });
        if sound.is_none() {
            self.release();
        }
        sound
    }

    /// Solves in place to the precision of the factors, whatever the size of the right-hand side:
    /// on all equations, or on the interface alone.
    pub fn solve(&mut self, b: &mut [f64], on_interface: bool) {
        let Self { factors, scale } = self;
        let sizes = b.iter().zip(&*scale).map(|(b, scale)| (b * scale).abs());
        let size = sizes.fold(0.0, f64::max);
        if size == 0.0 {
            return;
        }
        let enter = |i: usize, b: f64| (b * scale[i] / size) as f32;
        let leave = |i: usize, x: f32| f64::from(x) * scale[i] * size;
        match on_interface {
            true => factors.solve_on_path(b, enter, leave),
            false => factors.solve_one(b, enter, leave, false),
        }
    }
}

/// The power of two at or below a positive number.
fn power_of_two(value: f64) -> f64 {
    f64::from_bits(value.to_bits() & f64::INFINITY.to_bits())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::Pattern;
    use crate::sparse::Sparse;
    use crate::system::{Kind, LinearSystem};

    fn unit(equation: usize, decades: i32) -> f64 {
        10f64.powi(equation as i32 * 7 % (2 * decades + 1) - decades)
    }

    /// Plane grid whose diagonal exceeds the rest of its row by `excess`, in units that differ from
    /// equation to equation by up to twice so many decades.
    fn grid(side: usize, excess: f64, decades: i32) -> (Pattern, Vec<f64>, Vec<f64>) {
        let own = |i: usize| [(i, i + 1), (i, i + side)];
        let inside =
            |&(i, j): &(usize, usize)| j < side * side && (j == i + side || i / side == j / side);
        let pairs = (0..side * side).flat_map(own).filter(inside);
        let pattern = Pattern::from_pairs(side * side, pairs);
        let unit = |i: usize| unit(i, decades);
        let rows = (0..pattern.size()).map(|i| (i, pattern.row(i)));
        let entry = |i: usize, j: usize, row: &[usize]| match i == j {
            true => (row.len() - 1) as f64 + excess,
            false => -1.0,
        };
        let values: Vec<f64> = rows
            .flat_map(|(i, row)| row.iter().map(move |&j| entry(i, j, row) * (unit(i) * unit(j))))
            .collect();
        let matrix = Matrix::new(&pattern, &values);
        let size = (0..pattern.size()).map(|i| matrix.row_size(i)).collect();
        (pattern, values, size)
    }

    /// Requirement: the factors of a definite matrix solve it to the precision of the format in any
    /// units; no pivot is named negative. Tolerance: a thousand roundings, the excess being 1.
    #[test]
    fn definite_matrices_are_factored_in_any_units() {
        let (pattern, values, _) = grid(30, 1.0, 30);
        let matrix = Matrix::new(&pattern, &values);
        let mut sparse = Sparse::new(&pattern, Kind::Symmetric, &[], None).unwrap();
        let report = sparse.factor_single(matrix).unwrap();
        assert!(report.negative_pivots == Some(0) && report.smallest_pivot_ratio > 0.05);
        let unit = |i: usize| unit(i, 30);
        let exact = |i: usize| ((i % 13) as f64 - 6.0) / unit(i);
        let x: Vec<f64> = (0..pattern.size()).map(exact).collect();
        let mut b = vec![0.0; x.len()];
        matrix.multiply(&x, &mut b);
        LinearSystem::solve(&mut sparse, &mut b, 1).unwrap();
        let off = |(i, (b, x)): (usize, (&f64, &f64))| (b - x).abs() * unit(i);
        let worst = b.iter().zip(&x).enumerate().map(off).fold(0.0, f64::max);
        assert!(worst < 1e3 * 6.0 * f64::from(f32::EPSILON) && worst > 1e-9, "{worst:e}");
    }

    /// Requirement: where the format leaves the sign of a pivot in doubt, where one is negative, and
    /// where a diagonal is, nothing is said: the factorisation in double decides.
    #[test]
    fn what_is_in_doubt_is_left_to_double() {
        for excess in [1e-7, -1e-3, -1.1, -5.3] {
            let (pattern, values, size) = grid(30, excess, 0);
            let matrix = Matrix::new(&pattern, &values);
            let mut sparse = Sparse::new(&pattern, Kind::Symmetric, &[], None).unwrap();
            assert_eq!(sparse.factor_single(matrix), None, "{excess}");
            sparse.scatter(matrix);
            let report = LinearSystem::factor(&mut sparse, matrix, &size).unwrap();
            let negative = report.negative_pivots.unwrap_or(if excess > 0.0 { 0 } else { 1 });
            assert_eq!(negative == 0, excess > 0.0, "{excess}");
        }
    }
}
