//! `*NODAL THICKNESS`: thickness of plane solids by their nodes.

use slideline_model::Dialect;

use crate::draft::{Draft, NodalThickness as Line};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*NODAL THICKNESS`.
pub(crate) struct NodalThickness;

impl Keyword for NodalThickness {
    fn name(&self) -> &'static str {
        "NODAL THICKNESS"
    }

    fn parameters(&self) -> &'static [Rule] {
        &[]
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Sections
    }

    fn page(&self) -> &'static str {
        page!("NODAL-THICKNESS")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if draft.dialect == Dialect::Abaqus {
            let message = "*NODAL THICKNESS has no effect here: Abaqus gives it to shells alone";
            draft.log.note("SL0257", message, card.span());
            return;
        }
        for line in card.data() {
            draft.log.at_most(line, 2);
            let target = draft.log.target(line, 0, "the node or set");
            let thickness = draft.log.number(line, 1, "the thickness");
            let Some((target, thickness)) = target.zip(thickness) else { continue };
            if thickness <= 0.0 {
                let message = "the thickness at a node must be positive";
                draft.log.error("SL0210", message, line.fields[1].span);
                continue;
            }
            let (target_span, origin) = (line.fields[0].span, line.span);
            draft.thicknesses.push(Line { target, target_span, thickness, origin });
        }
    }
}
