//! A finding and the card that mends it.

use slideline_diag::Diagnostic;
pub use slideline_diag::{Place, Suggestion};

/// Something found, with the card to write where one mends it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// What is said.
    pub diagnostic: Diagnostic,
    /// The card, if one card helps.
    pub card: Option<Suggestion>,
}

impl Finding {
    /// A finding without a card.
    pub fn said(diagnostic: Diagnostic) -> Self {
        Self { diagnostic, card: None }
    }

    /// A finding with its card.
    pub fn with(diagnostic: Diagnostic, place: Place, text: impl Into<String>) -> Self {
        Self { diagnostic, card: Some(Suggestion { place, text: text.into() }) }
    }
}
