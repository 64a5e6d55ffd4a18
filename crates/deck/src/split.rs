//! Values between commas.

use slideline_diag::{FileId, Span};

use crate::card::{Card, Comment, Field, Parameter, Word};
use crate::lines::offset;
use crate::spelling::normalise;

/// A text of a file and where it begins in that file.
#[derive(Clone, Copy)]
pub(crate) struct Stretch<'a> {
    pub file: FileId,
    pub start: usize,
    pub text: &'a str,
}

impl<'a> Stretch<'a> {
    /// The part of the text, which must be a piece of it, with blanks trimmed.
    pub fn part(self, piece: &'a str) -> Self {
        let trimmed = piece.trim();
        Self { start: self.start + offset(self.text, trimmed), text: trimmed, ..self }
    }

    pub fn span(self) -> Span {
        Span::new(self.file, self.start, self.start + self.text.len())
    }
}

/// The pieces between commas outside quotation marks, trimmed; and the
/// position of a quotation mark that is never closed.
pub(crate) fn at_commas(whole: Stretch<'_>) -> (Vec<Stretch<'_>>, Option<Span>) {
    let mut pieces = Vec::new();
    let mut quote = None;
    let mut from = 0;
    for (at, c) in whole.text.char_indices() {
        match c {
            '"' => quote = if quote.is_some() { None } else { Some(at) },
            ',' if quote.is_none() => {
                pieces.push(whole.part(&whole.text[from..at]));
                from = at + 1;
            }
            _ => {}
        }
    }
    pieces.push(whole.part(&whole.text[from..]));
    let open = quote.map(|at| Span::new(whole.file, whole.start + at, whole.start + at + 1));
    (pieces, open)
}

/// A data line's values; an empty one behind the last comma is dropped.
pub(crate) fn fields(line: Stretch<'_>) -> (Vec<Field>, Option<Span>) {
    let (mut pieces, open) = at_commas(line);
    if pieces.len() > 1 && pieces.last().is_some_and(|piece| piece.text.is_empty()) {
        pieces.pop();
    }
    let field = |piece: &Stretch<'_>| Field { text: unquoted(piece.text), span: piece.span() };
    (pieces.iter().map(field).collect(), open)
}

/// A keyword or a value.
pub(crate) fn word(piece: Stretch<'_>) -> Word {
    let raw = unquoted(piece.text);
    let quoted = raw.len() != piece.text.len();
    let name = if quoted { raw.clone() } else { normalise(&raw) };
    Word { raw, name, span: piece.span() }
}

/// `NAME` or `NAME=VALUE`.
pub(crate) fn parameter(piece: Stretch<'_>) -> Parameter {
    match piece.text.split_once('=') {
        Some((name, value)) => {
            Parameter { name: word(piece.part(name)), value: Some(word(piece.part(value))) }
        }
        None => Parameter { name: word(piece), value: None },
    }
}

/// Reads a comment as the keyword line it would be with one star less:
/// `**INTERFACE, ELSET=A` as `*INTERFACE, ELSET=A`. `None` where the second
/// star is not followed by a letter.
pub fn comment_as_card(comment: &Comment) -> Option<Card> {
    let text = comment.text.strip_prefix("**")?;
    if !text.starts_with(|c: char| c.is_ascii_alphabetic()) {
        return None;
    }
    let Span { file, start, .. } = comment.span;
    let inner = Stretch { file, start: start as usize + 2, text };
    let (pieces, _) = at_commas(inner);
    let named = |piece: &&Stretch<'_>| !piece.text.is_empty();
    let parameters = pieces[1..].iter().filter(named).map(|piece| parameter(*piece)).collect();
    let keyword = word(*pieces.first()?);
    Some(Card { keyword, parameters, data: Vec::new(), span: comment.span })
}

/// A value without its quotation marks, which may stand about a part of a name only:
/// `ARM-1."top face"`.
fn unquoted(text: &str) -> String {
    text.chars().filter(|&c| c != '"').collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stretch(text: &str) -> Stretch<'_> {
        Stretch { file: FileId(0), start: 100, text }
    }

    #[test]
    fn values_know_their_columns() {
        let (fields, open) = fields(stretch("1,  2.5 ,, \"a, b\","));
        let texts: Vec<_> = fields.iter().map(|field| field.text.as_str()).collect();
        assert_eq!(texts, ["1", "2.5", "", "a, b"]);
        assert_eq!((fields[1].span.start, fields[1].span.end), (104, 107));
        assert!(open.is_none());
    }

    #[test]
    fn a_part_of_a_name_may_be_quoted() {
        let (fields, open) = fields(stretch("ARM-1.\"a, b\", \"ARM 1\".\"tip\""));
        let texts: Vec<_> = fields.iter().map(|field| field.text.as_str()).collect();
        assert_eq!((texts, open), (vec!["ARM-1.a, b", "ARM 1.tip"], None));
    }

    #[test]
    fn names_lose_blanks_and_case_unless_quoted() {
        let parameter = parameter(stretch("Friction  Onset = \"My Set\""));
        assert_eq!(parameter.name.name, "FRICTIONONSET");
        assert_eq!(parameter.value.unwrap().name, "My Set");
    }

    #[test]
    fn an_open_quotation_is_found() {
        let (_, open) = at_commas(stretch("INPUT=\"a"));
        assert_eq!(open.map(|span| span.start), Some(106));
    }
}
