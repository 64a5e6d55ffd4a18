//! Diagnostics while they are collected, and values read with their errors.

use slideline_deck::{DataLine, Field, integer, normalise, number, parse_integer};
use slideline_diag::{Code, Diagnostic, Listing, Severity, Span};
use slideline_model::NumberedSet;

use crate::instances::Instances;
pub(crate) use crate::instances::{MAX_LABEL, Target};

/// Collects diagnostics.
#[derive(Default)]
pub(crate) struct Log {
    listing: Listing,
    errors: usize,
    /// Errors that leave nothing out.
    harmless: usize,
    said: NumberedSet<String>,
    /// Instances of parts, whose nodes and elements have names.
    pub instances: Instances,
    /// The deck has `*PARAMETER`, which has been said: values in `<...>` are
    /// not complained about.
    pub has_parameters: bool,
    /// Where a name of a parameter was replaced: the place, the name and the value.
    pub values: Vec<(Span, String, String)>,
}

impl Log {
    pub fn push(&mut self, mut diagnostic: Diagnostic) {
        if let Some(said) = self.instances.in_words(&diagnostic.message) {
            diagnostic.message = said;
        }
        if diagnostic.severity == Severity::Error && self.names_to_compare() > 0 {
            let values = self.values_at(diagnostic.span);
            if !values.is_empty() {
                diagnostic.message = format!("{} ({values})", diagnostic.message);
            }
        }
        self.errors += usize::from(diagnostic.severity == Severity::Error);
        self.listing.push(diagnostic);
    }

    /// The values of the parameters that a place names: `width = 0`.
    fn values_at(&self, place: Option<Span>) -> String {
        let Some(place) = place else { return String::new() };
        let within =
            |own: &Span| own.file == place.file && place.start <= own.start && own.end <= place.end;
        let mut values: Vec<String> = Vec::new();
        for (_, name, value) in self.values.iter().filter(|(span, ..)| within(span)) {
            let value = format!("{name} = {value}");
            if !values.contains(&value) {
                values.push(value);
            }
        }
        values.join(", ")
    }

    pub fn error(&mut self, code: &'static str, message: impl Into<String>, span: Span) {
        self.push(Diagnostic::error(Code(code), message).at(span));
    }

    pub fn warning(&mut self, code: &'static str, message: impl Into<String>, span: Span) {
        self.push(Diagnostic::warning(Code(code), message).at(span));
    }

    pub fn note(&mut self, code: &'static str, message: impl Into<String>, span: Span) {
        self.push(Diagnostic::note(Code(code), message).at(span));
    }

    /// An error that leaves nothing of what its card gives out.
    pub fn push_harmless(&mut self, error: Diagnostic) {
        self.harmless += 1;
        self.push(error);
    }

    /// How many errors so far that leave something out.
    pub fn errors(&self) -> usize {
        self.errors - self.harmless
    }

    /// Forgets everything but errors.
    pub fn keep_errors(&mut self) {
        self.listing.keep_errors();
        self.said.clear();
    }

    /// How many names are worth comparing for a likely spelling: fewer once
    /// there is much to say, so that a broken deck is still read in no time.
    pub fn names_to_compare(&self) -> usize {
        if self.errors < 100 { 1000 } else { 0 }
    }

    /// Whether this is the first time that `what` comes up.
    pub fn first_time(&mut self, what: &str) -> bool {
        self.said.insert(what.to_owned())
    }

    /// Whether `what` came up before.
    pub fn was_said(&self, what: &str) -> bool {
        self.said.contains(what)
    }

    pub fn into_diagnostics(self) -> Vec<Diagnostic> {
        self.listing.into_diagnostics()
    }

    /// Keeps the value, or reports the error.
    pub fn take<T>(&mut self, result: Result<T, Box<Diagnostic>>) -> Option<T> {
        result.map_err(|diagnostic| self.push(*diagnostic)).ok()
    }

    fn present<'l>(&mut self, line: &'l DataLine, at: usize, what: &str) -> Option<&'l Field> {
        let field = line.field(at);
        if field.is_none() {
            let span = line.fields.get(at).map_or(line.end(), |field| field.span);
            self.error("SL0119", format!("{what} is missing"), span);
        }
        field
    }

    /// Whether the value stands for a `*PARAMETER`; the card it belongs to then
    /// counts as broken.
    fn is_parameter(&mut self, field: &Field) -> bool {
        let found = self.has_parameters && field.text.contains('<');
        self.errors += usize::from(found);
        found
    }

    /// A value as a real number.
    pub fn number_in(&mut self, field: &Field) -> Option<f64> {
        if self.is_parameter(field) {
            return None;
        }
        self.take(number(field))
    }

    /// A value as a whole number.
    pub fn integer_in(&mut self, field: &Field) -> Option<i64> {
        if self.is_parameter(field) {
            return None;
        }
        self.take(integer(field))
    }

    /// A real number that must be there; `what` names it in the error.
    pub fn number(&mut self, line: &DataLine, at: usize, what: &str) -> Option<f64> {
        let field = self.present(line, at, what)?;
        self.number_in(field)
    }

    /// A real number, or its default where it is missing or blank.
    pub fn number_or(&mut self, line: &DataLine, at: usize, default: f64) -> Option<f64> {
        line.field(at).map_or(Some(default), |field| self.number_in(field))
    }

    /// A real number that may be missing: `Some(None)` then.
    pub fn maybe_number(&mut self, line: &DataLine, at: usize) -> Option<Option<f64>> {
        line.field(at).map_or(Some(None), |field| self.number_in(field).map(Some))
    }

    /// A whole number, or its default where it is missing or blank.
    pub fn integer_or(&mut self, line: &DataLine, at: usize, default: i64) -> Option<i64> {
        line.field(at).map_or(Some(default), |field| self.integer_in(field))
    }

    /// A node or element number.
    pub fn label(&mut self, line: &DataLine, at: usize, what: &str) -> Option<u64> {
        let field = self.present(line, at, what)?;
        self.label_in(field)
    }

    /// The points of a line, three numbers each; blank ones are zero.
    pub fn points<const N: usize>(&mut self, line: &DataLine) -> Option<[[f64; 3]; N]> {
        let mut points = [[0.0; 3]; N];
        for (at, value) in points.as_flattened_mut().iter_mut().enumerate() {
            *value = self.number_or(line, at, 0.0)?;
        }
        Some(points)
    }

    /// A value as a node or element number.
    pub fn label_in(&mut self, field: &Field) -> Option<u64> {
        let value = self.integer_in(field)?;
        self.in_range(value, field)
    }

    fn in_range(&mut self, value: i64, field: &Field) -> Option<u64> {
        let label = u64::try_from(value).ok().filter(|_| (1..=MAX_LABEL).contains(&value));
        if label.is_none() {
            let message = format!("{value} is not a node or element number: 1 to {MAX_LABEL}");
            self.error("SL0224", message, field.span);
        }
        label
    }

    /// A number or the name of a set.
    pub fn target(&mut self, line: &DataLine, at: usize, what: &str) -> Option<Target> {
        let field = self.present(line, at, what)?;
        if parse_integer(&field.text).is_ok() {
            let value = self.integer_in(field)?;
            return self.in_range(value, field).map(Target::Label);
        }
        let number = field.text.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
        let alphabetic = |c: char| c.is_alphabetic() && !"eEdD".contains(c) || c == '_';
        if number && !field.text.contains(alphabetic) {
            self.integer_in(field);
            return None;
        }
        Some(self.instances.target(normalise(&field.text)))
    }

    /// Complains about values behind the last one that means something.
    pub fn at_most(&mut self, line: &DataLine, count: usize) {
        let extra = line.fields.iter().skip(count).find(|field| !field.text.is_empty());
        if let Some(field) = extra {
            let message = format!("more values than this line takes ({count})");
            self.error("SL0209", message, field.span);
        }
    }

    /// Whether temperatures of a table ascend; complains if not. `at`: the field of the temperature.
    pub fn ascends(&mut self, last: Option<f64>, now: f64, line: &DataLine, at: usize) -> bool {
        let sound = last.is_none_or(|last| now > last);
        if !sound {
            let span = line.fields.get(at).map_or(line.span, |field| field.span);
            let message = format!("the temperature {now} does not ascend");
            self.error("SL0234", message, span);
        }
        sound
    }

    /// Complains about lines behind the last one that means something.
    pub fn at_most_lines(&mut self, data: &[DataLine], count: usize, keyword: &str) {
        if let Some(line) = data.get(count) {
            let message = match count {
                0 => format!("*{keyword} takes no data lines"),
                1 => format!("*{keyword} takes one data line"),
                _ => format!("*{keyword} takes {count} data lines"),
            };
            self.error("SL0209", message, line.span);
        }
    }
}
