//! Stresses as unknowns of the linearisation, eliminated in the element.
//!
//! ```text
//!   displacements q ----> strains eps(q) --- law ---> stresses D eps ----> force
//!          |                                                                 |
//!          +--> B' D B  +  geometric stiffness of the estimate s  <----------+
//!                                            ^
//!        s := D (eps + B dq) of the last linear solution
//! ```
//!
//! The force is that of the law at the strains, so that what is converged is the same as ever. Only
//! the geometric stiffness takes stresses of its own, those that the last linear solution has
//! arrived at: the stresses of a strain that one correction leaves behind, second order in its
//! rotations and as stiff as the axis, are never multiplied with it. [derived: docs/theory.md,
//! "Stresses of their own in the linearisation"]

use crate::first_order::First;

/// An element of `N` variables whose tangent takes `S` stresses that are estimated apart.
pub trait Mixed<const N: usize, const NN: usize, const S: usize> {
    /// Writes the force of the law at `q` and the tangent (row-major, symmetric) whose geometric
    /// stiffness is that of `stresses`; returns the strain energy [F L]: docs/theory.md
    /// eq. (3.26). With the stresses of [`Mixed::stresses_after`] and no change the tangent is the
    /// derivative of the force.
    fn force_and_mixed_tangent(
        &self,
        q: &[f64; N],
        stresses: &[f64; S],
        force: &mut [f64; N],
        tangent: &mut [f64; NN],
    ) -> f64;

    /// The force l B' s of given stresses at `q` (F, F, F L of every node).
    fn force_of_stresses(&self, q: &[f64; N], stresses: &[f64; S]) -> [f64; N];

    /// D (eps + B dq), the stresses that a linear solution with the change dq of the displacements
    /// q arrives at: docs/theory.md eq. (3.27).
    fn stresses_after(&self, q: &[f64; N], change: &[f64; N]) -> [f64; S];
}

/// The line q + t dq as numbers that carry their derivative by t.
pub(super) fn line<const N: usize>(q: &[f64; N], change: &[f64; N]) -> [First<1>; N] {
    std::array::from_fn(|i| First { value: q[i], gradient: [change[i]] })
}

/// Value plus derivative: where the tangent of a curve arrives at t = 1.
pub(super) fn arrival(number: &First<1>) -> f64 {
    number.value + number.gradient[0]
}

/// Axial strain below which a stress counts as none [1].
pub(super) const SLIGHT_STRAIN: f64 = 1e-9;
/// Part of the bending stiffness of a beam as long as the model that the geometric stiffness of
/// such a stress may be [1].
pub(super) const SLIGHT_STIFFNESS: f64 = 1e-3;

/// Raises axial stresses of a beam that are next to none, in a model of size `reach` [L], to a
/// slight tension: docs/theory.md eq. (3.30). `S` stresses a point, the axial one first.
pub(super) fn tighten<const S: usize>(
    (axial, bending): (f64, f64),
    reach: f64,
    stresses: &mut [f64],
) {
    let by_bending = SLIGHT_STIFFNESS * bending / (reach * reach);
    let least = (SLIGHT_STRAIN * axial).min(by_bending);
    for point in stresses.as_chunks_mut::<S>().0 {
        if point[0].abs() < least {
            point[0] = least;
        }
    }
}

/// The estimated stresses of a caller as those of the element; others count as none.
pub(super) fn estimate<const S: usize>(stresses: &[f64]) -> [f64; S] {
    stresses.try_into().unwrap_or([0.0; S])
}
