//! The corpus, deck by deck.
//!
//! Requirement (architecture, errors): a bad deck announces its own
//! diagnostics in comments, and both sides agree exactly; every code of the
//! reader has a bad deck and a page; every good deck gives no error and prints
//! back to itself. `SLIDELINE_BLESS=1` rewrites the announcements, which are
//! then to be reviewed.

#![allow(clippy::expect_used)] // a test may stop

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use slideline_deck::{FromDisk, parse};
use slideline_diag::{CATALOGUE, Diagnostic, FileId, Severity, Sources};
use slideline_keywords::{interpret, keywords};
use slideline_model::Dialect;

/// Codes of limits too large for a deck in the corpus, which the tests of the
/// deck crate show; and SL0326, which needs a run.
const WITHOUT_DECK: [&str; 7] =
    ["SL0112", "SL0114", "SL0115", "SL0122", "SL0124", "SL0326", "SL0399"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn decks(folder: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(root().join(folder)).expect("a folder of the corpus");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let mut decks: Vec<_> =
        paths.filter(|path| path.extension().is_some_and(|ext| ext == "inp")).collect();
    decks.sort();
    decks
}

fn diagnostics(path: &Path) -> (Sources, Vec<Diagnostic>) {
    let mut sources = Sources::default();
    let bytes = std::fs::read(path).expect("a deck");
    let parsed = parse(&mut sources, &path.display().to_string(), &bytes, &FromDisk);
    assert_eq!(parsed.deck.print(FileId(0)), bytes, "{}", path.display());
    let interpreted = interpret(&parsed, Dialect::Abaqus);
    (sources, interpreted.diagnostics)
}

/// `error[SL0203] 12:1-9: message`, with the file's name before the line in
/// included files and `line:column-line:column` over several lines.
fn announcement(sources: &Sources, diagnostic: &Diagnostic) -> String {
    let severity = diagnostic.severity.word();
    let place = diagnostic.span.map_or(String::new(), |span| {
        let at = sources.locate(span).expect("a known file");
        let file = Path::new(&at.file)
            .file_name()
            .map_or(String::new(), |name| format!("{}:", name.to_string_lossy()));
        let file = if span.file == FileId(0) { String::new() } else { file };
        let end = if at.end_line == at.line {
            at.end_column.to_string()
        } else {
            format!("{}:{}", at.end_line, at.end_column)
        };
        format!(" {file}{}:{}-{end}", at.line, at.column)
    });
    format!("{severity}[{}]{place}: {}", diagnostic.code, diagnostic.message)
}

#[test]
fn bad_decks_announce_their_errors() {
    let bless = std::env::var_os("SLIDELINE_BLESS").is_some();
    for path in decks("corpus/bad") {
        let (sources, diagnostics) = diagnostics(&path);
        let said: Vec<String> = diagnostics.iter().map(|d| announcement(&sources, d)).collect();
        let bytes = std::fs::read(&path).expect("a deck");
        if bless {
            rewrite(&path, &bytes, &said);
            continue;
        }
        let text = String::from_utf8_lossy(&bytes);
        let announced: Vec<&str> = text
            .lines()
            .filter(|line| !of_a_run(line))
            .filter_map(|line| line.strip_prefix("**! "))
            .collect();
        assert_eq!(said, announced, "{}", path.display());
    }
}

/// Whether a line announces what ends the run of a deck that reads well; the
/// tests of the library hold those against the run.
fn of_a_run(line: &str) -> bool {
    line.starts_with("**! error[SL05")
}

/// Puts the announcements at the end, where they move no line.
fn rewrite(path: &Path, bytes: &[u8], said: &[String]) {
    let lines = bytes.split_inclusive(|&byte| byte == b'\n');
    let keep = |line: &[u8]| !line.starts_with(b"**!") || of_a_run(&String::from_utf8_lossy(line));
    let mut new: Vec<u8> = lines.filter(|line| keep(line)).flatten().copied().collect();
    for line in said {
        new.extend(format!("**! {line}\n").bytes());
    }
    std::fs::write(path, new).expect("a writable deck");
}

#[test]
fn every_code_of_the_reader_has_a_page_and_a_bad_deck() {
    let mut shown = BTreeSet::new();
    for path in decks("corpus/bad") {
        shown.extend(diagnostics(&path).1.iter().map(|diagnostic| diagnostic.code.0));
    }
    for code in CATALOGUE.iter().map(|entry| entry.code.0).filter(|code| *code < "SL04") {
        let page = root().join(format!("docs/errors/{code}.md"));
        let text = std::fs::read_to_string(&page).unwrap_or_default();
        assert!(text.starts_with(&format!("# {code}: ")), "{code} has no page");
        assert!(shown.contains(code) || WITHOUT_DECK.contains(&code), "{code} has no deck");
        let stem = format!("{code}-");
        let own = decks("corpus/bad").into_iter().find(|path| {
            path.file_name().is_some_and(|name| name.to_string_lossy().starts_with(&stem))
        });
        if let Some(own) = own {
            let codes: Vec<_> = diagnostics(&own).1.iter().map(|d| d.code.0).collect();
            assert!(codes.contains(&code), "{} shows {codes:?}", own.display());
        }
    }
}

/// One slip, one error: no deck that is named for a code shows another error,
/// warnings and notes aside.
#[test]
fn no_error_is_followed_by_another() {
    for path in decks("corpus/bad") {
        let name = path.file_name().expect("a name").to_string_lossy().into_owned();
        let Some((code, _)) = name.split_once('-').filter(|(code, _)| code.starts_with("SL"))
        else {
            continue;
        };
        let (sources, diagnostics) = diagnostics(&path);
        for diagnostic in diagnostics.iter().filter(|d| d.severity == Severity::Error) {
            assert_eq!(diagnostic.code.0, code, "{}", announcement(&sources, diagnostic));
        }
    }
}

#[test]
fn good_decks_give_no_error() {
    for path in decks("corpus/keywords").into_iter().chain(decks("corpus/diehl1995")) {
        let (sources, diagnostics) = diagnostics(&path);
        let loud = diagnostics.iter().filter(|d| d.severity > Severity::Note);
        let said: Vec<String> = loud.map(|d| announcement(&sources, d)).collect();
        assert!(said.is_empty(), "{}: {said:#?}", path.display());
    }
}

#[test]
fn every_keyword_has_a_deck_and_a_page() {
    for keyword in keywords() {
        let stem = keyword.name.replace(' ', "-");
        let deck = root().join(format!("corpus/keywords/{stem}.inp"));
        let text = std::fs::read_to_string(&deck).unwrap_or_default();
        assert!(text.contains(&format!("*{}", keyword.name)), "{stem} has no deck");
        assert!(keyword.page.starts_with(&format!("# *{}\n", keyword.name)), "{stem}: title");
        for part in ["## Meaning", "## Parameters", "## Data", "## Source", "## Example"] {
            assert!(keyword.page.contains(part), "the page of {stem} lacks {part}");
        }
        for rule in keyword.parameters {
            assert!(keyword.page.contains(rule.name), "the page of {stem} lacks {}", rule.name);
        }
    }
}

/// A mend that a diagnostic carries is certain: applied, the complaint is gone
/// and nothing worse has come.
#[test]
fn the_mends_mend() {
    let mut mended = 0;
    for path in decks("corpus/bad") {
        let mut sources = Sources::default();
        let name = path.display().to_string();
        let bytes = std::fs::read(&path).expect("a deck");
        let parsed = parse(&mut sources, &name, &bytes, &FromDisk);
        let before = interpret(&parsed, Dialect::Abaqus).diagnostics;
        let edits: Vec<_> = before.iter().filter_map(|d| d.edit.clone()).collect();
        if edits.is_empty() {
            continue;
        }
        mended += 1;
        let applied = slideline_deck::apply(&parsed.deck, FileId(0), &edits);
        assert_eq!(applied.refused, [], "{name}");
        let parsed = parse(&mut Sources::default(), &name, &applied.bytes, &FromDisk);
        for diagnostic in interpret(&parsed, Dialect::Abaqus).diagnostics {
            let known = before.iter().any(|d| d.code == diagnostic.code && d.edit.is_none());
            assert!(known, "{name}: {diagnostic:?}");
        }
    }
    assert!(mended >= 6, "only {mended} decks carry mends");
}
