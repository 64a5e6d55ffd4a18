//! `JOB.sta`: one line an increment as it ends.
//!
//! ```text
//!  STEP   INC   ATT SEVERE-DISCON-ITERS EQUIL-ITERS TOTAL-ITERS    TOTAL-TIME ...
//!     1     3    1U                   2           9          11          0.15 ...
//!     1     3     2                   0           5           5        0.1125 ...
//! ```

use crate::file::{Growing, WriteError};
use crate::job::JobFiles;
use crate::kept::Kept;
use crate::number::general;
use crate::writer::Writer;
use slideline_solve::observe::Event;
use std::fmt::Write as _;

/// Writes `JOB.sta`.
pub(crate) struct Sta {
    job: JobFiles,
    file: Option<Growing>,
}

impl Sta {
    pub fn new(job: &JobFiles) -> Self {
        Self { job: job.clone(), file: None }
    }

    fn begin(&mut self) -> Result<(), WriteError> {
        if self.file.is_none() {
            self.file = Some(self.job.begin(".sta", HEADER)?);
        }
        Ok(())
    }

    /// A line of an attempt: step, increment and its number; severe and equilibrium
    /// iterations; total time, step time, increment.
    fn line(
        &mut self,
        [step, increment, attempt]: [usize; 3],
        mark: &str,
        [severe, equilibrium]: [usize; 2],
        times: [f64; 3],
    ) -> Result<(), WriteError> {
        let Some(file) = &mut self.file else { return Ok(()) };
        let (attempt, all) = (format!("{attempt}{mark}"), severe + equilibrium);
        let [total_time, step_time, increment_time] = times.map(|time| general(time, 6));
        line!(
            file.text,
            "{step:>5} {increment:>5} {attempt:>5} {severe:>19} {equilibrium:>11} {all:>11} \
             {total_time:>13} {step_time:>13} {increment_time:>13}"
        );
        file.flush()
    }
}

const HEADER: &str = concat!(
    " STEP   INC   ATT SEVERE-DISCON-ITERS EQUIL-ITERS TOTAL-ITERS",
    "    TOTAL-TIME     STEP-TIME      INC-TIME\n",
);

impl Writer for Sta {
    fn event(&mut self, event: &Event<'_>) -> Result<(), WriteError> {
        match event {
            Event::StepBegin(_) => self.begin(),
            Event::Committed(own) => self.line(
                [own.step, own.increment, own.attempt],
                "",
                [own.severe_iterations, own.equilibrium_iterations],
                [own.total_time, own.step_time, own.time_increment],
            ),
            Event::AttemptFailed(own) => self.line(
                [own.step, own.increment, own.attempt],
                "U",
                [own.severe_iterations, own.equilibrium_iterations],
                [own.total_time, own.step_time, own.time_increment],
            ),
            _ => Ok(()),
        }
    }

    fn keep(&self, kept: &mut Kept) {
        kept.file(".sta", self.file.as_ref());
    }
}
