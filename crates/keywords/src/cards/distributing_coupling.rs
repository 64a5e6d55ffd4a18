//! `*DISTRIBUTING COUPLING`: the node of a coupling element follows the weighted mean of nodes.

use slideline_deck::DataLine;

use crate::constraints::{Coupling, CouplingKind, Fading, Points};
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::log::Target;
use crate::reading::Reading;

/// `*DISTRIBUTING COUPLING`.
pub(crate) struct DistributingCoupling;

impl Keyword for DistributingCoupling {
    fn name(&self) -> &'static str {
        "DISTRIBUTING COUPLING"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::required("ELSET")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Links
    }

    fn page(&self) -> &'static str {
        page!("DISTRIBUTING-COUPLING")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if card.first_line("node or set, weight", &mut draft.log).is_none() {
            return;
        }
        let points = card.data().iter().filter_map(|line| points(line, draft)).collect();
        let Some(elements) = card.name("ELSET") else { return };
        draft.couplings.push(Coupling {
            reference: Target::Set(elements),
            of_element: true,
            reference_span: card.span_of("ELSET"),
            points,
            kind: CouplingKind::Distributing([true; 6], Fading::Uniform),
            within: None,
            axes: None,
            origin: card.span(),
        });
    }
}

fn points(line: &DataLine, draft: &mut Draft) -> Option<Points> {
    draft.log.at_most(line, 2);
    let target = draft.log.target(line, 0, "the node or set")?;
    let weight = draft.log.number_or(line, 1, 1.0)?;
    if weight <= 0.0 {
        draft.log.error("SL0210", "a weight must be positive", line.fields[1].span);
        return None;
    }
    Some(Points::Nodes { target, span: line.fields[0].span, weight })
}
