//! `*ELCOPY`: elements copied, on nodes of other numbers.

use slideline_diag::{Code, Diagnostic};

use crate::draft::{Draft, Element};
use crate::finish::unknown_set;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::sets::Item;

/// `*ELCOPY`.
pub(crate) struct Elcopy;

impl Keyword for Elcopy {
    fn name(&self) -> &'static str {
        "ELCOPY"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::required("ELEMENT SHIFT"),
            Rule::required("OLD SET"),
            Rule::required("SHIFT NODES"),
            Rule::value("NEW SET"),
        ];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Elements
    }

    fn page(&self) -> &'static str {
        page!("ELCOPY")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 0, self.name());
        let elements = card.at_least(1, "ELEMENT SHIFT", 1, &mut draft.log) as u64;
        let nodes = card.at_least(0, "SHIFT NODES", 0, &mut draft.log) as u64;
        let Some(old) = card.name("OLD SET") else { return };
        let Some(labels) = draft.element_sets.labels(&old) else {
            let names = draft.element_sets.names().take(draft.log.names_to_compare());
            let error = unknown_set("element", &old, card.span_of("OLD SET"), names);
            draft.log.push(error);
            return;
        };
        let new = card.name("NEW SET");
        if let Some(new) = &new {
            draft.element_sets.open(new, card.span());
        }
        if !draft.reserve(labels.len() as u128, "elements", card.span()) {
            return;
        }
        for label in labels {
            let Some(&index) = draft.element_by_label.get(&label) else {
                let message = format!("element {label} is not defined yet");
                let error = Diagnostic::error(Code("SL0230"), message).at(card.span_of("OLD SET"));
                draft.log.push(error.help("*ELCOPY uses the elements stored when it is read"));
                return;
            };
            let Element { kind, nodes: mut own, .. } = draft.elements[index];
            let origin = card.span();
            for node in own.iter_mut().take(kind.node_count()) {
                let Some(moved) = draft.further(*node, nodes, 1, origin) else { return };
                *node = moved;
            }
            let Some(label) = draft.further(label, elements, 1, origin) else { return };
            if let Some(new) = &new {
                draft.element_sets.join(new, Item::One(label), origin);
            }
            draft.add_element(Element { label, kind, nodes: own, origin });
        }
    }
}
