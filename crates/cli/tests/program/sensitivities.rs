//! `slideline run --sensitivities` and studies with gradients.
//!
//! Requirement: `JOB.sensitivity.csv` has a row a converged increment, column of the histories and
//! parameter of the deck, and the derivative in it is that of differences of runs; what has none is told.
//! Source: contract, the files of a job.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::jobs::{MOTIONS, code, folder, irs, model, slideline, stderr, step};
use std::path::Path;

/// A deck with the parameters `mu` and `height`.
fn deck(head: &str) -> String {
    let contact = irs().replace("*FRICTION\n0.3\n", "*FRICTION\n<mu>\n");
    let columns = model("", &contact).replace("0.01, 0.01\n", "0.01, <height>\n");
    let step = step(5, MOTIONS[1])
        .replace("*BOUNDARY", "*CONTROLS, PARAMETERS=FIELD\n1e-11, 1e-8\n*BOUNDARY");
    format!("*PARAMETER\nmu = 0.3\nheight = 0.01\n{head}{columns}{step}")
}

fn rows(folder: &Path, file: &str) -> Vec<Vec<String>> {
    let text = std::fs::read_to_string(folder.join(file)).unwrap();
    text.lines().map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

/// The last RF1 and RF2 of node 9, of a run with other values.
fn last(folder: &Path, set: &str) -> [f64; 2] {
    let output =
        slideline(folder, &["run", "job", "--quiet", "--no-html", "--set", set, "--out", "other"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let all = rows(&folder.join("other"), "job.history.csv");
    let place = |name: &str| all[0].iter().position(|own| own == name).unwrap();
    ["RF1", "RF2"].map(|name| all.last().unwrap()[place(name)].parse().unwrap())
}

#[test]
fn derivatives_of_histories_are_those_of_differences() {
    let folder = folder("histories");
    std::fs::write(folder.join("job.inp"), deck("")).unwrap();
    let output = slideline(&folder, &["run", "job", "--sensitivities", "--quiet", "--no-html"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let all = rows(&folder, "job.sensitivity.csv");
    let head = "step,increment,time,response,parameter,derivative,one_sided";
    assert_eq!(all[0].join(","), head);
    // five increments, two parameters, six columns of one node
    assert_eq!(all.len(), 1 + 5 * 2 * 6, "{all:?}");
    for (name, value) in [("mu", 0.3), ("height", 0.01)] {
        let h = 1e-4 * value;
        let runs = [-1.0, 1.0].map(|k| last(&folder, &format!("{name}={:?}", value + k * h)));
        for (of, column) in ["9.RF1", "9.RF2"].iter().enumerate() {
            let row = all.iter().rfind(|row| row[3] == *column && row[4] == name).unwrap();
            let (own, by) =
                (row[5].parse::<f64>().unwrap(), (runs[1][of] - runs[0][of]) / (2.0 * h));
            let size = runs[0].iter().fold(0.0, |most: f64, own| most.max(own.abs())) / value;
            assert!((own - by).abs() < 1e-6 * size, "{column} by {name}: {own} {by}");
            assert_eq!(row[6], "0");
        }
    }
}

#[test]
fn what_has_no_derivative_is_told() {
    let folder = folder("told");
    std::fs::write(
        folder.join("count.inp"),
        deck("last = 9\nsize = 0.2\n")
            .replace("9, 1, 1,", "<last>, 1, 1,")
            .replace("0.2, 1.0, 1.0E-9, 0.2", "<size>, 1.0, 1.0E-9, 0.2"),
    )
    .unwrap();
    let output = slideline(&folder, &["run", "count", "--sensitivities", "--quiet", "--no-html"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    for told in ["no sensitivities by last", "no sensitivities by size"] {
        assert!(stderr(&output).contains(told), "{}", stderr(&output));
    }
    assert!(stderr(&output).contains("SL0811"), "{}", stderr(&output));
    let plain = model("", &irs()) + &step(5, MOTIONS[0]);
    std::fs::write(folder.join("plain.inp"), plain).unwrap();
    let output = slideline(&folder, &["run", "plain", "--sensitivities", "--quiet"]);
    assert_eq!(code(&output), 1);
    assert!(stderr(&output).contains("SL0810"), "{}", stderr(&output));
    assert!(!folder.join("plain.sensitivity.csv").exists());
    let output = slideline(&folder, &["run", "plain", "--sensitivities", "--restart"]);
    assert!(stderr(&output).contains("cannot be used with"), "{}", stderr(&output));
}

const STUDY: &str = "deck = \"job.inp\"\ngradients = true\n\
    parameters.mu = [0.2999, 0.3, 0.3001]\nparameters.height = [0.01]\n\
    responses.force = \"peak(RF1@9)\"\n\
    responses.work = \"work(RF2@9, U2@9)\"\n\
    responses.both = \"sqrt(force*height) / (1 + abs(work)) - mu*at(RF2@9, 0.5) + max(RF2@9)\"\n\
    responses.count = \"increments\"\n";

/// Requirement: gradients follow the rules of derivatives through measures and arithmetic: those of
/// the middle case are differences of the others to 1e-6.
#[test]
fn gradients_of_a_study_are_those_of_differences() {
    let folder = folder("study");
    std::fs::write(folder.join("job.inp"), deck("")).unwrap();
    std::fs::write(folder.join("study.toml"), STUDY).unwrap();
    let output = slideline(&folder, &["sweep", "study.toml", "--quiet", "--out", "out", "--csv"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let all = rows(&folder.join("out"), "study.csv");
    let place = |name: &str| all[0].iter().position(|own| own == name).unwrap();
    let value = |row: usize, name: &str| all[row][place(name)].parse::<f64>().unwrap();
    for name in ["force", "work", "both"] {
        let by = (value(3, name) - value(1, name)) / 2e-4;
        let own = value(2, &format!("d({name})/d(mu)"));
        let size = value(2, name).abs() / 0.3;
        assert!((own - by).abs() < 2e-6 * size.max(by.abs()), "{name}: {own} {by}");
        assert!(value(2, &format!("d({name})/d(height)")).is_finite());
    }
    assert_eq!(all[2][place("d(count)/d(mu)")], "");
}

/// Requirement: a case whose outline is another one than that of the case before has its gradients.
#[test]
fn cases_of_another_outline_have_gradients() {
    let folder = folder("outlines");
    let beams = "*ELEMENT, TYPE=B21, ELSET=BEAMS\n";
    let more = format!("50, 0.0, 0.2\n51, 0.0, 0.3\n{beams}3, 1, <top>\n");
    std::fs::write(folder.join("job.inp"), deck("top = 50\n").replace(beams, &more)).unwrap();
    let study = "deck = \"job.inp\"\ngradients = true\nparameters.mu = [0.3]\n\
                 parameters.top = [50, 51, 50]\nresponses.force = \"peak(RF1@9)\"\n";
    std::fs::write(folder.join("study.toml"), study).unwrap();
    let output = slideline(&folder, &["sweep", "study.toml", "--quiet", "--out", "out", "--csv"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let all = rows(&folder.join("out"), "study.csv");
    let place = all[0].iter().position(|own| own == "d(force)/d(mu)").unwrap();
    let found: Vec<f64> = all[1..].iter().map(|row| row[place].parse().unwrap()).collect();
    assert_eq!(found.len(), 3);
    assert!(found.iter().all(|own| *own == found[0] && *own != 0.0), "{found:?}");
}
