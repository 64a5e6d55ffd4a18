//! Values for parameters of a deck on the command line.
//!
//! Requirement: `run --set NAME=VALUE` gives the results of the deck with that value written into it,
//! byte for byte, also where the job goes on from a saved state. Source: contract, options of `run`.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::jobs::{MOTIONS, WRITE, code, folder, irs, model, slideline, stderr, step};
use std::path::Path;

const QUIET: [&str; 2] = ["--quiet", "--no-html"];

fn run(folder: &Path, deck: &str, options: &[&str]) -> (i32, String) {
    let output = slideline(folder, &[&["run", deck], options, &QUIET].concat());
    (code(&output), stderr(&output).to_owned())
}

fn text(folder: &Path, name: &str) -> String {
    std::fs::read_to_string(folder.join(name)).unwrap_or_else(|why| panic!("{name}: {why}"))
}

/// Columns on a plane whose friction has a name, and the steps of the job.
fn parametric(mu: &str, steps: &str) -> String {
    let contact = irs();
    assert!(contact.contains("*FRICTION\n0.3\n"), "{contact}");
    let contact = contact.replace("*FRICTION\n0.3\n", "*FRICTION\n<mu>\n");
    format!("*PARAMETER\nmu = {mu}\n{}{steps}", model(WRITE, &contact))
}

/// Rows of a file behind its heading.
fn rows(folder: &Path, name: &str) -> Vec<String> {
    text(folder, name).lines().skip(1).map(str::to_owned).collect()
}

#[test]
fn a_value_on_the_command_line_is_one_in_the_deck() {
    let folder = folder("set");
    let steps: String = MOTIONS.map(|to| step(5, to)).concat();
    let write = |name: &str, deck: String| std::fs::write(folder.join(name), deck).unwrap();
    write("named.inp", parametric("0.3", &steps));
    write("written.inp", parametric("0.125", &steps));
    assert_eq!(run(&folder, "written", &[]), (0, String::new()));
    assert_eq!(run(&folder, "named", &["--set", "mu=1.0/8"]), (0, String::new()));
    let columns = |job: &str| text(&folder, &format!("{job}.history.csv"));
    assert_eq!(columns("named"), columns("written"));
    let summary = text(&folder, "named.json");
    assert!(summary.contains("\"parameters\":{\"mu\":\"1.0/8\"}"), "{summary}");
    assert_eq!(run(&folder, "named", &[]).0, 0);
    assert_ne!(columns("named"), columns("written"));

    // a job that is done says so only to those who set the same values
    assert_eq!(run(&folder, "named", &["--set", "mu=0.2"]).0, 0);
    assert_eq!(run(&folder, "named", &["--set", "mu=0.2", "--restart"]).0, 0);
    let (code, said) = run(&folder, "named", &["--restart"]);
    assert_eq!(code, 1);
    assert!(said.contains("SL0709") && said.contains("it was mu=0.2 and is none now"), "{said}");
}

/// The states of an earlier job know the values that it was run with.
#[test]
fn a_job_that_goes_on_keeps_the_values() {
    let folder = folder("set_further");
    let [press, drag, _] = MOTIONS.map(|to| step(5, to));
    let write = |name: &str, deck: String| std::fs::write(folder.join(name), deck).unwrap();
    write("whole.inp", parametric("0.3", &format!("{press}{drag}")));
    write("press.inp", parametric("0.3", &press));
    write("drag.inp", format!("*RESTART, READ\n{drag}"));
    let set = ["--set", "mu=0.1"];
    assert_eq!(run(&folder, "whole", &set).0, 0);
    assert_eq!(run(&folder, "press", &set).0, 0);
    assert_eq!(run(&folder, "drag", &["--oldjob", "press"]), (0, String::new()));
    let (all, own) = (rows(&folder, "whole.history.csv"), rows(&folder, "drag.history.csv"));
    assert!(!own.is_empty());
    assert_eq!(all[all.len() - own.len()..], own);
    let (code, said) = run(&folder, "drag", &["--oldjob", "press", "--set", "mu=0.2"]);
    assert_eq!(code, 1);
    assert!(said.contains("SL0801") && said.contains("previous job"), "{said}");
}

#[test]
fn values_that_cannot_be_set() {
    let folder = folder("set_wrong");
    std::fs::write(folder.join("job.inp"), parametric("0.3", &step(5, MOTIONS[0]))).unwrap();
    for (set, exit, words) in [
        ("mue=0.2", 1, "did you mean mu?"),
        ("mue=0.2", 1, "--> --set:1:1"),
        ("mu=abc", 1, "SL0802"),
        ("mu=-0.1", 1, "SL0216"),
        ("mu", 64, "NAME=VALUE"),
        ("=0.2", 64, "NAME=VALUE"),
        ("mu=", 64, "NAME=VALUE"),
    ] {
        let (code, said) = run(&folder, "job", &["--set", set]);
        assert!(code == exit && said.contains(words), "{set}: {code} {said}");
        let check = slideline(&folder, &["check", "job", "--set", set]);
        assert_eq!(code, self::code(&check), "check with {set}");
    }
    let (code, said) = run(&folder, "job", &["--set", "mu=0.1", "--set", "mu=0.2"]);
    assert!(code == 1 && said.contains("set twice"), "{said}");
}

/// Requirement: lists of values run the deck with each of them, under names of their own, with the
/// results of a run with that value; a table and a plot have them all, and one that cannot be is told.
#[test]
fn several_values_are_several_runs_in_one_table() {
    let folder = folder("set_several");
    let steps: String = MOTIONS.map(|to| step(5, to)).concat();
    std::fs::write(folder.join("job.inp"), parametric("0.3", &steps)).unwrap();
    let (exit, said) = run(&folder, "job", &["--set", "mu=0.1,-0.5,(0.4/2)"]);
    assert!(exit == 1 && said.contains("SL0216"), "{exit} {said}");
    let table = text(&folder, "job.study.csv");
    let rows: Vec<Vec<&str>> = table.lines().map(|line| line.splitn(4, ',').collect()).collect();
    assert_eq!(rows[0][..3], ["job", "mu", "status"], "{table}");
    assert_eq!(rows[1][..3], ["job-1", "0.1", "completed"]);
    assert_eq!(rows[2][..3], ["job-2", "-0.5", "input_error"]);
    assert!(table.lines().nth(3).unwrap().starts_with("job-3,(0.4/2),completed"), "{table}");
    assert_eq!(rows.len(), 4);
    let figure = text(&folder, "job.study.svg");
    assert!(figure.contains("mu = 0.1<") && figure.contains("mu = (0.4/2)<"), "{figure}");
    assert_eq!(run(&folder, "job", &["--set", "mu=0.2"]), (0, String::new()));
    assert_eq!(text(&folder, "job-3.history.csv"), text(&folder, "job.history.csv"));
    assert_ne!(text(&folder, "job-1.history.csv"), text(&folder, "job.history.csv"));
    let (exit, said) = run(&folder, "job", &["--set", "mu=0.1,0.2", "--restart"]);
    assert!(exit == 1 && said.contains("SL0803"), "{said}");
    let many: Vec<String> = (0..1001).map(|k| format!("0.{k:04}")).collect();
    let (exit, said) = run(&folder, "job", &["--set", &format!("mu={}", many.join(","))]);
    assert!(exit == 1 && said.contains("SL0803"), "{said}");
}
