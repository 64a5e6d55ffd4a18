//! `*INITIAL CONDITIONS`: the state before the first step.

use slideline_deck::DataLine;
use slideline_diag::{Code, Diagnostic};
use slideline_model::Dialect;

use crate::draft::{Draft, StressLine};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::temperatures;

/// `*INITIAL CONDITIONS`.
pub(crate) struct InitialConditions;

impl Keyword for InitialConditions {
    fn name(&self) -> &'static str {
        "INITIAL CONDITIONS"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::required("TYPE"), Rule::value("INPUT")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Other
    }

    fn page(&self) -> &'static str {
        page!("INITIAL-CONDITIONS")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        match card.name("TYPE").as_deref() {
            Some("TEMPERATURE") => {
                let lines = temperatures::lines(card, draft);
                draft.initial_temperatures.extend(lines);
            }
            Some("STRESS") => {
                let lines: Vec<StressLine> =
                    card.data().iter().filter_map(|line| stress(line, draft)).collect();
                draft.initial_stresses.extend(lines);
            }
            Some("VELOCITY") => {
                let message = "initial velocities have no effect in a static step";
                draft.log.note("SL0257", message, card.span());
            }
            other => {
                let kind = other.unwrap_or_default();
                let message = format!("*INITIAL CONDITIONS, TYPE={kind} is not supported");
                let error = Diagnostic::error(Code("SL0221"), message);
                let error = error.at(card.span_of("TYPE"));
                draft.log.push(error.help("given here: TEMPERATURE and STRESS"));
            }
        }
    }
}

/// `element or set, components`, in the dialect of CalculiX `element or set, point, components`.
fn stress(line: &DataLine, draft: &mut Draft) -> Option<StressLine> {
    let target = draft.log.target(line, 0, "the element or set")?;
    let calculix = draft.dialect == Dialect::Calculix;
    let point = match calculix {
        true => Some(draft.log.label(line, 1, "the integration point")? as usize - 1),
        false => None,
    };
    let first = if calculix { 2 } else { 1 };
    draft.log.at_most(line, first + 6);
    let count = line.fields.len().clamp(first + 1, first + 6);
    let values = (first..count).map(|at| draft.log.number_or(line, at, 0.0));
    let values: Vec<Option<f64>> = values.collect();
    Some(StressLine {
        target,
        target_span: line.fields.first()?.span,
        point,
        values: values.into_iter().collect::<Option<_>>()?,
        origin: line.span,
    })
}
