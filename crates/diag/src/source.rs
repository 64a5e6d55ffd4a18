//! Texts that were read, and places in them.

/// Which of the read texts: the deck itself is file 0, included files follow.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct FileId(pub u32);

/// A stretch of one text, in bytes: `start..end`, end excluded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct Span {
    /// The text.
    pub file: FileId,
    /// First byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
}

impl Span {
    /// The stretch `start..end` of `file`.
    pub fn new(file: FileId, start: usize, end: usize) -> Self {
        let clip = |byte: usize| u32::try_from(byte).unwrap_or(u32::MAX);
        Self { file, start: clip(start), end: clip(end) }
    }

    /// The smallest stretch that covers both; `self` where the files differ.
    pub fn to(self, other: Self) -> Self {
        if self.file != other.file {
            return self;
        }
        Self { file: self.file, start: self.start.min(other.start), end: self.end.max(other.end) }
    }
}

/// One text with its name as the user knows it.
#[derive(Clone, Debug)]
pub struct Source {
    /// Name as shown in messages: the path the user gave or the deck includes.
    pub name: String,
    /// The whole text.
    pub text: String,
    line_starts: Vec<usize>,
}

/// A place as people count: lines and columns from 1, columns in characters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Location {
    /// Name of the text.
    pub file: String,
    /// First line.
    pub line: usize,
    /// Last line.
    pub end_line: usize,
    /// First column.
    pub column: usize,
    /// One past the last column (on `end_line`).
    pub end_column: usize,
}

/// All texts of one deck.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    files: Vec<Source>,
}

impl Sources {
    /// Takes a text in and returns its number.
    pub fn add(&mut self, name: impl Into<String>, text: impl Into<String>) -> FileId {
        let text = text.into();
        let line_starts =
            std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect();
        self.files.push(Source { name: name.into(), text, line_starts });
        FileId(u32::try_from(self.files.len() - 1).unwrap_or(u32::MAX))
    }

    /// The text of that number, if there is one.
    pub fn get(&self, file: FileId) -> Option<&Source> {
        self.files.get(file.0 as usize)
    }

    /// All texts in the order in which they were read.
    pub fn files(&self) -> &[Source] {
        &self.files
    }

    /// The stretch itself; empty where the span points outside the text.
    pub fn text(&self, span: Span) -> &str {
        self.get(span.file)
            .and_then(|source| source.text.get(span.start as usize..span.end as usize))
            .unwrap_or("")
    }

    /// Lines and columns of a span; `None` for an unknown file.
    pub fn locate(&self, span: Span) -> Option<Location> {
        let source = self.get(span.file)?;
        let (line, column) = source.line_and_column(span.start as usize);
        let (end_line, end_column) = source.line_and_column(span.end as usize);
        Some(Location { file: source.name.clone(), line, end_line, column, end_column })
    }
}

impl Source {
    fn line_and_column(&self, byte: usize) -> (usize, usize) {
        let byte = byte.min(self.text.len());
        let line = self.line_starts.partition_point(|&start| start <= byte);
        let start = self.line_starts[line - 1];
        let column = self.text.as_bytes()[start..byte]
            .iter()
            .filter(|&&b| b & 0xC0 != 0x80) // count characters, not continuation bytes
            .count();
        (line, column + 1)
    }

    /// The text of a line (from 1) without its line ending.
    pub fn line(&self, line: usize) -> &str {
        let Some(&start) = line.checked_sub(1).and_then(|index| self.line_starts.get(index)) else {
            return "";
        };
        let end = self.line_starts.get(line).copied().unwrap_or(self.text.len());
        self.text.get(start..end).unwrap_or("").trim_end_matches(['\n', '\r'])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_count_characters_and_lines_count_from_one() {
        let mut sources = Sources::default();
        let file = sources.add("a.inp", "*NODE\n1, \u{e9}x, 2\n");
        let at = sources.locate(Span::new(file, 9, 12)).unwrap();
        assert_eq!((at.line, at.column, at.end_column), (2, 4, 6));
        assert_eq!(sources.text(Span::new(file, 9, 12)), "\u{e9}x");
        assert_eq!(sources.files()[0].line(2), "1, \u{e9}x, 2");
    }

    #[test]
    fn a_span_outside_the_text_is_harmless() {
        let mut sources = Sources::default();
        let file = sources.add("a.inp", "");
        assert_eq!(sources.text(Span::new(file, 5, 9)), "");
        assert_eq!(sources.locate(Span::new(file, 5, 9)).unwrap().line, 1);
        assert!(sources.locate(Span::new(FileId(3), 0, 0)).is_none());
    }
}
