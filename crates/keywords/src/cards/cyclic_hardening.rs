//! `*CYCLIC HARDENING`: how the yield surface of combined hardening grows.

use super::plastic::table;
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*CYCLIC HARDENING`.
pub(crate) struct CyclicHardening;

impl Keyword for CyclicHardening {
    fn name(&self) -> &'static str {
        "CYCLIC HARDENING"
    }

    fn parameters(&self) -> &'static [Rule] {
        &[]
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Sections
    }

    fn is_suboption(&self) -> bool {
        true
    }

    fn page(&self) -> &'static str {
        page!("CYCLIC-HARDENING")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if draft.owning_material(self.name(), card.span()).is_none() {
            return;
        }
        let line = card.first_line("yield stress, plastic strain", &mut draft.log);
        let table = line.and_then(|_| table(card, draft)).filter(|table| {
            let one = table.len() == 1;
            if !one {
                let message = "a yield surface that moves has constants of one temperature alone";
                draft.log.error("SL0234", message, card.span());
            }
            one
        });
        let own = (self.name(), card.span());
        draft.give_material(own, |material| &mut material.growth, table);
    }
}
