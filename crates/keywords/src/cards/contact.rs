//! `*CONTACT`: contact between all parts of a model, as its cards include and exclude them.

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Subject};
use crate::reading::Reading;
use crate::surfaces::{GeneralContact, Named, Two};

use slideline_deck::{DataLine, normalise};
use slideline_diag::{Code, Diagnostic};

/// `*CONTACT`.
pub(crate) struct Contact;

impl Keyword for Contact {
    fn name(&self) -> &'static str {
        "CONTACT"
    }

    fn without_effect(&self) -> &'static [&'static str] {
        // there is one *CONTACT in a deck, so that nothing is replaced
        &["OP"]
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Contact
    }

    fn page(&self) -> &'static str {
        page!("CONTACT")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 0, self.name());
        if let Some(first) = &draft.general {
            let error = Diagnostic::error(Code("SL0242"), "a second *CONTACT").at(card.span());
            draft.log.push(error.label(first.origin, "the first one"));
            return;
        }
        draft.general = Some(GeneralContact {
            inclusions: Vec::new(),
            exclusions: Vec::new(),
            properties: Vec::new(),
            initializations: Vec::new(),
            origin: card.span(),
        });
    }
}

/// The general contact that a card belongs to; complains where there is none.
pub(super) fn owner<'a>(
    card: &Reading<'_>,
    keyword: &str,
    draft: &'a mut Draft,
) -> Option<&'a mut GeneralContact> {
    if draft.general.is_none() {
        draft.orphan(keyword, "CONTACT", card.span());
    }
    draft.general.as_mut()
}

/// The two surfaces of a line, each blank for all outer faces.
pub(super) fn two(line: &DataLine) -> Two {
    let named = |at: usize| {
        line.field(at).map(|field| Named { name: normalise(&field.text), span: field.span })
    };
    Two { first: named(0), second: named(1) }
}
