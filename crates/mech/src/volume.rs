//! Forces per volume, spread over the nodes of a cell: f_i = int N_i b dV.
//!
//! ```text
//!    o-----o      b at each integration point, its share to every node
//!    |  b  |
//!    o-----o
//! ```

use crate::element::cell::{Cell, line3_shapes, line3_slopes};
use crate::element::quadrature::{GAUSS_4, GAUSS_4_MEAN, Quadrature};

/// The most nodes of a cell.
pub const MOST: usize = 20;

/// Calls `at` with every point of a product rule on the reference cell and its weight. Simplices
/// are squares and cubes of which one side is drawn together. With four points an axis polynomials
/// of degree 7 are exact, on triangles 6, on tetrahedra 5: a quadratic shape function times a force
/// that grows with the place twice, on straight edges. docs/theory.md eq. (4.10).
fn for_each_point(cell: &Cell, mut at: impl FnMut([f64; 3], f64)) {
    // points and weights on [0, 1]
    let line = || GAUSS_4.into_iter().zip(GAUSS_4_MEAN).map(|(x, w)| (0.5 * (1.0 + x), w));
    let simplex = matches!(cell.nodes, 3 | 6) && cell.dimension == 2;
    let wedge = matches!(cell.nodes, 6 | 15) && cell.dimension == 3;
    let tetrahedron = matches!(cell.nodes, 4 | 10) && cell.dimension == 3;
    for ((x, u), (y, v)) in line().flat_map(|x| line().map(move |y| (x, y))) {
        if cell.dimension == 2 {
            match simplex {
                true => at([x, y * (1.0 - x), 0.0], u * v * (1.0 - x)),
                false => at([2.0 * x - 1.0, 2.0 * y - 1.0, 0.0], 4.0 * u * v),
            }
            continue;
        }
        for (z, w) in line() {
            let (upright, weight) = (2.0 * z - 1.0, u * v * w);
            if tetrahedron {
                let (left, rest) = (1.0 - x, (1.0 - x) * (1.0 - y));
                at([x, y * left, z * rest], weight * left * rest);
            } else if wedge {
                at([x, y * (1.0 - x), upright], 2.0 * weight * (1.0 - x));
            } else {
                at([2.0 * x - 1.0, 2.0 * y - 1.0, upright], 8.0 * weight);
            }
        }
    }
}

/// Forces on the nodes at `x` [L] of a force per volume that depends on the place [F/L3]; an area
/// has a thickness [L]. Exact on straight edges, or by the points of a rule. `None` for a cell
/// without volume.
pub fn spread(
    (cell, rule): (&Cell, Option<&Quadrature>),
    thickness: f64,
    x: &[[f64; 3]],
    body: impl Fn([f64; 3]) -> [f64; 3],
) -> Option<Vec<[f64; 3]>> {
    if !matches!(cell.dimension, 2 | 3) || cell.nodes > MOST {
        return None;
    }
    let mut forces = vec![[0.0; 3]; cell.nodes];
    for_each_share((cell, rule), thickness, x, |shapes, at, volume| {
        let force = body(at);
        for (own, shape) in forces.iter_mut().zip(shapes) {
            own.iter_mut().zip(force).for_each(|(f, b)| *f += volume * shape * b);
        }
    });
    Some(forces)
}

/// Masses of pairs of the nodes at `x` [L], row by row [M], of a density that depends on the place
/// [M/L3]; else as [`spread`]: docs/theory.md eq. (4.28).
pub fn masses(
    (cell, rule): (&Cell, Option<&Quadrature>),
    thickness: f64,
    x: &[[f64; 3]],
    density: impl Fn([f64; 3]) -> f64,
) -> Option<Vec<f64>> {
    if !matches!(cell.dimension, 2 | 3) || cell.nodes > MOST {
        return None;
    }
    let mut masses = vec![0.0; cell.nodes * cell.nodes];
    for_each_share((cell, rule), thickness, x, |shapes, at, volume| {
        let mass = volume * density(at);
        for (row, own) in masses.chunks_exact_mut(cell.nodes).zip(shapes) {
            row.iter_mut().zip(shapes).for_each(|(entry, other)| *entry += mass * own * other);
        }
    });
    Some(masses)
}

/// Calls `share` with the shape functions, the place [L] and the volume [L3] of every point of a
/// rule, or of those of the exact product.
fn for_each_share(
    (cell, rule): (&Cell, Option<&Quadrature>),
    thickness: f64,
    x: &[[f64; 3]],
    mut share: impl FnMut(&[f64], [f64; 3], f64),
) {
    let mut add = |place: [f64; 3], weight: f64| {
        let (mut shapes, mut slopes) = ([0.0; MOST], [[0.0; 3]; MOST]);
        (cell.shapes)(&place, &mut shapes[..cell.nodes]);
        (cell.slopes)(&place, &mut slopes[..cell.nodes]);
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
        share(&shapes[..cell.nodes], at, weight * volume);
    };
    match rule {
        Some(rule) => rule.points.iter().zip(rule.weights).for_each(|(at, &w)| add(*at, w)),
        None => for_each_point(cell, add),
    }
}

/// Forces on the nodes at `x` [L] of a line of two or three of a force per length [F/L] that depends
/// on the place [L] and the unit tangent; two nodes for any other number of them.
pub fn spread_along(
    x: &[[f64; 3]],
    pull: impl Fn([f64; 3], [f64; 3]) -> [f64; 3],
) -> Vec<[f64; 3]> {
    let mut forces = vec![[0.0; 3]; x.len()];
    for_each_share_along(x, |shapes, (at, along), length| {
        let force = pull(at, along);
        for (own, shape) in forces.iter_mut().zip(shapes) {
            own.iter_mut().zip(force).for_each(|(own, force)| *own += length * shape * force);
        }
    });
    forces
}

/// Masses of pairs of the nodes at `x` [L] of such a line, row by row [M], of a mass per length [M/L].
pub fn masses_along(x: &[[f64; 3]], mass: f64) -> Vec<f64> {
    let mut masses = vec![0.0; x.len() * x.len()];
    for_each_share_along(x, |shapes, _, length| {
        for (row, own) in masses.chunks_exact_mut(x.len()).zip(shapes) {
            row.iter_mut()
                .zip(shapes)
                .for_each(|(entry, other)| *entry += mass * length * own * other);
        }
    });
    masses
}

/// Calls `share` with the shape functions, the place [L] with the unit tangent, and the length [L] of
/// every point of a line.
fn for_each_share_along(
    x: &[[f64; 3]],
    mut share: impl FnMut(&[f64; 3], ([f64; 3], [f64; 3]), f64),
) {
    for (xi, weight) in GAUSS_4.into_iter().zip(GAUSS_4_MEAN) {
        let (shapes, slopes) = match x.len() {
            3 => (line3_shapes(xi), line3_slopes(xi)),
            _ => ([0.5 * (1.0 - xi), 0.5 * (1.0 + xi), 0.0], [-0.5, 0.5, 0.0]),
        };
        let sum = |by: &[f64; 3]| -> [f64; 3] {
            std::array::from_fn(|k| x.iter().zip(by).map(|(x, by)| by * x[k]).sum())
        };
        let (at, along) = (sum(&shapes), sum(&slopes));
        let length = along[0].hypot(along[1]).hypot(along[2]);
        // the weights are those of an interval of length one
        share(&shapes, (at, along.map(|part| part / length)), 2.0 * weight * length);
    }
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
            let forces = spread((cell, None), 1.0, &x, |[x, ..]| [1.0, x, 0.0]).unwrap_or_default();
            let sum = [0, 1].map(|k| forces.iter().map(|f| f[k]).sum::<f64>());
            assert!((sum[0] - volume).abs() < 1e-14, "{}: {sum:?}", cell.name);
            assert!((sum[1] - volume * (2.0 + centre)).abs() < 1e-13, "{}: {sum:?}", cell.name);
        }
        assert!(spread((&LINE2, None), 1.0, &[[0.0; 3]; 2], |_| [0.0; 3]).is_none());
    }

    /// Requirement: of a uniform force per length both ends take half, ends and middle a sixth and
    /// two thirds; of one that grows along the line a third and two thirds.
    #[test]
    fn shares_along_lines() {
        let x = [[1.0, 0.0, 0.0], [1.0, 3.0, 4.0]];
        let even = spread_along(&x, |_, _| [2.0, 0.0, 0.0]);
        let growing = spread_along(&x, |at, t| [at[1] * t[1], at[1] * t[2], 0.0]);
        for k in 0..2 {
            assert!((even[k][0] - 5.0).abs() < 1e-14, "{even:?}");
            let share = [2.5, 5.0][k];
            assert!((growing[k][0] - 0.6 * share).abs() < 1e-14, "{growing:?}");
            assert!((growing[k][1] - 0.8 * share).abs() < 1e-14, "{growing:?}");
        }
        let three = [[0.0; 3], [0.0, 0.0, 3.0], [0.0, 0.0, 6.0]];
        let even = spread_along(&three, |_, t| t);
        assert!([1.0, 4.0, 1.0].iter().zip(even).all(|(own, f)| (f[2] - own).abs() < 1e-14));
    }

    /// Requirement: every node's own share of a uniform force, of one that grows with the place (a
    /// turning body) and, on rings, of both times 2 pi r, on affine cells. Source: integrals of
    /// barycentric coordinates, int L1^a L2^b L3^c = a! b! c! d!/(a + b + c + d)! V. Tolerance:
    /// rounding.
    #[test]
    fn shares_of_the_nodes() {
        let factorial = |n: usize| (1..=n).map(|k| k as f64).product::<f64>();
        for (cell, d) in [(&TRI3, 2), (&TRI6, 2), (&TET4, 3), (&TET10, 3)] {
            let map = |&[a, b, c]: &[f64; 3]| [2.0 + a + 0.5 * b + 0.25 * c, 1.5 * b, 0.75 * c];
            let x: Vec<[f64; 3]> = cell.places.iter().map(map).collect();
            let volume = (if d == 2 { 1.5 } else { 1.5 * 0.75 }) / factorial(d);
            // int of a product of barycentric coordinates
            let integral = |list: &[usize]| {
                let mut powers = [0; 4];
                list.iter().for_each(|&k| powers[k] += 1);
                let top: f64 = powers.iter().map(|&n| factorial(n)).product();
                volume * top * factorial(d) / factorial(list.len() + d)
            };
            // shape functions as sums of products, and the first coordinate as one of corners
            let corners = d + 1;
            let shape = |node: usize| -> Vec<(f64, Vec<usize>)> {
                if cell.nodes == corners {
                    return vec![(1.0, vec![node])];
                }
                if node < corners {
                    return vec![(2.0, vec![node, node]), (-1.0, vec![node])];
                }
                let ends: &[[usize; 2]] = if d == 2 {
                    &[[0, 1], [1, 2], [2, 0]]
                } else {
                    &[[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]]
                };
                vec![(4.0, ends[node - corners].to_vec())]
            };
            for power in 0..=2 {
                let forces =
                    spread((cell, None), 1.0, &x, |[x, ..]| [f64::powi(x, power), 0.0, 0.0]);
                for (node, force) in forces.unwrap_or_default().iter().enumerate() {
                    let mut exact = 0.0;
                    let count = corners.pow(power as u32);
                    for (factor, own) in shape(node) {
                        for code in 0..count {
                            let more: Vec<usize> = (0..power as u32)
                                .map(|k| code / corners.pow(k) % corners)
                                .collect();
                            let radii: f64 = more.iter().map(|&k| x[k][0]).product();
                            exact += factor * radii * integral(&[own.clone(), more].concat());
                        }
                    }
                    let error = (force[0] - exact).abs();
                    assert!(error < 1e-14 * volume * 9.0, "{} {node} {power} {error}", cell.name);
                }
            }
        }
        // a uniform force on the quadratic triangle and tetrahedron, known by heart
        let uniform = |cell: &Cell| {
            let x = cell.places.to_vec();
            spread((cell, None), 1.0, &x, |_| [1.0, 0.0, 0.0]).unwrap_or_default()
        };
        let (six, ten) = (uniform(&TRI6), uniform(&TET10));
        assert!(six[0][0].abs() < 1e-15 && (six[3][0] - 1.0 / 6.0).abs() < 1e-15);
        assert!((ten[0][0] + 1.0 / 120.0).abs() < 1e-15 && (ten[4][0] - 1.0 / 30.0).abs() < 1e-15);
    }
}
