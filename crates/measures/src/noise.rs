//! The noise of a run in numbers.

use crate::{DEFAULT_NOISE_FLOOR, maximum, stroke_reversals, stroke_roughness, strokes};

/// Wiggles below this fraction of the peak are not counted as reversals [-].
const FLOOR: f64 = 0.002;

/// What was measured.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct NoiseSummary {
    /// Increments seen.
    pub increments: usize,
    /// Driven reactions.
    pub reactions: Vec<ReactionNoise>,
    /// Contact pairs.
    pub pairs: Vec<PairNoise>,
}

/// Noise of one driven reaction.
#[derive(Clone, Debug, PartialEq)]
pub struct ReactionNoise {
    /// Node label and component, such as `9999.RF2`.
    pub name: String,
    /// Largest magnitude [F or F L].
    pub peak: f64,
    /// Roughness within strokes [-], from second differences; none for fewer
    /// than three increments or a zero curve.
    pub roughness: Option<f64>,
    /// The same from fourth differences [-], which a smooth bend leaves alone.
    pub roughness_of_fourth: Option<f64>,
    /// Sign changes of the slope within strokes, beyond a small fraction of
    /// the peak.
    pub reversals: usize,
}

impl ReactionNoise {
    /// Of a reaction over the increments, with the motion that it belongs to.
    pub fn of(name: String, reaction: &[f64], motion: &[f64]) -> Self {
        let strokes = strokes(motion);
        let rough = stroke_roughness(reaction, &strokes);
        Self {
            name,
            peak: maximum(reaction).unwrap_or(0.0),
            roughness: rough.map(|[second, _]| second),
            roughness_of_fourth: rough.map(|[_, fourth]| fourth),
            reversals: stroke_reversals(reaction, &strokes, FLOOR.max(DEFAULT_NOISE_FLOOR)),
        }
    }
}

/// Noise of one contact pair.
#[derive(Clone, Debug, PartialEq)]
pub struct PairNoise {
    /// The pair's name.
    pub name: String,
    /// Points that opened or closed, over all increments.
    pub changes: usize,
    /// The same per increment [-].
    pub changes_per_increment: f64,
    /// Deepest penetration [L].
    pub penetration: f64,
    /// The same in units of c0 [-], for a softened law.
    pub penetration_over_c0: Option<f64>,
    /// Largest sum of contact forces over both sides, relative to their
    /// magnitudes [-].
    pub force_imbalance: f64,
    /// The same of moments [-].
    pub moment_imbalance: f64,
}
