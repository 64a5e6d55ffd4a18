//! Results of a solid: stresses, strains and energies at its points.

use super::point::Point;
use super::recipe::Formulation;
use super::solids::Solids;
use super::told::Told;
use crate::axes;
use crate::element::kernel::Surroundings;
use crate::material::Axes;
use crate::material::tensor::{Matrix, Symmetric, carried, deformation, full, left, product};
use crate::orientation;

/// Components along axes of a strain whose shear components are angles.
fn angles_along(axes: &axes::Axes, strain: &Symmetric) -> Symmetric {
    let halved = |factor: f64| {
        move |tensor: Symmetric| -> Symmetric {
            std::array::from_fn(|k| if k < 3 { tensor[k] } else { factor * tensor[k] })
        }
    };
    halved(2.0)(carried(axes, &halved(0.5)(*strain)))
}

/// Axes that turn with the material: R of the polar decomposition F = V R takes them along.
fn taken_along(axes: &axes::Axes, gradient: &Matrix) -> axes::Axes {
    let principal = Axes::of(&left(gradient));
    let shrink = full(&principal.tensor(&principal.logs.map(|log| (-log).exp())));
    let turn = product(&shrink, &deformation(gradient));
    axes.map(|axis| std::array::from_fn(|i| (0..3).map(|j| turn[i][j] * axis[j]).sum()))
}

impl<const D: usize, const N: usize, const P: usize> Solids<D, N, P> {
    /// All points of a committed state, which answers its own strains with the same stresses;
    /// `None` where it has no answer.
    #[inline(always)]
    pub(super) fn committed_points(
        &self,
        element: usize,
        (q, state): (&[f64], &[f64]),
        under: &Surroundings<'_>,
    ) -> Option<[Point<D, N>; P]> {
        let mut scratch = state.to_vec();
        let mut points = [Point::<D, N>::EMPTY; P];
        let states = (under, state, &mut scratch[..]);
        let answered = match self.recipe.formulation {
            Formulation::Incompatible => self.enhanced_points(element, q, states, &mut points),
            _ => self.points(element, q, states, &mut points).map(|_| ()),
        };
        answered.ok().map(|()| points)
    }

    /// At every point: Cauchy stress [F/L2], strain [1], both 11, 22, 33, 12 in the plane and 13, 23
    /// behind them in space, equivalent plastic strain and equivalent creep strain (CalculiX: their
    /// sum twice) [1], stored energy and energy taken by flow of a unit of undeformed volume [F/L2];
    /// then the same two energies [F L] and the volume [L3] of the element, current (Abaqus) or
    /// undeformed (CalculiX).
    #[inline(always)]
    pub(super) fn write_results(
        &self,
        element: usize,
        (q, state): (&[f64], &[f64]),
        under: &Surroundings<'_>,
        into: &mut [f64],
    ) {
        let large = under.is_large();
        let Some(points) = self.committed_points(element, (q, state), under) else {
            into.fill(f64::NAN);
            return;
        };
        let width = if D == 2 { 4 } else { 6 };
        let Some((stresses, rest)) = into.split_at_mut_checked(width * P) else { return };
        let Some((strains, rest)) = rest.split_at_mut_checked(width * P) else { return };
        let Some((plastic, rest)) = rest.split_at_mut_checked(P) else { return };
        let Some((creep, rest)) = rest.split_at_mut_checked(P) else { return };
        let Some((stored, rest)) = rest.split_at_mut_checked(P) else { return };
        let Some((dissipated, whole)) = rest.split_at_mut_checked(P) else { return };
        let mut sums = [0.0; 3];
        for (k, point) in points.iter().enumerate() {
            let volume = if large { 1.0 + point.dilation } else { 1.0 };
            let mut stress = point.stress.map(|stress| stress / volume);
            let mut strain = self.recipe.told.strain(&point.gradient, large);
            let axes = self.axes([element, k]);
            if let Some(axes) = axes.filter(|_| self.recipe.told == Told::Logarithmic) {
                let turned = if large { taken_along(&axes, &point.gradient) } else { axes };
                stress = orientation::along(&turned, &stress);
                strain = angles_along(&turned, &strain);
            }
            stresses[width * k..width * (k + 1)].copy_from_slice(&stress[..width]);
            strains[width * k..width * (k + 1)].copy_from_slice(&strain[..width]);
            let own = self.of_point(state, k);
            [plastic[k], creep[k]] = self.recipe.told.flowed(&self.recipe.material, own);
            stored[k] = point.energy - point.dissipation;
            dissipated[k] = point.dissipation;
            let content = if self.recipe.told == Told::Logarithmic { volume } else { 1.0 };
            let own = [stored[k], dissipated[k], content];
            sums.iter_mut().zip(own).for_each(|(sum, own)| *sum += point.weight * own);
        }
        whole.iter_mut().zip(sums).for_each(|(entry, sum)| *entry = sum);
    }
}

/// What results are asked of.
pub(super) struct Asked<'a> {
    pub element: usize,
    pub q: &'a [f64],
    pub state: &'a [f64],
    pub under: &'a Surroundings<'a>,
    pub into: &'a mut [f64],
}

/// Results in the widest vector instructions that the processor has, as forces are.
pub(super) struct WidenedResults<'a, const D: usize, const N: usize, const P: usize>(
    pub &'a Solids<D, N, P>,
    pub Asked<'a>,
);

impl<const D: usize, const N: usize, const P: usize> pulp::WithSimd
    for WidenedResults<'_, D, N, P>
{
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) {
        let Asked { element, q, state, under, into } = self.1;
        self.0.write_results(element, (q, state), under, into);
    }
}
