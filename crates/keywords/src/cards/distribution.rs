//! `*DISTRIBUTION`: numbers of every element, here the points of its axes.
//!
//! ```text
//!       , 1., 0., 0.,  0., 1., 0.     of elements that no line names
//!   12, 0.8, 0.6, 0., -0.6, 0.8, 0.   a, b of element 12
//! ```

use slideline_deck::DataLine;
use slideline_diag::{Code, Diagnostic};

use crate::axes::{Distribution as Draught, Numbers};
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*DISTRIBUTION`.
pub(crate) struct Distribution;

impl Keyword for Distribution {
    fn name(&self) -> &'static str {
        "DISTRIBUTION"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::required("NAME"),
            Rule::required("LOCATION"),
            Rule::required("TABLE"),
            Rule::value("INPUT"),
        ];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Sections
    }

    fn page(&self) -> &'static str {
        page!("DISTRIBUTION")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let Some((name, table)) = card.name("NAME").zip(card.name("TABLE")) else { return };
        match card.choice("LOCATION", &["ELEMENT", "NODE", "NONE"], &mut draft.log) {
            Some("ELEMENT") => {}
            Some(location) => {
                let message = format!("a distribution by LOCATION={location} is not supported");
                let error = Diagnostic::error(Code("SL0221"), message);
                let help = "give the axes element by element: LOCATION=ELEMENT";
                draft.log.push(error.at(card.span_of("LOCATION")).help(help));
                return;
            }
            None => return,
        }
        let Some(first) = card.first_line("the default, behind a comma", &mut draft.log) else {
            return;
        };
        if first.field(0).is_some() {
            let message = "the first line of a *DISTRIBUTION has the default and names no element";
            let error = Diagnostic::error(Code("SL0208"), message);
            let help = "put a line before it that begins with a comma: , 1., 0., 0., 0., 1., 0.";
            draft.log.push(error.at(first.span).help(help));
            return;
        }
        if draft.distributions.iter().any(|known| known.name == name) {
            let message = format!("the distribution {name} is defined twice");
            draft.log.error("SL0250", message, card.span_of("NAME"));
            return;
        }
        let Some(default) = numbers(first, draft) else { return };
        let mut lines = Vec::with_capacity(card.data().len());
        for line in card.data().iter().skip(1) {
            let target = draft.log.target(line, 0, "the element or set");
            lines.extend(target.zip(numbers(line, draft)));
        }
        let table = (table, card.span_of("TABLE"));
        draft.distributions.push(Draught { name, table, default, lines, motion: None });
    }
}

/// The numbers behind the element.
fn numbers(line: &DataLine, draft: &mut Draft) -> Option<Numbers> {
    draft.log.at_most(line, 7);
    let mut first = [0.0; 6];
    for (at, number) in first.iter_mut().enumerate() {
        *number = draft.log.number_or(line, at + 1, 0.0)?;
    }
    Some(Numbers { first, span: line.span })
}
