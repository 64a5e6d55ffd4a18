//! Where a run gives up it leaves the state of its last attempt, to be looked
//! at.
//!
//! Requirement: `JOB.failed.vtu` holds that state with the forces that nothing
//! balances as point data, the message names the file, and what converged
//! before is untouched. Its parts are read here by a few lines of their own;
//! the readers that people have open it in `.ci/readers`.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::Dof;
use slideline::observe::{Event, Observer, Stop};
use slideline::{Job, Quiet, ReadOptions, RunOptions, Status, run};
use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

fn deck(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../corpus/bad").join(name)
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    folder
}

/// The largest residual of the last iteration, and the one that the event
/// shows at each node.
#[derive(Default)]
struct Last {
    reported: f64,
    shown: Vec<[f64; 2]>,
    time: f64,
}

impl Observer for Last {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::Iteration(report) if self.shown.is_empty() => {
                self.reported = report.force.residual;
            }
            Event::Unconverged(state) => {
                let nodes = 0..state.frame.model.nodes.len();
                let at = |node| [Dof::U1, Dof::U2].map(|dof| state.residual(node, dof));
                self.shown = nodes.map(at).collect();
                self.time = state.frame.total_time;
            }
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

/// Arrays of 64-bit numbers of a state, by name.
fn arrays(text: &str) -> BTreeMap<String, Vec<f64>> {
    let mut found = BTreeMap::new();
    for part in text.split("<DataArray ").skip(1) {
        let (head, rest) = part.split_once('>').unwrap();
        if !head.contains("type=\"Float64\"") {
            continue;
        }
        let name = head.split("Name=\"").nth(1).unwrap().split('"').next().unwrap();
        let data = base64(rest.split('<').next().unwrap());
        let values = data[4..].chunks_exact(8).map(|b| f64::from_le_bytes(b.try_into().unwrap()));
        found.insert(name.to_owned(), values.collect());
    }
    found
}

fn base64(text: &str) -> Vec<u8> {
    let value = |c: u8| match c {
        b'A'..=b'Z' => c - b'A',
        b'a'..=b'z' => c - b'a' + 26,
        b'0'..=b'9' => c - b'0' + 52,
        b'+' => 62,
        b'/' => 63,
        other => panic!("{other}"),
    };
    let mut bytes = Vec::new();
    for group in text.trim().as_bytes().chunks(4) {
        let known: Vec<u8> = group.iter().filter(|&&c| c != b'=').map(|&c| value(c)).collect();
        let bits = known.iter().fold(0_u32, |sum, &v| sum << 6 | u32::from(v));
        let bits = bits << (6 * (4 - known.len()));
        bytes.extend(&bits.to_be_bytes()[1..known.len()]);
    }
    bytes
}

#[test]
fn the_last_attempt_is_written_with_its_residual() {
    let read = Job::read(&deck("SL0511-toggle.inp"), &ReadOptions::default());
    let folder = folder("failed_toggle");
    let options = RunOptions { folder: Some(folder.clone()), ..RunOptions::default() };
    let mut last = Last::default();
    let outcome = run(&read, &options, &mut last);
    assert_eq!(outcome.status, Status::NotConverged);
    let path = outcome.files.failed_state();
    let note = outcome.diagnostics.iter().find(|said| said.code.0 == "SL0592").unwrap();
    assert!(note.message.contains(&path.display().to_string()), "{}", note.message);

    let shown = arrays(&std::fs::read_to_string(&path).unwrap());
    let residual = &shown["residual_force"];
    // the same doubles as the observer saw, three components a point
    for (node, own) in last.shown.iter().enumerate() {
        assert_eq!(&residual[3 * node..3 * node + 2], own, "node {node}");
    }
    // what the iterations judged: the largest nodal force, up to rounding
    let largest = residual.chunks(3).map(|f| f[0].hypot(f[1])).fold(0.0, f64::max);
    assert!((largest / last.reported - 1.0).abs() < 1e-9, "{largest} {}", last.reported);
    assert!(largest > 0.0 && shown.contains_key("contact_pressure"));

    // states and list end with the last converged increment
    let energy = std::fs::read_to_string(outcome.files.path(".energy.csv")).unwrap();
    let increments = energy.lines().count() - 1;
    assert_eq!(increments, outcome.totals.increments);
    let list = std::fs::read_to_string(outcome.files.path(".pvd")).unwrap();
    assert_eq!(list.matches("<DataSet").count(), increments + 1);
    assert!(!list.contains("failed") && !folder.join("SL0511-toggle_9999.vtu").exists());
    let message = std::fs::read_to_string(outcome.files.path(".msg")).unwrap();
    assert!(message.contains("SL0592") && message.contains(".failed.vtu"));
    let reached = energy.lines().last().unwrap().split(',').nth(2).unwrap().parse::<f64>().unwrap();
    assert!(last.time > reached, "{} {reached}", last.time);
}

/// Result files of converged increments do not depend on the attempt that
/// follows: a run that fails leaves what a run that was stopped there leaves.
#[test]
fn what_converged_stays_as_it_is() {
    struct StopAt(usize);
    impl Observer for StopAt {
        fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
            match event {
                Event::Committed(frame) if frame.increment == self.0 => {
                    ControlFlow::Break(Stop::Interrupted)
                }
                _ => ControlFlow::Continue(()),
            }
        }
    }
    let read = Job::read(&deck("SL0514-bar-on-floor.inp"), &ReadOptions::default());
    let options = |name| RunOptions { folder: Some(folder(name)), ..RunOptions::default() };
    let failed = run(&read, &options("failed_bar"), &mut Quiet);
    let stopped = run(&read, &options("stopped_bar"), &mut StopAt(failed.totals.increments));
    assert_eq!((failed.status, stopped.status), (Status::NotConverged, Status::Interrupted));
    for ending in [".history.csv", ".contact.csv", ".energy.csv", "_0001.vtu", "_0008.vtu"] {
        let bytes =
            |files: &slideline::output::JobFiles| std::fs::read(files.path(ending)).unwrap();
        assert!(bytes(&failed.files) == bytes(&stopped.files), "{ending}");
    }
    assert!(failed.files.failed_state().exists() && !stopped.files.failed_state().exists());
    // the next run of the job takes it away
    let again = run(&read, &options("failed_bar"), &mut StopAt(1));
    assert!(!again.files.failed_state().exists());
}
