//! `*CONTACT PRINT`: tables of contact results.

use slideline_deck::{Field, normalise};
use slideline_diag::{Code, Diagnostic};
use slideline_model::{self as model, ContactVariable, PrintTarget};

use super::node_print::frequency;
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*CONTACT PRINT`.
pub(crate) struct ContactPrint;

impl Keyword for ContactPrint {
    fn name(&self) -> &'static str {
        "CONTACT PRINT"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::value("NSET"),
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
        page!("CONTACT-PRINT")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        request(card, PrintTarget::Table, draft);
    }
}

/// Takes in a request for contact results.
pub(crate) fn request(card: &Reading<'_>, target: PrintTarget, draft: &mut Draft) {
    let frequency = frequency(card, target, draft);
    let mut variables = Vec::new();
    for line in card.data() {
        for field in line.fields.iter().filter(|field| !field.text.is_empty()) {
            match variable(&field.text) {
                Some(found) if !variables.contains(&found) => variables.push(found),
                Some(_) => {}
                None => unknown(field, draft),
            }
        }
    }
    if card.has("VARIABLE") && variables.is_empty() {
        variables = vec![ContactVariable::CSTRESS, ContactVariable::CDISP];
    }
    if variables.is_empty() {
        if card.data().is_empty() {
            let message = "no variables are listed: CSTRESS, CDISP or CFORCE";
            draft.log.error("SL0208", message, card.span());
        }
        return;
    }
    let set = card.name("NSET");
    let span = set.is_some().then(|| card.span_of("NSET"));
    let print = model::ContactPrint {
        set: set.unwrap_or_default(),
        nodes: Vec::new(),
        variables,
        frequency,
        target,
        origin: card.span(),
    };
    if let Some(step) = draft.step() {
        step.contact_prints.push((print, span));
    }
}

/// Abaqus' words and CalculiX' shorter ones, or a component.
fn variable(text: &str) -> Option<ContactVariable> {
    match normalise(text).as_str() {
        "CSTRESS" | "CSTR" | "CPRESS" | "CSHEAR1" => Some(ContactVariable::CSTRESS),
        "CDISP" | "CDIS" | "COPEN" | "CSLIP1" => Some(ContactVariable::CDISP),
        "CFORCE" | "CNORMF" | "CSHEARF" => Some(ContactVariable::CFORCE),
        _ => None,
    }
}

fn unknown(field: &Field, draft: &mut Draft) {
    let message = format!("`{}` is no contact variable", field.text);
    let error = Diagnostic::error(Code("SL0252"), message).at(field.span);
    draft.log.push(error.help("known: CSTRESS, CDISP, CFORCE"));
}
