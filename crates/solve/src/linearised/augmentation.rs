//! The stiffness of an iteration, with and without the augmentation of closed
//! points.
//!
//! ```text
//!   K_s = K_0 + sum A c f g'      c at touching points, back out of the multipliers:
//!                                 lambda = q + c (e - e_0)
//! ```
//!
//! docs/theory.md eq. (8.4).

use super::{LinearPoint, Sliding};
use slideline_linalg::{FactorReport, Pattern, SolveError, Solver};

/// K_0 of an iteration and the factors of K_s.
pub struct Stiffness<'a> {
    /// Pattern of both.
    pub pattern: &'a Pattern,
    /// K_0 [F/L and the like].
    pub values: &'a [f64],
    /// K_s; written.
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
    pub fn factor(&mut self, points: &[LinearPoint]) -> Result<FactorReport, SolveError> {
        self.augmented.copy_from_slice(self.values);
        for point in points {
            self.augment(point);
        }
        if self.symmetrised {
            symmetrise(self.pattern, self.augmented);
        }
        self.solver.refactor(self.pattern, self.augmented)
    }

    fn augment(&mut self, point: &LinearPoint) {
        let tangential = point.sliding.map_or(0.0, |sliding| sliding.stiffness);
        if point.stiffness == 0.0 && tangential == 0.0 {
            return;
        }
        for i in 0..point.width {
            for j in 0..point.width {
                let at = self.pattern.position(point.equations[i], point.equations[j]);
                if let Some(at) = at {
                    self.augmented[at] += point.area
                        * (point.stiffness * point.normal[i] * point.normal[j]
                            + tangential * point.direction[i] * point.tangential[j]);
                }
            }
        }
    }

    /// Stiffness per area that a point feels of its own equations alone, along
    /// its normal and along its tangent [F/L3]: of both sides in series, a side
    /// that cannot move being infinitely stiff.
    pub fn local(&self, point: &LinearPoint) -> [f64; 2] {
        let mut compliance = [0.0; 2];
        for k in 0..point.width {
            let own = point.equations[k];
            let diagonal = self.pattern.position(own, own).map_or(0.0, |at| self.values[at]);
            let squares = [
                point.normal[k] * point.normal[k],
                (point.direction[k] * point.tangential[k]).abs(),
            ];
            for (sum, square) in compliance.iter_mut().zip(squares).filter(|(_, s)| *s > 0.0) {
                // what nothing but contact holds yields without end
                *sum += if diagonal > 0.0 { point.area * square / diagonal } else { f64::INFINITY };
            }
        }
        compliance.map(|c| if c > 0.0 { (1.0 / c).max(point.least) } else { 0.0 })
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

impl LinearPoint {
    /// Sets the augmentation along the normal and along the tangent [F/L3].
    pub(super) fn set_augmentation(&mut self, [normal, tangential]: [f64; 2]) {
        self.stiffness = normal;
        if let Some(sliding) = &mut self.sliding {
            *sliding = Sliding { stiffness: tangential, ..*sliding };
        }
    }
}
