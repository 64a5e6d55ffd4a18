//! `JOB.contact.csv` read back, point by point.

use super::problem::{Problem, unreadable};
use super::table::Table;
use std::path::Path;

/// A slave point from the increment in which it first closed.
#[derive(Clone, Debug)]
pub(crate) struct Point {
    /// Name of the pair.
    pub pair: String,
    /// Number of the slave node.
    pub node: u64,
    /// Place of its first increment in the list of all.
    pub first: usize,
    /// `o`, `t` (stick) or `s` (slip), a letter an increment.
    pub status: String,
    /// `c` (called), `d` (dropped) or `n` (none), a letter an increment.
    pub friction: String,
    /// Gap, pressure, shear traction, slip; normal's angle; one list each.
    pub values: [Vec<f64>; 5],
    /// Tributary area; not a number where the file does not say.
    pub area: f64,
}

const NUMBERS: [&str; 4] = ["COPEN", "CPRESS", "CSHEAR1", "CSLIP1"];

/// Reads all points. `numbers` are the steps and increments there are; rows of
/// others are those of a job that was killed while it wrote.
pub(crate) fn read(path: &Path, numbers: &[[usize; 2]]) -> Result<Vec<Point>, Problem> {
    let start = ["step", "increment", "time", "pair", "node", "status"];
    let mut table = Table::open(path, &start)?;
    let places: Vec<Option<usize>> = NUMBERS.iter().map(|name| table.place(name)).collect();
    let friction = table.place("friction");
    let normal = [table.place("normal_x"), table.place("normal_y")];
    let area = table.place("area");
    let mut points: Vec<Point> = Vec::new();
    let mut now = 0;
    loop {
        let Some(row) = table.row()? else { return Ok(points) };
        let whole = |place: usize| -> Result<u64, Problem> {
            let wrong = || unreadable(path, format!("`{}` is not a whole number", row[place]));
            row[place].parse().map_err(|_| wrong())
        };
        let at = [whole(0)? as usize, whole(1)? as usize];
        let node = whole(4)?;
        while now < numbers.len() && numbers[now] != at {
            now += 1;
        }
        if now == numbers.len() {
            return Ok(points);
        }
        let pair = row[3].clone();
        let status = letter(&row[5], &[("open", 'o'), ("stick", 't'), ("slip", 's')]);
        let called = friction.map_or("none", |place| row[place].as_str());
        let called = letter(called, &[("called", 'c'), ("dropped", 'd'), ("none", 'n')]);
        let (Some(status), Some(called)) = (status, called) else {
            return Err(unreadable(path, format!("`{}` is no status", row[5])));
        };
        let number = |place: Option<usize>| place.map_or(Ok(f64::NAN), |p| table.number(p));
        let mut values = [f64::NAN; 5];
        for (value, place) in values.iter_mut().zip(&places) {
            *value = number(*place)?;
        }
        values[4] = number(normal[1])?.atan2(number(normal[0])?);
        let area = number(area)?;
        let known = points.iter_mut().find(|point| point.node == node && point.pair == pair);
        let point = match known {
            Some(point) => point,
            None => {
                points.push(Point {
                    pair,
                    node,
                    first: now,
                    status: String::new(),
                    friction: String::new(),
                    values: std::array::from_fn(|_| Vec::new()),
                    area,
                });
                let last = points.len() - 1;
                &mut points[last]
            }
        };
        point.status.push(status);
        point.friction.push(called);
        for (column, value) in point.values.iter_mut().zip(values) {
            column.push(value);
        }
    }
}

fn letter(word: &str, words: &[(&str, char)]) -> Option<char> {
    words.iter().find(|(known, _)| *known == word).map(|(_, letter)| *letter)
}
