//! The residual of a solution, as a backward error.

use crate::pattern::Matrix;

/// Largest backward error max_i |b - A x|_i / (|A|_i max|x| + |b_i|) and its equation, where |A|_i
/// is the size of row i (Rigal and Gaches' measure with one norm for x). It does not depend on the
/// scaling of the equations.
pub(crate) fn worst_residual(
    matrix: Matrix<'_>,
    row_size: &[f64],
    x: &[f64],
    b: impl Fn(usize) -> f64,
) -> (f64, usize) {
    let mut largest_x = 0.0f64;
    for x_j in x {
        largest_x = largest_x.max(x_j.abs());
    }
    let (mut worst, mut equation) = (0.0, 0);
    for (i, size) in row_size.iter().enumerate() {
        let b_i = b(i);
        let residual = (b_i - matrix.row_times(i, x)).abs();
        let scale = size * largest_x + b_i.abs();
        let usual = residual <= worst * scale;
        if !usual {
            (worst, equation) = (residual / scale, i);
        }
    }
    (worst, equation)
}
