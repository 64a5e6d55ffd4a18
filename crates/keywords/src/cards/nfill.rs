//! `*NFILL`: nodes between the nodes of two sets.

use slideline_deck::{DataLine, normalise};
use slideline_diag::{Code, Diagnostic};

use crate::draft::Draft;
use crate::finish::unknown_set;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::sets::Item;

/// `*NFILL`.
pub(crate) struct Nfill;

impl Keyword for Nfill {
    fn name(&self) -> &'static str {
        "NFILL"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::value("NSET")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Nodes
    }

    fn page(&self) -> &'static str {
        page!("NFILL")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if card.first_line("first set, last set, intervals, increment", &mut draft.log).is_none() {
            return;
        }
        let set = card.name("NSET");
        if let Some(set) = &set {
            draft.node_sets.open(set, card.span());
        }
        for line in card.data() {
            fill(line, set.as_deref(), draft);
        }
    }
}

/// Nodes in equal distances between the nodes of two sets, both in ascending order; the ends join
/// the set too.
fn fill(line: &DataLine, set: Option<&str>, draft: &mut Draft) -> Option<()> {
    draft.log.at_most(line, 4);
    let first = bound(line, 0, draft)?;
    let last = bound(line, 1, draft)?;
    let count = positive(line, 2, draft)?;
    let step = positive(line, 3, draft)?;
    if first.len() != last.len() {
        let message =
            format!("the first set has {} nodes, the last one {}", first.len(), last.len());
        draft.log.error("SL0226", message, line.span);
        return None;
    }
    let new = first.len() as u128 * u128::from(count - 1);
    if !draft.reserve(new, "nodes", line.span) {
        return None;
    }
    for ((a, start), (b, end)) in first.into_iter().zip(last) {
        for k in 0..=count {
            let label = if k == count { b } else { draft.further(a, step, k, line.span)? };
            if let Some(set) = set {
                draft.node_sets.join(set, Item::One(label), line.span);
            }
            if k > 0 && k < count {
                #[allow(clippy::cast_precision_loss)] // far below 2^53
                let part = k as f64 / count as f64;
                let place = [0, 1, 2].map(|axis| start[axis] + (end[axis] - start[axis]) * part);
                draft.add_node(label, place, line.span, true);
            }
        }
    }
    Some(())
}

/// Numbers and places of the nodes of a set, ascending.
fn bound(line: &DataLine, at: usize, draft: &mut Draft) -> Option<Vec<(u64, [f64; 3])>> {
    let Some(field) = line.field(at) else {
        draft.log.error("SL0119", "the node set is missing", line.span);
        return None;
    };
    let name = normalise(&field.text);
    let Some(mut labels) = draft.node_sets.labels(&name) else {
        let names = draft.node_sets.names().take(draft.log.names_to_compare());
        let error = unknown_set("node", &name, field.span, names);
        draft.log.push(error);
        return None;
    };
    labels.sort_unstable();
    let mut nodes = Vec::with_capacity(labels.len());
    for label in labels {
        let Some(index) = draft.model.nodes.find(label) else {
            let message = format!("node {label} is not defined yet");
            let error = Diagnostic::error(Code("SL0225"), message).at(field.span);
            draft.log.push(error.help("*NFILL uses the coordinates stored when it is read"));
            return None;
        };
        nodes.push((label, draft.model.nodes.position(index)));
    }
    Some(nodes)
}

fn positive(line: &DataLine, at: usize, draft: &mut Draft) -> Option<u64> {
    let value = draft.log.integer_or(line, at, 1)?;
    let found = u64::try_from(value).ok().filter(|&value| value > 0);
    if found.is_none() {
        draft.log.error("SL0226", format!("{value} must be positive"), line.fields[at].span);
    }
    found
}
