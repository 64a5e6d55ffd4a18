//! Plane strain with the mean dilation (Q1P0): displacements bilinear, pressure constant.
//!
//! ```text
//!    4-------3
//!    | x   x |    x: integration points; each feels its own change of shape,
//!    |   p   |    p: all of them feel one change of volume, the mean of the element
//!    | x   x |
//!    1-------2
//! ```
//!
//! W = sum_g w_g W(s_g, j_g, m) with m = sum_g w_g j_g / V: docs/theory.md section 3.4. One
//! pressure an element does not lock where the material is next to incompressible.

mod response;

use super::cell::QUAD4;
use super::quadrature::QUAD_4;
use crate::differentiate::Real;
use crate::material::{Elastic, PlaneInvariants, PlaneStrainLaw};

/// What an integration point knows of the undeformed element.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Point<const NODES: usize> {
    /// Undeformed volume it stands for [L3].
    weight: f64,
    /// Derivatives of the shape functions by undeformed position [1/L].
    slopes: [[f64; 2]; NODES],
}

/// A plane element of `NODES` nodes and `POINTS` integration points whose pressure is that of its
/// mean dilation; `L` is its law at large strain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeanDilation<L, const NODES: usize, const POINTS: usize> {
    law: L,
    elastic: Elastic,
    /// Whether shear strains are told as angles where strains are small.
    engineering: bool,
    thickness: f64,
    points: [Point<NODES>; POINTS],
    volume: f64,
}

/// Four nodes, 2 x 2 points: CPE4.
pub type Quad4<L> = MeanDilation<L, 4, 4>;

impl<L> Quad4<L> {
    /// The quadrilateral on four undeformed positions [L], counter-clockwise; check them with
    /// [`runs_around`]. `law` at large strain is that of `elastic`; `thickness` out of the plane
    /// [L].
    pub fn quad4(
        corners: &[[f64; 2]; 4],
        thickness: f64,
        (law, elastic, engineering): (L, Elastic, bool),
    ) -> Self {
        let points = std::array::from_fn(|point| {
            let (slopes, area) = at_point(corners, &quad4_slopes(&QUAD_4.points[point]));
            Point { weight: area * thickness, slopes }
        });
        let volume = points.iter().map(|point| point.weight).sum();
        Self { law, elastic, engineering, thickness, points, volume }
    }
}

/// Whether the integration points of the quadrilateral on four positions [L] all have a positive
/// area: corners counter-clockwise, none far re-entrant.
pub fn runs_around(corners: &[[f64; 2]; 4]) -> bool {
    QUAD_4.points.iter().all(|place| at_point(corners, &quad4_slopes(place)).1 > 0.0)
}

fn quad4_slopes(place: &[f64; 3]) -> [[f64; 2]; 4] {
    let mut slopes = [[0.0; 3]; 4];
    (QUAD4.slopes)(place, &mut slopes);
    slopes.map(|[x, y, _]| [x, y])
}

/// Derivatives by undeformed position of functions given by their slopes on the reference cell,
/// and the ratio of areas det dX/dxi: docs/theory.md eq. (3.31).
fn at_point<const NODES: usize>(
    nodes: &[[f64; 2]; NODES],
    by_xi: &[[f64; 2]; NODES],
) -> ([[f64; 2]; NODES], f64) {
    // Slopes sum to zero: differences keep the digits of elements far from the origin.
    let mut map = [[0.0; 2]; 2];
    for (node, by_xi) in nodes.iter().zip(by_xi) {
        for i in 0..2 {
            for k in 0..2 {
                map[i][k] += (node[i] - nodes[0][i]) * by_xi[k];
            }
        }
    }
    let area = map[0][0] * map[1][1] - map[0][1] * map[1][0];
    let inverse = if area == 0.0 { 0.0 } else { 1.0 / area };
    let slopes = by_xi.map(|[a, b]| {
        [(map[1][1] * a - map[1][0] * b) * inverse, (map[0][0] * b - map[0][1] * a) * inverse]
    });
    (slopes, area)
}

impl<const NODES: usize> Point<NODES> {
    /// H = du/dX at displacements q = (ux, uy) of the nodes.
    fn gradient<R: Real>(&self, q: &[R]) -> [[R; 2]; 2] {
        let mut h = [[R::from_f64(0.0); 2]; 2];
        let (origin, _) = q.split_at(2);
        for (slopes, u) in self.slopes.iter().zip(q.chunks_exact(2)) {
            for i in 0..2 {
                for k in 0..2 {
                    // slopes sum to zero
                    h[i][k] = h[i][k] + (u[i] - origin[i]) * R::from_f64(slopes[k]);
                }
            }
        }
        h
    }
}

/// Invariants of a point for small displacements: those of eq. (3.32) without products.
fn small<R: Real>(h: &[[R; 2]; 2]) -> PlaneInvariants<R> {
    let (a, b) = (h[0][0] - h[1][1], h[0][1] + h[1][0]);
    let dilation = h[0][0] + h[1][1];
    PlaneInvariants { shear: a * a + b * b, dilation, mean: dilation }
}

impl<L: PlaneStrainLaw, const NODES: usize, const POINTS: usize> MeanDilation<L, NODES, POINTS> {
    /// Strain energy [F L] at any displacement of the nodes, (ux, uy) each [L]: docs/theory.md
    /// eq. (3.33).
    pub fn energy<R: Real>(&self, q: &[R]) -> R {
        self.energy_of(&self.law, crate::material::invariants, q)
    }

    fn energy_of<R: Real>(
        &self,
        law: &impl PlaneStrainLaw,
        invariants: impl Fn(&[[R; 2]; 2]) -> PlaneInvariants<R>,
        q: &[R],
    ) -> R {
        let at = self.points.map(|point| invariants(&point.gradient(q)));
        let sum = |of: &dyn Fn(&PlaneInvariants<R>) -> R| {
            self.points
                .iter()
                .zip(&at)
                .fold(R::from_f64(0.0), |sum, (point, at)| sum + R::from_f64(point.weight) * of(at))
        };
        let mean = sum(&|at| at.dilation) * R::from_f64(1.0 / self.volume);
        sum(&|at| law.energy(&PlaneInvariants { mean, ..*at }))
    }
}
