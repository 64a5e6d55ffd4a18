//! Rubber from test data.
//!
//! ```text
//!   nominal stress over strain,  uniaxial  equibiaxial  planar      pressure over volume
//!            |                                                             |
//!            v   sum (1 - T_law/T_test)^2 -> least                         v
//!      polynomials: linear      Ogden, Arruda-Boyce: sum c_k f(p_k),     linear
//!                               from many starts
//! ```
//!
//! Relative errors, so that small strains count as much as large ones, and no unit does:
//! docs/theory.md eqs. (3.84) and (3.85).

use super::least_squares::{Linearised, linear, nonlinear};
use super::paths::{Mode, term};
use super::rubber::{CHAIN, MOST_TERMS, Rubber, Volume};
use crate::differentiate::{Real, Second};

/// A law whose coefficients are sought.
#[derive(Debug, Clone, PartialEq)]
pub enum Form {
    /// Powers of I1 - 3 and I2 - 3 of each term.
    Polynomial(Vec<(u8, u8)>),
    /// So many terms of Ogden.
    Ogden(usize),
    /// Arruda and Boyce.
    ArrudaBoyce,
}

/// A point of a test.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measured {
    /// How the specimen was loaded.
    pub mode: Mode,
    /// Nominal strain, above -1 and not zero [1].
    pub strain: f64,
    /// Nominal stress, not zero [F/L2].
    pub stress: f64,
}

/// Why no law comes of test data.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NoFit {
    /// Fewer points than coefficients.
    TooFew {
        /// How many there must be.
        needed: usize,
    },
    /// Other coefficients fit as well.
    Undetermined,
    /// The search for the least error does not arrive.
    NotConverged,
    /// Nothing in the data says where the chains of molecules lock.
    NoLocking,
}

/// Powers that the search of Ogden's terms starts from [1].
const STARTS: [f64; 10] = [-6.0, -3.5, -2.0, -1.0, 1.0, 2.0, 3.0, 4.5, 7.0, 11.0];
/// Starts that are followed, the best ones.
const FOLLOWED: usize = 12;
/// Locking stretches that the search of Arruda and Boyce's law starts from [1].
const LOCKING: [f64; 4] = [1.5, 3.0, 5.0, 10.0];
/// The inverse square of a locking stretch that is none [1].
const NO_LOCKING: f64 = 1e-6;

impl Form {
    /// Number of coefficients.
    pub fn unknowns(&self) -> usize {
        match self {
            Self::Polynomial(powers) => powers.len(),
            Self::Ogden(terms) => 2 * terms,
            Self::ArrudaBoyce => 2,
        }
    }

    /// The rubber that fits test data best, without a change of volume yet.
    ///
    /// # Errors
    ///
    /// Why there is none.
    pub fn fit(&self, data: &[Measured]) -> Result<Rubber, NoFit> {
        let needed = self.unknowns();
        if data.len() < needed {
            return Err(NoFit::TooFew { needed });
        }
        match self {
            Self::Polynomial(powers) => polynomial(powers, data),
            Self::Ogden(terms) => ogden(*terms, data),
            Self::ArrudaBoyce => chains(data),
        }
    }

    /// 1/D_i of so many terms, from points of pressure [F/L2] and ratio of volumes [1].
    ///
    /// # Errors
    ///
    /// Why there are none.
    pub fn fit_volume(&self, terms: usize, data: &[[f64; 2]]) -> Result<Volume, NoFit> {
        let terms = if *self == Self::ArrudaBoyce { 1 } else { terms.min(MOST_TERMS) };
        if data.len() < terms {
            return Err(NoFit::TooFew { needed: terms });
        }
        let column = |term: usize| {
            let mut volume = Volume::default();
            volume[term] = 1.0;
            let unit = self.empty().with_volume(volume);
            data.iter().map(|[pressure, ratio]| unit.pressure(ratio - 1.0) / pressure).collect()
        };
        let found = linear((0..terms).map(column).collect(), vec![1.0; data.len()]);
        let mut volume = Volume::default();
        volume.iter_mut().zip(found.ok_or(NoFit::Undetermined)?).for_each(|(v, own)| *v = own);
        Ok(volume)
    }

    /// The form without any stiffness.
    fn empty(&self) -> Rubber {
        let volume = Volume::default();
        match self {
            Self::Polynomial(_) => Rubber::Polynomial { terms: Vec::new(), volume },
            Self::Ogden(_) => Rubber::Ogden { terms: Vec::new(), volume },
            Self::ArrudaBoyce => Rubber::ArrudaBoyce { shear: 0.0, locking: 1.0, volume: 0.0 },
        }
    }
}

impl Rubber {
    /// The same with another change of volume; Arruda and Boyce's has one coefficient.
    pub fn with_volume(self, volume: Volume) -> Self {
        match self {
            Self::Polynomial { terms, .. } => Self::Polynomial { terms, volume },
            Self::Ogden { terms, .. } => Self::Ogden { terms, volume },
            Self::ArrudaBoyce { shear, locking, .. } => {
                Self::ArrudaBoyce { shear, locking, volume: volume[0] }
            }
        }
    }

    /// Error of the stress at a point of a test, over the measured stress [1].
    pub fn relative_error(&self, point: &Measured) -> f64 {
        self.nominal_stress(point.mode, point.strain) / point.stress - 1.0
    }
}

/// docs/theory.md eq. (3.85), which is linear in the coefficients.
fn polynomial(powers: &[(u8, u8)], data: &[Measured]) -> Result<Rubber, NoFit> {
    let volume = Volume::default();
    let column = |&(i, j): &(u8, u8)| {
        let unit = Rubber::Polynomial { terms: vec![(i, j, 1.0)], volume };
        data.iter().map(|own| unit.nominal_stress(own.mode, own.strain) / own.stress).collect()
    };
    let found = linear(powers.iter().map(column).collect(), vec![1.0; data.len()]);
    let found = found.ok_or(NoFit::Undetermined)?;
    let terms = powers.iter().zip(found).map(|(&(i, j), own)| (i, j, own)).collect();
    Ok(Rubber::Polynomial { terms, volume })
}

/// Stress of a term at a point of a test for a coefficient of one, over the measured stress, and its
/// derivative by the parameter of the term.
pub(super) type Shape = fn(&Measured, f64) -> [f64; 2];

/// 2/alpha l^(alpha - 1) less what the free sides take.
pub(super) fn power(point: &Measured, alpha: f64) -> [f64; 2] {
    let alpha = Second::<1>::variable(alpha, 0);
    let found = term(point.mode, point.strain, |logs, rates| {
        let parts = logs
            .iter()
            .zip(rates)
            .map(|(&log, rate)| Second::constant(rate) * (alpha * Second::constant(log)).exp_m1());
        Second::constant(2.0) / alpha * parts.fold(Second::constant(0.0), |sum, own| sum + own)
    });
    found.map(|own| own / point.stress)
}

/// The law of chains by the inverse square of their locking stretch.
pub(super) fn chain(point: &Measured, inverse: f64) -> [f64; 2] {
    let inverse = Second::<1>::variable(inverse, 0);
    let found = term(point.mode, point.strain, |logs, rates| {
        let first = 3.0 + logs.iter().map(|log| (2.0 * log).exp_m1()).sum::<f64>();
        let rate: f64 =
            logs.iter().zip(rates).map(|(log, rate)| 2.0 * rate * (2.0 * log).exp_m1()).sum();
        let ratio = inverse * Second::constant(first);
        let slopes = CHAIN
            .iter()
            .zip(1..)
            .map(|(by, k)| Second::constant(by * f64::from(k)) * ratio.powi(k - 1));
        Second::constant(rate) * slopes.fold(Second::constant(0.0), |sum, own| sum + own)
    });
    found.map(|own| own / point.stress)
}

/// Errors of a sum of terms and their derivatives; coefficients, then the terms' own parameters.
fn errors(shape: Shape, parameters: &[f64], data: &[Measured]) -> Linearised {
    let (coefficients, own) = parameters.split_at(parameters.len() / 2);
    let mut residual = vec![-1.0; data.len()];
    let mut columns = vec![vec![0.0; data.len()]; parameters.len()];
    for (k, (c, p)) in coefficients.iter().zip(own).enumerate() {
        for (row, point) in data.iter().enumerate() {
            let [value, slope] = shape(point, *p);
            residual[row] += c * value;
            columns[k][row] = value;
            columns[coefficients.len() + k][row] = c * slope;
        }
    }
    (residual, columns)
}

/// Coefficients that fit best for given parameters of the terms, with the sum of squares.
fn start(shape: Shape, own: &[f64], data: &[Measured]) -> Option<(f64, Vec<f64>)> {
    let column = |p: &f64| data.iter().map(|point| shape(point, *p)[0]).collect();
    let found = linear(own.iter().map(column).collect(), vec![1.0; data.len()])?;
    let parameters: Vec<f64> = found.into_iter().chain(own.iter().copied()).collect();
    let (residual, _) = errors(shape, &parameters, data);
    Some((residual.iter().map(|r| r * r).sum(), parameters))
}

/// The least sum of squares from the best of many starts.
fn search(shape: Shape, starts: &[Vec<f64>], data: &[Measured]) -> Option<Vec<f64>> {
    let mut begun: Vec<_> = starts.iter().filter_map(|own| start(shape, own, data)).collect();
    begun.sort_by(|a, b| a.0.total_cmp(&b.0));
    let followed = begun.into_iter().take(FOLLOWED).map(|(_, parameters)| parameters);
    let arrived = followed.filter_map(|from| nonlinear(from, |trial| errors(shape, trial, data)));
    arrived.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(parameters, _)| parameters)
}

fn ogden(terms: usize, data: &[Measured]) -> Result<Rubber, NoFit> {
    let found = search(power, &choices(&STARTS, terms), data).ok_or(NoFit::NotConverged)?;
    let (shears, powers) = found.split_at(terms);
    let mut terms: Vec<[f64; 2]> = shears.iter().zip(powers).map(|(s, p)| [*s, *p]).collect();
    terms.sort_by(|a, b| a[1].abs().total_cmp(&b[1].abs()));
    Ok(Rubber::Ogden { terms, volume: Volume::default() })
}

fn chains(data: &[Measured]) -> Result<Rubber, NoFit> {
    let starts = LOCKING.map(|locking| vec![1.0 / (locking * locking)]);
    match search(chain, &starts, data).as_deref() {
        Some([shear, inverse]) if *inverse > NO_LOCKING => {
            Ok(Rubber::ArrudaBoyce { shear: *shear, locking: 1.0 / inverse.sqrt(), volume: 0.0 })
        }
        Some(_) => Err(NoFit::NoLocking),
        None => Err(NoFit::NotConverged),
    }
}

/// All choices of so many different values.
fn choices(from: &[f64], count: usize) -> Vec<Vec<f64>> {
    if count == 0 {
        return vec![Vec::new()];
    }
    let tails = from.iter().enumerate().flat_map(|(place, &own)| {
        let rest = choices(&from[place + 1..], count - 1);
        rest.into_iter().map(move |mut tail| {
            tail.insert(0, own);
            tail
        })
    });
    tails.collect()
}
