//! `*CENTROID`: where the centroid of a general section is.

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Subject};
use crate::reading::Reading;
use crate::section_places::{Place, read};

/// `*CENTROID`.
pub(crate) struct Centroid;

impl Keyword for Centroid {
    fn name(&self) -> &'static str {
        "CENTROID"
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
        page!("CENTROID")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        read((self.name(), card), Place::Centroid, draft);
    }
}
