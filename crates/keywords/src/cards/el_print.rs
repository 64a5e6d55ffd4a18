//! `*EL PRINT`: tables of section forces and stresses of beams.

use slideline_deck::{Field, normalise};
use slideline_diag::{Code, Diagnostic};
use slideline_model::{self as model, ElementVariable, PrintTarget, SECTION_POINTS};

use super::node_print::frequency;
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*EL PRINT`.
pub(crate) struct ElPrint;

impl Keyword for ElPrint {
    fn name(&self) -> &'static str {
        "EL PRINT"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::value("ELSET"),
            Rule::value("FREQUENCY"),
            Rule::maybe("TOTALS"),
            Rule::maybe("SUMMARY"),
        ];
        RULES
    }

    fn level(&self) -> Level {
        Level::History
    }

    fn subject(&self) -> Subject {
        Subject::Steps
    }

    fn page(&self) -> &'static str {
        page!("EL-PRINT")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        request(card, PrintTarget::Table, draft);
    }
}

/// Takes in a request for beam results: section points, where numbers are
/// listed, and variables.
pub(crate) fn request(card: &Reading<'_>, target: PrintTarget, draft: &mut Draft) {
    let frequency = frequency(card, target, draft);
    let (mut variables, mut section_points) = (Vec::new(), Vec::new());
    for line in card.data() {
        for field in line.fields.iter().filter(|field| !field.text.is_empty()) {
            match (variable(&field.text), section_point(&field.text)) {
                (Some(found), _) if !variables.contains(&found) => variables.push(found),
                (_, Some(point)) if !section_points.contains(&point) => section_points.push(point),
                (None, None) => unknown(field, draft),
                _ => {}
            }
        }
    }
    if card.has("VARIABLE") && variables.is_empty() {
        variables = vec![ElementVariable::SF, ElementVariable::SM, ElementVariable::S];
    }
    if variables.is_empty() {
        if card.data().is_empty() {
            let message = "no variables are listed: SF, SM, SE, SK, S or MISES";
            draft.log.error("SL0208", message, card.span());
        }
        return;
    }
    if section_points.is_empty() {
        section_points = vec![1, SECTION_POINTS];
    }
    let set = card.name("ELSET");
    let span = set.is_some().then(|| card.span_of("ELSET"));
    let print = model::ElementPrint {
        set: set.unwrap_or_default(),
        elements: Vec::new(),
        variables,
        section_points,
        frequency,
        target,
        origin: card.span(),
    };
    if let Some(step) = draft.step() {
        step.element_prints.push((print, span));
    }
}

/// `SF`, `SM` ..., or one of their components such as `SF1`.
fn variable(text: &str) -> Option<ElementVariable> {
    let name = normalise(text);
    match name.trim_end_matches(|c: char| c.is_ascii_digit()) {
        "SF" => Some(ElementVariable::SF),
        "SM" => Some(ElementVariable::SM),
        "SE" => Some(ElementVariable::SE),
        "SK" => Some(ElementVariable::SK),
        "S" => Some(ElementVariable::S),
        "MISES" => Some(ElementVariable::MISES),
        _ => None,
    }
}

fn section_point(text: &str) -> Option<usize> {
    text.trim().parse().ok().filter(|point| (1..=SECTION_POINTS).contains(point))
}

fn unknown(field: &Field, draft: &mut Draft) {
    let message = format!("`{}` is no variable of a beam", field.text);
    let error = Diagnostic::error(Code("SL0252"), message).at(field.span);
    let help = "known: SF, SM, SE, SK, S, MISES; numbers from 1 to 5 are section points";
    draft.log.push(error.help(help));
}
