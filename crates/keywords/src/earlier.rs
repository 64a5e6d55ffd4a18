//! Decks that go on from the saved state of an earlier job.
//!
//! ```text
//!   press.inp   model  *STEP 1              saved: press.rst
//!   drag.inp    *RESTART, READ  *STEP 2     model of both: model, steps 1 and 2
//! ```

use slideline_deck::{Parsed, normalise};
use slideline_diag::Span;

use crate::log::Log;
use crate::overrides::Setting;
use crate::reading::{Match, Reading};
use crate::registry::keyword_of;

/// Cards that may stand before the first step of a deck that goes on.
pub(crate) const MAY_FOLLOW: [&str; 5] = ["HEADING", "RESTART", "AMPLITUDE", "NSET", "ELSET"];

/// A deck that was walked before.
#[derive(Clone, Copy, Debug)]
pub struct Earlier<'a> {
    /// The deck.
    pub parsed: &'a Parsed,
    /// How many steps there are after it, those of decks before it included;
    /// what it says behind them does not count.
    pub steps: usize,
    /// Values that its parameters had from outside.
    pub settings: &'a [Setting],
}

/// What `*RESTART, READ` asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ReadRequest {
    /// The step to go on from; the last saved one unless said.
    pub step: Option<usize>,
    /// Its increment; the last saved one unless said.
    pub increment: Option<usize>,
    /// The card.
    pub span: Span,
}

/// The request of a deck that goes on from an earlier job; `None` for a deck
/// that stands for itself.
pub fn read_request(parsed: &Parsed) -> Option<ReadRequest> {
    parsed.deck.cards.iter().find_map(|card| {
        let found = keyword_of(&normalise(&card.keyword.raw));
        let (Match::Exact(keyword) | Match::Abbreviation(keyword)) = found else { return None };
        // What is wrong with the card is told when it is interpreted.
        let mut log = Log::default();
        let reading = Reading::new(card, keyword.form(), &mut log);
        let reading = reading.filter(|_| keyword.name() == "RESTART")?;
        let mut count = |name| reading.has(name).then(|| reading.count(name, 1, &mut log));
        let (step, increment) = (count("STEP"), count("INC"));
        reading.has("READ").then_some(ReadRequest { step, increment, span: card.span })
    })
}
