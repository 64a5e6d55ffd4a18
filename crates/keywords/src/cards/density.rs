//! `*DENSITY`: mass per volume, for gravity and centrifugal loads.

use crate::draft::Draft;
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
        let line = card.first_line("the density", &mut draft.log);
        let density = line.and_then(|line| draft.log.number(line, 0, "the density"));
        let density = density.filter(|&density| {
            let sound = density >= 0.0;
            if !sound {
                let span = card.data().first().map_or(card.span(), |line| line.span);
                draft.log.error("SL0234", "the density must not be negative", span);
            }
            sound
        });
        let own = (self.name(), card.span());
        draft.give_material(own, |material| &mut material.density, density);
    }
}
