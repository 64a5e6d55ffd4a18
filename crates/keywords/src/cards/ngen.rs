//! `*NGEN`: nodes between two nodes.

use slideline_deck::DataLine;
use slideline_diag::{Code, Diagnostic, Span};

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::paths::{Arc, Path};
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
        let line_of = card.choice("LINE", &["P", "C"], &mut draft.log);
        if card.has("LINE") && line_of.is_none() {
            return;
        }
        let set = card.name("NSET");
        if let Some(set) = &set {
            draft.node_sets.open(set, card.span());
        }
        for line in card.data() {
            draft.log.at_most(line, if line_of.is_some() { 10 } else { 3 });
            let Some(row) = row(line, draft) else { continue };
            let Some(path) = path(line_of, line, &row, draft) else { continue };
            generate(&row, &path, set.as_deref(), draft);
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

/// The line on which nodes are generated.
fn path(kind: Option<&str>, line: &DataLine, row: &Row, draft: &mut Draft) -> Option<Path> {
    let [a, b] = row.ends;
    let Some(kind) = kind else { return Some(Path::Straight(a, b)) };
    let extra = match line.field(3) {
        Some(_) => {
            let label = draft.log.label(line, 3, "the extra point")?;
            end(label, 3, line, draft)?
        }
        None => place(line, 4, draft)?,
    };
    if kind == "P" {
        return Some(Path::Parabola(a, extra, b));
    }
    let normal = match line.fields.len() > 7 {
        true => Some(place(line, 7, draft)?),
        false => None,
    };
    let arc = Arc::through(a, b, extra, normal);
    if arc.is_none() {
        let message = "these points make no arc: an end is at the centre, or they are in one line";
        let error = Diagnostic::error(Code("SL0232"), message).at(line.span);
        draft.log.push(error.help(
            "an arc of 180 degrees or more needs its axis, the 8th to 10th number: nodes go round \
             it by the right hand",
        ));
    }
    arc.map(Path::Arc)
}

fn place(line: &DataLine, from: usize, draft: &mut Draft) -> Option<[f64; 3]> {
    let mut at = [0.0; 3];
    for (k, value) in at.iter_mut().enumerate() {
        *value = draft.log.number_or(line, from + k, 0.0)?;
    }
    Some(at)
}

/// Nodes at equal steps along their line, ends included in the set. [semantics: deck language,
/// *NGEN]
fn generate(row: &Row, path: &Path, set: Option<&str>, draft: &mut Draft) {
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
        draft.add_node(label, path.at(part), row.span, true);
    }
}
