//! A point of the undeformed element, and how it deforms.

use super::recipe::{Kinematics, Recipe};
use crate::axes::Axes;
use crate::element::cell::Cell;
use crate::element::quadrature::Quadrature;
use crate::material::tensor::Matrix;
use crate::orientation::Orientation;

/// Strain that no digit of a deformation knows of: the square of its rounding [1]. Where an element
/// is carried along without strain, what is solved for in it goes to nothing, and this is all that
/// its changes can be held against.
pub(super) const NO_STRAIN: f64 = f64::EPSILON * f64::EPSILON;

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
    /// Undeformed distance from the axis; of no meaning but for rings [L].
    pub radius: f64,
}

/// Displacements of the nodes less those of the first one, axis by axis [L].
pub(super) type Apart<const D: usize, const N: usize> = [[f64; N]; D];

/// Those of an element's variables.
#[inline(always)]
pub(super) fn apart<const D: usize, const N: usize>(q: &[f64]) -> Apart<D, N> {
    let mut apart = [[0.0; N]; D];
    let (nodes, _) = q.as_chunks::<D>();
    let Some(first) = nodes.first() else { return apart };
    for (a, u) in nodes.iter().enumerate().take(N) {
        for i in 0..D {
            // slopes sum to zero: differences keep their digits
            apart[i][a] = u[i] - first[i];
        }
    }
    apart
}

/// Derivatives of the position by the coordinates of the cell [L].
fn coordinates<const D: usize, const N: usize>(
    nodes: &[[f64; D]; N],
    at: &Reference<D, N>,
) -> [[f64; D]; D] {
    // Slopes sum to zero: differences keep the digits of elements far from the origin.
    let apart =
        nodes.map(|node| -> [f64; D] { std::array::from_fn(|axis| node[axis] - nodes[0][axis]) });
    let mut map = [[0.0; D]; D];
    for (k, slopes) in at.slopes.iter().enumerate() {
        for (apart, slope) in apart.iter().zip(slopes) {
            for (row, apart) in map.iter_mut().zip(apart) {
                row[k] += apart * slope;
            }
        }
    }
    map
}

impl<const D: usize, const N: usize> Place<D, N> {
    /// Before any displacement, docs/theory.md eq. (3.31); with the derivatives of the cell's
    /// coordinates by position [1/L].
    pub fn new(
        nodes: &[[f64; D]; N],
        at: &Reference<D, N>,
        recipe: &Recipe,
    ) -> (Self, [[f64; D]; D]) {
        let (inverse, content) = invert(&coordinates(nodes, at));
        let slopes = carried_back(&at.slopes, &inverse);
        let content = content * at.weight;
        let (across, radius) = match recipe.kinematics {
            Kinematics::PlaneStrain | Kinematics::PlaneStress => (recipe.thickness, 1.0),
            Kinematics::Space => (1.0, 1.0),
            Kinematics::Axisymmetric => {
                let radius: f64 =
                    at.shapes.iter().zip(nodes).map(|(shape, node)| shape * node[0]).sum();
                (2.0 * std::f64::consts::PI * radius, radius)
            }
        };
        (Self { weight: content * across, content, slopes, radius }, inverse)
    }

    /// A point that stands for the whole element, with the means of the gradients at `fine`;
    /// `None`: there are none.
    pub fn mean(nodes: &[[f64; D]; N], fine: &[Reference<D, N>], recipe: &Recipe) -> Option<Self> {
        let places = || fine.iter().map(|at| Self::new(nodes, at, recipe).0);
        let mut mean = places().next()?;
        mean.weight = places().map(|place| place.weight).sum();
        mean.content = places().map(|place| place.content).sum();
        mean.radius = mean.weight / (2.0 * std::f64::consts::PI * mean.content);
        mean.slopes = [[0.0; N]; D];
        for place in places() {
            let part = place.weight / mean.weight;
            for (sum, row) in mean.slopes.iter_mut().zip(&place.slopes) {
                sum.iter_mut().zip(row).for_each(|(sum, slope)| *sum += part * slope);
            }
        }
        Some(mean)
    }

    /// H = du/dX of displacements; H33 is not among them.
    #[inline(always)]
    pub fn gradient(&self, apart: &Apart<D, N>) -> Matrix {
        let mut gradient = [[0.0; 3]; 3];
        for (row, u) in gradient.iter_mut().zip(apart) {
            for (entry, slopes) in row.iter_mut().zip(&self.slopes) {
                *entry = dot(u, slopes);
            }
        }
        gradient
    }
}

/// Means of the shape functions over the section of a ring: with the radius of [`Place::mean`] they
/// give the mean of the hoop strain over its volume.
pub(super) fn mean_shapes<const D: usize, const N: usize>(
    nodes: &[[f64; D]; N],
    fine: &[Reference<D, N>],
) -> [f64; N] {
    let area = |at: &Reference<D, N>| at.weight * invert(&coordinates(nodes, at)).1;
    let whole: f64 = fine.iter().map(area).sum();
    let mut mean = [0.0; N];
    for at in fine {
        let part = area(at) / whole;
        mean.iter_mut().zip(&at.shapes).for_each(|(mean, shape)| *mean += part * shape);
    }
    mean
}

/// Axes of the material at the points of an element, where it has any of its own.
pub(super) fn axes<const D: usize, const N: usize, const P: usize>(
    nodes: &[[f64; D]; N],
    tables: &Tables<D, N, P>,
    orientation: &Orientation,
) -> [Axes; P] {
    let at = |shapes: &[f64; N]| {
        let point = std::array::from_fn(|k| {
            nodes.iter().zip(shapes).map(|(node, shape)| shape * node[k]).sum()
        });
        orientation.at(nodes, point)
    };
    if tables.fine.is_empty() {
        return std::array::from_fn(|point| at(&tables.points[point].shapes));
    }
    let fine = &tables.fine;
    let mean = |a: usize| fine.iter().map(|at| at.shapes[a]).sum::<f64>() / fine.len() as f64;
    [at(&std::array::from_fn(mean)); P]
}

/// Sum of products, four sums at a time.
#[inline(always)]
fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    let ((a, rest_a), (b, rest_b)) = (a.as_chunks::<4>(), b.as_chunks::<4>());
    let mut sums = [0.0; 4];
    for (a, b) in a.iter().zip(b) {
        for (sum, (a, b)) in sums.iter_mut().zip(a.iter().zip(b)) {
            *sum += a * b;
        }
    }
    let rest: f64 = rest_a.iter().zip(rest_b).map(|(a, b)| a * b).sum();
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest
}

/// Derivatives by other coordinates, of which `by` holds those of the present ones.
#[inline(always)]
pub(super) fn carried_back<const D: usize, const N: usize>(
    slopes: &[[f64; N]; D],
    by: &[[f64; D]; D],
) -> [[f64; N]; D] {
    let mut carried = [[0.0; N]; D];
    for (axis, carried) in carried.iter_mut().enumerate() {
        for (k, slopes) in slopes.iter().enumerate() {
            let by = by[k][axis];
            carried.iter_mut().zip(slopes).for_each(|(sum, slope)| *sum += slope * by);
        }
    }
    carried
}

/// Inverse and determinant in two or three dimensions; zeros for a singular matrix.
#[inline(always)]
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
    let mut slopes = vec![[0.0; 3]; cell.nodes];
    let all = rule.points.iter().map(|at| jacobian(cell, at, nodes, &mut slopes));
    all.fold(f64::INFINITY, f64::min)
}

/// The node of a cell on which its volume is smallest or most turned inside out, for nodes at these
/// positions [L]; the first one of several.
pub fn worst_node(cell: &Cell, nodes: &[[f64; 3]]) -> usize {
    let mut slopes = vec![[0.0; 3]; cell.nodes];
    let all = cell.places.iter().map(|at| jacobian(cell, at, nodes, &mut slopes));
    all.enumerate().min_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(node, _)| node)
}

/// Volume of a cell by that of its reference cell at a place [L3, in the plane L2].
fn jacobian(cell: &Cell, at: &[f64; 3], nodes: &[[f64; 3]], slopes: &mut [[f64; 3]]) -> f64 {
    (cell.slopes)(at, slopes);
    let mut map: Matrix = [[0.0; 3]; 3];
    for (node, slopes) in nodes.iter().zip(slopes.iter()) {
        for i in 0..cell.dimension {
            for k in 0..cell.dimension {
                map[i][k] += (node[i] - nodes[0][i]) * slopes[k];
            }
        }
    }
    (cell.dimension..3).for_each(|axis| map[axis][axis] = 1.0);
    crate::material::tensor::determinant(&map)
}
