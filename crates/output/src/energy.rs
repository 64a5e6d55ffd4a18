//! `JOB.energy.csv`: where the work went, a row per converged increment.

use crate::rows::{Rows, Sheet};
use slideline_model::Section;
use slideline_solve::observe::{Energies, Frame, StepReport};

/// What stands in a column [F L].
pub type EnergyOf = fn(&Energies) -> f64;
/// A column and what stands in it [F L].
pub(crate) type Column = (&'static str, EnergyOf);

/// All columns.
const ALL: [Column; 12] = [
    ("external_work", |energy| energy.external_work),
    ("strain_energy", |energy| energy.strain_energy),
    ("contact_energy", |energy| energy.contact_energy),
    ("friction_dissipation", |energy| energy.friction_dissipation),
    ("friction_elastic", |energy| energy.friction_elastic),
    ("dropped_friction", |energy| energy.dropped_friction),
    ("balance", |energy| energy.balance),
    ("stabilisation", |energy| energy.stabilisation),
    ("released_energy", |energy| energy.released_energy),
    ("removed_energy", |energy| energy.removed_energy),
    ("material_dissipation", |energy| energy.material_dissipation),
    ("thermal_work", |energy| energy.thermal_work),
];

/// The energy of a column of `JOB.energy.csv`.
pub fn energy_named(name: &str) -> Option<EnergyOf> {
    ALL.iter().find(|(known, _)| *known == name).map(|(_, of)| *of)
}

/// The columns of a run: contact stabilisation, what is removed, materials that do not give all back
/// and heat have one where they may act.
pub(crate) fn columns(report: &StepReport<'_>) -> Vec<Column> {
    let mut columns = ALL.to_vec();
    let takes = report.model.blocks.iter().any(|block| match &block.section {
        Section::Solid(section) => section.material.dissipates(),
        Section::Properties(_) => true,
        Section::Beam(_) | Section::Spring(_) => false,
    });
    columns.retain(|(name, _)| match *name {
        "material_dissipation" => takes,
        "stabilisation" => report.may_stabilise(),
        "removed_energy" => report.model.is_changed(),
        "thermal_work" => report.model.has_temperatures(),
        _ => true,
    });
    columns
}

/// `JOB.energy.csv`.
#[derive(Default)]
pub(crate) struct Energy(Vec<Column>);

impl Rows for Energy {
    fn ending(&self) -> &'static str {
        ".energy.csv"
    }

    fn columns(&mut self, report: &StepReport<'_>) -> Option<String> {
        self.0 = columns(report);
        Some(self.0.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(","))
    }

    fn rows(&self, sheet: &mut Sheet<'_>, frame: &Frame<'_>) {
        sheet.row().numbers(self.0.iter().map(|(_, value)| value(&frame.energy))).end();
    }
}
