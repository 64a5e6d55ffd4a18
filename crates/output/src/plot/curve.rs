//! The numbers of a curve, taken from the result files.

use crate::job::JobFiles;
use crate::number::push_shortest;
use crate::reading::history::{Energies, History, with_start};
use crate::reading::problem::Problem;
use crate::reading::summary::{driven, read};

/// What is asked for.
#[derive(Clone, Debug)]
pub struct Question {
    /// Column along the horizontal axis: `U2`, `RF2`, `time`, `increment`, an
    /// energy.
    pub x: String,
    /// Column along the vertical axis.
    pub y: String,
    /// The node; the driven one where there is only one.
    pub node: Option<u64>,
    /// Whether a job that still runs is shown as far as it came.
    pub unfinished: bool,
}

/// A curve over the increments, the start among them.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// What the legend calls it.
    pub name: String,
    /// Total times.
    pub times: Vec<f64>,
    /// Horizontal values.
    pub x: Vec<f64>,
    /// Vertical values.
    pub y: Vec<f64>,
}

/// Reads a curve from the files of a job. At the start everything is zero.
///
/// # Errors
/// Files that cannot be read, a column or node that they lack.
pub fn curve(job: &JobFiles, question: &Question) -> Result<Curve, Problem> {
    let said = read(job, question.unfinished)?;
    let mut nodes: Vec<u64> =
        driven(&said).iter().flat_map(|own| own.nodes.first().copied()).collect();
    nodes.dedup();
    let asked = match (question.node, nodes.as_slice()) {
        (Some(node), _) => Some(node),
        (None, [only]) => Some(*only),
        _ => None,
    };
    let energies = Energies::read(&job.path(".energy.csv"))?;
    let mut history = History::read(&job.path(".history.csv"), |node| Some(node) == asked)?;
    history.shorten(energies.times.len());
    let files = Files { job, energies: &energies, history: &history, node: asked };
    let (x, y) = (files.column(&question.x)?, files.column(&question.y)?);
    let times = with_start(&energies.times);
    if x.len() != times.len() || y.len() != times.len() {
        return Err(Problem::Unreadable {
            path: job.path(".history.csv"),
            reason: "it has fewer increments than the energies: it is truncated".to_owned(),
        });
    }
    Ok(Curve { name: job.name(), times, x, y })
}

struct Files<'a> {
    job: &'a JobFiles,
    energies: &'a Energies,
    history: &'a History,
    node: Option<u64>,
}

impl Files<'_> {
    fn column(&self, name: &str) -> Result<Vec<f64>, Problem> {
        let energies = self.energies;
        if name.eq_ignore_ascii_case("time") {
            return Ok(with_start(&energies.times));
        }
        if name.eq_ignore_ascii_case("increment") {
            return Ok((0..=energies.times.len()).map(|place| place as f64).collect());
        }
        let same = |column: &&String| column.eq_ignore_ascii_case(name);
        if let Some(place) = energies.columns.iter().position(|column| same(&column)) {
            return Ok(with_start(&energies.values[place]));
        }
        let Some(column) = self.history.columns.iter().find(same) else {
            return Err(Problem::Question(format!(
                "there is no column {name}: known are time, increment, {} and {}",
                self.history.columns.join(", "),
                energies.columns.join(", ")
            )));
        };
        let Some(node) = self.node else {
            return Err(Problem::Question(format!(
                "{name} needs a node: name one with --node (those in {} have a history)",
                self.job.path(".history.csv").display()
            )));
        };
        let values = self.history.column(node, column).ok_or_else(|| {
            let file = self.job.path(".history.csv");
            Problem::Question(format!("node {node} has no history in {}", file.display()))
        })?;
        Ok(with_start(values))
    }
}

/// `other` minus `one` at the times of `one`; between its increments `other`
/// is taken along a straight line. Beyond its end there is no difference (not
/// a number).
pub fn difference(one: &Curve, other: &Curve) -> Vec<f64> {
    let at = |time: f64| -> f64 {
        let after = other.times.partition_point(|t| *t < time - 1e-12 * time.abs());
        let Some(&late) = other.times.get(after) else { return f64::NAN };
        if after == 0 || late <= time + 1e-12 * time.abs() {
            return other.y[after];
        }
        let early = other.times[after - 1];
        let part = (time - early) / (late - early);
        other.y[after - 1] + part * (other.y[after] - other.y[after - 1])
    };
    one.times.iter().zip(&one.y).map(|(time, y)| at(*time) - y).collect()
}

/// The curves as CSV: a column for x, y of the job, and with another job its x
/// and y at the same place in the list, and the difference at equal times.
pub fn csv(question: &Question, one: &Curve, other: Option<&Curve>) -> String {
    let mut text = format!("time,{},{}", question.x, question.y);
    let differences = other.map(|other| difference(one, other));
    if other.is_some() {
        text.push_str(&format!(",other_time,other_{},other_{},difference", question.x, question.y));
    }
    text.push('\n');
    let rows = one.times.len().max(other.map_or(0, |other| other.times.len()));
    for row in 0..rows {
        let mut cells = vec![one.times.get(row), one.x.get(row), one.y.get(row)];
        if let (Some(other), Some(differences)) = (other, &differences) {
            cells.extend([other.times.get(row), other.x.get(row), other.y.get(row)]);
            cells.push(differences.get(row));
        }
        for (place, cell) in cells.into_iter().enumerate() {
            if place > 0 {
                text.push(',');
            }
            if let Some(value) = cell {
                push_shortest(&mut text, *value);
            }
        }
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(times: &[f64], slope: f64) -> Curve {
        let y = times.iter().map(|t| slope * t).collect();
        Curve { name: "a".to_owned(), times: times.to_vec(), x: times.to_vec(), y }
    }

    /// Requirement: jobs with other increments are compared at equal times.
    #[test]
    fn the_difference_is_taken_at_equal_times() {
        let one = line(&[0.0, 0.25, 0.5, 1.0], 1.0);
        let other = line(&[0.0, 0.4, 0.8], 3.0);
        let found = difference(&one, &other);
        for (found, expected) in found.iter().zip([0.0, 0.5, 1.0]) {
            assert!((found - expected).abs() < 1e-15, "{found} {expected}");
        }
        assert!(found[3].is_nan(), "beyond the end there is nothing to compare");
        assert_eq!(difference(&one, &one), [0.0; 4]);
    }
}
