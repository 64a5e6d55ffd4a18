//! `*NODE PRINT`: tables of nodal values.

use slideline_deck::{Field, normalise};
use slideline_diag::{Code, Diagnostic};
use slideline_model::{self as model, NodeVariable, PrintTarget};

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*NODE PRINT`.
pub(crate) struct NodePrint;

impl Keyword for NodePrint {
    fn name(&self) -> &'static str {
        "NODE PRINT"
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
        page!("NODE-PRINT")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        request(card, PrintTarget::Table, draft);
    }
}

/// Takes in a request for nodal values.
pub(crate) fn request(card: &Reading<'_>, target: PrintTarget, draft: &mut Draft) {
    let frequency = frequency(card, target, draft);
    let mut variables = Vec::new();
    for line in card.data() {
        for field in line.fields.iter().filter(|field| !field.text.is_empty()) {
            match variable(&field.text) {
                Some(variable) if !variables.contains(&variable) => variables.push(variable),
                Some(_) => {}
                None => unknown(field, draft),
            }
        }
    }
    if card.has("VARIABLE") && variables.is_empty() {
        variables = vec![NodeVariable::U, NodeVariable::RF];
    }
    if variables.is_empty() {
        if card.data().is_empty() {
            draft.log.error("SL0208", "no variables are listed: U, RF, CF or COORD", card.span());
        }
        return;
    }
    let set = card.name("NSET");
    let span = set.is_some().then(|| card.span_of("NSET"));
    let set = set.unwrap_or_default();
    let origin = card.span();
    let print = model::NodePrint { set, nodes: Vec::new(), variables, frequency, target, origin };
    if let Some(step) = draft.step() {
        step.prints.push((print, span));
    }
}

/// `FREQUENCY` of a request: its own, or that of the `*OUTPUT` above it.
pub(crate) fn frequency(card: &Reading<'_>, target: PrintTarget, draft: &mut Draft) -> usize {
    let above = match target {
        PrintTarget::File => draft.step().map_or(1, |step| step.output_frequency),
        PrintTarget::Table => 1,
    };
    card.count("FREQUENCY", above, &mut draft.log)
}

/// `U`, `RF`, `CF`, `COORD`, or one of their components such as `RF2`.
fn variable(text: &str) -> Option<NodeVariable> {
    let name = normalise(text);
    match name.trim_end_matches(|c: char| c.is_ascii_digit()) {
        "U" | "UR" | "UT" => Some(NodeVariable::U),
        "RF" | "RM" | "RT" => Some(NodeVariable::RF),
        "CF" | "CM" => Some(NodeVariable::CF),
        "COORD" | "COOR" => Some(NodeVariable::COORD),
        _ => None,
    }
}

fn unknown(field: &Field, draft: &mut Draft) {
    let message = format!("`{}` is no nodal variable", field.text);
    let error = Diagnostic::error(Code("SL0252"), message).at(field.span);
    draft.log.push(error.help("known: U, RF, CF, COORD"));
}
