//! `*PRE-TENSION SECTION`: a cut through a bolt whose sides a reference node moves apart.

use crate::constraints::{Cut, PreTension};
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::log::Target;
use crate::reading::Reading;

/// `*PRE-TENSION SECTION`.
pub(crate) struct PreTensionSection;

impl Keyword for PreTensionSection {
    fn name(&self) -> &'static str {
        "PRE-TENSION SECTION"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] =
            &[Rule::required("NODE"), Rule::value("SURFACE"), Rule::value("ELEMENT")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Links
    }

    fn page(&self) -> &'static str {
        page!("PRE-TENSION-SECTION")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 1, self.name());
        let reference = super::rigid_body::node(card, "NODE", draft);
        let Some(cut) = cut(card, draft) else { return };
        let normal = match card.data().first() {
            Some(line) => match super::dload::direction(line, 0, draft) {
                Some(normal) => Some(normal),
                None => return,
            },
            None => None,
        };
        let Some(reference) = reference else { return };
        let (reference_span, origin) = (card.span_of("NODE"), card.span());
        draft.pre_tensions.push(PreTension { cut, reference, reference_span, normal, origin });
    }
}

/// Where the bolt is cut: at a surface, or at the end of an element.
fn cut(card: &Reading<'_>, draft: &mut Draft) -> Option<Cut> {
    match (card.has("SURFACE"), card.has("ELEMENT")) {
        (true, false) => Some(Cut::Surface(card.named("SURFACE")?)),
        (false, true) => match super::rigid_body::node(card, "ELEMENT", draft)? {
            Target::Label(label) => Some(Cut::Element(label, card.span_of("ELEMENT"))),
            Target::Set(_) => {
                let message = "ELEMENT is the number of one element";
                draft.log.error("SL0224", message, card.span_of("ELEMENT"));
                None
            }
        },
        _ => {
            let message = "*PRE-TENSION SECTION takes either SURFACE= or ELEMENT=";
            draft.log.error("SL0205", message, card.span());
            None
        }
    }
}
