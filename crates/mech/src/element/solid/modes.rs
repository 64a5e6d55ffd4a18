//! Hourglass modes: what one point does not see.
//!
//! ```text
//!    \_______/     u = h alpha, h = xi eta at the corners: no strain at the centre,
//!     |  x  |      held by energy k/2 alpha^2 per direction
//!    /-------\     gamma = (h - (h.X) grad N)/N: what it measures is no homogeneous strain and
//!                  no turn, at whatever displacement
//! ```
//!
//! The modes are those of [flanagan1981]; k is that of elastic bending of a block of the element's
//! size, docs/theory.md eq. (3.54).

use super::place::Place;
use super::recipe::Formulation;
use super::solids::Solids;
use crate::element::cell::Cell;

/// Products of coordinates that are no linear function, in the plane and in space.
const MODES: [[usize; 3]; 4] = [[1, 1, 0], [0, 1, 1], [1, 0, 1], [1, 1, 1]];

/// Stiffness of the hourglass control of CalculiX, over E V sum (dN/dX)^2 [1]: measured with ccx
/// 2.20, any proportions and Poisson's ratio.
const SOFT: f64 = 0.032;

/// Value of a mode at a corner of the reference cell.
fn value(mode: [usize; 3], at: &[f64; 3]) -> f64 {
    (0..3).map(|axis| if mode[axis] == 1 { at[axis] } else { 1.0 }).product()
}

/// The modes of a cell: one of a quadrilateral, four of a hexahedron.
fn modes(cell: &Cell) -> &'static [[usize; 3]] {
    if cell.dimension == 2 { &MODES[..1] } else { &MODES }
}

impl<const D: usize, const N: usize, const P: usize> Solids<D, N, P> {
    /// Adds force and tangent of the hourglass control, returns its energy [F L].
    pub(super) fn hold_modes(
        &self,
        element: usize,
        q: &[f64],
        (force, mut tangent): (&mut [f64], Option<&mut [f64]>),
    ) -> f64 {
        let (cell, nodes) = (self.recipe.cell, &self.elements[element]);
        let place = &self.places[element][0];
        let stiffness = self.hourglass_stiffness(place);
        let mut energy = 0.0;
        for &mode in modes(cell) {
            let own: [f64; N] =
                std::array::from_fn(|a| cell.places.get(a).map_or(0.0, |at| value(mode, at)));
            let mut gamma = own.map(|h| h / N as f64);
            for axis in 0..D {
                let slant: f64 =
                    own.iter().zip(nodes).map(|(h, x)| h * (x[axis] - nodes[0][axis])).sum();
                for (gamma, slope) in gamma.iter_mut().zip(&place.slopes[axis]) {
                    *gamma -= slant / N as f64 * slope;
                }
            }
            for i in 0..D {
                let nodal = q.chunks_exact(D).zip(&gamma);
                let amount: f64 = nodal.map(|(u, gamma)| gamma * (u[i] - q[i])).sum();
                energy += 0.5 * stiffness * amount * amount;
                for (force, gamma) in force.chunks_exact_mut(D).zip(&gamma) {
                    force[i] += stiffness * amount * gamma;
                }
            }
            if let Some(tangent) = tangent.as_deref_mut() {
                add_tangent::<D, N>(&gamma, stiffness, tangent);
            }
        }
        energy
    }

    /// E V (N / D) sum (dN/dX)^2 / 3: docs/theory.md eq. (3.54).
    fn hourglass_stiffness(&self, place: &Place<D, N>) -> f64 {
        let material = &self.recipe.material;
        let modulus = material.elastic().map_or(2.6 * material.shear_modulus(), |e| e.modulus);
        let squares: f64 = place.slopes.iter().flatten().map(|slope| slope * slope).sum();
        let part = match self.recipe.formulation {
            Formulation::SoftHourglass => SOFT,
            _ => N as f64 / (3.0 * D as f64),
        };
        part * modulus * place.weight * squares
    }
}

fn add_tangent<const D: usize, const N: usize>(
    gamma: &[f64; N],
    stiffness: f64,
    tangent: &mut [f64],
) {
    for (a, left) in gamma.iter().enumerate() {
        for (b, right) in gamma.iter().enumerate() {
            for i in 0..D {
                tangent[D * N * (D * a + i) + D * b + i] += stiffness * left * right;
            }
        }
    }
}
