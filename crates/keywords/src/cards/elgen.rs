//! `*ELGEN`: elements repeated in rows.

use slideline_deck::DataLine;
use slideline_diag::{Code, Diagnostic, Span};

use crate::draft::Draft;
use crate::draft::{Element, ElementKind};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::log::MAX_LABEL;
use crate::reading::Reading;
use crate::sets::Item;

/// `*ELGEN`.
pub(crate) struct Elgen;

impl Keyword for Elgen {
    fn name(&self) -> &'static str {
        "ELGEN"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::value("ELSET"), Rule::flag("ALL NODES")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Elements
    }

    fn page(&self) -> &'static str {
        page!("ELGEN")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let set = card.name("ELSET");
        if let Some(set) = &set {
            draft.element_sets.open(set, card.span());
        }
        for line in card.data() {
            if let Some(pattern) = pattern(line, draft) {
                generate(&pattern, card.has("ALL NODES"), set.as_deref(), draft);
            }
        }
    }
}

/// One direction of repetition.
#[derive(Clone, Copy)]
struct Row {
    count: i64,
    nodes: i64,
    elements: i64,
}

struct Pattern {
    master: Element,
    rows: [Row; 3],
    span: Span,
}

fn pattern(line: &DataLine, draft: &mut Draft) -> Option<Pattern> {
    draft.log.at_most(line, 10);
    let label = draft.log.label(line, 0, "the master element")?;
    let mut rows = [Row { count: 1, nodes: 0, elements: 0 }; 3];
    for (k, row) in rows.iter_mut().enumerate() {
        let at = 1 + 3 * k;
        row.count = draft.log.integer_or(line, at, 1)?;
        row.nodes = increment(line, at + 1, draft)?;
        row.elements = increment(line, at + 2, draft)?;
        if row.count < 1 {
            let span = line.fields[at].span;
            draft.log.error("SL0210", "a row has at least one element", span);
            return None;
        }
    }
    let total =
        rows.iter().map(|row| u128::from(row.count.unsigned_abs())).fold(1, u128::saturating_mul);
    if !draft.reserve(total - 1, "elements", line.span) {
        return None;
    }
    let Some(&index) = draft.element_by_label.get(&label) else {
        if draft.is_complete(Subject::Elements) {
            let message = format!("element {label} is not defined yet");
            let error = Diagnostic::error(Code("SL0230"), message).at(line.fields[0].span);
            draft.log.push(error.help("*ELGEN repeats an element that *ELEMENT defined before"));
        }
        return None;
    };
    draft.element_by_label.reserve(usize::try_from(total - 1).unwrap_or(0));
    Some(Pattern { master: draft.elements[index], rows, span: line.span })
}

/// An increment: 1 by default, and not beyond the largest number.
fn increment(line: &DataLine, at: usize, draft: &mut Draft) -> Option<i64> {
    let value = draft.log.integer_or(line, at, 1)?;
    if value.abs() > MAX_LABEL {
        let message = format!("an increment of {value} leads beyond the largest number");
        draft.log.error("SL0224", message, line.fields[at].span);
        return None;
    }
    Some(value)
}

/// Element e + i de_1 + j de_2 + k de_3 on nodes n + i dn_1 + j dn_2 + k dn_3;
/// the reference node of an IRS element stays, unless all nodes are asked
/// for. [semantics: deck language, *ELGEN]
fn generate(pattern: &Pattern, all_nodes: bool, set: Option<&str>, draft: &mut Draft) {
    let [a, b, c] = pattern.rows;
    for k in 0..c.count {
        for j in 0..b.count {
            for i in 0..a.count {
                let nodes = i * a.nodes + j * b.nodes + k * c.nodes;
                let elements = i * a.elements + j * b.elements + k * c.elements;
                let first = (i, j, k) == (0, 0, 0);
                if !one(pattern, [elements, nodes], (first, all_nodes), set, draft) {
                    return;
                }
            }
        }
    }
}

/// One copy, moved by [elements, nodes]. False where it has no valid number.
fn one(
    pattern: &Pattern,
    [elements, nodes]: [i64; 2],
    (first, all_nodes): (bool, bool),
    set: Option<&str>,
    draft: &mut Draft,
) -> bool {
    let mut copy = Element { origin: pattern.span, ..pattern.master };
    let moved =
        if copy.kind == ElementKind::Irs21 && !all_nodes { 2 } else { copy.kind.node_count() };
    let mut valid = shift(&mut copy.label, elements);
    for node in copy.nodes.iter_mut().take(moved) {
        valid &= shift(node, nodes);
    }
    if !valid {
        let message =
            format!("the copies of element {} run out of valid numbers", pattern.master.label);
        draft.log.error("SL0224", message, pattern.span);
        return false;
    }
    if let Some(set) = set {
        draft.element_sets.join(set, Item::One(copy.label), pattern.span);
    }
    if !first {
        draft.add_element(copy);
    }
    true
}

fn shift(label: &mut u64, by: i64) -> bool {
    let moved = label.checked_add_signed(by);
    *label = moved.unwrap_or(0);
    moved.is_some_and(|new| new >= 1 && new <= MAX_LABEL.unsigned_abs())
}
