//! The quadrilateral of four nodes, counter-clockwise from (-1, -1).

/// Corners of the reference square.
const CORNERS: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

/// Shape functions of the four nodes at (xi, eta) in [-1, 1]^2: docs/theory.md eq. (3.31).
pub fn quad4_shapes([xi, eta]: [f64; 2]) -> [f64; 4] {
    CORNERS.map(|[a, b]| 0.25 * (1.0 + a * xi) * (1.0 + b * eta))
}

/// Their derivatives by xi and eta.
pub fn quad4_slopes([xi, eta]: [f64; 2]) -> [[f64; 2]; 4] {
    CORNERS.map(|[a, b]| [0.25 * a * (1.0 + b * eta), 0.25 * b * (1.0 + a * xi)])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: one at the own node, zero at the others, sum one; slopes by central
    /// differences, exact for bilinear functions. Tolerance: rounding.
    #[test]
    fn shapes_of_the_quadrilateral() {
        for (node, corner) in CORNERS.into_iter().enumerate() {
            let shapes = quad4_shapes(corner);
            assert!((0..4).all(|k| shapes[k] == if k == node { 1.0 } else { 0.0 }));
        }
        let at = [0.3, -0.7];
        assert!((quad4_shapes(at).iter().sum::<f64>() - 1.0).abs() < 1e-15);
        let slopes = quad4_slopes(at);
        for axis in 0..2 {
            let moved = |by: f64| {
                let mut place = at;
                place[axis] += by;
                quad4_shapes(place)
            };
            let (up, down) = (moved(0.25), moved(-0.25));
            for node in 0..4 {
                assert!((slopes[node][axis] - 2.0 * (up[node] - down[node])).abs() < 1e-15);
            }
        }
    }
}
