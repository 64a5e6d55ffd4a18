//! `*NODE`: points of the model.

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::sets::Item;

/// `*NODE`.
pub(crate) struct Node;

impl Keyword for Node {
    fn name(&self) -> &'static str {
        "NODE"
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
        page!("NODE")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let set = card.name("NSET");
        if let Some(set) = &set {
            draft.node_sets.open(set, card.span());
        }
        for line in card.data() {
            draft.log.at_most(line, 7); // behind the coordinates may stand a normal
            let Some(label) = draft.log.label(line, 0, "the node number") else { continue };
            let [x, y, z] = [1, 2, 3].map(|at| draft.log.number_or(line, at, 0.0).unwrap_or(0.0));
            if let Some(set) = &set {
                draft.node_sets.join(set, Item::One(label), line.span);
            }
            draft.add_node(label, [x, y, z], line.span, false);
        }
    }
}
