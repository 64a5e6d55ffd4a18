//! `JOB.energy.csv`: where the work went, a row per converged increment.

use crate::rows::{Rows, Sheet};
use slideline_solve::observe::{Frame, StepReport};

/// `JOB.energy.csv`.
#[derive(Default)]
pub(crate) struct Energy {
    /// Whether contact may be stabilised: one more column.
    stabilised: bool,
}

impl Rows for Energy {
    const ENDING: &'static str = ".energy.csv";

    fn columns(&mut self, report: &StepReport<'_>) -> Option<String> {
        self.stabilised = report.may_stabilise();
        let more = if self.stabilised { ",stabilisation" } else { "" };
        Some(format!(
            "external_work,strain_energy,contact_energy,friction_dissipation,friction_elastic,\
             dropped_friction,balance{more},released_energy"
        ))
    }

    fn rows(&self, sheet: &mut Sheet<'_>, frame: &Frame<'_>) {
        let energy = &frame.energy;
        sheet.row().numbers([
            energy.external_work,
            energy.strain_energy,
            energy.contact_energy,
            energy.friction_dissipation,
            energy.friction_elastic,
            energy.dropped_friction,
            energy.balance,
        ]);
        sheet.numbers(self.stabilised.then_some(energy.stabilisation));
        sheet.numbers([energy.released_energy]).end();
    }
}
