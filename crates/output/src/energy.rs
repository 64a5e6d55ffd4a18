//! `JOB.energy.csv`: where the work went, a row per converged increment.

use crate::file::{Growing, WriteError};
use crate::history::push_time;
use crate::job::JobFiles;
use crate::number::push_shortest;
use crate::restart::Kept;
use crate::writers::Writer;
use slideline_solve::observe::{Event, Frame, StepReport};

/// Writes `JOB.energy.csv`.
pub(crate) struct Energy {
    job: JobFiles,
    file: Option<Growing>,
    /// Whether contact may be stabilised: one more column.
    stabilised: bool,
}

const HEADER: &str = concat!(
    "step,increment,time,external_work,strain_energy,contact_energy,",
    "friction_dissipation,friction_elastic,dropped_friction,balance",
);

impl Energy {
    pub fn new(job: &JobFiles) -> Self {
        Self { job: job.clone(), file: None, stabilised: false }
    }

    fn begin(&mut self, report: &StepReport<'_>) -> Result<(), WriteError> {
        if self.file.is_none() {
            self.stabilised = report.may_stabilise;
            let more = if self.stabilised { ",stabilisation" } else { "" };
            let header = format!("{HEADER}{more},released_energy\n");
            self.file = Some(Growing::begin(&self.job, ".energy.csv", &header)?);
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
        if self.stabilised {
            file.text.push(',');
            push_shortest(&mut file.text, energy.stabilisation);
        }
        file.text.push(',');
        push_shortest(&mut file.text, energy.released_energy);
        file.text.push('\n');
        file.flush()
    }
}

impl Writer for Energy {
    fn event(&mut self, event: &Event<'_>) -> Result<(), WriteError> {
        match event {
            Event::StepBegin(report) => self.begin(report),
            Event::Committed(frame) => self.row(frame),
            _ => Ok(()),
        }
    }

    fn keep(&self, kept: &mut Kept) {
        kept.file(".energy.csv", self.file.as_ref());
    }
}
