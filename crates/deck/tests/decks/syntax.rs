//! The rules of the deck language (semantics: deck language), one by one.

#![allow(clippy::expect_used)] // a test may stop

use std::collections::HashMap;

use slideline_deck::{Deck, LineKind, LoadError, Loaded, Loader, NoFiles, Parsed, parse};
use slideline_diag::{Diagnostic, FileId, Severity, Sources};

struct Memory(HashMap<&'static str, &'static [u8]>);

impl Loader for Memory {
    fn load(&self, _: &[String], input: &str, _: usize) -> Result<Loaded, LoadError> {
        let bytes = self.0.get(input).ok_or(LoadError::Unreadable("no such file".into()))?;
        Ok(Loaded { name: input.to_owned(), bytes: bytes.to_vec(), outside: false })
    }
}

fn read(text: &str) -> (Sources, Parsed) {
    let mut sources = Sources::default();
    let parsed = parse(&mut sources, "a.inp", text.as_bytes(), &NoFiles);
    (sources, parsed)
}

fn deck(text: &str) -> Deck {
    let (_, parsed) = read(text);
    assert_eq!(parsed.diagnostics, [], "{text}");
    parsed.deck
}

fn told(sources: &Sources, diagnostics: &[Diagnostic]) -> Vec<String> {
    let one = |diagnostic: &Diagnostic| {
        let at = sources.locate(diagnostic.span.expect("a place")).expect("a known file");
        format!(
            "{}[{}] {}:{}:{}-{}",
            diagnostic.severity.word(),
            diagnostic.code,
            at.file,
            at.line,
            at.column,
            at.end_column
        )
    };
    diagnostics.iter().map(one).collect()
}

fn said(text: &str) -> Vec<String> {
    let (sources, parsed) = read(text);
    told(&sources, &parsed.diagnostics)
}

#[test]
fn a_keyword_is_continued_after_a_comma() {
    let deck = deck("*Beam Section, elset = Beam ,\n  Material=M\n1., 2.\n");
    let card = &deck.cards[0];
    assert_eq!(card.keyword.name, "BEAMSECTION");
    assert_eq!(card.keyword.raw, "Beam Section");
    assert_eq!(card.parameter("MATERIAL").and_then(|p| p.value.as_ref()).unwrap().name, "M");
    assert_eq!(card.data.len(), 1);
    assert_eq!(deck.files[0].lines[1].kind, LineKind::Keyword(0));
}

/// Requirement: a line with a bare number is data, also behind a comma too many; parameters begin
/// with a letter. Public decks of CalculiX, which continues no keyword, have such commas.
#[test]
fn data_behind_a_comma_too_many() {
    let deck = read("*BOUNDARY,\nLEFT, 1, 3\n*STEP,\nNLGEOM, INC=10\n").1.deck;
    assert!(deck.cards[0].parameters.is_empty());
    assert_eq!(deck.cards[0].data[0].fields.len(), 3);
    assert_eq!(deck.cards[1].parameters.len(), 2);
    assert_eq!(said("*BOUNDARY,\nLEFT, 1, 3\n"), ["warning[SL0108] a.inp:1:10-11"]);
}

#[test]
fn comments_are_kept_with_their_place() {
    let deck = deck("***** first\n*NODE\n1, 0.\n**INTERFACE, ELSET=A\n2, 0.\n");
    assert_eq!((deck.comments[0].card, deck.comments[0].data_before), (None, 0));
    assert_eq!((deck.comments[1].card, deck.comments[1].data_before), (Some(0), 1));
    assert_eq!(deck.comments[1].text, "**INTERFACE, ELSET=A");
    assert_eq!(deck.cards[0].data.len(), 2);
}

#[test]
fn a_trailing_comma_and_a_blank_value() {
    let deck = deck("*NSET, NSET=A\nBEARINGC,\n9999, 1,, 0.0\n");
    assert_eq!(deck.cards[0].data[0].fields.len(), 1);
    let second = &deck.cards[0].data[1];
    assert_eq!(second.fields.len(), 4);
    assert!(second.field(2).is_none());
}

#[test]
fn titles_may_hold_anything() {
    assert_eq!(said("*HEADING\nsay \"hi, \u{1}there\n*STEP\nit's, a \"title\n"), [""; 0]);
}

#[test]
fn every_error_in_one_go_with_its_columns() {
    let text = "1, 2\n*\n*NODE, NSET=, NSET=A,, B\n1, \u{7}\n*NODE,\n1, \"x\n";
    assert_eq!(
        said(text),
        [
            "error[SL0102] a.inp:1:1-5",
            "error[SL0104] a.inp:2:1-2",
            "error[SL0105] a.inp:3:8-13",
            "error[SL0106] a.inp:3:15-21",
            "warning[SL0107] a.inp:3:22-22",
            "error[SL0110] a.inp:4:4-5",
            "warning[SL0108] a.inp:5:6-7",
            "error[SL0103] a.inp:6:4-5",
        ]
    );
}

#[test]
fn an_empty_deck_says_so() {
    assert_eq!(said(""), ["error[SL0101] a.inp:1:1-1"]);
    assert_eq!(said("** nothing\n\n"), ["error[SL0101] a.inp:1:1-1"]);
    // A note on the way does not make it a deck.
    let parsed = parse(&mut Sources::default(), "a.inp", b"** \xe9\n", &NoFiles);
    let codes: Vec<_> = parsed.diagnostics.iter().map(|said| said.code.0).collect();
    assert_eq!(codes, ["SL0109", "SL0101"]);
}

#[test]
fn limits_are_errors_not_cuts() {
    let many = vec!["1"; 17].join(",");
    assert_eq!(said(&format!("*NSET\n{many}\n")), ["error[SL0113] a.inp:2:33-34"]);
    let long = "1".repeat(slideline_deck::MAX_LINE_BYTES + 1);
    assert_eq!(said(&format!("*NSET\n{long}\n1\n")).len(), 1);
    let rubbish = "*\n".repeat(3000);
    let said = said(&rubbish);
    assert_eq!(said.len(), slideline_diag::MAX_OF_ONE_CODE + 1);
    assert!(said.last().unwrap().starts_with("note[SL0115]"));
}

#[test]
fn broken_bytes_are_an_error_in_data_and_a_note_elsewhere() {
    let mut sources = Sources::default();
    let bytes = b"** d\xfcse\n*HEADING\nd\xfcse\n*NODE\n1, \xfc\xfc\n2, 0.\r1\n";
    let parsed = parse(&mut sources, "a.inp", bytes, &NoFiles);
    assert_eq!(
        told(&sources, &parsed.diagnostics),
        ["note[SL0109] a.inp:1:5-6", "error[SL0109] a.inp:5:4-6", "error[SL0111] a.inp:6:6-7"]
    );
}

#[test]
fn files_are_read_in_place() {
    let files = Memory(HashMap::from([
        ("beam.inp", &b"2, 0.\n*NSET, NSET=A\n1\n"[..]),
        ("bad.inp", b"*INCLUDE, INPUT=bad.inp\n*\n"),
    ]));
    let text = b"*NODE\n1, 0.\n*INCLUDE, INPUT=beam.inp\n2\n*INCLUDE, INPUT=none.inp\n\
        *INCLUDE\n*INCLUDE, INPUT=bad.inp\n";
    let mut sources = Sources::default();
    let parsed = parse(&mut sources, "a.inp", text, &files);
    let data: Vec<usize> = parsed.deck.cards.iter().map(|card| card.data.len()).collect();
    assert_eq!(data, [2, 2], "data lines go on across files");
    assert_eq!(
        told(&sources, &parsed.diagnostics),
        [
            "error[SL0120] a.inp:5:17-25",
            "error[SL0123] a.inp:6:1-9",
            "error[SL0121] bad.inp:1:17-24",
            "error[SL0104] bad.inp:2:1-2",
        ]
    );
    assert_eq!(parsed.deck.print(FileId(0)), text);
}

#[test]
fn nesting_has_a_limit() {
    struct Deeper;
    impl Loader for Deeper {
        fn load(&self, open: &[String], input: &str, _: usize) -> Result<Loaded, LoadError> {
            let bytes = b"*INCLUDE, INPUT=x\n".to_vec();
            Ok(Loaded { name: format!("{}/{input}", open.len()), bytes, outside: false })
        }
    }
    let mut sources = Sources::default();
    let parsed = parse(&mut sources, "a", b"*INCLUDE, INPUT=x\n", &Deeper);
    assert_eq!(parsed.diagnostics.len(), 1);
    assert_eq!(parsed.diagnostics[0].code.0, "SL0122");
    assert_eq!(parsed.diagnostics[0].severity, Severity::Error);
    assert_eq!(parsed.deck.files.len(), slideline_deck::MAX_DEPTH + 1);
}

#[test]
fn a_comment_can_be_read_as_the_keyword_it_hides() {
    let deck = deck("*NODE\n1, 0.\n**INTERFACE, ELSET=ISL\n** prose, here\n***\n");
    let card = slideline_deck::comment_as_card(&deck.comments[0]).unwrap();
    assert_eq!(card.keyword.name, "INTERFACE");
    assert_eq!(card.parameter("ELSET").and_then(|p| p.value.as_ref()).unwrap().name, "ISL");
    assert!(deck.comments[1..].iter().all(|c| slideline_deck::comment_as_card(c).is_none()));
}

/// Requirement: `INPUT=` of a card draws data lines in from a file, before those behind the card; of
/// keywords that have none in a file it stays a parameter. A file that is missing is named.
#[test]
fn data_lines_from_another_file() {
    use slideline_deck::Texts;
    let texts = [("far.txt".to_owned(), "1, 0., 0.\n** between\n2, 1., 0.\n".to_owned())];
    let read = |deck: &str| {
        let mut sources = slideline_diag::Sources::default();
        slideline_deck::parse(&mut sources, "deck.inp", deck.as_bytes(), &Texts(&texts))
    };
    let parsed = read("*NODE, NSET=ALL, INPUT=far.txt\n3, 2., 0.\n*NSET, NSET=A\n1\n");
    let numbers = |card: &slideline_deck::Card| -> Vec<String> {
        card.data.iter().map(|line| line.fields[0].text.clone()).collect()
    };
    assert!(parsed.diagnostics.is_empty(), "{:?}", parsed.diagnostics);
    assert_eq!(numbers(&parsed.deck.cards[0]), ["1", "2", "3"]);
    assert_eq!(numbers(&parsed.deck.cards[1]), ["1"]);
    assert!(read("*BOUNDARY, INPUT=far.txt\n1, 1\n").deck.cards[0].data.len() == 1);
    let missing = read("*ELEMENT, TYPE=B21, INPUT=none.txt\n");
    assert_eq!(missing.diagnostics[0].code.0, "SL0120");
}
