//! `*TIE`: surfaces that stick together.

use slideline_deck::normalise;
use slideline_model::Dialect;

use crate::constraints::Tie as Draught;
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::surfaces::Named;

/// `*TIE`.
pub(crate) struct Tie;

impl Keyword for Tie {
    fn name(&self) -> &'static str {
        "TIE"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::value("NAME"),
            Rule::value("POSITION TOLERANCE"),
            Rule::value("ADJUST"),
            Rule::value("TYPE"),
        ];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        &["NO ROTATION", "NO THICKNESS", "CONSTRAINT RATIO"]
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Links
    }

    fn page(&self) -> &'static str {
        page!("TIE")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let kinds = &["SURFACE TO SURFACE", "NODE TO SURFACE"];
        let kind = card.choice("TYPE", kinds, &mut draft.log);
        let by_faces = match kind {
            Some(kind) => kind == "SURFACE TO SURFACE",
            None => draft.dialect != Dialect::Calculix,
        };
        let Some(tolerance) = card.number("POSITION TOLERANCE", &mut draft.log) else { return };
        if tolerance.is_some_and(|tolerance| tolerance < 0.0) {
            let message = "POSITION TOLERANCE is a distance: it must not be negative";
            draft.log.error("SL0210", message, card.span_of("POSITION TOLERANCE"));
            return;
        }
        let adjust = card.yes("ADJUST", &mut draft.log).unwrap_or(true);
        card.first_line("slave surface, master surface", &mut draft.log);
        for line in card.data() {
            draft.log.at_most(line, 2);
            let name = |at: usize| {
                let field = line.field(at)?;
                Some(Named { name: normalise(&field.text), span: field.span })
            };
            let (Some(slave), Some(master)) = (name(0), name(1)) else {
                draft.log.error("SL0119", "a tie needs two surfaces: slave, master", line.end());
                continue;
            };
            let origin = line.span;
            let is_pair = false;
            draft.ties.push(Draught {
                slave,
                master,
                tolerance,
                adjust,
                by_faces,
                is_pair,
                origin,
            });
        }
    }
}
