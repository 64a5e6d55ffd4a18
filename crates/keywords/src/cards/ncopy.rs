//! `*NCOPY`: nodes copied, moved.

use slideline_diag::{Code, Diagnostic};

use super::instance::motion;
use crate::draft::Draft;
use crate::finish::unknown_set;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::sets::Item;

/// `*NCOPY`.
pub(crate) struct Ncopy;

impl Keyword for Ncopy {
    fn name(&self) -> &'static str {
        "NCOPY"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::required("CHANGE NUMBER"),
            Rule::required("OLD SET"),
            Rule::value("NEW SET"),
            Rule::flag("SHIFT"),
            Rule::value("MULTIPLE"),
        ];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Nodes
    }

    fn page(&self) -> &'static str {
        page!("NCOPY")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let change = card.at_least(1, "CHANGE NUMBER", 1, &mut draft.log) as u64;
        let times = card.count("MULTIPLE", 1, &mut draft.log) as u64;
        draft.log.at_most_lines(card.data(), 2, self.name());
        if !card.has("SHIFT") {
            let error = Diagnostic::error(Code("SL0205"), "*NCOPY needs the parameter SHIFT");
            draft.log.push(error.at(card.span()).help("its data lines say where the copy stands"));
            return;
        }
        let motion = motion(card, draft);
        let Some(old) = card.name("OLD SET") else { return };
        let Some(mut labels) = draft.node_sets.labels(&old) else {
            let names = draft.node_sets.names().take(draft.log.names_to_compare());
            let error = unknown_set("node", &old, card.span_of("OLD SET"), names);
            draft.log.push(error);
            return;
        };
        labels.sort_unstable();
        let new = card.name("NEW SET");
        if let Some(new) = &new {
            draft.node_sets.open(new, card.span());
        }
        if !draft.reserve(labels.len() as u128 * u128::from(times), "nodes", card.span()) {
            return;
        }
        for label in labels {
            let Some(index) = draft.model.nodes.find(label) else {
                let message = format!("node {label} is not defined yet");
                let error = Diagnostic::error(Code("SL0225"), message).at(card.span_of("OLD SET"));
                draft.log.push(error.help("*NCOPY uses the coordinates stored when it is read"));
                return;
            };
            let mut place = draft.model.nodes.position(index);
            for copy in 1..=times {
                place = motion.point(place);
                let Some(own) = draft.further(label, change, copy, card.span()) else { return };
                if let Some(new) = &new {
                    draft.node_sets.join(new, Item::One(own), card.span());
                }
                draft.add_node(own, place, card.span(), true);
            }
        }
    }
}
