//! `*SURFACE INTERACTION`: thickness and laws of a contact, by name.

use slideline_diag::{Code, Diagnostic};

use crate::draft::{Draft, Owner};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::surfaces::NamedInteraction;

/// `*SURFACE INTERACTION`.
pub(crate) struct SurfaceInteraction;

impl Keyword for SurfaceInteraction {
    fn name(&self) -> &'static str {
        "SURFACE INTERACTION"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::required("NAME")];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        &["UNSYMM", "TRACKING THICKNESS"]
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Contact
    }

    fn page(&self) -> &'static str {
        page!("SURFACE-INTERACTION")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let Some(named) = card.named("NAME") else { return };
        if let Some(old) = draft.interactions.iter().find(|old| old.named.name == named.name) {
            let message = format!("the surface interaction {} is defined twice", named.name);
            let error = Diagnostic::error(Code("SL0250"), message).at(named.span);
            draft.log.push(error.label(old.interaction.origin, "defined here first"));
        }
        let thickness = thickness(card, draft);
        let mut own = NamedInteraction::plain(named);
        own.interaction.width = thickness.unwrap_or(1.0);
        own.interaction.origin = card.span();
        own.thickness = thickness;
        // The laws that follow are read in any case: one error for one slip.
        draft.owner = Owner::Interaction(draft.interactions.len());
        draft.interactions.push(own);
    }
}

/// Out-of-plane thickness [L]; `None` where the line is absent.
fn thickness(card: &Reading<'_>, draft: &mut Draft) -> Option<f64> {
    draft.log.at_most_lines(card.data(), 1, "SURFACE INTERACTION");
    let line = card.data().first()?;
    let field = line.field(0)?;
    draft.log.at_most(line, 1);
    let value = draft.log.number(line, 0, "the thickness")?;
    if value <= 0.0 {
        draft.log.error("SL0210", "the thickness of a contact must be positive", field.span);
    }
    Some(value)
}
