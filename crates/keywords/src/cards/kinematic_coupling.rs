//! `*KINEMATIC COUPLING`: nodes that follow a reference node rigidly.

use slideline_deck::DataLine;
use slideline_model::Dof;

use crate::constraints::{Coupling, CouplingKind, Points};
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*KINEMATIC COUPLING`.
pub(crate) struct KinematicCoupling;

impl Keyword for KinematicCoupling {
    fn name(&self) -> &'static str {
        "KINEMATIC COUPLING"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::required("REF NODE")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Links
    }

    fn page(&self) -> &'static str {
        page!("KINEMATIC-COUPLING")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if card.first_line("node or set, first dof, last dof", &mut draft.log).is_none() {
            return;
        }
        let Some(reference) = super::rigid_body::node(card, "REF NODE", draft) else { return };
        for line in card.data() {
            let Some((points, dofs)) = line_of(line, draft) else { continue };
            draft.couplings.push(Coupling {
                reference: reference.clone(),
                of_element: false,
                reference_span: card.span_of("REF NODE"),
                points: vec![points],
                kind: CouplingKind::Kinematic(dofs),
                within: None,
                axes: None,
                origin: line.span,
            });
        }
    }
}

/// Node or set, and the dofs that follow: all where none is given.
fn line_of(line: &DataLine, draft: &mut Draft) -> Option<(Points, [bool; 6])> {
    draft.log.at_most(line, 3);
    let target = draft.log.target(line, 0, "the node or set")?;
    let points = Points::Nodes { target, span: line.fields[0].span, weight: 1.0 };
    if line.field(1).is_none() {
        return Some((points, [true; 6]));
    }
    let range = draft.dof_range(line, 1)?;
    Some((points, Dof::ALL.map(|dof| range.contains(&dof))))
}
