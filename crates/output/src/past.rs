//! What a run that goes on from a saved state has already told: read back
//! from its files, digit by digit what was written.

use crate::job::JobFiles;
use crate::pair::columns;
use crate::reading::history::History;
use crate::reading::problem::Problem;
use crate::reading::table::Table;
use slideline_mech::axes::PLAIN;
use slideline_model::{Dof, Model, NodeIndex};
use slideline_solve::observe::PairRow;

/// Curves and pairs of the increments before the saved state.
#[derive(Clone, Debug, Default)]
pub struct Past {
    history: History,
    /// A row for every pair in every increment.
    pub pairs: Vec<Vec<PairRow>>,
    /// The slave node that carries most, for every pair in every increment.
    pub carriers: Vec<Vec<Option<NodeIndex>>>,
}

impl Past {
    /// Reads the first `increments` of a job.
    ///
    /// # Errors
    /// A file that is missing or cannot be read as one of this job.
    pub fn read(job: &JobFiles, model: &Model, increments: usize) -> Result<Self, Problem> {
        let mut history = History::read(&job.path(".history.csv"), |_| true)?;
        history.shorten(increments);
        let (pairs, numbers) = pairs(job, model, increments)?;
        let carriers = carriers(job, model, &numbers)?;
        Ok(Self { history, pairs, carriers })
    }

    /// Motion and reaction of a node over the increments, along its own axes where it has any.
    pub fn curve(&self, model: &Model, node: NodeIndex, dof: Dof) -> Option<[Vec<f64>; 2]> {
        let (first, place) = if dof.is_rotation() { (Dof::UR1, 3) } else { (Dof::U1, 0) };
        let axis = model.axes_of(node).unwrap_or(PLAIN)[dof as usize - first as usize];
        let label = model.nodes.label(node);
        let mut both = [Vec::new(), Vec::new()];
        for (&own, part) in Dof::ALL[place..].iter().zip(axis).filter(|(_, part)| *part != 0.0) {
            for (name, sum) in [own.name(), own.reaction_name()].into_iter().zip(&mut both) {
                let column = self.history.column(label, name)?;
                sum.resize(column.len(), 0.0);
                sum.iter_mut().zip(column).for_each(|(sum, value)| *sum += part * value);
            }
        }
        Some(both)
    }
}

/// Step and increment as the files have them.
type Number = [String; 2];

fn pairs(
    job: &JobFiles,
    model: &Model,
    increments: usize,
) -> Result<(Vec<Vec<PairRow>>, Vec<Number>), Problem> {
    let count = model.contact_pairs.len();
    let expected: Vec<&str> =
        ["step", "increment", "time", "pair"].into_iter().chain(columns(model)).collect();
    let mut table = Table::open(&job.path(".pair.csv"), &expected)?;
    let (mut all, mut numbers) = (Vec::new(), Vec::new());
    while all.len() < increments && count > 0 {
        let mut rows = Vec::with_capacity(count);
        while rows.len() < count {
            if table.row()?.is_none() {
                return Ok((all, numbers));
            }
            if rows.is_empty() {
                numbers.push([0, 1].map(|index| table.cell(index).to_owned()));
            }
            rows.push(row(&table, model)?);
        }
        all.push(rows);
    }
    Ok((all, numbers))
}

/// Which node carries most, of every pair in the increments of these numbers:
/// the largest pressure times area, the first one where two carry alike.
fn carriers(
    job: &JobFiles,
    model: &Model,
    numbers: &[Number],
) -> Result<Vec<Vec<Option<NodeIndex>>>, Problem> {
    let count = model.contact_pairs.len();
    let mut found = vec![vec![None; count]; numbers.len()];
    if numbers.is_empty() {
        return Ok(found);
    }
    let start = ["step", "increment", "time", "pair", "node", "status"];
    let mut table = Table::open(&job.path(".contact.csv"), &start)?;
    let (pressure, area) = (table.index("CPRESS"), table.index("area"));
    let (mut now, mut most) = (0, vec![0.0; count]);
    while table.row()?.is_some() {
        let own = |number: &Number| [0, 1].iter().all(|&k| number[k] == table.cell(k));
        while now < numbers.len() && !own(&numbers[now]) {
            now += 1;
            most.fill(0.0);
        }
        let pair = model.contact_pairs.iter().position(|pair| pair.name == table.cell(3));
        let node = table.cell(4).parse().ok().and_then(|label| model.nodes.find(label));
        let (Some(pair), Some(pressure), Some(into)) = (pair, pressure, found.get_mut(now)) else {
            continue;
        };
        let area = area.map_or(Ok(1.0), |area| table.number(area))?;
        let force = table.number::<f64>(pressure)? * area;
        if force > most[pair] {
            (most[pair], into[pair]) = (force, node);
        }
    }
    Ok(found)
}

fn row(table: &Table, model: &Model) -> Result<PairRow, Problem> {
    let number = |index| table.number(index);
    let node = |index| table.cell(index).parse().ok().and_then(|label| model.nodes.find(label));
    let (force, moment, next, unseen) = match model.is_in_space() {
        true => {
            ([number(8)?, number(9)?, number(10)?], [number(11)?, number(12)?, number(13)?], 14, 23)
        }
        false => ([number(8)?, number(9)?, 0.0], [0.0, 0.0, number(10)?], 11, 18),
    };
    Ok(PairRow {
        closed: table.number(4)?,
        changes: table.number(5)?,
        penetration: number(6)?,
        deepest: node(7),
        force,
        moment,
        force_imbalance: number(next)?,
        moment_imbalance: number(next + 1)?,
        area: number(next + 2)?,
        unseen_depth: number(unseen)?,
        unseen: node(unseen + 1),
        falls_away: number(unseen + 2)?,
        smoothed_away: number(unseen + 3)?,
        approach: number(unseen + 4)?,
        ..PairRow::default()
    })
}
