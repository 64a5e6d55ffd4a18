//! Error bars, or why there are none, added to the files of a finished run.

use crate::file::{WriteError, at, read_text, replace};
use crate::job::JobFiles;
use crate::json::{self, Object};
use crate::number::push_shortest;
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
    let summary = job.path(".json");
    let object = read_text(&summary).map_err(at(&summary))?;
    for rows in mesh.into_iter().chain(time) {
        text = with_columns(&text, rows);
    }
    replace(&history, text.as_bytes())?;
    let open = verdict::without(&object);
    let text = format!("{open},\"error_bars\":{}}}\n", members(mesh, time));
    replace(&summary, verdict::attached(job, &text).as_bytes())
}

/// Adds a warning that came after the end of the run to `JOB.json`.
///
/// # Errors
/// When the file cannot be read or written.
pub fn add_warning(job: &JobFiles, said: &Diagnostic, sources: &Sources) -> Result<(), WriteError> {
    let summary = job.path(".json");
    let object = read_text(&summary).map_err(at(&summary))?;
    let text = with_warning(&object, &record(said, sources).finish());
    let text = verdict::attached(job, &text);
    replace(&summary, text.as_bytes())
}

/// In a text quotation marks are escaped: what is looked for stands there once.
fn with_warning(object: &str, warning: &str) -> String {
    let Some(end) = object.find(AFTER_WARNINGS) else { return object.to_owned() };
    let (before, after) = object.split_at(end);
    let comma = if before.ends_with('[') { "" } else { "," };
    format!("{before}{comma}{warning}{after}")
}

/// What follows the last warning of a summary.
const AFTER_WARNINGS: &str = "],\"advice\":[";

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
fn members(mesh: Option<&BarRows<'_>>, time: Option<&BarRows<'_>>) -> String {
    let kind = |object: Object, rows: &BarRows<'_>| {
        object.raw("method", &json::text(rows.method)).raw("largest", &largest(rows))
    };
    let object = mesh.into_iter().fold(Object::new(), kind);
    let object = match time {
        Some(rows) => object.raw("time", &kind(Object::new(), rows).finish()),
        None => object,
    };
    object.finish()
}

/// The largest bar of every reaction, by its column.
fn largest(rows: &BarRows<'_>) -> String {
    let mut object = Object::new();
    for (k, node) in rows.nodes.iter().enumerate() {
        for (column, name) in rows.columns.iter().enumerate() {
            let curve = rows.bars.get(k * rows.columns.len() + column);
            let most = curve.map_or(0.0, |c| c.iter().copied().fold(0.0, f64::max));
            object = object.number(&format!("{node}.{name}"), most);
        }
    }
    object.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_late_warning_comes_last() {
        let none = r#"{"job":"],\"advice\":[","warnings":[],"advice":[]}"#;
        let one = with_warning(none, "1");
        assert_eq!(one, r#"{"job":"],\"advice\":[","warnings":[1],"advice":[]}"#);
        let two = with_warning(&one, "2");
        assert_eq!(two, r#"{"job":"],\"advice\":[","warnings":[1,2],"advice":[]}"#);
    }

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
        let json = members(Some(&rows), Some(&rows));
        assert!(json.starts_with("{\"method\":\"m\",\"largest\":{"), "{json}");
        assert!(json.contains("\"9.RF2_error\":4}"), "{json}");
        assert!(json.contains(",\"time\":{\"method\":\"m\",\"largest\":{"), "{json}");
        assert!(members(None, Some(&rows)).starts_with("{\"time\":{"));
    }
}
