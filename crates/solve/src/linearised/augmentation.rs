//! The stiffness of an iteration, with and without the augmentation of closed
//! points.
//!
//! ```text
//!   K_s = K_0 + sum A c f g'      c at touching points, back out of the multipliers:
//!                                 lambda = q + c (e - e_0)
//! ```
//!
//! docs/theory.md eq. (8.4).

use super::context::LawContext;
use super::laws::PointAnswer;
use super::points::{Augmentation, LinearPoint, LinearPoints, LinearRows};
use slideline_linalg::{FactorReport, Pattern, SolveError, Solver};
use slideline_mech::contact::tangential::Tangential;

/// The most and the least augmentation, in stiffnesses that the point feels [1].
const MOST: f64 = 1e6;
const LEAST: f64 = 1e-3;

/// K_0 of an iteration and the factors of K_s.
pub struct Stiffness<'a> {
    /// Pattern of both.
    pub pattern: &'a Pattern,
    /// K_0 [F/L and the like].
    pub values: &'a [f64],
    /// K_s; written. Empty: K_0 is factored as it is, which no point augments.
    pub augmented: &'a mut [f64],
    /// Factors of K_s.
    pub solver: &'a mut Solver,
    /// Whether only the symmetric part is wanted.
    pub symmetrised: bool,
}

impl Stiffness<'_> {
    /// Factors K_s with the augmentation that the points have.
    ///
    /// Errors: the solver's.
    pub fn factor(&mut self, points: &LinearPoints) -> Result<FactorReport, SolveError> {
        self.begin();
        for point in points.with_rows() {
            self.augment(&point);
        }
        self.refactor()
    }

    /// Takes K_0 without factoring it, where the factors at hand are those of a matrix near it and
    /// that pays; false: it is to be factored.
    ///
    /// Errors: the solver's.
    pub fn follow(&mut self) -> Result<bool, SolveError> {
        self.begin();
        self.finish();
        let values = if self.augmented.is_empty() { self.values } else { &*self.augmented };
        self.solver.follow(self.pattern, values)
    }

    /// K_0 as K_s begins.
    fn begin(&mut self) {
        if !self.augmented.is_empty() {
            self.augmented.copy_from_slice(self.values);
        }
    }

    /// Factors K_0 with the slopes of laws that are inserted: `answers`, a point each.
    ///
    /// Errors: the solver's.
    pub(super) fn factor_inserted(
        &mut self,
        points: &LinearPoints,
        answers: &[PointAnswer],
    ) -> Result<FactorReport, SolveError> {
        self.begin();
        let Self { augmented, pattern, .. } = self;
        let pressing = points.with_rows().zip(answers).filter(|(_, answer)| !answer.is_idle());
        for (point, answer) in pressing {
            let unknowns = point.rows.unknowns;
            answer.add_slope(&point, |row, column, slope| {
                if let Some(at) = pattern.position(unknowns[row], unknowns[column]) {
                    augmented[at] += slope;
                }
            });
        }
        self.refactor()
    }

    /// Factors what stands in K_s.
    fn refactor(&mut self) -> Result<FactorReport, SolveError> {
        self.finish();
        let values = if self.augmented.is_empty() { self.values } else { &*self.augmented };
        self.solver.refactor(self.pattern, values)
    }

    /// Leaves the symmetric part of K_s, where only that is wanted.
    fn finish(&mut self) {
        if self.symmetrised {
            symmetrise(self.pattern, self.augmented);
        }
    }

    fn augment(&mut self, point: &LinearRows<'_>) {
        let augmentation = point.augmentation();
        if augmentation == Augmentation::default() {
            return;
        }
        let (rows, directions) = (point.rows, 0..point.rows.directions());
        for (i, &row) in rows.unknowns.iter().enumerate() {
            for (j, &column) in rows.unknowns.iter().enumerate() {
                let Some(at) = self.pattern.position(row, column) else { continue };
                let normal = augmentation.normal * rows.normal()[i] * rows.normal()[j];
                let along = |k: usize| augmentation.tangential * rows.force(k)[i] * rows.slip(k)[j];
                self.augmented[at] +=
                    point.area * directions.clone().map(along).fold(normal, |sum, own| sum + own);
            }
        }
    }

    /// Stiffness per area that a point feels of its own equations alone, along
    /// its normal and along its tangents [F/L3]: of both sides in series, a side
    /// that cannot move being infinitely stiff.
    pub(super) fn local(&self, point: &LinearRows<'_>) -> Augmentation {
        let rows = point.rows;
        let (mut normal, mut tangential) = (0.0, 0.0);
        for (k, &own) in rows.unknowns.iter().enumerate() {
            let diagonal = self.pattern.position(own, own).map_or(0.0, |at| self.values[at]);
            let yields = |square: f64| match diagonal > 0.0 {
                _ if square <= 0.0 => 0.0,
                true => point.area * square / diagonal,
                // what nothing but contact holds yields without end
                false => f64::INFINITY,
            };
            normal += yields(rows.normal()[k] * rows.normal()[k]);
            let squares =
                (0..rows.directions()).map(|d| (rows.force(d)[k] * rows.slip(d)[k]).abs());
            tangential += squares.map(yields).sum::<f64>();
        }
        tangential /= rows.directions().max(1) as f64;
        let stiffness = |c: f64| if c > 0.0 { (1.0 / c).max(point.least) } else { 0.0 };
        Augmentation { normal: stiffness(normal), tangential: stiffness(tangential) }
    }
}

/// Replaces matrix values by their symmetric part.
fn symmetrise(pattern: &Pattern, values: &mut [f64]) {
    for i in 0..pattern.size() {
        let start = pattern.row_start()[i];
        for (k, &j) in pattern.row(i).iter().enumerate().filter(|&(_, &j)| j > i) {
            let Some(mirrored) = pattern.position(j, i) else { continue };
            let mean = 0.5 * (values[start + k] + values[mirrored]);
            values[start + k] = mean;
            values[mirrored] = mean;
        }
    }
}

/// A slope of a law as an augmentation: none steeper than what the point feels
/// allows, and an infinite one as what it feels [F/L3].
pub(super) fn within(slope: f64, local: f64, least: f64) -> f64 {
    match slope.is_finite() {
        true => slope.clamp(least * local, MOST * local),
        false => local,
    }
}

impl LawContext<'_> {
    /// Augments points that touch by their laws at the first estimate.
    pub fn augment(&self, points: &mut LinearPoints, stiffness: &Stiffness<'_>) {
        for place in 0..points.len() {
            if points[place].stiffness <= 0.0 {
                continue;
            }
            let wanted = self.augmentation(&points.at(place), stiffness);
            if wanted.normal > 0.0 {
                points[place].set_augmentation(wanted);
            }
        }
    }

    /// Pressure and traction at the point of linearisation, of laws linearised
    /// about the estimates with the augmentation as their slope [F/L2]:
    /// docs/theory.md eq. (8.29).
    pub(super) fn linearised(&self, point: &LinearPoint) -> (f64, Tangential) {
        let laws = &self.laws[point.law];
        let carries = match laws.normal.overclosure(point.pressure) {
            Some((overclosure, _)) => overclosure,
            None => point.overclosure.min(laws.normal.contact_begins()),
        };
        let pressure = point.pressure + point.stiffness * (point.overclosure - carries);
        let traction = point.sliding.map_or(Tangential::ZERO, |sliding| {
            let exact = laws.friction.needs_multiplier() || sliding.stiffness == 0.0;
            let from = match exact {
                true => Tangential::ZERO,
                false => sliding.traction / sliding.stiffness - sliding.elastic_slip,
            };
            sliding.traction + sliding.stiffness * (sliding.slip - from)
        });
        (pressure, traction)
    }

    /// Slopes of the laws of a point at its estimates, no steeper and no softer than what it
    /// feels allows [F/L3].
    fn augmentation(&self, point: &LinearRows<'_>, stiffness: &Stiffness<'_>) -> Augmentation {
        let laws = &self.laws[point.law];
        let (local, pressure) = (stiffness.local(point), point.pressure);
        let normal = match laws.normal.overclosure(pressure) {
            // a hard law has no slope: the point's own stiffness stands for it
            Some((_, 0.0)) => local.normal,
            Some((_, by_pressure)) => within(1.0 / by_pressure, local.normal, LEAST),
            None => LEAST * local.normal,
        };
        let tangential = match &point.sliding {
            Some(sliding) if pressure > 0.0 => {
                let at = (sliding.traction, sliding.slip);
                let stick = laws.stick_stiffness(pressure, at, self.dt).filter(|_| !point.turns());
                stick.map_or(0.0, |slope| within(slope, local.tangential, 0.0))
            }
            _ => 0.0,
        };
        Augmentation { normal, tangential }
    }
}
