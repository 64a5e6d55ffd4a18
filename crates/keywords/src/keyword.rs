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

    /// What its cards are held against.
    fn form(&self) -> Form {
        Form { name: self.name(), parameters: self.parameters() }
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
