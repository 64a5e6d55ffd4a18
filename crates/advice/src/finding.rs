//! A finding and the card that mends it.

use slideline_diag::{Diagnostic, Span};

/// Something found, with the card to write where one mends it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// What is said.
    pub diagnostic: Diagnostic,
    /// The card, if one card helps.
    pub card: Option<Suggestion>,
}

/// One card and where it belongs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Suggestion {
    /// Where.
    pub place: Place,
    /// The card: keyword line and data lines, each ended by a line feed.
    pub text: String,
}

/// Where a suggested card belongs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// In front of the card at that place.
    Before(Span),
    /// Behind the card at that place and its data.
    After(Span),
    /// Instead of the card at that place and its data.
    Instead(Span),
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
