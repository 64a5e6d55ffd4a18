//! Solids as the solver sees them.

use super::evaluate::{Task, Widened};
use super::pressures::{After, WidenedAfter};
use super::results::{Asked, WidenedResults};
use super::solids::Solids;
use crate::element::kernel::{Failure, Kernel, Response, Scale, Surroundings};

impl<const D: usize, const N: usize, const P: usize> Kernel for Solids<D, N, P> {
    fn count(&self) -> usize {
        self.elements.len()
    }

    fn variables(&self) -> usize {
        D * N
    }

    fn respond(
        &self,
        element: usize,
        q: &[f64],
        committed: &[f64],
        under: &Surroundings<'_>,
        into: Response<'_>,
    ) -> Result<f64, Failure> {
        let task = Task { element, q, committed, under, into };
        pulp::Arch::new().dispatch(Widened(self, task))
    }

    fn estimate_size(&self) -> usize {
        self.pressures()
    }

    fn estimates(&self) -> bool {
        self.estimates_pressures()
    }

    fn stresses_after(
        &self,
        element: usize,
        q: &[f64],
        change: &[f64],
        under: &Surroundings<'_>,
        into: &mut [f64],
    ) {
        let task = After { element, q, change, under, into };
        pulp::Arch::new().dispatch(WidenedAfter(self, task));
    }

    fn tighten(&self, element: usize, reach: f64, stresses: &mut [f64]) {
        self.raise(element, reach, stresses);
    }

    fn scale(&self, element: usize) -> Scale {
        let places = &self.places[element];
        let volume: f64 = places.iter().map(|place| place.weight).sum();
        let content: f64 = places.iter().map(|place| place.content).sum();
        let length = content.powf(1.0 / D as f64);
        let stiffness = self.recipe.material.stiffest() * volume / (length * length);
        Scale { stiffness, length: Some(length) }
    }

    fn dissipated(
        &self,
        element: usize,
        q: &[f64],
        state: &[f64],
        under: &Surroundings<'_>,
    ) -> f64 {
        if !self.recipe.material.dissipates() {
            return 0.0;
        }
        let points = self.committed_points(element, (q, state), under);
        let points = points.iter().flatten();
        points.map(|point| point.weight * point.dissipation).sum()
    }

    fn creep_difference(&self, _element: usize, state: &[f64]) -> f64 {
        let own = |point| self.recipe.material.creep_difference(self.of_point(state, point));
        (0..P).filter_map(own).fold(0.0, f64::max)
    }

    fn results(
        &self,
        element: usize,
        q: &[f64],
        state: &[f64],
        under: &Surroundings<'_>,
        into: &mut [f64],
    ) {
        let asked = Asked { element, q, state, under, into };
        pulp::Arch::new().dispatch(WidenedResults(self, asked));
    }
}
