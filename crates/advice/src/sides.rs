//! Normals that look the wrong way.

use crate::finding::{Finding, Place};
use crate::start::{Start, spacing};
use slideline_diag::{Code, Diagnostic};
use slideline_model::{ContactPair, Master, SlideLine};
use std::fmt::Write as _;

/// SL0407: most slaves lie deeper behind their master than a contact element
/// is long. [semantics: wrong side]
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    for (place, pair) in start.model.contact_pairs.iter().enumerate() {
        let spacing = spacing(start.model, pair);
        let facing = start.facing(place).count();
        let behind = start.facing(place).filter(|row| row.opening < -spacing).count();
        if behind > 0 && 2 * behind >= facing {
            findings.push(say(start, pair, behind, facing));
        }
    }
}

fn say(start: &Start<'_>, pair: &ContactPair, behind: usize, facing: usize) -> Finding {
    let (origin, help) = match &pair.master {
        Master::SlideLine(line) => (
            line.origin,
            "list the nodes of *SLIDE LINE in the opposite order: the outward normal stands 90 \
             degrees counter-clockwise of travel",
        ),
        Master::RigidSurface(surface) => (
            surface.origin,
            "give the points of *RIGID SURFACE in the opposite order: the outward normal stands \
             90 degrees counter-clockwise of travel",
        ),
    };
    let message = format!(
        "the master of {} seems to look the wrong way: {behind} of {facing} slave points lie \
         behind it, deeper than a contact element is long",
        pair.name
    );
    let said = Diagnostic::warning(Code("SL0407"), message).at(origin).help(help);
    match &pair.master {
        Master::SlideLine(line) if line.origin != pair.origin || pair.name.is_ascii() => {
            Finding::with(said, Place::Instead(line.origin), reversed(start, pair, line))
        }
        _ => Finding::said(said),
    }
}

/// The slide line's card with its nodes in opposite order.
fn reversed(start: &Start<'_>, pair: &ContactPair, line: &SlideLine) -> String {
    let mut text = format!(
        "*SLIDE LINE, TYPE=LINEAR, ELSET={}, SMOOTH={:?}, EXTENSION ZONE={:?}\n",
        pair.name, line.smooth, line.extension
    );
    let nodes: Vec<String> =
        line.nodes.iter().rev().map(|&node| start.model.nodes.label(node).to_string()).collect();
    for row in nodes.chunks(16) {
        let _ = writeln!(text, "{}", row.join(", ")); // a String takes any text
    }
    text
}
