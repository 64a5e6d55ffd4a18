//! `*PLANAR TEST DATA`: a sheet pulled along one direction and held along another: pure shear.

use slideline_mech::material::hyperelastic::Mode;

use crate::draft::{Draft, Kind};
use crate::keyword::{Keyword, Level, Subject};
use crate::reading::Reading;
use crate::test_data;

/// `*PLANAR TEST DATA`.
pub(crate) struct PlanarTestData;

impl Keyword for PlanarTestData {
    fn name(&self) -> &'static str {
        "PLANAR TEST DATA"
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
        page!("PLANAR-TEST-DATA")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        test_data::read(Kind::Mode(Mode::Planar), card, draft);
    }
}
