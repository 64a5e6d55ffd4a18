//! `*SURFACE, TYPE=CYLINDER` and `TYPE=REVOLUTION`: profiles that sweep surfaces in space.
//!
//! ```text
//!    CYLINDER    a origin, b on the x-axis, c on the way along which it is drawn;
//!                y stands so that (x, y, c - a) is left-handed: c is on the negative z-axis
//!    REVOLUTION  a, b on the axis; the profile has r and z
//! ```

use slideline_deck::{DataLine, normalise};
use slideline_mech::vector::{cross, dot};
use slideline_model::Sweep;

use super::rigid_surface::profile;
use crate::draft::Draft;
use crate::reading::Reading;
use crate::surfaces::{Extent, SweptAxes};

type Vector = [f64; 3];

/// `a, b`, `c`, then the profile; without the first two lines the axes of the part.
pub(super) fn drawn_along(card: &Reading<'_>, draft: &mut Draft) -> Option<Extent> {
    let lines = with_axes(card, 2, draft)?;
    let (axes, rest) = match lines {
        ([], rest) => (PLAIN, rest),
        (given, rest) => {
            let (a, b) = (place(&given[0], 0, draft), place(&given[0], 3, draft));
            draft.log.at_most(&given[0], 6);
            draft.log.at_most(&given[1], 3);
            let c = place(&given[1], 0, draft);
            let (a, b, c) = (a?, b?, c?);
            let x = unit(difference(b, a));
            let way = difference(c, a);
            let along = x.map(|x| unit(difference(way, x.map(|x_k| x_k * dot(way, x)))));
            let Some((x, Some(way))) = x.zip(along) else {
                let message = "a, b and c must not lie on one line: a to b is the x-axis, a to c the \
                               way along which the profile is drawn";
                draft.log.error("SL0237", message, given[0].span);
                return None;
            };
            (SweptAxes { directions: [x, cross(x, way), way], origin: a, ..PLAIN }, rest)
        }
    };
    let (start, segments) = profile(card, rest, draft)?;
    Some(Extent::Swept { start, segments, axes })
}

/// `a, b`, then the profile; without the first line the axis of a part is its y-axis.
pub(super) fn turned_about(card: &Reading<'_>, draft: &mut Draft) -> Option<Extent> {
    let (given, rest) = with_axes(card, 1, draft)?;
    let (a, b) = match given {
        [] => ([0.0; 3], [0.0, 1.0, 0.0]),
        [line, ..] => {
            draft.log.at_most(line, 6);
            let (a, b) = (place(line, 0, draft), place(line, 3, draft));
            (a?, b?)
        }
    };
    let Some(axis) = unit(difference(b, a)) else {
        let message = "a and b, the points of the axis, coincide";
        draft.log.error("SL0237", message, given[0].span);
        return None;
    };
    let (start, segments) = profile(card, rest, draft)?;
    let places = || std::iter::once(start).chain(segments.iter().map(|segment| segment.end()));
    if let Some(beyond) = places().find(|place| place[0] < 0.0) {
        let message = format!("r = {} of the profile is negative: it is a distance", beyond[0]);
        draft.log.error("SL0237", message, card.span());
        return None;
    }
    let least = (0..3).min_by(|&p, &q| axis[p].abs().total_cmp(&axis[q].abs())).unwrap_or(0);
    let beside = std::array::from_fn(|k| f64::from(u8::from(k == least)));
    let x = unit(cross(beside, axis))?;
    let directions = [x, cross(axis, x), axis];
    let axes = SweptAxes { sweep: Sweep::Around, origin: a, directions };
    Some(Extent::Swept { start, segments, axes })
}

/// The axes of a part.
const PLAIN: SweptAxes = SweptAxes {
    sweep: Sweep::Along,
    origin: [0.0; 3],
    directions: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]],
};

/// The lines that give axes, of which there are `count` or none, and those of the profile.
fn with_axes<'a>(
    card: &'a Reading<'_>,
    count: usize,
    draft: &mut Draft,
) -> Option<(&'a [DataLine], &'a [DataLine])> {
    let first = card.first_line("the axes, then START, x, y", &mut draft.log)?;
    let starts =
        |line: &DataLine| line.field(0).is_some_and(|field| normalise(&field.text) == "START");
    if starts(first) {
        return Some((&[], card.data()));
    }
    if card.data().len() <= count {
        let message = "the profile START, x, y is missing behind the axes";
        draft.log.error("SL0237", message, card.span());
        return None;
    }
    Some(card.data().split_at(count))
}

fn place(line: &DataLine, first: usize, draft: &mut Draft) -> Option<Vector> {
    let mut at = [0.0; 3];
    for (k, x) in at.iter_mut().enumerate() {
        *x = draft.log.maybe_number(line, first + k)?.unwrap_or(0.0);
    }
    Some(at)
}

fn difference(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|k| a[k] - b[k])
}

fn unit(a: Vector) -> Option<Vector> {
    let size = dot(a, a).sqrt();
    (size > 0.0 && size.is_finite()).then(|| a.map(|x| x / size))
}
