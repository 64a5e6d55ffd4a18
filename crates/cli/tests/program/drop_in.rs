//! Started in place of ccx: what PrePoMax and FreeCAD call, read and look for (docs/ccx.md).

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands
#![cfg(unix)] // a link is the program under another name

use crate::replayed::{Results, tables};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const PROGRAM: &str = env!("CARGO_BIN_EXE_slideline");

/// Written as PrePoMax writes: mixed case, two numbers for each reference point, an inert card.
const DECK: &str = include_str!("replayed/pressed.inp");

/// Written as PrePoMax writes: a punch in contact with a block, springs, a gap, an equation, a rigid body
/// with a node of its turning, two steps.
const CONTACT: &str = include_str!("replayed/contact.inp");

/// Written as FreeCAD writes: a cantilever of beams, 1000 long, 10 wide and 20 high.
const BEAM: &str = include_str!("replayed/beam.inp");

/// An empty folder with the deck and, beside it, a link named as ccx is.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("drop_in").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    std::os::unix::fs::symlink(PROGRAM, folder.join("ccx_2.20_MT")).unwrap();
    std::fs::write(folder.join("pressed.inp"), DECK).unwrap();
    folder
}

fn ccx(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(folder.join("ccx_2.20_MT"));
    command.args(arguments).current_dir(folder).env_remove("OMP_NUM_THREADS").output().unwrap()
}

fn stdout(output: &Output) -> &str {
    std::str::from_utf8(&output.stdout).unwrap()
}

fn text(folder: &Path, name: &str) -> String {
    std::fs::read_to_string(folder.join(name)).unwrap_or_else(|reason| panic!("{name}: {reason}"))
}

/// What both programs ask of a run that succeeded.
fn succeeded(output: &Output) {
    let said = stdout(output);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    assert!(output.stderr.is_empty(), "FreeCAD logs a failure: {output:?}");
    assert!(!said.contains("*ERROR"), "PrePoMax calls it failed: {said}");
    assert!(said.contains("\n Job finished\n"), "{said}");
}

/// Requirement: the probes of FreeCAD. Source: ccx 2.20 for words and codes.
#[test]
fn probes_are_answered_as_by_ccx() {
    let folder = folder("probes");
    let usage = ccx(&folder, &[]);
    assert_eq!(usage.status.code(), Some(201));
    assert!(stdout(&usage).contains("CalculiX"));
    let version = ccx(&folder, &["-v"]);
    assert_eq!(version.status.code(), Some(201));
    assert!(stdout(&version).starts_with("\nThis is Version 2.20\n"));
    assert!(usage.stderr.is_empty() && version.stderr.is_empty());
    let own = Command::new(PROGRAM).args(["ccx", "-v"]).output().unwrap();
    assert_eq!((own.status.code(), &own.stdout), (Some(201), &version.stdout));
}

/// Requirement: every way to name a job gives the same files, beside the deck.
#[test]
fn jobs_are_named_as_callers_do() {
    let plain = folder("plain");
    succeeded(&ccx(&plain, &["pressed"]));
    let freecad = folder("freecad");
    succeeded(&ccx(&freecad, &["-i ", "pressed"]));
    let absolute = folder("absolute");
    succeeded(&ccx(&freecad, &["-i", absolute.join("pressed").to_str().unwrap()]));
    for ending in ["dat", "sta", "cvg"] {
        let name = format!("pressed.{ending}");
        assert_eq!(text(&plain, &name), text(&freecad, &name));
        assert_eq!(text(&plain, &name), text(&absolute, &name));
    }
}

/// Requirement: the files are those that PrePoMax' and FreeCAD's readers accept, and say what the
/// deck's closed form says: a block of 10 x 1 x 1 is pressed between fixed sides and pulled.
#[test]
fn files_are_read_by_the_rules_of_both_programs() {
    let folder = folder("files");
    succeeded(&ccx(&folder, &["-i", "pressed"]));
    let results = Results::read(&text(&folder, "pressed.frd"));
    assert_eq!(results.named("Hash:"), Some("abcdEFG1"));
    assert_eq!(results.named("Unit system:"), Some("MM_TON_S_C"));
    let day = results.heading.iter().find(|line| line.starts_with("    1UDATE")).unwrap();
    assert_eq!(day.split_whitespace().nth(1).unwrap().split('.').count(), 3, "{day}");
    assert!(results.heading.iter().any(|line| line.starts_with("    1UTIME")));
    assert!(results.heading.iter().any(|line| line.trim_end() == "    1UMAT    1SOLID"));
    // the nodes of elements alone, elements by their own numbers
    assert_eq!(results.nodes.len(), 8);
    assert!(results.elements.keys().eq(&[17]));
    assert_eq!(results.elements[&17], (1, (1..=8).collect()));
    let last = results.field("DISP", 4);
    assert_eq!((last.at, last.time), ([4, 1, 4], 1.0));
    assert_eq!(last.components, ["D1", "D2", "D3", "ALL"]);
    // u = 0.01 x on the way to u = 0.1: uniaxial strain, stress of E (1 - nu) / (1 + nu) / (1 - 2 nu)
    assert!((last.rows[&2][0] - 0.1).abs() < 1e-6 && last.rows[&2][1].abs() < 1e-9);
    let stress = &results.field("STRESS", 4).rows[&3];
    assert!((stress[0] / 2826.923 - 1.0).abs() < 1e-3, "{stress:?}");
    let tables = tables(&text(&folder, "pressed.dat"));
    let titles: Vec<&str> = tables.iter().map(|(title, _)| title.as_str()).collect();
    assert_eq!(titles.len(), 4 * 4, "{titles:?}");
    assert_eq!(titles[0], "total force (fx,fy,fz) for set RP and time  0.2500000E+00");
    let (_, rows) = &tables[12];
    assert!((rows[0][0] / 2826.923 - 1.0).abs() < 1e-3, "{tables:?}");
    // the node of the turning: its displacements are the rotation, which is held
    let (title, rows) = &tables[13];
    assert!(title.starts_with("displacements (vx,vy,vz) for set TURN and"), "{title}");
    assert_eq!(rows[0], [10.0, 0.0, 0.0, 0.0]);
}

/// Requirement: .sta and .cvg have the columns of ccx, an increment and an iteration a line.
#[test]
fn progress_files_have_the_columns_of_ccx() {
    let folder = folder("progress");
    succeeded(&ccx(&folder, &["pressed"]));
    let rows = |name: &str, heads: usize| -> Vec<Vec<f64>> {
        let text = text(&folder, name);
        let lines = text.lines().skip(heads).map(str::split_whitespace);
        lines.map(|words| words.map(|word| word.parse().unwrap()).collect()).collect()
    };
    let increments = rows("pressed.sta", 2);
    assert_eq!(increments.len(), 4);
    assert_eq!(increments[3][..3], [1.0, 4.0, 1.0]);
    assert_eq!(increments[3][4..], [1.0, 1.0, 0.25]);
    let iterations = rows("pressed.cvg", 4);
    assert!(iterations.iter().all(|row| row.len() == 9));
    let counted: f64 = increments.iter().map(|row| row[3]).sum();
    assert_eq!(iterations.len(), counted as usize);
    // the last correction of an increment is small against its displacement
    assert!(iterations.last().unwrap()[6] < 1.0, "{iterations:?}");
}

/// Requirement: what fails says *ERROR on standard output, has a code, and leaves no results that
/// could be taken for those of the run.
#[test]
fn failures_are_told_as_callers_expect() {
    let folder = folder("failures");
    succeeded(&ccx(&folder, &["pressed"]));
    std::fs::write(folder.join("pressed.inp"), DECK.replace("*Elastic", "*Elastik")).unwrap();
    let output = ccx(&folder, &["pressed"]);
    assert_eq!(output.status.code(), Some(1));
    let said = stdout(&output);
    assert!(said.contains(" *ERROR in pressed.inp, line 41 (SL0201)"), "{said}");
    assert!(!said.contains("Job finished"));
    assert!(!folder.join("pressed.frd").exists(), "results of the run before");
    let missing = ccx(&folder, &["nothing"]);
    assert_eq!(missing.status.code(), Some(1));
    assert!(stdout(&missing).contains("*ERROR"));
}

/// Requirement: what a killed run left stops nobody: PrePoMax kills the process and deletes some of
/// the files only.
#[test]
fn leftovers_of_a_killed_run_stop_nobody() {
    let folder = folder("leftovers");
    for name in ["pressed.lck", "pressed.history.csv", "pressed.frd.part", "pressed.rst"] {
        std::fs::write(folder.join(name), "left from before").unwrap();
    }
    succeeded(&ccx(&folder, &["pressed"]));
    assert!(!folder.join("pressed.lck").exists() && !folder.join("pressed.frd.part").exists());
    assert!(text(&folder, "pressed.history.csv").starts_with("step,"));
}

/// Requirement: OMP_NUM_THREADS is obeyed, and whatever stands there the results are the same.
#[test]
fn results_do_not_depend_on_the_threads_of_the_environment() {
    let folder = folder("threads");
    succeeded(&ccx(&folder, &["pressed"]));
    let one = text(&folder, "pressed.dat");
    for threads in ["2", "none", "2,4"] {
        let mut command = Command::new(folder.join("ccx_2.20_MT"));
        let command = command.arg("pressed").current_dir(&folder).env("OMP_NUM_THREADS", threads);
        succeeded(&command.output().unwrap());
        assert_eq!(one, text(&folder, "pressed.dat"), "{threads}");
    }
}

/// Requirement: a job that asks for no states leaves its mesh in .frd, as ccx does; .dat is there
/// without tables, too: FreeCAD looks for it.
#[test]
fn frd_and_dat_are_always_there() {
    let folder = folder("always");
    let deck = DECK.replace("*Output, Frequency=1\n", "");
    let (before, after) = deck.split_once("*Node print").unwrap();
    let (_, end) = after.split_once("*End step").unwrap();
    std::fs::write(folder.join("pressed.inp"), format!("{before}*End step{end}")).unwrap();
    succeeded(&ccx(&folder, &["pressed"]));
    let results = Results::read(&text(&folder, "pressed.frd"));
    assert!(results.fields.is_empty() && results.elements.len() == 1);
    assert_eq!(text(&folder, "pressed.dat"), "");
}

/// Requirement: every law of contact that PrePoMax writes runs, in two steps, with all that it asks for,
/// and is read. Source: the punch is pulled over the block in the second step, so that the foot feels
/// friction of a tenth of the pressure; the springs add less than 0.3 %.
#[test]
fn every_law_of_prepomax_is_run_and_read() {
    let folder = folder("laws");
    let laws = [
        ("Hard", 0.1),
        ("Linear\n100000, 0.5", 0.1),
        ("Linear\n100000, 0.5, 0.001", 0.1),
        ("Exponential\n0.001, 10", 0.1),
        ("Tabular\n0, -0.001\n100, 0\n1000, 0.001", 0.1),
        ("Tied\n1E+07", f64::NAN),
    ];
    for (law, friction) in laws {
        let deck =
            CONTACT.replace("Pressure-overclosure=Hard", &format!("Pressure-overclosure={law}"));
        std::fs::write(folder.join("punch.inp"), deck).unwrap();
        let output = ccx(&folder, &["punch"]);
        succeeded(&output);
        assert!(!stdout(&output).contains("SL0348"), "what touches is tied: {output:?}");
        let results = Results::read(&text(&folder, "punch.frd"));
        assert!(results.fields.iter().any(|own| own.at[1] == 2 && own.name == "STRESS"), "{law}");
        let tables = tables(&text(&folder, "punch.dat"));
        let foot =
            tables.iter().rfind(|own| own.0.starts_with("total force (fx,fy,fz) for set FOOT"));
        let force = &foot.unwrap().1[0];
        assert!(force[2] > 1000.0, "{law}: {force:?}");
        let ratio = -force[0] / force[2];
        assert!(friction.is_nan() || (ratio / friction - 1.0).abs() < 0.01, "{law}: {ratio}");
    }
}

/// Requirement: FreeCAD's deck of beams is read whatever `OUTPUT=` says. Source: equilibrium, and F l^3 /
/// (3 E I) for the tip; two elements follow it within 2 %.
#[test]
fn beams_of_freecad_are_run_and_read() {
    let folder = folder("beams");
    for output in ["2d", "3d"] {
        let deck = BEAM.replace("OUTPUT=2d", &format!("OUTPUT={output}"));
        std::fs::write(folder.join("beam.inp"), deck).unwrap();
        succeeded(&ccx(&folder, &["-i ", "beam"]));
        let results = Results::read(&text(&folder, "beam.frd"));
        let tip = results.field("DISP", 1).rows[&3][2];
        let exact = -100.0 * 1000f64.powi(3) / (3.0 * 210_000.0 * 10.0 * 20f64.powi(3) / 12.0);
        assert!((tip / exact - 1.0).abs() < 0.02, "{tip} {exact}");
        let tables = tables(&text(&folder, "beam.dat"));
        assert!((tables[0].1[0][2] - 100.0).abs() < 1e-6, "{tables:?}");
    }
}
