//! A text line by line, with places for what is said about it.

use crate::fault::unreadable;
use slideline_diag::{Diagnostic, FileId, Span};

/// What is left of a text.
pub(crate) struct Lines<'a> {
    text: &'a str,
    file: FileId,
    at: usize,
    /// The last line that was taken.
    last: Span,
}

/// A line without blanks at its ends.
#[derive(Clone, Copy)]
pub(crate) struct Line<'a> {
    pub text: &'a str,
    pub span: Span,
}

impl<'a> Lines<'a> {
    pub fn new(text: &'a str, file: FileId) -> Self {
        Self { text, file, at: 0, last: Span::new(file, 0, 0) }
    }

    /// The next line that is not empty.
    pub fn next(&mut self) -> Option<Line<'a>> {
        loop {
            let rest = self.text.get(self.at..).filter(|rest| !rest.is_empty())?;
            let length = rest.find('\n').map_or(rest.len(), |end| end + 1);
            let begin = self.at;
            self.at += length;
            let text = rest[..length].trim();
            if !text.is_empty() {
                self.last = Span::new(self.file, begin, begin + rest[..length].trim_end().len());
                return Some(Line { text, span: self.last });
            }
        }
    }

    /// The next line, which must be there.
    pub fn wanted(&mut self, what: &str) -> Result<Line<'a>, Box<Diagnostic>> {
        let last = self.last;
        self.next().ok_or_else(|| {
            unreadable(format!("the mesh ends where {what} should follow"), Some(last))
        })
    }
}

impl<'a> Line<'a> {
    /// Its numbers, at least so many.
    pub fn numbers<T: std::str::FromStr>(
        &self,
        least: usize,
        what: &str,
    ) -> Result<Vec<T>, Box<Diagnostic>> {
        let numbers: Result<Vec<T>, &str> =
            self.text.split_whitespace().map(|word| word.parse().map_err(|_| word)).collect();
        match numbers {
            Err(word) => {
                Err(unreadable(format!("`{word}` is no number of {what}"), Some(self.span)))
            }
            Ok(numbers) if numbers.len() < least => {
                let message = format!("{what} should have {least} numbers here");
                Err(unreadable(message, Some(self.span)))
            }
            Ok(numbers) => Ok(numbers),
        }
    }

    /// Coordinates: three finite numbers [L].
    pub fn position(&self) -> Result<[f64; 3], Box<Diagnostic>> {
        let numbers: Vec<f64> = self.numbers(3, "a position")?;
        if !numbers[..3].iter().all(|value| value.is_finite()) {
            return Err(unreadable("a position is not finite", Some(self.span)));
        }
        Ok([numbers[0], numbers[1], numbers[2]])
    }
}
