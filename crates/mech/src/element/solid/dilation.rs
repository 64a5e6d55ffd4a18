//! Changes of volume that few fields make for all points: displacements as they are.
//!
//! ```text
//!    4-------3
//!    | x   x |    x: integration points; each feels its own change of shape,
//!    |   p   |    p: all of them feel one change of volume, the mean of the element (Q1P0),
//!    | x   x |       or one that is linear in position (quadratic hybrid elements)
//!    1-------2
//! ```
//!
//! The material sees F' = ((1 + m)/(1 + j))^(1/3) F with m the part of j that the fields make:
//! docs/theory.md eqs. (3.33) and (3.48) to (3.50). So few pressures an element do not lock where the
//! material is next to incompressible.

use super::fields::{self, MOST_FIELDS};
use super::gather::Joints;
use super::point::{Point, States};
use super::solids::Solids;
use crate::element::kernel::Failure;
use crate::material::tensor::{COUNTS, INDEX, Matrix, Moduli, Symmetric, trace};

impl<const D: usize, const N: usize, const P: usize> Solids<D, N, P> {
    /// The fields of an element's changes of volume beside the constant one.
    #[inline(always)]
    pub(super) fn straight_fields(&self, element: usize) -> &[[f64; P]] {
        self.fields.get(element).map_or(&[], |fields| &fields[..])
    }

    /// Writes all points, their stresses those that do work on displacements.
    #[inline(always)]
    pub(super) fn with_dilation(
        &self,
        element: usize,
        gradients: &[Matrix; P],
        (under, committed, state): States<'_, '_>,
        points: &mut [Point<D, N>; P],
    ) -> Result<Joints<D, N>, Failure> {
        let large = under.is_large();
        let places = &self.places[element];
        for (k, (point, place)) in points.iter_mut().zip(places).enumerate() {
            self.deform([element, k], (place, &gradients[k]), large, point)?;
        }
        let straight = self.straight_fields(element);
        let shares = fields::shares(places);
        let made = |of: &[f64; P]| fields::values(&fields::parts(&shares, of, straight), straight);
        let dilations = made(&std::array::from_fn(|k| points[k].dilation));
        let grown = dilations.map(|m| if large { 1.0 + m } else { 1.0 });
        if let Some(flat) = grown.iter().position(|&grown| grown.is_nan() || grown <= 0.0) {
            return Err(Failure::InsideOut(flat));
        }
        for (k, point) in points.iter_mut().enumerate() {
            let mut gradient = with_dilation(&gradients[k], [point.dilation, dilations[k]], large);
            let answer =
                self.ask(&mut gradient, ([element, k], under), (committed, &mut *state))?;
            point.take(&answer, large);
        }
        let pressures = made(&std::array::from_fn(|k| trace(&points[k].stress) / 3.0 / grown[k]));
        let volume = places.iter().map(|place| place.weight).sum();
        let mut joints = Joints::new(volume, 1 + straight.len());
        for (k, point) in points.iter_mut().enumerate() {
            let mut fields = [1.0; MOST_FIELDS];
            fields[1..].iter_mut().zip(straight).for_each(|(own, field)| *own = field[k]);
            couple(point, ([pressures[k], grown[k]], large), &fields, &mut joints);
        }
        joints.close();
        Ok(joints)
    }
}

/// H of the deformation whose dilation is replaced.
#[inline(always)]
fn with_dilation(h: &Matrix, [own, other]: [f64; 2], large: bool) -> Matrix {
    let (even, growth) = if large {
        let even = cube_root((other - own) / (1.0 + own));
        (even, 1.0 + even)
    } else {
        ((other - own) / 3.0, 1.0)
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

/// Makes stress and moduli of a point those of the gradients of displacements, docs/theory.md eq.
/// (3.49), and adds its part of what joins all nodes, eq. (3.50).
#[inline(always)]
fn couple<const D: usize, const N: usize>(
    point: &mut Point<D, N>,
    ([pressure, grown], large): ([f64; 2], bool),
    fields: &[f64; MOST_FIELDS],
    joints: &mut Joints<D, N>,
) {
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
    let weight = point.weight / grown;
    let mut even = row;
    (0..3).for_each(|k| even[k] -= sum / 3.0);
    even.iter_mut().for_each(|entry| *entry *= weight / 3.0);
    let square = weight / grown * (sum / 9.0 - own_turning);
    let share = point.weight * j / joints.volume;
    for (joint, own) in joints.each_mut().iter_mut().zip(fields) {
        point.add_even_rows(share * own, &mut joint.left);
        point.add_rows(&even.map(|entry| own * entry), &mut joint.right);
        joint.square.iter_mut().zip(fields).for_each(|(sum, other)| *sum += square * own * other);
    }
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
