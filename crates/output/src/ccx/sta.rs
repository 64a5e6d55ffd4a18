//! `JOB.sta` of ccx: a line for each attempt of an increment.

use crate::file::{Growing, WriteError};
use crate::fortran::push_fortran;
use crate::job::JobFiles;
use crate::kept::Kept;
use crate::writer::Writer;
use slideline_solve::observe::{AttemptReport, Event, Frame};
use std::fmt::Write as _;

/// Writes `JOB.sta` in the columns of ccx.
pub(crate) struct Sta {
    job: JobFiles,
    file: Option<Growing>,
}

const HEADER: &str = "\
SUMMARY OF JOB INFORMATION
  STEP      INC     ATT  ITRS     TOT TIME     STEP TIME      INC TIME
";

/// One attempt of an increment.
struct Line {
    step: usize,
    increment: usize,
    attempt: usize,
    /// Behind the attempt: `U` where it was given up.
    mark: char,
    iterations: usize,
    /// Total time, time in the step and increment [T].
    times: [f64; 3],
}

impl Line {
    fn of_increment(own: &Frame<'_>) -> Self {
        Self {
            step: own.step,
            increment: own.increment,
            attempt: own.attempt,
            mark: ' ',
            iterations: own.severe_iterations + own.equilibrium_iterations,
            times: [own.total_time, own.step_time, own.time_increment],
        }
    }

    fn of_attempt(own: &AttemptReport) -> Self {
        Self {
            step: own.step,
            increment: own.increment,
            attempt: own.attempt,
            mark: 'U',
            iterations: own.severe_iterations + own.equilibrium_iterations,
            times: [own.total_time, own.step_time, own.time_increment],
        }
    }

    fn push(&self, text: &mut String) {
        let Self { step, increment, attempt, mark, iterations, times } = self;
        // a String takes any text
        let _ = write!(text, "{step:>6}{increment:>11}{attempt:>6}{mark}{iterations:>5}");
        for &time in times {
            text.push(' ');
            push_fortran(text, time, 6);
        }
        text.push('\n');
    }
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
        line.push(&mut file.text);
        file.flush()
    }
}

impl Writer for Sta {
    fn event(&mut self, event: &Event<'_>) -> Result<(), WriteError> {
        match event {
            Event::StepBegin(_) => self.begin(),
            Event::Committed(own) => self.line(&Line::of_increment(own)),
            Event::AttemptFailed(own) => self.line(&Line::of_attempt(own)),
            _ => Ok(()),
        }
    }

    fn keep(&self, kept: &mut Kept) {
        kept.file(".sta", self.file.as_ref());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: the columns of ccx. Source: the second line is one that ccx 2.20 wrote for its
    /// test deck contact2, step 2.
    #[test]
    fn a_line_has_the_columns_of_ccx() {
        let mut text = HEADER.to_owned();
        let times = [1.35, 0.35, 0.15];
        let mut line = Line { step: 2, increment: 3, attempt: 1, mark: ' ', iterations: 2, times };
        line.push(&mut text);
        line.mark = 'U';
        line.push(&mut text);
        let rows: Vec<&str> = text.lines().skip(2).collect();
        assert_eq!(
            rows[0],
            "     2          3     1     2  0.135000E+01  0.350000E+00  0.150000E+00"
        );
        assert_eq!(
            rows[1],
            "     2          3     1U    2  0.135000E+01  0.350000E+00  0.150000E+00"
        );
    }
}
