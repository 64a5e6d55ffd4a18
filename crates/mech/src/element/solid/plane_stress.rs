//! No stress across the plane: the strain across is solved for at the point.
//!
//! ```text
//!   tau33(H11, H12, H21, H22, H33) = 0  -->  H33, kept as the point's last state variable
//!   c_ab = c_ab - c_a3 c_3b / c_33
//! ```

use super::place::NO_STRAIN;
use crate::material::tensor::{INDEX, Matrix};
use crate::material::{Answer, Conditions};
use crate::orientation::Oriented;

/// Most corrections of the strain across.
const MOST: usize = 40;
/// Roundings that are left of the stress across, relative to what makes it [1].
const ROUNDINGS: f64 = 16.0;

/// Longest step of the logarithm of the thickness [1].
const LONGEST: f64 = 0.5;
/// Change of the thickness over the thickness that may be left when the stress across is that of
/// rounding [1]: where the thickness goes to nothing the stress vanishes with it, the change does
/// not.
const CLOSE: f64 = 1e-8;

/// Answers with H33 such that nothing pulls across; writes it into the gradient. The stress across
/// that is left is that of rounding; `None`: there is no such H33.
#[inline(always)]
pub(super) fn ask(
    material: &Oriented<'_>,
    gradient: &mut Matrix,
    under: &Conditions,
    (committed, state): (&[f64], &mut [f64]),
) -> Option<Answer> {
    let own = material.material.states();
    let (before, after) = (&committed[..own.min(committed.len())], state.split_at_mut_checked(own));
    let (after, rest) = after?;
    let [across] = rest else { return None };
    let least = NO_STRAIN + material.material.strained_before(before);
    gradient[2][2] = first_guess(material, gradient, under, committed.get(own).copied());
    for _ in 0..MOST {
        let answer = material.respond(gradient, under, before, after);
        let stress = answer.stress[2];
        // by the logarithm of the thickness: docs/theory.md eq. (3.56)
        let modulus = answer.moduli[2][2] + if under.large { 2.0 * stress } else { 0.0 };
        let step = -stress / modulus;
        let size = answer.stress.iter().fold(0.0_f64, |size, s| size.max(s.abs()));
        let largest = gradient.as_flattened().iter().fold(least, |most, h| most.max(h.abs()));
        let made = modulus.abs() * largest + size;
        if !step.is_finite() {
            return None;
        }
        if stress.abs() <= ROUNDINGS * f64::EPSILON * made && step.abs() <= CLOSE {
            *across = gradient[2][2];
            return (modulus > 0.0).then(|| condensed(answer));
        }
        if under.large {
            gradient[2][2] += step.clamp(-LONGEST, LONGEST).exp_m1() * (1.0 + gradient[2][2]);
        } else {
            gradient[2][2] += step;
        }
    }
    None
}

/// The strain across of linear isotropic elasticity, which is exact but for temperatures; of other
/// laws the last one.
fn first_guess(
    material: &Oriented<'_>,
    gradient: &Matrix,
    under: &Conditions,
    committed: Option<f64>,
) -> f64 {
    let exact = material.material.across(gradient, under.large);
    exact.or(committed).unwrap_or(0.0)
}

/// Indices of the components in the plane.
const PLANE: [usize; 3] = [INDEX[0][0], INDEX[1][1], INDEX[0][1]];

/// The answer in the plane with the strain across eliminated.
#[inline(always)]
fn condensed(mut answer: Answer) -> Answer {
    let across = answer.moduli[2];
    for k in PLANE {
        let part = answer.moduli[k][2] / across[2];
        PLANE.iter().for_each(|&l| answer.moduli[k][l] -= part * across[l]);
        answer.moduli[k][2] = 0.0;
    }
    answer.moduli[2].fill(0.0);
    answer.stress[2] = 0.0;
    answer
}
