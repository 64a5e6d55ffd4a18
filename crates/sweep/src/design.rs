//! From the number of a case to the values of its parameters.

use crate::mixing::{joined, permuted, unit};
use crate::normal::{below, quantile};
use crate::sobol;
use crate::spread::{Number, Spread};

/// How cases are laid out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Every value of every parameter with every other; the last parameter changes first.
    Grid,
    /// The first values of all lists, then the second ones.
    Together,
    /// Independent points.
    Random,
    /// As many strata as cases in every direction, one case in each.
    Latin,
    /// The sequence of Sobol, scrambled.
    Sobol,
    /// Points of that sequence in pairs, A and B, and for each parameter A with its value of B: one
    /// after the other, for the shares of the variance.
    Saltelli,
}

/// What a case of Saltelli's design is at its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    A,
    B,
    /// A with one value of B.
    Mixed(usize),
}

/// The point of a case of Saltelli's design, and its role there.
#[allow(clippy::cast_possible_truncation)] // below the number of directions
fn role(case: u64, directions: usize) -> (u64, Role) {
    let each = cases_a_point(directions);
    let role = match case % each {
        0 => Role::A,
        1 => Role::B,
        mixed => Role::Mixed(mixed as usize - 2),
    };
    (case / each, role)
}

/// Cases of Saltelli's design at one point of so many directions.
pub(crate) fn cases_a_point(directions: usize) -> u64 {
    directions as u64 + 2
}

/// The layout of a study, sound.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Design {
    /// How.
    pub kind: Kind,
    /// Number of cases.
    pub cases: u64,
    /// What random numbers follow from.
    pub seed: u64,
    /// Lower factor of the matrix of correlations, row by row; empty: none are correlated.
    pub factor: Vec<Vec<f64>>,
}

impl Design {
    /// Values of the parameters in a case.
    pub fn values(&self, case: u64, spreads: &[&Spread]) -> Vec<Number> {
        match self.kind {
            Kind::Grid => levels(case, spreads),
            Kind::Together => spreads.iter().map(|spread| spread.level(case)).collect(),
            Kind::Random | Kind::Latin | Kind::Sobol | Kind::Saltelli => {
                let point = self.point(case, spreads.len());
                spreads.iter().zip(point).map(|(spread, u)| spread.at(u)).collect()
            }
        }
    }

    /// A point of the unit cube, correlated.
    fn point(&self, case: u64, directions: usize) -> Vec<f64> {
        let point: Vec<f64> =
            (0..directions).map(|of| self.coordinate(case, of, directions)).collect();
        if self.factor.is_empty() {
            return point;
        }
        correlated(&point, &self.factor)
    }

    #[allow(clippy::cast_precision_loss)] // cases are far fewer than 2^53
    fn coordinate(&self, case: u64, direction: usize, directions: usize) -> f64 {
        let seed = joined(&[self.seed, direction as u64]);
        let within = unit(joined(&[seed, case]));
        match self.kind {
            Kind::Latin => (permuted(case, self.cases, seed) as f64 + within) / self.cases as f64,
            Kind::Sobol => sobol::coordinate(case, direction, self.seed),
            Kind::Saltelli => {
                let (point, role) = role(case, directions);
                let of_b = role == Role::B || role == Role::Mixed(direction);
                let own = if of_b { directions + direction } else { direction };
                sobol::coordinate(point, own, self.seed)
            }
            Kind::Grid | Kind::Together | Kind::Random => within,
        }
    }
}

fn levels(case: u64, spreads: &[&Spread]) -> Vec<Number> {
    let mut rest = case;
    let mut values: Vec<Number> = spreads
        .iter()
        .rev()
        .map(|spread| {
            let count = spread.count().unwrap_or(1);
            let place = rest % count;
            rest /= count;
            spread.level(place)
        })
        .collect();
    values.reverse();
    values
}

/// A Gaussian copula: normal numbers of the point, mixed by the factor of their correlations, and
/// back into the cube.
fn correlated(point: &[f64], factor: &[Vec<f64>]) -> Vec<f64> {
    let normal: Vec<f64> = point.iter().map(|&u| quantile(u)).collect();
    let mixed = factor.iter().map(|row| row.iter().zip(&normal).map(|(l, z)| l * z).sum::<f64>());
    mixed.map(|z| below(z).clamp(f64::MIN_POSITIVE, 1.0 - f64::EPSILON)).collect()
}

/// Lower factor of Cholesky; `None` where the matrix is not positive definite.
pub(crate) fn factored(matrix: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
    let mut factor: Vec<Vec<f64>> = Vec::with_capacity(matrix.len());
    for (i, row) in matrix.iter().enumerate() {
        let mut own: Vec<f64> = Vec::with_capacity(i + 1);
        for (j, earlier) in factor.iter().enumerate() {
            let known: f64 = own.iter().zip(earlier).map(|(a, b)| a * b).sum();
            own.push((row[j] - known) / earlier[j]);
        }
        let rest = row[i] - own.iter().map(|a| a * a).sum::<f64>();
        if rest <= f64::EPSILON {
            return None;
        }
        own.push(rest.sqrt());
        factor.push(own);
    }
    Some(factor)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn design(kind: Kind, cases: u64) -> Design {
        Design { kind, cases, seed: 1, factor: Vec::new() }
    }

    #[test]
    fn a_grid_is_walked_like_a_number() {
        let whole =
            |values: &[i64]| Spread::List(values.iter().map(|&v| Number::Whole(v)).collect());
        let (a, b) = (whole(&[1, 2]), whole(&[5, 6, 7]));
        let rows: Vec<String> = (0..6)
            .map(|case| {
                let values = design(Kind::Grid, 6).values(case, &[&a, &b]);
                values.iter().map(|value| value.text()).collect()
            })
            .collect();
        assert_eq!(rows, ["15", "16", "17", "25", "26", "27"]);
    }

    /// Requirement: one case in each stratum, in every direction.
    #[test]
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // between 0 and 100
    fn a_latin_hypercube_meets_every_stratum_once() {
        let all = Spread::Uniform([0.0, 100.0]);
        for of in 0..3 {
            let mut met = [0; 100];
            for case in 0..100 {
                met[design(Kind::Latin, 100).values(case, &[&all; 3])[of].real() as usize] += 1;
            }
            assert_eq!(met, [1; 100]);
        }
    }

    /// Requirement: the three roles of every point, and points that fill the cube of twice as many
    /// directions.
    #[test]
    fn points_of_saltelli_come_with_their_mixtures() {
        let all = Spread::Uniform([0.0, 1.0]);
        let own = design(Kind::Saltelli, 40);
        for point in 0..10 {
            let at = |role: u64| -> Vec<f64> {
                let values = own.values(4 * point + role, &[&all; 2]);
                values.into_iter().map(Number::real).collect()
            };
            let (a, b) = (at(0), at(1));
            assert_eq!([at(2), at(3)], [vec![b[0], a[1]], vec![a[0], b[1]]]);
            let expected = [0, 1].map(|of| sobol::coordinate(point, of, 1));
            assert_eq!(a, expected);
            assert_ne!(a, b);
        }
    }

    /// Requirement: means, deviations and correlation of many cases are those asked for, within
    /// three standard errors of independent points; those of Sobol's sequence within a third of it.
    #[test]
    #[allow(clippy::cast_precision_loss)] // a few thousand cases
    fn correlated_normal_numbers() {
        const COUNT: u64 = 4096;
        let normal = Spread::Normal { mean: 5.0, deviation: 2.0, within: None };
        let factor = factored(&[vec![1.0, 0.6], vec![0.6, 1.0]]).unwrap_or_default();
        for (kind, allowed) in [(Kind::Random, 3.0), (Kind::Latin, 3.0), (Kind::Sobol, 1.0)] {
            let design = Design { factor: factor.clone(), ..design(kind, COUNT) };
            let error = allowed / (COUNT as f64).sqrt();
            let mut sums = [0.0; 3];
            for case in 0..COUNT {
                let values = design.values(case, &[&normal, &normal]);
                let [x, y] = [0, 1].map(|k| (values[k].real() - 5.0) / 2.0);
                sums = [sums[0] + y, sums[1] + y * y, sums[2] + x * y];
            }
            let [mean, square, product] = sums.map(|sum| sum / COUNT as f64);
            assert!(mean.abs() < error, "{kind:?} mean {mean}");
            assert!((square - 1.0).abs() < 1.5 * error, "{kind:?} variance {square}");
            assert!((product - 0.6).abs() < 1.2 * error, "{kind:?} correlation {product}");
        }
    }

    #[test]
    fn impossible_correlations_have_no_factor() {
        let row = |a, b, c| vec![a, b, c];
        let matrix = [row(1.0, 0.9, -0.9), row(0.9, 1.0, 0.9), row(-0.9, 0.9, 1.0)];
        assert_eq!(factored(&matrix), None);
    }
}
