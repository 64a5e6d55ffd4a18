//! Forces and tangents of two ends that pull at one another.

/// The forces of a pull along a unit vector on both nodes.
pub(super) fn push<const D: usize>(t: &[f64; D], pull: f64, force: &mut [f64]) {
    for (k, t) in t.iter().enumerate() {
        (force[k], force[D + k]) = (-pull * t, pull * t);
    }
}

/// The tangent [[B, -B], [-B, B]] of a block of so many rows.
pub(super) fn fill(tangent: &mut [f64], dimension: usize, block: impl Fn(usize, usize) -> f64) {
    let width = 2 * dimension;
    for i in 0..width {
        for j in 0..width {
            let sign = if (i < dimension) == (j < dimension) { 1.0 } else { -1.0 };
            tangent[width * i + j] = sign * block(i % dimension, j % dimension);
        }
    }
}

/// Length of a vector, without over- or underflow of its squares.
pub(super) fn length<const D: usize>(a: &[f64; D]) -> f64 {
    let scale = a.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    if scale == 0.0 {
        0.0
    } else {
        scale * a.iter().map(|x| (x / scale).powi(2)).sum::<f64>().sqrt()
    }
}
