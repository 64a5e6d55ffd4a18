//! A rigid curved body on a coarse flexible chain: how noisy will it be?
//!
//! ```text
//!        ( r )        the slave node that touches is up to l/2 beside the
//!     o---`-'o---o    tangent point: its normal tilts by up to l/(2r)
//!         l
//! ```
//!
//! The tangent point wanders evenly over the element, so that the tilt has the
//! root mean square l/(2 sqrt(3) r) where one node carries at a time; a soft
//! law that spreads the load over several nodes takes some of it away.

use crate::finding::Finding;
use crate::start::{Start, circle_of, spacing};
use slideline_diag::{Code, Diagnostic};
use slideline_model::{ContactPair, ElementBlock, Formulation, NodeIndex, NormalLaw};

/// Root mean square tilt of the normal below which nobody sees the noise [1].
const QUIET: f64 = 0.002;
/// Places of the tangent point between two nodes at which the tilt is found.
const PLACES: usize = 32;
/// Overclosure at which a softened law usually works, in c0 [1]: p0 is the
/// largest pressure a deck reckons with, most of a stroke goes below it.
const WORKING: f64 = -0.5;

/// SL0403: slaves on a flexible chain against a convex rigid circle, so far
/// apart that the sliding force is noisy. [verification: metrics and expectations]
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    for pair in &start.model.contact_pairs {
        if let (Formulation::NodeToSurface, Some((_, radius))) = (pair.formulation, circle_of(pair))
        {
            let flexible =
                pair.slave_nodes().iter().any(|&node| start.bodies.dependent[node].is_none());
            let spacing = spacing(start.model, pair);
            let tilt = spacing / (2.0 * radius);
            let rms = rms_tilt(&pair.interaction.normal, spacing, radius);
            if flexible && rms > QUIET && slides(start, pair) {
                findings.push(Finding::said(say(pair, [radius, spacing], [tilt, rms])));
            }
        }
    }
}

/// Root mean square of the tilt of the contact force [1] while a circle of
/// `radius` slides over nodes `spacing` apart under a constant load.
pub fn rms_tilt(law: &NormalLaw, spacing: f64, radius: f64) -> f64 {
    let alone = spacing / (2.0 * radius * 3f64.sqrt());
    let NormalLaw::Exponential { clearance, .. } = *law else { return alone };
    let pressure = |h: f64| law.pressure(h).map_or(0.0, |(pressure, _)| pressure);
    // nodes within twice the reach of the law, beside a place `off` of the tangent point
    let count = ((8.0 * radius * clearance).sqrt() / spacing).ceil().min(1e3) as i32 + 1;
    let sums = |deep: f64, off: f64| {
        let nodes = (-count..=count).map(|k| f64::from(k) * spacing - off);
        nodes.fold((0.0, 0.0), |(force, moment), s| {
            let p = pressure(deep - s * s / (2.0 * radius));
            (force + p, moment + p * s)
        })
    };
    let load = sums(WORKING * clearance, 0.0).0;
    let squares: f64 = (0..PLACES)
        .map(|k| {
            let off = ((k as f64 + 0.5) / PLACES as f64 - 0.5) * spacing;
            // the node beside it must be able to carry all of the load
            let (mut low, mut high) = (-clearance, spacing * spacing / (8.0 * radius));
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if sums(middle, off).0 < load { low = middle } else { high = middle }
            }
            let (force, moment) = sums(high, off);
            (moment / (force * radius)).powi(2)
        })
        .sum();
    (squares / PLACES as f64).sqrt()
}

/// Whether contact wanders over an elastic chain of slaves: beams or solids that have a slave and
/// the nodes of a contact element between two of them.
fn slides(start: &Start<'_>, pair: &ContactPair) -> bool {
    let elastic = |block: &&ElementBlock| block.kind.joins() && block.kind.cell.dimension > 0;
    let slaves = pair.slave_nodes();
    let has = |nodes: &[NodeIndex], node: &NodeIndex| nodes.contains(node);
    start.model.blocks.iter().filter(elastic).flat_map(|block| &block.elements).any(|element| {
        slaves.iter().any(|slave| has(element.nodes, slave))
            && pair.elements.iter().any(|own| own.nodes.iter().all(|node| has(element.nodes, node)))
    })
}

fn say(pair: &ContactPair, [radius, spacing]: [f64; 2], [tilt, rms]: [f64; 2]) -> Diagnostic {
    let [_, friction] = pair.interaction.friction.coefficients();
    let message = format!(
        "slave nodes of {} are {spacing:.4e} apart and touch a circle of radius {radius:.4e}: the \
         contact normal tilts by up to l/(2r) = {tilt:.3} rad, so the sliding force will be noisy \
         by {:.2} % of the contact force (root mean square) and by up to {:.1} %; of the driving \
         force it is that divided by (sin of the contact angle + {friction})",
        pair.name,
        100.0 * rms,
        100.0 * tilt
    );
    Diagnostic::advice(Code("SL0403"), message).at(pair.origin).help(format!(
        "{}, or {}",
        pair.vocabulary.swap_roles(),
        pair.vocabulary.integrate()
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: one node at a time tilts by l/(2 sqrt(3) r) (mean square
    /// of an even distribution); a law that reaches over many nodes leaves
    /// next to nothing of it.
    #[test]
    fn the_tilt_of_coarse_nodes_is_that_of_an_even_distribution() {
        let law = NormalLaw::Exponential { clearance: 1e-5, pressure: 4.8e6 };
        let even = |spacing: f64| spacing / (2.0 * 9e-3 * 3f64.sqrt());
        assert_eq!(rms_tilt(&NormalLaw::Hard, 2e-3, 9e-3), even(2e-3));
        // near the middle between two nodes both carry: a few hundredths
        assert!((rms_tilt(&law, 2e-3, 9e-3) / even(2e-3) - 1.0).abs() < 0.1);
        assert!(rms_tilt(&law, 1e-4, 9e-3) < 0.05 * even(1e-4));
    }
}
