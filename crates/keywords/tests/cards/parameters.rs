//! Values behind names: they stand wherever a number may stand, and may be given from outside.

#![allow(clippy::expect_used)] // a test may stop

use slideline_deck::{FromDisk, NoFiles, Parsed, apply, parse, parse_number};
use slideline_diag::{Diagnostic, Edit, FileId, Severity, Sources, Span};
use slideline_keywords::{Interpreted, Prepared, Setting, interpret, interpret_with};
use slideline_model::{Dialect, Model};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

const DECK: &str = include_str!("../../../../corpus/keywords/PARAMETER.inp");

fn set(text: &str, settings: &[(&str, &str)]) -> Interpreted {
    let parsed = parse(&mut Sources::default(), "a.inp", text.as_bytes(), &NoFiles);
    let own = |&(name, value): &(&str, &str)| Setting {
        name: name.to_owned(),
        value: value.to_owned(),
        span: None,
    };
    interpret_with(&settings.iter().map(own).collect::<Vec<_>>(), &parsed, Dialect::Abaqus)
}

fn errors(read: &Interpreted) -> Vec<&Diagnostic> {
    read.diagnostics.iter().filter(|said| said.severity == Severity::Error).collect()
}

fn corner(read: &Interpreted) -> [f64; 3] {
    let nodes = &read.model.nodes;
    nodes.position(nodes.find(3).expect("a node of the deck"))
}

/// Requirement: a value from outside stands in place of the first value of the deck, and what is
/// computed of the name follows it; a value that the deck gives later counts from there on.
/// Source: contract, `run --set NAME=VALUE`.
#[test]
#[allow(clippy::float_cmp)] // values of the deck
fn a_setting_stands_in_place_of_the_first_value() {
    assert_eq!(corner(&set(DECK, &[])), [10.0e-3, 5.0e-3, 0.0]);
    assert_eq!(corner(&set(DECK, &[("length", "0.03")])), [0.03, 0.015, 0.0]);
    assert_eq!(corner(&set(DECK, &[("length", "3*(1.0e-2)")])), [0.03, 0.015, 0.0]);
    assert_eq!(corner(&set(DECK, &[("half", "7.5e-3")])), [10.0e-3, 7.5e-3, 0.0]);
    assert_eq!(corner(&set(DECK, &[("half", "1"), ("length", "2")])), [2.0, 1.0, 0.0]);
    let later = DECK.replace("*NODE\n", "length = 0.5\n*NODE\n");
    assert_eq!(corner(&set(&later, &[("length", "0.03")])), [0.5, 0.015, 0.0]);
}

/// Requirement: a deck that is prepared for many values says of each what it says of it alone, with
/// misprints and without.
#[test]
fn a_prepared_deck_means_the_same() {
    let furniture = DECK.replace("*ELEMENT", "Continued on next page of the listing\n*ELEMENT");
    for text in [DECK, &furniture] {
        let parsed = parse(&mut Sources::default(), "a.inp", text.as_bytes(), &NoFiles);
        let prepared = Prepared::new(parsed, Dialect::Abaqus);
        for value in ["0.03", "0.04", "nothing"] {
            let setting = Setting { name: "length".into(), value: value.into(), span: None };
            let (own, alone) =
                (prepared.interpret_with(&[setting]), set(text, &[("length", value)]));
            assert_eq!(own.model, alone.model);
            assert_eq!(own.diagnostics, alone.diagnostics);
            assert_eq!(own.numbers, alone.numbers);
        }
    }
    assert!(set(&furniture, &[]).diagnostics.iter().any(|said| said.code.0 == "SL0212"));
}

/// Requirement: a number has the bits that it had outside. Source: issue 14, same bits.
#[test]
fn a_number_keeps_its_bits() {
    for number in [0.1_f64 + 0.2, 1.0 / 3.0, -1.0e-300, 5e-324, f64::MAX] {
        let read = set(DECK, &[("half", &format!("{number:?}"))]);
        assert_eq!(corner(&read)[1].to_bits(), number.to_bits());
    }
}

/// Requirement: a name that the deck does not define is an error that names the nearest one and
/// lists the others; a value that is none and a name set twice are errors. One error for each.
#[test]
fn settings_that_cannot_be() {
    let said = |deck: &str, settings: &[(&str, &str)]| {
        let read = set(deck, settings);
        let all = errors(&read);
        assert_eq!(all.len(), 1, "{all:?}");
        (all[0].code.0, all[0].message.clone(), all[0].help.clone().unwrap_or_default())
    };
    let (code, message, help) = said(DECK, &[("lenght", "1.0")]);
    assert_eq!((code, message.as_str()), ("SL0801", "the deck has no parameter lenght"));
    assert!(help.contains("did you mean length?"), "{help}");
    assert!(help.contains("half, length, modulus"), "{help}");
    assert!(said(DECK, &[("Length", "1.0")]).2.contains("did you mean length?"));
    let bare =
        DECK.replace("*PARAMETER\nlength = 10.0E-3\nmodulus = 210.0E9\nhalf = length/2\n", "");
    let bare = bare.replace("<length>", "1.0").replace("<half>", "0.5").replace("<modulus>", "1e9");
    assert!(said(&bare, &[("mu", "0.2")]).2.contains("`mu = ...`"));
    for value in ["", "0.1.2", "abc", "length/2", "1/3", "sqrt(-1.0)", "nan", "inf", "1e999", "0,2"]
    {
        let (code, message, _) = said(DECK, &[("length", value)]);
        assert_eq!(code, "SL0802", "{value}: {message}");
    }
    assert_eq!(said(DECK, &[("length", "1.0"), ("length", "2.0")]).0, "SL0802");
    let broken = DECK.replace("length/2", "1/2");
    assert_eq!(said(&broken, &[("half", "0.5")]).0, "SL0286");
}

/// Requirement: an error at a value behind a name says the name and the value, and what follows from
/// a parameter without a value is not complained about as well.
#[test]
fn errors_say_the_values_of_parameters() {
    let messages = |deck: &str, settings: &[(&str, &str)]| {
        errors(&set(deck, settings)).iter().map(|own| own.message.clone()).collect::<Vec<_>>()
    };
    let said = messages(DECK, &[("modulus", "0")]);
    assert_eq!(said, ["Young's modulus must be positive (modulus = 0)"]);
    let chain = "half = 1.0/length\nquarter = half/2.0\neighth = quarter/2.0\n";
    let broken = DECK.replace("half = length/2\n", chain);
    let said = messages(&broken, &[("length", "0")]);
    assert_eq!(said.len(), 1, "{said:?}");
    let own = "the parameter half has no value: it is divided by zero (with length = 0)";
    assert_eq!(said[0], own);
}

/// Requirement: what is underlined is the piece of the value that is to blame; a number that is too large is called so.
#[test]
fn the_piece_to_blame_is_underlined() {
    for (value, piece) in
        [("2*lenght/2", "lenght"), ("1.0 + 3.4.5", "3.4.5"), ("length*", "half = length*")]
    {
        let broken = DECK.replace("half = length/2", &format!("half = {value}"));
        let read = set(&broken, &[]);
        let span = errors(&read)[0].span.unwrap();
        assert_eq!(&broken[span.start as usize..span.end as usize], piece);
    }
    let large = DECK.replace("half = length/2", "half = 99999999999999999999");
    assert!(errors(&set(&large, &[]))[0].message.contains("too large"));
}

/// The deck with a name in place of every number, and the values of the names at its head.
fn behind_names(parsed: &Parsed) -> Vec<u8> {
    let mut values = String::from("*PARAMETER\n");
    let mut edits = Vec::new();
    let mut replace = |text: &str, span: Span| {
        if span.file == FileId(0) && is_plain(text) {
            let _ = writeln!(values, "p{} = {text}", edits.len()); // a String takes any text
            edits.push(Edit { span, replacement: format!("<p{}>", edits.len()) });
        }
    };
    for card in &parsed.deck.cards {
        let title = ["HEADING", "STEP", "PARAMETER"].contains(&card.keyword.name.as_str());
        for value in card.parameters.iter().filter_map(|parameter| parameter.value.as_ref()) {
            replace(&value.raw, value.span);
        }
        for field in card.data.iter().filter(|_| !title).flat_map(|line| &line.fields) {
            replace(&field.text, field.span);
        }
    }
    let applied = apply(&parsed.deck, FileId(0), &edits);
    assert_eq!(applied.refused, []);
    [values.into_bytes(), applied.bytes].concat()
}

/// Whether an expression may say the number in the same letters.
fn is_plain(text: &str) -> bool {
    let sign = text.strip_prefix(['+', '-']).unwrap_or(text);
    parse_number(text).is_ok()
        && sign.starts_with(|first: char| first.is_ascii_digit() || first == '.')
        && !text.contains(['d', 'D'])
}

/// What a model says without the places in its deck.
fn without_places(model: &Model) -> String {
    let text = without(&format!("{model:?}"), "Span {");
    without(&text, "by_label: {")
}

/// A text without what stands between `begin` and the next closing brace.
fn without(text: &str, begin: &str) -> String {
    let mut kept = String::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once(begin) {
        kept.push_str(before);
        rest = after.split_once('}').map_or("", |(_, behind)| behind);
    }
    kept + rest
}

/// Where two models begin to differ.
fn difference(own: &Model, other: &Model) -> Option<(String, String)> {
    let (own, other) = (without_places(own), without_places(other));
    let from = own.bytes().zip(other.bytes()).take_while(|(a, b)| a == b).count();
    let part = |text: &str| text.chars().skip(from.saturating_sub(200)).take(400).collect();
    (own != other).then(|| (part(&own), part(&other)))
}

fn decks() -> Vec<PathBuf> {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../corpus");
    let folders = ["keywords", "diehl1995", "tutorial", "sound", "field"];
    let mut decks = Vec::new();
    for folder in folders {
        let entries = std::fs::read_dir(corpus.join(folder)).expect("a folder of the corpus");
        let paths = entries.map(|entry| entry.expect("an entry").path());
        decks.extend(paths.filter(|path| path.extension().is_some_and(|end| end == "inp")));
    }
    decks.sort();
    decks
}

/// Requirement: `<name>` stands wherever a number may stand: every number of every sound deck behind
/// a name gives the model that the deck gives. Source: Abaqus manual, parametric input; issue 14.
#[test]
fn every_number_may_have_a_name() {
    let mut compared = 0;
    for path in decks() {
        let name = path.display().to_string();
        let bytes = std::fs::read(&path).expect("a deck");
        let parsed = parse(&mut Sources::default(), &name, &bytes, &FromDisk);
        let plain = interpret(&parsed, Dialect::Abaqus);
        if !errors(&plain).is_empty() {
            continue;
        }
        let own = behind_names(&parsed);
        let parsed = parse(&mut Sources::default(), &name, &own, &FromDisk);
        let named = interpret(&parsed, Dialect::Abaqus);
        assert_eq!(errors(&named), Vec::<&Diagnostic>::new(), "{name}");
        assert_eq!(difference(&named.model, &plain.model), None, "{name}");
        compared += 1;
    }
    assert!(compared > 150, "only {compared} decks");
}
