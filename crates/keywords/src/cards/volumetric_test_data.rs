//! `*VOLUMETRIC TEST DATA`: a specimen under pressure on all sides.

use crate::draft::{Draft, Kind};
use crate::keyword::{Keyword, Level, Subject};
use crate::reading::Reading;
use crate::test_data;

/// `*VOLUMETRIC TEST DATA`.
pub(crate) struct VolumetricTestData;

impl Keyword for VolumetricTestData {
    fn name(&self) -> &'static str {
        "VOLUMETRIC TEST DATA"
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
        page!("VOLUMETRIC-TEST-DATA")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        test_data::read(Kind::Volume, card, draft);
    }
}
