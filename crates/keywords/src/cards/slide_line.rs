//! `*SLIDE LINE`: chain of master nodes.

use std::collections::HashMap;

use slideline_deck::{DataLine, parse_integer, parse_number};
use slideline_diag::{Code, Diagnostic, Span};

use crate::draft::Draft;
use crate::draft::{Owner, Shape, Surface};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*SLIDE LINE`.
pub(crate) struct SlideLine;

impl Keyword for SlideLine {
    fn name(&self) -> &'static str {
        "SLIDE LINE"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::required("ELSET"),
            Rule::value("TYPE"),
            Rule::value("SMOOTH"),
            Rule::value("EXTENSION ZONE"),
            Rule::flag("GENERATE"),
        ];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Contact
    }

    fn page(&self) -> &'static str {
        page!("SLIDE-LINE")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if let Some("PARABOLIC") = card.choice("TYPE", &["LINEAR", "PARABOLIC"], &mut draft.log) {
            let message = "*SLIDE LINE, TYPE=PARABOLIC is not supported: LINEAR only";
            draft.log.error("SL0221", message, card.span_of("TYPE"));
        }
        if !card.has("SMOOTH") {
            let message = "SMOOTH is absent: the corners of this slide line stay sharp";
            let note = Diagnostic::note(Code("SL0239"), message).at(card.span());
            draft.log.push(note.help("SMOOTH=0.25 rounds them over a quarter of each segment"));
        }
        let smooth = smooth(card, draft).unwrap_or(0.0);
        let extension = extension(card, draft);
        let Some(set) = card.name("ELSET") else { return };
        if card.first_line("the master nodes", &mut draft.log).is_none() {
            return;
        }
        let mut nodes = Vec::new();
        for line in card.data() {
            if !stray_number(line, draft) {
                take_line(line, card.has("GENERATE"), &mut nodes, draft);
            }
        }
        repeated(&nodes, draft);
        let set_span = card.span_of("ELSET");
        let shape = Shape::Line { nodes, smooth, extension };
        draft.surfaces.push(Surface { set, set_span, shape, origin: card.span() });
    }
}

/// The fraction of each segment that a corner takes, `SMOOTH`; `None` where it is absent or wrong.
pub(crate) fn smooth(card: &Reading<'_>, draft: &mut Draft) -> Option<f64> {
    let value = card.number("SMOOTH", &mut draft.log)??;
    if !(0.0..0.5).contains(&value) {
        let message = format!("SMOOTH={value} is not at least 0 and less than 0.5");
        draft.log.error("SL0238", message, card.span_of("SMOOTH"));
        return None;
    }
    Some(value)
}

/// The prolongation of open ends, as a fraction of the end segments.
pub(crate) fn extension(card: &Reading<'_>, draft: &mut Draft) -> f64 {
    const DEFAULT: f64 = 0.1;
    let Some(value) = card.number("EXTENSION ZONE", &mut draft.log) else { return DEFAULT };
    let value = value.unwrap_or(DEFAULT);
    if !(0.0..=0.2).contains(&value) {
        let message = format!("EXTENSION ZONE={value} is not between 0 and 0.2");
        draft.log.error("SL0238", message, card.span_of("EXTENSION ZONE"));
        return DEFAULT;
    }
    value
}

/// A lone real number among node numbers: the width of an `*INTERFACE` whose
/// keyword line is missing, never a node.
fn stray_number(line: &DataLine, draft: &mut Draft) -> bool {
    let Some(field) = line.field(0) else { return false };
    let lone = line.fields.len() == 1;
    let real = parse_number(&field.text).is_ok() && parse_integer(&field.text).is_err();
    if !(lone && real) {
        return false;
    }
    let message = format!("`{}` is not a node of the slide line", field.text);
    let help = "is it the width of an *INTERFACE card whose keyword line is missing?";
    draft.log.push(Diagnostic::error(Code("SL0241"), message).at(field.span).help(help));
    draft.owner = Owner::Broken;
    true
}

fn take_line(line: &DataLine, generate: bool, nodes: &mut Vec<(u64, Span)>, draft: &mut Draft) {
    if !generate {
        for at in (0..line.fields.len()).filter(|&at| line.field(at).is_some()) {
            let label = draft.log.label(line, at, "a node");
            nodes.extend(label.map(|label| (label, line.fields[at].span)));
        }
        return;
    }
    draft.log.at_most(line, 3);
    let first = draft.log.label(line, 0, "the first node");
    let last = draft.log.label(line, 1, "the last node");
    let (Some(first), Some(last)) = (first, last) else { return };
    let Some(step) = draft.log.integer_or(line, 2, 1) else { return };
    let step = step.unsigned_abs();
    let distance = first.abs_diff(last);
    if step == 0 || distance % step != 0 {
        let message = format!("{first} to {last} is not a whole number of increments of {step}");
        draft.log.error("SL0226", message, line.span);
        return;
    }
    if draft.reserve(u128::from(distance / step + 1), "members", line.span) {
        let label = |k: u64| if last >= first { first + k * step } else { first - k * step };
        nodes.extend((0..=distance / step).map(|k| (label(k), line.span)));
    }
}

fn repeated(nodes: &[(u64, Span)], draft: &mut Draft) {
    let mut seen = HashMap::new();
    for &(label, span) in nodes {
        if let Some(first) = seen.insert(label, span) {
            let message = format!("node {label} comes twice in the slide line");
            let error = Diagnostic::error(Code("SL0240"), message).at(span);
            draft.log.push(error.label(first, "here first"));
            return;
        }
    }
}
