//! Error bars, or why there are none, added to the files of a finished run.

use crate::file::{WriteError, at, read_text, replace};
use crate::job::JobFiles;
use crate::json::{self, Map, Value, joined, json};
use crate::number::push_shortest;
use crate::reading::history::{Energies, History};
use crate::reading::problem::Problem;
use crate::reading::summary::raw;
use crate::record::record;
use crate::verdict;
use slideline_diag::{Diagnostic, Sources};

/// Error bars of one kind as the rows of `JOB.history.csv` want them.
#[derive(Clone, Copy, Debug)]
pub struct BarRows<'a> {
    /// What they were found by, in words.
    pub method: &'a str,
    /// Labels of the nodes, in the order of the rows of an increment.
    pub nodes: &'a [u64],
    /// Names of the columns.
    pub columns: &'a [String],
    /// A curve each node and column, node by node [F or F L].
    pub bars: &'a [Vec<f64>],
}

/// Appends columns to `JOB.history.csv`, those of the mesh and then those in
/// time, and the member `error_bars` to `JOB.json`.
///
/// # Errors
/// When a file cannot be read or written.
pub fn add_error_bars(
    job: &JobFiles,
    mesh: Option<&BarRows<'_>>,
    time: Option<&BarRows<'_>>,
) -> Result<(), WriteError> {
    let history = job.path(".history.csv");
    let mut text = read_text(&history).map_err(at(&history))?;
    for rows in mesh.into_iter().chain(time) {
        text = with_columns(&text, rows);
    }
    replace(&history, text.as_bytes())?;
    change(job, |summary| summary["error_bars"] = members(mesh, time))
}

/// Changes what `JOB.json` says; forces and verdict follow.
fn change(job: &JobFiles, how: impl FnOnce(&mut Value)) -> Result<(), WriteError> {
    let path = job.path(".json");
    let mut summary = raw(job).map_err(|problem| match problem {
        Problem::Write(error) => error,
        other => at(&path)(std::io::Error::other(other.to_string())),
    })?;
    how(&mut summary);
    let energies = Energies::read(&job.path(".energy.csv")).unwrap_or_default();
    let history = History::read(&job.path(".history.csv"), |_| true).unwrap_or_default();
    let summary = verdict::attached(summary, &energies, &history);
    replace(&path, (json::text(&summary) + "\n").as_bytes())
}

/// Adds a warning that came after the end of the run to `JOB.json`.
///
/// # Errors
/// When the file cannot be read or written.
pub fn add_warning(job: &JobFiles, said: &Diagnostic, sources: &Sources) -> Result<(), WriteError> {
    change(job, |summary| {
        if let Some(warnings) = summary["warnings"].as_array_mut() {
            warnings.push(record(said, sources));
        }
    })
}

fn with_columns(old: &str, rows: &BarRows<'_>) -> String {
    let mut text = String::with_capacity(2 * old.len());
    let nodes = rows.nodes.len().max(1);
    for (line, row) in old.lines().enumerate() {
        text.push_str(row);
        for (column, name) in rows.columns.iter().enumerate() {
            text.push(',');
            let Some(place) = line.checked_sub(1) else {
                text.push_str(name);
                continue;
            };
            let curve = rows.bars.get(place % nodes * rows.columns.len() + column);
            if let Some(&bar) = curve.and_then(|curve| curve.get(place / nodes)) {
                push_shortest(&mut text, bar);
            }
        }
        text.push('\n');
    }
    text
}

/// Method and largest bars of the mesh, those in time as a member of their
/// own.
fn members(mesh: Option<&BarRows<'_>>, time: Option<&BarRows<'_>>) -> Value {
    let kind = |rows: &BarRows<'_>| json!({"method": rows.method, "largest": largest(rows)});
    let mesh = mesh.map_or_else(|| json!({}), kind);
    joined(mesh, time.map_or(Value::Null, |rows| json!({ "time": kind(rows) })))
}

/// The largest bar of every reaction, by its column.
fn largest(rows: &BarRows<'_>) -> Map<String, Value> {
    let nodes = rows.nodes.iter();
    let names =
        nodes.flat_map(|node| rows.columns.iter().map(move |name| format!("{node}.{name}")));
    let larger = |most: f64, bar: f64| if bar.is_nan() || bar > most { bar } else { most };
    let most = |curve: &Vec<f64>| curve.iter().copied().fold(0.0, larger);
    let none = std::iter::repeat(0.0);
    names.zip(rows.bars.iter().map(most).chain(none)).map(|(n, most)| (n, json!(most))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_come_last_and_rows_keep_their_order() {
        let columns = ["RF1_error".to_owned(), "RF2_error".to_owned()];
        let bars = [vec![0.1, 0.2], vec![0.3, 0.4], vec![1.0, 2.0], vec![3.0, 4.0]];
        let rows = BarRows { method: "m", nodes: &[7, 9], columns: &columns, bars: &bars };
        let old = "step,node\n1,7\n1,9\n2,7\n2,9\n";
        assert_eq!(
            with_columns(old, &rows),
            "step,node,RF1_error,RF2_error\n1,7,0.1,0.3\n1,9,1,3\n2,7,0.2,0.4\n2,9,2,4\n"
        );
        let json = json::text(&members(Some(&rows), Some(&rows)));
        assert!(json.starts_with("{\"method\":\"m\",\"largest\":{"), "{json}");
        assert!(json.contains("\"9.RF2_error\":4}"), "{json}");
        assert!(json.contains(",\"time\":{\"method\":\"m\",\"largest\":{"), "{json}");
        assert!(json::text(&members(None, Some(&rows))).starts_with("{\"time\":{"));
    }
}
