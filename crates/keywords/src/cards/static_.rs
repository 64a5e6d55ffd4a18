//! `*STATIC`: time and increments of a step.

use slideline_deck::DataLine;
use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{self as model, Passage};

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*STATIC`.
pub(crate) struct Static;

impl Keyword for Static {
    fn name(&self) -> &'static str {
        "STATIC"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::maybe("DIRECT"),
            Rule::flag("LONG TERM"),
            Rule::maybe("STABILIZE"),
            Rule::value("TOTAL TIME AT START"),
            Rule::flag("TIME RESET"),
        ];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        &["SOLVER", "ALLSDTOL", "FACTOR", "CONTINUE", "FULLY PLASTIC"]
    }

    fn level(&self) -> Level {
        Level::History
    }

    fn subject(&self) -> Subject {
        Subject::Steps
    }

    fn page(&self) -> &'static str {
        page!("STATIC")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let passage = if card.has("LONG TERM") { Passage::LongTerm } else { Passage::Still };
        procedure(self.name(), card, (passage, None), draft);
    }
}

/// Takes in how a step is analysed.
pub(super) fn procedure(
    name: &str,
    card: &Reading<'_>,
    (passage, creep_tolerance): (Passage, Option<f64>),
    draft: &mut Draft,
) {
    draft.log.at_most_lines(card.data(), 1, name);
    if card.has("STABILIZE") {
        let message =
            "no damping is added: equilibrium is found without it, or the run says why not";
        draft.log.note("SL0253", message, card.span_of("STABILIZE"));
    }
    another_time(card, draft);
    let direct = card.has("DIRECT");
    let procedure = match card.data().first() {
        Some(line) => times(line, direct, card.span(), draft),
        None => Some([1.0, 1.0, 1e-5, 1.0]),
    };
    let Some([initial, period, minimum, maximum]) = procedure else { return };
    let origin = card.span();
    let Some(step) = draft.step() else { return };
    let before = step.procedure.replace(model::Static {
        initial,
        period,
        minimum,
        maximum,
        direct,
        passage,
        creep_tolerance,
        origin: Some(origin),
    });
    if let Some(first) = before.and_then(|before| before.origin) {
        let error = Diagnostic::error(Code("SL0242"), format!("a second *{name} in one step"));
        draft.log.push(error.at(origin).label(first, "the first one"));
    }
}

/// A total time that does not run on (CalculiX): it moves curves over the total time, and nothing
/// else but the times that are printed.
fn another_time(card: &Reading<'_>, draft: &mut Draft) {
    for name in ["TOTAL TIME AT START", "TIME RESET"].into_iter().filter(|name| card.has(name)) {
        let span = card.span_of(name);
        if draft.model.amplitudes.iter().any(|curve| curve.total) {
            let message = format!("{name} is not supported beside *AMPLITUDE, TIME=TOTAL TIME");
            let error = Diagnostic::error(Code("SL0221"), message).at(span);
            draft.log.push(error.help("give the curve over the time of the step"));
        } else {
            let message = format!("{name} has no effect here: the total time runs on");
            draft.log.note("SL0257", message, span);
        }
    }
}

/// First increment, period, smallest and largest increment with their
/// defaults. [semantics: deck language, *STATIC]
fn times(line: &DataLine, direct: bool, span: Span, draft: &mut Draft) -> Option<[f64; 4]> {
    draft.log.at_most(line, 4);
    let given: Vec<Option<Option<f64>>> =
        (0..4).map(|at| draft.log.maybe_number(line, at)).collect();
    let given: Vec<Option<f64>> = given.into_iter().collect::<Option<_>>()?;
    // Zero stands for the default, as a blank does.
    let value = |at: usize| given.get(at).copied().flatten().filter(|&value| value != 0.0);
    let period = value(1).unwrap_or(1.0);
    let initial = value(0).unwrap_or(period);
    let minimum = if direct { initial } else { value(2).unwrap_or(initial.min(1e-5 * period)) };
    let maximum = if direct { initial } else { value(3).unwrap_or(period) };
    let at = |at: usize| line.fields.get(at).map_or(span, |field| field.span);
    let fault = if period < 0.0 {
        Some((at(1), "the time of a step must be positive"))
    } else if initial < 0.0 || initial > period {
        Some((at(0), "the first increment must be positive and within the step"))
    } else if minimum < 0.0 || minimum > initial {
        Some((at(2), "the smallest increment must be positive and at most the first one"))
    } else if maximum < minimum {
        Some((at(3), "the largest increment is smaller than the smallest one"))
    } else {
        None
    };
    if let Some((span, message)) = fault {
        draft.log.error("SL0246", message, span);
        return None;
    }
    Some([initial, period, minimum, maximum])
}
