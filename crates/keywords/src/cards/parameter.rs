//! `*PARAMETER`: values behind names.

use slideline_deck::DataLine;
use slideline_diag::{Code, Diagnostic, Span};
use std::ops::Range;

use crate::draft::{Draft, ParameterRange};
use crate::expression::{Value, Values, evaluate, is_name};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*PARAMETER`.
pub(crate) struct Parameter;

impl Keyword for Parameter {
    fn name(&self) -> &'static str {
        "PARAMETER"
    }

    fn parameters(&self) -> &'static [Rule] {
        &[]
    }

    fn level(&self) -> Level {
        Level::Both
    }

    fn subject(&self) -> Subject {
        Subject::Other
    }

    fn page(&self) -> &'static str {
        page!("PARAMETER")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        for line in card.data() {
            define(line, draft);
        }
    }
}

/// `name = expression`; a comment may follow behind #.
fn define(line: &DataLine, draft: &mut Draft) {
    let text = line.text.split('#').next().unwrap_or_default().trim().trim_end_matches(';');
    if text.is_empty() {
        return;
    }
    let named = text.split_once('=').map(|(name, value)| (name.trim(), value.trim()));
    let Some((name, value)) = named.filter(|(name, _)| is_name(name)) else {
        let message = "a parameter is `name = value`, its name of letters, digits and _";
        broken(message.to_owned(), line.span, draft);
        return;
    };
    let set = draft.overrides.take(name);
    let (is_set, is_known, text_of) = (set.is_some(), draft.parameters.contains_key(name), value);
    match evaluate(value, &draft.parameters) {
        Ok(value) => {
            let value = set.unwrap_or(value);
            if is_out_of_range((name, &value), line, draft) {
                return;
            }
            let stands_alone = is_set || evaluate(text_of, &Values::new()).is_ok();
            if let (true, false, Ok(number)) = (stands_alone, is_known, value.real()) {
                draft.numbers.push((name.to_owned(), number));
            }
            draft.parameters.insert(name.to_owned(), value);
        }
        Err((why, piece)) => {
            let own = format!("parameter {name}");
            // what follows from one without a value is not complained about as well
            if names(value).any(|used| draft.log.was_said(&format!("parameter {used}"))) {
                draft.log.first_time(&own);
                return;
            }
            // and one that is used later is not complained about once more
            draft.log.first_time(&own);
            let mut with: Vec<String> = Vec::new();
            for used in names(value) {
                let Some(number) = draft.parameters.get(used) else { continue };
                let one = format!("{used} = {}", number.text());
                if !with.contains(&one) {
                    with.push(one);
                }
            }
            let with = if with.is_empty() {
                String::new()
            } else {
                format!(" (with {})", with.join(", "))
            };
            let at = place_of(value, piece, line);
            broken(format!("the parameter {name} has no value: {why}{with}"), at, draft);
        }
    }
}

/// Whether a value lies outside the range of its name; complains if so, and then the name has none.
fn is_out_of_range((name, value): (&str, &Value), line: &DataLine, draft: &mut Draft) -> bool {
    let Some(&ParameterRange { low, high, origin }) = draft.ranges.get(name) else { return false };
    let Ok(number) = value.real() else { return false };
    if low < number && number < high {
        return false;
    }
    let limits = match (low.is_finite(), high.is_finite()) {
        (true, true) => format!("between {low} and {high}"),
        (true, false) => format!("above {low}"),
        _ => format!("below {high}"),
    };
    let message = format!("the parameter {name} is {}: it must be {limits}", value.text());
    let error = Diagnostic::error(Code("SL0287"), message).at(line.span);
    let error = error.label(origin, "its range");
    draft.log.push(error.help(format!("give {name} a value {limits}")));
    // what follows from it is not complained about as well
    draft.log.first_time(&format!("parameter {name}"));
    draft.log.has_parameters = true;
    draft.mark_all_incomplete();
    true
}

/// The names in an expression, functions among them.
fn names(expression: &str) -> impl Iterator<Item = &str> {
    expression
        .split(|letter: char| !(letter.is_alphanumeric() || letter == '_'))
        .filter(|word| is_name(word))
}

/// Where a piece of a value stands, which is a part of its line.
fn place_of(value: &str, piece: Range<usize>, line: &DataLine) -> Span {
    let behind = line.text.split_once('=').map_or("", |(_, behind)| behind);
    let before = line.text.len() - behind.trim_start().len();
    let begin = line.span.start as usize + before;
    match piece.is_empty() || !behind.trim_start().starts_with(value) {
        true => line.span,
        false => Span::new(line.span.file, begin + piece.start, begin + piece.end),
    }
}

fn broken(message: String, at: Span, draft: &mut Draft) {
    draft.log.has_parameters = true;
    draft.mark_all_incomplete();
    let error = Diagnostic::error(Code("SL0286"), message).at(at);
    let help = "numbers, names of lines above, + - * / **, brackets and functions such as sqrt";
    draft.log.push(error.help(format!("a value is made of {help}")));
}
