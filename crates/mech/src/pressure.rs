//! Pressure on a face that moves: the load follows the face.
//!
//! ```text
//!    1 <---- 2   edge of an area, material on the left:   f_i = -p w int N_i n ds
//!      p | |                                              n ds = (dy, -dx)
//!    face of a volume, corners counter-clockwise from outside:
//!                                                         n dA = x,xi x x,eta dxi deta
//! ```
//! docs/theory.md eqs (4.8), (4.9).

use crate::element::cell::{Cell, QUAD4, QUAD8, TRI3, TRI6, line3_shapes, line3_slopes};
use crate::element::quadrature::{GAUSS_2, GAUSS_3, QUAD_4, QUAD_9, Quadrature, TRI_3};
use crate::vector::cross;

/// The most nodes of a face.
pub const MOST_NODES: usize = 8;

/// What a face is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Face {
    /// An edge of an area, with the thickness behind it [L].
    Edge {
        /// Two or three, in the order along it.
        nodes: usize,
        /// Thickness out of the plane [L].
        thickness: f64,
    },
    /// An edge that runs about the second axis: it is as wide as its circle, 2 pi r [L].
    Ring {
        /// Two or three, in the order along it.
        nodes: usize,
    },
    /// A face of a volume.
    Area(&'static Cell, &'static Quadrature),
}

/// Shape functions and slopes at a point, with its weight.
pub(crate) struct At {
    /// Weight of the rule, times the thickness or, of a ring, the circle of radius one.
    pub weight: f64,
    /// Shape functions [1].
    pub shapes: [f64; MOST_NODES],
    /// Their slopes by the coordinates of the face [1].
    pub slopes: [[f64; 2]; MOST_NODES],
}

impl Face {
    /// The face of an area (dimension 2) or a volume (3) with so many nodes.
    pub fn of(dimension: usize, nodes: usize, thickness: f64) -> Option<Self> {
        match (dimension, nodes) {
            (2, 2 | 3) => Some(Self::Edge { nodes, thickness }),
            (3, 3) => Some(Self::Area(&TRI3, &TRI_3)),
            (3, 4) => Some(Self::Area(&QUAD4, &QUAD_4)),
            (3, 6) => Some(Self::Area(&TRI6, &TRI_3)),
            (3, 8) => Some(Self::Area(&QUAD8, &QUAD_9)),
            _ => None,
        }
    }

    /// The face of a ring with so many nodes.
    pub fn of_ring(nodes: usize) -> Option<Self> {
        matches!(nodes, 2 | 3).then_some(Self::Ring { nodes })
    }

    /// Displacements of a node that it uses: two or three.
    pub fn axes(&self) -> usize {
        match self {
            Self::Edge { .. } | Self::Ring { .. } => 2,
            Self::Area(..) => 3,
        }
    }

    /// Where it is integrated.
    pub(crate) fn points(&self) -> impl Iterator<Item = At> + '_ {
        let count = match self {
            Self::Edge { nodes, .. } | Self::Ring { nodes } => *nodes,
            Self::Area(_, rule) => rule.points.len(),
        };
        (0..count).map(|k| match self {
            Self::Edge { nodes, thickness } => edge_point(*nodes, k, *thickness),
            Self::Ring { nodes } => edge_point(*nodes, k, 2.0 * std::f64::consts::PI),
            Self::Area(cell, rule) => area_at(cell, &rule.points[k], rule.weights[k]),
        })
    }

    /// Forces of a unit pressure on the nodes at `x` [L]: adds pressure times them to `force`, three
    /// for each node [F].
    pub fn press(&self, pressure: f64, x: &[[f64; 3]], force: &mut [[f64; 3]]) {
        for at in self.points() {
            let normal = self.normal(&at, x);
            for (own, shape) in force.iter_mut().zip(at.shapes) {
                let factor = -pressure * at.weight * shape;
                own.iter_mut().zip(normal).for_each(|(f, n)| *f += factor * n);
            }
        }
    }

    /// Forces of a traction [F/L2], given at each place, on a face that stays at `x` [L].
    pub fn pull(
        &self,
        traction: impl Fn([f64; 3]) -> [f64; 3],
        x: &[[f64; 3]],
        force: &mut [[f64; 3]],
    ) {
        for at in self.points() {
            let traction = traction(place(&at, x));
            let normal = self.normal(&at, x);
            let area = normal.iter().map(|n| n * n).sum::<f64>().sqrt();
            for (own, shape) in force.iter_mut().zip(at.shapes) {
                let factor = at.weight * shape * area;
                own.iter_mut().zip(traction).for_each(|(f, t)| *f += factor * t);
            }
        }
    }

    /// Outward normal times the area of a point of the reference cell.
    fn normal(&self, at: &At, x: &[[f64; 3]]) -> [f64; 3] {
        let [a, b] = tangents(at, x);
        match self {
            Self::Edge { .. } => [a[1], -a[0], 0.0],
            Self::Ring { .. } => {
                let radius = radius(at, x);
                [radius * a[1], -radius * a[0], 0.0]
            }
            Self::Area(..) => cross(a, b),
        }
    }

    /// Derivative of the forces by the positions: adds to `tangent`, a row for each force and a
    /// column for each position, three of each a node [F/L].
    pub fn stiffness(&self, pressure: f64, x: &[[f64; 3]], tangent: &mut [f64]) {
        let width = 3 * x.len();
        for at in self.points() {
            let [a, b] = tangents(&at, x);
            for (j, slope) in at.slopes.iter().enumerate().take(x.len()) {
                for axis in 0..3 {
                    let mut unit = [0.0; 3];
                    unit[axis] = 1.0;
                    let change = match self {
                        Self::Edge { .. } => [slope[0] * unit[1], -slope[0] * unit[0], 0.0],
                        Self::Ring { .. } => {
                            let (radius, grown) = (radius(&at, x), at.shapes[j] * unit[0]);
                            let [u, v] = [radius * slope[0], grown];
                            [u * unit[1] + v * a[1], -u * unit[0] - v * a[0], 0.0]
                        }
                        Self::Area(..) => {
                            let (first, second) = (cross(unit, b), cross(a, unit));
                            std::array::from_fn(|k| slope[0] * first[k] + slope[1] * second[k])
                        }
                    };
                    for (i, shape) in at.shapes.iter().enumerate().take(x.len()) {
                        let factor = -pressure * at.weight * shape;
                        for (k, part) in change.iter().enumerate() {
                            tangent[(3 * i + k) * width + 3 * j + axis] += factor * part;
                        }
                    }
                }
            }
        }
    }
}

/// Distance of a point of a ring from the second axis [L].
pub(crate) fn radius(at: &At, x: &[[f64; 3]]) -> f64 {
    at.shapes.iter().zip(x).map(|(shape, x)| shape * x[0]).sum()
}

/// Where a point of a face is [L].
pub(crate) fn place(at: &At, x: &[[f64; 3]]) -> [f64; 3] {
    std::array::from_fn(|k| at.shapes.iter().zip(x).map(|(shape, x)| shape * x[k]).sum())
}

/// The place of a face that is nearest to a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// Shape functions there [1].
    pub shapes: [f64; MOST_NODES],
    /// Where it is [L].
    pub place: [f64; 3],
    /// Distance from the point [L].
    pub distance: f64,
}

impl Face {
    /// The place nearest to a point, on a face with nodes at `x` [L]: Gauss-Newton steps, each kept
    /// on the face.
    pub fn nearest(&self, x: &[[f64; 3]], point: [f64; 3]) -> Nearest {
        let here = self.at(self.nearest_place(x, point));
        let foot = place(&here, x);
        let distance = (0..3).map(|k| (point[k] - foot[k]).powi(2)).sum::<f64>().sqrt();
        Nearest { shapes: here.shapes, place: foot, distance }
    }

    /// Coordinates of the face of the place nearest to a point.
    pub(crate) fn nearest_place(&self, x: &[[f64; 3]], point: [f64; 3]) -> [f64; 2] {
        let mut at = match self {
            Self::Area(cell, _) if matches!(cell.nodes, 3 | 6) => [1.0 / 3.0; 2],
            _ => [0.0; 2],
        };
        for _ in 0..30 {
            let here = self.at(at);
            let [a, b] = tangents(&here, x);
            let away: [f64; 3] = std::array::from_fn(|k| point[k] - place(&here, x)[k]);
            let dot = |u: [f64; 3], v: [f64; 3]| u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
            let (aa, ab, bb) = (dot(a, a), dot(a, b), dot(b, b));
            let (ra, rb) = (dot(a, away), dot(b, away));
            let step = match self {
                Self::Edge { .. } | Self::Ring { .. } => [ra / aa, 0.0],
                Self::Area(..) => {
                    let determinant = aa * bb - ab * ab;
                    [(bb * ra - ab * rb) / determinant, (aa * rb - ab * ra) / determinant]
                }
            };
            let next = self.kept([at[0] + step[0], at[1] + step[1]]);
            let moved = (next[0] - at[0]).abs() + (next[1] - at[1]).abs();
            if !moved.is_finite() {
                break;
            }
            at = next;
            if moved < 1e-14 {
                break;
            }
        }
        at
    }

    /// Length of an edge by its coordinate, times the thickness or the circle; shape functions and
    /// place there.
    pub(crate) fn measured(
        &self,
        x: &[[f64; 3]],
        coordinate: f64,
    ) -> (f64, [f64; MOST_NODES], [f64; 3]) {
        let here = self.at([coordinate, 0.0]);
        let [along, _] = tangents(&here, x);
        let length = along.iter().map(|x| x * x).sum::<f64>().sqrt();
        let across = match self {
            Self::Edge { thickness, .. } => *thickness,
            Self::Ring { .. } => 2.0 * std::f64::consts::PI * radius(&here, x),
            Self::Area(..) => 1.0,
        };
        (length * across, here.shapes, place(&here, x))
    }

    /// Shape functions and slopes at coordinates of the face.
    pub(crate) fn at(&self, [a, b]: [f64; 2]) -> At {
        match self {
            Self::Edge { nodes, .. } | Self::Ring { nodes } => edge_at(*nodes, a, 1.0),
            Self::Area(cell, _) => area_at(cell, &[a, b, 0.0], 1.0),
        }
    }

    /// The nearest coordinates that belong to the face.
    fn kept(&self, [a, b]: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Area(cell, _) if matches!(cell.nodes, 3 | 6) => {
                if a + b <= 1.0 {
                    return [a.clamp(0.0, 1.0), b.clamp(0.0, 1.0)];
                }
                let along = (0.5 * (a - b + 1.0)).clamp(0.0, 1.0);
                [along, 1.0 - along]
            }
            _ => [a.clamp(-1.0, 1.0), b.clamp(-1.0, 1.0)],
        }
    }
}

fn area_at(cell: &Cell, place: &[f64; 3], weight: f64) -> At {
    let (mut shapes, mut slopes) = ([0.0; MOST_NODES], [[0.0; 3]; MOST_NODES]);
    (cell.shapes)(place, &mut shapes[..cell.nodes]);
    (cell.slopes)(place, &mut slopes[..cell.nodes]);
    At { weight, shapes, slopes: slopes.map(|[a, b, _]| [a, b]) }
}

fn edge_at(nodes: usize, xi: f64, weight: f64) -> At {
    let (mut shapes, mut slopes) = ([0.0; MOST_NODES], [[0.0; 2]; MOST_NODES]);
    let (own, along) = match nodes {
        2 => ([0.5 * (1.0 - xi), 0.5 * (1.0 + xi), 0.0], [-0.5, 0.5, 0.0]),
        _ => (line3_shapes(xi), line3_slopes(xi)),
    };
    for k in 0..nodes {
        (shapes[k], slopes[k][0]) = (own[k], along[k]);
    }
    At { weight, shapes, slopes }
}

/// Slopes of the position by the coordinates of the face.
pub(crate) fn tangents(at: &At, x: &[[f64; 3]]) -> [[f64; 3]; 2] {
    let mut tangents = [[0.0; 3]; 2];
    for (x, slope) in x.iter().zip(at.slopes) {
        for (tangent, slope) in tangents.iter_mut().zip(slope) {
            tangent.iter_mut().zip(x).for_each(|(t, x)| *t += slope * x);
        }
    }
    tangents
}

/// A point of the rule of as many points as the edge has nodes.
fn edge_point(nodes: usize, point: usize, thickness: f64) -> At {
    let gauss: &[(f64, f64)] = match nodes {
        2 => &[(-GAUSS_2, 1.0), (GAUSS_2, 1.0)],
        _ => &[(-GAUSS_3, 5.0 / 9.0), (0.0, 8.0 / 9.0), (GAUSS_3, 5.0 / 9.0)],
    };
    let (xi, weight) = gauss[point];
    edge_at(nodes, xi, weight * thickness)
}

#[cfg(test)]
mod tests;
