//! Normals that look the wrong way.

use crate::finding::{Finding, Place};
use crate::start::{Start, spacing};
use slideline_diag::{Code, Diagnostic};
use slideline_model::{ContactPair, Master, RigidSurface, SlideLine, SurfaceSegment};
use std::fmt::Write as _;

/// SL0407: most slaves lie deeper behind their master than a contact element
/// is long. [semantics: wrong side]
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    for (place, pair) in start.model.contact_pairs.iter().enumerate() {
        let spacing = spacing(start.model, pair);
        let facing = start.facing(place).count();
        let behind = start.facing(place).filter(|row| row.opening < -spacing).count();
        if behind > 0 && 2 * behind >= facing {
            findings.push(say(start, pair, behind, facing));
        } else if opens(start, place, pair) {
            findings.push(say(start, pair, facing, facing));
        }
    }
}

/// Whether every slave lies behind the master at first, deeper than its law
/// reaches, and the prescribed motion brings them all out in front of it:
/// parts that meet do the opposite.
fn opens(start: &Start<'_>, place: usize, pair: &ContactPair) -> bool {
    let Some(Some(rehearsal)) = start.rehearsals.get(place) else { return false };
    let ranges = || rehearsal.moments.iter().filter_map(|moment| moment.range);
    let (Some((least, _)), Some((_, most))) = (ranges().next(), ranges().next_back()) else {
        return false;
    };
    let floor = (1e-6 * start.reach).max(pair.interaction.normal.contact_begins().abs());
    least > floor && most < 0.0
}

fn say(start: &Start<'_>, pair: &ContactPair, behind: usize, facing: usize) -> Finding {
    let (origin, help) = match &pair.master {
        Master::SlideLine(line) => (
            line.origin,
            "list the nodes of *SLIDE LINE in the opposite order, or name the other side of *SURFACE \
             (SPOS, SNEG): the outward normal stands 90 degrees counter-clockwise of travel",
        ),
        Master::RigidSurface(surface) => (
            surface.origin,
            "give the points of *RIGID SURFACE (*SURFACE, TYPE=SEGMENTS) in the opposite order: the \
             outward normal stands 90 degrees counter-clockwise of travel",
        ),
    };
    let place = start.model.contact_pairs.iter().position(|own| own == pair);
    let nearest = place.into_iter().flat_map(|place| start.facing(place));
    let deepest = nearest.map(|row| -row.opening).fold(0.0, f64::max);
    let message = format!(
        "the master of {} seems to look the wrong way: {behind} of {facing} slave points lie \
         behind it at the start, the deepest by {:.3e}",
        pair.name, deepest
    );
    let said = Diagnostic::warning(Code("SL0407"), message).at(origin).help(help);
    let text = match &pair.master {
        Master::SlideLine(line) => reversed(start, pair, line),
        Master::RigidSurface(surface) => backwards(surface),
    };
    match &pair.master {
        // of a modern pair another card names the line
        Master::SlideLine(_) if pair.name.contains('/') => Finding::said(said),
        Master::SlideLine(_) => Finding::with(said, Place::Instead(origin), text),
        Master::RigidSurface(_) => Finding::with(said, Place::Data(origin), text),
    }
}

/// The points of a rigid surface in opposite order.
fn backwards(surface: &RigidSurface) -> String {
    let mut points: Vec<[f64; 2]> = vec![surface.start];
    points.extend(surface.segments.iter().map(SurfaceSegment::end));
    let mut text = String::new();
    if let Some([x, y]) = points.last() {
        let _ = writeln!(text, "START, {x:?}, {y:?}"); // a String takes any text
    }
    for (segment, [x, y]) in surface.segments.iter().zip(&points).rev() {
        let _ = match *segment {
            SurfaceSegment::Line { .. } => writeln!(text, "LINE, {x:?}, {y:?}"),
            SurfaceSegment::Circle { centre, .. } => {
                writeln!(text, "CIRCL, {x:?}, {y:?}, {:?}, {:?}", centre[0], centre[1])
            }
            SurfaceSegment::Parabola { middle, .. } => {
                writeln!(text, "PARAB, {:?}, {:?}, {x:?}, {y:?}", middle[0], middle[1])
            }
        }; // as above
    }
    text
}

/// The slide line's card with its nodes in opposite order.
fn reversed(start: &Start<'_>, pair: &ContactPair, line: &SlideLine) -> String {
    let mut text = format!(
        "*SLIDE LINE, TYPE=LINEAR, ELSET={}, SMOOTH={:?}, EXTENSION ZONE={:?}\n",
        pair.name, line.smooth, line.extension
    );
    let nodes: Vec<String> =
        line.nodes.iter().rev().map(|&node| start.model.nodes.label(node).to_string()).collect();
    for row in nodes.chunks(16) {
        let _ = writeln!(text, "{}", row.join(", ")); // a String takes any text
    }
    text
}
