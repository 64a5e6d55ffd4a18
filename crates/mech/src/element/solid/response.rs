//! How a point of an element answers: gradient, answer of the material, slopes by deformed position.

use super::place::{Apart, Place, carried_back, invert};
use super::plane_stress;
use super::point::{Point, States};
use super::recipe::Kinematics;
use super::solids::Solids;
use crate::element::heated::weighted;
use crate::element::kernel::{Failure, Surroundings};
use crate::material::tensor::Matrix;
use crate::material::{Answer, Conditions};
use crate::orientation::Oriented;

impl<const D: usize, const N: usize, const P: usize> Solids<D, N, P> {
    /// Shape functions at a point, the second number, or their means where it stands for the whole
    /// ring.
    #[inline(always)]
    fn shapes(&self, [element, point]: [usize; 2]) -> &[f64; N] {
        self.means.get(element).unwrap_or(&self.tables.points[point].shapes)
    }

    /// H at a point whose slopes by undeformed position are those of `place`.
    #[inline(always)]
    pub(super) fn gradient(
        &self,
        point: [usize; 2],
        place: &Place<D, N>,
        (q, apart): (&[f64], &Apart<D, N>),
    ) -> Matrix {
        let mut gradient = place.gradient(apart);
        if self.is_ring() {
            let nodes = q.chunks_exact(D).zip(self.shapes(point));
            gradient[2][2] = nodes.map(|(u, shape)| u[0] * shape).sum::<f64>() / place.radius;
        }
        gradient
    }

    /// What the material answers under at a point.
    #[inline(always)]
    fn conditions(&self, point: usize, under: &Surroundings<'_>) -> Conditions {
        let [temperature, initial] = [under.temperatures, under.initial]
            .map(|nodes| weighted(&self.heat[point], nodes).value);
        Conditions { large: under.is_large(), temperature, initial, clock: under.clock }
    }

    /// Asks the material, or solves for the strain across the plane first.
    #[inline(always)]
    pub(super) fn ask(
        &self,
        gradient: &mut Matrix,
        ([element, point], under): ([usize; 2], &Surroundings<'_>),
        (committed, state): (&[f64], &mut [f64]),
    ) -> Result<Answer, Failure> {
        let width = self.point_states();
        let committed = self.of_point(committed, point);
        let state = state.get_mut(width * point..width * (point + 1)).unwrap_or_default();
        let under = &self.conditions(point, under);
        let material =
            Oriented { material: &self.recipe.material, axes: self.axes([element, point]) };
        if self.recipe.kinematics == Kinematics::PlaneStress {
            plane_stress::ask(&material, gradient, under, (committed, state))
                .ok_or(Failure::NoThickness(point))
        } else {
            Ok(material.respond(gradient, under, committed, state))
        }
    }

    /// Writes place, gradient and slopes of a point.
    ///
    /// # Errors
    /// The point is turned inside out, or has come to the axis.
    #[inline(always)]
    pub(super) fn deform(
        &self,
        [element, point]: [usize; 2],
        (place, gradient): (&Place<D, N>, &Matrix),
        large: bool,
        into: &mut Point<D, N>,
    ) -> Result<(), Failure> {
        into.weight = place.weight;
        into.gradient = *gradient;
        into.note_dilation(large);
        let mut radius = place.radius;
        if large {
            let hoop = 1.0 + gradient[2][2];
            if self.is_ring() && (hoop.is_nan() || hoop <= 0.0) {
                return Err(Failure::OnAxis(point));
            }
            let volume = 1.0 + into.dilation;
            if volume.is_nan() || volume <= 0.0 {
                return Err(Failure::InsideOut(point));
            }
            radius *= hoop;
            let mut f = [[0.0; D]; D];
            for (i, row) in f.iter_mut().enumerate() {
                row.copy_from_slice(&gradient[i][..D]);
                row[i] += 1.0;
            }
            into.slopes = carried_back(&place.slopes, &invert(&f).0);
        } else {
            into.slopes = place.slopes;
        }
        if self.is_ring() {
            let shapes = self.shapes([element, point]);
            into.hoop.iter_mut().zip(shapes).for_each(|(hoop, shape)| *hoop = shape / radius);
        }
        Ok(())
    }

    /// Writes a point that its own gradient moves.
    #[inline(always)]
    pub(super) fn answer(
        &self,
        [element, point]: [usize; 2],
        (place, gradient): (&Place<D, N>, &Matrix),
        (under, committed, state): States<'_, '_>,
        into: &mut Point<D, N>,
    ) -> Result<(), Failure> {
        let large = under.is_large();
        self.deform([element, point], (place, gradient), large, into)?;
        let answer = self.ask(&mut into.gradient, ([element, point], under), (committed, state))?;
        if self.recipe.kinematics == Kinematics::PlaneStress {
            into.note_dilation(large);
        }
        into.take(&answer, large);
        Ok(())
    }
}
