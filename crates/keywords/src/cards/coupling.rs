//! `*COUPLING`: nodes of a surface and a reference node.

use crate::constraints::{Coupling as Draught, CouplingKind, Points};
use crate::draft::{Draft, Owner};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::surfaces::Named;

/// `*COUPLING`.
pub(crate) struct Coupling;

impl Keyword for Coupling {
    fn name(&self) -> &'static str {
        "COUPLING"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::required("REF NODE"),
            Rule::required("SURFACE"),
            Rule::value("CONSTRAINT NAME"),
            Rule::value("INFLUENCE RADIUS"),
            Rule::value("ORIENTATION"),
        ];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        &["ALPHA"]
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Links
    }

    fn page(&self) -> &'static str {
        page!("COUPLING")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 0, self.name());
        draft.owner = Owner::Broken;
        let Some(within) = card.number("INFLUENCE RADIUS", &mut draft.log) else { return };
        if within.is_some_and(|radius| radius <= 0.0) {
            let span = card.span_of("INFLUENCE RADIUS");
            draft.log.error("SL0210", "INFLUENCE RADIUS must be positive", span);
            return;
        }
        let Some(reference) = super::rigid_body::node(card, "REF NODE", draft) else { return };
        let Some(name) = card.name("SURFACE") else { return };
        draft.owner = Owner::Coupling(draft.couplings.len());
        draft.couplings.push(Draught {
            reference,
            of_element: false,
            reference_span: card.span_of("REF NODE"),
            points: vec![Points::Surface(Named { name, span: card.span_of("SURFACE") })],
            kind: CouplingKind::Open,
            within,
            axes: card.name("ORIENTATION").map(|name| (name, card.span_of("ORIENTATION"))),
            origin: card.span(),
        });
    }
}
