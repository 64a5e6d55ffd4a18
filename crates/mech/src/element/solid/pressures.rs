//! Pressures of rubber that the iteration estimates apart from its changes of volume.
//!
//! ```text
//!   a step moves the nodes along straight lines: it leaves a change of volume of second order,
//!   and what is next to incompressible answers that with a pressure as high as anything
//!
//!     force:                                    pressure of the law
//!     how forces turn and areas change with q:  pressure where the last linear solution arrived
//! ```
//!
//! docs/theory.md section 3.5, "Pressures of their own". [derived]

use super::fields;
use super::point::Point;
use super::recipe::{Formulation, Kinematics};
use super::solids::Solids;
use crate::element::kernel::{Strains, Surroundings};
use crate::element::mixed::{SLIGHT_STIFFNESS, SLIGHT_STRAIN};
use crate::material::Rubber;
use crate::material::tensor::{COUNTS, trace};

impl<const D: usize, const N: usize, const P: usize> Solids<D, N, P> {
    /// Number of pressures of an element: one a field of changes of volume, or one a point.
    pub(super) fn pressures(&self) -> usize {
        match (self.recipe.formulation, self.recipe.kinematics) {
            (_, Kinematics::PlaneStress) => 0,
            (Formulation::MeanDilation, _) => 1,
            (Formulation::LinearDilation, _) => 1 + D,
            (Formulation::Plain, _) => P,
            _ => 0,
        }
    }

    /// Whether they are estimated: of rubber whose stresses follow strains alone.
    pub(super) fn estimates_pressures(&self) -> bool {
        let material = &self.recipe.material;
        let rubber = material.rubber(0.0, |_| ()).is_some();
        rubber && material.states() == 0 && self.pressures() > 0
    }

    /// The estimates of an element; `None`: pressures are those of the law.
    #[inline(always)]
    pub(super) fn estimated<'a>(&self, under: &Surroundings<'a>) -> Option<&'a [f64]> {
        match under.strains {
            Strains::Mixed(own) if own.len() == self.pressures() => {
                (self.estimates_pressures()).then_some(own)
            }
            _ => None,
        }
    }

    /// Writes the pressures that a linear solution with the change `change` of `q` arrives at.
    #[inline(always)]
    pub(super) fn pressures_after(&self, task: After<'_>) {
        let After { element, q, change, under, into } = task;
        into.fill(0.0);
        if into.len() != self.pressures() || !self.estimates_pressures() {
            return;
        }
        let mut points = [Point::<D, N>::EMPTY; P];
        let Ok(joints) = self.points(element, q, (under, &[], &mut []), &mut points) else {
            return;
        };
        let along = |rows: &[[f64; N]; D]| along(rows, change);
        if let Some(joints) = joints {
            let shares = fields::shares(&self.places[element]);
            let pressures = std::array::from_fn(|k| pressure(&points[k]));
            let parts = fields::parts(&shares, &pressures, self.straight_fields(element));
            for (a, joint) in joints.each().iter().enumerate() {
                let halves = joints.each().iter().zip(&joint.square);
                let half: f64 = halves.map(|(other, s)| 0.5 * s * along(&other.left)).sum();
                into[a] = parts[a] + (along(&joint.right) + half) / joints.volume;
            }
            return;
        }
        for (point, own) in points.iter().zip(into) {
            let mut row = [0.0; 6];
            for (k, entry) in row.iter_mut().enumerate() {
                let moduli = &point.moduli;
                *entry = moduli[0][k] + moduli[1][k] + moduli[2][k] + 2.0 * point.stress[k];
            }
            let (mut work, mut even) = ([[0.0; N]; D], [[0.0; N]; D]);
            point.add_rows(&row, &mut work);
            point.add_even_rows(trace(&point.stress), &mut even);
            *own = pressure(point) + (along(&work) - along(&even)) / (3.0 * (1.0 + point.dilation));
        }
    }
}

impl<const D: usize, const N: usize, const P: usize> Solids<D, N, P> {
    /// Raises pressures that are next to none, in a model of size `reach` [L], to a slight tension: a
    /// body that nothing holds and nothing presses is not turned by an arbitrary angle.
    pub(super) fn raise(&self, element: usize, reach: f64, pressures: &mut [f64]) {
        if !self.estimates_pressures() {
            return;
        }
        let material = &self.recipe.material;
        let content: f64 = self.places[element].iter().map(|place| place.content).sum();
        let size = content.powf(1.0 / D as f64) / reach;
        let shear = material.rubber(0.0, Rubber::shear_modulus).unwrap_or(0.0);
        let least =
            (SLIGHT_STRAIN * material.stiffest()).min(SLIGHT_STIFFNESS * shear * size * size);
        // of fields the constant one alone: the others have no mean
        let means = if self.recipe.formulation.has_fields() { 1 } else { P };
        for own in pressures.iter_mut().take(means).filter(|own| own.abs() < least) {
            *own = least;
        }
    }

    /// Estimated pressures, at the points.
    #[inline(always)]
    pub(super) fn at_points(&self, element: usize, estimates: &[f64]) -> [f64; P] {
        if self.recipe.formulation.has_fields() {
            return fields::values(estimates, self.straight_fields(element));
        }
        std::array::from_fn(|k| estimates.get(k).copied().unwrap_or(0.0))
    }
}

/// What the pressures of an element are made of.
pub(super) struct After<'a> {
    pub element: usize,
    pub q: &'a [f64],
    pub change: &'a [f64],
    pub under: &'a Surroundings<'a>,
    pub into: &'a mut [f64],
}

/// The same in the widest vector instructions of the processor.
pub(super) struct WidenedAfter<'a, const D: usize, const N: usize, const P: usize>(
    pub &'a Solids<D, N, P>,
    pub After<'a>,
);

impl<const D: usize, const N: usize, const P: usize> pulp::WithSimd for WidenedAfter<'_, D, N, P> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) {
        self.0.pressures_after(self.1);
    }
}

/// Lets areas and normals change as under these pressures.
#[inline(always)]
pub(super) fn turn_by<const D: usize, const N: usize, const P: usize>(
    points: &mut [Point<D, N>; P],
    estimates: &[f64; P],
) {
    for (point, estimate) in points.iter_mut().zip(estimates) {
        let beyond = (1.0 + point.dilation) * (estimate - pressure(point));
        for i in 0..3 {
            point.turning[i] += beyond;
            (0..3).for_each(|j| point.moduli[i][j] += beyond);
        }
        for (i, row) in point.moduli.iter_mut().enumerate() {
            row[i] -= 2.0 * beyond / COUNTS[i];
        }
    }
}

/// Mean stress per deformed area, positive in tension.
#[inline(always)]
fn pressure<const D: usize, const N: usize>(point: &Point<D, N>) -> f64 {
    trace(&point.stress) / (3.0 * (1.0 + point.dilation))
}

/// The rows of all nodes on their change.
#[inline(always)]
fn along<const D: usize, const N: usize>(rows: &[[f64; N]; D], change: &[f64]) -> f64 {
    let axis = |i: usize| rows[i].iter().zip(change.iter().skip(i).step_by(D));
    (0..D).flat_map(axis).map(|(row, moved)| row * moved).sum()
}
