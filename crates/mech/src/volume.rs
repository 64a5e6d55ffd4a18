//! Forces per volume, spread over the nodes of a cell: f_i = int N_i b dV.
//!
//! ```text
//!    o-----o      b at each integration point, its share to every node
//!    |  b  |
//!    o-----o
//! ```

use crate::element::cell::Cell;
use crate::element::quadrature::{
    HEX_8, HEX_27, QUAD_4, QUAD_9, Quadrature, TET_1, TET_4, TRI_3, WEDGE_3X3,
};

/// The most nodes of a cell.
const MOST: usize = 20;

/// A rule that integrates the shape functions of a cell; `None` for a cell without volume.
fn rule(cell: &Cell) -> Option<&'static Quadrature> {
    Some(match (cell.dimension, cell.nodes) {
        (2, 3 | 6) => &TRI_3,
        (2, 4) => &QUAD_4,
        (2, 8) => &QUAD_9,
        (3, 4) => &TET_1,
        (3, 10) => &TET_4,
        (3, 6 | 15) => &WEDGE_3X3,
        (3, 8) => &HEX_8,
        (3, 20) => &HEX_27,
        _ => return None,
    })
}

/// Forces on the nodes at `x` [L] of a force per volume that depends on the place [F/L3]; an area
/// has a thickness [L]. `None` for a cell without volume.
pub fn spread(
    cell: &Cell,
    thickness: f64,
    x: &[[f64; 3]],
    body: impl Fn([f64; 3]) -> [f64; 3],
) -> Option<Vec<[f64; 3]>> {
    let rule = rule(cell)?;
    let mut forces = vec![[0.0; 3]; cell.nodes];
    for (place, &weight) in rule.points.iter().zip(rule.weights) {
        let (mut shapes, mut slopes) = ([0.0; MOST], [[0.0; 3]; MOST]);
        (cell.shapes)(place, &mut shapes[..cell.nodes]);
        (cell.slopes)(place, &mut slopes[..cell.nodes]);
        let (mut at, mut jacobian) = ([0.0; 3], [[0.0; 3]; 3]);
        for ((x, shape), slope) in x.iter().zip(shapes).zip(slopes) {
            for k in 0..3 {
                at[k] += shape * x[k];
                (0..3).for_each(|j| jacobian[j][k] += slope[j] * x[k]);
            }
        }
        let [a, b, c] = jacobian;
        let volume = match cell.dimension {
            2 => thickness * (a[0] * b[1] - a[1] * b[0]),
            _ => {
                let area = [
                    a[1] * b[2] - a[2] * b[1],
                    a[2] * b[0] - a[0] * b[2],
                    a[0] * b[1] - a[1] * b[0],
                ];
                (0..3).map(|k| area[k] * c[k]).sum()
            }
        };
        let force = body(at);
        for (own, shape) in forces.iter_mut().zip(shapes) {
            own.iter_mut().zip(force).for_each(|(f, b)| *f += weight * volume * shape * b);
        }
    }
    Some(forces)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::cell::{
        HEX8, HEX20, LINE2, QUAD4, QUAD8, TET4, TET10, TRI3, TRI6, WEDGE6, WEDGE15,
    };

    /// Requirement: of a uniform force on the reference cell the nodes together take the volume,
    /// and of one that grows with x the sum is its integral, here by an affine map x = 2 + xi.
    #[test]
    fn sums_are_integrals() {
        let cells = [
            (&TRI3, 0.5, 1.0 / 3.0),
            (&TRI6, 0.5, 1.0 / 3.0),
            (&QUAD4, 4.0, 0.0),
            (&QUAD8, 4.0, 0.0),
            (&TET4, 1.0 / 6.0, 0.25),
            (&TET10, 1.0 / 6.0, 0.25),
            (&WEDGE6, 1.0, 1.0 / 3.0),
            (&WEDGE15, 1.0, 1.0 / 3.0),
            (&HEX8, 8.0, 0.0),
            (&HEX20, 8.0, 0.0),
        ];
        for (cell, volume, centre) in cells {
            let x: Vec<[f64; 3]> = cell.places.iter().map(|&[a, b, c]| [2.0 + a, b, c]).collect();
            let forces = spread(cell, 1.0, &x, |[x, ..]| [1.0, x, 0.0]).unwrap_or_default();
            let sum = [0, 1].map(|k| forces.iter().map(|f| f[k]).sum::<f64>());
            assert!((sum[0] - volume).abs() < 1e-14, "{}: {sum:?}", cell.name);
            assert!((sum[1] - volume * (2.0 + centre)).abs() < 1e-13, "{}: {sum:?}", cell.name);
        }
        assert!(spread(&LINE2, 1.0, &[[0.0; 3]; 2], |_| [0.0; 3]).is_none());
    }
}
