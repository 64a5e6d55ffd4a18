//! The program as a user meets it: standard output, standard error, exit
//! codes and files.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

const PROGRAM: &str = env!("CARGO_BIN_EXE_slideline");

/// An empty folder of that name.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

fn slideline(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(PROGRAM).args(arguments).current_dir(folder).output().unwrap()
}

fn stdout(output: &Output) -> &str {
    std::str::from_utf8(&output.stdout).unwrap()
}

fn stderr(output: &Output) -> &str {
    std::str::from_utf8(&output.stderr).unwrap()
}

/// A column that slides on a rigid plane below it, with friction: small, and
/// in contact from the first increment.
fn column(step: &str) -> String {
    format!(
        "*HEADING
column on a plane
*NODE, NSET=ALL
1, 0.0, 0.1
2, 0.0, 0.0
3, 0.01, 0.1
4, 0.01, 0.0
9, 0.0, 0.0
*ELEMENT, TYPE=B21, ELSET=BEAMS
1, 1, 2
2, 3, 4
*BEAM SECTION, SECTION=RECT, ELSET=BEAMS, MATERIAL=M
0.01, 0.01
*MATERIAL, NAME=M
*ELASTIC
1.0E9, 0.3
*RIGID SURFACE, TYPE=SEGMENTS, ELSET=TIPS
START, -1.0, -1.0E-4
LINE, 1.0, -1.0E-4
*ELEMENT, TYPE=IRS21, ELSET=TIPS
11, 2, 4, 9
*INTERFACE, ELSET=TIPS
0.025
*FRICTION
0.3
*SURFACE CONTACT, SOFTENED
1.0E-5, 4.8E6
*NSET, NSET=PLANE
9
{step}"
    )
}

const SLIDE: &str = "*STEP, NLGEOM, INC=100
RAISE AND SLIDE
*STATIC
0.2, 1.0, 1.0E-6, 0.2
*BOUNDARY
1, 1, 6
3, 1, 6
2, 1
2, 6
4, 1
4, 6
9, 1, 1, 1.0E-3
9, 2, 2, 1.2E-4
9, 6, 6
*NODE PRINT, NSET=PLANE
U, RF
*END STEP
";

fn write_deck(folder: &Path, name: &str, text: &str) {
    std::fs::write(folder.join(name), text).unwrap();
}

fn read(folder: &Path, name: &str) -> String {
    std::fs::read_to_string(folder.join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
}

fn summary(folder: &Path, job: &str) -> Value {
    serde_json::from_str(&read(folder, &format!("{job}.json"))).unwrap()
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

fn code(output: &Output) -> i32 {
    output.status.code().unwrap_or_else(|| panic!("{output:?}"))
}

#[test]
fn a_run_completes_and_leaves_the_files_of_the_contract() {
    let folder = folder("completes");
    write_deck(&folder, "column.inp", &column(SLIDE));
    let output = slideline(&folder, &["run", "column", "--out", "results/new"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let results = folder.join("results/new");
    let expected = [
        "column.contact.csv",
        "column.dat",
        "column.energy.csv",
        "column.history.csv",
        "column.html",
        "column.json",
        "column.msg",
        "column.pair.csv",
        "column.pvd",
        "column.sta",
        "column_0000.vtu",
        "column_0001.vtu",
        "column_0002.vtu",
        "column_0003.vtu",
        "column_0004.vtu",
        "column_0005.vtu",
    ];
    assert_eq!(names(&results), expected);
    let plain = stdout(&output);
    assert_eq!(plain.lines().count(), 2 + 5 + 2, "{plain}");
    assert!(plain.contains("\nverdict: "), "{plain}");
    assert!(plain.lines().last().unwrap().contains("completed after 5 increments"), "{plain}");
    assert!(!plain.contains('\x1b'), "a pipe gets plain lines");

    let sta = read(&results, "column.sta");
    let columns = sta.lines().next().unwrap().split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(
        columns,
        "STEP INC ATT SEVERE-DISCON-ITERS EQUIL-ITERS TOTAL-ITERS TOTAL-TIME STEP-TIME INC-TIME"
    );
    assert_eq!(sta.lines().count(), 6);
    assert!(sta.lines().skip(1).all(|line| line.split_whitespace().count() == 9));

    let header = |name: &str| read(&results, name).lines().next().unwrap().to_owned();
    assert_eq!(header("column.history.csv"), "step,increment,time,node,U1,U2,UR3,RF1,RF2,RM3");
    assert_eq!(
        header("column.contact.csv"),
        "step,increment,time,pair,node,status,COPEN,CPRESS,CSHEAR1,CSLIP1,friction,x,y,normal_x,\
         normal_y,area"
    );
    assert_eq!(
        header("column.energy.csv"),
        "step,increment,time,external_work,strain_energy,contact_energy,friction_dissipation,\
         friction_elastic,dropped_friction,balance,released_energy"
    );
    assert_eq!(read(&results, "column.history.csv").lines().count(), 1 + 5);
    let summary = summary(&results, "column");
    assert_eq!(summary["status"], "completed");
    assert_eq!(summary["increments"], 5);
    assert_eq!(summary["friction_onset"], "immediate");
    assert_eq!(summary["dialect"], "abaqus");
    assert_eq!(summary["peaks"]["9.U2"]["max"], 1.2e-4);
    assert_eq!(summary["peaks"]["9.U2"]["time_max"], 1.0);
}

/// Requirement: signs of the contract (RF is the force of the support on the
/// model) and Coulomb's law in full sliding (200 um an increment against an
/// elastic slip of 50 um).
#[test]
fn columns_of_the_histories_have_the_signs_of_the_contract() {
    let folder = folder("signs");
    write_deck(&folder, "column.inp", &column(SLIDE));
    assert_eq!(code(&slideline(&folder, &["run", "column", "-q"])), 0);
    let history = read(&folder, "column.history.csv");
    let last: Vec<f64> =
        history.lines().last().unwrap().split(',').map(|cell| cell.parse().unwrap()).collect();
    let (push, drag) = (last[8], last[7]);
    assert!(push > 0.0 && drag > 0.0, "the support pushes up and drags along: {history}");
    // The tips are held, so that the driver feels friction alone: exactly
    // Coulomb's law, to the rounding of the equilibrium.
    assert!((drag / push - 0.3).abs() < 1e-9, "{drag} / {push}");
    let contact = read(&folder, "column.contact.csv");
    let row: Vec<&str> = contact.lines().last().unwrap().split(',').collect();
    assert_eq!((row[3], row[4], row[5], row[10]), ("TIPS", "4", "slip", "called"));
    let (shear, pressure): (f64, f64) = (row[8].parse().unwrap(), row[7].parse().unwrap());
    assert!((shear.abs() / pressure - 0.3).abs() < 1e-9, "tau = mu p while sliding: {row:?}");
    let dat = read(&folder, "column.dat");
    assert!(dat.contains("exponential as Abaqus has it") && dat.contains("EA = 100000"), "{dat}");
    assert_eq!(dat.matches("NODES PLANE").count(), 5, "a table per increment: {dat}");
}

#[test]
fn a_run_removes_what_an_earlier_one_left_and_nothing_else() {
    let folder = folder("removes");
    write_deck(&folder, "column.inp", &column(SLIDE));
    for name in ["column_0099.vtu", "column.html", "column.rst", "column.json.part"] {
        write_deck(&folder, name, "old");
    }
    for name in ["column2.sta", "column.txt", "column_1.vtu"] {
        write_deck(&folder, name, "not ours");
    }
    assert_eq!(code(&slideline(&folder, &["run", "column.inp"])), 0);
    let names = names(&folder);
    assert_ne!(read(&folder, "column.html"), "old");
    for old in ["column_0099.vtu", "column.rst", "column.json.part"] {
        assert!(!names.contains(&old.to_owned()), "{old} is still there");
    }
    for other in ["column2.sta", "column.txt", "column_1.vtu", "column.inp"] {
        assert!(names.contains(&other.to_owned()), "{other} is gone");
    }
}

#[test]
fn a_bad_deck_ends_with_1_and_says_where_and_why() {
    let folder = folder("bad");
    write_deck(&folder, "column.inp", &column(SLIDE).replace("*FRICTION", "*FRICTON"));
    write_deck(&folder, "column.sta", "old");
    let output = slideline(&folder, &["run", "column"]);
    assert_eq!(code(&output), 1);
    let said = stderr(&output);
    assert!(said.contains("error[SL02") && said.contains("column.inp:24:"), "{said}");
    assert!(said.contains("FRICTION") && said.contains("*FRICTON"), "{said}");
    assert_eq!(stdout(&output), "column: input error, nothing was solved\n");
    assert_eq!(names(&folder), ["column.inp", "column.json"]);
    let summary = summary(&folder, "column");
    assert_eq!(summary["status"], "input_error");
    assert_eq!(summary["errors"][0]["line"], 24);
    assert_eq!(summary["errors"][0]["card"], "*FRICTON");
}

#[test]
fn nothing_is_written_where_there_is_no_deck() {
    let folder = folder("nodeck");
    std::fs::create_dir(folder.join("dir.inp")).unwrap();
    write_deck(&folder, "empty.inp", "");
    write_deck(&folder, "blank.inp", " \n\n");
    for (job, words) in [
        ("missing", "missing.inp cannot be read"),
        (".", "it is a folder"),
        ("dir", "it is a folder"),
        ("dir.inp", "it is a folder"),
        ("empty", "error[SL01"),
        ("blank.inp", "error[SL01"),
    ] {
        for command in ["run", "check"] {
            let output = slideline(&folder, &[command, job]);
            assert_eq!(code(&output), 1, "{command} {job}");
            assert!(stderr(&output).contains(words), "{job}: {}", stderr(&output));
            let said = [&output.stdout[..], &output.stderr].concat();
            let said = String::from_utf8(said).unwrap();
            assert!(!said.lines().any(|line| line.starts_with(": ")), "{job}: {said}");
        }
    }
    assert_eq!(names(&folder), ["blank.inp", "dir.inp", "empty.inp"]);
}

#[test]
fn a_folder_that_cannot_be_made_ends_with_4() {
    let folder = folder("unwritable");
    write_deck(&folder, "column.inp", &column(SLIDE));
    let output = slideline(&folder, &["run", "column", "--out", "column.inp/results"]);
    assert_eq!(code(&output), 4);
    assert!(stderr(&output).contains("error[SL0702]"), "{}", stderr(&output));
    assert_eq!(names(&folder), ["column.inp"]);
}

/// A limit on the size of files stands for a full disk: the histories grow
/// past it, the small files do not.
#[cfg(unix)]
#[test]
fn a_full_disk_ends_with_4_and_keeps_whole_lines() {
    let folder = folder("full");
    write_deck(
        &folder,
        "column.inp",
        &column(&SLIDE.replace("0.2, 1.0, 1.0E-6, 0.2", "0.01, 1.0, 1.0E-6, 0.01")),
    );
    let script = format!("trap '' XFSZ; ulimit -f 24; exec {PROGRAM} run column");
    let output = Command::new("sh").arg("-c").arg(script).current_dir(&folder).output().unwrap();
    assert_eq!(code(&output), 4, "{}", stderr(&output));
    let said = stderr(&output);
    assert!(said.contains("error[SL0702]") && said.contains("column.msg"), "{said}");
    assert!(said.contains("column.history.csv"), "what was written is said: {said}");
    assert_eq!(summary(&folder, "column")["status"], "output_error");
    for name in ["column.msg", "column.sta", "column.history.csv"] {
        assert!(read(&folder, name).ends_with('\n'), "{name} ends with a whole line");
    }
    assert!(!names(&folder).iter().any(|name| name.ends_with(".part")));
}

#[test]
fn a_deck_that_includes_a_result_of_its_own_job_is_refused() {
    let folder = folder("collision");
    write_deck(&folder, "column.dat", &column(""));
    write_deck(&folder, "column.inp", &format!("*INCLUDE, INPUT=column.dat\n{SLIDE}"));
    let output = slideline(&folder, &["run", "column"]);
    assert_eq!(code(&output), 1);
    assert!(stderr(&output).contains("error[SL0703]"), "{}", stderr(&output));
    assert_eq!(read(&folder, "column.dat"), column(""), "the included file is untouched");
    assert_eq!(code(&slideline(&folder, &["run", "column", "--out", "elsewhere"])), 0);
}

#[test]
fn too_few_increments_end_with_2_and_keep_what_converged() {
    let folder = folder("notconverged");
    write_deck(&folder, "column.inp", &column(&SLIDE.replace("INC=100", "INC=3")));
    let output = slideline(&folder, &["run", "column"]);
    assert_eq!(code(&output), 2);
    assert!(stderr(&output).contains("error[SL05"), "{}", stderr(&output));
    assert!(stdout(&output).contains("not converged after 3 increments"), "{}", stdout(&output));
    let summary = summary(&folder, "column");
    assert_eq!(summary["status"], "not_converged");
    assert_eq!(summary["increments"], 3);
    assert!(summary["diagnosis"]["code"].as_str().unwrap().starts_with("SL05"));
    assert_eq!(read(&folder, "column.history.csv").lines().count(), 1 + 3);
    assert!(read(&folder, "column.msg").contains("what to do"));
}

#[test]
fn json_progress_is_one_object_a_line() {
    let folder = folder("json");
    write_deck(&folder, "column.inp", &column(SLIDE));
    let output = slideline(&folder, &["run", "column", "--json"]);
    assert_eq!(code(&output), 0);
    let events: Vec<Value> =
        stdout(&output).lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let kinds: Vec<&str> = events.iter().map(|event| event["event"].as_str().unwrap()).collect();
    assert_eq!((kinds[0], kinds[kinds.len() - 1]), ("start", "end"));
    assert_eq!(kinds.iter().filter(|kind| **kind == "increment").count(), 5);
    assert!(kinds.contains(&"iteration"));
    assert_eq!(events[events.len() - 1]["exit_code"], 0);
    assert!(events.iter().any(|event| event["values"]["9.U2"] == 1.2e-4));

    write_deck(&folder, "bad.inp", "*NODE\n1, x\n");
    let output = slideline(&folder, &["run", "bad", "--json"]);
    assert_eq!(code(&output), 1);
    let events: Vec<Value> =
        stdout(&output).lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(events[events.len() - 1]["status"], "input_error");
    let said = events.iter().find(|event| event["event"] == "diagnosis").unwrap();
    for key in ["code", "severity", "message", "file", "line", "columns", "card"] {
        assert!(said.get(key).is_some(), "{key} in {said}");
    }
}

/// Members of each kind of event.
const MEMBERS: &[(&str, &str)] = &[
    ("start", "job deck deck_hash program_version dialect friction_onset steps"),
    (
        "iteration",
        "step increment attempt iteration severe equilibrium contact_changes closed force moment \
         converged",
    ),
    (
        "increment",
        "step increment attempt severe_iterations equilibrium_iterations total_time step_time \
         time_increment closed friction_dropped values",
    ),
    (
        "attempt_failed",
        "step increment attempt severe_iterations equilibrium_iterations total_time step_time \
         time_increment reason next_time_increment",
    ),
    ("tangent", "step increment equations off entry assembled difference"),
    ("diagnosis", "code severity message file line columns card"),
    ("end", "status exit_code increments cutbacks iterations wall_seconds folder"),
];

/// Requirement: every line of `--json` is one object, in the order of the run,
/// with the members that a reader needs to follow it. Source: the contract's
/// list of events; docs of the members: crates/cli/src/progress.rs.
#[test]
fn every_json_event_has_its_members() {
    let folder = folder("json-members");
    // too few increments for the step: the run ends with a diagnosis
    write_deck(&folder, "column.inp", &column(&SLIDE.replace("INC=100", "INC=3")));
    let output = slideline(&folder, &["run", "column", "--json", "--check-tangent"]);
    let text = stdout(&output);
    assert!(text.ends_with('\n') && !text.contains('\u{1b}'));
    let events: Vec<Value> = text.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    for event in &events {
        let kind = event["event"].as_str().unwrap();
        let (_, expected) = MEMBERS.iter().find(|(known, _)| *known == kind).unwrap();
        for member in expected.split_whitespace() {
            assert!(event.get(member).is_some(), "{member} in {event}");
        }
    }
    for kind in ["start", "iteration", "increment", "diagnosis", "end"] {
        assert!(events.iter().any(|event| event["event"] == kind), "{kind}: {text}");
    }
    let force = &events.iter().find(|event| event["event"] == "iteration").unwrap()["force"];
    for member in ["residual", "average", "allowed", "correction"] {
        assert!(force[member].is_number(), "{member} in {force}");
    }
    assert_eq!(events[events.len() - 1]["exit_code"], code(&output));
}

/// Requirement: a pipe gets plain lines, one an increment under one heading a
/// step, without anything that moves a cursor. The numbers are those of the
/// history.
#[test]
fn a_pipe_gets_plain_lines() {
    let folder = folder("plain-lines");
    write_deck(&folder, "column.inp", &column(SLIDE));
    let output = slideline(&folder, &["run", "column"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let text = stdout(&output);
    assert!(text.chars().all(|c| c == '\n' || !c.is_control()), "{text:?}");
    let words = |line: &str| line.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    let heading = text.lines().position(|line| line.trim_start().starts_with("STEP ")).unwrap();
    let names = words(text.lines().nth(heading).unwrap());
    assert_eq!(names[..7], ["STEP", "INC", "ATT", "SDI", "EQU", "TIME", "CLOSED"]);
    let rows: Vec<Vec<String>> = text.lines().skip(heading + 1).take(5).map(words).collect();
    let motion = names.iter().position(|name| name == "9.U2").unwrap();
    let history = read(&folder, "column.history.csv");
    let mut history = history.lines().skip(1).filter(|row| row.split(',').nth(3) == Some("9"));
    for (place, row) in rows.iter().enumerate() {
        assert_eq!(row.len(), names.len(), "{row:?}");
        assert_eq!(row[..2], ["1".to_owned(), (place + 1).to_string()]);
        let cells: Vec<&str> = history.next().unwrap().split(',').collect();
        for (shown, written) in [(&row[motion], cells[5]), (&row[motion + 1], cells[8])] {
            let (shown, written): (f64, f64) = (shown.parse().unwrap(), written.parse().unwrap());
            assert!((shown - written).abs() <= 1e-6 * written.abs(), "{row:?}: {cells:?}");
        }
    }
    assert!(text.lines().last().unwrap().starts_with("column: completed after 5 increments"));
}

#[test]
fn quiet_silences_progress_only() {
    let folder = folder("quiet");
    write_deck(&folder, "column.inp", &column(SLIDE));
    let output = slideline(&folder, &["run", "column", "--quiet", "--no-html"]);
    assert_eq!((code(&output), stdout(&output)), (0, ""));
    let output = slideline(&folder, &["run", "column", "--quiet", "--friction-onset", "matfru"]);
    assert_eq!((code(&output), stdout(&output)), (0, ""));
    let said = stderr(&output);
    assert!(
        said.contains("warning[SL0601]") && said.contains("FRICTION ONSET=IMMEDIATE"),
        "{said}"
    );
    let summary = summary(&folder, "column");
    assert_eq!(summary["friction_onset"], "matfru");
    let warnings = summary["warnings"].as_array().unwrap();
    assert!(warnings.iter().any(|said| said["code"] == "SL0601"), "{warnings:?}");
    assert_eq!(summary["verdict"]["colour"], "amber");
    assert!(summary["dropped_friction"]["point_increments"].as_u64().unwrap() > 0);
    assert!(summary["dropped_friction"]["work"].as_f64().unwrap() > 0.0);
    assert!(read(&folder, "column.contact.csv").contains(",dropped,"));
}

#[test]
fn check_explains_the_model_without_solving_it() {
    let folder = folder("check");
    write_deck(&folder, "column.inp", &column(SLIDE));
    let output = slideline(&folder, &["check", "column"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let said = stdout(&output);
    for part in [
        "slave    2 nodes (2, 4)",
        "master   analytic rigid surface",
        "node 9",
        "initial gaps",
        "why",
    ] {
        assert!(said.contains(part), "{part} in {said}");
    }
    assert_eq!(names(&folder), ["column.inp"], "check writes nothing");

    let output = slideline(&folder, &["check", "column", "--json"]);
    let lines: Vec<Value> =
        stdout(&output).lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    for line in &lines {
        for key in ["code", "severity", "message", "file", "line", "columns", "card"] {
            assert!(line.get(key).is_some(), "{key} in {line}");
        }
    }
    let pair = &lines.iter().find(|line| line.get("pair").is_some()).unwrap()["pair"];
    assert_eq!(pair["slave_nodes"], serde_json::json!([2, 4]));
    let gap = pair["initial_gaps"][0]["gap"].as_f64().unwrap();
    assert!((gap - 1e-4).abs() < 1e-15, "the plane stands 1e-4 below: {gap}");

    write_deck(&folder, "bad.inp", "*NODE\n1, x\n");
    assert_eq!(code(&slideline(&folder, &["check", "bad"])), 1);
    assert_eq!(code(&slideline(&folder, &["check", "bad", "--json"])), 1);
}

#[test]
fn a_wrong_command_line_ends_with_64() {
    let folder = folder("usage");
    for arguments in [
        &[][..],
        &["fly"],
        &["run"],
        &["run", "a", "--no-such-option"],
        &["run", "a", "--threads", "0"],
        &["run", "a", "--friction-onset", "never"],
        &["completions", "fish-and-chips"],
    ] {
        let output = slideline(&folder, arguments);
        assert_eq!(code(&output), 64, "{arguments:?}: {}", stderr(&output));
        assert!(output.stdout.is_empty() && !output.stderr.is_empty(), "{arguments:?}");
    }
    for arguments in [&["--help"][..], &["--version"], &["run", "--help"]] {
        let output = slideline(&folder, arguments);
        assert_eq!(code(&output), 0, "{arguments:?}");
        assert!(!output.stdout.is_empty());
    }
}

#[test]
fn explain_knows_codes_and_keywords_and_helps_with_slips() {
    let folder = folder("explain");
    let page = slideline(&folder, &["explain", "sl0601"]);
    assert_eq!(code(&page), 0);
    assert!(stdout(&page).starts_with("# SL0601"));
    let keyword = slideline(&folder, &["explain", "slide", "line"]);
    assert_eq!(code(&keyword), 0);
    assert_eq!(stdout(&keyword), stdout(&slideline(&folder, &["explain", "*SLIDE LINE"])));
    let slip = slideline(&folder, &["explain", "FRICTON"]);
    assert_eq!(code(&slip), 1);
    assert_eq!(stderr(&slip), "error: there is no page on FRICTON; did you mean FRICTION?\n");
    let stranger = slideline(&folder, &["explain", "zzzzzzzzzz"]);
    assert_eq!(code(&stranger), 1);
    assert_eq!(stderr(&stranger), "error: there is no page on zzzzzzzzzz\n");
}

#[test]
fn completions_are_printed_for_every_shell() {
    let folder = folder("completions");
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let output = slideline(&folder, &["completions", shell]);
        assert_eq!(code(&output), 0);
        assert!(stdout(&output).contains("slideline"), "{shell}");
    }
}

/// `slideline run job | head`: the reader leaves, the run goes on.
#[cfg(unix)]
#[test]
fn a_reader_that_leaves_does_not_stop_a_run() {
    let folder = folder("pipe");
    write_deck(&folder, "column.inp", &column(SLIDE));
    let script = format!("{{ {PROGRAM} run column; echo $? > code; }} | true");
    let output = Command::new("sh").arg("-c").arg(script).current_dir(&folder).output().unwrap();
    assert!(output.status.success());
    assert_eq!(read(&folder, "code").trim(), "0");
    assert_eq!(summary(&folder, "column")["status"], "completed");
}

/// Ten million increments: nobody waits for the end.
fn endless(folder: &Path) -> std::process::Child {
    let step = SLIDE
        .replace("INC=100", "INC=10000000")
        .replace("0.2, 1.0, 1.0E-6, 0.2", "1.0E-7, 1.0, 1.0E-8, 1.0E-7")
        .replace("*NODE PRINT, NSET=PLANE\nU, RF\n", "");
    write_deck(folder, "column.inp", &column(&step));
    Command::new(PROGRAM)
        .args(["run", "column"])
        .current_dir(folder)
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

fn wait_for_increments(folder: &Path) {
    let began = Instant::now();
    while began.elapsed() < Duration::from_secs(60) {
        let sta = std::fs::read_to_string(folder.join("column.sta")).unwrap_or_default();
        if sta.lines().count() > 5 {
            return;
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    panic!("no increment within a minute");
}

#[cfg(unix)]
#[test]
fn an_interrupt_finishes_the_increment_and_says_how_to_go_on() {
    let folder = folder("interrupt");
    let child = endless(&folder);
    wait_for_increments(&folder);
    let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
    let output = child.wait_with_output().unwrap();
    assert_eq!(code(&output), 130, "{}", stderr(&output));
    let said = stderr(&output);
    assert!(said.contains("finishing the increment") && said.contains("slideline run"), "{said}");
    let summary = summary(&folder, "column");
    assert_eq!(summary["status"], "interrupted");
    let increments = summary["increments"].as_u64().unwrap() as usize;
    assert_eq!(read(&folder, "column.history.csv").lines().count(), 1 + increments);
    assert_eq!(read(&folder, "column.pvd").matches("<DataSet").count(), 1 + increments);
}

#[cfg(unix)]
#[test]
fn a_killed_run_leaves_valid_files_and_a_summary_that_says_running() {
    let folder = folder("killed");
    let mut child = endless(&folder);
    wait_for_increments(&folder);
    child.kill().unwrap();
    child.wait().unwrap();
    assert_eq!(summary(&folder, "column")["status"], "running");
    for name in ["column.sta", "column.history.csv", "column.energy.csv", "column.contact.csv"] {
        let text = read(&folder, name);
        let cells = |line: &str| line.split([',', ' ']).filter(|c| !c.is_empty()).count();
        let header = cells(text.lines().next().unwrap());
        assert!(text.ends_with('\n') && text.lines().all(|line| cells(line) == header), "{name}");
    }
    for name in names(&folder).iter().filter(|name| name.ends_with(".vtu")) {
        assert!(read(&folder, name).ends_with("</VTKFile>\n"), "{name} is whole");
    }
}
