//! `slideline check`: words for modern pairs, and decks that it mends.

#![allow(clippy::unwrap_used)] // a test may fail where it stands

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

fn slideline(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_slideline"))
        .args(arguments)
        .current_dir(folder)
        .output()
        .unwrap()
}

fn corpus(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../corpus").join(name);
    std::fs::read_to_string(path).unwrap()
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// Requirement: the mended deck stands beside the old one, with a comment on
/// each card; it runs; nothing is overwritten, however often that is done.
#[test]
fn a_mended_deck_stands_beside_the_old_one_and_overwrites_nothing() {
    let folder = folder("check_fix");
    let deck = corpus("advice/SL0407-circle-inside-out-mm.inp");
    std::fs::write(folder.join("roller.inp"), &deck).unwrap();
    std::fs::write(folder.join("roller.fixed.inp"), "mine\n").unwrap();
    for _ in 0..2 {
        let output = slideline(&folder, &["check", "roller", "--fix"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
    }
    assert_eq!(
        names(&folder),
        ["roller.fixed-2.inp", "roller.fixed-3.inp", "roller.fixed.inp", "roller.inp"]
    );
    let text = |name: &str| std::fs::read_to_string(folder.join(name)).unwrap();
    assert_eq!(text("roller.inp"), deck);
    assert_eq!(text("roller.fixed.inp"), "mine\n");
    assert_eq!(text("roller.fixed-2.inp"), text("roller.fixed-3.inp"));
    assert!(text("roller.fixed-2.inp").contains("** SL0407: "));
    let output = slideline(&folder, &["run", "roller.fixed-2", "--no-html", "--quiet"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
}

/// Requirement: who is slave and who is master is told in the words of the
/// cards that the deck has.
#[test]
fn roles_are_told_in_the_words_of_the_deck() {
    let folder = folder("check_roles");
    let cases = [
        ("diehl1995/surface_coarse.inp", "contact is integrated along the first surface"),
        ("diehl1995/irs_modern.inp", "nodes of the first surface of *CONTACT PAIR are slaves"),
        ("diehl1995/isl_modern.inp", "the beams of the second one are the master"),
        ("diehl1995/irs_coarse.inp", "nodes of IRS elements are slaves"),
        ("diehl1995/isl_coarse.inp", "nodes of ISL elements are slaves"),
    ];
    for (name, words) in cases {
        std::fs::write(folder.join("job.inp"), corpus(name)).unwrap();
        for arguments in [&["check", "job"][..], &["check", "job", "--json"]] {
            let output = slideline(&folder, arguments);
            let text = String::from_utf8(output.stdout).unwrap();
            assert!(text.contains(words), "{name}: {text}");
            let old = name.contains("modern") || name.contains("surface");
            assert!(!old || !text.contains("IRS elements") && !text.contains("ISL elements"));
        }
    }
}

/// Requirement: the table of initial gaps has every slave node of integrated contact that faces
/// the master, near the zone of contact or not: here a circle of radius 9 mm whose lower half ends
/// at its equator. Source: distance from the circle.
#[test]
fn gaps_of_integrated_contact_are_those_of_its_nodes() {
    let folder = folder("check_gaps");
    std::fs::write(folder.join("job.inp"), corpus("diehl1995/surface_coarse.inp")).unwrap();
    let output = slideline(&folder, &["check", "job", "--json"]);
    let text = String::from_utf8(output.stdout).unwrap();
    let pair: serde_json::Value = text
        .lines()
        .map(|line| serde_json::from_str::<serde_json::Value>(line).unwrap())
        .find_map(|said| said.get("pair").cloned())
        .unwrap();
    let gaps = pair["initial_gaps"].as_array().unwrap();
    let known = gaps.iter().filter(|row| row["gap"].is_number()).count();
    assert!(known > 4, "{known} of {}: {gaps:?}", gaps.len());
}

/// Requirement: remedies speak the words of the deck they answer.
#[test]
fn remedies_speak_the_words_of_their_deck() {
    let folder = folder("check_words");
    for (name, own, other) in [
        ("irs_coarse", "*SLIDE LINE", "*SURFACE, TYPE=NODE"),
        ("irs_modern", "*SURFACE, TYPE=NODE", "*SLIDE LINE"),
    ] {
        std::fs::write(folder.join("job.inp"), corpus(&format!("diehl1995/{name}.inp"))).unwrap();
        let output = slideline(&folder, &["check", "job"]);
        let text = String::from_utf8(output.stderr).unwrap().replace('\n', " ");
        assert!(text.contains("SL0403") && text.contains(own), "{name}: {text}");
        let help = &text[text.find("SL0403").unwrap()..];
        assert!(!help.contains(other), "{name}: {help}");
    }
}
