//! `*DISTRIBUTING`: the reference node of a coupling follows the mean of the nodes.

use crate::constraints::{CouplingKind, Fading};
use crate::draft::{Draft, Owner};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*DISTRIBUTING`.
pub(crate) struct Distributing;

impl Keyword for Distributing {
    fn name(&self) -> &'static str {
        "DISTRIBUTING"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::value("WEIGHTING METHOD"), Rule::value("COUPLING")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Links
    }

    fn is_suboption(&self) -> bool {
        true
    }

    fn page(&self) -> &'static str {
        page!("DISTRIBUTING")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let methods = &["UNIFORM", "LINEAR", "QUADRATIC", "CUBIC"];
        let fading = match card.choice("WEIGHTING METHOD", methods, &mut draft.log) {
            Some("LINEAR") => Fading::Linear,
            Some("QUADRATIC") => Fading::Quadratic,
            Some("CUBIC") => Fading::Cubic,
            _ => Fading::Uniform,
        };
        card.choice("COUPLING", &["CONTINUUM", "STRUCTURAL"], &mut draft.log);
        let dofs = super::kinematic::dofs(card, draft);
        match draft.owner {
            Owner::Coupling(index) => {
                if let Some(coupling) = draft.couplings.get_mut(index) {
                    coupling.kind = CouplingKind::Distributing(dofs, fading);
                }
            }
            _ => draft.orphan(self.name(), "COUPLING", card.span()),
        }
    }
}
