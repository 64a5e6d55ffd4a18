//! The line of three nodes: end, middle, end.

/// Shape functions of the three nodes at xi in [-1, 1]: docs/theory.md eq. (3.9).
pub fn line3_shapes(xi: f64) -> [f64; 3] {
    [0.5 * xi * (xi - 1.0), (1.0 - xi) * (1.0 + xi), 0.5 * xi * (xi + 1.0)]
}

/// Their derivatives by xi.
pub fn line3_slopes(xi: f64) -> [f64; 3] {
    [xi - 0.5, -2.0 * xi, xi + 0.5]
}
