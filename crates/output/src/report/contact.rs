//! `JOB.contact.csv` read back, point by point.

use super::presence::Presence;
use crate::reading::problem::{Problem, unreadable};
use crate::reading::table::Table;
use slideline_results::contact_component;
use slideline_solve::observe::{ContactRow, Frame};
use std::collections::HashMap;
use std::path::Path;

/// Most numbers of closed points that are kept, a column each: with more, the
/// increments at which there are numbers are thinned.
const MOST: usize = 24_000;

/// Every slave point that touched.
///
/// ```text
///   place      0 1 2 3 4 5 6 7 8 9     increments of the job
///   status     o o t t t s s s s o     at every one
///   numbers    -     x     x     x     at every stride-th, counted from the last
/// ```
#[derive(Clone, Debug, Default)]
pub(crate) struct Contacts {
    /// In the order in which they closed.
    pub points: Vec<Point>,
    /// How many increments there are from one with numbers to the next.
    pub stride: usize,
    /// Number of increments of the job.
    count: usize,
    /// Numbers of closed points that are kept.
    kept: usize,
    /// When pairs have rows.
    presence: Presence,
}

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
    /// Gap, pressure, shear traction, slip; normal's angle; one list each, at
    /// the increments with numbers from the first on.
    pub values: [Vec<f32>; 5],
    /// Tributary area; not a number where the file does not say.
    pub area: f64,
}

const STATUS: [(&str, char); 3] = [("open", 'o'), ("stick", 't'), ("slip", 's')];
const FRICTION: [(&str, char); 3] = [("called", 'c'), ("dropped", 'd'), ("none", 'n')];
const NUMBERS: [&str; 4] = ["COPEN", "CPRESS", "CSHEAR1", "CSLIP1"];
/// Gap, pressure, shear traction, slip and angle of a point that faces nothing.
const NOTHING: [f32; 5] = [f32::INFINITY, 0.0, 0.0, 0.0, 0.0];

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
            numbers: NUMBERS.map(|name| table.index(name)),
            friction: table.index("friction"),
            normal: ["normal_x", "normal_y"].map(|name| table.index(name)),
            area: table.index("area"),
        }
    }
}

/// What stands before the numbers of a row.
struct Row<'a> {
    at: [usize; 2],
    pair: &'a str,
    node: u64,
    status: char,
    friction: char,
}

/// Where the points of a node are in the list.
#[derive(Clone, Debug, Default)]
pub(crate) struct Places(HashMap<u64, Vec<usize>>);

/// Reads all points. `numbers` are the steps and increments there are; rows of
/// others are those of a job that was killed while it wrote.
pub(crate) fn read(path: &Path, numbers: &[[usize; 2]]) -> Result<Contacts, Problem> {
    let start = ["step", "increment", "time", "pair", "node", "status"];
    let mut table = Table::open(path, &start)?;
    let columns = Columns::of(&table);
    let mut contacts = Contacts { stride: 1, count: numbers.len(), ..Contacts::default() };
    let mut places = Places::default();
    let mut now = 0;
    while table.row()?.is_some() {
        let row = row(path, &table, &columns)?;
        while now < numbers.len() && numbers[now] != row.at {
            now += 1;
        }
        if now == numbers.len() {
            break;
        }
        contacts.push(&mut places, now, &row, || values(&table, &columns))?;
    }
    Ok(contacts)
}

fn row<'a>(path: &Path, table: &'a Table, columns: &Columns) -> Result<Row<'a>, Problem> {
    let at = [table.number(0)?, table.number(1)?];
    let status = letter(table.cell(5), &STATUS);
    let called = columns.friction.map_or("none", |index| table.cell(index));
    let friction = letter(called, &FRICTION);
    match (status, friction) {
        (Some(status), Some(friction)) => {
            Ok(Row { at, pair: table.cell(3), node: table.number(4)?, status, friction })
        }
        _ => Err(unreadable(path, format!("`{}`, `{called}` is no status", table.cell(5)))),
    }
}

impl Contacts {
    /// Whether there are numbers at that place in the list of increments; at
    /// the last one there are.
    pub fn has_numbers(&self, place: usize) -> bool {
        place < self.count && (self.count - 1 - place).is_multiple_of(self.stride)
    }

    /// The numbers of a point up to the last increment in which it is closed,
    /// a list a column: what is open for good needs none.
    pub fn numbers<'a>(&self, point: &'a Point) -> [&'a [f32]; 5] {
        let closed = point.first..point.first + point.closed_until();
        let length = closed.filter(|place| self.has_numbers(*place)).count();
        point.values.each_ref().map(|column| &column[..length.min(column.len())])
    }

    /// Takes a row in. Numbers and area are asked for where they are kept.
    fn push<E>(
        &mut self,
        places: &mut Places,
        now: usize,
        row: &Row<'_>,
        values: impl Fn() -> Result<([f64; 5], f64), E>,
    ) -> Result<(), E> {
        let own = places.0.entry(row.node).or_default();
        // a sharp edge of the slave has a row of its own beside that of its node
        let is_free = |point: &Point| point.first + point.status.len() <= now;
        let is_it = |point: &Point| point.pair == row.pair && is_free(point);
        let known = own.iter().copied().find(|&place| is_it(&self.points[place]));
        let place = match known {
            Some(place) => place,
            None => {
                own.push(self.points.len());
                let (_, area) = values()?;
                self.points.push(Point::first_closed(row.pair.to_owned(), row.node, now, area));
                self.points.len() - 1
            }
        };
        self.presence.note(row.pair, now);
        self.fill(place, now);
        let has_numbers = self.has_numbers(now);
        let point = &mut self.points[place];
        point.status.push(row.status);
        point.friction.push(row.friction);
        if has_numbers {
            let (numbers, _) = values()?;
            point.values.iter_mut().zip(numbers).for_each(|(own, value)| own.push(value as f32));
            self.kept += usize::from(row.status != 'o');
        }
        self.limit();
        Ok(())
    }

    /// Whether a pair has rows.
    pub fn has_rows(&self, pair: &str) -> bool {
        self.presence.has(pair)
    }

    /// Behind which increment rows are missing, where a pair `has` some in that with this place.
    pub fn missing_from(&self, has: impl Fn(&str, usize) -> bool) -> Option<usize> {
        self.presence.missing_from(self.count, has)
    }

    /// A pair that was removed and is back has no rows of the time between, and where edges cross the rows are those
    /// of the nodes nearby: the points were open, and faced nothing.
    fn fill(&mut self, place: usize, now: usize) {
        let point = &self.points[place];
        for absent in point.first + point.status.len()..now {
            let has_numbers = self.has_numbers(absent);
            let point = &mut self.points[place];
            point.status.push('o');
            point.friction.push('n');
            if has_numbers {
                point.values.iter_mut().zip(NOTHING).for_each(|(own, value)| own.push(value));
            }
        }
    }

    /// Those of a run that goes on: numbers are kept at every increment until it is [`over`](Self::over).
    pub fn begun() -> Self {
        Self { stride: 1, count: usize::MAX, ..Self::default() }
    }

    /// Takes in the rows of an increment.
    pub fn follow(&mut self, places: &mut Places, now: usize, frame: &Frame<'_>) {
        for row in frame.contact.iter().filter(|row| row.ever_closed) {
            let [status, friction] = letters(row);
            let head = Row {
                at: [frame.step, frame.increment],
                pair: &frame.model.contact_pairs[row.pair].name,
                node: frame.model.nodes.label(row.node),
                status,
                friction,
            };
            let none = Ok::<_, std::convert::Infallible>((shown(row), row.area));
            let Ok(()) = self.push(places, now, &head, || none);
        }
    }

    /// The run has come to so many increments.
    pub fn over(&mut self, count: usize) {
        self.count = count;
        self.limit();
    }

    /// Thins the numbers until there are few enough.
    fn limit(&mut self) {
        while self.kept > MOST && self.stride < self.count && self.count < usize::MAX {
            self.thin();
        }
    }

    /// Drops the numbers of every second increment that has some.
    fn thin(&mut self) {
        let old = self.stride;
        self.stride *= 2;
        self.kept = 0;
        let (count, stride) = (self.count, self.stride);
        for point in &mut self.points {
            let skipped = (count - 1 - point.first) % old;
            let place = |index: usize| point.first + skipped + old * index;
            let stays = |index: usize| (count - 1 - place(index)).is_multiple_of(stride);
            let statuses = point.status.as_bytes();
            let closed = |index: usize| statuses.get(place(index) - point.first) != Some(&b'o');
            let length = point.values[0].len();
            self.kept += (0..length).filter(|index| stays(*index) && closed(*index)).count();
            for column in &mut point.values {
                let mut index = 0;
                column.retain(|_| {
                    index += 1;
                    stays(index - 1)
                });
            }
        }
    }
}

/// Gap, pressure, shear traction, slip, the normal's angle, and the area of the row at hand.
fn values(table: &Table, columns: &Columns) -> Result<([f64; 5], f64), Problem> {
    let mut numbers = [f64::NAN; 5];
    for (number, place) in numbers.iter_mut().zip(columns.numbers) {
        *number = optional(table, place)?;
    }
    let [x, y] = columns.normal;
    numbers[4] = optional(table, y)?.atan2(optional(table, x)?);
    Ok((numbers, optional(table, columns.area)?))
}

/// The same numbers of a row that is told.
pub(crate) fn shown(row: &ContactRow) -> [f64; 5] {
    let of = |name| contact_component(name).map_or(f64::NAN, |own| (own.value)(row));
    let [opening, pressure, shear, slip] = NUMBERS.map(of);
    [opening, pressure, shear, slip, row.normal[1].atan2(row.normal[0])]
}

/// Letters of the status and of the friction of a row.
pub(crate) fn letters(row: &ContactRow) -> [char; 2] {
    let [status, friction] = [
        letter(row.status.word(), &STATUS).unwrap_or('o'),
        letter(row.friction.word(), &FRICTION).unwrap_or('n'),
    ];
    [status, friction]
}

/// A number of the row at hand; not a number where there is no such column.
fn optional(table: &Table, place: Option<usize>) -> Result<f64, Problem> {
    place.map_or(Ok(f64::NAN), |place| table.number(place))
}

impl Point {
    fn first_closed(pair: String, node: u64, first: usize, area: f64) -> Self {
        let values = std::array::from_fn(|_| Vec::new());
        Self { pair, node, first, status: String::new(), friction: String::new(), values, area }
    }

    /// Number of increments up to the last one in which it is closed.
    pub fn closed_until(&self) -> usize {
        self.status.trim_end_matches('o').len()
    }
}

/// A letter and how often it stands in a row, in turn: `ooottt` is `o3t3`.
pub(crate) fn runs(letters: &str) -> String {
    let mut text = String::new();
    for run in letters.as_bytes().chunk_by(|a, b| a == b) {
        text.push(char::from(run[0]));
        text.push_str(&run.len().to_string());
    }
    text
}

fn letter(word: &str, words: &[(&str, char)]) -> Option<char> {
    words.iter().find(|(known, _)| *known == word).map(|(_, letter)| *letter)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)] // a test may fail where it stands

    use super::*;

    /// Contacts of `points` slave points closed over `count` increments but
    /// for the first one's first third; the pressure tells the place.
    fn contacts(points: u64, count: usize) -> Contacts {
        let path = std::env::temp_dir()
            .join(format!("slideline_contacts_{}_{points}_{count}.csv", std::process::id()));
        let mut text = String::from("step,increment,time,pair,node,status,COPEN,CPRESS\n");
        for increment in 1..=count {
            for node in 1..=points {
                let status = if node == 1 && increment <= count / 3 { "open" } else { "slip" };
                text.push_str(&format!("1,{increment},0,P,{node},{status},0,{increment}\n"));
            }
        }
        std::fs::write(&path, text).unwrap();
        let numbers: Vec<[usize; 2]> = (1..=count).map(|increment| [1, increment]).collect();
        let contacts = read(&path, &numbers).unwrap();
        std::fs::remove_file(&path).unwrap();
        contacts
    }

    /// Requirement: a pair that is removed and comes back is open in the report for as long as it is away, and
    /// what it does then stands at its own increments.
    ///
    /// What touched before and does not again has no further rows; the pair is known to have left.
    #[test]
    fn a_pair_that_comes_back_was_open() {
        let path = std::env::temp_dir().join(format!("slideline_back_{}.csv", std::process::id()));
        let row = |own: usize, node: usize| format!("1,{own},0,P,{node},slip,0,{own}\n");
        let rows = [row(1, 7), row(2, 7), row(2, 8), row(5, 7)].concat();
        let head = "step,increment,time,pair,node,status,COPEN,CPRESS\n";
        std::fs::write(&path, format!("{head}{rows}")).unwrap();
        let contacts = read(&path, &[1, 2, 3, 4, 5].map(|own| [1, own])).unwrap();
        std::fs::remove_file(&path).unwrap();
        assert_eq!(contacts.missing_from(|_, _| true), None);
        let point = &contacts.points[0];
        assert_eq!(runs(&point.status), "s2o2s1");
        assert_eq!(
            (runs(&point.friction).as_str(), &point.values[1][..]),
            ("n5", &[1., 2., 0., 0., 5.][..])
        );
    }

    /// What is read from these rows of five increments.
    fn read_rows(name: &str, rows: &[String]) -> Contacts {
        let path =
            std::env::temp_dir().join(format!("slideline_{name}_{}.csv", std::process::id()));
        let head = "step,increment,time,pair,node,status,COPEN,CPRESS\n";
        std::fs::write(&path, format!("{head}{}", rows.concat())).unwrap();
        let contacts = read(&path, &[1, 2, 3, 4, 5].map(|own| [1, own])).unwrap();
        std::fs::remove_file(&path).unwrap();
        contacts
    }

    /// Requirement: a row of a sharp edge beside that of its node is a point of its own, and where edges cross, rows go from
    /// node to node; a file is cut where a pair has fewer rows than before, or none though it touches.
    #[test]
    fn rows_of_edges_go_from_node_to_node() {
        let row = |own: usize, node: usize| format!("1,{own},0,P,{node},slip,0,{own}\n");
        let whole = [(1, 7), (2, 7), (2, 7), (3, 7), (3, 8), (4, 7), (4, 9), (5, 7), (5, 9)]
            .map(|(own, node)| row(own, node));
        let contacts = read_rows("edges", &whole);
        let status: Vec<_> =
            contacts.points.iter().map(|own| (own.node, own.first, runs(&own.status))).collect();
        let expected = [(7, 0, "s5"), (7, 1, "s1"), (8, 2, "s1"), (9, 3, "s2")];
        assert_eq!(status, expected.map(|(node, first, runs)| (node, first, runs.to_owned())));
        assert_eq!(contacts.missing_from(|_, _| true), None);
        let without_last = read_rows("short", &whole[..8]);
        assert_eq!(without_last.missing_from(|_, _| true), Some(4));
        let without_increment = read_rows("shorter", &whole[..7]);
        assert_eq!(without_increment.missing_from(|_, _| true), Some(4));
        assert_eq!(without_increment.missing_from(|_, _| false), None);
    }

    /// Requirement: numbers are thinned where there are many, evenly, the last
    /// increment always among them; statuses never are.
    #[test]
    fn numbers_are_thinned_and_statuses_are_not() {
        let few = contacts(20, 100);
        assert_eq!((few.stride, few.points[3].values[1].len()), (1, 100));
        let many = contacts(300, 500);
        assert!(many.stride >= 8 && many.stride.is_power_of_two(), "{}", many.stride);
        let kept: Vec<usize> = (0..500).filter(|place| many.has_numbers(*place)).collect();
        let expected: Vec<f32> = kept.iter().map(|place| (place + 1) as f32).collect();
        for point in &many.points {
            assert_eq!(point.status.len(), 500);
            assert_eq!(many.numbers(point)[1], expected, "{}", point.node);
        }
        assert_eq!(expected.last(), Some(&500.0));
        let closed = 300 * kept.len() - kept.iter().filter(|place| **place < 166).count();
        assert_eq!(many.kept, closed);
        assert!(closed <= MOST && 2 * closed > MOST, "{closed}");
    }

    #[test]
    fn runs_are_counted() {
        assert_eq!(runs("oottts"), "o2t3s1");
        assert_eq!(runs(""), "");
    }
}
