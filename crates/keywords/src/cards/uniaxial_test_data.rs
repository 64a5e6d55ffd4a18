//! `*UNIAXIAL TEST DATA`: a specimen pulled or pressed along one direction.

use slideline_mech::material::hyperelastic::Mode;

use crate::draft::{Draft, Kind};
use crate::keyword::{Keyword, Level, Subject};
use crate::reading::Reading;
use crate::test_data;

/// `*UNIAXIAL TEST DATA`.
pub(crate) struct UniaxialTestData;

impl Keyword for UniaxialTestData {
    fn name(&self) -> &'static str {
        "UNIAXIAL TEST DATA"
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
        page!("UNIAXIAL-TEST-DATA")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        test_data::read(Kind::Mode(Mode::Uniaxial), card, draft);
    }
}
