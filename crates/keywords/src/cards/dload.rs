//! `*DLOAD`: loads on faces and volumes of elements.

use slideline_deck::{DataLine, normalise};
use slideline_diag::{Code, Diagnostic};
use slideline_mech::traction::Follows;

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
        const RULES: &[Rule] = &[
            Rule::value("OP"),
            Rule::value("AMPLITUDE"),
            Rule::value("TIME DELAY"),
            Rule::value("ORIENTATION"),
            Rule::value("FOLLOWER"),
            Rule::value("CONSTANT RESULTANT"),
        ];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        &["LOAD CASE", "REGION TYPE", "REAL"]
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
    let stays = card.yes("FOLLOWER", &mut draft.log) == Some(false);
    let undeformed = card.yes("CONSTANT RESULTANT", &mut draft.log) == Some(true);
    let mut lines = Vec::new();
    for line in card.data() {
        if let Some(mut load) = line_of(line, draft) {
            load.amplitude.clone_from(&amplitude);
            load.axes.clone_from(&axes);
            // along a surface a traction can only stay if it turns with it
            let turns = !stays || matches!(load.kind, Kind::Shear(_));
            load.follows = Follows { turns, grows: !undeformed };
            lines.push(load);
        }
    }
    without_effect(card, (stays, undeformed), &lines, draft);
    if let Some(step) = draft.step() {
        step.new_distributed[usize::from(card.keyword.name == "DSLOAD")] |= new;
        step.distributed.extend(lines);
    }
}

/// Notes what a card says of tractions where its loads do not ask.
fn without_effect(
    card: &Reading<'_>,
    (stays, undeformed): (bool, bool),
    lines: &[Distributed],
    draft: &mut Draft,
) {
    let is = |kind: fn(&Kind) -> bool| lines.iter().any(|own| kind(&own.kind));
    if stays && is(|kind| matches!(kind, Kind::Shear(_))) {
        let message = "FOLLOWER=NO does not concern TRSHR: along its surface it turns with it";
        draft.log.note("SL0253", message, card.span_of("FOLLOWER"));
    }
    if (stays || undeformed) && is(|kind| *kind == Kind::Pressure) {
        let name = if stays { "FOLLOWER" } else { "CONSTANT RESULTANT" };
        let message = format!("{name} concerns tractions: a pressure follows its faces");
        draft.log.note("SL0253", message, card.span_of(name));
    }
}

/// A load on elements.
pub(super) fn line_of(line: &DataLine, draft: &mut Draft) -> Option<Distributed> {
    let label = line.field(1).map_or(String::new(), |field| normalise(&field.text));
    // gravity on the whole model needs no set
    let target = match line.field(0) {
        None if label == "GRAV" => None,
        _ => Some(draft.log.target(line, 0, "the element or set")?),
    };
    let span = line.fields.first().map_or(line.span, |field| field.span);
    let value = draft.log.number(line, 2, "the size of the load")?;
    let mut face = None;
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
        _ => {
            let (kind, number) = on_face(&label, line, draft)?;
            face = Some(number);
            kind
        }
    };
    let on = match target {
        Some(target) => On::Elements(target, span),
        None => On::Elements(crate::log::Target::Set(String::new()), span),
    };
    Some(Distributed::new(on, (kind, face), value, line.span))
}

/// A load on one face of every element, and that face, from 0.
fn on_face(label: &str, line: &DataLine, draft: &mut Draft) -> Option<(Kind, usize)> {
    let numbered = |word: &str| label.strip_prefix(word)?.parse::<usize>().ok();
    let found = ["P", "TRVEC", "TRSHR"].into_iter().find_map(|word| Some((word, numbered(word)?)));
    let Some((word, face)) = found else {
        let known = "P1 to P6, TRVEC1 to TRVEC6, TRSHR1 to TRSHR6, PX, PY, PZ, BX, BY, BZ, BR, GRAV, \
                     CENTRIF";
        unknown(line, known, draft);
        return None;
    };
    if !(1..=6).contains(&face) {
        let message = format!("no element has a face {face}");
        let span = line.fields.get(1).map_or(line.span, |field| field.span);
        let error = Diagnostic::error(Code("SL0256"), message).at(span);
        let help = "faces are 1 to 3 or 4 in the plane, 1 to 4 of tetrahedra, to 5 of wedges, \
                    to 6 of bricks";
        draft.log.push(error.help(help));
        return None;
    }
    let kind = match word {
        "TRVEC" => Kind::Traction(direction(line, 3, draft)?),
        "TRSHR" => Kind::Shear(direction(line, 3, draft)?),
        _ => {
            draft.log.at_most(line, 3);
            Kind::Pressure
        }
    };
    Some((kind, face - 1))
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
