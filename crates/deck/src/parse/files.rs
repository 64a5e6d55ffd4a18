//! Which files are read, and how far.

use slideline_diag::{Code, Diagnostic, FileId, Span};

use super::reader::{Page, Reader};
use crate::card::{LineKind, Word};
use crate::include::{LoadError, Loaded};
use crate::limits::{MAX_BYTES, MAX_DEPTH, MAX_FILES, MAX_LINES, MAX_NULS, MAX_VALUES};
use crate::lines::RawLine;

/// Keywords whose data lines may stand in a file of their own, `INPUT=`.
const WITH_DATA_ELSEWHERE: [&str; 8] = [
    "NODE",
    "ELEMENT",
    "AMPLITUDE",
    "INITIALCONDITIONS",
    "TEMPERATURE",
    "DISTRIBUTION",
    "EQUATION",
    "MPC",
];

impl Reader<'_> {
    /// Why a file is not read at all.
    pub(super) fn no_deck(&self, file: FileId, text: &str) -> Option<Diagnostic> {
        if self.total_bytes > MAX_BYTES {
            let message = format!("the deck is larger than {} MiB", MAX_BYTES >> 20);
            let error = Diagnostic::error(Code("SL0114"), message).at(Span::new(file, 0, 0));
            return Some(
                error.help("a deck contains only text; generate nodes instead of listing them"),
            );
        }
        let mut nuls = text.match_indices('\0').map(|(at, _)| at);
        let first = nuls.next()?;
        nuls.nth(MAX_NULS - 1)?;
        let message = "this is not text: it is full of NUL bytes";
        let error =
            Diagnostic::error(Code("SL0110"), message).at(Span::new(file, first, first + 1));
        Some(error.help("a deck is UTF-8 text; this may be UTF-16, or a binary file"))
    }

    /// Whether no more lines are read; says so the first time.
    pub(super) fn is_full(&mut self, page: &Page<'_>, at: usize) -> bool {
        let lines = self.total_lines >= MAX_LINES;
        if !lines && self.total_values < MAX_VALUES {
            return false;
        }
        if !std::mem::replace(&mut self.is_said_full, true) {
            let (count, what) = if lines { (MAX_LINES, "lines") } else { (MAX_VALUES, "values") };
            let message = format!("the deck has more than {count} {what}; it is read up to here");
            let error = Diagnostic::error(Code("SL0124"), message).at(Span::new(page.file, at, at));
            self.diagnostics.push(error.help("generate nodes and elements: *NGEN, *ELGEN"));
        }
        true
    }

    /// Keeps what is left of a file without reading it.
    pub(super) fn rest(&mut self, page: &Page<'_>, start: usize) {
        let end = page.text.len();
        self.keep(page, RawLine { start, content_end: end, end }, LineKind::Stray);
    }

    /// The file named by the `*INCLUDE` that was pushed last, if it can be read.
    pub(super) fn include(&mut self) -> Option<Loaded> {
        let card = self.deck.cards.pop()?;
        for parameter in card.parameters.iter().filter(|parameter| parameter.name.name != "INPUT") {
            let message = format!("*INCLUDE has no parameter {}", parameter.name.raw);
            self.report(Diagnostic::error(Code("SL0202"), message).at(parameter.name.span));
        }
        let input = card.parameter("INPUT").and_then(|parameter| parameter.value.clone());
        let Some(input) = input else {
            let error = Diagnostic::error(Code("SL0123"), "*INCLUDE does not name a file");
            self.report(error.at(card.span).help("write *INCLUDE, INPUT=file.inp"));
            return None;
        };
        self.further(&input)
    }

    /// The file with the data of a card, if it names one that can be read: its lines come before
    /// those behind the card.
    pub(super) fn data_elsewhere(&mut self, card: usize) -> Option<Loaded> {
        let card = self.deck.cards.get(card)?;
        if !WITH_DATA_ELSEWHERE.contains(&card.keyword.name.as_str()) {
            return None;
        }
        let input = card.parameter("INPUT").and_then(|parameter| parameter.value.clone())?;
        self.further(&input)
    }

    /// A further file, as far as there may be more.
    fn further(&mut self, input: &Word) -> Option<Loaded> {
        if self.open_files.len() > MAX_DEPTH {
            let message = format!("files are included more than {MAX_DEPTH} deep");
            self.report(Diagnostic::error(Code("SL0122"), message).at(input.span));
            return None;
        }
        if self.deck.files.len() >= MAX_FILES {
            let message = format!("more than {MAX_FILES} files are included");
            self.report(Diagnostic::error(Code("SL0122"), message).at(input.span));
            return None;
        }
        self.load(&input.raw, input.span)
    }

    fn load(&mut self, input: &str, span: Span) -> Option<Loaded> {
        let left = MAX_BYTES.saturating_sub(self.total_bytes);
        match self.loader.load(&self.open_files, input, left) {
            Ok(loaded) if self.open_files.contains(&loaded.name) => {
                let message = format!("`{input}` includes itself");
                self.report(Diagnostic::error(Code("SL0121"), message).at(span));
                None
            }
            Ok(loaded) => {
                if loaded.outside {
                    let message = format!("`{input}` lies outside the folder of the deck");
                    self.report(Diagnostic::note(Code("SL0125"), message).at(span));
                }
                Some(loaded)
            }
            Err(LoadError::Unreadable(reason)) => {
                let message = format!("the file `{input}` cannot be read: {reason}");
                let help = "the name is relative to the folder of the file that includes it";
                self.report(Diagnostic::error(Code("SL0120"), message).at(span).help(help));
                None
            }
            Err(LoadError::TooLarge) => {
                let message = format!("with `{input}` the deck exceeds {} MiB", MAX_BYTES >> 20);
                self.report(Diagnostic::error(Code("SL0114"), message).at(span));
                None
            }
        }
    }
}
