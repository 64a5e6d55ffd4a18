//! Where a point is in a cell: the place of the reference cell that maps to it.
//!
//! ```text
//!   x = sum N_i(xi) X_i       Newton in xi from the middle; a point outside is taken to a place
//!                             of the reference cell beside it, and is so far away from that
//! ```
//! docs/theory.md section 4.2.

use super::reference::Cell;
use crate::material::tensor::{Matrix, inverse};
use crate::vector::dot;

/// Iterations after which a point is taken for one that the cell does not map to. (choice)
const ITERATIONS: usize = 30;
/// Change of a place that is none [1].
const SETTLED: f64 = 1e-12;
/// How far from the reference cell a place is still looked for [1]. (choice)
const FAR: f64 = 10.0;

/// A place in a cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Within {
    /// Coordinates of the reference cell.
    pub place: [f64; 3],
    /// Distance of the point from what that place maps to [L]: next to nothing where it is inside.
    pub distance: f64,
}

/// Where a point is in an area or a volume on these positions of its nodes [L]; `None`: nowhere near.
pub fn within(cell: &Cell, nodes: &[[f64; 3]], point: [f64; 3]) -> Option<Within> {
    let (mut shapes, mut slopes) = (vec![0.0; cell.nodes], vec![[0.0; 3]; cell.nodes]);
    let mut place = middle(cell);
    let mut steps = 0..ITERATIONS;
    loop {
        steps.next()?;
        let left = off(cell, nodes, (&place, point), &mut shapes);
        let (back, volume) = inverse(&map(cell, nodes, &place, &mut slopes));
        let change: [f64; 3] = std::array::from_fn(|k| dot(back[k], left));
        if volume == 0.0 || !change.iter().all(|part| part.is_finite()) {
            return None;
        }
        (0..cell.dimension).for_each(|k| place[k] += change[k]);
        if place.iter().any(|part| part.abs() > FAR) {
            return None;
        }
        if change[..cell.dimension].iter().all(|part| part.abs() < SETTLED) {
            break;
        }
    }
    let place = inside(cell, place);
    let left = off(cell, nodes, (&place, point), &mut shapes);
    Some(Within { place, distance: dot(left, left).sqrt() })
}

/// The way from what a place maps to to a point; in the plane without its third component.
fn off(
    cell: &Cell,
    nodes: &[[f64; 3]],
    (place, point): (&[f64; 3], [f64; 3]),
    shapes: &mut [f64],
) -> [f64; 3] {
    (cell.shapes)(place, shapes);
    std::array::from_fn(|k| match k < cell.dimension {
        true => nodes.iter().zip(&*shapes).map(|(node, shape)| shape * (point[k] - node[k])).sum(),
        false => 0.0,
    })
}

fn map(cell: &Cell, nodes: &[[f64; 3]], place: &[f64; 3], slopes: &mut [[f64; 3]]) -> Matrix {
    (cell.slopes)(place, slopes);
    let mut map: Matrix = [[0.0; 3]; 3];
    for (node, slopes) in nodes.iter().zip(&*slopes) {
        for i in 0..cell.dimension {
            for k in 0..cell.dimension {
                map[i][k] += (node[i] - nodes[0][i]) * slopes[k];
            }
        }
    }
    (cell.dimension..3).for_each(|axis| map[axis][axis] = 1.0);
    map
}

/// The mean of the places of the nodes.
fn middle(cell: &Cell) -> [f64; 3] {
    let sum = |k: usize| cell.places.iter().map(|place| place[k]).sum::<f64>();
    std::array::from_fn(|k| sum(k) / cell.places.len().max(1) as f64)
}

/// Axes of the reference cell that make a simplex: its first ones.
fn of_simplex(cell: &Cell) -> usize {
    match (cell.dimension, cell.nodes) {
        (2, 3 | 6) | (3, 6 | 15) => 2,
        (3, 4 | 10) => 3,
        _ => 0,
    }
}

/// A place, or the one of the reference cell beside it.
fn inside(cell: &Cell, mut place: [f64; 3]) -> [f64; 3] {
    let simplex = of_simplex(cell);
    // by the shares of all its corners, none of which comes first
    let rest = 1.0 - place[..simplex].iter().sum::<f64>();
    let sum = rest.max(0.0) + place[..simplex].iter().map(|axis| axis.max(0.0)).sum::<f64>();
    place[..simplex].iter_mut().for_each(|axis| *axis = axis.max(0.0) / sum);
    for axis in place.iter_mut().take(cell.dimension).skip(simplex) {
        *axis = axis.clamp(-1.0, 1.0);
    }
    place
}

#[cfg(test)]
mod tests {
    use super::super::{HEX8, HEX20, QUAD4, QUAD8, TET4, TET10, TRI3, TRI6, WEDGE6, WEDGE15};
    use super::*;

    /// Requirement: a place of a distorted cell is found from where it maps to, and a point beside the
    /// cell is as far away as it is from the side. Source: the map itself. 1e-9.
    #[test]
    fn places_are_found_again() {
        for cell in [&QUAD4, &QUAD8, &TRI3, &TRI6, &HEX8, &HEX20, &TET4, &TET10, &WEDGE6, &WEDGE15]
        {
            let bent = |at: &[f64; 3]| {
                let [x, y, z] = *at;
                let point =
                    [x + 0.1 * y + 0.04 * x * y, 1.2 * y - 0.1 * x + 0.05 * z, z + 0.06 * x * y];
                if cell.dimension == 3 { point } else { [point[0], point[1], 0.0] }
            };
            let nodes: Vec<[f64; 3]> = cell.places.iter().map(bent).collect();
            let at = [0.21, 0.33, if cell.dimension == 3 { 0.17 } else { 0.0 }];
            let mut shapes = vec![0.0; cell.nodes];
            (cell.shapes)(&at, &mut shapes);
            let sum = |k: usize| nodes.iter().zip(&shapes).map(|(x, n)| x[k] * n).sum();
            let point: [f64; 3] = std::array::from_fn(sum);
            let found = within(cell, &nodes, point);
            let found = found.unwrap_or(Within { place: [9.0; 3], distance: 9.0 });
            assert!(found.distance < 1e-9, "{} {found:?}", cell.name);
            assert!(
                (0..3).all(|k| (found.place[k] - at[k]).abs() < 1e-9),
                "{} {found:?}",
                cell.name
            );
        }
        let square = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0]];
        let beside = within(&QUAD4, &square, [2.5, 1.0, 0.0]).map(|found| found.distance);
        assert!(beside.is_some_and(|distance| (distance - 0.5).abs() < 1e-12), "{beside:?}");
        // the place beside a triangle is the same whichever of its nodes comes first
        let triangle = [[0.0, 0.0, 0.0], [2.0, 0.2, 0.0], [0.3, 1.5, 0.0]];
        let from =
            |first: usize| -> Vec<[f64; 3]> { (0..3).map(|k| triangle[(first + k) % 3]).collect() };
        for point in [[1.4, 1.2, 0.0], [-0.2, 0.5, 0.0], [2.3, 0.1, 0.0]] {
            let away = |first| within(&TRI3, &from(first), point).map(|found| found.distance);
            let all = [0, 1, 2].map(|first| away(first).unwrap_or(f64::NAN));
            assert!(all.iter().all(|own| (own - all[0]).abs() < 1e-12), "{all:?}");
        }
    }
}
