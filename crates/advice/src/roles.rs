//! A rigid curved body on a coarse flexible chain: how noisy will it be?
//!
//! ```text
//!        ( r )        the slave node that touches is up to l/2 beside the
//!     o---`-'o---o    tangent point: its normal tilts by up to l/(2r)
//!         l
//! ```

use crate::finding::Finding;
use crate::start::{Start, circle_of, spacing};
use slideline_diag::{Code, Diagnostic};
use slideline_model::{ContactPair, Formulation, Friction, NormalLaw};

/// Tilt of the normal below which nobody sees the noise [1].
const QUIET: f64 = 0.01;

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
            if flexible && tilt > QUIET && spacing > patch(pair, radius) && slides(start, pair) {
                findings.push(Finding::said(say(pair, radius, spacing, tilt)));
            }
        }
    }
}

/// Half-width of the zone that a softened law spreads contact over [L].
fn patch(pair: &ContactPair, radius: f64) -> f64 {
    match pair.interaction.normal {
        NormalLaw::Exponential { clearance, .. }
        | NormalLaw::CalculixExponential { clearance, .. } => (2.0 * radius * clearance).sqrt(),
        _ => 0.0,
    }
}

/// Whether the chain can bend between its slaves: more than two of them.
fn slides(start: &Start<'_>, pair: &ContactPair) -> bool {
    let on_beams = |node| {
        let mut beams = start.model.blocks.iter().filter_map(|block| block.beams());
        let has = |e: &slideline_model::BeamElement, node| e.nodes.contains(&node);
        beams.any(|block| {
            block.elements.iter().any(|e| {
                has(e, node) && pair.elements.iter().any(|c| c.nodes.iter().all(|&n| has(e, n)))
            })
        })
    };
    pair.slave_nodes().into_iter().any(on_beams)
}

fn say(pair: &ContactPair, radius: f64, spacing: f64, tilt: f64) -> Diagnostic {
    let friction = match pair.interaction.friction {
        Friction::Coulomb { coefficient, .. } => coefficient,
        _ => 0.0,
    };
    let message = format!(
        "slave nodes of {} stand {spacing:.4e} apart against a circle of radius {radius:.4e}: the \
         contact normal tilts by up to l/(2r) = {tilt:.3} rad, so the sliding force will be noisy \
         by up to {tilt:.3} of the contact force (relative: {tilt:.3}/(sin of the contact angle + \
         {friction}))",
        pair.name
    );
    Diagnostic::advice(Code("SL0403"), message).at(pair.origin).help(
        "let the curved body carry the slaves and the beam be the *SLIDE LINE (ISL21), or \
         integrate contact along the beam: *CONTACT PAIR, TYPE=SURFACE TO SURFACE",
    )
}
