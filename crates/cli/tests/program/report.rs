//! `slideline report` and `slideline plot`: from files alone, and what they
//! say about files that are none.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const DECK: &str =
    concat!(env!("CARGO_MANIFEST_DIR"), "/../../corpus/diehl1995/isl_coarse_push_pull_mu03.inp");

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("report").join(name);
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

fn code(output: &Output) -> i32 {
    output.status.code().unwrap_or_else(|| panic!("{output:?}"))
}

fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn stdout(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// A folder with the results of the push-pull deck and a copy of the deck.
fn job(name: &str) -> PathBuf {
    let folder = folder(name);
    std::fs::copy(DECK, folder.join("job.inp")).unwrap();
    let output = slideline(&folder, &["run", "job", "--quiet"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    folder
}

fn read(folder: &Path, name: &str) -> String {
    std::fs::read_to_string(folder.join(name)).unwrap()
}

#[test]
fn a_run_ends_with_a_report_that_the_files_alone_give_again() {
    let folder = job("again");
    let first = read(&folder, "job.html");
    assert!(first.len() <= 1_500_000, "{} bytes", first.len());
    for asked in ["job", "job.json", "job.inp", "job.history.csv", "job.pvd"] {
        std::fs::remove_file(folder.join("job.html")).unwrap();
        let output = slideline(&folder, &["report", asked]);
        assert_eq!(code(&output), 0, "{}", stderr(&output));
        assert_eq!(read(&folder, "job.html"), first);
        let said = stdout(&output);
        for part in [
            "Completed: 40 increments",
            "Verdict amber",
            "ot self-locking",
            "ull-out force",
            "job.html",
        ] {
            assert!(said.contains(part), "{part}: {said}");
        }
    }
    assert!(!first.contains("src=") && !first.contains("http-equiv=\"refresh"), "it is alone");
    let output = slideline(&folder, &["run", "job", "--quiet", "--no-html"]);
    assert_eq!(code(&output), 0);
    assert!(!folder.join("job.html").exists(), "--no-html leaves none, not even an old one");
}

/// Requirement: issue text, "a clear message, nothing overwritten".
#[test]
fn files_that_are_missing_truncated_or_foreign_are_named_and_nothing_is_written() {
    let folder = job("bad-files");
    std::fs::write(folder.join("job.html"), "kept").unwrap();
    let half = |name: &str| {
        let text = std::fs::read(folder.join(name)).unwrap();
        text[..text.len() / 2].to_vec()
    };
    let without_last_line = |name: &str| {
        let text = read(&folder, name);
        let end = text.trim_end().rfind('\n').unwrap() + 1;
        text.as_bytes()[..end].to_vec()
    };
    let heading = |name: &str| {
        let text = read(&folder, name);
        text.as_bytes()[..=text.find('\n').unwrap()].to_vec()
    };
    let cases: Vec<(&str, Option<Vec<u8>>)> = vec![
        ("job.json", None),
        ("job.json", Some(half("job.json"))),
        ("job.json", Some(b"{\"schema\":99,\"status\":\"completed\"}".to_vec())),
        ("job.json", Some(b"[1, 2]".to_vec())),
        ("job.history.csv", Some(half("job.history.csv"))),
        ("job.history.csv", Some(b"a,b\n1,2\n".to_vec())),
        ("job.contact.csv", Some(half("job.contact.csv"))),
        ("job.contact.csv", Some(without_last_line("job.contact.csv"))),
        ("job.contact.csv", Some(heading("job.contact.csv"))),
        ("job.contact.csv", Some(vec![0xff, 0xfe, 0, 1])),
        ("job.energy.csv", None),
        ("job.energy.csv", Some(half("job.energy.csv"))),
        ("job_0007.vtu", None),
        ("job_0007.vtu", Some(half("job_0007.vtu"))),
        ("job_0000.vtu", Some(b"<?xml version=\"1.0\"?><VTKFile/>".to_vec())),
        ("job.dat", None),
        ("job.msg", None),
        ("job.pair.csv", Some(half("job.pair.csv"))),
        ("job.pair.csv", Some(without_last_line("job.pair.csv"))),
    ];
    for (name, content) in cases {
        let path = folder.join(name);
        let good = std::fs::read(&path).unwrap();
        match &content {
            Some(content) => std::fs::write(&path, content).unwrap(),
            None => std::fs::remove_file(&path).unwrap(),
        }
        let output = slideline(&folder, &["report", "job"]);
        assert_eq!(code(&output), 1, "{name}: {}", stderr(&output));
        let said = stderr(&output);
        assert!(said.contains("SL0704") && said.contains(name), "{name}: {said}");
        assert_eq!(read(&folder, "job.html"), "kept", "{name}");
        assert!(!folder.join("job.html.part").exists());
        std::fs::write(&path, good).unwrap();
    }
    assert_eq!(code(&slideline(&folder, &["report", "job"])), 0);
    assert_eq!(code(&slideline(&folder, &["report", "nothing"])), 1);
}

#[test]
fn a_job_that_runs_is_refused_unless_asked_for() {
    let folder = job("running");
    let json = read(&folder, "job.json").replace("\"completed\"", "\"running\"");
    std::fs::write(folder.join("job.json"), json).unwrap();
    // a process that was killed left a row without its end
    let history = read(&folder, "job.history.csv");
    std::fs::write(folder.join("job.history.csv"), &history[..history.len() - 9]).unwrap();
    let energy = read(&folder, "job.energy.csv");
    let whole = energy.trim_end().rfind('\n').unwrap() + 4;
    std::fs::write(folder.join("job.energy.csv"), &energy[..whole]).unwrap();
    std::fs::write(folder.join("job.html"), "kept").unwrap();
    let output = slideline(&folder, &["report", "job"]);
    assert_eq!(code(&output), 1);
    assert!(stderr(&output).contains("SL0705"), "{}", stderr(&output));
    assert_eq!(read(&folder, "job.html"), "kept");
    let output = slideline(&folder, &["report", "job", "--unfinished"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let said = stdout(&output);
    assert!(said.contains("Not finished") && said.contains("39 increments"), "{said}");
}

/// A process that runs a long job, in a folder of its own.
fn long_run(name: &str) -> (PathBuf, std::process::Child) {
    let folder = folder(name);
    let deck = std::fs::read_to_string(DECK).unwrap();
    let long = deck.replace("0.05, 1.0, 1.0E-6, 0.05", "1.0E-5, 1.0, 1.0E-9, 1.0E-5");
    assert_ne!(deck, long);
    std::fs::write(folder.join("job.inp"), long.replace("INC=100", "INC=1000000")).unwrap();
    let run = Command::new(env!("CARGO_BIN_EXE_slideline"))
        .args(["run", "job", "--quiet"])
        .current_dir(&folder)
        .spawn()
        .unwrap();
    while !folder.join("job_0005.vtu").exists() {
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    (folder, run)
}

/// Requirement: "a job still running: a clear message, nothing overwritten":
/// neither a report of it nor a second run of it, and a kill does not leave it
/// running for ever.
#[test]
fn a_job_that_runs_is_told_from_one_that_was_killed() {
    let (folder, mut run) = long_run("lock");
    for ask in [&["report", "job"][..], &["plot", "job", "--x", "U2", "--y", "RF2"]] {
        let output = slideline(&folder, ask);
        assert_eq!(code(&output), 1, "{}", stderr(&output));
        let said = stderr(&output);
        assert!(said.contains("SL0705") && said.contains("still running, and it is"), "{said}");
    }
    let count = || read(&folder, "job.energy.csv").lines().count();
    let before = count();
    for ask in [&["run", "job"][..], &["run", "job", "--restart"]] {
        let output = slideline(&folder, ask);
        assert_eq!(code(&output), 1, "{}", stderr(&output));
        let said = stderr(&output);
        assert!(said.contains("SL0705") && said.contains("another process"), "{said}");
    }
    // a deck that was spoilt in the meantime does not take the files away either
    std::fs::rename(folder.join("job.inp"), folder.join("kept.inp")).unwrap();
    std::fs::write(folder.join("job.inp"), "*NODE\n1, x\n").unwrap();
    assert_eq!(code(&slideline(&folder, &["run", "job"])), 1);
    assert!(count() >= before && folder.join("job_0005.vtu").exists(), "the run goes on");
    let output = slideline(&folder, &["report", "job", "--unfinished"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    assert!(read(&folder, "job.html").contains("The job was running when this page was made"));
    run.kill().unwrap();
    run.wait().unwrap();
    std::fs::rename(folder.join("kept.inp"), folder.join("job.inp")).unwrap();
    std::fs::write(folder.join("job.html"), "kept").unwrap();
    let output = slideline(&folder, &["report", "job"]);
    assert_eq!(code(&output), 1);
    let said = stderr(&output);
    assert!(said.contains("SL0705") && said.contains("it was killed"), "{said}");
    assert_eq!(read(&folder, "job.html"), "kept");
    let output = slideline(&folder, &["report", "job", "--unfinished"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    assert!(read(&folder, "job.html").contains("The job had been killed when this page"));
    std::fs::copy(DECK, folder.join("job.inp")).unwrap();
    let output = slideline(&folder, &["run", "job", "--quiet"]);
    assert_eq!(code(&output), 0, "what a kill left stops nobody: {}", stderr(&output));
    assert!(!folder.join("job.lck").exists());
}

/// Requirement: `plot` says what is wrong with the files it reads, and leaves
/// a figure that was there as it was.
#[test]
fn plots_of_bad_files_are_refused_and_nothing_is_written() {
    let folder = job("bad-plots");
    std::fs::write(folder.join("f.svg"), "kept").unwrap();
    let half = |name: &str| {
        let text = std::fs::read(folder.join(name)).unwrap();
        text[..text.len() / 2].to_vec()
    };
    let cases: Vec<(&str, Option<Vec<u8>>)> = vec![
        ("job.json", None),
        ("job.json", Some(half("job.json"))),
        ("job.json", Some(b"{\"name\":\"of something else\"}".to_vec())),
        ("job.history.csv", None),
        ("job.history.csv", Some(half("job.history.csv"))),
        ("job.history.csv", Some(b"time;force\n1;2\n".to_vec())),
        ("job.history.csv", Some(vec![0xff, 0xfe, 0, 1])),
        ("job.energy.csv", None),
        ("job.energy.csv", Some(Vec::new())),
    ];
    for (name, content) in cases {
        let path = folder.join(name);
        let good = std::fs::read(&path).unwrap();
        match &content {
            Some(content) => std::fs::write(&path, content).unwrap(),
            None => std::fs::remove_file(&path).unwrap(),
        }
        let ask = ["plot", "job", "--x", "U2", "--y", "RF2", "-o", "f.svg"];
        let output = slideline(&folder, &ask);
        assert_eq!(code(&output), 1, "{name}: {}", stderr(&output));
        let said = stderr(&output);
        assert!(said.contains("SL0704") && said.contains(name), "{name}: {said}");
        assert_eq!(read(&folder, "f.svg"), "kept", "{name}");
        std::fs::write(&path, good).unwrap();
    }
}

/// Requirement: names with spaces, quotes, brackets and letters of other
/// scripts, in the folder, the job, the sets and the texts: every file has its
/// name, reads back, and shows it as text. Source: issue, "Bad input".
#[test]
fn strange_names_are_only_names() {
    let folder = folder("a <b> 'q' \"p\" & \u{6f22}");
    let name = "j <script>alert(1) 'q' \"p\" & \u{436}";
    let deck = std::fs::read_to_string(DECK).unwrap();
    let heading = "*HEADING\n</script><script>alert(2)</script> \u{6f22}\n";
    // names of a deck lose blanks and case
    let (pair, name_of_pair) = ("\"</script><img/src=x>\u{436}\"", "</SCRIPT><IMG/SRC=X>\u{416}");
    let deck =
        deck.replacen("*HEADING\n", heading, 1).replace("ELSET=ISL", &format!("ELSET={pair}"));
    let requests = "*NODE FILE\nU\n*CONTACT PRINT, FREQUENCY=20\nCSTRESS\n*END STEP";
    let deck = deck.replace("*END STEP", requests);
    std::fs::write(folder.join(format!("{name}.inp")), deck).unwrap();
    let output = slideline(&folder, &["run", name, "--quiet"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let html = read(&folder, &format!("{name}.html"));
    assert_eq!(html.matches("<script").count(), 2, "data and program, nothing else");
    assert!(
        !html.to_lowercase().contains("<img") && !html.contains("alert(2)<"),
        "texts are escaped"
    );
    assert!(
        html.contains("<p class=\"job\">j &lt;script&gt;alert(1) 'q' &quot;p&quot; &amp; \u{436}")
    );
    let title = "&lt;/script&gt;&lt;script&gt;alert(2)&lt;/script&gt; \u{6f22}";
    assert!(html.contains(&format!("<title>{title} - slideline</title>")), "the heading");
    assert!(html.contains(&format!("<h1>{title}</h1>")));
    let json: serde_json::Value =
        serde_json::from_str(&read(&folder, &format!("{name}.json"))).unwrap();
    assert_eq!(json["job"], name);
    assert_eq!(json["pairs"][0]["name"], name_of_pair);
    let list = read(&folder, &format!("{name}.pvd"));
    let file = format!("{name}_0001.vtu").replace('&', "&amp;").replace('<', "&lt;");
    assert!(list.contains(&format!("file=\"{}\"", file.replace('"', "&quot;"))), "{list}");
    let contact = read(&folder, &format!("{name}.contact.csv"));
    assert!(contact.contains(name_of_pair), "{contact}");
    assert!(read(&folder, &format!("{name}.dat")).contains(name_of_pair));
    assert!(read(&folder, &format!("{name}.frd")).is_ascii(), "the format knows no other letters");
    std::fs::remove_file(folder.join(format!("{name}.html"))).unwrap();
    let output = slideline(&folder, &["report", &format!("{name}.json")]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    assert_eq!(read(&folder, &format!("{name}.html")), html);
    let plot = ["plot", name, "--x", "U2", "--y", "RF2", "--compare", name, "-o", "f <1>.svg"];
    let output = slideline(&folder, &plot);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let svg = read(&folder, "f <1>.svg");
    assert!(!svg.contains("<script") && svg.contains("&lt;script&gt;"), "{svg}");
}

#[test]
fn a_deck_that_was_changed_is_told() {
    let folder = job("changed");
    let deck = read(&folder, "job.inp");
    std::fs::write(folder.join("job.inp"), deck.replace("0.3", "0.2")).unwrap();
    let output = slideline(&folder, &["report", "job"]);
    assert_eq!(code(&output), 0);
    assert!(stderr(&output).contains("SL0706"), "{}", stderr(&output));
    assert!(read(&folder, "job.html").contains("The deck was changed after this run"));
    let output = slideline(&folder, &["plot", "job", "--x", "U2", "--y", "RF2"]);
    assert_eq!(code(&output), 0);
    assert!(stderr(&output).contains("SL0706"), "{}", stderr(&output));
    assert!(stdout(&output).starts_with("time,U2,RF2\n"), "the numbers stand alone");
}

#[test]
fn a_report_that_cannot_be_written_is_exit_4() {
    let folder = job("unwritable");
    std::fs::remove_file(folder.join("job.html")).unwrap();
    std::fs::create_dir(folder.join("job.html")).unwrap();
    let output = slideline(&folder, &["report", "job"]);
    assert_eq!(code(&output), 4, "{}", stderr(&output));
    assert!(stderr(&output).contains("SL0702"), "{}", stderr(&output));
}

#[test]
fn an_overlay_must_be_a_curve() {
    let folder = job("overlay");
    std::fs::write(folder.join("theory.csv"), "increment,time,RF2,U2\n0,0,0,0\n1,1,-9,-0.03\n")
        .unwrap();
    assert_eq!(code(&slideline(&folder, &["report", "job", "--overlay", "theory.csv"])), 0);
    assert!(read(&folder, "job.html").contains("\"name\":\"theory.csv\""));
    for wrong in ["a,b\n1,2\n", "U2,RF2\n", "U2,RF2\n1,2", ""] {
        std::fs::write(folder.join("wrong.csv"), wrong).unwrap();
        let output = slideline(&folder, &["report", "job", "--overlay", "wrong.csv"]);
        assert_eq!(code(&output), 1, "{wrong:?}: {}", stderr(&output));
        assert!(stderr(&output).contains("wrong.csv"), "{}", stderr(&output));
    }
}

#[test]
fn plots_are_numbers_svg_or_png() {
    let folder = job("plot");
    let ask = ["plot", "job", "--x", "U2", "--y", "RF2"];
    let with = |more: &[&str]| slideline(&folder, &[&ask[..], more].concat());
    let table = stdout(&with(&["--node", "9999"]));
    let mut lines = table.lines();
    assert_eq!(lines.next(), Some("time,U2,RF2"));
    assert_eq!(lines.next(), Some("0,0,0"));
    let last = read(&folder, "job.history.csv").lines().last().unwrap().to_owned();
    let cells: Vec<&str> = last.split(',').collect();
    assert_eq!(lines.last().unwrap(), format!("{},{},{}", cells[2], cells[5], cells[8]));
    assert_eq!(stdout(&with(&[])), table, "the only driven node need not be named");

    for (name, begin) in [("f.svg", &b"<svg "[..]), ("f.png", &b"\x89PNG"[..]), ("f.csv", b"time,")]
    {
        let output = with(&["-o", name, "--compare", "job"]);
        assert_eq!(code(&output), 0, "{}", stderr(&output));
        assert!(stdout(&output).contains("largest difference 0e0"), "{}", stdout(&output));
        assert!(std::fs::read(folder.join(name)).unwrap().starts_with(begin), "{name}");
    }
    assert_eq!(code(&with(&["--node", "1"])), 1);
    assert_eq!(code(&slideline(&folder, &["plot", "job", "--x", "U2", "--y", "RF7"])), 1);
    assert_eq!(code(&with(&["-o", "f.pdf"])), 64);
    assert_eq!(code(&with(&["-o", "no/such/folder/f.svg"])), 4);
}
