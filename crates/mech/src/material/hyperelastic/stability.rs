//! Where a rubber stops answering more strain with more stress.
//!
//! ```text
//!   T |      .-.            dtau : de > 0 for every small strain that keeps the volume;
//!     |    /     \          behind the first strain where one gives nothing the law is unstable
//!     +---/-------:--> e
//! ```
//!
//! Drucker's condition in principal logarithmic strains: docs/theory.md eq. (3.86).

use super::paths::Mode;
use super::rubber::Rubber;
use crate::differentiate::Second;

/// Stretches of the search go to this one and to its inverse [1].
const FARTHEST: f64 = 10.0;
/// Steps of the search.
const STEPS: u32 = 400;
/// Halvings of the step in which stability is lost.
const HALVINGS: u32 = 40;

impl Rubber {
    /// Whether every further strain that keeps the volume takes work, at the logarithmic strains
    /// along two axes, the volume kept: docs/theory.md eq. (3.86).
    pub fn is_stable(&self, axes: [f64; 2]) -> bool {
        let w: Second<2> = self.kept(Second::variables(&axes));
        let [[a, b], [_, c]] = w.hessian;
        a > 0.0 && a * c - b * b > 0.0
    }

    /// Nominal strains at which stability is lost in each mode, pulled and pressed, between the
    /// stretches .1 and 10; nothing where it is not [1].
    pub fn unstable_from(&self) -> Vec<(Mode, f64)> {
        let ways = Mode::ALL.into_iter().flat_map(|mode| [(mode, 1.0), (mode, -1.0)]);
        ways.filter_map(|(mode, way)| Some((mode, self.lost(mode, way)?))).collect()
    }

    /// The strain at which it is lost on one way.
    fn lost(&self, mode: Mode, way: f64) -> Option<f64> {
        let step = way * FARTHEST.ln() / f64::from(STEPS);
        let stable = |log: f64| self.is_stable(mode.axes(log));
        let first = (0..=STEPS).map(|k| f64::from(k) * step).find(|&log| !stable(log))?;
        let [mut inside, mut outside] = [first - step, first];
        for _ in 0..HALVINGS {
            let middle = 0.5 * (inside + outside);
            if stable(middle) {
                inside = middle;
            } else {
                outside = middle;
            }
        }
        Some(outside.exp_m1())
    }
}
