//! Studies from the command line.
//!
//! Requirement: a study has the same bits on any number of threads and in any order of its shards;
//! what was done is kept, what is damaged is computed again, a case that fails is a row, and what is
//! wrong is said before anything is run. Source: contract, `slideline sweep`.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

mod jobs;

use jobs::{MOTIONS, code, folder, irs, model, slideline, stderr, step};
use std::path::Path;

const STUDY: &str = "deck = \"job.inp\"\n\
    parameters.mu = [0.1, 0.2, -0.5]\n\
    parameters.scale = { from = 0.9, to = 1.1, count = 4 }\n\
    responses.force = \"peak(RF1@1)\"\n\
    responses.share = \"force / (scale + 1)\"\n";

/// A folder with a deck of two parameters and a study.
fn prepared(name: &str, study: &str) -> std::path::PathBuf {
    let folder = folder(name);
    let contact = irs().replace("*FRICTION\n0.3\n", "*FRICTION\n<mu>\n");
    let deck = format!(
        "*PARAMETER\nmu = 0.3\nscale = 1.0\n{}{}",
        model("", &contact),
        step(5, MOTIONS[0])
    );
    std::fs::write(folder.join("job.inp"), deck).unwrap();
    std::fs::write(folder.join("study.toml"), study).unwrap();
    folder
}

fn sweep(folder: &Path, options: &[&str]) -> (i32, String) {
    let output = slideline(folder, &[&["sweep", "study.toml", "--quiet"], options].concat());
    (code(&output), stderr(&output).to_owned())
}

fn table(folder: &Path, out: &str) -> String {
    std::fs::read_to_string(folder.join(out).join("study.csv")).unwrap()
}

/// A folder of a study whose shards have so many cases.
fn with_shards_of(folder: &Path, from: &str, out: &str, count: u64) {
    let told = std::fs::read_to_string(folder.join(from).join("study.json")).unwrap();
    let mut told: serde_json::Value = serde_json::from_str(&told).unwrap();
    told["cases_a_shard"] = count.into();
    std::fs::create_dir_all(folder.join(out)).unwrap();
    std::fs::write(folder.join(out).join("study.json"), told.to_string()).unwrap();
}

#[test]
fn threads_and_shards_change_no_bit() {
    let folder = prepared("sweep_same", STUDY);
    assert_eq!(sweep(&folder, &["--out", "one", "--csv"]), (0, String::new()));
    let one = table(&folder, "one");
    assert_eq!(one.lines().count(), 13);
    let failed = one.lines().filter(|line| line.ends_with("SL0216")).count();
    assert_eq!(failed, 4, "{one}");
    assert!(one.lines().nth(1).unwrap().ends_with(','), "{one}");
    with_shards_of(&folder, "one", "two", 5);
    assert_eq!(sweep(&folder, &["--out", "two", "--csv", "--threads", "2"]), (0, String::new()));
    assert_eq!(table(&folder, "two"), one);
    with_shards_of(&folder, "one", "three", 2);
    for part in ["2/3", "0/3"] {
        assert_eq!(sweep(&folder, &["--out", "three", "--shard", part]).0, 0);
    }
    let (code, said) = sweep(&folder, &["--out", "three", "--csv", "--shard", "0/3"]);
    assert!(code == 0 && said.contains("SL0808"), "{said}");
    assert_eq!(sweep(&folder, &["--out", "three", "--csv", "--shard", "1/3"]).0, 0);
    assert_eq!(table(&folder, "three"), one);
}

#[test]
fn damaged_shards_are_computed_again() {
    let folder = prepared("sweep_damaged", STUDY);
    sweep(&folder, &["--out", "out", "--csv"]);
    let whole = table(&folder, "out");
    let shard = folder.join("out/shard_00000.parquet");
    let bytes = std::fs::read(&shard).unwrap();
    for at in (0..bytes.len()).step_by(bytes.len() / 12) {
        let mut damaged = bytes.clone();
        damaged[at] ^= 0x55;
        std::fs::write(&shard, &damaged).unwrap();
        let (code, said) = sweep(&folder, &["--out", "out", "--csv"]);
        assert!(code == 0 && (said.is_empty() || said.contains("SL0808")), "byte {at}: {said}");
        assert_eq!(table(&folder, "out"), whole, "byte {at}");
    }
    std::fs::write(&shard, &bytes[..bytes.len() / 2]).unwrap();
    let (code, said) = sweep(&folder, &["--out", "out", "--csv"]);
    assert!(code == 0 && said.contains("SL0808"), "{said}");
    assert_eq!(table(&folder, "out"), whole);
}

#[test]
fn what_is_wrong_is_said_before() {
    let folder = prepared("sweep_wrong", STUDY);
    assert_eq!(sweep(&folder, &["--out", "out"]).0, 0);
    let other = |from: &str, to: &str| {
        assert!(STUDY.contains(from));
        STUDY.replace(from, to)
    };
    let many = "{ from = 0.1, to = 0.2, count = 1_000_000_000_000 }";
    for (study, exit, words) in [
        (other("0.2, -0.5", "0.25"), 1, "SL0807"),
        (other("parameters.mu", "parameters.mue"), 1, "SL0801"),
        (other("parameters.mu", "parameters.mue"), 1, "study.toml:2:12"),
        (other("[0.1, 0.2, -0.5]", "[]"), 1, "SL0803"),
        (other("[0.1, 0.2, -0.5]", many), 1, "SL0803"),
        (other("count = 4", "mean = 1.0"), 1, "SL0803"),
        (other("from = 0.9", "from = 1.9"), 1, "SL0803"),
        (other("from = 0.9", "from = nan"), 1, "SL0806"),
        (other("from = 0.9", "form = 0.9"), 1, "Did you mean from?"),
        (other("[0.1, ", "[0.1 "), 1, "SL0806"),
        (other("deck = \"job.inp\"\n", ""), 1, "SL0806"),
        (other("job.inp", "jab.inp"), 1, "SL0701"),
        (other("peak(RF1@1)", "peek(RF1@1)"), 1, "SL0804"),
        (other("peak(RF1@1)", "peak(RF1@4711)"), 1, "SL0805"),
        (other("force / (scale", "farce / (scale"), 1, "did you mean force?"),
        (format!("gradients = true\n{STUDY}"), 1, "SL0809"),
        (format!("design = \"sobol\"\n{STUDY}"), 1, "cases = 1000"),
    ] {
        std::fs::write(folder.join("study.toml"), &study).unwrap();
        let (code, said) = sweep(&folder, &["--out", "out"]);
        assert!(code == exit && said.contains(words), "{words}: {code} {said}\n{study}");
    }
    std::fs::write(folder.join("study.toml"), STUDY).unwrap();
    std::fs::write(folder.join("file"), "").unwrap();
    let (code, said) = sweep(&folder, &["--out", "file/below"]);
    assert!(code == 4 && said.contains("SL0702"), "{code} {said}");
    assert_eq!(sweep(&folder, &["--shard", "3/3"]).0, 64);
}
