//! The driver for Dakota.
//!
//! Requirement: the answer has the values of the study's responses in the order of Dakota's functions,
//! to the bit; a case that fails is a failed evaluation; what cannot be answered is an input error and
//! leaves no results. Source: contract, `slideline dakota`; the manual of Dakota, file formats.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::jobs::{code, folder, slideline, stderr};
use std::path::{Path, PathBuf};

const STUDY: &str = "deck = \"snap_fit.inp\"\n\
    parameters = { thickness = [1.5], lead = [30.0] }\n\
    responses.push = \"peak(RF1@100, 1)\"\n\
    responses.pull = \"peak(RF1@100, 2)\"\n";

/// A folder with the snap-fit of the Python package and a study of it.
fn prepared(name: &str) -> PathBuf {
    let folder = folder(name);
    let deck =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../bindings/python/examples/snap_fit.inp");
    std::fs::copy(deck, folder.join("snap_fit.inp")).unwrap();
    std::fs::write(folder.join("study.toml"), STUDY).unwrap();
    folder
}

fn parameters(thickness: &str, lead: &str) -> String {
    format!(
        "2 variables\n{lead} lead\n{thickness} thickness\n2 functions\n1 ASV_1:pull\n1 ASV_2:push\n\
         2 derivative_variables\n1 DVV_1:lead\n2 DVV_2:thickness\n0 analysis_components\n1 eval_id\n"
    )
}

/// Exit code, what was said and the results of a question.
fn ask(folder: &Path, asked: &str) -> (i32, String, Option<String>) {
    std::fs::write(folder.join("params.in"), asked).unwrap();
    let words = ["dakota", "params.in", "results.out", "--study", "study.toml"];
    let output = slideline(folder, &words);
    let results = std::fs::read_to_string(folder.join("results.out")).ok();
    (code(&output), stderr(&output).to_owned(), results)
}

#[test]
fn the_answer_is_that_of_a_sweep() {
    let folder = prepared("dakota_same");
    let (code, said, results) = ask(&folder, &parameters("1.5", "30.0"));
    assert_eq!((code, said.as_str()), (0, ""));
    let swept = slideline(&folder, &["sweep", "study.toml", "--csv", "--quiet", "--out", "s"]);
    assert!(swept.status.success());
    let table = std::fs::read_to_string(folder.join("s/study.csv")).unwrap();
    let row: Vec<f64> =
        table.lines().nth(1).unwrap().split(',').filter_map(|cell| cell.parse().ok()).collect();
    let results = results.unwrap();
    let answers: Vec<(f64, &str)> = results
        .lines()
        .map(|line| line.split_once(' ').unwrap())
        .map(|(value, name)| (value.parse().unwrap(), name))
        .collect();
    assert_eq!(answers, [(row[4], "pull"), (row[3], "push")]);
}

#[test]
fn aprepro_names_the_study_itself() {
    let folder = prepared("dakota_aprepro");
    let asked = "{ DAKOTA_VARS = 2 }\n{ thickness = 1.5 }\n{ lead = 30.0 }\n{ DAKOTA_FNS = 1 }\n\
        { ASV_1:push = 1 }\n{ DAKOTA_DER_VARS = 0 }\n{ DAKOTA_AN_COMPS = 1 }\n\
        { AC_1:slideline = \"study.toml\" }\n{ DAKOTA_EVAL_ID = 1 }\n";
    std::fs::write(folder.join("params.in"), asked).unwrap();
    let output = slideline(&folder, &["dakota", "params.in", "results.out"]);
    assert_eq!((code(&output), &*stderr(&output)), (0, ""));
    let results = std::fs::read_to_string(folder.join("results.out")).unwrap();
    assert!(results.ends_with(" push\n") && results.lines().count() == 1, "{results}");
}

#[test]
fn a_case_that_fails_is_a_failed_evaluation() {
    let folder = prepared("dakota_failed");
    let (code, _, results) = ask(&folder, &parameters("-1.5", "30.0"));
    assert_eq!(code, 0);
    assert!(results.unwrap().starts_with("FAIL SL"));
}

#[test]
fn what_cannot_be_answered_leaves_no_results() {
    let folder = prepared("dakota_wrong");
    let good = parameters("1.5", "30.0");
    for (old, new, told) in [
        ("1 ASV_1:pull", "4 ASV_1:pull", "second derivatives of pull"),
        ("1 ASV_1:pull", "1 ASV_1:pall", "no response pall"),
        ("30.0 lead", "30.0 load", "no parameter load"),
        ("2 variables", "a deck", "number of variables"),
    ] {
        let (code, said, results) = ask(&folder, &good.replacen(old, new, 1));
        assert_eq!((code, results), (1, None), "{said}");
        assert!(said.contains("SL0820") && said.contains(told), "{said}");
    }
    std::fs::write(folder.join("params.in"), &good).unwrap();
    let output = slideline(&folder, &["dakota", "params.in", "results.out"]);
    assert!(code(&output) == 1 && stderr(&output).contains("no study says"));
    let output = slideline(&folder, &["dakota", "none.in", "results.out"]);
    assert!(code(&output) == 1 && stderr(&output).contains("SL0701"));
}
