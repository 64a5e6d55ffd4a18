//! Methods that a file gives to a type of another one: who calls them imports that file, although
//! no path says so.

use super::{Module, in_name};
use std::collections::{BTreeMap, BTreeSet};

/// Methods that one file of a crate alone defines, for a type of another file: name, type, file.
pub struct Methods(Vec<(String, String, Module)>);

impl Methods {
    /// Those of a crate.
    pub fn of(code: &BTreeMap<Module, String>) -> Self {
        let mut files_of: BTreeMap<&str, BTreeSet<&Module>> = BTreeMap::new();
        for (module, text) in code {
            for name in words_behind(text, "fn ") {
                files_of.entry(name).or_default().insert(module);
            }
        }
        let mut found = Vec::new();
        for (module, text) in code {
            for (of, body) in implementations(text).filter(|(of, _)| !defines(text, of)) {
                let single = words_behind(body, "fn ").filter(|name| files_of[name].len() == 1);
                found.extend(single.map(|name| (name.to_owned(), of.to_owned(), module.clone())));
            }
        }
        Self(found)
    }

    /// Which files call a method of another: those that reach the type by what they import.
    pub fn calls(
        &self,
        code: &BTreeMap<Module, String>,
        reached: &BTreeMap<Module, BTreeSet<Module>>,
    ) -> Vec<(Module, Module)> {
        let called: BTreeMap<&Module, BTreeSet<&str>> =
            code.iter().map(|(module, text)| (module, called(text))).collect();
        let mut calls = Vec::new();
        for (name, of, target) in &self.0 {
            let mut callers = called
                .iter()
                .filter(|(caller, names)| **caller != target && names.contains(name.as_str()));
            let Some(first) = callers.next() else { continue };
            let types: Vec<&Module> = code
                .iter()
                .filter(|(_, text)| defines(text, of))
                .map(|(module, _)| module)
                .collect();
            for (caller, _) in std::iter::once(first).chain(callers) {
                let knows =
                    |module: &&Module| module == caller || reached[*caller].contains(*module);
                if types.iter().any(knows) {
                    calls.push(((*caller).clone(), target.clone()));
                }
            }
        }
        calls
    }
}

/// Types with a block of their own methods, and that block.
fn implementations(text: &str) -> impl Iterator<Item = (&str, &str)> {
    let begins = text.match_indices("\nimpl").map(|(at, _)| &text[at + 5..]);
    begins.filter_map(|rest| {
        let (head, body) = rest.split_once('{')?;
        let own = behind_generics(head).trim_start();
        let of = own.split(|letter| !in_name(letter)).next()?;
        let body = body.split("\n}").next()?;
        (!head.contains(" for ") && !of.is_empty()).then_some((of, body))
    })
}

/// What follows `<...>`, if that comes first.
fn behind_generics(head: &str) -> &str {
    if !head.starts_with('<') {
        return head;
    }
    let mut depth = 0;
    for (at, letter) in head.char_indices() {
        depth += match letter {
            '<' => 1,
            '>' => -1,
            _ => 0,
        };
        if depth == 0 {
            return &head[at + 1..];
        }
    }
    head
}

/// Names that follow a word such as `fn `.
fn words_behind<'a>(text: &'a str, word: &'a str) -> impl Iterator<Item = &'a str> {
    text.match_indices(word).filter(|(at, _)| !text[..*at].ends_with(in_name)).filter_map(
        move |(at, _)| {
            let rest = &text[at + word.len()..];
            rest.split(|letter| !in_name(letter)).next().filter(|name| !name.is_empty())
        },
    )
}

/// Whether a type is defined there.
fn defines(text: &str, of: &str) -> bool {
    ["struct ", "enum ", "type ", "trait "]
        .iter()
        .any(|word| words_behind(text, word).any(|name| name == of))
}

/// Names of methods and functions that are called there through a value or a path.
fn called(text: &str) -> BTreeSet<&str> {
    let mut found = BTreeSet::new();
    for through in [".", "::"] {
        for (at, _) in text.match_indices(through) {
            let rest = &text[at + through.len()..];
            let end = rest.find(|letter| !in_name(letter)).unwrap_or(rest.len());
            if rest[end..].starts_with('(') || rest[end..].starts_with("::<") {
                found.insert(&rest[..end]);
            }
        }
    }
    found
}
