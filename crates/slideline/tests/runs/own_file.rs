//! A result file of the embedding program: the example's own.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

#[allow(dead_code)] // its main is not called here
#[path = "../../examples/own_file.rs"]
mod example;

use example::PressureFile;
use slideline::{Job, ReadOptions, RunOptions, Status, run};
use std::collections::BTreeMap;

/// Requirement: the file of an observer has a row for every increment and pair with contact points,
/// and its pressures are the largest of JOB.contact.csv, to the letter.
#[test]
fn a_file_of_ones_own_says_what_the_others_say() {
    let folder = std::env::temp_dir().join(format!("slideline_own_file_{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let deck = concat!(env!("CARGO_MANIFEST_DIR"), "/../../corpus/diehl1995/isl_coarse.inp");
    let read = Job::read(deck.as_ref(), &ReadOptions::default());
    let mut own = PressureFile::create(&folder.join("own.csv")).unwrap();
    let options = RunOptions { folder: Some(folder.clone()), ..RunOptions::default() };
    assert_eq!(run(&read, &options, &mut own).status, Status::Completed);
    assert!(own.failure.is_none());
    let text = |name: &str| std::fs::read_to_string(folder.join(name)).unwrap();
    let contact = text("isl_coarse.contact.csv");
    let heading: Vec<&str> = contact.lines().next().unwrap().split(',').collect();
    let at = |name: &str| heading.iter().position(|column| *column == name).unwrap();
    let columns = ["step", "increment", "pair", "node", "CPRESS"].map(at);
    let mut largest: BTreeMap<(usize, usize, String), [String; 2]> = BTreeMap::new();
    for line in contact.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let [step, increment, pair, node, pressure] = columns.map(|at| cells[at].to_owned());
        let key = (step.parse().unwrap(), increment.parse().unwrap(), pair);
        let value = |text: &str| text.parse::<f64>().unwrap_or(0.0);
        let known = largest.get(&key).map_or(f64::NEG_INFINITY, |known| value(&known[1]));
        // of equal ones the last, as the maximum of an iterator is
        if value(&pressure) >= known {
            largest.insert(key, [node, pressure]);
        }
    }
    let expected = largest.iter().map(|((step, increment, pair), [node, pressure])| {
        format!("{step},{increment},{pair},{node},{pressure}\n")
    });
    let expected: String = expected.collect();
    assert!(expected.lines().count() == 20 && expected.contains("9017"), "{expected}");
    assert_eq!(text("own.csv"), "step,increment,pair,node,pressure\n".to_owned() + &expected);
    std::fs::remove_dir_all(&folder).unwrap(); // ours alone
}
