//! `*MASS`: the masses of points, which weigh.
//!
//! ```text
//!     o m          |
//!     |            v GRAV: m g on the node
//!   --+--
//! ```

use crate::draft::{Draft, PointMass};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*MASS`.
pub(crate) struct Mass;

impl Keyword for Mass {
    fn name(&self) -> &'static str {
        "MASS"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::required("ELSET"), Rule::value("TYPE")];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        // damping
        &["ALPHA", "COMPOSITE"]
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Sections
    }

    fn page(&self) -> &'static str {
        page!("MASS")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        card.choice("TYPE", &["ISOTROPIC"], &mut draft.log);
        let Some(set) = card.name("ELSET") else { return };
        let Some(line) = card.only_line("the mass", &mut draft.log) else { return };
        draft.log.at_most(line, 1);
        let Some(mass) = draft.log.number(line, 0, "the mass") else { return };
        if mass < 0.0 {
            let message = format!("a mass must not be negative, and {mass} is");
            draft.log.error("SL0234", message, line.span);
            return;
        }
        let (set_span, origin) = (card.span_of("ELSET"), card.span());
        draft.masses.push(PointMass { set, set_span, mass, origin });
    }
}
