//! Dual shape functions of a face: those that hold one node's own position alone.
//!
//! ```text
//!   int Phi_j N_k = delta_jk int N_k          Phi = D M^-1 N over what is covered of the face
//! ```
//!
//! docs/theory.md eq. (5.31)

use super::curve::MOST_CONTROLS;
use crate::differentiate::Real;

/// A matrix over the control points of a face, row by row.
pub type Matrix<R> = [[R; MOST_CONTROLS]; MOST_CONTROLS];

/// The matrix of zeros.
pub fn zeros<R: Real>() -> Matrix<R> {
    [[R::from_f64(0.0); MOST_CONTROLS]; MOST_CONTROLS]
}

/// The inverse of a symmetric mass matrix of so many rows.
pub fn inverse<R: Real>(mass: &Matrix<R>, count: usize) -> Matrix<R> {
    let m = mass;
    let mut own = zeros();
    if count == 2 {
        let det = m[0][0] * m[1][1] - m[0][1] * m[0][1];
        own[0][0] = m[1][1] / det;
        own[1][1] = m[0][0] / det;
        own[0][1] = -m[0][1] / det;
        own[1][0] = own[0][1];
        return own;
    }
    let minor = |i: usize, j: usize| {
        let (a, b) = ((i + 1) % 3, (i + 2) % 3);
        let (c, d) = ((j + 1) % 3, (j + 2) % 3);
        m[a][c] * m[b][d] - m[a][d] * m[b][c]
    };
    let det = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
    for (i, row) in own.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            *entry = minor(j, i) / det;
        }
    }
    own
}

/// Row times vector over so many entries.
pub fn along<R: Real>(row: &[R; MOST_CONTROLS], vector: &[R; MOST_CONTROLS], count: usize) -> R {
    let own = row[..count].iter().zip(vector);
    own.fold(R::from_f64(0.0), |sum, (&a, &b)| sum + a * b)
}
