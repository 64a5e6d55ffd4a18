//! A second curve laid over the reactions.

use crate::reading::problem::{Problem, unreadable};
use crate::reading::table::Table;
use std::path::Path;

/// Longer files are refused: a curve to compare with has no more points.
const ROWS: usize = 100_000;

/// Columns of numbers of a CSV file, such as `slideline theory` prints or a
/// `JOB.history.csv` of another run.
#[derive(Clone, Debug)]
pub(crate) struct Overlay {
    /// What the legend calls it.
    pub name: String,
    /// Columns of numbers.
    pub columns: Vec<(String, Vec<f64>)>,
}

/// Reads it. Cells without a number are not a number.
///
/// # Errors
/// A file that cannot be read, has no column of a motion or reaction, or no
/// rows.
pub(crate) fn read(path: &Path) -> Result<Overlay, Problem> {
    let mut table = Table::open(path, &[])?;
    let known = |name: &str| {
        let [motions, reactions] = [["U1", "U2", "U3", "UR1", "UR2", "UR3"], REACTIONS];
        motions.contains(&name) || reactions.contains(&name)
    };
    if !table.columns.iter().any(|column| known(column)) {
        let reason = "none of its columns is a motion (U1 ...) or reaction (RF1 ...)";
        return Err(unreadable(path, reason));
    }
    let mut columns: Vec<(String, Vec<f64>)> =
        table.columns.iter().map(|name| (name.clone(), Vec::new())).collect();
    while let Some(row) = table.row()? {
        for ((_, column), cell) in columns.iter_mut().zip(row) {
            column.push(cell.trim().parse().unwrap_or(f64::NAN));
        }
        if columns[0].1.len() > ROWS {
            return Err(unreadable(path, format!("it has more than {ROWS} rows")));
        }
    }
    if table.is_cut() {
        return Err(unreadable(path, "it is truncated: its last line has no end"));
    }
    if columns[0].1.is_empty() {
        return Err(unreadable(path, "it has no rows"));
    }
    columns.retain(|(name, _)| known(name) || name == "node");
    let name = path.file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned());
    Ok(Overlay { name, columns })
}

const REACTIONS: [&str; 6] = ["RF1", "RF2", "RF3", "RM1", "RM2", "RM3"];
