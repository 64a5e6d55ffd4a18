//! Normals that look the wrong way.

use crate::alike::{is_drawn, look_alike};
use crate::finding::{Finding, Place};
use crate::start::{Start, spacing};
use slideline_diag::{Code, Diagnostic, Span};
use slideline_mech::surface::swept::Sweep;
use slideline_model::{
    ContactPair, Master, MasterFaces, OwnSurface, ProfilePoint, RigidSurface, SlideLine,
    SurfaceSegment, Vocabulary,
};
use std::fmt::Write as _;

/// Depth of a slave in contact element lengths that counts as behind: one, but for rounding [1].
const LEAST: f64 = 1.0 - 1e-9;

/// SL0407: most slaves lie deeper behind their master than a contact element
/// is long. [semantics: wrong side]
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    for (place, pair) in start.model.contact_pairs.iter().enumerate() {
        let spacing = spacing(start.model, pair);
        let facing = start.facing(place).count();
        let behind = start.facing(place).filter(|row| row.opening <= -LEAST * spacing).count();
        let stand = |count: usize| {
            let deepest = start.facing(place).map(|row| -row.opening).fold(0.0, f64::max);
            format!(
                "{count} of {facing} slave points lie behind it at the start, the deepest by {deepest:.3e}"
            )
        };
        if behind > 0 && 2 * behind >= facing {
            findings.push(say(start, pair, &stand(behind)));
        } else if opens(start, place, pair) {
            findings.push(say(start, pair, &stand(facing)));
        } else if let Some([alike, facing]) = look_alike(start, place, pair) {
            let seen = format!(
                "{alike} of {facing} slave points touch or overlap it at the start and belong to faces that \
                 look the same way as its outside"
            );
            findings.push(say(start, pair, &seen));
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

/// What is said of masters whose order of points is not to blame, and their card.
fn of_bodies(start: &Start<'_>, pair: &ContactPair) -> Option<(Span, &'static str)> {
    let outward = "faces of solids look outward: do the parts overlap at the start, or does *SURFACE \
                   name faces on the far side?";
    match &pair.master {
        Master::RigidSurface(_) => None,
        Master::Faces(faces) if faces.swept.is_some() => None,
        Master::SlideLine(_) if pair.vocabulary != Vocabulary::Faces => None,
        Master::Faces(MasterFaces { origin, .. }) | Master::SlideLine(SlideLine { origin, .. })
            if is_drawn(start.model, pair) =>
        {
            let other = "name the other side of its rigid elements or beams in *SURFACE, SPOS or SNEG, or none: \
                         the master then turns to its slaves";
            Some((*origin, other))
        }
        Master::Itself(OwnSurface { origin, .. })
        | Master::Faces(MasterFaces { origin, meets_itself: true, .. }) => {
            let itself = "faces of solids look outward: do parts of the surface stand in one another at the \
                          start?";
            Some((*origin, itself))
        }
        Master::Faces(MasterFaces { origin, .. }) | Master::SlideLine(SlideLine { origin, .. }) => {
            Some((*origin, outward))
        }
    }
}

fn say(start: &Start<'_>, pair: &ContactPair, seen: &str) -> Finding {
    if let Some((origin, help)) = of_bodies(start, pair) {
        return Finding::said(wrong_side(pair, seen).at(origin).help(help));
    }
    let opposite = || {
        let of = match &pair.master {
            Master::Faces(MasterFaces { swept: Some(swept), .. }) => match swept.sweep {
                Sweep::Around => "*SURFACE, TYPE=REVOLUTION",
                Sweep::Along => "*SURFACE, TYPE=CYLINDER",
            },
            _ => pair.vocabulary.rigid_surface(),
        };
        format!("give the points of {of} in the opposite order")
    };
    let (origin, help) = match &pair.master {
        Master::SlideLine(line) => (line.origin, pair.vocabulary.turn_chain().to_owned()),
        Master::RigidSurface(RigidSurface { origin, .. })
        | Master::Faces(MasterFaces { origin, .. })
        | Master::Itself(OwnSurface { origin, .. }) => (*origin, opposite()),
    };
    let help = format!(
        "{help}: the outward normal is 90 degrees counter-clockwise from the \
                        direction of travel"
    );
    let said = wrong_side(pair, seen).at(origin).help(help);
    let text = match &pair.master {
        Master::SlideLine(line) => reversed(start, pair, line),
        Master::RigidSurface(surface) => SurfacePoints::of(surface).backwards().lines(),
        Master::Faces(_) | Master::Itself(_) => String::new(),
    };
    match &pair.master {
        // of a modern pair another card names the line
        Master::SlideLine(_) if pair.vocabulary == Vocabulary::Surfaces => Finding::said(said),
        Master::Faces(_) | Master::Itself(_) => Finding::said(said),
        Master::SlideLine(_) => Finding::with(said, Place::Instead(origin), text),
        Master::RigidSurface(_) => Finding::with(said, Place::Data(origin), text),
    }
}

fn wrong_side(pair: &ContactPair, seen: &str) -> Diagnostic {
    let message = format!("the master of {} seems to face the wrong way: {seen}", pair.name);
    Diagnostic::warning(Code("SL0407"), message)
}

/// The points of a rigid surface, to be written as data lines.
pub struct SurfacePoints {
    /// The first one [L].
    pub start: ProfilePoint,
    /// The way from there.
    pub segments: Vec<SurfaceSegment>,
}

impl SurfacePoints {
    /// Those of a surface.
    pub fn of(surface: &RigidSurface) -> Self {
        Self { start: surface.start, segments: surface.segments.clone() }
    }

    /// The same from the other end.
    fn backwards(self) -> Self {
        let mut points: Vec<ProfilePoint> = vec![self.start];
        points.extend(self.segments.iter().map(SurfaceSegment::end));
        let segments =
            self.segments.iter().zip(&points).rev().map(|(segment, &end)| match *segment {
                SurfaceSegment::Line { .. } => SurfaceSegment::Line { end },
                SurfaceSegment::Circle { centre, .. } => SurfaceSegment::Circle { end, centre },
                SurfaceSegment::Parabola { middle, .. } => SurfaceSegment::Parabola { middle, end },
            });
        let segments = segments.collect();
        Self { start: points.last().copied().unwrap_or(self.start), segments }
    }

    /// Data lines, each ended by a line feed.
    pub fn lines(&self) -> String {
        let mut text = format!("START, {:?}, {:?}\n", self.start[0], self.start[1]);
        for segment in &self.segments {
            let [x, y] = segment.end();
            let _ = match *segment {
                SurfaceSegment::Line { .. } => writeln!(text, "LINE, {x:?}, {y:?}"),
                SurfaceSegment::Circle { centre: [cx, cy], .. } => {
                    writeln!(text, "CIRCL, {x:?}, {y:?}, {cx:?}, {cy:?}")
                }
                SurfaceSegment::Parabola { middle: [mx, my], .. } => {
                    writeln!(text, "PARAB, {mx:?}, {my:?}, {x:?}, {y:?}")
                }
            }; // a String takes any text
        }
        text
    }
}

/// The slide line's card with its nodes in opposite order.
fn reversed(start: &Start<'_>, pair: &ContactPair, line: &SlideLine) -> String {
    let mut text = format!(
        "*SLIDE LINE, TYPE=LINEAR, ELSET={}, SMOOTH={:?}, EXTENSION ZONE={:?}\n",
        pair.name,
        line.smooth.unwrap_or(0.0),
        line.extension
    );
    let nodes: Vec<String> =
        line.nodes.iter().rev().map(|&node| start.model.nodes.name(node).to_string()).collect();
    for row in nodes.chunks(16) {
        let _ = writeln!(text, "{}", row.join(", ")); // a String takes any text
    }
    text
}
