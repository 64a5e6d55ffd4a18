//! A card held against its keyword: which parameters were given.

use slideline_deck::{Card, DataLine, Field, Parameter, Word, nearest, normalise};
use slideline_diag::{Code, Diagnostic, Span};

use crate::log::Log;
use crate::rule::{Form, Rule, Takes};
use crate::surfaces::Named;

/// A card whose parameters are known by their full names.
pub(crate) struct Reading<'a> {
    pub card: &'a Card,
    pub keyword: Form,
    given: Vec<(&'static str, &'a Parameter)>,
}

/// What a word stands for among known ones.
pub(crate) enum Match<T> {
    Exact(T),
    Abbreviation(T),
    Ambiguous(Vec<T>),
    Unknown,
}

/// Finds a normalised word among names: spelt out, or a unique beginning of
/// at least two letters.
pub(crate) fn resolve<T: Copy>(word: &str, known: &[T], name: fn(&T) -> &'static str) -> Match<T> {
    // Known names are upper case; a deck of nothing but unknown words asks often.
    let letters = |entry: &T| name(entry).bytes().filter(|&byte| byte != b' ');
    let first = word.as_bytes().first();
    let mut alike = known.iter().filter(|entry| name(entry).as_bytes().first() == first);
    if let Some(&exact) = alike.find(|entry| letters(entry).eq(word.bytes())) {
        return Match::Exact(exact);
    }
    if word.len() < 2 {
        return Match::Unknown;
    }
    let begins = |entry: &&T| letters(entry).take(word.len()).eq(word.bytes());
    let found: Vec<T> = known.iter().filter(begins).copied().collect();
    match found.as_slice() {
        [] => Match::Unknown,
        [only] => Match::Abbreviation(*only),
        _ => Match::Ambiguous(found),
    }
}

/// Says once that an abbreviation was understood.
pub(crate) fn note_abbreviation(log: &mut Log, raw: &str, full: &str, span: Span) {
    if log.first_time(&format!("{}={full}", normalise(raw))) {
        log.note("SL0204", format!("`{raw}` is read as {full}"), span);
    }
}

impl<'a> Reading<'a> {
    /// Holds the card against the keyword. `None` where a required parameter
    /// is missing; everything wrong is reported.
    pub fn new(card: &'a Card, keyword: Form, log: &mut Log) -> Option<Self> {
        let mut reading = Self { card, keyword, given: Vec::new() };
        for parameter in &card.parameters {
            if let Some(rule) = find_rule(parameter, keyword, log) {
                reading.check_value(parameter, rule, log);
                reading.given.push((rule.name, parameter));
            }
        }
        let missing =
            keyword.parameters.iter().filter(|rule| rule.required && !reading.has(rule.name));
        let missing: Vec<&str> = missing.map(|rule| rule.name).collect();
        for name in &missing {
            let message = format!("*{} needs the parameter {name}=", keyword.name);
            log.error("SL0205", message, card.span);
        }
        missing.is_empty().then_some(reading)
    }

    fn check_value(&self, parameter: &Parameter, rule: &Rule, log: &mut Log) {
        let name = rule.name;
        match (&parameter.value, rule.takes) {
            (None, Takes::Value) => {
                log.error("SL0206", format!("{name} needs a value: {name}=..."), parameter.span());
            }
            (Some(value), Takes::Nothing) => {
                log.error("SL0206", format!("{name} takes no value"), value.span);
            }
            _ => {}
        }
    }

    /// Whether the parameter was given.
    pub fn has(&self, name: &str) -> bool {
        self.given.iter().any(|(given, _)| *given == name)
    }

    /// The value of a parameter.
    pub fn word(&self, name: &str) -> Option<&'a Word> {
        self.parameter(name).and_then(|parameter| parameter.value.as_ref())
    }

    fn parameter(&self, name: &str) -> Option<&'a Parameter> {
        self.given.iter().find(|(given, _)| *given == name).map(|&(_, parameter)| parameter)
    }

    /// Where a parameter stands; the card where it does not.
    pub fn span_of(&self, name: &str) -> Span {
        self.parameter(name).map_or(self.card.span, Parameter::span)
    }

    /// A name given as value: a set, a material. Case and blanks do not count.
    pub fn name(&self, name: &str) -> Option<String> {
        self.word(name).map(|word| normalise(&word.raw)).filter(|name| !name.is_empty())
    }

    /// Such a name, with where it was said.
    pub fn named(&self, parameter: &str) -> Option<Named> {
        self.name(parameter).map(|name| Named { name, span: self.span_of(parameter) })
    }

    /// A real number given as value: `Some(None)` where the parameter is
    /// absent, `None` after an error.
    pub fn number(&self, name: &str, log: &mut Log) -> Option<Option<f64>> {
        let Some(word) = self.word(name) else { return Some(None) };
        let field = Field { text: word.raw.clone(), span: word.span };
        log.number_in(&field).map(Some)
    }

    /// A positive whole number given as value, or the default.
    pub fn count(&self, name: &str, default: usize, log: &mut Log) -> usize {
        self.at_least(1, name, default, log)
    }

    /// A whole number of at least `least` given as value, or the default.
    pub fn at_least(&self, least: usize, name: &str, default: usize, log: &mut Log) -> usize {
        let Some(word) = self.word(name) else { return default };
        let field = Field { text: word.raw.clone(), span: word.span };
        let Some(value) = log.integer_in(&field) else { return default };
        let value = usize::try_from(value).ok().filter(|&value| value >= least);
        if value.is_none() {
            log.error("SL0210", format!("{name} must be at least {least}"), word.span);
        }
        value.unwrap_or(default)
    }

    /// One of several words given as value; `None` where absent or unknown.
    pub fn choice(
        &self,
        name: &str,
        known: &'static [&'static str],
        log: &mut Log,
    ) -> Option<&'static str> {
        let word = self.word(name)?;
        let span = word.span;
        match resolve(&normalise(&word.raw), known, |entry| entry) {
            Match::Exact(found) => Some(found),
            Match::Abbreviation(found) => {
                note_abbreviation(log, &word.raw, found, span);
                Some(found)
            }
            Match::Ambiguous(_) | Match::Unknown => {
                let message = format!("{name}={} is not known", word.raw);
                let listed = known.join(", ");
                let error = Diagnostic::error(Code("SL0207"), message).at(span);
                log.push(error.help(format!("known for {name} on this keyword: {listed}")));
                None
            }
        }
    }

    /// A parameter that means yes unless it says `NO`.
    pub fn yes(&self, name: &str, log: &mut Log) -> Option<bool> {
        self.parameter(name)?;
        if self.word(name).is_none() {
            return Some(true);
        }
        let word = self.choice(name, &["YES", "NO", "ON", "OFF"], log);
        word.map(|word| !["NO", "OFF"].contains(&word))
    }

    /// The data lines.
    pub fn data(&self) -> &'a [DataLine] {
        &self.card.data
    }

    /// The keyword line.
    pub fn span(&self) -> Span {
        self.card.span
    }

    /// All numbers of the data lines, one after the other; blank ones are zero.
    pub fn numbers(&self, log: &mut Log) -> Option<Vec<f64>> {
        let fields =
            self.data().iter().flat_map(|line| (0..line.fields.len()).map(move |k| (line, k)));
        let read: Vec<Option<f64>> =
            fields.map(|(line, at)| log.number_or(line, at, 0.0)).collect();
        read.into_iter().collect()
    }

    /// The only data line of the card; complains where there is none or more.
    pub fn only_line(&self, what: &str, log: &mut Log) -> Option<&'a DataLine> {
        log.at_most_lines(self.data(), 1, self.keyword.name);
        self.first_line(what, log)
    }

    /// The first data line; complains where there is none.
    pub fn first_line(&self, what: &str, log: &mut Log) -> Option<&'a DataLine> {
        let line = self.data().first();
        if line.is_none() {
            let message = format!("*{} needs a data line: {what}", self.keyword.name);
            log.error("SL0208", message, self.span());
        }
        line
    }
}

/// Whether a parameter is one that changes no result, spelt out or by its first three letters or
/// more.
fn is_without_effect(word: &Word, keyword: Form) -> bool {
    const FEWEST: usize = 3;
    let name = normalise(&word.raw);
    let is_it = |known: String| known == name || (name.len() >= FEWEST && known.starts_with(&name));
    keyword.without_effect.iter().any(|known| is_it(normalise(known)))
}

/// The rule a parameter follows: exact, a unique beginning, or the nearest
/// spelling (which is an error, but read on with).
fn find_rule(parameter: &Parameter, keyword: Form, log: &mut Log) -> Option<&'static Rule> {
    let rules = keyword.parameters;
    let word = &parameter.name;
    let name = normalise(&word.raw);
    if let Some(exact) = rules.iter().find(|rule| rule.name == name) {
        return Some(exact);
    }
    let refs: Vec<&'static Rule> = rules.iter().collect();
    let found = resolve(&name, &refs, |rule| rule.name);
    if !matches!(found, Match::Exact(_))
        && let Some(help) = crate::unsupported::parameter(keyword.name, &name)
    {
        let message = format!("{} of *{} is not supported", word.raw, keyword.name);
        let error = Diagnostic::error(Code("SL0221"), message).at(word.span);
        log.push(error.help(help));
        return None;
    }
    match found {
        Match::Exact(rule) => Some(rule),
        Match::Abbreviation(rule) => {
            note_abbreviation(log, &word.raw, rule.name, word.span);
            Some(rule)
        }
        Match::Ambiguous(found) => {
            let names: Vec<&str> = found.iter().map(|rule| rule.name).collect();
            let message = format!("`{}` may be {}", word.raw, names.join(" or "));
            log.error("SL0203", message, word.span);
            None
        }
        Match::Unknown if is_without_effect(word, keyword) => {
            let name = keyword.name;
            if log.first_time(&format!("{name} {}", word.name)) {
                let message = format!("{} of *{name} has no effect here and is ignored", word.raw);
                log.note("SL0257", message, word.span);
            }
            None
        }
        Match::Unknown => {
            let message = format!("*{} has no parameter {}", keyword.name, word.raw);
            let error = Diagnostic::error(Code("SL0202"), message).at(word.span);
            let compared = rules.iter().take(log.names_to_compare());
            let near = nearest(&word.raw, compared.map(|rule| rule.name));
            let Some(near) = near else {
                let names: Vec<&str> = rules.iter().map(|rule| rule.name).collect();
                let known = if names.is_empty() { "none".to_owned() } else { names.join(", ") };
                log.push(error.help(format!("its parameters: {known}")));
                return None;
            };
            log.push(error.help(format!("did you mean {near}?")).edit(word.span, near));
            rules.iter().find(|rule| rule.name == near)
        }
    }
}
