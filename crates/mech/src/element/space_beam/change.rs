//! Force and tangent of a beam in space: gathered from its points by turns about fixed axes, then
//! handed to rotation vectors.
//!
//! ```text
//!   turns theta:    m, K            rotation vectors phi:   T' m,  T' K T + sym d(T' m)/dphi
//! ```
//! docs/theory.md eq. (3.76).

use super::posture::{Posture, reference_node};
use super::station::{MOST, VARIABLES};
use crate::rotation;

/// What an element answers, by displacements and turns of its nodes.
#[derive(Clone, Debug)]
pub(super) struct Change {
    /// Strain energy [F L].
    pub energy: f64,
    /// Force [F], moment [F L] of every node.
    pub force: [f64; MOST],
    /// The same of the stresses that the geometric stiffness is made of.
    carried: [f64; MOST],
    tangent: [[f64; MOST]; MOST],
}

impl Default for Change {
    fn default() -> Self {
        let none = [0.0; MOST];
        Self { energy: 0.0, force: none, carried: none, tangent: [none; MOST] }
    }
}

impl Change {
    /// Adds length rates' pull.
    pub fn add_force(
        &mut self,
        length: f64,
        pull: &[f64; VARIABLES],
        rates: &[[f64; MOST]; VARIABLES],
        width: usize,
    ) {
        add(length, pull, rates, &mut self.force[..width]);
    }

    /// The same to what the geometric stiffness is made of.
    pub fn add_carried(
        &mut self,
        length: f64,
        pull: &[f64; VARIABLES],
        rates: &[[f64; MOST]; VARIABLES],
        width: usize,
    ) {
        add(length, pull, rates, &mut self.carried[..width]);
    }

    /// Adds length rates' stiffness rates.
    pub fn stiffen<const V: usize>(
        &mut self,
        length: f64,
        rates: &[[f64; MOST]; V],
        stiffness: &[[f64; V]; V],
        width: usize,
    ) {
        for (row, rate) in stiffness.iter().zip(rates) {
            let mut across = [0.0; MOST];
            for (entry, rate) in row.iter().zip(rates) {
                (0..width).for_each(|j| across[j] += length * entry * rate[j]);
            }
            for (i, by) in rate.iter().enumerate().take(width).filter(|(_, by)| **by != 0.0) {
                (0..width).for_each(|j| self.tangent[i][j] += by * across[j]);
            }
        }
    }

    /// Adds the second derivatives of the turns psi of all nodes against the reference node, times
    /// what each `carried`.
    pub fn stiffen_by_relative<const N: usize>(
        &mut self,
        carried: &[[f64; 3]; N],
        posture: &Posture<N>,
    ) {
        let reference = 6 * reference_node(N) + 3;
        for (a, carried) in carried.iter().enumerate().filter(|(a, _)| *a != reference_node(N)) {
            let place = |k: usize| if k < 3 { reference + k } else { 6 * a + k };
            for (part, weight) in posture.relative[a].iter().zip(carried) {
                for i in 0..6 {
                    for j in 0..6 {
                        self.tangent[place(i)][place(j)] += weight * part.hessian[i][j];
                    }
                }
            }
        }
    }

    /// From turns about fixed axes to the rotation vectors of the nodes.
    pub fn take_rotation_vectors<const N: usize>(&mut self, posture: &Posture<N>, stiffen: bool) {
        let moment = |of: &[f64; MOST], a: usize| [of[6 * a + 3], of[6 * a + 4], of[6 * a + 5]];
        if stiffen {
            for row in &mut self.tangent[..6 * N] {
                spin_back(row, posture);
            }
            // the same on the rows: T' K
            for j in 0..6 * N {
                let mut column: [f64; MOST] = std::array::from_fn(|i| self.tangent[i][j]);
                spin_back(&mut column, posture);
                (0..6 * N).for_each(|i| self.tangent[i][j] = column[i]);
            }
            for (a, vector) in posture.vectors.iter().enumerate() {
                let slopes = rotation::along_vector_slopes(*vector, moment(&self.carried, a));
                for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
                    self.tangent[6 * a + 3 + i][6 * a + 3 + j] +=
                        0.5 * (slopes[i][j] + slopes[j][i]);
                }
            }
        }
        spin_back(&mut self.force, posture);
    }

    /// Writes force and tangent of so many dofs.
    pub fn write(&self, width: usize, force: &mut [f64], tangent: Option<&mut [f64]>) {
        force.copy_from_slice(&self.force[..width]);
        let Some(tangent) = tangent else { return };
        for (into, row) in tangent.chunks_exact_mut(width).zip(&self.tangent) {
            into.copy_from_slice(&row[..width]);
        }
    }
}

fn add(length: f64, pull: &[f64; VARIABLES], rates: &[[f64; MOST]; VARIABLES], into: &mut [f64]) {
    for (pull, rate) in pull.iter().zip(rates) {
        into.iter_mut().zip(rate).for_each(|(sum, by)| *sum += length * pull * by);
    }
}

/// T' m of every node, in place.
fn spin_back<const N: usize>(list: &mut [f64; MOST], posture: &Posture<N>) {
    for (node, spin) in list.as_chunks_mut::<6>().0.iter_mut().zip(&posture.spins) {
        let moment = [node[3], node[4], node[5]];
        (0..3).for_each(|j| node[3 + j] = (0..3).map(|i| spin[i][j] * moment[i]).sum());
    }
}

/// T dphi of every node, in place.
pub(super) fn spin<const N: usize>(list: &mut [f64; MOST], posture: &Posture<N>) {
    for (node, spin) in list.as_chunks_mut::<6>().0.iter_mut().zip(&posture.spins) {
        let change = [node[3], node[4], node[5]];
        (0..3).for_each(|i| node[3 + i] = (0..3).map(|j| spin[i][j] * change[j]).sum());
    }
}
