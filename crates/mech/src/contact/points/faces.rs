//! Tributary areas of the nodes of faces in space.
//!
//! ```text
//!    o-------o     o---o---o     linear: the integral of the shape function
//!    | 1/4   |     |   |   |     quadratic: that of the four parts that the middle nodes make,
//!    o-------o     o---+---o     since the integrals of corner functions are zero or negative
//! ```

use crate::element::cell::Cell;
use crate::element::quadrature::{QUAD_4, TRI_3};
use crate::vector::{Vector, add, cross, scale, size};

/// Area that each node of a face stands for [L2]: `add` takes the place of a node and its part.
pub fn tributary_areas(cell: &Cell, nodes: &[Vector], mut add_at: impl FnMut(usize, f64)) {
    let corners = cell.faces.len();
    let linear = cell.nodes == corners;
    let quadrature = if corners == 3 { &TRI_3 } else { &QUAD_4 };
    for (at, weight) in quadrature.points.iter().zip(quadrature.weights) {
        let (mut shapes, mut slopes) = ([0.0; 8], [[0.0; 3]; 8]);
        (cell.shapes)(at, &mut shapes);
        (cell.slopes)(at, &mut slopes);
        let tangent = |axis: usize| {
            let own = nodes.iter().zip(&slopes);
            own.fold([0.0; 3], |sum, (node, slope)| add(sum, scale(*node, slope[axis])))
        };
        let area = weight * size(cross(tangent(0), tangent(1)));
        for (node, shape) in shapes[..cell.nodes].iter().enumerate() {
            let share = match (linear, corners, node < corners) {
                (true, ..) => *shape,
                (false, 3, true) => 1.0 / 12.0,
                (false, 3, false) => 1.0 / 4.0,
                (false, _, true) => 1.0 / 16.0,
                (false, _, false) => 3.0 / 16.0,
            };
            add_at(node, share * area);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::cell::{QUAD4, QUAD8, TRI3, TRI6};

    /// Requirement: the areas of the nodes of a face are positive and sum to that of the face, and
    /// those of a linear one load it without moment about its centroid.
    #[test]
    fn areas_are_those_of_the_face() {
        for cell in [&TRI3, &QUAD4, &TRI6, &QUAD8] {
            let nodes: Vec<Vector> =
                cell.places.iter().map(|p| [2.0 * p[0] + 0.5 * p[1], 3.0 * p[1], p[0]]).collect();
            let reference = if cell.faces.len() == 3 { 0.5 } else { 4.0 };
            let whole = reference * size(cross([2.0, 0.0, 1.0], [0.5, 3.0, 0.0]));
            let mut areas = vec![0.0; cell.nodes];
            tributary_areas(cell, &nodes, |node, area| areas[node] += area);
            assert!(areas.iter().all(|area| *area > 0.0), "{}", cell.name);
            let sum: f64 = areas.iter().sum();
            assert!((sum - whole).abs() < 1e-13 * whole, "{} {sum} {whole}", cell.name);
        }
        // a trapezium of heights 1 and 3: a uniform pressure acts in its centroid
        let nodes = [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [2.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        let (mut area, mut moment) = (0.0, [0.0; 3]);
        tributary_areas(&QUAD4, &nodes, |node, own| {
            area += own;
            moment = add(moment, scale(nodes[node], own));
        });
        // of the square of side 2 and the triangle beside it
        let exact = [2.0 * 1.0 + 0.5 * (2.0 + 1.0 / 3.0), 2.0 * 0.5 + 0.5 / 3.0];
        assert!((area - 2.5).abs() < 1e-14, "{area}");
        assert!((moment[0] - exact[0]).abs() < 1e-13 && (moment[1] - exact[1]).abs() < 1e-13);
    }
}
