//! Who overlaps before anything moves, and where that goes.

use crate::finding::Finding;
use crate::start::{Start, spacing};
use slideline_diag::{Code, Diagnostic};
use slideline_model::{ContactPair, NormalLaw, Section};
use slideline_solve::observe::ContactRow;

/// Overclosure that no slide starts from, in contact element lengths [1].
const DEEP: f64 = 0.1;

/// SL0402 and SL0425: slave points that overlap their master at the start.
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    for (place, pair) in start.model.contact_pairs.iter().enumerate() {
        let mut over: Vec<&ContactRow> =
            start.facing(place).filter(|row| row.opening < -1e-9 * start.reach).collect();
        over.sort_by(|a, b| a.opening.total_cmp(&b.opening));
        let Some(deepest) = over.first() else { continue };
        findings.push(Finding::said(match through(start, deepest) {
            Some(thickness) => say_through(start, pair, deepest, thickness),
            None if is_taken_away(start, place) => continue,
            None => say(start, pair, deepest, over.len()),
        }));
    }
}

/// Whether the deck says how the first step takes the overclosure away.
fn is_taken_away(start: &Start<'_>, place: usize) -> bool {
    let first = start.model.steps.first();
    first.is_some_and(|step| step.interferences.iter().any(|own| own.pair == place))
}

/// How thick the part of a slave is along the normal [L], where the slave stands deeper in its
/// master than that.
fn through(start: &Start<'_>, row: &ContactRow) -> Option<f64> {
    if !is_of_solids(start, row) {
        return None; // what beams are thick by is not in the model
    }
    let body = start.bodies.of_node(row.node);
    let own = start.model.nodes.iter().enumerate();
    let own = own.filter(|&(node, _)| start.bodies.of_node(node) == body);
    let along = |at: [f64; 3]| (0..3).map(|k| at[k] * row.normal[k]).sum::<f64>();
    let nothing = (f64::INFINITY, f64::NEG_INFINITY);
    let (low, high) = own.fold(nothing, |(low, high), (_, node)| {
        let at = along(node.position);
        (low.min(at), high.max(at))
    });
    let thickness = high - low;
    (thickness > 1e-6 * start.reach && -row.opening > thickness).then_some(thickness)
}

fn is_of_solids(start: &Start<'_>, row: &ContactRow) -> bool {
    let solids =
        start.model.blocks.iter().filter(|block| matches!(block.section, Section::Solid(_)));
    solids.flat_map(|block| &block.elements).any(|element| element.nodes.contains(&row.node))
}

/// SL0425: a slave that stands in its master deeper than its own part is thick.
fn say_through(
    start: &Start<'_>,
    pair: &ContactPair,
    row: &ContactRow,
    thickness: f64,
) -> Diagnostic {
    let message = format!(
        "node {} of {} stands {:.4e} deep in the master, and its own part is only {thickness:.4e} \
         thick there: it would be pressed out the wrong way, or not at all",
        start.model.nodes.name(row.node),
        pair.name,
        -row.opening
    );
    Diagnostic::warning(Code("SL0425"), message).at(pair.origin).help(
        "is one part in the wrong place, or does a surface name the faces on its far side? Check \
         *NODE and *SURFACE",
    )
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
