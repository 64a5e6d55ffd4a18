//! `*MPC`: rigid links.

use slideline_deck::{DataLine, normalise};

use crate::constraints::{Link, LinkKind};
use crate::draft::Draft;

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
        if card.first_line("type, dependent, master", &mut draft.log).is_none() {
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
    let word = line.field(0).map_or("", |field| &field.text);
    let kind = match normalise(word).as_str() {
        "BEAM" => LinkKind::Beam,
        "TIE" => LinkKind::Tie,
        "PIN" => LinkKind::Pin,
        _ => {
            let span = line.fields.first().map_or(line.span, |field| field.span);
            let message = format!("*MPC of type `{word}` is not supported: BEAM, TIE or PIN");
            draft.log.error("SL0221", message, span);
            return None;
        }
    };
    draft.log.at_most(line, 3);
    let dependent = draft.log.target(line, 1, "the dependent node or set");
    let master = draft.log.target(line, 2, "the master node");
    Some(Link {
        kind,
        dependent: dependent?,
        dependent_span: line.fields[1].span,
        master: master?,
        master_span: line.fields[2].span,
        origin: line.span,
    })
}
