//! Logarithmic elasticity: without principal axes where the stretches are near one another and one.
//!
//! ```text
//!   b = (1 + m)(1 + Y), tr Y = 0
//!   ln(1 + Y) = integral of Y R, R = (1 + t Y)^-1, over t from 0 to 1: eight points of Gauss
//! ```
//!
//! R of a symmetric tensor without trace is a polynomial of second degree in Y over a cubic in t,
//! so that the sums over the points are of numbers. The derivative is that of the sum itself.
//! docs/theory.md, below (3.41).

use super::answer::Answer;
use super::elastic::Elastic;
use super::principal::Axes;
use super::tensor::{Matrix, Moduli, Symmetric, contract, determinant, full, left, square, trace};

/// Eigenvalues of Y, and m, up to which the rule of eight points is exact but for rounding [1]: its
/// error falls with the sixteenth power of 14 there.
const NEAR: f64 = 0.25;
/// Gauss's points on the way from 0 to 1.
const PLACES: [f64; 8] = [
    0.019_855_071_751_231_884,
    0.101_666_761_293_186_63,
    0.237_233_795_041_835_5,
    0.408_282_678_752_175_1,
    0.591_717_321_247_825,
    0.762_766_204_958_164_5,
    0.898_333_238_706_813_4,
    0.980_144_928_248_768_1,
];
/// Their weights.
const WEIGHTS: [f64; 8] = [
    0.050_614_268_145_188_13,
    0.111_190_517_226_687_24,
    0.156_853_322_938_943_64,
    0.181_341_891_689_181,
    0.181_341_891_689_181,
    0.156_853_322_938_943_64,
    0.111_190_517_226_687_24,
    0.050_614_268_145_188_13,
];
/// w t^k.
static MOMENTS: [[f64; 8]; 5] = moments();

const fn moments() -> [[f64; 8]; 5] {
    let mut moments = [WEIGHTS; 5];
    let mut k = 1;
    while k < 5 {
        let mut point = 0;
        while point < 8 {
            moments[k][point] = PLACES[point] * moments[k - 1][point];
            point += 1;
        }
        k += 1;
    }
    moments
}

impl Elastic {
    /// W = G sum eps_a^2 + L/2 (sum eps_a)^2 in logarithmic strains: docs/theory.md eq. (3.35).
    #[inline(always)]
    pub fn hencky(&self, gradient: &Matrix) -> Answer {
        let stretched = left(gradient);
        match Near::to_one(&stretched) {
            Some(near) => self.near_one(&near),
            None => self.along_axes(&stretched),
        }
    }

    /// By principal stretches, of b - 1.
    #[inline(never)]
    fn along_axes(&self, stretched: &Symmetric) -> Answer {
        let axes = Axes::of(stretched);
        let (stresses, slopes, energy) = self.principal(&axes.logs);
        axes.answer(&stresses, &slopes, energy)
    }

    /// By the rule, docs/theory.md, below (3.41).
    #[inline(always)]
    fn near_one(&self, near: &Near) -> Answer {
        let (lame, shear) = (self.lame(), self.shear_modulus());
        let Logarithm { even, linear, quadratic, slopes } = near.logarithm();
        let strain: Symmetric = std::array::from_fn(|k| {
            let unit = if k < 3 { even } else { 0.0 };
            0.5 * (unit + linear * near.y[k] + quadratic * near.z[k])
        });
        let pressure = lame * trace(&strain);
        let stress: Symmetric =
            std::array::from_fn(|k| 2.0 * shear * strain[k] + if k < 3 { pressure } else { 0.0 });
        // what is in front of Y^p e Y^q
        let turned = [2.0 * (shear * even + pressure), shear * linear, shear * quadratic];
        let mut factors = slopes.map(|row| row.map(|slope| shear * slope));
        factors[0][0] -= turned[0];
        for k in 1..3 {
            factors[0][k] -= turned[k];
            factors[k][0] -= turned[k];
        }
        let mut moduli = near.products(&factors);
        (0..3).for_each(|i| (0..3).for_each(|k| moduli[i][k] += lame));
        Answer { stress, moduli, energy: 0.5 * contract(&stress, &strain), dissipation: 0.0 }
    }
}

/// b = (1 + m)(1 + Y).
struct Near {
    /// m.
    mean: f64,
    /// Y, its square, half the trace of that and its determinant.
    y: Symmetric,
    z: Symmetric,
    half: f64,
    determinant: f64,
}

/// ln b = even + linear Y + quadratic Y^2, and the derivative of it for b' = e b + b e: the sum of
/// slopes_pq Y^p e Y^q.
struct Logarithm {
    even: f64,
    linear: f64,
    quadratic: f64,
    slopes: Matrix,
}

impl Near {
    /// Parts of b, from b - 1; `None` where a stretch is far from one.
    #[inline(always)]
    fn to_one(stretched: &Symmetric) -> Option<Self> {
        let mean = trace(stretched) / 3.0;
        let scale = 1.0 / (1.0 + mean);
        let y: Symmetric =
            std::array::from_fn(|k| scale * if k < 3 { stretched[k] - mean } else { stretched[k] });
        let z = square(&y);
        let half = 0.5 * trace(&z);
        // no eigenvalue is larger than the root of 4/3 of it
        let is_near = mean.abs() <= NEAR && 4.0 * half <= 3.0 * NEAR * NEAR;
        let determinant = determinant(&full(&y));
        is_near.then_some(Self { mean, y, z, half, determinant })
    }

    /// The sums over the points, docs/theory.md, below (3.41).
    #[inline(always)]
    fn logarithm(&self) -> Logarithm {
        let Self { mean, half: a, determinant, .. } = *self;
        let over = PLACES.map(|t| 1.0 / (1.0 - t * t * (a - t * determinant)));
        let squares = over.map(|over| over * over);
        let of_mean = PLACES.map(|t| 1.0 / (1.0 + t * mean));
        let first = |k: usize| sum(&MOMENTS[k], &over);
        let v: [f64; 5] = std::array::from_fn(|k| sum(&MOMENTS[k], &squares));
        let c = a - determinant;
        let unit = 2.0 * (v[0] - (a + c) * v[2] + a * c * v[4]);
        let once = v[0] - 2.0 * v[1] - a * v[2] + (a + c) * v[3];
        let twice = 2.0 * v[2] - v[1] + a * v[3] - (a + c) * v[4];
        let (both, mixed, far) = (2.0 * (v[2] - v[1]), 2.0 * (v[2] - v[3]), 2.0 * (v[4] - v[3]));
        Logarithm {
            even: mean * sum(&MOMENTS[0], &of_mean) + determinant * first(2),
            linear: first(0),
            quadratic: -first(1),
            slopes: [[unit, once, twice], [once, both, mixed], [twice, mixed, far]],
        }
    }

    /// The tensor that makes the sum of factors_pq Y^p e Y^q of a symmetric e.
    #[inline(always)]
    fn products(&self, factors: &Matrix) -> Moduli {
        let (y, z) = (&self.y, &self.z);
        let behind = |[unit, once, twice]: &[f64; 3]| -> Symmetric {
            std::array::from_fn(|k| {
                0.5 * (once * y[k] + twice * z[k] + if k < 3 { *unit } else { 0.0 })
            })
        };
        let [of_unit, of_y, of_z] = factors;
        let even = full(&behind(of_unit));
        let pairs = [[by_axes(y), by_axes(&behind(of_y))], [by_axes(z), by_axes(&behind(of_z))]];
        [
            row::<0, 0>(&even, &pairs),
            row::<1, 1>(&even, &pairs),
            row::<2, 2>(&even, &pairs),
            row::<0, 1>(&even, &pairs),
            row::<0, 2>(&even, &pairs),
            row::<1, 2>(&even, &pairs),
        ]
    }
}

/// a_ik and a_il for the axes k and l of every index, axis by axis.
type ByAxes = [[Symmetric; 2]; 3];

#[inline(always)]
fn by_axes(a: &Symmetric) -> ByAxes {
    full(a).map(|[x, y, z]| [[x, y, z, x, x, y], [x, y, z, y, z, z]])
}

/// The components of an index of the axes `I` and `J`: a_ik b_jl + a_il b_jk of all `pairs`, and of
/// the unit tensor with `even`.
#[inline(always)]
fn row<const I: usize, const J: usize>(even: &Matrix, pairs: &[[ByAxes; 2]; 2]) -> Symmetric {
    let [x, y, z] = even[J];
    let mut row = match I {
        0 => [2.0 * x, 0.0, 0.0, y, z, 0.0],
        1 => [0.0, 2.0 * y, 0.0, x, 0.0, z],
        _ => [0.0, 0.0, 2.0 * z, 0.0, x, y],
    };
    for [before, behind] in pairs {
        let ([first, second], [third, fourth]) = (&before[I], &behind[J]);
        for n in 0..6 {
            row[n] += first[n] * fourth[n] + second[n] * third[n];
        }
    }
    row
}

/// Sum of products, in a fixed order.
#[inline(always)]
fn sum(a: &[f64; 8], b: &[f64; 8]) -> f64 {
    let mut four = [0.0; 4];
    for k in 0..4 {
        four[k] = a[k] * b[k] + a[k + 4] * b[k + 4];
    }
    (four[0] + four[2]) + (four[1] + four[3])
}

#[cfg(test)]
mod tests {
    use super::super::tensor::COUNTS;
    use super::*;
    use proptest::prelude::*;

    const STEEL: Elastic = Elastic { modulus: 7.0, poisson: 0.3 };

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(500))]

        /// Requirement: with the rule and with principal axes stress, moduli and energy are the
        /// same, for stretches as far from one as the rule is used and for as good as equal ones.
        /// Tolerance: rounding of the principal axes.
        #[test]
        fn the_rule_is_the_law(
            h in prop::array::uniform9(-0.1..0.1_f64), small in 0.0..9.0_f64
        ) {
            let scale = f64::powf(10.0, -small);
            let gradient: Matrix =
                std::array::from_fn(|i| std::array::from_fn(|j| scale * h[3 * i + j]));
            let stretched = left(&gradient);
            let Some(near) = Near::to_one(&stretched) else { return Ok(()) };
            let (own, exact) = (STEEL.near_one(&near), STEEL.along_axes(&stretched));
            for k in 0..6 {
                prop_assert!((own.stress[k] - exact.stress[k]).abs() < 1e-13 * scale);
                for l in 0..6 {
                    prop_assert!((own.moduli[k][l] - exact.moduli[k][l]).abs() < 1e-10);
                }
            }
            prop_assert!((own.energy - exact.energy).abs() < 1e-12 * exact.energy);
        }

        /// Requirement: where the rule ends it is still the law but for rounding: uniaxial stretches of
        /// the largest eigenvalue. Closed form: stress and moduli along the axes.
        #[test]
        fn the_rule_reaches_to_its_end(part in -1.0..1.0_f64, even in -1.0..1.0_f64) {
            let (m, y) = (NEAR * even, NEAR * part);
            let values = [y, -0.5 * y, -0.5 * y].map(|y| (1.0 + m) * (1.0 + y) - 1.0);
            let [a, b, c] = values;
            let Some(near) = Near::to_one(&[a, b, c, 0.0, 0.0, 0.0]) else { return Ok(()) };
            let own = STEEL.near_one(&near);
            let logs = values.map(|value| 0.5 * value.ln_1p());
            let (stresses, slopes, energy) = STEEL.principal(&logs);
            for k in 0..3 {
                prop_assert!((own.stress[k] - stresses[k]).abs() < 2e-15 * 7.0);
                for (l, slope) in slopes[k].iter().enumerate() {
                    let turned = if k == l { 2.0 * stresses[k] } else { 0.0 };
                    prop_assert!((own.moduli[k][l] - slope + turned).abs() < 1e-14 * 7.0);
                }
            }
            prop_assert!((own.energy - energy).abs() < 1e-15 * 7.0);
            prop_assert_eq!(own.moduli[3][4] * COUNTS[3], 0.0);
        }
    }
}
