//! What a keyword is.

use crate::draft::Draft;
use crate::reading::Reading;
use crate::rule::Form;
pub(crate) use crate::rule::{Level, Rule, Subject};

/// A keyword of the deck language: one file and one line in the registry.
pub(crate) trait Keyword: Sync {
    /// Its name without the star, upper case, spelt out.
    fn name(&self) -> &'static str;

    /// The parameters it knows.
    fn parameters(&self) -> &'static [Rule] {
        &[]
    }

    /// Parameters that change no result of a static step: accepted with a note.
    fn without_effect(&self) -> &'static [&'static str] {
        &[]
    }

    /// What its cards are held against.
    fn form(&self) -> Form {
        let (name, parameters) = (self.name(), self.parameters());
        Form { name, parameters, without_effect: self.without_effect() }
    }

    /// Where it may stand.
    fn level(&self) -> Level;

    /// What it contributes to.
    fn subject(&self) -> Subject;

    /// Whether it belongs to the card before it, as `*FRICTION` to
    /// `*INTERFACE`.
    fn is_suboption(&self) -> bool {
        false
    }

    /// Its page: meaning, formula, default, source, example.
    fn page(&self) -> &'static str;

    /// Takes a card in. Called only when its parameters are in order.
    fn read(&self, card: &Reading<'_>, draft: &mut Draft);
}
