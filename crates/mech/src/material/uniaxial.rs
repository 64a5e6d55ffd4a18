//! A material pulled along one axis and free across it.
//!
//! ```text
//!        ^ tau22 = 0         tau22(H11, H22, H22) = 0  -->  H22, kept behind the
//!   <----o----> tau11        state variables of the material
//! ```
//!
//! For materials without directions of their own: both strains across are the same.
//! docs/theory.md eqs. (3.58), (3.59).

use super::answer::{Answer, Conditions};
use super::law::Material;

/// Most corrections of the strain across.
const MOST: usize = 40;
/// Roundings that are left of the stress across, relative to what makes it [1].
const ROUNDINGS: f64 = 16.0;

/// Answer along the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Uniaxial {
    /// Kirchhoff stress, or that of small strains [F/L2].
    pub stress: f64,
    /// Its derivative by the logarithm of the stretch, or by the small strain [F/L2].
    pub modulus: f64,
    /// Energy per undeformed volume [F/L2]; no number where nothing balances across.
    pub energy: f64,
    /// The part of it that is not given back [F/L2].
    pub dissipation: f64,
    /// Strain across, H22 = H33 [1].
    pub across: f64,
}

impl Material {
    /// Number of state variables of a point that is pulled along one axis.
    pub fn uniaxial_states(&self) -> usize {
        self.states() + 1
    }

    /// Answers a stretch less one, H11, with the strain across for which nothing pulls there.
    pub fn uniaxial(
        &self,
        stretch: f64,
        under: &Conditions,
        committed: &[f64],
        state: &mut [f64],
    ) -> Uniaxial {
        let own = self.states();
        let before = &committed[..own.min(committed.len())];
        let mut across = committed.get(own).copied().unwrap_or(0.0);
        let energy = f64::NAN;
        let nothing = Uniaxial { stress: 0.0, modulus: 0.0, energy, dissipation: 0.0, across };
        let Some((after, [kept])) = state.split_at_mut_checked(own) else { return nothing };
        let least = self.strained_before(before);
        for _ in 0..MOST {
            let gradient = [[stretch, 0.0, 0.0], [0.0, across, 0.0], [0.0, 0.0, across]];
            let answer = self.respond(&gradient, under, before, after);
            let (along, off) = (answer.stress[0], answer.stress[1]);
            let twice = if under.large { 2.0 } else { 0.0 };
            let c = &answer.moduli;
            let resists = c[1][1] + c[1][2] + twice * off;
            let strained = stretch.abs().max(across.abs()).max(least);
            let made = along.abs().max(off.abs()) + resists.abs() * strained;
            if off.abs() <= ROUNDINGS * f64::EPSILON * made {
                *kept = across;
                let modulus = c[0][0] + twice * along - (c[0][1] + c[0][2]) * c[1][0] / resists;
                let Answer { energy, dissipation, .. } = answer;
                return Uniaxial { stress: along, modulus, energy, dissipation, across };
            }
            let step = -off / resists;
            if !step.is_finite() {
                break;
            }
            // a step that would turn the thickness round is cut
            across += if under.large { step.max(-0.5) * (1.0 + across) } else { step };
        }
        nothing
    }
}
