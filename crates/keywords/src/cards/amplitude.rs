//! `*AMPLITUDE`: a curve over time.

use slideline_diag::{Code, Diagnostic};

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*AMPLITUDE`.
pub(crate) struct Amplitude;

impl Keyword for Amplitude {
    fn name(&self) -> &'static str {
        "AMPLITUDE"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::required("NAME"),
            Rule::value("DEFINITION"),
            Rule::value("TIME"),
            Rule::value("VALUE"),
        ];
        RULES
    }

    fn level(&self) -> Level {
        Level::Both
    }

    fn subject(&self) -> Subject {
        Subject::Amplitudes
    }

    fn page(&self) -> &'static str {
        page!("AMPLITUDE")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        card.choice("DEFINITION", &["TABULAR"], &mut draft.log);
        card.choice("TIME", &["STEP TIME"], &mut draft.log);
        card.choice("VALUE", &["RELATIVE", "ABSOLUTE"], &mut draft.log);
        let Some(name) = card.name("NAME") else { return };
        if let Some(old) = draft.model.amplitude(&name) {
            let message = format!("the amplitude {name} is defined twice");
            let error = Diagnostic::error(Code("SL0250"), message).at(card.span_of("NAME"));
            let error = error.label(old.origin, "defined here first");
            draft.log.push(error);
            return;
        }
        if card.first_line("time, factor, ...", &mut draft.log).is_none() {
            return;
        }
        let points = points(card, draft);
        if !points.is_empty() {
            let origin = card.span();
            draft.model.amplitudes.push(slideline_model::Amplitude { name, points, origin });
        }
    }
}

/// Pairs of time and factor, up to four on a line, times ascending.
fn points(card: &Reading<'_>, draft: &mut Draft) -> Vec<(f64, f64)> {
    let mut points: Vec<(f64, f64)> = Vec::new();
    for line in card.data() {
        for at in (0..line.fields.len()).step_by(2) {
            let time = draft.log.number(line, at, "the time");
            let factor = draft.log.number(line, at + 1, "the factor");
            let (Some(time), Some(factor)) = (time, factor) else { continue };
            if points.last().is_some_and(|&(last, _)| time <= last) {
                let message = format!("the time {time} does not come after the one before it");
                draft.log.error("SL0249", message, line.fields[at].span);
                continue;
            }
            points.push((time, factor));
        }
    }
    points
}
