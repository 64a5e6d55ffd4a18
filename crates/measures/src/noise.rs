//! The noise of a run in numbers.

use crate::difference::maximum;
use crate::shape::{DEFAULT_NOISE_FLOOR, pushes, stroke_reversals, stroke_roughness, strokes};
use std::ops::Range;

/// Wiggles below this fraction of the peak are not counted as reversals [-].
const FLOOR: f64 = 0.002;

/// Values that a fourth difference takes: a shorter push has no roughness.
const WINDOW: usize = 5;
/// Reversals that a smooth push may have: over a crest, and up again.
const SMOOTH_TURNS: usize = 2;

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
    /// What of it the mesh makes.
    pub of_mesh: Option<MeshNoise>,
}

/// Noise that contact makes as it is handed from node to node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshNoise {
    /// The smaller of the roughness from second and from fourth differences
    /// [-], within the pushes that are noisy.
    pub roughness: f64,
    /// Reversals within these pushes.
    pub reversals: usize,
}

impl ReactionNoise {
    /// Of a reaction over the increments, with the motion that it belongs to.
    /// `nodes` tells over how many slave nodes contact has moved in a range of
    /// increments.
    pub fn of(
        name: String,
        reaction: &[f64],
        motion: &[f64],
        nodes: impl Fn(Range<usize>) -> usize,
    ) -> Self {
        let strokes = strokes(motion);
        let rough = stroke_roughness(reaction, &strokes);
        let floor = FLOOR.max(DEFAULT_NOISE_FLOOR);
        Self {
            name,
            peak: maximum(reaction).unwrap_or(0.0),
            roughness: rough.map(|[second, _]| second),
            roughness_of_fourth: rough.map(|[_, fourth]| fourth),
            reversals: stroke_reversals(reaction, &strokes, floor),
            of_mesh: mesh_noise(reaction, &pushes(reaction, &strokes, WINDOW), nodes),
        }
    }
}

/// The noise of those pushes that turn more often than a smooth push does, and
/// not more often than the mesh explains: each slave node that contact passes
/// makes the force rise and fall once. A hook that drops off edge after edge
/// turns without passing nodes, a snap turns once or twice: both are physics.
fn mesh_noise(
    reaction: &[f64],
    pushes: &[Range<usize>],
    nodes: impl Fn(Range<usize>) -> usize,
) -> Option<MeshNoise> {
    let turns = |push: &Range<usize>| {
        stroke_reversals(reaction, std::slice::from_ref(push), FLOOR.max(DEFAULT_NOISE_FLOOR))
    };
    let noisy: Vec<Range<usize>> = pushes
        .iter()
        .filter(|push| {
            let turns = turns(push);
            turns > SMOOTH_TURNS && turns <= 2 * nodes((*push).clone())
        })
        .cloned()
        .collect();
    let [second, fourth] = stroke_roughness(reaction, &noisy)?;
    let reversals = noisy.iter().map(turns).sum();
    Some(MeshNoise { roughness: second.min(fourth), reversals })
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

#[cfg(test)]
mod tests {
    use super::*;

    fn measured(reaction: &[f64], nodes: usize) -> Option<MeshNoise> {
        let motion: Vec<f64> = (1..=reaction.len()).map(|k| k as f64).collect();
        ReactionNoise::of(String::new(), reaction, &motion, |_| nodes).of_mesh
    }

    /// Requirement: a zigzag that a passing mesh explains is its noise, with
    /// its closed form (second differences 4 a, fourth ones 16 a); the same
    /// curve of a contact that stays on its nodes is physics, and so is one
    /// without contact.
    #[test]
    fn noise_of_the_mesh_needs_nodes_that_contact_passes() {
        let zigzag: Vec<f64> = (0..40).map(|k| 1.0 + 0.02 * f64::from(k % 2)).collect();
        let found = measured(&zigzag, 20);
        let expected = 0.04 / 6f64.sqrt() / 1.02;
        assert!(
            found.is_some_and(|n| n.reversals == 38 && (n.roughness / expected - 1.0).abs() < 1e-9)
        );
        assert_eq!(measured(&zigzag, 2), None);
        assert_eq!(measured(&zigzag, 0), None);
    }

    /// Requirement: a snap is no noise at any number of increments, whatever
    /// nodes it passes: up a ramp, over a crest, off the edge, and up again to
    /// nothing. The curve is that of a hook on a tooth, drawn by hand.
    #[test]
    fn a_snap_is_no_noise_however_many_increments_it_has() {
        for count in [8, 12, 20, 37, 80, 200, 1000] {
            let force = |k: usize| match k as f64 / count as f64 {
                s if s < 0.1 => 0.0,
                s if s < 0.5 => s - 0.1,
                s if s < 0.7 => 0.15,
                s if s < 0.9 => 0.9 * (s - 0.9),
                _ => 0.0,
            };
            let snap: Vec<f64> = (0..count).map(force).collect();
            assert_eq!(measured(&snap, 1000), None, "{count} increments");
        }
    }
}
