//! `*DENSITY`: mass per volume, for gravity and centrifugal loads.

use crate::draft::{Draft, Owner};
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
        Subject::Sections
    }

    fn is_suboption(&self) -> bool {
        true
    }

    fn page(&self) -> &'static str {
        page!("DENSITY")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let Some(line) = card.first_line("the density", &mut draft.log) else { return };
        let Some(density) = draft.log.number(line, 0, "the density") else { return };
        match draft.owner {
            Owner::Material(index) => {
                if let Some(material) = draft.materials.get(index) {
                    let name = material.name.clone();
                    draft.densities.insert(name, density);
                }
            }
            _ => draft.orphan(self.name(), "MATERIAL", card.span()),
        }
    }
}
