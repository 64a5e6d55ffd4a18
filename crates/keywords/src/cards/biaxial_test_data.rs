//! `*BIAXIAL TEST DATA`: a specimen pulled or pressed along two directions alike.

use slideline_mech::material::hyperelastic::Mode;

use crate::draft::{Draft, Kind};
use crate::keyword::{Keyword, Level, Subject};
use crate::reading::Reading;
use crate::test_data;

/// `*BIAXIAL TEST DATA`.
pub(crate) struct BiaxialTestData;

impl Keyword for BiaxialTestData {
    fn name(&self) -> &'static str {
        "BIAXIAL TEST DATA"
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
        page!("BIAXIAL-TEST-DATA")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        test_data::read(Kind::Mode(Mode::Biaxial), card, draft);
    }
}
