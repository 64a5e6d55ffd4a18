//! Thermal expansion: the change of shape that a change of temperature makes of a free body.
//!
//! ```text
//!   F = F_m F_th        F_th: free body, hot     F_m: what the law behind it feels
//!
//!   [ ] --F_th--> [   ] --F_m--> /  /
//!   cold, free     hot, free     hot, strained
//! ```
//!
//! The law takes the free body as its undeformed one: its energy counts per volume of that, so
//! that W = J_th W_m(F_m) and Kirchhoff's stress is J_th tau_m. Small strains are taken apart as a
//! sum. docs/theory.md eqs. (3.60) to (3.62).

use super::answer::{Answer, Conditions};
use super::tensor::{self, Matrix, Symmetric};

/// Mean coefficients of expansion over temperature.
#[derive(Debug, Clone, PartialEq)]
pub struct Expansion {
    /// Temperature from which they count [theta].
    pub zero: f64,
    /// Temperature [theta] and coefficients, a tensor about the axes of the material [1/theta],
    /// temperatures ascending: straight between, constant outside.
    pub table: Vec<(f64, Symmetric)>,
}

impl Expansion {
    /// A coefficient for all temperatures and directions.
    pub fn even(coefficient: f64) -> Self {
        Self { zero: 0.0, table: vec![(0.0, tensor::UNIT.map(|one| coefficient * one))] }
    }

    /// Whether all directions expand alike.
    pub fn is_even(&self) -> bool {
        let sheared = |angles: &[f64]| angles.iter().any(|angle| *angle != 0.0);
        self.table
            .iter()
            .all(|(_, row)| row[0] == row[1] && row[1] == row[2] && !sheared(&row[3..]))
    }

    /// Mean coefficients at a temperature.
    fn coefficients(&self, temperature: f64) -> Symmetric {
        match between(&self.table, temperature) {
            Some((low, high, part)) => std::array::from_fn(|k| low[k] + part * (high[k] - low[k])),
            None => [0.0; 6],
        }
    }

    /// Strains of a free body about the axes at a temperature, of one that had none at another:
    /// a(T)(T - T0) - a(TI)(TI - T0), written such that equal temperatures give zeros.
    /// docs/theory.md eq. (3.60).
    pub fn strains(&self, temperature: f64, initial: f64) -> Symmetric {
        let (now, before) = (self.coefficients(temperature), self.coefficients(initial));
        std::array::from_fn(|k| {
            now[k] * (temperature - initial) + (now[k] - before[k]) * (initial - self.zero)
        })
    }
}

/// The rows about a temperature and the part of the way between them; outside of all the outer row
/// twice. `None`: there are no rows.
pub fn between<T>(rows: &[(f64, T)], temperature: f64) -> Option<(&T, &T, f64)> {
    let (first, last) = (rows.first()?, rows.last()?);
    let above = rows.partition_point(|(at, _)| *at <= temperature);
    let Some((high, below)) = rows.get(above).zip(above.checked_sub(1)) else {
        let outer = if above == 0 { first } else { last };
        return Some((&outer.1, &outer.1, 0.0));
    };
    let low = &rows[below];
    Some((&low.1, &high.1, (temperature - low.0) / (high.0 - low.0)))
}

/// How long a free body is at large strain, of the thermal strain e: docs/theory.md eq. (3.61).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Growth {
    /// exp(e): e is a logarithmic strain.
    Logarithmic,
    /// 1 + e: e is a change of length.
    Length,
}

impl Growth {
    /// Logarithm of the stretch.
    fn log(self, strain: f64) -> f64 {
        match self {
            Self::Logarithmic => strain,
            Self::Length => strain.ln_1p(),
        }
    }
}

/// A law of a body that expands.
#[derive(Debug, Clone, PartialEq)]
pub struct Expanding<L> {
    /// How it expands.
    pub expansion: Expansion,
    /// What its strains mean at large strain.
    pub growth: Growth,
    /// What it answers to the rest of its deformation.
    pub law: L,
}

impl<L> Expanding<L> {
    /// Logarithms of the principal stretches of the free body, and their directions.
    fn logs(&self, under: &Conditions) -> ([f64; 3], Option<Matrix>) {
        let strains = self.expansion.strains(under.temperature, under.initial);
        let [a, b, c, angles @ ..] = strains;
        let (principal, directions) = match angles == [0.0; 3] {
            true => ([a, b, c], None),
            false => {
                let (principal, directions) = tensor::eigen(&strains);
                (principal, Some(directions))
            }
        };
        (principal.map(|strain| self.growth.log(strain)), directions)
    }

    /// Its volume over that of the cold one.
    pub(super) fn volume(&self, under: &Conditions) -> f64 {
        self.logs(under).0.iter().sum::<f64>().exp()
    }

    /// What the answer of the `law` to what the expansion leaves of a displacement gradient is on
    /// the cold body.
    pub(super) fn respond(
        &self,
        gradient: &Matrix,
        under: &Conditions,
        law: impl FnOnce(&Matrix) -> Answer,
    ) -> Answer {
        let mut left = *gradient;
        if !under.large {
            let strains = self.expansion.strains(under.temperature, under.initial);
            let free = tensor::full(&strains);
            (0..3).for_each(|i| (0..3).for_each(|j| left[i][j] -= free[i][j]));
            return law(&left);
        }
        let (logs, directions) = self.logs(under);
        // H_m = H B + B with B = 1/F_th - 1, free of cancellation
        match directions {
            None => {
                for (j, log) in logs.iter().enumerate() {
                    let back = (-log).exp_m1();
                    left.iter_mut().for_each(|row| row[j] += back * row[j]);
                    left[j][j] += back;
                }
            }
            Some(directions) => {
                let back = logs.map(|log| (-log).exp_m1());
                let back = tensor::full(&tensor::of_principal(&back, &directions));
                let moved = tensor::product(gradient, &back);
                (0..3).for_each(|i| (0..3).for_each(|j| left[i][j] += moved[i][j] + back[i][j]));
            }
        }
        let answer = law(&left);
        let volume = self.volume(under);
        Answer {
            stress: answer.stress.map(|stress| volume * stress),
            moduli: answer.moduli.map(|row| row.map(|entry| volume * entry)),
            energy: volume * answer.energy,
            dissipation: volume * answer.dissipation,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Clock, Elastic, LargeStrain, Material};
    use super::*;

    /// Stress of a body that expands so, at a displacement gradient.
    fn stress(row: Symmetric, growth: Growth, h: &Matrix, large: bool) -> Symmetric {
        let elastic = Elastic { modulus: 7.0, poisson: 0.3 };
        let law = Material::Elastic(elastic, LargeStrain::Logarithmic);
        let expansion = Expansion { zero: 0.0, table: vec![(0.0, row)] };
        let hot = Material::Expanding(Box::new(Expanding { expansion, growth, law }));
        let under = Conditions { large, temperature: 90.0, initial: 10.0, clock: Clock::default() };
        hot.respond(h, &under, &[], &mut []).stress
    }

    /// Requirement: six coefficients are those of three axes, looked at from others. Source:
    /// tensors turn. Tolerance: rounding.
    #[test]
    fn sheared_coefficients_are_those_of_turned_axes() {
        let turn = [[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]];
        let along: Symmetric = [1e-3, 3e-3, -5e-4, 0.0, 0.0, 0.0];
        let sheared = tensor::carried(&turn, &along);
        let h = [[0.05, 0.02, -0.01], [0.03, -0.04, 0.01], [0.0, 0.02, 0.06]];
        let back: Matrix = std::array::from_fn(|i| std::array::from_fn(|j| turn[j][i]));
        let turned = tensor::product(&tensor::product(&turn, &h), &back);
        for growth in [Growth::Logarithmic, Growth::Length] {
            for large in [false, true] {
                let expected = tensor::carried(&turn, &stress(along, growth, &h, large));
                let found = stress(sheared, growth, &turned, large);
                for (found, expected) in found.iter().zip(expected) {
                    assert!((found - expected).abs() < 1e-14, "{growth:?} {found} {expected}");
                }
            }
        }
    }
}
