//! The corners of solids.

/// For every corner those at the other ends of its edges, in an order that spans a positive volume.
pub fn corners(dimension: usize, nodes: usize) -> Option<&'static [&'static [usize]]> {
    match (dimension, nodes) {
        (2, 3 | 6) => Some(&[&[1, 2], &[2, 0], &[0, 1]]),
        (2, 4 | 8) => Some(&[&[1, 3], &[2, 0], &[3, 1], &[0, 2]]),
        (3, 4 | 10) => Some(&[&[1, 2, 3], &[2, 0, 3], &[0, 1, 3], &[0, 2, 1]]),
        (3, 6 | 15) => {
            Some(&[&[1, 2, 3], &[2, 0, 4], &[0, 1, 5], &[5, 4, 0], &[3, 5, 1], &[4, 3, 2]])
        }
        (3, 8 | 20) => Some(&[
            &[1, 3, 4],
            &[2, 0, 5],
            &[3, 1, 6],
            &[0, 2, 7],
            &[7, 5, 0],
            &[4, 6, 1],
            &[5, 7, 2],
            &[6, 4, 3],
        ]),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use slideline_mech::vector::{cross, dot, sub};

    /// Requirement: the edges of every corner of a cell's reference shape span a positive volume.
    #[test]
    fn corners_of_reference_cells_are_right() {
        let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        let up = |x: [f64; 3]| [x[0], x[1], 1.0];
        let cube: Vec<[f64; 3]> = square.into_iter().chain(square.map(up)).collect();
        let triangle = [square[0], square[1], square[3]];
        let wedge: Vec<[f64; 3]> = triangle.into_iter().chain(triangle.map(up)).collect();
        let tetrahedron = [square[0], square[1], square[3], [0.0, 0.0, 1.0]];
        let cells: [(usize, &[[f64; 3]]); 5] =
            [(2, &triangle), (2, &square), (3, &tetrahedron), (3, &wedge), (3, &cube)];
        for (dimension, at) in cells {
            for (own, others) in corners(dimension, at.len()).unwrap_or(&[]).iter().enumerate() {
                let mut edges = [[0.0, 0.0, 1.0]; 3];
                for (edge, &other) in edges.iter_mut().zip(*others) {
                    *edge = sub(at[other], at[own]);
                }
                let spans = dot(cross(edges[0], edges[1]), edges[2]);
                assert!(spans > 0.9, "{dimension} {} {own}: {spans}", at.len());
            }
        }
    }
}
