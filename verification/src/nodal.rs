//! Stresses at nodes, read from the file that viewers read.

use slideline::{Job, Quiet, ReadOptions, RunOptions, Status};
use std::path::Path;

/// Stress 11, 22, 33, 12, 23, 13 [F/L2] at a node in the last state of `JOB.frd`; the deck asks for
/// it by `*EL FILE`. The files of the run are left in `folder`.
///
/// # Errors
/// Where the run does not come to its end, or its file has no such node.
pub fn nodal_stress(folder: &Path, deck: &str, label: u64) -> Result<[f64; 6], String> {
    let read = Job::read_text("claim", deck, &ReadOptions::default());
    let options = RunOptions { folder: Some(folder.to_owned()), ..RunOptions::default() };
    let outcome = slideline::run(&read, &options, &mut Quiet);
    if outcome.status != Status::Completed {
        return Err(format!("{:?} {:?}", outcome.status, outcome.diagnostics));
    }
    let text =
        std::fs::read_to_string(folder.join("claim.frd")).map_err(|reason| reason.to_string())?;
    let block = text.rsplit(" -4  STRESS").next().unwrap_or_default();
    let row = block.lines().find(|line| {
        line.starts_with(" -1")
            && line.get(3..13).and_then(|own| own.trim().parse().ok()) == Some(label)
    });
    let row = row.ok_or_else(|| format!("no stress at the node {label}"))?;
    let mut stress = [f64::NAN; 6];
    for (k, value) in stress.iter_mut().enumerate() {
        let cell = row.get(13 + 12 * k..25 + 12 * k).unwrap_or_default();
        *value = cell.trim().parse().map_err(|reason| format!("{cell}: {reason}"))?;
    }
    Ok(stress)
}
