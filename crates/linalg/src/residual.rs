//! The residual of a solution, as a backward error.

use crate::pattern::Matrix;

/// Largest backward error max_i |r_i| / (|A|_i max|x| + |b_i|) over rows of (r_i, |A|_i, b_i), where
/// |A|_i is the size of row i (Rigal and Gaches' measure with one norm for x). It does not depend on
/// the scaling of the equations. Infinite where it cannot be computed.
pub(crate) fn worst_of(rows: impl Iterator<Item = (f64, f64, f64)>, x: &[f64]) -> f64 {
    let mut largest_x = 0.0f64;
    for x_j in x {
        largest_x = largest_x.max(x_j.abs());
    }
    let mut worst = 0.0;
    for (residual, size, b) in rows {
        let scale = size * largest_x + b.abs();
        let usual = residual.abs() <= worst * scale;
        if !usual {
            worst = residual.abs() / scale;
            if worst.is_nan() {
                return f64::INFINITY;
            }
        }
    }
    worst
}

/// Backward error of a solution of the whole system for the right-hand side `b`.
pub(crate) fn worst_residual(
    matrix: Matrix<'_>,
    row_size: &[f64],
    x: &[f64],
    b: impl Fn(usize) -> f64,
) -> f64 {
    let rows = row_size.iter().enumerate();
    worst_of(rows.map(|(i, &size)| (b(i) - matrix.row_times(i, x), size, b(i))), x)
}
