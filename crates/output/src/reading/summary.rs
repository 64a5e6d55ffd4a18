//! `JOB.json` read back.

use super::problem::{self, Problem, unreadable};
use crate::job::JobFiles;
use crate::json::{Members as _, Value};
use crate::lock::is_running;

/// Version of the layout of `JOB.json`.
pub const SCHEMA: usize = 1;

/// A prescribed motion that moves.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Driven {
    /// What is driven, a node or a set of nodes, as it is called.
    pub name: String,
    /// Its nodes; the reaction is the sum of theirs.
    pub nodes: Vec<u64>,
    /// Column of its motion.
    pub motion: String,
    /// Column of its reaction.
    pub reaction: String,
    /// Directions of both, a node each, where nodes have axes of their own; empty: the columns tell [1].
    pub along: Vec<[f64; 3]>,
}

impl Driven {
    /// `node 7`, or `nodes END`.
    pub fn words(&self) -> String {
        format!("{} {}", if self.nodes.len() == 1 { "node" } else { "nodes" }, self.name)
    }
}

/// What the summary says is driven.
pub(crate) fn driven(summary: &Value) -> Vec<Driven> {
    let driven = summary.list("driven").iter().filter_map(|driven| {
        let node = driven.count("node")? as u64;
        let nodes: Vec<u64> = driven.list("nodes").iter().filter_map(Value::as_u64).collect();
        Some(Driven {
            name: driven.text("name").map_or_else(|| node.to_string(), str::to_owned),
            // earlier versions had one node a motion
            nodes: if nodes.is_empty() { vec![node] } else { nodes },
            motion: driven.text("motion")?.to_owned(),
            reaction: driven.text("reaction")?.to_owned(),
            along: driven.list("along").iter().map(direction).collect(),
        })
    });
    driven.collect()
}

/// Three numbers; what is none counts as zero.
fn direction(value: &Value) -> [f64; 3] {
    std::array::from_fn(|axis| value.get(axis).and_then(Value::as_f64).unwrap_or(0.0))
}

/// What the summary says is loaded: the first node, what all of them are called, the column of its
/// motion.
pub(crate) fn loaded(summary: &Value) -> Vec<(u64, String, String)> {
    let loads = summary.list("loaded").iter().filter_map(|load| {
        let node = load.count("node")? as u64;
        let name = load.text("name").map_or_else(|| node.to_string(), str::to_owned);
        Some((node, name, load.text("motion")?.to_owned()))
    });
    loads.collect()
}

/// Reads `JOB.json` as it is.
pub(crate) fn raw(job: &JobFiles) -> Result<Value, Problem> {
    let path = job.path(".json");
    let text = problem::bytes(&path)?;
    serde_json::from_slice(&text).map_err(|reason| unreadable(&path, reason.to_string()))
}

/// Reads `JOB.json` and refuses what is no finished job.
pub(crate) fn read(job: &JobFiles, unfinished: bool) -> Result<Value, Problem> {
    let (path, summary) = (job.path(".json"), raw(job)?);
    let (Some(schema), Some(status)) = (summary.count("schema"), summary.text("status")) else {
        return Err(unreadable(&path, "it is not a summary written by this program"));
    };
    if schema > SCHEMA {
        let reason = format!("its layout {schema} is newer than this program's {SCHEMA}");
        return Err(unreadable(&path, reason));
    }
    match status {
        "running" if !unfinished && is_running(job) => Err(Problem::Running(path)),
        "running" if !unfinished => Err(Problem::Killed(path)),
        "input_error" => Err(Problem::NothingSolved(path)),
        _ => Ok(summary),
    }
}

/// Whether the job's own summary says that it is complete.
pub fn is_completed(job: &JobFiles) -> bool {
    raw(job).is_ok_and(|summary| summary.text("status") == Some("completed"))
}
