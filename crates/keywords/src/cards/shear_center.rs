//! `*SHEAR CENTER`: where the shear centre of a general section is.

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Subject};
use crate::reading::Reading;
use crate::section_places::{Place, read};

/// `*SHEAR CENTER`.
pub(crate) struct ShearCenter;

impl Keyword for ShearCenter {
    fn name(&self) -> &'static str {
        "SHEAR CENTER"
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
        page!("SHEAR-CENTER")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        read((self.name(), card), Place::ShearCenter, draft);
    }
}
