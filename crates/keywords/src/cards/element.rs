//! `*ELEMENT`: elements and contact elements.

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
        for line in card.data() {
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
