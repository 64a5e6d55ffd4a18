//! One change of volume for all points (Q1P0): displacements as they are, pressure constant.
//!
//! ```text
//!    4-------3
//!    | x   x |    x: integration points; each feels its own change of shape,
//!    |   p   |    p: all of them feel one change of volume, the mean of the element
//!    | x   x |
//!    1-------2
//! ```
//!
//! The material sees F' = ((1 + m)/(1 + j))^(1/3) F with m = sum w j / V: docs/theory.md eqs.
//! (3.33) and (3.48) to (3.50). One pressure an element does not lock where the material is next to
//! incompressible.

use super::{Place, Point, Solids};
use crate::material::tensor::{
    Matrix, Symmetric, UNIT, add_dyad, add_pair, add_unit, dilation, trace,
};

/// What joins all nodes through the mean dilation.
pub(super) struct Coupling<const D: usize, const N: usize> {
    /// Derivatives of ln(1 + m) by the displacements, axis by axis.
    mean: [[f64; N]; D],
    /// Derivatives of the even stress.
    even: [[f64; N]; D],
    /// What the square of the first one takes.
    square: f64,
}

impl<const D: usize, const N: usize, const P: usize> Solids<D, N, P> {
    /// All points, their stresses those that do work on displacements.
    pub(super) fn with_mean_dilation(
        &self,
        places: &[Place<D, N>; P],
        large: bool,
        (committed, state): (&[f64], &mut [f64]),
    ) -> ([Point<D, N>; P], Coupling<D, N>) {
        let own = places.map(|place| {
            let h = &place.gradient;
            if large { dilation(h) } else { h[0][0] + h[1][1] + h[2][2] }
        });
        let volume: f64 = places.iter().map(|place| place.weight).sum();
        let mean = places.iter().zip(own).map(|(place, j)| place.weight * j).sum::<f64>() / volume;
        let width = self.point_states();
        let mut points = std::array::from_fn(|k| {
            let mut gradient = with_dilation(&places[k].gradient, [own[k], mean], large);
            let own_state = state.get_mut(width * k..width * (k + 1)).unwrap_or_default();
            let answer =
                self.ask(&mut gradient, &places[k], self.of_point(committed, k), own_state);
            Point::new(&places[k], &places[k].gradient, large, &answer)
        });
        let grown = if large { 1.0 + mean } else { 1.0 };
        let pressure = points.iter().map(|p| p.weight * trace(&p.stress) / 3.0).sum::<f64>()
            / (volume * grown);
        let coupling = couple(&mut points, [pressure, volume * grown], large);
        (points, coupling)
    }
}

/// H of the deformation whose dilation is replaced by the mean one.
fn with_dilation(h: &Matrix, [own, mean]: [f64; 2], large: bool) -> Matrix {
    let (even, growth) = if large {
        let even = ((mean.ln_1p() - own.ln_1p()) / 3.0).exp_m1();
        (even, 1.0 + even)
    } else {
        ((mean - own) / 3.0, 1.0)
    };
    std::array::from_fn(|i| {
        std::array::from_fn(|j| growth * h[i][j] + if i == j { even } else { 0.0 })
    })
}

/// Makes stresses and moduli those of the gradients of displacements: docs/theory.md eq. (3.49).
fn couple<const D: usize, const N: usize>(
    points: &mut [Point<D, N>],
    [pressure, volume]: [f64; 2],
    large: bool,
) -> Coupling<D, N> {
    let mut coupling = Coupling { mean: [[0.0; N]; D], even: [[0.0; N]; D], square: 0.0 };
    for point in points {
        let j = if large { 1.0 + point.dilation } else { 1.0 };
        let own = trace(&point.stress) / 3.0;
        let twice = if large { 2.0 } else { 0.0 };
        let row: Symmetric = std::array::from_fn(|k| {
            point.moduli[0][k] + point.moduli[1][k] + point.moduli[2][k] + twice * point.stress[k]
        });
        let sum = trace(&row);
        let (own_turning, mean_turning) = if large { (own, j * pressure) } else { (0.0, 0.0) };
        let moduli = &mut point.moduli;
        add_pair(moduli, -1.0 / 3.0, &UNIT, &row);
        add_dyad(moduli, sum / 9.0 + mean_turning, &UNIT);
        add_unit(moduli, 2.0 * (own_turning - mean_turning));
        (0..3).for_each(|k| point.stress[k] += j * pressure - own);
        if large {
            point.turning = point.stress;
        }
        let weight = point.weight;
        let even: Symmetric =
            std::array::from_fn(|k| weight / 3.0 * (row[k] - if k < 3 { sum / 3.0 } else { 0.0 }));
        point.add_rows(&UNIT.map(|unit| weight * j / volume * unit), &mut coupling.mean);
        point.add_rows(&even, &mut coupling.even);
        coupling.square += weight * (sum / 9.0 - own_turning);
    }
    coupling
}

impl<const D: usize, const N: usize> Point<D, N> {
    /// Adds the work of a stress on the displacements of every node.
    fn add_rows(&self, stress: &Symmetric, rows: &mut [[f64; N]; D]) {
        use crate::material::tensor::INDEX;
        for (i, row) in rows.iter_mut().enumerate() {
            for (j, slopes) in self.slopes.iter().enumerate() {
                let factor = stress[INDEX[i][j]];
                row.iter_mut().zip(slopes).for_each(|(sum, slope)| *sum += factor * slope);
            }
        }
        if D == 2 {
            rows[0].iter_mut().zip(&self.hoop).for_each(|(sum, hoop)| *sum += stress[2] * hoop);
        }
    }
}

impl<const D: usize, const N: usize> Coupling<D, N> {
    /// Adds e r' + r e' + square e e' to the tangent: docs/theory.md eq. (3.50).
    pub fn add_tangent(&self, tangent: &mut [f64]) {
        let mut rows = tangent.chunks_exact_mut(D * N);
        for a in 0..N {
            for i in 0..D {
                let Some(row) = rows.next() else { return };
                let (mean, even) =
                    (self.mean[i][a], self.even[i][a] + self.square * self.mean[i][a]);
                for (b, node) in row.chunks_exact_mut(D).enumerate() {
                    for (k, entry) in node.iter_mut().enumerate() {
                        *entry += mean * self.even[k][b] + even * self.mean[k][b];
                    }
                }
            }
        }
    }
}
