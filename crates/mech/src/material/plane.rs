//! Isotropic elasticity in plane strain, as energies of three invariants.
//!
//! ```text
//!   F = 1 + H    s = (H11 - H22)^2 + (H12 + H21)^2    shear: zero for turned circles
//!                j = H11 + H22 + H11 H22 - H12 H21    dilation J - 1 of the point
//!                m = mean of j over the element       dilation that the pressure takes
//! ```
//!
//! Written in small quantities, so that small strains keep all their digits. What changes shape
//! follows the point, what changes volume the element: docs/theory.md section 3.4.

use super::Elastic;
use crate::differentiate::{Real, ln_1p, taylor};

/// What a plane deformation amounts to, whichever way it is turned: docs/theory.md eq. (3.32).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlaneInvariants<R = f64> {
    /// s = tr F'F - 2 det F [1], zero where a circle stays a circle.
    pub shear: R,
    /// j = det F - 1 [1].
    pub dilation: R,
    /// Mean of j over the element [1].
    pub mean: R,
}

/// An elastic material in plane strain.
pub trait PlaneStrainLaw {
    /// Energy per undeformed volume [F/L2].
    fn energy<R: Real>(&self, at: &PlaneInvariants<R>) -> R;

    /// Deviator of the Kirchhoff stress across the plane [F/L2].
    fn across(&self, at: &PlaneInvariants) -> f64;

    /// The strain told beside the stress, of a displacement gradient H: 11, 22, 33, 12 [1].
    fn strain(&self, gradient: &[[f64; 2]; 2]) -> [f64; 4];
}

/// Small strains: W = G |dev eps|^2 + K/2 (tr eps)^2, docs/theory.md eq. (3.35).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SmallStrain {
    /// Moduli.
    pub elastic: Elastic,
    /// Whether the shear strain is told as an angle (2 eps12), as Abaqus does.
    pub engineering: bool,
}

impl PlaneStrainLaw for SmallStrain {
    fn energy<R: Real>(&self, at: &PlaneInvariants<R>) -> R {
        let number = R::from_f64;
        let (shear, bulk) = (self.elastic.shear_modulus(), self.elastic.bulk_modulus());
        number(0.5 * shear) * at.shear
            + number(shear / 6.0) * at.dilation * at.dilation
            + number(0.5 * bulk) * at.mean * at.mean
    }

    fn across(&self, at: &PlaneInvariants) -> f64 {
        -2.0 / 3.0 * self.elastic.shear_modulus() * at.dilation
    }

    fn strain(&self, h: &[[f64; 2]; 2]) -> [f64; 4] {
        let angle = h[0][1] + h[1][0];
        [h[0][0], h[1][1], 0.0, if self.engineering { angle } else { 0.5 * angle }]
    }
}

/// Logarithmic strain and Kirchhoff stress (Hencky): `*ELASTIC` of Abaqus at large strain.
/// W = G |dev ln V|^2 + K/2 (ln J)^2, docs/theory.md eq. (3.36).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hencky(pub Elastic);

impl PlaneStrainLaw for Hencky {
    fn energy<R: Real>(&self, at: &PlaneInvariants<R>) -> R {
        let number = R::from_f64;
        let (shear, bulk) = (self.0.shear_modulus(), self.0.bulk_modulus());
        let (point, mean) = (ln_1p(at.dilation), ln_1p(at.mean));
        let t = at.shear / (number(4.0) * (number(1.0) + at.dilation));
        let stretches = taylor(t, squared_arsinh_of_root(t.value()));
        number(2.0 * shear) * stretches
            + number(shear / 6.0) * point * point
            + number(0.5 * bulk) * mean * mean
    }

    fn across(&self, at: &PlaneInvariants) -> f64 {
        -2.0 / 3.0 * self.0.shear_modulus() * at.dilation.ln_1p()
    }

    /// ln V, its shear as an angle: docs/theory.md eq. (3.39).
    fn strain(&self, h: &[[f64; 2]; 2]) -> [f64; 4] {
        let f = [[1.0 + h[0][0], h[0][1]], [h[1][0], 1.0 + h[1][1]]];
        let at = invariants(h);
        let [_, slope, _] = squared_arsinh_of_root(at.shear / (4.0 * (1.0 + at.dilation)));
        // eta / sinh 2 eta = (d eta^2 / dt) / 2, over J
        let ratio = 0.5 * slope / (1.0 + at.dilation);
        let across = [h[0][0] - h[1][1], h[0][1] + h[1][0]];
        // ln V = ln J / 2 + ratio (b - tr b / 2), of which b - J is formed first
        let half = 0.5 * (at.dilation.ln_1p() - ratio * at.shear);
        let lean = ratio * (across[0] * f[0][0] + across[1] * f[0][1]);
        let turn = ratio * (across[0] * f[1][0] + across[1] * f[1][1]);
        let back = ratio * (across[1] * f[1][0] - across[0] * f[1][1]);
        [half + lean, half + back, 0.0, 2.0 * turn]
    }
}

/// Green-Lagrange strain and second Piola-Kirchhoff stress (Saint Venant, Kirchhoff): `*ELASTIC` of
/// CalculiX at large strain. W = L/2 (tr E)^2 + G E:E with E of the deformation whose dilation is
/// replaced by the mean one, docs/theory.md eq. (3.37).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SaintVenant(pub Elastic);

/// Traces of E and E^2, and E33, of the deformation with the mean dilation [1].
fn green<R: Real>(at: &PlaneInvariants<R>) -> [R; 3] {
    let number = R::from_f64;
    let (j, s) = (at.dilation, at.shear);
    // theta = ((1 + m)/(1 + j))^(2/3) = 1 + tau
    let tau = (number(2.0 / 3.0) * (ln_1p(at.mean) - ln_1p(j))).exp_m1();
    let theta = tau + number(1.0);
    let trace = number(0.5) * s + j;
    let squares = trace * trace + number(0.5) * (s - j * j);
    let first = number(1.5) * tau + theta * trace;
    let second = number(0.75) * tau * tau + theta * (tau * trace + theta * squares);
    [first, second, number(0.5) * tau]
}

impl SaintVenant {
    fn lame(&self) -> f64 {
        self.0.bulk_modulus() - 2.0 / 3.0 * self.0.shear_modulus()
    }
}

impl PlaneStrainLaw for SaintVenant {
    fn energy<R: Real>(&self, at: &PlaneInvariants<R>) -> R {
        let [first, second, _] = green(at);
        R::from_f64(0.5 * self.lame()) * first * first
            + R::from_f64(self.0.shear_modulus()) * second
    }

    fn across(&self, at: &PlaneInvariants) -> f64 {
        let [first, second, third] = green(at);
        let (lame, shear) = (self.lame(), self.0.shear_modulus());
        let own = (1.0 + 2.0 * third) * (lame * first + 2.0 * shear * third);
        let sum = lame * first * (3.0 + 2.0 * first) + 2.0 * shear * (first + 2.0 * second);
        own - sum / 3.0
    }

    fn strain(&self, h: &[[f64; 2]; 2]) -> [f64; 4] {
        let products = |i: usize, j: usize| h[0][i] * h[0][j] + h[1][i] * h[1][j];
        [
            h[0][0] + 0.5 * products(0, 0),
            h[1][1] + 0.5 * products(1, 1),
            0.0,
            0.5 * (h[0][1] + h[1][0] + products(0, 1)),
        ]
    }
}

/// Those of one point alone.
pub(crate) fn invariants<R: Real>(h: &[[R; 2]; 2]) -> PlaneInvariants<R> {
    let (a, b) = (h[0][0] - h[1][1], h[0][1] + h[1][0]);
    let dilation = h[0][0] + h[1][1] + (h[0][0] * h[1][1] - h[0][1] * h[1][0]);
    PlaneInvariants { shear: a * a + b * b, dilation, mean: dilation }
}

/// arsinh^2(sqrt t) with its first two derivatives: eta^2 where t = sinh^2 eta = s/4J. Below a
/// hundredth by its series sum_n (-1)^(n+1) (4 t)^n / (2 n^2 binomial(2n, n)), docs/theory.md
/// eq. (3.38); above from (1 + t) t f'^2 = f.
fn squared_arsinh_of_root(t: f64) -> [f64; 3] {
    if t < 1e-2 {
        let (mut sum, mut power, mut coefficient) = ([0.0; 3], [1.0, 0.0, 0.0], 1.0);
        for n in 1..=9 {
            let n = f64::from(n);
            // t^n and its derivatives from those of t^(n-1)
            power = [power[0] * t, n * power[0], n * power[1]];
            for (sum, power) in sum.iter_mut().zip(power) {
                *sum += coefficient * power;
            }
            coefficient *= -n * n / ((n + 1.0) * (n + 0.5));
        }
        return sum;
    }
    let root = t.sqrt();
    let value = root.asinh();
    let first = value / (root * (1.0 + t).sqrt());
    [value * value, first, (1.0 - (1.0 + 2.0 * t) * first) / (2.0 * t * (1.0 + t))]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: series and closed form agree where they meet, with derivatives that are those
    /// of the value. Tolerances: rounding of the closed form's differences.
    #[test]
    fn both_branches_of_the_squared_arsinh() {
        let (below, above) = (9.999_999_9e-3, 1.000_000_01e-2);
        let (a, b) = (squared_arsinh_of_root(below), squared_arsinh_of_root(above));
        for k in 0..2 {
            let line = a[k] + (above - below) * a[k + 1];
            assert!((b[k] - line).abs() < 1e-15, "{k} {} {line}", b[k]);
        }
        assert!((a[2] - b[2]).abs() < 1e-8);
        for t in [0.0, 1e-12, 3e-3, 0.4, 20.0] {
            let exact = t.sqrt().asinh().powi(2);
            assert!((squared_arsinh_of_root(t)[0] - exact).abs() <= 4.0 * f64::EPSILON * exact);
        }
        assert_eq!(squared_arsinh_of_root(0.0), [0.0, 1.0, -2.0 / 3.0]);
    }

    /// Requirement: uniaxial stretch of a bar that is held across: W = (K + 4G/3) e^2/2 with e the
    /// law's strain. Source: definition of the laws. Tolerance: rounding.
    #[test]
    fn a_stretch_in_one_direction() {
        let elastic = Elastic { modulus: 7.0, poisson: 0.3 };
        let modulus = elastic.bulk_modulus() + 4.0 / 3.0 * elastic.shear_modulus();
        for stretch in [0.3, 0.999_999, 1.0 + 1e-7, 1.4, 4.0_f64] {
            let h = [[stretch - 1.0, 0.0], [0.0, 0.0]];
            let at = invariants(&h);
            let log = Hencky(elastic);
            let green = SaintVenant(elastic);
            let small = SmallStrain { elastic, engineering: true };
            let log_strain = h[0][0].ln_1p();
            let green_strain = h[0][0] + 0.5 * h[0][0] * h[0][0];
            for (energy, strain, told) in [
                (log.energy(&at), log_strain, log.strain(&h)),
                (green.energy(&at), green_strain, green.strain(&h)),
                (small.energy(&at), h[0][0], small.strain(&h)),
            ] {
                let exact = 0.5 * modulus * strain * strain;
                assert!((energy - exact).abs() < 1e-13 * exact, "{stretch}: {energy} {exact}");
                assert!((told[0] - strain).abs() < 1e-14 * strain.abs() + 1e-16, "{told:?}");
                assert!(told[1].abs() < 1e-15 && told[3] == 0.0, "{told:?}");
            }
        }
    }

    /// Requirement: the stress across the plane follows from what is known of the laws: Hencky
    /// K ln J - 2G/3 ln J, Saint Venant L tr E J^(-1) per area (E33 = 0). Tolerance: rounding.
    #[test]
    fn the_stress_across_the_plane() {
        let elastic = Elastic { modulus: 7.0, poisson: 0.3 };
        let at = invariants(&[[0.2, 0.3], [-0.1, 0.05]]);
        let lame = elastic.bulk_modulus() - 2.0 / 3.0 * elastic.shear_modulus();
        let trace = 0.5 * at.shear + at.dilation;
        let green = SaintVenant(elastic);
        // the mean stress J W_m completes the deviator
        let by_mean = |energy: &dyn Fn(f64) -> f64| {
            (energy(at.mean + 1e-6) - energy(at.mean - 1e-6)) / 2e-6 * (1.0 + at.mean)
        };
        let pressure = by_mean(&|mean| green.energy(&PlaneInvariants { mean, ..at }));
        assert!((green.across(&at) + pressure - lame * trace).abs() < 1e-8);
        let log = Hencky(elastic);
        let pressure = by_mean(&|mean| log.energy(&PlaneInvariants { mean, ..at }));
        assert!((log.across(&at) + pressure - lame * at.dilation.ln_1p()).abs() < 1e-8);
    }
}
