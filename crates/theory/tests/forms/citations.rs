//! What the code says about its sources, compared with the documentation.
//!
//! ```text
//!   doc comments --- Diehl (1995) eq. (n) ---> equations of the paper
//!        |---------- [key, eq. n] -----------> docs/references.bib
//!        |---------- [semantics: NAME] ------> docs/theory.md, Appendix A
//!        '---------- [verification: NAME] ---> docs/theory.md, Appendix B
//! ```
//!
//! A bibliography key is lower-case letters, a year, and perhaps one letter.
//! Sources are read as text; nothing of the library is called.

// the helpers of a test may fail as loudly as the test
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// A file of the repository: its path below the root, and its text.
struct Document {
    path: String,
    text: String,
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn collect(folder: &Path, extension: &str, into: &mut Vec<Document>) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    let mut paths: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    for path in paths {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if path.is_dir() {
            if name != "target" && !name.starts_with('.') {
                collect(&path, extension, into);
            }
        } else if path.extension().is_some_and(|found| found == extension) {
            // files come and go while others work on them: a vanished one says nothing
            let Ok(text) = fs::read_to_string(&path) else { continue };
            let path = path.strip_prefix(root()).unwrap().to_string_lossy().into_owned();
            into.push(Document { path, text });
        }
    }
}

fn rust_sources(below: &str) -> Vec<Document> {
    let mut documents = Vec::new();
    collect(&root().join(below), "rs", &mut documents);
    assert!(!documents.is_empty(), "no sources below {below}");
    documents
}

fn pages() -> Vec<Document> {
    let mut documents = Vec::new();
    collect(&root().join("docs"), "md", &mut documents);
    documents
}

fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|reason| panic!("{path}: {reason}"))
}

/// The comments of a Rust source, their lines joined by blanks.
fn comments(text: &str) -> String {
    let mut joined = String::new();
    for line in text.lines() {
        if let Some(at) = line.find("//") {
            joined.push_str(line[at..].trim_start_matches(['/', '!']));
            joined.push(' ');
        }
    }
    joined
}

/// Everything that stands between `open` and the next `close`.
fn enclosed<'a>(text: &'a str, open: &str, close: char) -> Vec<&'a str> {
    let inside = |(at, _): (usize, &str)| text[at + open.len()..].split_once(close);
    text.match_indices(open).filter_map(inside).map(|(inside, _)| inside).collect()
}

fn is_key(word: &str) -> bool {
    let letters = word.bytes().take_while(u8::is_ascii_lowercase).count();
    let (year, rest) = word[letters..].split_at_checked(4).unwrap_or(("", ""));
    letters > 0
        && year.len() == 4
        && year.bytes().all(|byte| byte.is_ascii_digit())
        && rest.len() <= 1
        && rest.bytes().all(|byte| byte.is_ascii_lowercase())
}

/// Keys cited as `[key]` or `[key, where]`.
fn cited_keys(text: &str) -> BTreeSet<&str> {
    enclosed(text, "[", ']')
        .into_iter()
        .map(|inside| inside.split(',').next().unwrap_or(inside))
        .filter(|word| is_key(word))
        .collect()
}

/// Key and body of every entry of the bibliography.
fn bibliography() -> BTreeMap<String, String> {
    let text = read("docs/references.bib");
    let mut entries = BTreeMap::new();
    for entry in text.split("\n@").skip(1) {
        let (_, rest) = entry.split_once('{').expect("an entry has braces");
        let (key, body) = rest.split_once(',').expect("an entry has a key");
        assert!(is_key(key), "{key} has not the form of a key");
        let year: String = key.chars().filter(char::is_ascii_digit).collect();
        assert!(body.contains(&format!("{{{year}}}")), "{key}: the year is another");
        assert!(entries.insert(key.to_owned(), body.to_owned()).is_none(), "{key} stands twice");
    }
    entries
}

/// Numbers of the paper's equations that a doc comment cites, as in
/// "Diehl (1995) eq. (6)" or "Diehl (1995) eqs. (2), (3) and (4)".
fn equations(doc: &str) -> BTreeSet<u32> {
    let mut found = BTreeSet::new();
    if !doc.contains("Diehl (1995)") {
        return found;
    }
    for start in ["eq. (", "eqs. ("] {
        for (at, _) in doc.match_indices(start) {
            let mut rest = &doc[at + start.len() - 1..];
            while let Some(after) = rest.strip_prefix('(') {
                let Some((number, tail)) = after.split_once(')') else { break };
                let Ok(number) = number.parse() else { break };
                found.insert(number);
                rest = tail.trim_start_matches(", ").trim_start_matches(" and ");
            }
        }
    }
    found
}

/// A documented function.
struct Function {
    name: String,
    doc: String,
    is_test: bool,
}

fn functions(text: &str) -> Vec<Function> {
    let mut found = Vec::new();
    let (mut doc, mut is_test) = (String::new(), false);
    for line in text.lines().map(str::trim_start) {
        if let Some(comment) = line.strip_prefix("///") {
            doc.push_str(comment);
        } else if line.starts_with("#[") {
            is_test |= line.starts_with("#[test]");
        } else {
            if let Some((_, name)) = line.split_once("fn ")
                && !line.starts_with("//")
            {
                let name: String =
                    name.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
                found.push(Function { name, doc: doc.clone(), is_test });
            }
            (doc, is_test) = (String::new(), false);
        }
    }
    found
}

/// Requirement: each of the paper's equations (1) to (12) is implemented by a
/// function that cites it, and tested by a test that does. Source: the
/// project's rule on citations.
#[test]
fn every_equation_of_the_paper_has_a_function_and_a_test() {
    let (mut implemented, mut tested) = (BTreeSet::new(), BTreeSet::new());
    for document in rust_sources("crates/theory") {
        for function in functions(&document.text) {
            let into = if function.is_test { &mut tested } else { &mut implemented };
            into.extend(equations(&function.doc));
        }
    }
    let all: BTreeSet<u32> = (1..=12).collect();
    assert_eq!(implemented, all, "equations cited by functions");
    assert_eq!(tested, all, "equations cited by tests");
}

/// Requirement: the table of docs/theory.md names, for each equation, a
/// function whose own comment cites that equation.
#[test]
fn the_table_of_equations_names_the_functions() {
    let theory = read("docs/theory.md");
    let sources = rust_sources("crates/theory/src");
    let all: Vec<_> = sources.iter().flat_map(|document| functions(&document.text)).collect();
    for number in 1..=12 {
        let start = format!("| ({number}) |");
        let row = theory.lines().find(|line| line.starts_with(&start));
        let row = row.unwrap_or_else(|| panic!("no row for equation ({number})"));
        let name = enclosed(row, "`", '`')[0];
        let cites = |f: &&Function| f.name == name && equations(&f.doc).contains(&number);
        assert!(all.iter().any(|f| cites(&f)), "`{name}` does not cite equation ({number})");
    }
}

/// Requirement: every cited key stands in the bibliography, and every entry is
/// cited somewhere in code or documentation.
#[test]
fn keys_and_bibliography_agree() {
    let entries = bibliography();
    let mut cited = BTreeMap::new();
    let code = rust_sources("crates").into_iter();
    let code = code.map(|d| Document { text: comments(&d.text), ..d });
    for document in code.chain(pages()) {
        for key in cited_keys(&document.text) {
            cited.insert(key.to_owned(), document.path.clone());
        }
    }
    for (key, path) in &cited {
        assert!(entries.contains_key(key), "{path} cites [{key}], unknown to the bibliography");
    }
    for key in entries.keys() {
        assert!(cited.contains_key(key), "[{key}] of the bibliography is cited nowhere");
    }
}

/// Requirement: an author named with a year in a comment of the physics crates,
/// as "Hertz 1882" or "Diehl (1995)", is one of the bibliography.
#[test]
fn authors_with_a_year_are_in_the_bibliography() {
    let entries = bibliography();
    for below in ["crates/theory/src", "crates/mech/src", "crates/linalg/src"] {
        for document in rust_sources(below) {
            let text = comments(&document.text);
            let words: Vec<&str> = text.split_whitespace().collect();
            for pair in words.windows(2) {
                let year = pair[1].trim_matches(|c: char| !c.is_ascii_digit());
                let name = pair[0].trim_matches(|c: char| !c.is_alphabetic());
                let is_name = name.len() > 3 && name.starts_with(char::is_uppercase);
                let is_year = matches!(year.parse(), Ok(1800..=2100)) && year.len() == 4;
                if is_name && is_year && !pair[0].ends_with(['.', ',', ':']) {
                    let known = entries
                        .values()
                        .any(|body| body.contains(name) && body.contains(&format!("{{{year}}}")));
                    assert!(known, "{}: {name} {year} is not in the bibliography", document.path);
                }
            }
        }
    }
}

/// A name without quotation marks, stars and case, and without a mark of its
/// standing after a semicolon.
fn plain(name: &str) -> String {
    let name = name.split(';').next().unwrap_or(name);
    let kept: String = name.chars().filter(|c| !"`*\\".contains(*c)).collect();
    kept.split_whitespace().collect::<Vec<_>>().join(" ").to_lowercase()
}

/// Headings and bold terms of an appendix of docs/theory.md.
fn terms(appendix: &str) -> Vec<String> {
    let theory = read("docs/theory.md");
    let start = theory.find(&format!("\n## {appendix}")).expect("the appendix exists");
    let body = &theory[start + 4..];
    let body = &body[..body.find("\n## ").unwrap_or(body.len())];
    let headings = body.lines().filter(|line| line.starts_with('#')).map(plain);
    // stars inside quoted cards are not bold marks
    let quoted: String = body
        .split('`')
        .enumerate()
        .map(|(i, part)| if i % 2 == 1 { part.replace('*', "") } else { part.to_owned() })
        .collect();
    headings.chain(quoted.split("**").skip(1).step_by(2).map(plain)).collect()
}

fn check_tags(tag: &str, appendix: &str) {
    let terms = terms(appendix);
    let mut count = 0;
    for document in rust_sources("crates") {
        let text = comments(&document.text);
        for name in enclosed(&text, &format!("[{tag}: "), ']') {
            let wanted = plain(name);
            count += 1;
            assert!(
                wanted == "name" || terms.iter().any(|term| term.contains(&wanted)),
                "{}: [{tag}: {name}] has no entry in docs/theory.md, {appendix}",
                document.path
            );
        }
    }
    assert!(count > 1, "no [{tag}: ...] was found at all");
}

/// Requirement: a reader finds every rule that code refers to, with its standing.
#[test]
fn every_rule_stands_in_the_appendix() {
    check_tags("semantics", "Appendix A");
}

/// Requirement: likewise every claim of the verification.
#[test]
fn every_claim_stands_in_the_appendix() {
    check_tags("verification", "Appendix B");
}

/// Numbers of equations cited as "docs/theory.md eq. (3.9)" or "docs/theory.md
/// eqs. (3.17) and (3.19)".
fn theory_equations(comments: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (at, start) in comments.match_indices("docs/theory.md eq") {
        let rest = comments[at + start.len()..].trim_start_matches('s').trim_start_matches('.');
        let mut rest = rest.trim_start();
        while let Some((number, tail)) = rest.strip_prefix('(').and_then(|r| r.split_once(')')) {
            found.push(number.to_owned());
            rest = tail.trim_start_matches(", ").trim_start_matches(" and ");
        }
        assert!(!found.is_empty(), "no equation in: {}", &comments[at..]);
    }
    found
}

/// Requirement: equations are numbered consecutively within their section, and
/// every reference in the page and every part named in code exists.
#[test]
fn equation_numbers_and_headings_hold_together() {
    let theory = read("docs/theory.md");
    let mut tags = BTreeSet::new();
    let (mut section, mut count) = (0, 0);
    for line in theory.lines() {
        if let Some(heading) = line.strip_prefix("## ") {
            section = heading.split('.').next().unwrap().parse().unwrap_or(0);
            count = 0;
        }
        for tag in enclosed(line, "\\tag{", '}') {
            count += 1;
            assert_eq!(tag, format!("{section}.{count}"), "in {line}");
            tags.insert(tag.to_owned());
        }
    }
    let is_number = |s: &str| !s.is_empty() && s.bytes().all(|byte| byte.is_ascii_digit());
    for inside in enclosed(&theory, "(", ')') {
        let numbered = inside.split_once('.').is_some_and(|(a, b)| is_number(a) && is_number(b));
        assert!(!numbered || tags.contains(inside), "there is no equation ({inside})");
    }
    for document in rust_sources("crates") {
        for part in enclosed(&comments(&document.text), "docs/theory.md, \"", '"') {
            let found = theory.lines().any(|line| line.starts_with('#') && line.contains(part));
            assert!(found, "{}: no part \"{part}\" in docs/theory.md", document.path);
        }
        for number in theory_equations(&comments(&document.text)) {
            assert!(tags.contains(&number), "{}: no equation ({number})", document.path);
        }
    }
}

/// Requirement: files that docs/theory.md points to exist.
#[test]
fn paths_in_the_theory_exist() {
    for path in enclosed(&read("docs/theory.md"), "`crates/", '`') {
        let path = format!("crates/{path}");
        assert!(root().join(&path).is_file(), "docs/theory.md points to {path}");
    }
}
