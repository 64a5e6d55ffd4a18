//! Three rigidly linked slaves on one straight segment under hard contact.
//!
//! ```text
//!      o . o . o     the link keeps them on their arc,
//!   ---o---o---o---  hard contact wants them on the line: no solution
//! ```

use crate::finding::{Finding, Place};
use crate::start::{Start, arc_of, length, less, spacing};
use slideline_diag::{Code, Diagnostic};
use slideline_model::{ContactPair, Formulation, Master, NodeIndex, NormalLaw, SurfaceSegment};

/// SL0404: hard contact of a rigid row of slaves with straight segments.
/// Diehl (1995), section 2.0.
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    for pair in &start.model.contact_pairs {
        if pair.interaction.normal != NormalLaw::Hard
            || pair.formulation == Formulation::SurfaceToSurface
        {
            continue;
        }
        if let Some((nodes, sagitta)) = three(start, pair, straight(start, pair)) {
            findings.push(say(start, pair, nodes, sagitta));
        }
    }
}

/// Length of the longest straight segment of the master [L].
fn straight(start: &Start<'_>, pair: &ContactPair) -> f64 {
    let at = |node| start.model.nodes.position(node);
    match &pair.master {
        // their slaves are faces, in no order
        Master::Faces(_) | Master::Itself(_) => 0.0,
        Master::SlideLine(line) => {
            let sides = line.nodes.windows(2).map(|w| length(less(at(w[1]), at(w[0]))));
            sides.fold(0.0, f64::max)
        }
        Master::RigidSurface(surface) => {
            let mut from = surface.start;
            let mut longest: f64 = 0.0;
            for segment in &surface.segments {
                if let SurfaceSegment::Line { end } = *segment {
                    longest = longest.max((end[0] - from[0]).hypot(end[1] - from[1]));
                }
                from = segment.end();
            }
            longest
        }
    }
}

/// Three neighbouring slaves of one rigid body that fit on a segment of the
/// length `straight`, and how far the middle one stands off their chord [L].
fn three(start: &Start<'_>, pair: &ContactPair, straight: f64) -> Option<([NodeIndex; 3], f64)> {
    let at = |node| start.model.nodes.position(node);
    pair.elements.windows(2).find_map(|both| {
        let [first, second] = [both[0].nodes, both[1].nodes];
        let nodes = if first[1] == second[0] {
            [first[0], first[1], second[1]]
        } else {
            [second[0], first[0], first[1]] // listed the other way round
        };
        let body = start.bodies.rigid_with(nodes[0])?;
        let linked = nodes.iter().all(|&node| start.bodies.rigid_with(node) == Some(body));
        let chord = length(less(at(nodes[2]), at(nodes[0])));
        let neighbours = first[1] == second[0] || second[1] == first[0];
        if !neighbours || !linked || chord > straight {
            return None;
        }
        let radius = arc_of(start.model, pair, nodes[1]).map(|(_, radius)| radius);
        Some((nodes, radius.map_or(0.0, |radius| chord * chord / (8.0 * radius))))
    })
}

fn say(start: &Start<'_>, pair: &ContactPair, nodes: [NodeIndex; 3], sagitta: f64) -> Finding {
    let [a, b, c] = nodes.map(|node| start.model.nodes.name(node));
    let what = match &pair.master {
        Master::SlideLine(_) => "slide line",
        Master::RigidSurface(_) => "rigid surface",
        Master::Faces(_) | Master::Itself(_) => "surface",
    };
    let message = format!(
        "hard contact and rigid links can contradict each other: slaves {a}, {b} and {c} of {} fit \
         on one straight segment of the {what}, but their rigid body keeps the middle one \
         {sagitta:.3e} off that line",
        pair.name
    );
    let clearance = sagitta.max(1e-2 * spacing(start.model, pair));
    let pressure = pressure_scale(start, pair);
    let words = pair.vocabulary;
    let card = words.softened_card(clearance, pressure);
    let said = Diagnostic::warning(Code("SL0404"), message)
        .at(pair.interaction.origin)
        .help(format!("soften the contact: {} after {}", words.softened(), words.interaction()));
    Finding::with(said, Place::After(pair.interaction.origin), card)
}

/// A pressure of the order of contact pressures: a thousandth of the modulus.
fn pressure_scale(start: &Start<'_>, pair: &ContactPair) -> f64 {
    let materials = start.model.blocks.iter().filter_map(|block| block.section.elastic());
    let modulus = materials.map(|material| material.modulus).fold(0.0, f64::max);
    let scale = if modulus > 0.0 { 1e-3 * modulus } else { 1.0 };
    scale * (start.reach / (start.reach + pair.interaction.width.abs())).max(0.1)
}
