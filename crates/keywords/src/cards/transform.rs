//! `*TRANSFORM`: axes of nodes.
//!
//! ```text
//!   TYPE=R  a on axis 1, b in the plane of 1 and 2     TYPE=C  a, b on the axis
//!   TYPE=S  a the centre, b on the polar axis
//! ```

use crate::axes::Transform as Axes;
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use slideline_model::System;

/// `*TRANSFORM`.
pub(crate) struct Transform;

impl Keyword for Transform {
    fn name(&self) -> &'static str {
        "TRANSFORM"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::required("NSET"), Rule::value("TYPE")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Links
    }

    fn page(&self) -> &'static str {
        page!("TRANSFORM")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let kind = card.choice("TYPE", &["R", "C", "S"], &mut draft.log);
        if card.has("TYPE") && kind.is_none() {
            return;
        }
        let Some(line) = card.only_line("the points a and b", &mut draft.log) else { return };
        draft.log.at_most(line, 6);
        let Some([a, b]) = draft.log.points(line) else { return };
        let (system, fault) = match kind {
            Some("C") => (System::cylindrical(a, b), "the points a and b of the axis coincide"),
            Some("S") => (System::spherical(a, b), "the points a and b of the polar axis coincide"),
            _ => (System::rectangular(a, b), "the directions to a and b are none, or the same"),
        };
        let Some(system) = system else {
            draft.log.error("SL0232", fault, line.span);
            return;
        };
        let Some(set) = card.name("NSET") else { return };
        let set_span = card.span_of("NSET");
        draft.transforms.push(Axes { set, set_span, system, origin: card.span() });
    }
}
