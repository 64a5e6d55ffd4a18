//! `*MPC`: rigid links.

use slideline_deck::{DataLine, normalise};

use crate::draft::Draft;
use crate::draft::Link;
use crate::keyword::{Keyword, Level, Subject};
use crate::reading::Reading;

/// `*MPC`.
pub(crate) struct Mpc;

impl Keyword for Mpc {
    fn name(&self) -> &'static str {
        "MPC"
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Links
    }

    fn page(&self) -> &'static str {
        page!("MPC")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if card.first_line("BEAM, dependent, master", &mut draft.log).is_none() {
            return;
        }
        for line in card.data() {
            if let Some(link) = link(line, draft) {
                draft.links.push(link);
            }
        }
    }
}

fn link(line: &DataLine, draft: &mut Draft) -> Option<Link> {
    let kind = line.field(0).map_or("", |field| &field.text);
    if normalise(kind) != "BEAM" {
        let span = line.fields.first().map_or(line.span, |field| field.span);
        let message = format!("*MPC of type `{kind}` is not supported: BEAM only");
        draft.log.error("SL0221", message, span);
        return None;
    }
    draft.log.at_most(line, 3);
    let dependent = draft.log.target(line, 1, "the dependent node or set");
    let master = draft.log.target(line, 2, "the master node");
    Some(Link {
        dependent: dependent?,
        dependent_span: line.fields[1].span,
        master: master?,
        master_span: line.fields[2].span,
        origin: line.span,
    })
}
