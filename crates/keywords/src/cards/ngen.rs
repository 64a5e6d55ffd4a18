//! `*NGEN`: nodes between two nodes.

use slideline_deck::DataLine;
use slideline_diag::{Code, Diagnostic, Span};

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::sets::Item;

/// `*NGEN`.
pub(crate) struct Ngen;

impl Keyword for Ngen {
    fn name(&self) -> &'static str {
        "NGEN"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::value("NSET"), Rule::value("LINE")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Nodes
    }

    fn page(&self) -> &'static str {
        page!("NGEN")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if card.has("LINE") {
            let message = "*NGEN, LINE= is not supported: nodes are generated on straight lines";
            draft.log.error("SL0221", message, card.span_of("LINE"));
        }
        let set = card.name("NSET");
        if let Some(set) = &set {
            draft.node_sets.open(set, card.span());
        }
        for line in card.data() {
            draft.log.at_most(line, 3);
            if let Some(row) = row(line, draft) {
                generate(&row, set.as_deref(), draft);
            }
        }
    }
}

/// A line of `*NGEN`, checked: `count` intervals between `first` and `last`.
struct Row {
    first: u64,
    last: u64,
    step: u64,
    count: u64,
    ends: [[f64; 3]; 2],
    span: Span,
}

fn row(line: &DataLine, draft: &mut Draft) -> Option<Row> {
    let first = draft.log.label(line, 0, "the first node")?;
    let last = draft.log.label(line, 1, "the last node")?;
    let step = draft.log.integer_or(line, 2, 1)?.unsigned_abs();
    if step == 0 || first.abs_diff(last) % step != 0 {
        let message = format!("{first} to {last} is not a whole number of increments of {step}");
        draft.log.error("SL0226", message, line.span);
        return None;
    }
    let ends = [end(first, 0, line, draft), end(last, 1, line, draft)];
    let [Some(a), Some(b)] = ends else { return None };
    let count = first.abs_diff(last) / step;
    let new = u128::from(count.saturating_sub(1));
    let fits = draft.reserve(new, "nodes", line.span);
    fits.then_some(Row { first, last, step, count, ends: [a, b], span: line.span })
}

fn end(label: u64, at: usize, line: &DataLine, draft: &mut Draft) -> Option<[f64; 3]> {
    let index = draft.model.nodes.find(label);
    if index.is_none() && draft.is_complete(Subject::Nodes) {
        let message = format!("node {label} is not defined yet");
        let error = Diagnostic::error(Code("SL0225"), message).at(line.fields[at].span);
        draft.log.push(error.help("*NGEN uses the coordinates stored when it is read"));
    }
    index.map(|index| draft.model.nodes.get(index).position)
}

/// Nodes at equal distances: x_k = x_a + (x_b - x_a) k/n, ends included in
/// the set. [semantics: deck language, *NGEN]
fn generate(row: &Row, set: Option<&str>, draft: &mut Draft) {
    let [a, b] = row.ends;
    let step = row.step;
    for k in 0..=row.count {
        let label = if row.last >= row.first { row.first + k * step } else { row.first - k * step };
        if let Some(set) = set {
            draft.node_sets.join(set, Item::One(label), row.span);
        }
        if k == 0 || k == row.count {
            continue;
        }
        #[allow(clippy::cast_precision_loss)] // far below 2^53
        let part = k as f64 / row.count as f64;
        let between = |axis: usize| a[axis] + (b[axis] - a[axis]) * part;
        draft.add_node(label, [between(0), between(1), between(2)], row.span, true);
    }
}
