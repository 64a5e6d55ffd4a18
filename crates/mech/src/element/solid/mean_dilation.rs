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

use super::gather::Joint;
use super::point::{Point, States};
use super::solids::Solids;
use crate::element::kernel::Failure;
use crate::material::tensor::{COUNTS, INDEX, Matrix, Moduli, Symmetric, trace};

impl<const D: usize, const N: usize, const P: usize> Solids<D, N, P> {
    /// Writes all points, their stresses those that do work on displacements.
    #[inline(always)]
    pub(super) fn with_mean_dilation(
        &self,
        element: usize,
        gradients: &[Matrix; P],
        (under, committed, state): States<'_, '_>,
        points: &mut [Point<D, N>; P],
    ) -> Result<Joint<D, N>, Failure> {
        let large = under.is_large();
        let places = &self.places[element];
        for (k, (point, place)) in points.iter_mut().zip(places).enumerate() {
            self.deform([element, k], (place, &gradients[k]), large, point)?;
        }
        let volume: f64 = places.iter().map(|place| place.weight).sum();
        let mean = points.iter().map(|point| point.weight * point.dilation).sum::<f64>() / volume;
        for (k, point) in points.iter_mut().enumerate() {
            let mut gradient = with_dilation(&gradients[k], [point.dilation, mean], large);
            let answer =
                self.ask(&mut gradient, ([element, k], under), (committed, &mut *state))?;
            point.take(&answer, large);
        }
        let grown = if large { 1.0 + mean } else { 1.0 };
        let pressure = points.iter().map(|p| p.weight * trace(&p.stress) / 3.0).sum::<f64>()
            / (volume * grown);
        Ok(couple(points, [pressure, volume * grown], large))
    }
}

/// H of the deformation whose dilation is replaced by the mean one.
#[inline(always)]
fn with_dilation(h: &Matrix, [own, mean]: [f64; 2], large: bool) -> Matrix {
    let (even, growth) = if large {
        let even = cube_root((mean - own) / (1.0 + own));
        (even, 1.0 + even)
    } else {
        ((mean - own) / 3.0, 1.0)
    };
    let mut with = *h;
    for (i, row) in with.iter_mut().enumerate() {
        row.iter_mut().for_each(|entry| *entry *= growth);
        row[i] += even;
    }
    with
}

/// (1 + x)^(1/3) - 1 with all its digits: one correction of Newton's method for e^3 + 3 e^2 + 3 e
/// = x.
#[inline(always)]
fn cube_root(x: f64) -> f64 {
    let root = (1.0 + x).cbrt();
    let e = root - 1.0;
    e - (e * (3.0 + e * (3.0 + e)) - x) / (3.0 * root * root)
}

/// Makes stresses and moduli those of the gradients of displacements, docs/theory.md eq. (3.49),
/// and what joins all nodes, eq. (3.50): e r' + r e' + square e e'.
#[inline(always)]
fn couple<const D: usize, const N: usize>(
    points: &mut [Point<D, N>],
    [pressure, volume]: [f64; 2],
    large: bool,
) -> Joint<D, N> {
    let mut joint = Joint { left: [[0.0; N]; D], right: [[0.0; N]; D], square: 0.0, volume };
    let mut square = 0.0;
    for point in points {
        let j = if large { 1.0 + point.dilation } else { 1.0 };
        let own = trace(&point.stress) / 3.0;
        let twice = if large { 2.0 } else { 0.0 };
        let mut row = [0.0; 6];
        for (k, entry) in row.iter_mut().enumerate() {
            let moduli = &point.moduli;
            *entry = moduli[0][k] + moduli[1][k] + moduli[2][k] + twice * point.stress[k];
        }
        let sum = trace(&row);
        let (own_turning, mean_turning) = if large { (own, j * pressure) } else { (0.0, 0.0) };
        add_even(&mut point.moduli, &row, sum / 9.0 + mean_turning);
        for (k, row) in point.moduli.iter_mut().enumerate() {
            row[k] += 2.0 * (own_turning - mean_turning) / COUNTS[k];
        }
        (0..3).for_each(|k| point.stress[k] += j * pressure - own);
        if large {
            point.turning = point.stress;
        }
        let weight = point.weight;
        point.add_even_rows(weight * j / volume, &mut joint.left);
        let mut even = row;
        (0..3).for_each(|k| even[k] -= sum / 3.0);
        even.iter_mut().for_each(|entry| *entry *= weight / 3.0);
        point.add_rows(&even, &mut joint.right);
        square += weight * (sum / 9.0 - own_turning);
    }
    for (right, left) in joint.right.iter_mut().zip(&joint.left) {
        right.iter_mut().zip(left).for_each(|(r, e)| *r += 0.5 * square * e);
    }
    joint.square = square;
    joint
}

/// moduli += even 1 1 - (1 row + row 1)/3.
#[inline(always)]
fn add_even(moduli: &mut Moduli, row: &Symmetric, even: f64) {
    for k in 0..6 {
        moduli.iter_mut().take(3).for_each(|own| own[k] -= row[k] / 3.0);
        moduli[k].iter_mut().take(3).for_each(|own| *own -= row[k] / 3.0);
    }
    (0..3).for_each(|i| (0..3).for_each(|k| moduli[i][k] += even));
}

impl<const D: usize, const N: usize> Point<D, N> {
    /// Adds the work of a stress on the displacements of every node.
    #[inline(always)]
    pub(super) fn add_rows(&self, stress: &Symmetric, rows: &mut [[f64; N]; D]) {
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

    /// The same of the same stress in all directions.
    #[inline(always)]
    pub(super) fn add_even_rows(&self, stress: f64, rows: &mut [[f64; N]; D]) {
        for (row, slopes) in rows.iter_mut().zip(&self.slopes) {
            row.iter_mut().zip(slopes).for_each(|(sum, slope)| *sum += stress * slope);
        }
        if D == 2 {
            rows[0].iter_mut().zip(&self.hoop).for_each(|(sum, hoop)| *sum += stress * hoop);
        }
    }
}
