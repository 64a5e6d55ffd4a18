//! `JOB.history.csv` and `JOB.energy.csv` read back.

use super::problem::Problem;
use super::summary::Driven;
use super::table::Table;
use std::collections::HashMap;
use std::path::Path;

/// Columns with which every growing CSV file begins.
const TIME: [&str; 3] = ["step", "increment", "time"];

/// Values over the increments, behind the zero of the start.
pub(crate) fn with_start(values: &[f64]) -> Vec<f64> {
    std::iter::once(0.0).chain(values.iter().copied()).collect()
}

/// Columns of one node over the increments.
#[derive(Clone, Debug)]
pub(crate) struct NodeHistory {
    /// The node's number.
    pub node: u64,
    /// Values column by column, as in [`History::columns`].
    pub values: Vec<Vec<f64>>,
}

/// Motions and reactions over the increments.
#[derive(Clone, Debug, Default)]
pub(crate) struct History {
    /// `U1`, `U2`, ...
    pub columns: Vec<String>,
    /// Kept nodes in the order of the file.
    pub nodes: Vec<NodeHistory>,
}

impl NodeHistory {
    /// One with so many columns, all empty.
    pub fn new(node: u64, columns: usize) -> Self {
        Self { node, values: vec![Vec::new(); columns] }
    }
}

impl History {
    /// Reads the nodes that `keep` wants; it is asked once for each.
    pub fn read(path: &Path, mut keep: impl FnMut(u64) -> bool) -> Result<Self, Problem> {
        let mut table = Table::open(path, &["step", "increment", "time", "node"])?;
        let columns: Vec<String> = table.columns[4..].to_vec();
        let mut history = Self { columns, nodes: Vec::new() };
        let mut places: HashMap<u64, Option<usize>> = HashMap::new();
        while table.row()?.is_some() {
            let label = table.number(3)?;
            let place = *places.entry(label).or_insert_with(|| {
                keep(label).then(|| {
                    history.nodes.push(NodeHistory::new(label, history.columns.len()));
                    history.nodes.len() - 1
                })
            });
            if let Some(place) = place {
                let numbers = table.numbers(4)?;
                for (column, number) in history.nodes[place].values.iter_mut().zip(numbers) {
                    column.push(number);
                }
            }
        }
        Ok(history)
    }

    /// A column of a node, without the start.
    pub fn column(&self, node: u64, name: &str) -> Option<&[f64]> {
        let place = self.columns.iter().position(|column| column == name)?;
        let node = self.nodes.iter().find(|kept| kept.node == node)?;
        node.values.get(place).map(Vec::as_slice)
    }

    /// Motion and reaction of what is driven from the start on: the motion of its first node, the
    /// sum of the reactions of all.
    pub fn stroke(&self, driven: &Driven) -> Option<[Vec<f64>; 2]> {
        let mut motion = self.along(driven, 0, &driven.motion)?;
        if !driven.along.is_empty() {
            steady(&mut motion);
        }
        let mut sum = vec![0.0; motion.len()];
        for place in 0..driven.nodes.len() {
            let own = self.along(driven, place, &driven.reaction)?;
            sum.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
        }
        Some([self::with_start(&motion), self::with_start(&sum)])
    }

    /// A column of a node that is driven, along the axis of its motion.
    fn along(&self, driven: &Driven, place: usize, name: &str) -> Option<Vec<f64>> {
        let &node = driven.nodes.get(place)?;
        let Some(direction) = driven.along.get(place) else {
            return self.column(node, name).map(<[f64]>::to_vec);
        };
        let stem = name.trim_end_matches(|digit: char| digit.is_ascii_digit());
        let mut sum = vec![0.0; self.column(node, name)?.len()];
        for (share, number) in direction.iter().zip(1..) {
            let column = self.column(node, &format!("{stem}{number}")).unwrap_or_default();
            sum.iter_mut().zip(column).for_each(|(sum, own)| *sum += share * own);
        }
        Some(sum)
    }

    /// Cuts what a job that was killed wrote beyond its last whole increment.
    pub fn shorten(&mut self, length: usize) {
        for column in self.nodes.iter_mut().flat_map(|node| &mut node.values) {
            column.truncate(length);
        }
    }
}

/// Part of the largest value below which values that were added up of components do not differ [1].
const ROUNDING: f64 = 1e-13;

/// Takes rounding off a motion, so that what stands still does not go to and fro.
fn steady(motion: &mut [f64]) {
    let grain = ROUNDING * motion.iter().fold(0.0_f64, |most, own| most.max(own.abs()));
    if grain > 0.0 {
        motion.iter_mut().for_each(|own| *own = (*own / grain).round() * grain);
    }
}

/// Energies over the increments, and with them step, increment and time.
#[derive(Clone, Debug, Default)]
pub(crate) struct Energies {
    /// Step and increment numbers.
    pub numbers: Vec<[usize; 2]>,
    /// Total times [T].
    pub times: Vec<f64>,
    /// Names of the energies.
    pub columns: Vec<String>,
    /// Values column by column.
    pub values: Vec<Vec<f64>>,
}

impl Energies {
    /// Those of these names, none yet.
    pub fn of(columns: Vec<String>) -> Self {
        Self { values: vec![Vec::new(); columns.len()], columns, ..Self::default() }
    }

    /// Reads them all.
    pub fn read(path: &Path) -> Result<Self, Problem> {
        let mut table = Table::open(path, &[TIME[0], TIME[1], TIME[2], "external_work"])?;
        let mut found = Self::of(table.columns[3..].to_vec());
        while table.row()?.is_some() {
            let numbers = table.numbers(0)?;
            found.numbers.push([numbers[0] as usize, numbers[1] as usize]);
            found.times.push(numbers[2]);
            for (column, number) in found.values.iter_mut().zip(&numbers[3..]) {
                column.push(*number);
            }
        }
        Ok(found)
    }

    /// Cuts what a job that was killed wrote beyond its last whole increment.
    pub fn shorten(&mut self, length: usize) {
        self.values.iter_mut().for_each(|column| column.truncate(length));
    }

    /// The values of an energy.
    pub fn column(&self, name: &str) -> Option<&[f64]> {
        let place = self.columns.iter().position(|column| column == name)?;
        self.values.get(place).map(Vec::as_slice)
    }

    /// The last value of an energy.
    pub fn last(&self, name: &str) -> Option<f64> {
        let place = self.columns.iter().position(|column| column == name)?;
        self.values[place].last().copied()
    }
}
