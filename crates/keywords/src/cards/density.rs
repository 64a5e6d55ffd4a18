//! `*DENSITY`: mass per volume, for gravity and centrifugal loads.

use crate::draft::{Draft, Table};
use crate::keyword::{Keyword, Level, Subject};
use crate::reading::Reading;

/// `*DENSITY`.
pub(crate) struct Density;

impl Keyword for Density {
    fn name(&self) -> &'static str {
        "DENSITY"
    }

    fn without_effect(&self) -> &'static [&'static str] {
        &["DEPENDENCIES"]
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Properties
    }

    fn is_suboption(&self) -> bool {
        true
    }

    fn page(&self) -> &'static str {
        page!("DENSITY")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let density = table(card, draft);
        let own = (self.name(), card.span());
        draft.give_material(own, |material| &mut material.density, density);
    }
}

/// Temperatures and densities, of which one line has none; of other dependencies the first line.
fn table(card: &Reading<'_>, draft: &mut Draft) -> Option<Table<f64>> {
    card.first_line("the density", &mut draft.log)?;
    let lines = if card.has("DEPENDENCIES") { &card.data()[..1] } else { card.data() };
    let mut table: Table<f64> = Vec::with_capacity(lines.len());
    for line in lines {
        let density = draft.log.number(line, 0, "the density")?;
        if density < 0.0 {
            draft.log.error("SL0234", "the density must not be negative", line.span);
            return None;
        }
        let temperature = match lines.len() {
            1 => 0.0,
            _ => draft.log.number_or(line, 1, 0.0)?,
        };
        if !draft.log.ascends(table.last().map(|last| last.0), temperature, line, 1) {
            return None;
        }
        table.push((temperature, density));
    }
    Some(table)
}
