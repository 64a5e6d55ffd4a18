//! `*NORMAL`: the normal n2 of a beam's section at a node.

use slideline_diag::{Code, Diagnostic};

use crate::draft::{Draft, Normal as Draught};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*NORMAL`.
pub(crate) struct Normal;

impl Keyword for Normal {
    fn name(&self) -> &'static str {
        "NORMAL"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::value("TYPE")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Sections
    }

    fn page(&self) -> &'static str {
        page!("NORMAL")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let kind = card.choice("TYPE", &["ELEMENT", "CONTACT SURFACE"], &mut draft.log);
        if kind == Some("CONTACT SURFACE") {
            let message = "normals of a contact surface are not given: they are those of its faces";
            let error = Diagnostic::error(Code("SL0221"), message).at(card.span_of("TYPE"));
            draft.log.push(error.help("leave the card out"));
            return;
        }
        if kind.is_none() && card.has("TYPE") {
            return;
        }
        if card.first_line("element, node, and the normal", &mut draft.log).is_none() {
            return;
        }
        for line in card.data() {
            draft.log.at_most(line, 5);
            let elements = draft.log.target(line, 0, "the element or set");
            let nodes = draft.log.target(line, 1, "the node or set");
            let parts = [2, 3, 4].map(|at| draft.log.number_or(line, at, 0.0));
            let ([Some(x), Some(y), Some(z)], Some((elements, nodes))) =
                (parts, elements.zip(nodes))
            else {
                continue;
            };
            if [x, y, z] == [0.0; 3] {
                draft.log.error("SL0232", "the normal is missing", line.span);
                continue;
            }
            draft.normals.push(Draught {
                elements,
                nodes,
                direction: [x, y, z],
                origin: line.span,
            });
        }
    }
}
