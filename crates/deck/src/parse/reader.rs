//! What is known while a deck is read: the tree so far, the open files, the counts.

use slideline_diag::{Diagnostic, FileId, Listing, Sources, Span};

use crate::card::{Deck, Line, LineKind};
use crate::include::Loader;
use crate::lines::{RawLine, offset, strip};
use crate::split::Stretch;

/// Whom data lines belong to.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Owner {
    Nobody,
    Card(usize),
    /// A line already complained about; what follows it is passed over.
    Skipped,
}

/// A deck while it is read.
pub(super) struct Reader<'a> {
    pub sources: &'a mut Sources,
    pub loader: &'a dyn Loader,
    pub deck: Deck,
    pub diagnostics: Listing,
    pub is_said_full: bool,
    pub open_files: Vec<String>,
    pub total_bytes: usize,
    pub total_lines: usize,
    pub total_values: usize,
    pub owner: Owner,
}

/// One file while it is read.
pub(super) struct Page<'t> {
    pub index: usize,
    pub file: FileId,
    pub text: &'t str,
    pub broken: Vec<usize>,
    pub noted_broken: bool,
}

impl<'t> Page<'t> {
    /// The text between two places of the file, without blanks at its ends.
    pub fn stretch(&self, start: usize, end: usize) -> Stretch<'t> {
        let part = strip(&self.text[start..end]);
        Stretch { file: self.file, start: offset(self.text, part), text: part }
    }

    /// The first bytes between two places that are not UTF-8.
    pub fn first_broken(&self, start: usize, end: usize) -> Option<Span> {
        let first = self.broken.partition_point(|&at| at < start);
        let run = self.broken[first..].iter().take_while(|&&at| at < end);
        let begin = *self.broken.get(first).filter(|&&at| at < end)?;
        let length = run.enumerate().take_while(|&(k, &at)| at == begin + k).count();
        Some(Span::new(self.file, begin, begin + length))
    }
}

impl<'a> Reader<'a> {
    /// A reader that has read nothing.
    pub fn new(sources: &'a mut Sources, loader: &'a dyn Loader) -> Self {
        Self {
            sources,
            loader,
            deck: Deck::default(),
            diagnostics: Listing::default(),
            is_said_full: false,
            open_files: Vec::new(),
            total_bytes: 0,
            total_lines: 0,
            total_values: 0,
            owner: Owner::Nobody,
        }
    }

    /// Keeps what is to be said.
    pub fn report(&mut self, diagnostic: Diagnostic) {
        self.diagnostics.push(diagnostic);
    }

    /// Keeps a line of the open file, with what it is.
    pub fn keep(&mut self, page: &Page<'_>, line: RawLine, kind: LineKind) {
        let span = Span::new(page.file, line.start, line.end);
        if let Some(file) = self.deck.files.get_mut(page.index) {
            file.lines.push(Line { span, kind });
        }
    }
}
