//! The decks of `corpus/keywords` run: what a page shows works as it stands.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::observe::{Ending, Event, Observer, Stop};
use slideline::{Job, ReadOptions, SolveOptions, solve};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// Decks that end with a code, and why they must.
const ENDS: [(&str, &str); 0] = [];

/// Counts increments.
#[derive(Default)]
struct Watch(usize);

impl Observer for Watch {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(_) = event {
            self.0 += 1;
        }
        ControlFlow::Continue(())
    }
}

fn decks() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../corpus/keywords");
    let entries = std::fs::read_dir(folder).unwrap();
    let paths = entries.map(|entry| entry.unwrap().path());
    let mut decks: Vec<_> =
        paths.filter(|path| path.extension().is_some_and(|own| own == "inp")).collect();
    decks.sort();
    decks
}

/// How a deck ends: nothing where it completes, else the code that says why not.
fn ending(path: &Path) -> Option<String> {
    let read = Job::read(path, &ReadOptions::default());
    let Some(model) = &read.model else {
        let errors = read.diagnostics.iter().map(|said| said.code.0);
        return Some(errors.collect::<Vec<_>>().join(", "));
    };
    let mut watch = Watch::default();
    match solve(model, &SolveOptions::default(), &mut watch) {
        Ending::Completed(_) if watch.0 > 0 => None,
        Ending::Completed(_) => Some("no increment".to_owned()),
        Ending::NotConverged(_, said) => Some(said.code.0.to_owned()),
        other => Some(format!("{other:?}")),
    }
}

/// Requirement: every deck that a page of a keyword shows runs to its end, or ends with the code that
/// the table names. No other expectation stands behind it: what each computes is tested elsewhere.
#[test]
fn every_deck_of_a_keyword_runs() {
    let decks = decks();
    assert!(decks.len() > 100, "{} decks", decks.len());
    let wrong: Vec<String> = decks
        .iter()
        .filter_map(|path| {
            let stem = path.file_stem().unwrap().to_string_lossy().into_owned();
            let known = ENDS.iter().find(|(name, _)| *name == stem).map(|own| own.1.to_owned());
            let ended = ending(path);
            (ended != known).then(|| format!("{stem}: {ended:?}, expected {known:?}"))
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
