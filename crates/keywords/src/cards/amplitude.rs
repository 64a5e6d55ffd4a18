//! `*AMPLITUDE`: a curve over time.

use slideline_diag::{Code, Diagnostic};
use slideline_model::{self as model, Curve, Dialect};

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
            Rule::value("SCALEX"),
            Rule::value("SCALEY"),
            Rule::value("SHIFTX"),
            Rule::value("SHIFTY"),
            Rule::value("FIXED INTERVAL"),
            Rule::value("BEGIN"),
            Rule::value("INPUT"),
        ];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        &["SMOOTH"]
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
        let kinds = &["TABULAR", "EQUALLY SPACED", "SMOOTH STEP", "PERIODIC", "MODULATED", "DECAY"];
        let kind = card.choice("DEFINITION", kinds, &mut draft.log);
        let time = card.choice("TIME", &["STEP TIME", "TOTAL TIME"], &mut draft.log);
        let value = card.choice("VALUE", &["RELATIVE", "ABSOLUTE"], &mut draft.log);
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
        if card.has("DEFINITION") && kind.is_none() {
            return;
        }
        let curve = match kind {
            Some("PERIODIC") => periodic(card, draft),
            Some("MODULATED") => {
                let numbers = numbers(card, "A0, A, start, two frequencies", draft);
                numbers.map(|[mean, swing, start, first, second]| Curve::Modulated {
                    mean,
                    swing,
                    start,
                    frequencies: (first, second),
                })
            }
            Some("DECAY") => decay(card, draft),
            Some("EQUALLY SPACED") => {
                evenly(card, draft).filter(|points| !points.is_empty()).map(Curve::Tabular)
            }
            _ => {
                shifted(card, draft).filter(|points| !points.is_empty()).map(|points| match kind {
                    Some("SMOOTH STEP") => Curve::SmoothStep(points),
                    _ => Curve::Tabular(points),
                })
            }
        };
        if let Some(curve) = curve.and_then(|curve| scaled(curve, card, draft)) {
            if value == Some("ABSOLUTE") {
                absolute(&name, card, draft);
            }
            let (total, origin) = (time == Some("TOTAL TIME"), card.span());
            draft.model.amplitudes.push(model::Amplitude {
                name,
                curve,
                begins: 0.0,
                total,
                origin,
            });
        }
    }
}

/// `VALUE=ABSOLUTE`: in place of the numbers of loads and motions.
fn absolute(name: &str, card: &Reading<'_>, draft: &mut Draft) {
    match draft.dialect {
        Dialect::Abaqus => _ = draft.absolute_amplitudes.insert(name.to_owned()),
        Dialect::Calculix => {
            let message = "VALUE has no effect here: in CalculiX amplitudes are always factors";
            draft.log.note("SL0253", message, card.span_of("VALUE"));
        }
    }
}

/// `SHIFTX` and `SHIFTY`: what is added to times and to factors.
fn shift(card: &Reading<'_>, draft: &mut Draft) -> Option<(f64, f64)> {
    let x = card.number("SHIFTX", &mut draft.log)?.unwrap_or(0.0);
    let y = card.number("SHIFTY", &mut draft.log)?.unwrap_or(0.0);
    Some((x, y))
}

/// `SCALEX` and `SCALEY`: what times and factors are multiplied with. Whether shifts are scaled too is not said:
/// one of both along an axis.
fn scaled(curve: Curve, card: &Reading<'_>, draft: &mut Draft) -> Option<Curve> {
    let x = card.number("SCALEX", &mut draft.log)?.unwrap_or(1.0);
    let y = card.number("SCALEY", &mut draft.log)?.unwrap_or(1.0);
    for [scale, shift] in [["SCALEX", "SHIFTX"], ["SCALEY", "SHIFTY"]] {
        if card.has(scale) && card.has(shift) {
            let message = format!("{scale} and {shift} together are not supported");
            let error = Diagnostic::error(Code("SL0221"), message).at(card.span_of(scale));
            let help = "which acts first is not said: write the points as they shall be";
            draft.log.push(error.help(help));
            return None;
        }
    }
    if x <= 0.0 {
        draft.log.error("SL0210", "SCALEX must be positive", card.span_of("SCALEX"));
        return None;
    }
    Some(curve.scaled(x, y))
}

/// The points of a table, shifted.
fn shifted(card: &Reading<'_>, draft: &mut Draft) -> Option<Vec<(f64, f64)>> {
    let (x, y) = shift(card, draft)?;
    Some(points(card, draft).into_iter().map(|(time, factor)| (time + x, factor + y)).collect())
}

/// So many numbers on one line, of which the first is shifted like a factor and the third like a
/// time.
fn numbers<const N: usize>(card: &Reading<'_>, what: &str, draft: &mut Draft) -> Option<[f64; N]> {
    let line = card.only_line(what, &mut draft.log)?;
    draft.log.at_most(line, N);
    let (later, higher) = shift(card, draft)?;
    let mut numbers = [0.0; N];
    for (at, number) in numbers.iter_mut().enumerate() {
        *number = draft.log.number_or(line, at, 0.0)?;
    }
    numbers[0] += higher;
    numbers[2] += later;
    Some(numbers)
}

/// `A0, A, t0, td`.
fn decay(card: &Reading<'_>, draft: &mut Draft) -> Option<Curve> {
    let [mean, swing, start, time] = numbers(card, "A0, A, start, decay time", draft)?;
    if time <= 0.0 {
        let message = "the decay time, the fourth number, must be positive";
        draft.log.error("SL0210", message, card.data()[0].span);
        return None;
    }
    Some(Curve::Decay { mean, swing, start, time })
}

/// Factors at equal distances of time, from `BEGIN` on.
fn evenly(card: &Reading<'_>, draft: &mut Draft) -> Option<Vec<(f64, f64)>> {
    let interval = card.number("FIXED INTERVAL", &mut draft.log)?;
    let Some(interval) = interval.filter(|&interval| interval > 0.0) else {
        let message = "EQUALLY SPACED needs a positive FIXED INTERVAL=";
        draft.log.error("SL0205", message, card.span_of("FIXED INTERVAL"));
        return None;
    };
    let begin = card.number("BEGIN", &mut draft.log)?.unwrap_or(0.0);
    let (later, higher) = shift(card, draft)?;
    let factors = card.numbers(&mut draft.log)?;
    let points = factors.into_iter().enumerate();
    #[allow(clippy::cast_precision_loss)] // far below 2^53
    let at = |k: usize| begin + later + interval * k as f64;
    Some(points.map(|(k, factor)| (at(k), factor + higher)).collect())
}

/// `N, w, t0, A0`, then N pairs A_n, B_n.
fn periodic(card: &Reading<'_>, draft: &mut Draft) -> Option<Curve> {
    let line = card.first_line("N, frequency, start, A0", &mut draft.log)?;
    draft.log.at_most(line, 4);
    let count = draft.log.integer_or(line, 0, 0)?;
    let frequency = draft.log.number(line, 1, "the angular frequency")?;
    let (later, higher) = shift(card, draft)?;
    let start = draft.log.number_or(line, 2, 0.0)? + later;
    let mean = draft.log.number_or(line, 3, 0.0)? + higher;
    let mut terms = Vec::new();
    for line in &card.data()[1..] {
        for at in (0..line.fields.len()).step_by(2) {
            let (a, b) =
                (draft.log.number_or(line, at, 0.0)?, draft.log.number_or(line, at + 1, 0.0)?);
            terms.push((a, b));
        }
    }
    if usize::try_from(count).ok() != Some(terms.len()) {
        let message = format!("{count} terms are announced, here are {}", terms.len());
        draft.log.error("SL0210", message, line.span);
        return None;
    }
    Some(Curve::Periodic { frequency, start, mean, terms })
}

/// Pairs of time and factor, up to four on a line, times ascending.
fn points(card: &Reading<'_>, draft: &mut Draft) -> Vec<(f64, f64)> {
    let mut points: Vec<(f64, f64)> = Vec::new();
    for line in card.data() {
        for at in (0..line.fields.len()).step_by(2) {
            let time = draft.log.number(line, at, "the time");
            let factor = draft.log.number(line, at + 1, "the factor");
            let (Some(time), Some(factor)) = (time, factor) else { continue };
            // CalculiX takes the later of two values of one time, so that the curve jumps there
            let jumps = draft.dialect == Dialect::Calculix;
            if points.last().is_some_and(|&(last, _)| time < last || (time == last && !jumps)) {
                let message = format!("the time {time} does not come after the one before it");
                let error = Diagnostic::error(Code("SL0249"), message).at(line.fields[at].span);
                let help = "give pairs of time and factor, times ascending; a jump is a rise over a \
                            short time";
                draft.log.push(error.help(help));
                continue;
            }
            points.push((time, factor));
        }
    }
    points
}
