//! `indices.csv`: shares of the variance of every response, of a study with Saltelli's design.

use crate::case::Row;
use crate::design::cases_a_point;
use crate::folder::{Failure, Folder, own_name, unwritten};
use crate::shard::Found;
use crate::study_file::StudyFile;
use slideline_measures::Shares;
use std::fmt::Write as _;
use std::path::PathBuf;

/// Writes the shares where all shards are there. `Ok(None)`: shards are missing, and nothing was
/// written.
pub(crate) fn write_indices(
    folder: &Folder,
    study: &StudyFile,
) -> Result<Option<PathBuf>, Failure> {
    let mut points = Points::new(study);
    for shard in 0..folder.shards() {
        let Found::Rows(rows) = folder.read(study, shard) else { return Ok(None) };
        rows.into_iter().for_each(|row| points.take(row));
    }
    let path = folder.path.join("indices.csv");
    let part = own_name(&path);
    let written = std::fs::write(&part, points.table(study));
    let written = written.and_then(|()| std::fs::rename(&part, &path));
    written.map_err(|reason| unwritten(&path, &reason))?;
    Ok(Some(path))
}

/// Cases gathered point by point.
struct Points {
    each: usize,
    rows: Vec<Row>,
    /// Of each response.
    shares: Vec<Shares>,
}

impl Points {
    #[allow(clippy::cast_possible_truncation)] // two more than the parameters
    fn new(study: &StudyFile) -> Self {
        let each = cases_a_point(study.parameters.len()) as usize;
        let shares = vec![Shares::default(); study.responses.len()];
        Self { each, rows: Vec::with_capacity(each), shares }
    }

    /// Takes the next case. A point with a case that has no value of a response does not count for
    /// it.
    fn take(&mut self, row: Row) {
        self.rows.push(row);
        if self.rows.len() < self.each {
            return;
        }
        for (place, shares) in self.shares.iter_mut().enumerate() {
            let values: Option<Vec<f64>> =
                self.rows.iter().map(|row| row.responses[place]).collect();
            if let Some([a, b, mixed @ ..]) = values.as_deref() {
                shares.add([*a, *b], mixed);
            }
        }
        self.rows.clear();
    }

    fn table(&self, study: &StudyFile) -> String {
        let head = "response,parameter,first,first_error,total,total_error,points,mean,deviation";
        let mut text = format!("{head}\n");
        for (response, shares) in study.responses.iter().zip(&self.shares) {
            let (moments, all) = (shares.moments(), shares.shares().unwrap_or_default());
            let deviation = moments.variance().unwrap_or_default().sqrt();
            for ((parameter, _), own) in study.parameters.iter().zip(all) {
                let [first, total] = [(own.first, own.errors[0]), (own.total, own.errors[1])];
                let _ = writeln!(
                    text, // a String takes any text
                    "{response},{parameter},{:?},{:?},{:?},{:?},{},{:?},{deviation:?}",
                    first.0,
                    first.1,
                    total.0,
                    total.1,
                    moments.count / 2,
                    moments.mean,
                );
            }
        }
        text
    }
}
