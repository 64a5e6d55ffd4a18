//! The numbers of a deck that may be changed: lines of `*PARAMETER`.
//!
//! ```text
//!   ** range thickness 1.0 3.0
//!   *PARAMETER
//!   thickness = 1.5        # height of the arm [mm]     a slider from 1 to 3, its label and unit
//!   area = width*thickness # follows from others        no slider: it is computed
//! ```

use crate::places::{Follows, Place, Places};
use crate::slider::{Range, Slider, around};
use slideline::deck::{DataLine, Deck};
use slideline::diag::Span;

/// The range that a text such as `thickness=1.0:3.0` names; `None`: it names none.
pub fn range(text: &str) -> Option<Range> {
    let (name, ends) = text.split_once('=')?;
    let (minimum, maximum) = ends.split_once(':')?;
    limits(name, minimum, maximum)
}

fn limits(name: &str, minimum: &str, maximum: &str) -> Option<Range> {
    let [minimum, maximum] = [minimum, maximum].map(|text| text.trim().parse::<f64>().ok());
    let (minimum, maximum) = (minimum?, maximum?);
    let sound = minimum.is_finite() && maximum.is_finite() && minimum < maximum;
    sound.then(|| Range { name: name.trim().to_owned(), minimum, maximum })
}

/// Ranges that comments of a deck name: `** range NAME FROM TO`.
pub(crate) fn ranges(deck: &Deck) -> Vec<Range> {
    let own = deck.comments.iter().filter_map(|comment| {
        let mut words = comment.text.trim_start_matches('*').split_whitespace();
        if !words.next()?.eq_ignore_ascii_case("range") {
            return None;
        }
        limits(words.next()?, words.next()?, words.next()?)
    });
    own.collect()
}

/// The parameters that a deck gives numbers to, each at its first line, and where their numbers are.
pub(crate) fn declared(deck: &Deck, ranges: &[Range]) -> (Vec<Slider>, Places) {
    let (mut found, mut places) = (Vec::new(), Places::default());
    let cards = deck.cards.iter().filter(|card| card.keyword.name == "PARAMETER");
    let mut met: Vec<String> = Vec::new();
    // what stands in an included file is not changed
    let own = |line: &&DataLine| Some(line.span.file) == deck.files.first().map(|own| own.file);
    for line in cards.flat_map(|card| &card.data).filter(own) {
        let Some((name, _)) = line.text.split_once('=') else { continue };
        let name = name.trim();
        if met.iter().any(|own| own == name) {
            continue;
        }
        met.push(name.to_owned());
        if let Some((own, span)) = slider(&line.text, line.span) {
            places.list.push(Place {
                span,
                name: own.name.clone(),
                value: own.value,
                follows: Follows::Same(found.len()),
            });
            found.push(own.limited(ranges));
        }
    }
    (found, places)
}

/// That of a line such as `thickness = 1.5  # height of the arm [mm]`, and where its number is; `None`:
/// it is computed, or no number.
fn slider(line: &str, span: Span) -> Option<(Slider, Span)> {
    let (assigned, comment) = line.split_once('#').unwrap_or((line, ""));
    let (name, number) = assigned.split_once('=')?;
    let begin = name.len() + 1 + (number.len() - number.trim_start().len());
    let text = number.trim().trim_end_matches(';').trim_end();
    let whole = text.parse::<i64>().is_ok();
    let is_number = text.starts_with(|first: char| first.is_ascii_digit() || "+-.".contains(first));
    let value = text.parse::<f64>().ok().filter(|value| is_number && value.is_finite())?;
    let (about, unit) = labelled(comment);
    let begin = span.start as usize + begin;
    let place = Span::new(span.file, begin, begin + text.len());
    let (name, range) = (name.trim().to_owned(), around(value));
    Some((Slider { name, value, range, whole, about, unit, declared: true }, place))
}

/// The words of a comment and the unit that ends it in brackets.
fn labelled(comment: &str) -> (String, String) {
    let comment = comment.trim();
    let bracketed = comment.strip_suffix(']').and_then(|rest| rest.rsplit_once('['));
    match bracketed {
        Some((about, unit)) => (about.trim().to_owned(), unit.trim().to_owned()),
        None => (comment.to_owned(), String::new()),
    }
}
