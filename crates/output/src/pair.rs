//! `JOB.pair.csv`: what each contact pair carries and whether it balances, a
//! row per pair and converged increment.

use crate::contact::push_name;
use crate::file::{Growing, WriteError};
use crate::history::push_time;
use crate::job::JobFiles;
use crate::number::push_shortest;
use crate::restart::Kept;
use crate::writers::Writer;
use slideline_model::ContactPair;
use slideline_solve::observe::{Event, Frame, PairRow};
use std::fmt::Write as _;

/// Columns behind step, increment, time and pair.
pub(crate) const COLUMNS: [&str; 9] = [
    "closed",
    "changes",
    "penetration",
    "deepest_node",
    "force_x",
    "force_y",
    "moment",
    "force_imbalance",
    "moment_imbalance",
];

/// Writes `JOB.pair.csv`.
pub(crate) struct Pairs {
    job: JobFiles,
    file: Option<Growing>,
}

impl Pairs {
    pub fn new(job: &JobFiles) -> Self {
        Self { job: job.clone(), file: None }
    }

    fn begin(&mut self) -> Result<(), WriteError> {
        if self.file.is_none() {
            let heading = format!("step,increment,time,pair,{}\n", COLUMNS.join(","));
            self.file = Some(Growing::begin(&self.job, ".pair.csv", &heading)?);
        }
        Ok(())
    }

    fn rows(&mut self, frame: &Frame<'_>) -> Result<(), WriteError> {
        let Some(file) = &mut self.file else { return Ok(()) };
        for (pair, row) in frame.model.contact_pairs.iter().zip(frame.pairs) {
            push_row(&mut file.text, frame, pair, row);
        }
        file.flush()
    }
}

fn push_row(text: &mut String, frame: &Frame<'_>, pair: &ContactPair, row: &PairRow) {
    push_time(text, frame);
    push_name(text, &pair.name);
    // A String takes any text.
    let _ = write!(text, ",{},{},", row.closed, row.changes);
    push_shortest(text, row.penetration);
    text.push(',');
    if let Some(node) = row.deepest {
        let _ = write!(text, "{}", frame.model.nodes.label(node)); // as above
    }
    let [x, y] = row.force;
    for value in [x, y, row.moment, row.force_imbalance, row.moment_imbalance] {
        text.push(',');
        push_shortest(text, value);
    }
    text.push('\n');
}

impl Writer for Pairs {
    fn event(&mut self, event: &Event<'_>) -> Result<(), WriteError> {
        match event {
            Event::StepBegin(_) => self.begin(),
            Event::Committed(frame) => self.rows(frame),
            _ => Ok(()),
        }
    }

    fn keep(&self, kept: &mut Kept) {
        kept.file(".pair.csv", self.file.as_ref());
    }
}
