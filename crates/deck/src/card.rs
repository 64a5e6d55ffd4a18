//! The tree: files made of lines, and the cards those lines spell.

use slideline_diag::{FileId, Span};

/// A deck as it was read: the lines of every file, and the cards in reading
/// order with included files in place.
#[derive(Clone, Debug, Default)]
pub struct Deck {
    /// Every file that was read, the deck itself first.
    pub files: Vec<FileLines>,
    /// All cards, `*INCLUDE` excepted.
    pub cards: Vec<Card>,
    /// All comments.
    pub comments: Vec<Comment>,
}

/// One file, line by line. The lines tile the bytes without gap or overlap.
#[derive(Clone, Debug)]
pub struct FileLines {
    /// Its number in `Sources`.
    pub file: FileId,
    /// The bytes as read.
    pub bytes: Vec<u8>,
    /// The lines in order.
    pub lines: Vec<Line>,
}

/// One line of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line {
    /// The bytes of the line, its ending included.
    pub span: Span,
    /// What the line is.
    pub kind: LineKind,
}

/// What a line is. Numbers are positions in [`Deck::cards`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineKind {
    /// The keyword line of a card, or its continuation.
    Keyword(usize),
    /// A data line of a card.
    Data(usize),
    /// `*INCLUDE` or its continuation.
    Include,
    /// A line beginning with `**`.
    Comment,
    /// Nothing but blanks.
    Blank,
    /// A line that belongs to nothing; an error was reported.
    Stray,
}

/// A keyword with its parameters and data lines.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Card {
    /// The keyword without its star.
    pub keyword: Word,
    /// Parameters in the order written.
    pub parameters: Vec<Parameter>,
    /// Data lines in the order written, blank lines left out.
    pub data: Vec<DataLine>,
    /// The keyword line with its continuations, without the line ending.
    pub span: Span,
}

/// A name as written and as understood.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Word {
    /// As written, blanks at the ends and quotation marks taken off.
    pub raw: String,
    /// Upper case, blanks inside removed; a quoted name keeps both.
    pub name: String,
    /// Where it stands.
    pub span: Span,
}

/// `NAME` or `NAME=VALUE` on a keyword line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameter {
    /// The name.
    pub name: Word,
    /// The value, where there is one.
    pub value: Option<Word>,
}

/// One data line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DataLine {
    /// The line without blanks at its ends and without the line ending.
    pub text: String,
    /// Where that is.
    pub span: Span,
    /// The values between the commas; an empty one after the last comma is
    /// left out.
    pub fields: Vec<Field>,
}

/// One value of a data line; blank means "default".
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Field {
    /// The value without blanks around it and without quotation marks.
    pub text: String,
    /// Where it stands; for a blank value the place where it is missing.
    pub span: Span,
}

/// A comment line and the place in the reading order where it stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Comment {
    /// The whole line with its stars, without the line ending.
    pub text: String,
    /// Where that is.
    pub span: Span,
    /// The card it follows, if any.
    pub card: Option<usize>,
    /// How many data lines of that card stand before it.
    pub data_before: usize,
}

impl Deck {
    /// The bytes of a file, printed line by line from the tree.
    pub fn print(&self, file: FileId) -> Vec<u8> {
        let Some(found) = self.files.iter().find(|lines| lines.file == file) else {
            return Vec::new();
        };
        let line_bytes = |line: &Line| {
            found.bytes.get(line.span.start as usize..line.span.end as usize).unwrap_or(&[])
        };
        found.lines.iter().flat_map(line_bytes).copied().collect()
    }
}

impl Card {
    /// The parameter of that normalised name, spelt out in full.
    pub fn parameter(&self, name: &str) -> Option<&Parameter> {
        self.parameters.iter().find(|parameter| parameter.name.name == name)
    }

    /// The keyword line and all data lines of the same file.
    pub fn full_span(&self) -> Span {
        self.data.iter().fold(self.span, |span, line| span.to(line.span))
    }
}

impl DataLine {
    /// The value at a position; `None` where it is missing or blank.
    pub fn field(&self, position: usize) -> Option<&Field> {
        self.fields.get(position).filter(|field| !field.text.is_empty())
    }

    /// The place just behind the last value, where more was expected.
    pub fn end(&self) -> Span {
        Span { start: self.span.end, ..self.span }
    }
}

impl Parameter {
    /// Name and value together.
    pub fn span(&self) -> Span {
        self.value.as_ref().map_or(self.name.span, |value| self.name.span.to(value.span))
    }
}
