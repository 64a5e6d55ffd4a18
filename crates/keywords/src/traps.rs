//! Misprints that a reader would swallow: a keyword made a comment by a
//! second star, and page furniture among the data. Both stand in the printed
//! listing of Diehl (1995).
//!
//! ```text
//!   *SLIDE LINE, ELSET=ISL, GENERATE
//!   2, 25, 1
//!   Continued on next page           <- furniture
//!   **INTERFACE, ELSET=ISL           <- a comment: its width falls to the
//!   25.0E-3                             slide line above
//! ```
//!
//! Each is reported by name; then the deck is read as if it were mended, so
//! that one misprint gives one error.

use std::borrow::Cow;
use std::collections::HashSet;

use slideline_deck::{Card, Comment, DataLine, Deck, comment_as_card, normalise, parse_number};
use slideline_diag::{Code, Diagnostic, Span};

use crate::keyword::Keyword;
use crate::log::Log;
use crate::reading::{Match, resolve};
use crate::registry::keyword_of;
use crate::rule::{Rule, Takes};

/// Keywords that no data line follows: a comment that spells one hides
/// nothing.
const WITHOUT_DATA: [&str; 9] = [
    "HEADING",
    "STEP",
    "RESTART",
    "MATERIAL",
    "PRINT",
    "CONTACT CONTROLS",
    "END STEP",
    "OUTPUT",
    "RIGID BODY",
];

/// The cards of the deck with both misprints mended and reported.
pub(crate) fn mend<'d>(deck: &'d Deck, log: &mut Log) -> Vec<Cow<'d, Card>> {
    let names = set_names(deck);
    let mut hidden = deck.comments.iter().peekable();
    let mut cards = Vec::with_capacity(deck.cards.len());
    for (number, card) in deck.cards.iter().enumerate() {
        let mut cuts: Vec<(usize, Card)> = Vec::new();
        while let Some(comment) = hidden.next_if(|comment| comment.card <= Some(number)) {
            if let Some(cut) = hidden_card(comment, number, card) {
                report_hidden(comment, &cut, log);
                cuts.push((comment.data_before, cut));
            }
        }
        for piece in cut_up(card, cuts) {
            cards.push(without_furniture(piece, &names, log));
        }
    }
    cards
}

/// Whether there is something to mend.
pub(crate) fn has_misprints(deck: &Deck) -> bool {
    let mut log = Log::default();
    let mended = mend(deck, &mut log);
    mended.iter().any(|card| matches!(card, Cow::Owned(_))) || !log.into_diagnostics().is_empty()
}

/// Every name a data line may refer to.
fn set_names(deck: &Deck) -> HashSet<String> {
    let parameters = deck.cards.iter().flat_map(|card| &card.parameters);
    let values = parameters.filter_map(|parameter| parameter.value.as_ref());
    values.map(|value| normalise(&value.raw)).collect()
}

/// The card that a comment hides: a known keyword, complete in itself, with
/// data lines behind it that would go to another card.
fn hidden_card(comment: &Comment, number: usize, owner: &Card) -> Option<Card> {
    if comment.card != Some(number) || comment.data_before >= owner.data.len() {
        return None;
    }
    let card = comment_as_card(comment)?;
    let name = normalise(&card.keyword.raw);
    let Match::Exact(keyword) = keyword_of(&name) else { return None };
    let owner_name = normalise(&owner.keyword.raw);
    let text_owner = ["HEADING", "STEP"].contains(&owner_name.as_str());
    if WITHOUT_DATA.contains(&keyword.name()) || owner_name == name || text_owner {
        return None;
    }
    is_complete(&card, keyword).then_some(card)
}

/// Whether all parameters are the keyword's own and none is missing.
fn is_complete(card: &Card, keyword: &dyn Keyword) -> bool {
    let rules = keyword.parameters();
    let mut missing: Vec<&str> =
        rules.iter().filter(|rule| rule.required).map(|rule| rule.name).collect();
    let refs: Vec<&Rule> = rules.iter().collect();
    for parameter in &card.parameters {
        let found = resolve(&normalise(&parameter.name.raw), &refs, |rule| rule.name);
        let (Match::Exact(rule) | Match::Abbreviation(rule)) = found else { return false };
        let fits = match rule.takes {
            Takes::Nothing => parameter.value.is_none(),
            Takes::Value => parameter.value.is_some(),
            Takes::Maybe => true,
        };
        if !fits {
            return false;
        }
        missing.retain(|name| *name != rule.name);
    }
    missing.is_empty()
}

fn report_hidden(comment: &Comment, card: &Card, log: &mut Log) {
    let Span { file, start, .. } = comment.span;
    let star = Span { file, start, end: start + 1 };
    let message = format!(
        "`**{}` is a comment, but data lines follow: a keyword with one star too many",
        card.keyword.raw
    );
    let help = "remove one star; as it is, the data belong to the card above";
    log.push(Diagnostic::error(Code("SL0211"), message).at(comment.span).help(help).edit(star, ""));
}

/// The card, and the hidden cards with the data that is theirs.
fn cut_up(card: &Card, cuts: Vec<(usize, Card)>) -> Vec<Cow<'_, Card>> {
    let Some(&(first, _)) = cuts.first() else { return vec![Cow::Borrowed(card)] };
    let mut head = card.clone();
    head.data.truncate(first);
    let mut pieces = vec![Cow::Owned(head)];
    let ends: Vec<usize> =
        cuts.iter().skip(1).map(|cut| cut.0).chain(std::iter::once(card.data.len())).collect();
    for ((from, mut hidden), to) in cuts.into_iter().zip(ends) {
        hidden.data = card.data[from..to].to_vec();
        pieces.push(Cow::Owned(hidden));
    }
    pieces
}

/// The card without lines of prose.
fn without_furniture<'d>(
    card: Cow<'d, Card>,
    names: &HashSet<String>,
    log: &mut Log,
) -> Cow<'d, Card> {
    let keyword = normalise(&card.keyword.raw);
    let known = keyword_of(&keyword);
    let (Match::Exact(keyword) | Match::Abbreviation(keyword)) = known else { return card };
    if matches!(keyword.name(), "HEADING" | "STEP" | "PARAMETER") {
        return card;
    }
    let prose = |line: &DataLine| is_furniture(line, names);
    if !card.data.iter().any(prose) {
        return card;
    }
    let mut card = card.into_owned();
    for line in card.data.iter().filter(|line| prose(line)) {
        let insert = Span { end: line.span.start, ..line.span };
        let message = format!("text among the data of *{}", keyword.name());
        let help = "a page heading or footer copied with the listing? Remove the line";
        let error = Diagnostic::error(Code("SL0212"), message).at(line.span);
        log.push(error.help(help).edit(insert, "** "));
    }
    card.data.retain(|line| !prose(line));
    Cow::Owned(card)
}

/// Words only, several to a value, none of them a name of the deck nor quoted.
fn is_furniture(line: &DataLine, names: &HashSet<String>) -> bool {
    if line.text.contains('"') {
        return false;
    }
    let fields =
        line.fields.iter().map(|field| field.text.as_str()).filter(|text| !text.is_empty());
    let mut words = 0;
    let mut several = false;
    for text in fields {
        if parse_number(text).is_ok() || names.contains(&normalise(text)) {
            return false;
        }
        let in_field = text
            .split_whitespace()
            .filter(|word| word.chars().filter(|c| c.is_alphabetic()).count() >= 2)
            .count();
        words += in_field;
        several |= in_field >= 2;
    }
    let lower = line.text.to_lowercase();
    let printed = lower.contains("continued") || lower.starts_with("page ");
    (several && words >= 3) || (printed && words >= 1)
}

#[cfg(test)]
mod tests {
    use slideline_deck::{NoFiles, parse};
    use slideline_diag::Sources;

    use super::*;

    fn furniture(text: &str) -> bool {
        let deck = format!("*NSET, NSET=ALL NODES OF BEAM\n{text}\n");
        let parsed = parse(&mut Sources::default(), "a", deck.as_bytes(), &NoFiles);
        is_furniture(&parsed.deck.cards[0].data[0], &set_names(&parsed.deck))
    }

    #[test]
    fn page_furniture_is_told_from_data() {
        assert!(furniture("Continued on next page"));
        assert!(furniture("ISL Method, Coarse Mesh, First Example, No Friction (Continued)"));
        assert!(furniture("Page 12"));
        assert!(!furniture("BEARINGC,"));
        assert!(!furniture("ALL NODES OF BEAM"));
        assert!(!furniture("9999, 1,, 0.0"));
        assert!(!furniture("BEAM, BEARING, 9999"));
    }
}
