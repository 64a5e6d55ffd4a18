//! Force, tangent and energy of an element: its points, what its formulation makes of them, and
//! their sums.

use super::gather;
use super::place;
use super::point::{Point, States, energy};
use super::pressures::turn_by;
use super::recipe::Formulation;
use super::solids::Solids;
use crate::element::kernel::{Failure, Response, Surroundings};

impl<const D: usize, const N: usize, const P: usize> Solids<D, N, P> {
    /// Writes all points, with what the formulation makes of them; what joins all nodes beside
    /// them.
    #[inline(always)]
    pub(super) fn points(
        &self,
        element: usize,
        q: &[f64],
        (under, committed, state): States<'_, '_>,
        points: &mut [Point<D, N>; P],
    ) -> Result<Option<gather::Joints<D, N>>, Failure> {
        let apart = place::apart(q);
        let places = &self.places[element];
        if self.recipe.formulation.has_fields() {
            let mut gradients = [[[0.0; 3]; 3]; P];
            for (k, (place, gradient)) in places.iter().zip(&mut gradients).enumerate() {
                *gradient = self.gradient([element, k], place, (q, &apart));
            }
            let states = (under, committed, state);
            return self.with_dilation(element, &gradients, states, points).map(Some);
        }
        for (k, (place, point)) in places.iter().zip(points).enumerate() {
            let gradient = self.gradient([element, k], place, (q, &apart));
            self.answer([element, k], (place, &gradient), (under, committed, &mut *state), point)?;
        }
        Ok(None)
    }

    /// Force, tangent, trial state and energy.
    #[inline(always)]
    fn evaluate(&self, task: Task<'_>) -> Result<f64, Failure> {
        let Task { element, q, committed, under, into } = task;
        let Response { force, mut tangent, state } = into;
        let mut points = [Point::<D, N>::EMPTY; P];
        if self.recipe.formulation == Formulation::Incompatible {
            let into = Response { force, tangent, state };
            return self.with_modes(element, q, (committed, under), (&mut points, into));
        }
        let joints = self.points(element, q, (under, committed, state), &mut points)?;
        gather::force(&points, force);
        if let Some(tangent) = tangent.as_deref_mut() {
            if let Some(estimates) = self.estimated(under) {
                turn_by(&mut points, &self.at_points(element, estimates));
            }
            let joints = joints.as_ref().map_or(&[][..], gather::Joints::each);
            gather::tangent(&points, self.is_ring(), joints, tangent);
        }
        let mut held = 0.0;
        if self.recipe.formulation.is_one_point() {
            held = self.hold_modes(element, (q, under), (force, tangent));
        }
        Ok(energy(&points) + held)
    }
}

/// What an element is asked.
pub(super) struct Task<'a> {
    pub element: usize,
    pub q: &'a [f64],
    pub committed: &'a [f64],
    pub under: &'a Surroundings<'a>,
    pub into: Response<'a>,
}

/// An evaluation in the widest vector instructions that the processor has: wider ones change no
/// bit, for every sum keeps its order.
pub(super) struct Widened<'a, const D: usize, const N: usize, const P: usize>(
    pub &'a Solids<D, N, P>,
    pub Task<'a>,
);

impl<const D: usize, const N: usize, const P: usize> pulp::WithSimd for Widened<'_, D, N, P> {
    type Output = Result<f64, Failure>;

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) -> Self::Output {
        self.0.evaluate(self.1)
    }
}
