//! `JOB.contact.csv` read back, point by point.

use super::problem::{Problem, unreadable};
use super::table::Table;
use std::collections::HashMap;
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

/// Where the columns stand.
struct Columns {
    numbers: [Option<usize>; 4],
    friction: Option<usize>,
    normal: [Option<usize>; 2],
    area: Option<usize>,
}

impl Columns {
    fn of(table: &Table) -> Self {
        Self {
            numbers: NUMBERS.map(|name| table.place(name)),
            friction: table.place("friction"),
            normal: ["normal_x", "normal_y"].map(|name| table.place(name)),
            area: table.place("area"),
        }
    }
}

/// A row of the file.
struct Row {
    at: [usize; 2],
    pair: String,
    node: u64,
    status: char,
    friction: char,
}

/// Reads all points. `numbers` are the steps and increments there are; rows of
/// others are those of a job that was killed while it wrote.
pub(crate) fn read(path: &Path, numbers: &[[usize; 2]]) -> Result<Vec<Point>, Problem> {
    let start = ["step", "increment", "time", "pair", "node", "status"];
    let mut table = Table::open(path, &start)?;
    let columns = Columns::of(&table);
    let mut points: Vec<Point> = Vec::new();
    let mut places: HashMap<u64, Vec<usize>> = HashMap::new();
    let mut now = 0;
    while let Some(cells) = table.row()? {
        let row = row(path, cells, &columns)?;
        while now < numbers.len() && numbers[now] != row.at {
            now += 1;
        }
        if now == numbers.len() {
            break;
        }
        let own = places.entry(row.node).or_default();
        let known = own.iter().copied().find(|place| points[*place].pair == row.pair);
        let place = match known {
            Some(place) => place,
            None => {
                own.push(points.len());
                let area = optional(&table, columns.area)?;
                points.push(Point::first_closed(&row, now, area));
                points.len() - 1
            }
        };
        points[place].push(&table, &columns, &row)?;
    }
    Ok(points)
}

fn row(path: &Path, cells: &[String], columns: &Columns) -> Result<Row, Problem> {
    let whole = |place: usize| -> Result<u64, Problem> {
        let wrong = || unreadable(path, format!("`{}` is not a whole number", cells[place]));
        cells[place].parse().map_err(|_| wrong())
    };
    let at = [whole(0)? as usize, whole(1)? as usize];
    let status = letter(&cells[5], &[("open", 'o'), ("stick", 't'), ("slip", 's')]);
    let called = columns.friction.map_or("none", |place| cells[place].as_str());
    let friction = letter(called, &[("called", 'c'), ("dropped", 'd'), ("none", 'n')]);
    match (status, friction) {
        (Some(status), Some(friction)) => {
            Ok(Row { at, pair: cells[3].clone(), node: whole(4)?, status, friction })
        }
        _ => Err(unreadable(path, format!("`{}`, `{called}` is no status", cells[5]))),
    }
}

/// A number of the row at hand; not a number where there is no such column.
fn optional(table: &Table, place: Option<usize>) -> Result<f64, Problem> {
    place.map_or(Ok(f64::NAN), |place| table.number(place))
}

impl Point {
    fn first_closed(row: &Row, now: usize, area: f64) -> Self {
        Self {
            pair: row.pair.clone(),
            node: row.node,
            first: now,
            status: String::new(),
            friction: String::new(),
            values: std::array::from_fn(|_| Vec::new()),
            area,
        }
    }

    fn push(&mut self, table: &Table, columns: &Columns, row: &Row) -> Result<(), Problem> {
        self.status.push(row.status);
        self.friction.push(row.friction);
        for (column, place) in self.values.iter_mut().zip(columns.numbers) {
            column.push(optional(table, place)?);
        }
        let [x, y] = columns.normal;
        self.values[4].push(optional(table, y)?.atan2(optional(table, x)?));
        Ok(())
    }

    /// Number of increments up to the last one in which it is closed.
    pub fn closed_until(&self) -> usize {
        self.status.trim_end_matches('o').len()
    }
}

fn letter(word: &str, words: &[(&str, char)]) -> Option<char> {
    words.iter().find(|(known, _)| *known == word).map(|(_, letter)| *letter)
}
