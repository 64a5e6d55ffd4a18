//! `*DLOAD`: loads on faces and volumes of elements.

use slideline_deck::{DataLine, normalise};
use slideline_diag::{Code, Diagnostic};

use crate::distributed::{Along, Distributed, Kind, On};
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*DLOAD`.
pub(crate) struct Dload;

impl Keyword for Dload {
    fn name(&self) -> &'static str {
        "DLOAD"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] =
            &[Rule::value("OP"), Rule::value("AMPLITUDE"), Rule::value("TIME DELAY")];
        RULES
    }

    fn level(&self) -> Level {
        Level::History
    }

    fn subject(&self) -> Subject {
        Subject::Steps
    }

    fn page(&self) -> &'static str {
        page!("DLOAD")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        take(card, line_of, draft);
    }
}

/// Reads the lines of a card into the step that is open.
pub(super) fn take(
    card: &Reading<'_>,
    line_of: fn(&DataLine, &mut Draft) -> Option<Distributed>,
    draft: &mut Draft,
) {
    let new = card.choice("OP", &["MOD", "NEW"], &mut draft.log) == Some("NEW");
    let amplitude = crate::curves::of_card(card, draft);
    let axes = card.name("ORIENTATION").map(|name| (name, card.span_of("ORIENTATION")));
    let mut lines = Vec::new();
    for line in card.data() {
        if let Some(mut load) = line_of(line, draft) {
            load.amplitude.clone_from(&amplitude);
            load.axes.clone_from(&axes);
            lines.push(load);
        }
    }
    if let Some(step) = draft.step() {
        step.new_distributed[usize::from(card.keyword.name == "DSLOAD")] |= new;
        step.distributed.extend(lines);
    }
}

fn line_of(line: &DataLine, draft: &mut Draft) -> Option<Distributed> {
    let label = line.field(1).map_or(String::new(), |field| normalise(&field.text));
    // gravity on the whole model needs no set
    let target = match line.field(0) {
        None if label == "GRAV" => None,
        _ => Some(draft.log.target(line, 0, "the element or set")?),
    };
    let span = line.fields.first().map_or(line.span, |field| field.span);
    let value = draft.log.number(line, 2, "the size of the load")?;
    let kind = match label.as_str() {
        "BX" | "BY" | "BZ" | "BR" => {
            draft.log.at_most(line, 3);
            Kind::Body(match label.as_str() {
                "BX" => Along::X,
                "BY" => Along::Y,
                "BZ" => Along::Z,
                _ => Along::Radius,
            })
        }
        "PX" | "PY" | "PZ" => {
            draft.log.at_most(line, 3);
            Kind::Line(["PX", "PY", "PZ"].iter().position(|name| *name == label)?)
        }
        "GRAV" => Kind::Gravity(direction(line, 3, draft)?),
        "CENTRIF" => {
            let point = [3, 4, 5].map(|at| draft.log.number_or(line, at, 0.0));
            Kind::Centrifugal([point[0]?, point[1]?, point[2]?], direction(line, 6, draft)?)
        }
        _ => match label.strip_prefix('P').and_then(|face| face.parse::<usize>().ok()) {
            Some(face @ 1..=6) => {
                draft.log.at_most(line, 3);
                Kind::Pressure(Some(face - 1))
            }
            Some(face) => {
                let message = format!("no element has a face {face}");
                let span = line.fields.get(1).map_or(line.span, |field| field.span);
                let error = Diagnostic::error(Code("SL0256"), message).at(span);
                let help = "faces are 1 to 3 or 4 in the plane, 1 to 4 of tetrahedra, to 5 of wedges, \
                            to 6 of bricks";
                draft.log.push(error.help(help));
                return None;
            }
            None => {
                unknown(line, "P1 to P6, PX, PY, PZ, BX, BY, BZ, BR, GRAV, CENTRIF", draft);
                return None;
            }
        },
    };
    let on = match target {
        Some(target) => On::Elements(target, span),
        None => On::Elements(crate::log::Target::Set(String::new()), span),
    };
    Some(Distributed { on, kind, value, amplitude: None, axes: None, origin: line.span })
}

pub(super) fn unknown(line: &DataLine, known: &str, draft: &mut Draft) {
    let span = line.fields.get(1).map_or(line.span, |field| field.span);
    let word = line.field(1).map_or("", |field| &field.text);
    let message = format!("the load `{word}` is not supported");
    let error = Diagnostic::error(Code("SL0221"), message).at(span);
    draft.log.push(error.help(format!("supported here: {known}")));
}

/// A unit vector of three values.
pub(super) fn direction(line: &DataLine, at: usize, draft: &mut Draft) -> Option<[f64; 3]> {
    draft.log.at_most(line, at + 3);
    let read = [0, 1, 2].map(|k| draft.log.number_or(line, at + k, 0.0));
    let vector = [read[0]?, read[1]?, read[2]?];
    let length = vector.iter().map(|x| x * x).sum::<f64>().sqrt();
    if length > 0.0 && length.is_finite() {
        return Some(vector.map(|x| x / length));
    }
    draft.log.error("SL0232", "the direction of the load is missing", line.span);
    None
}
