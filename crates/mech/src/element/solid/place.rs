//! A point of the undeformed element, and how it deforms.

use super::{Kinematics, Recipe};
use crate::axes::Axes;
use crate::element::cell::Cell;
use crate::element::quadrature::Quadrature;
use crate::material::Conditions;
use crate::material::tensor::Matrix;

/// Shape functions of a point of the reference cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reference<const D: usize, const N: usize> {
    /// Place on the reference cell.
    pub at: [f64; 3],
    /// Weight of the rule there.
    pub weight: f64,
    /// Shape functions.
    pub shapes: [f64; N],
    /// Derivatives by the coordinates of the cell, axis by axis.
    pub slopes: [[f64; N]; D],
}

impl<const D: usize, const N: usize> Reference<D, N> {
    /// Those of a cell at a place.
    pub fn new(cell: &Cell, at: &[f64; 3], weight: f64) -> Self {
        let (mut shapes, mut slopes) = ([0.0; N], [[0.0; 3]; N]);
        (cell.shapes)(at, &mut shapes);
        (cell.slopes)(at, &mut slopes);
        let slopes = std::array::from_fn(|axis| slopes.map(|slope| slope[axis]));
        Self { at: *at, weight, shapes, slopes }
    }
}

/// What all elements of a block share.
#[derive(Debug, Clone)]
pub(super) struct Tables<const D: usize, const N: usize, const P: usize> {
    pub points: [Reference<D, N>; P],
    pub centre: Reference<D, N>,
    /// Where gradients are averaged, if a point stands for the mean of its element.
    pub fine: Vec<Reference<D, N>>,
}

impl<const D: usize, const N: usize, const P: usize> Tables<D, N, P> {
    pub fn new(cell: &Cell, rule: &Quadrature, fine: Option<&Quadrature>) -> Self {
        let point = |k: usize| {
            let at = rule.points.get(k).unwrap_or(&[0.0; 3]);
            Reference::new(cell, at, rule.weights.get(k).copied().unwrap_or(0.0))
        };
        let mut middle = [0.0; 3];
        for at in cell.places {
            (0..3).for_each(|axis| middle[axis] += at[axis] / cell.places.len() as f64);
        }
        let fine = fine.into_iter().flat_map(|rule| rule.points.iter().zip(rule.weights));
        let fine = fine.map(|(at, weight)| Reference::new(cell, at, *weight)).collect();
        let centre = Reference::new(cell, &middle, 1.0);
        Self { points: std::array::from_fn(point), centre, fine }
    }
}

/// A point of an undeformed element.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place<const D: usize, const N: usize> {
    /// Undeformed volume it stands for [L3].
    pub weight: f64,
    /// Length, area or volume of the cell it stands for [L^D].
    pub content: f64,
    /// Derivatives of the shape functions by undeformed position, axis by axis [1/L].
    pub slopes: [[f64; N]; D],
    /// Shape functions over the undeformed radius; zeros but for rings [1/L].
    pub over_radius: [f64; N],
    /// Derivatives of the cell's coordinates by undeformed position [1/L].
    pub inverse: [[f64; D]; D],
    /// H = du/dX.
    pub gradient: Matrix,
    /// What the material answers under.
    pub conditions: Conditions,
    /// Its axes; `None`: those of the model.
    pub axes: Option<Axes>,
}

impl<const D: usize, const N: usize> Place<D, N> {
    /// Before any displacement: docs/theory.md eq. (3.31).
    pub fn new(nodes: &[[f64; D]; N], at: &Reference<D, N>, recipe: &Recipe) -> Self {
        // Slopes sum to zero: differences keep the digits of elements far from the origin.
        let apart = nodes
            .map(|node| -> [f64; D] { std::array::from_fn(|axis| node[axis] - nodes[0][axis]) });
        let mut map = [[0.0; D]; D];
        for (k, slopes) in at.slopes.iter().enumerate() {
            for (apart, slope) in apart.iter().zip(slopes) {
                for (row, apart) in map.iter_mut().zip(apart) {
                    row[k] += apart * slope;
                }
            }
        }
        let (inverse, content) = invert(&map);
        let mut slopes = [[0.0; N]; D];
        for (axis, slopes) in slopes.iter_mut().enumerate() {
            for (k, by_cell) in at.slopes.iter().enumerate() {
                for (slope, by) in slopes.iter_mut().zip(by_cell) {
                    *slope += by * inverse[k][axis];
                }
            }
        }
        let content = content * at.weight;
        let (across, over_radius) = match recipe.kinematics {
            Kinematics::PlaneStrain | Kinematics::PlaneStress => (recipe.thickness, [0.0; N]),
            Kinematics::Space => (1.0, [0.0; N]),
            Kinematics::Axisymmetric => {
                let radius: f64 =
                    at.shapes.iter().zip(nodes).map(|(shape, node)| shape * node[0]).sum();
                (2.0 * std::f64::consts::PI * radius, at.shapes.map(|shape| shape / radius))
            }
        };
        let gradient = [[0.0; 3]; 3];
        let weight = content * across;
        let conditions = Conditions::default();
        Self { weight, content, slopes, over_radius, inverse, gradient, conditions, axes: None }
    }

    /// The mean of an element: its volume, and gradients averaged over it, so that homogeneous
    /// deformations have exact forces whatever the shape.
    pub fn mean(nodes: &[[f64; D]; N], fine: &[Reference<D, N>], recipe: &Recipe) -> Option<Self> {
        let places = || fine.iter().map(|at| Self::new(nodes, at, recipe));
        let volume: f64 = places().map(|place| place.weight).sum();
        let mut mean: Option<Self> = None;
        for place in places() {
            let part = place.weight / volume;
            let Some(mean) = &mut mean else {
                let slopes = place.slopes.map(|row| row.map(|slope| part * slope));
                mean = Some(Self { weight: volume, content: volume, slopes, ..place });
                continue;
            };
            for (sum, row) in mean.slopes.iter_mut().zip(&place.slopes) {
                sum.iter_mut().zip(row).for_each(|(sum, slope)| *sum += part * slope);
            }
        }
        mean
    }

    /// Takes in displacements, node by node [L].
    pub fn follow(&mut self, q: &[f64]) {
        let (nodes, _) = q.as_chunks::<D>();
        let Some(first) = nodes.first() else { return };
        for (a, u) in nodes.iter().enumerate().take(N) {
            for i in 0..D {
                // slopes sum to zero
                let apart = u[i] - first[i];
                for (entry, slopes) in self.gradient[i].iter_mut().zip(&self.slopes) {
                    *entry += apart * slopes[a];
                }
            }
            self.gradient[2][2] += if D == 2 { self.over_radius[a] * u[0] } else { 0.0 };
        }
    }

    /// Derivatives by deformed position, and shape functions over the deformed radius.
    pub fn deformed(&self, gradient: &Matrix) -> ([[f64; N]; D], [f64; N]) {
        let f: [[f64; D]; D] = std::array::from_fn(|i| {
            std::array::from_fn(|j| gradient[i][j] + f64::from(u8::from(i == j)))
        });
        let (back, _) = invert(&f);
        let mut slopes = [[0.0; N]; D];
        for (axis, slopes) in slopes.iter_mut().enumerate() {
            for (k, undeformed) in self.slopes.iter().enumerate() {
                let turn = back[k][axis];
                for (slope, by) in slopes.iter_mut().zip(undeformed) {
                    *slope += by * turn;
                }
            }
        }
        let hoop = 1.0 + gradient[2][2];
        let over_radius =
            if D == 2 { self.over_radius.map(|shape| shape / hoop) } else { [0.0; N] };
        (slopes, over_radius)
    }
}

/// Inverse and determinant in two or three dimensions; zeros for a singular matrix.
pub(super) fn invert<const D: usize>(m: &[[f64; D]; D]) -> ([[f64; D]; D], f64) {
    let mut back = [[0.0; D]; D];
    let scaled = |det: f64| if det == 0.0 { 0.0 } else { 1.0 / det };
    if D == 2 {
        let det = m[0][0] * m[1][1] - m[0][1] * m[1][0];
        let scale = scaled(det);
        back[0] = std::array::from_fn(|j| if j == 0 { m[1][1] } else { -m[0][1] } * scale);
        back[1] = std::array::from_fn(|j| if j == 0 { -m[1][0] } else { m[0][0] } * scale);
        return (back, det);
    }
    let minor = |i: usize, j: usize| {
        let (a, b) = ((i + 1) % D, (i + 2) % D);
        let (c, d) = ((j + 1) % D, (j + 2) % D);
        m[a][c] * m[b][d] - m[a][d] * m[b][c]
    };
    let det = (0..D).map(|j| m[0][j] * minor(0, j)).sum();
    let scale = scaled(det);
    for (i, row) in back.iter_mut().enumerate() {
        row.iter_mut().enumerate().for_each(|(j, entry)| *entry = scale * minor(j, i));
    }
    (back, det)
}

/// Smallest ratio of contents det dX/dxi at the points of a rule, of an element on the positions of
/// its nodes [L^D]: positive for a sound one.
pub fn smallest_jacobian(cell: &Cell, rule: &Quadrature, nodes: &[[f64; 3]]) -> f64 {
    let mut smallest = f64::INFINITY;
    let mut slopes = vec![[0.0; 3]; cell.nodes];
    for at in rule.points {
        (cell.slopes)(at, &mut slopes);
        let mut map: Matrix = [[0.0; 3]; 3];
        for (node, slopes) in nodes.iter().zip(&slopes) {
            for i in 0..cell.dimension {
                for k in 0..cell.dimension {
                    map[i][k] += (node[i] - nodes[0][i]) * slopes[k];
                }
            }
        }
        (cell.dimension..3).for_each(|axis| map[axis][axis] = 1.0);
        smallest = smallest.min(crate::material::tensor::determinant(&map));
    }
    smallest
}
