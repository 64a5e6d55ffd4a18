//! Tests of a rubber: the points of a card, and the law that is to come of them.
//!
//! ```text
//!   *HYPERELASTIC, TEST DATA INPUT   --> Wanted --+
//!   *UNIAXIAL TEST DATA ...          --> Test   --+--> Rubber, when the deck is read
//! ```

use slideline_deck::DataLine;
use slideline_diag::{Code, Diagnostic, Span};

use crate::draft::{Draft, Kind, Test};
use crate::reading::Reading;

/// Nominal strain that no rubber bears; it tears at half of it [1].
const FARTHEST: f64 = 20.0;

/// Takes a card of test data in.
pub(crate) fn read(kind: Kind, card: &Reading<'_>, draft: &mut Draft) {
    let own = (card.keyword.name, card.span());
    if draft.owning_material(own.0, own.1).is_none() {
        return;
    }
    let what = match kind {
        Kind::Mode(_) => "nominal stress, nominal strain",
        Kind::Volume => "pressure, ratio of volumes",
    };
    let points = card.first_line(what, &mut draft.log).and_then(|_| points(kind, card, draft));
    if let Some(material) = draft.owning_material(own.0, own.1) {
        material.tests.push(Test { kind, points, card: own });
    }
}

/// The points that count; complains about every one that cannot be.
fn points(kind: Kind, card: &Reading<'_>, draft: &mut Draft) -> Option<Vec<[f64; 2]>> {
    let mut points = Vec::with_capacity(card.data().len());
    let mut sound = true;
    for line in card.data() {
        draft.log.at_most(line, 2);
        let read = match kind {
            Kind::Mode(_) => draft.log.number(line, 0, "the nominal stress").zip(draft.log.number(
                line,
                1,
                "the nominal strain",
            )),
            Kind::Volume => draft.log.number(line, 0, "the pressure").zip(draft.log.number(
                line,
                1,
                "the ratio of volumes",
            )),
        };
        match read.map(|(force, motion)| [force, motion]) {
            Some(point) if is_at_rest(kind, point) => without_weight(line.span, draft),
            Some(point) if can_be(kind, point, line, draft) => points.push(point),
            _ => sound = false,
        }
    }
    sound.then_some(points)
}

/// Whether nothing acts and nothing moves.
fn is_at_rest(kind: Kind, [force, motion]: [f64; 2]) -> bool {
    force == 0.0 && motion == if kind == Kind::Volume { 1.0 } else { 0.0 }
}

fn without_weight(span: Span, draft: &mut Draft) {
    let message = "the unloaded state is no test: every law goes through it";
    draft.log.note("SL0281", message, span);
}

/// Whether a specimen can answer so; complains if not.
fn can_be(kind: Kind, [force, motion]: [f64; 2], line: &DataLine, draft: &mut Draft) -> bool {
    let (message, help) = match kind {
        Kind::Mode(_) if motion <= -1.0 => (
            format!("a nominal strain of {motion} leaves nothing of the specimen"),
            "nominal strain is the change of length over the length at first, not in percent",
        ),
        Kind::Mode(_) if motion > FARTHEST => (
            format!("a nominal strain of {motion} is beyond any rubber"),
            "the stress stands first, then the strain: a change of length over the length at first, \
             not in percent",
        ),
        Kind::Mode(_) if force * motion <= 0.0 => (
            format!("a nominal stress of {force} at a nominal strain of {motion}"),
            "both are positive where the specimen is pulled and negative where it is pressed; \
             the stress stands first",
        ),
        Kind::Volume if motion <= 0.0 => (
            format!("a ratio of volumes of {motion} leaves nothing of the specimen"),
            "give the volume over the volume at first",
        ),
        Kind::Volume if force * (1.0 - motion) <= 0.0 => (
            format!("a pressure of {force} at a ratio of volumes of {motion}"),
            "pressure is positive where the volume shrinks, that is below a ratio of 1; the \
             pressure stands first",
        ),
        _ => return true,
    };
    draft.log.push(Diagnostic::error(Code("SL0280"), message).at(line.span).help(help));
    false
}
