//! `JOB.cvg` of ccx: a line for each iteration, which programs show while a run goes on.

use crate::facts::Formats;
use crate::file::{Growing, WriteError};
use crate::fortran::push_fortran;
use crate::job::JobFiles;
use crate::kept::Kept;
use crate::writer::Writer;
use slideline_solve::observe::{Event, FieldReport, IterationReport};
use std::fmt::Write as _;

/// Writes `JOB.cvg`, where files are those of ccx.
pub(crate) struct Cvg {
    job: JobFiles,
    formats: Formats,
    file: Option<Growing>,
}

/// The third word is spelt so there.
const HEADER: &str = "\
SUMMARY OF C0NVERGENCE INFORMATION
  STEP   INC  ATT   ITER     CONT.   RESID.        CORR.      RESID.      CORR.
                              EL.    FORCE         DISP       FLUX        TEMP.
                              (#)     (%)           (%)        (%)         (%)
";

impl Cvg {
    pub fn new(job: &JobFiles, formats: Formats) -> Self {
        Self { job: job.clone(), formats, file: None }
    }

    fn begin(&mut self) -> Result<(), WriteError> {
        if self.formats == Formats::Ccx && self.file.is_none() {
            self.file = Some(self.job.begin(".cvg", HEADER)?);
        }
        Ok(())
    }

    fn iteration(&mut self, own: &IterationReport) -> Result<(), WriteError> {
        let Some(file) = &mut self.file else { return Ok(()) };
        push_iteration(&mut file.text, own);
        file.flush()
    }
}

/// Step, increment, attempt, iteration; closed contact points; residual force in per cent of the
/// average force, correction in per cent of the displacement of the increment; no heat flows.
fn push_iteration(text: &mut String, own: &IterationReport) {
    let IterationReport { step, increment, attempt, iteration, closed, .. } = own;
    // a String takes any text
    let _ = write!(text, "{step:>6}{increment:>6}{attempt:>6}{iteration:>6} {closed:>8}");
    let FieldReport { residual, average, correction, increment, .. } = own.force;
    for value in [per_cent(residual, average), per_cent(correction, increment), 0.0, 0.0] {
        text.push(' ');
        push_fortran(text, value, 4);
    }
    text.push('\n');
}

/// Nothing of nothing is nothing.
fn per_cent(part: f64, whole: f64) -> f64 {
    if whole == 0.0 { 0.0 } else { 100.0 * part / whole }
}

impl Writer for Cvg {
    fn event(&mut self, event: &Event<'_>) -> Result<(), WriteError> {
        match event {
            Event::StepBegin(_) => self.begin(),
            Event::Iteration(own) => self.iteration(own),
            _ => Ok(()),
        }
    }

    fn keep(&self, kept: &mut Kept) {
        kept.file(".cvg", self.file.as_ref());
    }
}
