//! `JOB.sta`: one line an attempt of an increment as it ends.
//!
//! ```text
//!  STEP   INC   ATT SEVERE-DISCON-ITERS EQUIL-ITERS TOTAL-ITERS    TOTAL-TIME ...
//!     1     3    1U                   2           9          11          0.15 ...
//!     1     3     2                   0           5           5        0.1125 ...
//! ```

use crate::ccx;
use crate::facts::Formats;
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
    formats: Formats,
    file: Option<Growing>,
}

/// One attempt of an increment.
struct Attempt {
    /// Step, increment and number of the attempt.
    place: [usize; 3],
    /// It was given up.
    failed: bool,
    /// Severe and equilibrium iterations.
    iterations: [usize; 2],
    /// Total time, time in the step and increment [T].
    times: [f64; 3],
}

impl Attempt {
    fn of_increment(own: &Frame<'_>) -> Self {
        Self {
            place: [own.step, own.increment, own.attempt],
            failed: false,
            iterations: [own.severe_iterations, own.equilibrium_iterations],
            times: [own.total_time, own.step_time, own.time_increment],
        }
    }

    fn of_failed(own: &AttemptReport) -> Self {
        Self {
            place: [own.step, own.increment, own.attempt],
            failed: true,
            iterations: [own.severe_iterations, own.equilibrium_iterations],
            times: [own.total_time, own.step_time, own.time_increment],
        }
    }
}

const HEADER: &str = concat!(
    " STEP   INC   ATT SEVERE-DISCON-ITERS EQUIL-ITERS TOTAL-ITERS",
    "    TOTAL-TIME     STEP-TIME      INC-TIME\n",
);

fn push_attempt(text: &mut String, own: &Attempt) {
    let [step, increment, attempt] = own.place;
    let attempt = format!("{attempt}{}", if own.failed { "U" } else { "" });
    let [severe, equilibrium] = own.iterations;
    let all = severe + equilibrium;
    let [total_time, step_time, increment_time] = own.times.map(|time| general(time, 6));
    line!(
        text,
        "{step:>5} {increment:>5} {attempt:>5} {severe:>19} {equilibrium:>11} {all:>11} \
         {total_time:>13} {step_time:>13} {increment_time:>13}"
    );
}

impl Sta {
    pub fn new(job: &JobFiles, formats: Formats) -> Self {
        Self { job: job.clone(), formats, file: None }
    }

    fn begin(&mut self) -> Result<(), WriteError> {
        if self.file.is_none() {
            let header = match self.formats {
                Formats::Own => HEADER,
                Formats::Ccx => ccx::STA_HEADER,
            };
            self.file = Some(self.job.begin(".sta", header)?);
        }
        Ok(())
    }

    fn line(&mut self, own: &Attempt) -> Result<(), WriteError> {
        let Some(file) = &mut self.file else { return Ok(()) };
        match self.formats {
            Formats::Own => push_attempt(&mut file.text, own),
            Formats::Ccx => {
                let iterations = own.iterations.iter().sum();
                ccx::push_attempt(&mut file.text, own.place, own.failed, iterations, own.times);
            }
        }
        file.flush()
    }
}

impl Writer for Sta {
    fn event(&mut self, event: &Event<'_>) -> Result<(), WriteError> {
        match event {
            Event::StepBegin(_) => self.begin(),
            Event::Committed(own) => self.line(&Attempt::of_increment(own)),
            Event::AttemptFailed(own) => self.line(&Attempt::of_failed(own)),
            _ => Ok(()),
        }
    }

    fn keep(&self, kept: &mut Kept) {
        kept.file(".sta", self.file.as_ref());
    }
}
