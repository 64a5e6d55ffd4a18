//! Two squares of solids, with more cards, and what reading them gives.

use slideline_deck::NoFiles;
use slideline_diag::{Diagnostic, Sources};
use slideline_keywords::{Interpreted, read};
use slideline_model::{Dialect, Model};

/// Two squares, of 1 by 1, as solids of a type; sections and steps follow.
pub const SQUARES: &str = "\
*NODE
1, 1.0, 0.0
2, 2.0, 0.0
3, 3.0, 0.0
4, 1.0, 1.0
5, 2.0, 1.0
6, 3.0, 1.0
*ELEMENT, TYPE=CPS4, ELSET=A
1, 1, 2, 5, 4
*ELEMENT, TYPE=CPS4, ELSET=B
2, 2, 3, 6, 5
*ELSET, ELSET=ALL
A, B
*NSET, NSET=LEFT
1, 4
*NSET, NSET=RIGHT
3, 6
*SURFACE, NAME=TOP
ALL, S3
*SURFACE, NAME=POINTS, TYPE=NODE
RIGHT
*SOLID SECTION, ELSET=A, MATERIAL=M
2.0
*SOLID SECTION, ELSET=B, MATERIAL=M
2.0
*MATERIAL, NAME=M
*ELASTIC
200.0, 0.3
*DENSITY
3.0
*BOUNDARY
LEFT, 1, 2
";

pub fn interpret(text: &str, dialect: Dialect) -> Interpreted {
    read(&mut Sources::default(), "a.inp", text.as_bytes(), &NoFiles, dialect)
}

pub fn errors(read: &Interpreted) -> Vec<Diagnostic> {
    let all = read.diagnostics.iter();
    all.filter(|found| found.severity.word() == "error").cloned().collect()
}

/// The deck with more cards and pieces exchanged.
pub fn deck(more: &str, exchanged: &[(&str, &str)]) -> String {
    let mut deck = format!("{SQUARES}{more}");
    for (old, new) in exchanged {
        assert!(deck.contains(old), "{old}");
        deck = deck.replace(old, new);
    }
    deck
}

pub fn step(cards: &str) -> String {
    format!("*STEP, NLGEOM\n*STATIC\n{cards}\n*END STEP\n")
}

/// Codes of the errors of a deck, each once.
pub fn codes(deck: &str, dialect: Dialect) -> Vec<&'static str> {
    let mut codes: Vec<_> =
        errors(&interpret(deck, dialect)).iter().map(|found| found.code.0).collect();
    codes.dedup();
    codes
}

pub fn model(deck: &str, dialect: Dialect) -> Model {
    let read = interpret(deck, dialect);
    assert!(errors(&read).is_empty(), "{:#?}", errors(&read));
    read.model
}

pub const A: Dialect = Dialect::Abaqus;
pub const C: Dialect = Dialect::Calculix;
