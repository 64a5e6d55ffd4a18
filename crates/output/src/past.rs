//! What a run that goes on from a saved state has already told: read back
//! from its files, digit by digit what was written.

use crate::job::JobFiles;
use crate::pair::COLUMNS;
use crate::report::table::Table;
use crate::report::{History, Problem};
use slideline_model::{Dof, Model, NodeIndex};
use slideline_solve::observe::PairRow;

/// Curves and pairs of the increments before the saved state.
#[derive(Clone, Debug, Default)]
pub struct Past {
    history: History,
    /// A row for every pair in every increment.
    pub pairs: Vec<Vec<PairRow>>,
}

impl Past {
    /// Reads the first `increments` of a job.
    ///
    /// # Errors
    /// A file that is missing or cannot be read as one of this job.
    pub fn read(job: &JobFiles, model: &Model, increments: usize) -> Result<Self, Problem> {
        let mut history = History::read(&job.path(".history.csv"), |_| true)?;
        history.shorten(increments);
        let pairs = pairs(job, model, increments)?;
        Ok(Self { history, pairs })
    }

    /// Motion and reaction of a dof over the increments.
    pub fn curve(&self, label: u64, dof: Dof) -> Option<(&[f64], &[f64])> {
        let column = |name| self.history.column(label, name);
        Some((column(dof.name())?, column(dof.reaction_name())?))
    }
}

fn pairs(job: &JobFiles, model: &Model, increments: usize) -> Result<Vec<Vec<PairRow>>, Problem> {
    let count = model.contact_pairs.len();
    let expected: Vec<&str> =
        ["step", "increment", "time", "pair"].into_iter().chain(COLUMNS).collect();
    let mut table = Table::open(&job.path(".pair.csv"), &expected)?;
    let mut all = Vec::new();
    while all.len() < increments && count > 0 {
        let mut rows = Vec::with_capacity(count);
        while rows.len() < count {
            let Some(cells) = table.row()? else { return Ok(all) };
            let deepest = cells[7].parse().ok().and_then(|label| model.nodes.find(label));
            rows.push(row(&table, deepest)?);
        }
        all.push(rows);
    }
    Ok(all)
}

fn row(table: &Table, deepest: Option<NodeIndex>) -> Result<PairRow, Problem> {
    let number = |place| table.number(place);
    Ok(PairRow {
        closed: number(4)? as usize,
        changes: number(5)? as usize,
        penetration: number(6)?,
        deepest,
        force: [number(8)?, number(9)?],
        moment: number(10)?,
        force_imbalance: number(11)?,
        moment_imbalance: number(12)?,
    })
}
