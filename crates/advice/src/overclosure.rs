//! Who overlaps before anything moves, and where that goes.

use crate::finding::Finding;
use crate::start::{Start, spacing};
use slideline_diag::{Code, Diagnostic};
use slideline_model::{ContactPair, NormalLaw};
use slideline_solve::observe::ContactRow;

/// Overclosure that no slide starts from, in contact element lengths [1].
const DEEP: f64 = 0.1;

/// SL0402: slave points that overlap their master at the start.
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    for (place, pair) in start.model.contact_pairs.iter().enumerate() {
        let mut over: Vec<&ContactRow> =
            start.facing(place).filter(|row| row.opening < -1e-9 * start.reach).collect();
        over.sort_by(|a, b| a.opening.total_cmp(&b.opening));
        if let Some(deepest) = over.first() {
            findings.push(Finding::said(say(start, pair, deepest, over.len())));
        }
    }
}

fn say(start: &Start<'_>, pair: &ContactPair, deepest: &ContactRow, count: usize) -> Diagnostic {
    let depth = -deepest.opening;
    let against = match pair.interaction.normal {
        NormalLaw::Exponential { clearance, .. }
        | NormalLaw::CalculixExponential { clearance, .. } => {
            format!(", {:.3} times c0 = {clearance:e}", depth / clearance)
        }
        _ => String::new(),
    };
    let message = format!(
        "{count} slave point{} of {} overlap{} the master in the undeformed model: node {} by \
         {depth:.4e}{against}; the first increment resolves it with strain",
        if count == 1 { "" } else { "s" },
        pair.name,
        if count == 1 { "s" } else { "" },
        start.model.nodes.name(deepest.node),
    );
    let small = match pair.interaction.normal {
        NormalLaw::Exponential { clearance, .. }
        | NormalLaw::CalculixExponential { clearance, .. } => 3.0 * clearance,
        _ => 1e-6 * start.reach,
    };
    let said = if depth > small.max(DEEP * spacing(start.model, pair)) {
        Diagnostic::warning(Code("SL0402"), message)
    } else {
        Diagnostic::advice(Code("SL0402"), message)
    };
    said.at(pair.origin).help(
        "if the overlap is not intended, move one body in *NODE so that the parts only touch; an \
         overlap is never removed silently",
    )
}
