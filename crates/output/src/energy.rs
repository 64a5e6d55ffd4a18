//! `JOB.energy.csv`: where the work went, a row per converged increment.

use crate::file::{Growing, WriteError};
use crate::history::push_time;
use crate::job::JobFiles;
use crate::number::push_shortest;
use crate::restart::Kept;
use crate::writers::Writer;
use slideline_solve::observe::{Event, Frame};

/// Writes `JOB.energy.csv`.
pub(crate) struct Energy {
    job: JobFiles,
    file: Option<Growing>,
}

const HEADER: &str = concat!(
    "step,increment,time,external_work,strain_energy,contact_energy,",
    "friction_dissipation,friction_elastic,dropped_friction,balance\n",
);

impl Energy {
    pub fn new(job: &JobFiles) -> Self {
        Self { job: job.clone(), file: None }
    }

    fn begin(&mut self) -> Result<(), WriteError> {
        if self.file.is_none() {
            self.file = Some(Growing::begin(&self.job, ".energy.csv", HEADER)?);
        }
        Ok(())
    }

    fn row(&mut self, frame: &Frame<'_>) -> Result<(), WriteError> {
        let Some(file) = &mut self.file else { return Ok(()) };
        let energy = &frame.energy;
        push_time(&mut file.text, frame);
        let values = [
            energy.external_work,
            energy.strain_energy,
            energy.contact_energy,
            energy.friction_dissipation,
            energy.friction_elastic,
            energy.dropped_friction,
            energy.balance,
        ];
        for (place, value) in values.into_iter().enumerate() {
            if place > 0 {
                file.text.push(',');
            }
            push_shortest(&mut file.text, value);
        }
        file.text.push('\n');
        file.flush()
    }
}

impl Writer for Energy {
    fn event(&mut self, event: &Event<'_>) -> Result<(), WriteError> {
        match event {
            Event::StepBegin(_) => self.begin(),
            Event::Committed(frame) => self.row(frame),
            _ => Ok(()),
        }
    }

    fn keep(&self, kept: &mut Kept) {
        kept.file(".energy.csv", self.file.as_ref());
    }
}
