//! `*DISTRIBUTION TABLE`: what the numbers of a distribution are.

use slideline_deck::normalise;
use slideline_diag::{Code, Diagnostic};

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*DISTRIBUTION TABLE`.
pub(crate) struct DistributionTable;

impl Keyword for DistributionTable {
    fn name(&self) -> &'static str {
        "DISTRIBUTION TABLE"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::required("NAME")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Sections
    }

    fn page(&self) -> &'static str {
        page!("DISTRIBUTION-TABLE")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let Some(name) = card.name("NAME") else { return };
        let Some(first) = card.first_line("COORD3D, COORD3D", &mut draft.log) else { return };
        if draft.distribution_tables.contains(&name) {
            let message = format!("the distribution table {name} is defined twice");
            draft.log.error("SL0250", message, card.span_of("NAME"));
            return;
        }
        let fields = card.data().iter().flat_map(|line| &line.fields);
        let words = fields.filter(|field| !field.text.is_empty());
        let quantities: Vec<String> = words.map(|field| normalise(&field.text)).collect();
        if quantities != ["COORD3D", "COORD3D"] {
            let message = format!("a distribution of {} is not supported", quantities.join(", "));
            let error = Diagnostic::error(Code("SL0221"), message).at(first.span);
            let help = "distributions are of axes here: COORD3D, COORD3D";
            draft.log.push(error.help(help));
        }
        draft.distribution_tables.push(name);
    }
}
