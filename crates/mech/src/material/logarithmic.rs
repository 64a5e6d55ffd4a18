//! Laws of small strain taken to large strain in logarithmic strain space.
//!
//! ```text
//!   F --> E = ln(C)/2 --> law --> T, moduli of T by E
//!                                  |      by the derivatives of E by C
//!                                  v
//!                          Kirchhoff's stress, its moduli
//! ```
//!
//! E and T are tensors of the undeformed body, so that what a law remembers turns with it
//! [miehe2002]. Derivatives of the logarithm are divided differences over the squares x of the
//! principal stretches; equal stretches cost no digits. docs/theory.md eqs. (3.65) to (3.67).

use super::answer::Answer;
use super::tensor::{COUNTS, INDEX, Matrix, Moduli, Symmetric, carried, eigen, pushed, right};

/// The answer of a `law` of small strain, which answers E [1], to a displacement gradient.
pub(super) fn answer(gradient: &Matrix, law: impl FnOnce(&Symmetric) -> Answer) -> Answer {
    let principal = Principal::of(gradient);
    let own = law(&principal.strain());
    let n = &principal.directions;
    let (t, moduli) = (carried(n, &own.stress), pushed(n, &own.moduli));
    let turn = principal.turned(gradient);
    let stress = carried(&turn, &principal.stress(&t));
    let moduli = pushed(&turn, &principal.moduli(&t, &moduli));
    Answer { stress, moduli, ..own }
}

/// Principal stretches of a deformation, and where they point in the undeformed body.
struct Principal {
    /// ln of the stretches [1].
    logs: [f64; 3],
    /// The stretches [1].
    stretches: [f64; 3],
    /// Unit vectors, a row each.
    directions: Matrix,
}

impl Principal {
    fn of(gradient: &Matrix) -> Self {
        let (values, directions) = eigen(&right(gradient));
        let logs = values.map(|value| 0.5 * value.ln_1p());
        Self { logs, stretches: values.map(|value| (1.0 + value).sqrt()), directions }
    }

    /// E = ln(C)/2.
    fn strain(&self) -> Symmetric {
        let n = &self.directions;
        let back: Matrix = std::array::from_fn(|i| std::array::from_fn(|a| n[a][i]));
        let [x, y, z] = self.logs;
        carried(&back, &[x, y, z, 0.0, 0.0, 0.0])
    }

    /// Principal directions in the deformed body, a column each: F N over the stretch.
    fn turned(&self, gradient: &Matrix) -> Matrix {
        let n = &self.directions;
        std::array::from_fn(|i| {
            std::array::from_fn(|a| {
                let moved: f64 = (0..3).map(|j| gradient[i][j] * n[a][j]).sum();
                (n[a][i] + moved) / self.stretches[a]
            })
        })
    }

    /// Kirchhoff's stress along the principal axes from T along them, eq. (3.66).
    fn stress(&self, t: &Symmetric) -> Symmetric {
        std::array::from_fn(|k| self.slope(k) * t[k])
    }

    /// What an entry of E gains by that of a spatial strain: 2 l_a l_b f[x_a, x_b], which is
    /// d / sinh d with d the difference of two logarithms, for f the logarithm over two.
    fn slope(&self, k: usize) -> f64 {
        let [a, b] = super::tensor::PAIRS[k];
        let d = self.logs[a] - self.logs[b];
        if d == 0.0 { 1.0 } else { d / d.sinh() }
    }

    /// Its moduli along the principal axes, eq. (3.67).
    fn moduli(&self, t: &Symmetric, of_law: &Moduli) -> Moduli {
        let slopes: Symmetric = std::array::from_fn(|k| self.slope(k));
        let mut moduli: Moduli =
            std::array::from_fn(|i| std::array::from_fn(|j| slopes[i] * of_law[i][j] * slopes[j]));
        let l = &self.stretches;
        for a in 0..3 {
            for b in 0..3 {
                for c in 0..3 {
                    let weight = l[a] * l[b] * l[b] * l[c] * self.curvature([a, b, c]);
                    let (i, j) = (INDEX[a][b], INDEX[b][c]);
                    let half = 4.0 * t[INDEX[a][c]] * weight / (COUNTS[i] * COUNTS[j]);
                    moduli[i][j] += half;
                    moduli[j][i] += half;
                }
            }
        }
        moduli
    }

    /// Second divided difference of ln(x)/2 at three squares of stretches: of the first ones where
    /// they stand apart, a series about their mean where they are near.
    fn curvature(&self, places: [usize; 3]) -> f64 {
        let mut x = places.map(|place| self.stretches[place] * self.stretches[place]);
        x.sort_by(f64::total_cmp);
        let [low, middle, high] = x;
        let mean = (low + middle + high) / 3.0;
        if high - low > NEAR * mean {
            return (first(high, middle) - first(middle, low)) / (high - low);
        }
        let [u, v, w] = x.map(|x| (x - mean) / mean);
        // complete homogeneous sums of degree k of one, two and three numbers
        let (mut one, mut two, mut three) = (1.0, 1.0, 1.0);
        let mut sum = -0.25;
        for k in 1..TERMS {
            one *= u;
            two = one + v * two;
            three = two + w * three;
            let sign = if k % 2 == 0 { -0.5 } else { 0.5 };
            sum += sign * three / (k + 2) as f64;
        }
        sum / (mean * mean)
    }
}

/// First divided difference of ln(x)/2.
fn first(high: f64, low: f64) -> f64 {
    let part = (high - low) / low;
    if part == 0.0 { 0.5 / low } else { 0.5 * part.ln_1p() / (part * low) }
}

/// Spread of the squares over their mean below which a series is taken [1]: there its next term is
/// below rounding, and above it differences lose two digits.
const NEAR: f64 = 0.05;
/// Terms of the series.
const TERMS: usize = 14;
