//! No stress across the plane: the strain across is solved for at the point.
//!
//! ```text
//!   tau33(H11, H12, H21, H22, H33) = 0  -->  H33, kept as the point's last state variable
//!   c_ab = c_ab - c_a3 c_3b / c_33
//! ```

use crate::material::tensor::Matrix;
use crate::material::{Answer, Conditions};
use crate::orientation::Oriented;

/// Most corrections of the strain across.
const MOST: usize = 40;
/// Roundings that are left of the stress across, relative to what makes it [1].
const ROUNDINGS: f64 = 16.0;

/// Answers with H33 such that nothing pulls across; writes it into the gradient. The stress across
/// that is left is that of rounding; where there is no such H33 the energy is no number.
pub(super) fn ask(
    material: &Oriented<'_>,
    gradient: &mut Matrix,
    under: &Conditions,
    (committed, state): (&[f64], &mut [f64]),
) -> Answer {
    let own = material.material.states();
    let (before, after) = (&committed[..own.min(committed.len())], state.split_at_mut_checked(own));
    let Some((after, [across])) = after else { return Answer::default() };
    gradient[2][2] = committed.get(own).copied().unwrap_or(0.0);
    for _ in 0..MOST {
        let answer = material.respond(gradient, under, before, after);
        let stress = answer.stress[2];
        let modulus = answer.moduli[2][2] + if under.large { stress } else { 0.0 };
        let step = -stress / modulus;
        let size = answer.stress.iter().fold(0.0_f64, |size, s| size.max(s.abs()));
        let largest = gradient.as_flattened().iter().fold(0.0_f64, |most, h| most.max(h.abs()));
        let made = modulus.abs() * largest + size;
        if stress.abs() <= ROUNDINGS * f64::EPSILON * made {
            *across = gradient[2][2];
            return condensed(answer);
        }
        if !step.is_finite() {
            break;
        }
        if under.large {
            // a step that would turn the thickness round is cut
            gradient[2][2] += step.max(-0.5) * (1.0 + gradient[2][2]);
        } else {
            gradient[2][2] += step;
        }
    }
    Answer { energy: f64::NAN, ..Answer::default() }
}

/// The answer with the strain across eliminated.
fn condensed(mut answer: Answer) -> Answer {
    let across = answer.moduli[2];
    for (row, by) in answer.moduli.iter_mut().zip(across) {
        for (entry, other) in row.iter_mut().zip(across) {
            *entry -= by * other / across[2];
        }
    }
    answer.stress[2] = 0.0;
    answer
}
