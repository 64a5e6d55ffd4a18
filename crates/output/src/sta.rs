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
use slideline_solve::observe::{AttemptReport, Event, Frame};
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

    fn line(&mut self, line: &Line) -> Result<(), WriteError> {
        let Some(file) = &mut self.file else { return Ok(()) };
        let attempt = format!("{}{}", line.attempt, if line.failed { "U" } else { "" });
        let [severe, equilibrium] = line.iterations;
        let [total_time, step_time, increment_time] = line.times.map(|time| general(time, 6));
        // A String takes any text.
        let _ = writeln!(
            file.text,
            "{:>5} {:>5} {attempt:>5} {severe:>19} {equilibrium:>11} {:>11} {total_time:>13} {step_time:>13} {increment_time:>13}",
            line.step,
            line.increment,
            severe + equilibrium,
        );
        file.flush()
    }
}

const HEADER: &str = concat!(
    " STEP   INC   ATT SEVERE-DISCON-ITERS EQUIL-ITERS TOTAL-ITERS",
    "    TOTAL-TIME     STEP-TIME      INC-TIME\n",
);

struct Line {
    step: usize,
    increment: usize,
    attempt: usize,
    failed: bool,
    iterations: [usize; 2],
    times: [f64; 3],
}

impl From<&Frame<'_>> for Line {
    fn from(frame: &Frame<'_>) -> Self {
        Self {
            step: frame.step,
            increment: frame.increment,
            attempt: frame.attempt,
            failed: false,
            iterations: [frame.severe_iterations, frame.equilibrium_iterations],
            times: [frame.total_time, frame.step_time, frame.time_increment],
        }
    }
}

impl From<&AttemptReport> for Line {
    fn from(attempt: &AttemptReport) -> Self {
        Self {
            step: attempt.step,
            increment: attempt.increment,
            attempt: attempt.attempt,
            failed: true,
            iterations: [attempt.severe_iterations, attempt.equilibrium_iterations],
            times: [attempt.total_time, attempt.step_time, attempt.time_increment],
        }
    }
}

impl Writer for Sta {
    fn event(&mut self, event: &Event<'_>) -> Result<(), WriteError> {
        match event {
            Event::StepBegin(_) => self.begin(),
            Event::Committed(frame) => self.line(&Line::from(*frame)),
            Event::AttemptFailed(attempt) => self.line(&Line::from(*attempt)),
            _ => Ok(()),
        }
    }

    fn keep(&self, kept: &mut Kept) {
        kept.file(".sta", self.file.as_ref());
    }
}
