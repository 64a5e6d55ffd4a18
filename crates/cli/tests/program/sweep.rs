//! Studies from the command line.
//!
//! Requirement: a study has the same bits on any number of threads and in any order of its shards;
//! what was done is kept, what is damaged is computed again, a case that fails is a row, and what is
//! wrong is said before anything is run. Source: contract, `slideline sweep`.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::jobs::{MOTIONS, code, folder, irs, model, slideline, stderr, step};
use std::path::Path;

const STUDY: &str = "deck = \"job.inp\"\n\
    parameters.mu = [0.1, 0.2, -0.5]\n\
    parameters.scale = { from = 0.9, to = 1.1, count = 4 }\n\
    responses.force = \"peak(RF1@1)\"\n\
    responses.share = \"force / (scale + 1)\"\n";

const CORRELATED: &str = "[[correlated]]\nbetween = [\"mu\", \"scale\"]\ncoefficient = 0.5\n";

/// A deck with the parameters `mu` and `scale`.
fn deck() -> String {
    let contact = irs().replace("*FRICTION\n0.3\n", "*FRICTION\n<mu>\n");
    let head = "*PARAMETER\nmu = 0.3\nscale = 1.0\n";
    format!("{head}{}{}", model("", &contact), step(5, MOTIONS[0]))
}

/// A folder with that deck and a study.
fn prepared(name: &str, study: &str) -> std::path::PathBuf {
    let folder = folder(name);
    std::fs::write(folder.join("job.inp"), deck()).unwrap();
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

/// Requirement: one number goes with all values of the lists beside it.
#[test]
fn one_number_stands_beside_lists() {
    let study = STUDY.replace("{ from = 0.9, to = 1.1, count = 4 }", "1.05");
    let folder = prepared("sweep_together", &format!("design = \"together\"\n{study}"));
    assert_eq!(sweep(&folder, &["--out", "out", "--csv"]), (0, String::new()));
    let table = table(&folder, "out");
    let scales: Vec<&str> = table.lines().skip(1).filter_map(|row| row.split(',').nth(2)).collect();
    assert_eq!(scales, ["1.05"; 3], "{table}");
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
    let million = "{ from = 0.1, to = 0.2, count = 1_000_000 }";
    let most = "{ from = 0.1, to = 0.2, count = 9_000_000_000_000 }";
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
        (other("peak(RF1@1)", "peak(RF1@4711)"), 1, "study.toml:4:25"),
        (other("peak(RF1@1)", "peak(RF1@1, 99)"), 1, "SL0805"),
        (other("peak(RF1@1)", "peak(RF1@1, 99)"), 1, "names step 99, but the deck has"),
        (other("peak(RF1@1)", "at(RF1@1, 1e9)"), 1, "but the analysis ends at"),
        (other("peak(RF1@1)", "peak(force_x@NONE)"), 1, "Its contact pairs: "),
        (other("peak(RF1@1)", "peak(released_energie)"), 1, "SL0804"),
        (other("peak(RF1@1)", "last(balance@1)"), 1, "leave @ out"),
        (other("peak(RF1@1)", "peak(RF1@1)) + 1"), 1, "study.toml:4:31"),
        (other("force / (scale", "farce / (scale"), 1, "study.toml:5:20"),
        (other("\"force / (scale + 1)\"", "\"for\\u0063e / scal\""), 1, "study.toml:5:19"),
        (other("[0.1, 0.2, -0.5]", million).replace("count = 4", "count = 1_000_000"), 1, "SL0803"),
        (
            other("[0.1, 0.2, -0.5]", most).replace("count = 4", "count = 9_000_000_000_000"),
            1,
            "SL0803",
        ),
        (format!("design = \"saltelli\"\ncases = 10\n{STUDY}"), 1, "say cases = 12"),
        (format!("design = \"saltelli\"\ncases = 12\n{STUDY}{CORRELATED}"), 1, "independent"),
        (other("force / (scale", "farce / (scale"), 1, "did you mean force?"),
        (format!("gradients = 1\n{STUDY}"), 1, "SL0809"),
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

/// Requirement: a file of another study is not taken for a shard of this one.
#[test]
fn shards_of_another_study_are_computed_again() {
    let folder = prepared("sweep_other", STUDY);
    assert_eq!(sweep(&folder, &["--out", "one", "--csv"]).0, 0);
    let other = STUDY.replace("0.2, -0.5", "0.25, -0.5");
    std::fs::write(folder.join("study.toml"), other).unwrap();
    assert_eq!(sweep(&folder, &["--out", "two", "--csv"]).0, 0);
    let right = table(&folder, "two");
    assert_ne!(table(&folder, "one"), right);
    let shard = "shard_00000.parquet";
    std::fs::copy(folder.join("one").join(shard), folder.join("two").join(shard)).unwrap();
    let (code, said) = sweep(&folder, &["--out", "two", "--csv"]);
    assert!(code == 0 && said.contains("SL0808") && said.contains("another study"), "{said}");
    assert_eq!(table(&folder, "two"), right);
}

/// Requirement: a value that makes the geometry impossible, and one without meaning for the deck, are
/// rows with the codes that `run` has for them; the other cases are run.
#[test]
fn impossible_geometry_is_a_row_with_its_code() {
    let study = "deck = \"job.inp\"\nparameters.scale = [1.0, 0.0, -1.0, 2.0]\n\
                 responses.force = \"peak(RF1@1)\"\n";
    let folder = prepared("sweep_geometry", study);
    let wrong = deck().replace("1, 0.0, 0.1\n", "1, 0.0, <top>\n");
    let wrong = wrong.replace("scale = 1.0\n", "scale = 1.0\ntop = 0.1*scale\n");
    assert!(wrong.contains("<top>"));
    std::fs::write(folder.join("job.inp"), wrong).unwrap();
    assert_eq!(sweep(&folder, &["--csv"]), (0, String::new()));
    let all = table(&folder, "study");
    let code =
        |row: usize| all.lines().nth(row + 1).unwrap().rsplit(',').next().unwrap().to_owned();
    assert_eq!([code(0), code(3)], ["", ""], "{all}");
    let output = slideline(&folder, &["run", "job", "--quiet", "--no-html", "--set", "scale=0.0"]);
    assert!(code(1).starts_with("SL0") && stderr(&output).contains(&code(1)), "{all}");
}

/// Requirement: verdict, utilisation, margin, contact forces and energies of a case are those that the
/// files of a run with its values have.
#[test]
fn responses_are_those_of_the_files() {
    let study = "deck = \"job.inp\"\n[parameters]\nmu = [0.1, 0.3]\n[responses]\n\
        used = \"utilisation\"\nmargin = \"strain_margin\"\ncolour = \"verdict\"\n\
        pressed = \"max(normal_force@SLAVES)\"\ndragged = \"last(friction_x@SLAVES)\"\n\
        lost = \"last(friction_dissipation)\"\n";
    let folder = prepared("sweep_files", study);
    let elastic = "1.0E9, 0.3\n";
    let allowable = format!("{elastic}*ALLOWABLE, MATERIAL=M, STRAIN=0.002\n");
    let allowed = deck().replace(elastic, &allowable) + &step(5, MOTIONS[1]);
    let pair = allowed.split("*INTERFACE, ELSET=").nth(1).unwrap();
    let pair = pair.split(['\n', ',']).next().unwrap().to_owned();
    std::fs::write(folder.join("job.inp"), allowed).unwrap();
    std::fs::write(folder.join("study.toml"), study.replace("SLAVES", &pair)).unwrap();
    assert_eq!(sweep(&folder, &["--csv"]), (0, String::new()));
    let all = table(&folder, "study");
    for (row, mu) in ["0.1", "0.3"].iter().enumerate() {
        let set = format!("mu={mu}");
        assert_eq!(code(&slideline(&folder, &["run", "job", "--quiet", "--set", &set])), 0);
        let read = |name: &str| std::fs::read_to_string(folder.join(name)).unwrap();
        let summary: serde_json::Value = serde_json::from_str(&read("job.json")).unwrap();
        let last = |file: &str, column: &str| -> f64 {
            let text = read(file);
            let place = text.lines().next().unwrap().split(',').position(|own| own == column);
            text.lines().last().unwrap().split(',').nth(place.unwrap()).unwrap().parse().unwrap()
        };
        let colours = ["green", "amber", "red"];
        let colour = summary["verdict"]["colour"].as_str().unwrap();
        let expected = [
            summary["allowable"]["utilisation"].as_f64().unwrap(),
            summary["allowable"]["margin"].as_f64().unwrap(),
            colours.iter().position(|own| *own == colour).unwrap() as f64,
            summary["normal_force"]["max"].as_f64().unwrap(),
            last("job.pair.csv", "friction_x"),
            last("job.energy.csv", "friction_dissipation"),
        ];
        let line = all.lines().nth(row + 1).unwrap();
        let found: Vec<f64> =
            line.split(',').skip(2).take(6).map(|own| own.parse().unwrap()).collect();
        assert_eq!(found, expected, "{all}");
    }
}

/// Requirement: shares of the variance of a sum are those of its parts. Source: of uniform x and y of
/// the same width, x + 2 y owes them 1/5 and 4/5 of its variance.
#[test]
fn shares_of_the_variance_are_written() {
    let study = "deck = \"job.inp\"\ndesign = \"saltelli\"\ncases = 1024\n[parameters]\n\
        mu = { from = 0.1, to = 0.3 }\nscale = { from = 0.9, to = 1.1 }\n\
        [responses]\nsum = \"mu + 2*scale\"\n";
    let folder = prepared("sweep_shares", study);
    assert_eq!(sweep(&folder, &["--threads", "2"]), (0, String::new()));
    let text = std::fs::read_to_string(folder.join("study/indices.csv")).unwrap();
    let rows: Vec<Vec<&str>> = text.lines().skip(1).map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), 2, "{text}");
    for (row, (name, expected)) in rows.iter().zip([("mu", 0.2), ("scale", 0.8)]) {
        assert_eq!(row[..2], ["sum", name]);
        for at in [2, 4] {
            let found: f64 = row[at].parse().unwrap();
            assert!((found - expected).abs() < 0.01, "{text}");
        }
        assert_eq!(row[6], "256");
    }
}
