//! Scaling of rows and columns, used when a pivot is suspiciously small.

use crate::pattern::Matrix;

/// Number of sweeps; each takes the square root of what is left of the imbalance.
const SWEEPS: usize = 8;

/// Fills `scale` with powers of two such that the largest magnitude of each row and column of
/// S A S is near one. A small pivot that is only a matter of units (a multiplier beside a stiffness
/// of 1e14) becomes an ordinary one; one that is a matter of singularity stays small. After Ruiz
/// (2001), with one scale for row and column.
pub(crate) fn equilibrate(matrix: Matrix<'_>, scale: &mut [f64], largest: &mut [f64]) {
    scale.fill(1.0);
    for _ in 0..SWEEPS {
        largest.fill(0.0);
        for i in 0..matrix.pattern.size() {
            let (columns, values) = matrix.row(i);
            for (&j, &a) in columns.iter().zip(values) {
                let scaled = (a * scale[i] * scale[j]).abs();
                largest[i] = largest[i].max(scaled);
                largest[j] = largest[j].max(scaled);
            }
        }
        for (s, &l) in scale.iter_mut().zip(largest.iter()) {
            if l > 0.0 {
                *s /= l.sqrt();
            }
        }
    }
    scale.iter_mut().for_each(|s| *s = s.log2().round().exp2());
}
