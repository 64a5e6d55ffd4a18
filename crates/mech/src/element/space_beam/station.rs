//! An integration point of a beam in space: its strains and what they do to the element.
//!
//! ```text
//!   w = sum N_a' u_a     psi = sum N_a psi_a     psi' = sum N_a' psi_a     R = R_r exp(psi)
//!   gamma = L' (R' (t + w) - t)                  kappa = L' T(psi)' psi'
//! ```
//! The axes L = (t, n1, n2) are those of the undeformed section. docs/theory.md eqs (3.71), (3.72).

use super::posture::{Posture, reference_node, small};
use crate::differentiate::{Real, Second};
use crate::rotation;

/// Strains of a section: axial [1], shear along n1 and n2 [1], twist [1/L], curvature about n1 and
/// n2 [1/L].
pub type Strains = [f64; 6];

/// Variables of a point: w, the turn of the reference node, psi, psi'.
pub(super) const VARIABLES: usize = 12;
/// Among them where psi begins.
pub(super) const PSI: usize = 6;

/// What an integration point knows of the undeformed element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Station<const N: usize> {
    /// Undeformed length it stands for [L].
    pub length: f64,
    /// Unit vectors along the tangent of the axis, n1 and n2.
    pub axes: [[f64; 3]; 3],
    /// Shape functions [1].
    pub shapes: [f64; N],
    /// Their derivatives by undeformed length [1/L].
    pub slopes: [f64; N],
}

/// The six strains at a point with their derivatives: by the first nine variables of the point, and
/// by the last six.
pub(super) struct Sensed {
    stretch: [Second<9>; 3],
    bend: [Second<6>; 3],
}

impl<const N: usize> Station<N> {
    /// sum slopes_a of_a, the slopes' sum being zero: differences keep the digits of elements that
    /// have moved far.
    pub fn slope(&self, of: impl Fn(usize) -> [f64; 3]) -> [f64; 3] {
        let first = of(0);
        let mut sum = [0.0; 3];
        for a in 1..N {
            let own = of(a);
            (0..3).for_each(|k| sum[k] += self.slopes[a] * (own[k] - first[k]));
        }
        sum
    }

    /// w, psi and psi' at the dofs `q`.
    fn motion(&self, q: &[f64], posture: &Posture<N>) -> [[f64; 3]; 3] {
        let moved = |a: usize| [q[6 * a], q[6 * a + 1], q[6 * a + 2]];
        let turned = |a: usize| posture.relative[a].map(|part| part.value);
        let mut psi = [0.0; 3];
        for a in 0..N {
            (0..3).for_each(|k| psi[k] += self.shapes[a] * turned(a)[k]);
        }
        [self.slope(moved), psi, self.slope(turned)]
    }

    /// Strains at the dofs `q` with their derivatives.
    pub fn sense(&self, q: &[f64], posture: &Posture<N>) -> Sensed {
        let [w, psi, bent] = self.motion(q, posture);
        Sensed { stretch: self.stretch(w, psi, posture), bend: self.bend(psi, bent) }
    }

    /// Axial and shear strains: gamma = L' (R' w + R' t - t), without a difference of near numbers.
    fn stretch(&self, w: [f64; 3], psi: [f64; 3], posture: &Posture<N>) -> [Second<9>; 3] {
        let at = [w[0], w[1], w[2], 0.0, 0.0, 0.0, psi[0], psi[1], psi[2]];
        let [x, y, z, a, b, c, d, e, f] = Second::<9>::variables(&at);
        let reference = posture.reference.map(Second::constant);
        let node = rotation::after(&small(&[a, b, c]), &reference);
        let section = rotation::after(&node, &rotation::quaternion(&[d, e, f]));
        let back = rotation::back(&section);
        let tangent = self.axes[0].map(Second::constant);
        let (along, turned) = (
            rotation::displacement_by(&back, &[x, y, z]),
            rotation::displacement_by(&back, &tangent),
        );
        let whole = [x + along[0] + turned[0], y + along[1] + turned[1], z + along[2] + turned[2]];
        self.in_section(whole)
    }

    /// Twist and curvatures: kappa = L' T(psi)' psi'.
    fn bend(&self, psi: [f64; 3], bent: [f64; 3]) -> [Second<6>; 3] {
        let [a, b, c] = psi;
        let [d, e, f] = bent;
        let [a, b, c, d, e, f] = Second::<6>::variables(&[a, b, c, d, e, f]);
        self.in_section(rotation::along_vector(&[a, b, c], &[d, e, f]))
    }

    /// Components along the axes of the section.
    fn in_section<R: Real>(&self, [x, y, z]: [R; 3]) -> [R; 3] {
        let number = R::from_f64;
        self.axes.map(|[a, b, c]| number(a) * x + number(b) * y + number(c) * z)
    }

    /// Strains of small displacements as a matrix: row by row, a column a dof of `q`; docs/theory.md
    /// eq. (3.77).
    pub fn linear(&self) -> [[f64; MOST]; 6] {
        let mut rows = [[0.0; MOST]; 6];
        for (i, axis) in self.axes.iter().enumerate() {
            let arm = rotation::cross(&self.axes[0], axis);
            for a in 0..N {
                for k in 0..3 {
                    rows[i][6 * a + k] = self.slopes[a] * axis[k];
                    // -axis . (theta x t)
                    rows[i][6 * a + 3 + k] = -self.shapes[a] * arm[k];
                    rows[3 + i][6 * a + 3 + k] = self.slopes[a] * axis[k];
                }
            }
        }
        rows
    }

    /// Derivatives of the variables of the point by displacement and turn of every node: row by
    /// row, a column a dof; docs/theory.md eq. (3.75).
    pub fn rates(&self, posture: &Posture<N>) -> [[f64; MOST]; VARIABLES] {
        let mut rows = [[0.0; MOST]; VARIABLES];
        let reference = 6 * reference_node(N) + 3;
        for k in 0..3 {
            rows[3 + k][reference + k] = 1.0;
            for a in 0..N {
                rows[k][6 * a + k] = self.slopes[a];
                let gradient = &posture.relative[a][k].gradient;
                for j in 0..3 {
                    for (row, by) in [(PSI + k, self.shapes[a]), (PSI + 3 + k, self.slopes[a])] {
                        rows[row][reference + j] += by * gradient[j];
                        rows[row][6 * a + 3 + j] += by * gradient[3 + j];
                    }
                }
            }
        }
        rows
    }
}

/// The most dofs of an element.
pub(super) const MOST: usize = 18;

impl Sensed {
    /// The strains themselves.
    pub fn strains(&self) -> Strains {
        let ([a, b, c], [d, e, f]) = (&self.stretch, &self.bend);
        [a.value, b.value, c.value, d.value, e.value, f.value]
    }

    /// Derivatives of a strain by the variables of the point.
    pub fn gradient(&self, strain: usize) -> [f64; VARIABLES] {
        let mut gradient = [0.0; VARIABLES];
        match strain {
            0..3 => gradient[..9].copy_from_slice(&self.stretch[strain].gradient),
            _ => gradient[PSI..].copy_from_slice(&self.bend[strain - 3].gradient),
        }
        gradient
    }

    /// sum_k s_k d strain_k.
    pub fn pull(&self, stresses: &[f64; 6]) -> [f64; VARIABLES] {
        let mut pull = [0.0; VARIABLES];
        for (strain, stress) in stresses.iter().enumerate() {
            let gradient = self.gradient(strain);
            pull.iter_mut().zip(gradient).for_each(|(sum, by)| *sum += stress * by);
        }
        pull
    }

    /// sum_k s_k d2 strain_k + sum_kl D_kl d strain_k d strain_l.
    pub fn stiffness(
        &self,
        stresses: &[f64; 6],
        section: &[[f64; 6]; 6],
    ) -> [[f64; VARIABLES]; VARIABLES] {
        let mut sum = [[0.0; VARIABLES]; VARIABLES];
        for k in 0..3 {
            let stretch = self.stretch[k].hessian.iter().map(|row| &row[..]);
            let bend = self.bend[k].hessian.iter().map(|row| &row[..]);
            for (into, row) in sum.iter_mut().zip(stretch) {
                into.iter_mut().zip(row).for_each(|(into, own)| *into += stresses[k] * own);
            }
            for (into, row) in sum[PSI..].iter_mut().zip(bend) {
                let into = into[PSI..].iter_mut();
                into.zip(row).for_each(|(into, own)| *into += stresses[3 + k] * own);
            }
        }
        let gradients: [[f64; VARIABLES]; 6] = std::array::from_fn(|k| self.gradient(k));
        for (k, row) in section.iter().enumerate() {
            for (l, &entry) in row.iter().enumerate().filter(|(_, entry)| **entry != 0.0) {
                for i in 0..VARIABLES {
                    let by = entry * gradients[k][i];
                    (0..VARIABLES).for_each(|j| sum[i][j] += by * gradients[l][j]);
                }
            }
        }
        sum
    }
}
