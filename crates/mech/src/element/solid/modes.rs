//! Hourglass modes: what one point does not see.
//!
//! ```text
//!    \_______/     u = h alpha, h = xi eta at the corners: no strain at the centre,
//!     |  x  |      held by its energy of bending and twist, along axes that turn with the element
//!    /-------\     gamma = (h - (h.X) grad N)/N: what it measures is no homogeneous strain and
//!                  no turn, at whatever displacement
//! ```
//!
//! The modes are those of [flanagan1981]; their stiffness is that of elastic bending of a block with
//! the element's sides, docs/theory.md eqs. (3.54), (3.118).

use super::bending::{Amounts, Bending, MODES};
use super::place::{self, Place};
use super::recipe::{Formulation, Kinematics};
use super::solids::Solids;
use super::turned::{Held, SIZE};
use crate::element::cell::Cell;
use crate::element::kernel::Surroundings;
use crate::vector::scale;

/// Products of coordinates that are no linear function, in the plane and in space; the first three are known by
/// [`Bending`].
const PRODUCTS: [[usize; 3]; MODES] = [[1, 1, 0], [0, 1, 1], [1, 0, 1], [1, 1, 1]];

/// Stiffness of the hourglass control of CalculiX, over E V sum (dN/dX)^2 [1]: measured with ccx
/// 2.20, any proportions and Poisson's ratio.
const SOFT: f64 = 0.032;

/// Value of a mode at a corner of the reference cell.
fn value(mode: [usize; 3], at: &[f64; 3]) -> f64 {
    (0..3).map(|axis| if mode[axis] == 1 { at[axis] } else { 1.0 }).product()
}

/// Number of modes of a cell: one of a quadrilateral, four of a hexahedron.
fn count(cell: &Cell) -> usize {
    if cell.dimension == 2 { 1 } else { MODES }
}

/// What a node counts in the gradient of displacements, axis by axis [1/L], and in the amounts of the modes [1].
type Counts = [f64; SIZE];

impl<const D: usize, const N: usize, const P: usize> Solids<D, N, P> {
    /// Adds force and tangent of the hourglass control, returns its energy [F L].
    pub(super) fn hold_modes(
        &self,
        element: usize,
        (q, under): (&[f64], &Surroundings<'_>),
        (force, tangent): (&mut [f64], Option<&mut [f64]>),
    ) -> f64 {
        let place = &self.places[element][0];
        let counts = self.counts(element, place);
        let apart = place::apart::<D, N>(q);
        let mut amounts: Amounts = [[0.0; 3]; MODES];
        for (axis, apart) in apart.iter().enumerate() {
            for (counts, u) in counts.iter().zip(apart) {
                for (amount, count) in amounts.iter_mut().zip(&counts[3..]) {
                    amount[axis] += count * u;
                }
            }
        }
        let bending = self.bending(element, place);
        let held = match under.is_large() {
            true => Held::turned(bending, &place.gradient(&apart), amounts),
            false => Held::still(bending, amounts),
        };
        let slopes = held.slopes();
        for (force, counts) in force.chunks_exact_mut(D).zip(&counts) {
            for (force, slopes) in force.iter_mut().zip(&slopes) {
                *force +=
                    counts.iter().zip(slopes).map(|(count, slope)| count * slope).sum::<f64>();
            }
        }
        if let Some(tangent) = tangent {
            let used = 3 + count(self.recipe.cell);
            (0..D).for_each(|axis| add_columns::<D, N>((&held, &counts), (axis, used), tangent));
        }
        held.energy()
    }

    /// What every node counts.
    fn counts(&self, element: usize, place: &Place<D, N>) -> [Counts; N] {
        let (cell, nodes) = (self.recipe.cell, &self.elements[element]);
        let mut counts = [[0.0; SIZE]; N];
        for (axis, slopes) in place.slopes.iter().enumerate() {
            counts.iter_mut().zip(slopes).for_each(|(counts, slope)| counts[axis] = *slope);
        }
        for (number, &mode) in PRODUCTS.iter().enumerate().take(count(cell)) {
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
            counts.iter_mut().zip(gamma).for_each(|(counts, gamma)| counts[3 + number] = gamma);
        }
        counts
    }

    /// The stiffness of the modes.
    fn bending(&self, element: usize, place: &Place<D, N>) -> Bending {
        let material = &self.recipe.material;
        let elastic = material.elastic();
        let modulus = elastic.map_or(2.6 * material.shear_modulus(), |own| own.modulus);
        let poisson = elastic.map_or(0.3, |own| own.poisson);
        if self.recipe.formulation == Formulation::SoftHourglass {
            let squares: f64 = place.slopes.iter().flatten().map(|slope| slope * slope).sum();
            return Bending::even(SOFT * modulus * place.weight * squares);
        }
        let (cell, nodes) = (self.recipe.cell, &self.elements[element]);
        let sides = std::array::from_fn(|k| {
            let mut side = [0.0; 3];
            for (node, at) in nodes.iter().zip(cell.places) {
                for (axis, x) in node.iter().enumerate() {
                    side[axis] += at[k] * (x - nodes[0][axis]);
                }
            }
            scale(side, 1.0 / N as f64)
        });
        let whole = modulus * place.weight;
        match self.recipe.kinematics {
            Kinematics::PlaneStress => Bending::in_plane(sides, whole),
            Kinematics::Space => Bending::in_space(sides, whole, poisson),
            Kinematics::PlaneStrain | Kinematics::Axisymmetric => {
                Bending::in_plane(sides, whole / (1.0 - poisson * poisson))
            }
        }
    }
}

/// Adds the columns of the displacements along an axis to a tangent; so many of what a node counts are used.
fn add_columns<const D: usize, const N: usize>(
    (held, counts): (&Held, &[Counts; N]),
    (axis, used): (usize, usize),
    tangent: &mut [f64],
) {
    let curvatures: [_; SIZE] = std::array::from_fn(|number| match number < used {
        true => held.change_of_slopes(axis, number),
        false => [[0.0; SIZE]; 3],
    });
    for (b, of_column) in counts.iter().enumerate() {
        let mut change = [[0.0; SIZE]; 3];
        for (curvature, count) in curvatures.iter().zip(of_column) {
            for (sum, row) in change.iter_mut().flatten().zip(curvature.iter().flatten()) {
                *sum += count * row;
            }
        }
        for (a, of_row) in counts.iter().enumerate() {
            for (i, change) in change.iter().enumerate().take(D) {
                let own: f64 = of_row.iter().zip(change).map(|(count, slope)| count * slope).sum();
                tangent[D * N * (D * a + i) + D * b + axis] += own;
            }
        }
    }
}
