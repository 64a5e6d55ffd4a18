//! docs/limits-of-use.md is true: what it says is not available is refused
//! with an error, never read as something else.

#![allow(clippy::expect_used)] // a test may stop

use slideline_deck::NoFiles;
use slideline_diag::Sources;
use slideline_keywords::read;
use slideline_model::Dialect;

const PAGE: &str = include_str!("../../../../docs/limits-of-use.md");
const DECK: &str = include_str!("../../../../corpus/keywords/CONTACT-PAIR.inp");

/// Codes of the errors of the deck with a piece exchanged.
fn errors(old: &str, new: &str) -> Vec<&'static str> {
    assert!(DECK.contains(old), "{old}");
    let deck = DECK.replacen(old, new, 1);
    let read = read(&mut Sources::default(), "a.inp", deck.as_bytes(), &NoFiles, Dialect::Abaqus);
    let errors = read.diagnostics.iter().filter(|found| found.severity.word() == "error");
    errors.map(|found| found.code.0).collect()
}

/// Requirement: the deck itself is sound, so that each error below is that of
/// the piece exchanged.
#[test]
fn the_deck_is_sound() {
    assert!(errors("*HEADING", "*HEADING").is_empty());
}

/// Requirement: each thing that the page names is refused. A feature that
/// comes must leave the page. Words of the page, a piece of the deck, what
/// stands there instead.
#[test]
fn what_the_page_names_is_refused() {
    const MODEL: &str = "*STEP";
    const HISTORY: &str = "*END STEP";
    let cases = [
        ("beams in space as masters", "TYPE=B21", "TYPE=B31"),
        ("shells", MODEL, "*SHELL SECTION\n*STEP"),
        ("restrained warping", "TYPE=B21", "TYPE=B31OS"),
        ("tilt its section", MODEL, "*NORMAL\nBEAM, 2, 0., 0., 1.\n*STEP"),
        ("(`*TRS`)", MODEL, "*TRS\n*STEP"),
        ("rubber that softens", MODEL, "*MULLINS EFFECT\n*STEP"),
        ("heat conduction", HISTORY, "*HEAT TRANSFER\n*END STEP"),
        ("masses", "TYPE=B21", "TYPE=MASS"),
        ("connectors", "TYPE=B21", "TYPE=CONN2D2"),
        ("initial strains", MODEL, "*INITIAL CONDITIONS, TYPE=PLASTIC STRAIN\n*STEP"),
        ("`*PARAMETER DEPENDENCE`", MODEL, "*PARAMETER DEPENDENCE\nw = 1.\n*STEP"),
        ("dynamics", HISTORY, "*DYNAMIC\n*END STEP"),
        ("frequencies", HISTORY, "*FREQUENCY\n*END STEP"),
        ("linear buckling", HISTORY, "*BUCKLE\n*END STEP"),
        ("(Riks)", "*STATIC", "*STATIC, RIKS"),
        (
            "`INTERFERENCE FIT`",
            MODEL,
            "*CONTACT INITIALIZATION DATA, NAME=A, INTERFERENCE FIT\n*STEP",
        ),
    ];
    for (words, old, new) in cases {
        assert!(PAGE.contains(words), "the page does not say: {words}");
        assert!(!errors(old, new).is_empty(), "{words}: accepted");
    }
}

/// Requirement: the links of the page name codes, whose pages say what is meant.
#[test]
fn contact_that_is_not_available_has_the_codes_of_the_page() {
    let itself = errors("BEAM, CIRCLE", "BEAM, BEAM");
    assert!(!itself.is_empty(), "a beam in contact with itself");
    for code in ["SL0319", "SL0329", "SL0401", "SL0511"] {
        assert!(PAGE.contains(&format!("[{code}](errors/{code}.md)")), "{code}");
    }
}
