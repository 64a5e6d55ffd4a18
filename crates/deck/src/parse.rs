//! The reading itself: lines to cards, files in place of `*INCLUDE`.

mod files;
mod reader;

use slideline_diag::{Code, Diagnostic, Sources, Span};

use crate::card::{Card, Comment, DataLine, Deck, Field, FileLines, LineKind, Parameter};
use crate::include::Loader;
use crate::limits::{MAX_LINE_BYTES, MAX_PARAMETERS, MAX_VALUES_PER_LINE};
use crate::lines::{Look, RawLine, aligned, line_at, look, strip};
use crate::split::{Stretch, at_commas, fields, parameter, word};
use reader::{Owner, Page, Reader};

/// What reading a deck gives.
#[derive(Clone, Debug)]
pub struct Parsed {
    /// The cards and lines, as complete as the text allows.
    pub deck: Deck,
    /// Everything there is to say about the syntax.
    pub diagnostics: Vec<Diagnostic>,
}

/// Reads a deck: any bytes, never failing, every error in one go.
///
/// `name` is the deck's name for messages and, for [`crate::FromDisk`], the
/// path its includes are relative to. Texts are added to `sources`.
pub fn parse(sources: &mut Sources, name: &str, bytes: &[u8], loader: &dyn Loader) -> Parsed {
    let mut reader = Reader::new(sources, loader);
    reader.file(name, bytes.to_vec());
    let Reader { deck, diagnostics, .. } = reader;
    let mut diagnostics = diagnostics.into_diagnostics();
    if deck.cards.is_empty() && !slideline_diag::has_errors(&diagnostics) {
        let root = deck.files.first().map(|lines| Span::new(lines.file, 0, 0));
        let empty = Diagnostic::error(Code("SL0101"), "the deck is empty: it has no keyword line");
        diagnostics.push(empty.at(root).help("a deck begins with *HEADING or *NODE"));
    }
    Parsed { deck, diagnostics }
}

impl Reader<'_> {
    fn file(&mut self, name: &str, bytes: Vec<u8>) {
        let (text, broken) = aligned(&bytes);
        let file = self.sources.add(name, text.clone());
        let index = self.deck.files.len();
        self.total_bytes += bytes.len();
        self.deck.files.push(FileLines { file, bytes, lines: Vec::new() });
        let mut page = Page { index, file, text: &text, broken, noted_broken: false };
        if let Some(error) = self.no_deck(file, &text) {
            self.rest(&page, 0);
            self.report(error);
            return;
        }
        self.open_files.push(name.to_owned());
        let mut at = 0;
        while at < text.len() {
            if self.is_full(&page, at) {
                self.rest(&page, at);
                break;
            }
            at = self.line(&mut page, at);
        }
        self.open_files.pop();
    }

    /// Reads the line (or continued keyword line) at `at`; returns where the
    /// next one begins.
    fn line(&mut self, page: &mut Page<'_>, at: usize) -> usize {
        let line = line_at(page.text, at);
        self.total_lines += 1;
        let content = &page.text[line.start..line.content_end];
        match look(content) {
            Look::Blank => self.keep(page, line, LineKind::Blank),
            Look::Comment => self.comment(page, line),
            Look::Keyword | Look::Data if content.len() > MAX_LINE_BYTES => {
                self.keep(page, line, LineKind::Stray);
                if look(content) == Look::Keyword {
                    self.owner = Owner::Skipped;
                }
                let message = format!("the line is longer than {MAX_LINE_BYTES} bytes");
                let span = Span::new(page.file, line.start, line.content_end);
                self.report(Diagnostic::error(Code("SL0112"), message).at(span));
            }
            Look::Keyword => return self.keyword(page, line),
            Look::Data => self.data(page, line),
        }
        line.end
    }

    fn comment(&mut self, page: &mut Page<'_>, line: RawLine) {
        self.keep(page, line, LineKind::Comment);
        self.note_broken(page, line, "a comment");
        let stretch = page.stretch(line.start, line.content_end);
        let card = match self.owner {
            Owner::Card(card) => Some(card),
            _ => None,
        };
        let data_before = card.map_or(0, |card| self.deck.cards[card].data.len());
        let text = stretch.text.to_owned();
        self.deck.comments.push(Comment { text, span: stretch.span(), card, data_before });
    }

    /// Broken bytes where they do no harm: said once for each file.
    fn note_broken(&mut self, page: &mut Page<'_>, line: RawLine, place: &str) {
        if page.noted_broken {
            return;
        }
        if let Some(span) = page.first_broken(line.start, line.end) {
            page.noted_broken = true;
            let message =
                format!("{place} holds bytes that are not UTF-8; they are kept as they are");
            self.report(Diagnostic::note(Code("SL0109"), message).at(span));
        }
    }

    /// Bytes that have no place on a keyword or data line.
    fn check_bytes(&mut self, page: &Page<'_>, start: usize, end: usize) {
        if let Some(span) = page.first_broken(start, end) {
            let error = Diagnostic::error(Code("SL0109"), "these bytes are not UTF-8 text");
            self.report(error.at(span).help("save the deck as UTF-8, or write plain ASCII here"));
        }
        let content = &page.text[start..end];
        let returns =
            content.match_indices('\r').find(|&(at, _)| !content[at..].starts_with("\r\n"));
        if let Some((at, _)) = returns {
            let span = Span::new(page.file, start + at, start + at + 1);
            let error = Diagnostic::error(Code("SL0111"), "a carriage return without a line feed");
            self.report(error.at(span).help("save the deck with LF or CR LF line endings"));
        }
        let odd = |c: char| c.is_control() && !matches!(c, '\t' | '\r' | '\n');
        if let Some((at, c)) = content.char_indices().find(|&(_, c)| odd(c)) {
            let span = Span::new(page.file, start + at, start + at + c.len_utf8());
            let message = format!("a control character (U+{:04X})", u32::from(c));
            self.report(Diagnostic::error(Code("SL0110"), message).at(span));
        }
    }

    fn data(&mut self, page: &mut Page<'_>, line: RawLine) {
        let stretch = page.stretch(line.start, line.content_end);
        let Owner::Card(card) = self.owner else {
            self.keep(page, line, LineKind::Stray);
            if self.owner == Owner::Nobody {
                self.owner = Owner::Skipped;
                let error = Diagnostic::error(Code("SL0102"), "data before the first keyword");
                self.report(error.at(stretch.span()).help("every data line belongs to a keyword"));
            }
            return;
        };
        self.keep(page, line, LineKind::Data(card));
        let (mut fields, open) = fields(stretch);
        if is_text_card(&self.deck.cards[card]) {
            self.note_broken(page, line, "a title");
        } else {
            self.check_bytes(page, line.start, line.content_end);
            self.check_fields(&fields, open);
            fields.truncate(MAX_VALUES_PER_LINE);
        }
        self.total_values += fields.len();
        let text = stretch.text.to_owned();
        self.deck.cards[card].data.push(DataLine { text, span: stretch.span(), fields });
    }

    fn check_fields(&mut self, fields: &[Field], open: Option<Span>) {
        self.check_quotation(open);
        if let Some(first) = fields.get(MAX_VALUES_PER_LINE) {
            let message = format!(
                "{} values on one line; at most {MAX_VALUES_PER_LINE} are allowed",
                fields.len()
            );
            let last = fields.last().map_or(first.span, |field| field.span);
            let error = Diagnostic::error(Code("SL0113"), message).at(first.span.to(last));
            self.report(error.help("continue on the next line"));
        }
    }

    fn check_quotation(&mut self, open: Option<Span>) {
        if let Some(span) = open {
            let error = Diagnostic::error(Code("SL0103"), "this quotation is not closed");
            self.report(error.at(span));
        }
    }

    /// A keyword line with all its continuations.
    fn keyword(&mut self, page: &mut Page<'_>, first: RawLine) -> usize {
        let (lines, dangling) = continued(page.text, first);
        let end = lines.last().map_or(first.content_end, |line| line.content_end);
        let stretch = page.stretch(first.start, end);
        self.check_bytes(page, first.start, end);
        if dangling {
            self.dangling_comma(stretch);
        }
        let kind = self.keyword_card(stretch);
        for &line in &lines {
            self.keep(page, line, kind);
        }
        let next = lines.last().map_or(first.end, |line| line.end);
        let loaded = match kind {
            LineKind::Include => self.include(),
            LineKind::Keyword(card) => self.data_elsewhere(card),
            _ => None,
        };
        if let Some(loaded) = loaded {
            self.file(&loaded.name, loaded.bytes);
        }
        next
    }

    fn dangling_comma(&mut self, stretch: Stretch<'_>) {
        let end = stretch.span().end;
        let comma = Span { start: end.saturating_sub(1), ..stretch.span() };
        let message = "the keyword line ends in a comma, but no parameter follows";
        let warning = Diagnostic::warning(Code("SL0108"), message).at(comma).edit(comma, "");
        self.report(warning.help("remove the comma, or continue the keyword on the next line"));
    }

    /// Makes the card and says what its lines are. An `*INCLUDE` becomes the
    /// last card for a moment; [`Reader::include`] takes it off again.
    fn keyword_card(&mut self, stretch: Stretch<'_>) -> LineKind {
        let inner = stretch.part(&stretch.text[1..]);
        let (pieces, open) = at_commas(inner);
        self.check_quotation(open);
        let keyword = word(pieces.first().copied().unwrap_or(inner));
        if keyword.name.is_empty() {
            self.owner = Owner::Skipped;
            let error = Diagnostic::error(Code("SL0104"), "a star without a keyword");
            self.report(error.at(stretch.span()).help("a comment begins with two stars"));
            return LineKind::Stray;
        }
        let parameters = self.parameters(&pieces[1..]);
        let include = keyword.name == "INCLUDE";
        let card = Card { keyword, parameters, data: Vec::new(), span: stretch.span() };
        let number = self.deck.cards.len();
        self.deck.cards.push(card);
        if include {
            return LineKind::Include;
        }
        self.owner = Owner::Card(number);
        LineKind::Keyword(number)
    }

    fn parameters(&mut self, pieces: &[Stretch<'_>]) -> Vec<Parameter> {
        let mut read: Vec<Parameter> = Vec::new();
        if let Some(first) = pieces.get(MAX_PARAMETERS) {
            let message = format!("more than {MAX_PARAMETERS} parameters on one keyword line");
            self.report(Diagnostic::error(Code("SL0113"), message).at(first.span()));
        }
        for (k, piece) in pieces.iter().enumerate().take(MAX_PARAMETERS) {
            if piece.text.is_empty() {
                if k + 1 < pieces.len() {
                    let text = "nothing between two commas of a keyword line";
                    self.report(Diagnostic::warning(Code("SL0107"), text).at(piece.span()));
                }
                continue;
            }
            let new = parameter(*piece);
            if new.value.as_ref().is_some_and(|value| value.raw.is_empty()) {
                let message = format!("the parameter {} has no value", new.name.raw);
                self.report(Diagnostic::error(Code("SL0105"), message).at(new.span()));
            }
            if let Some(old) = read.iter().find(|old| old.name.name == new.name.name) {
                let message = format!("the parameter {} is given twice", new.name.raw);
                let error = Diagnostic::error(Code("SL0106"), message).at(new.span());
                let error = error.label(old.span(), "given here already");
                self.report(error);
                continue;
            }
            read.push(new);
        }
        read
    }
}

/// Cards followed by a title, not by values.
fn is_text_card(card: &Card) -> bool {
    let name = &card.keyword.name;
    name == "STEP" || (name.len() >= 4 && "HEADING".starts_with(name.as_str()))
}

/// Whether a piece of a line is a value and no parameter: these begin with a letter.
fn is_a_value(piece: &str) -> bool {
    let piece = piece.trim_start();
    piece.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c))
}

/// Parameters without a value of the cards that ask for results, without blanks.
const REQUEST_FLAGS: [&str; 22] = [
    "TOTALS",
    "SUMMARY",
    "FIELD",
    "HISTORY",
    "SECTIONFORCES",
    "EXTERIOR",
    "GLOBAL",
    "LASTITERATIONS",
    "CONTACTELEMENTS",
    "CONTACTELEMENT",
    "OUTPUT",
    "OUTPUTALL",
    "SECONDSURFACE",
    "GENERALCONTACT",
    "MICROSCALE",
    "DIAGNOSTIC",
    "MODELIST",
    "ALLNODES",
    "TIMEPOINTS",
    "POSITION",
    "REBAR",
    "SENSOR",
];

/// Whether a line behind the comma of a keyword names what is to be written, which the data lines of some cards do: that
/// comma is one too many, and no parameters follow.
fn names_results(text: &str, first: RawLine, content: &str) -> bool {
    let plain = |piece: &str| -> String {
        piece.chars().filter(|c| !c.is_whitespace()).collect::<String>().to_ascii_uppercase()
    };
    let line = &text[first.start..first.content_end];
    let keyword = plain(line.split(',').next().unwrap_or_default());
    let asks = ["FILE", "PRINT", "OUTPUT"].iter().any(|last| keyword.ends_with(last));
    let mut pieces = content.split(',').map(plain).filter(|piece| !piece.is_empty());
    asks && !pieces.all(|piece| piece.contains('=') || REQUEST_FLAGS.contains(&&piece[..]))
}

/// The lines of a keyword that ends in commas; and whether the last comma
/// promises a continuation that does not come.
fn continued(text: &str, first: RawLine) -> (Vec<RawLine>, bool) {
    let mut lines = vec![first];
    let mut last = first;
    while strip(&text[last.start..last.content_end]).ends_with(',') {
        if last.end >= text.len() {
            return (lines, true);
        }
        let next = line_at(text, last.end);
        let content = strip(&text[next.start..next.content_end]);
        let value = content.starts_with(',')
            || content.split(',').any(is_a_value)
            || names_results(text, first, content);
        let size = next.content_end - first.start;
        if look(content) != Look::Data || value || size > MAX_LINE_BYTES {
            return (lines, true);
        }
        lines.push(next);
        last = next;
    }
    (lines, false)
}
