//! `*ELEMENT`: elements and contact elements.

use std::borrow::Cow;

use slideline_deck::DataLine;
use slideline_diag::{Code, Diagnostic};

use crate::draft;
use crate::draft::Draft;
use crate::draft::ElementKind;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::sets::Item;

/// `*ELEMENT`.
pub(crate) struct Element;

impl Keyword for Element {
    fn name(&self) -> &'static str {
        "ELEMENT"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::required("TYPE"), Rule::value("ELSET")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Elements
    }

    fn page(&self) -> &'static str {
        page!("ELEMENT")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let Some(kind) = kind(card, draft) else { return };
        let set = card.name("ELSET");
        if let Some(set) = &set {
            draft.element_sets.open(set, card.span());
        }
        draft.note_spatial(kind);
        for line in whole_lines(card.data(), kind.node_count()).as_ref() {
            let Some(element) = element(line, kind, draft) else { continue };
            if let Some(set) = &set {
                draft.element_sets.join(set, Item::One(element.label), line.span);
            }
            draft.add_element(element);
        }
    }
}

fn kind(card: &Reading<'_>, draft: &mut Draft) -> Option<ElementKind> {
    let name = card.name("TYPE")?;
    let found = ElementKind::all().find(|kind| kind.is_called(&name));
    if found.is_none() {
        draft.mark_incomplete(Subject::Elements);
    }
    if found.is_none() && draft.log.first_time(&format!("element type {name}")) {
        let message = format!("elements of type {name} are not supported");
        let known: Vec<&str> = ElementKind::all().map(ElementKind::name).collect();
        let error = Diagnostic::error(Code("SL0220"), message).at(card.span_of("TYPE"));
        draft.log.push(error.help(format!("supported: {}", known.join(", "))));
    }
    found
}

/// Most nodes on the first line of an element.
const ON_ONE_LINE: usize = 15;

/// Data lines with those that go on behind a comma, or behind fifteen nodes, joined to one.
fn whole_lines(data: &[DataLine], nodes: usize) -> Cow<'_, [DataLine]> {
    let goes_on = |line: &DataLine| {
        line.fields.len() <= nodes && (line.text.ends_with(',') || line.fields.len() > ON_ONE_LINE)
    };
    if !data.iter().any(goes_on) {
        return Cow::Borrowed(data);
    }
    let mut whole: Vec<DataLine> = Vec::with_capacity(data.len());
    for line in data {
        match whole.last_mut() {
            Some(last) if goes_on(last) => {
                last.fields.extend(line.fields.iter().cloned());
                last.text = format!("{} {}", last.text, line.text);
            }
            _ => whole.push(line.clone()),
        }
    }
    Cow::Owned(whole)
}

fn element(line: &DataLine, kind: ElementKind, draft: &mut Draft) -> Option<draft::Element> {
    let label = draft.log.label(line, 0, "the element number")?;
    let count = kind.node_count();
    let given = line.fields.iter().skip(1).filter(|field| !field.text.is_empty()).count();
    if given != count {
        let nodes = if count == 1 { "node" } else { "nodes" };
        let message = format!("a {} element has {count} {nodes}, here are {given}", kind.name());
        draft.log.error("SL0231", message, line.span);
        return None;
    }
    let mut nodes = [0; draft::MOST_NODES];
    for (at, node) in nodes.iter_mut().take(count).enumerate() {
        *node = draft.log.label(line, at + 1, "a node number")?;
    }
    Some(draft::Element { label, kind, nodes, origin: line.span })
}
