//! `*INTERFACE`: width and laws of a contact.

use slideline_model::{Friction, Interaction, NormalLaw};

use crate::draft;
use crate::draft::Draft;
use crate::draft::Owner;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*INTERFACE`.
pub(crate) struct Interface;

impl Keyword for Interface {
    fn name(&self) -> &'static str {
        "INTERFACE"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::required("ELSET")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Contact
    }

    fn page(&self) -> &'static str {
        page!("INTERFACE")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let Some(set) = card.name("ELSET") else { return };
        let span = card.span();
        let width = card.only_line("the width", &mut draft.log).and_then(|line| {
            draft.log.at_most(line, 1);
            let width = draft.log.number(line, 0, "the width")?;
            if width <= 0.0 {
                let message = "the width of a contact must be positive";
                draft.log.error("SL0210", message, line.fields[0].span);
            }
            Some(width)
        });
        // The laws that follow are read in any case: one error for one slip.
        draft.owner = Owner::Interface(draft.interfaces.len());
        let interaction = Interaction {
            width: width.unwrap_or(1.0),
            normal: NormalLaw::Hard,
            friction: Friction::Frictionless,
            origin: span,
            no_separation: false,
            normal_origin: None,
            friction_origin: None,
        };
        let set_span = card.span_of("ELSET");
        draft.interfaces.push(draft::Interface { set, set_span, interaction });
    }
}
