//! Solids that are there twice, or begin in one another and no contact sees it.

use crate::corners::corners;
use crate::finding::Finding;
use crate::standing_in::{StandingIn, present};
use crate::start::Start;
use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{Model, NodeIndex};
use slideline_solve::observe::ContactRow;
use std::collections::HashMap;

/// Overclosure that counts, in sizes of the model [1].
const OVERCLOSED: f64 = 1e-9;

/// SL0411: solids that are there twice, and bodies that stand in one another where no contact sees it.
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    findings.extend(twice(start.model));
    let is_overclosed = |row: &&ContactRow| row.opening < -OVERCLOSED * start.reach;
    let overclosed: Vec<&ContactRow> = start.points.iter().filter(is_overclosed).collect();
    let is_seen = |own: &StandingIn| {
        let of_both = |row: &&&ContactRow| own.bodies.contains(&start.bodies.of_node(row.node));
        let mut pairs = overclosed.iter().filter(of_both).map(|row| row.pair).collect::<Vec<_>>();
        pairs.dedup();
        pairs.iter().any(|&pair| start.brings(&start.model.contact_pairs[pair], own.bodies))
    };
    let unseen: Vec<&StandingIn> = start.standing_in.iter().filter(|own| !is_seen(own)).collect();
    let first = unseen.first().map(|own| Finding::said(say(own, unseen.len() - 1, start.model)));
    findings.extend(first);
}

fn say(own: &StandingIn, others: usize, model: &Model) -> Diagnostic {
    let more = match others {
        0 => String::new(),
        others => format!(" (and {others} more pairs of bodies)"),
    };
    let message = format!(
        "solid {} stands in solid {} of another body{more}: the bodies begin in one another, no contact sees \
         it, and they pass through one another",
        own.inner.0, own.outer
    );
    let said = match model.contact_pairs.is_empty() {
        true => Diagnostic::advice(Code("SL0411"), message),
        false => Diagnostic::warning(Code("SL0411"), message),
    };
    said.at(own.inner.1).help(
        "is one part in the wrong place or in another unit? Move it in *NODE or *INSTANCE, so that the \
         parts only touch or overlap by what is meant; what is one part should be joined by *TIE",
    )
}

/// SL0411: a solid on the same corners as another one.
fn twice(model: &Model) -> Option<Finding> {
    let mut known: HashMap<Vec<NodeIndex>, u64> = HashMap::new();
    let mut found: Option<(u64, u64, Span)> = None;
    let mut count = 0;
    for (block, element) in present(model) {
        let cell = block.kind.cell;
        let Some(corners) = corners(cell.dimension, cell.nodes).map(<[_]>::len) else { continue };
        let mut nodes = element.nodes[..corners].to_vec();
        nodes.sort_unstable();
        if let Some(first) = known.insert(nodes, element.label) {
            count += 1;
            found.get_or_insert((first, element.label, element.origin));
        }
    }
    let (first, second, origin) = found?;
    let more = if count > 1 { format!(" (and {} more)", count - 1) } else { String::new() };
    let message = format!(
        "solids {first} and {second} have the same corners{more}: their stiffness counts twice"
    );
    let said = Diagnostic::warning(Code("SL0411"), message).at(origin);
    Some(Finding::said(said.help("remove one of them from *ELEMENT")))
}
