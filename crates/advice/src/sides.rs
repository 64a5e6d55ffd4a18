//! Normals that look the wrong way.

use crate::finding::{Finding, Place};
use crate::start::{Start, less, spacing};
use slideline_diag::{Code, Diagnostic};
use slideline_model::{
    ContactPair, Master, MasterFaces, NodeIndex, OwnSurface, ProfilePoint, RigidSurface, SlideLine,
    SurfaceSegment, Vocabulary,
};
use slideline_solve::observe::ContactRow;
use std::collections::HashMap;
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
        if behind > 0 && 2 * behind >= facing {
            findings.push(say(start, pair, behind, facing));
        } else if opens(start, place, pair) {
            findings.push(say(start, pair, facing, facing));
        } else if let Some(alike) = look_alike(start, place, pair) {
            findings.push(say(start, pair, alike, facing));
        }
    }
}

/// How many points overlap a rigid profile whose outside looks the same way as their own faces; `None`
/// where those are not the most of all that overlap: parts that touch look at one another.
fn look_alike(start: &Start<'_>, place: usize, pair: &ContactPair) -> Option<usize> {
    if !pair.of_solids || !matches!(pair.master, Master::RigidSurface(_)) {
        return None;
    }
    let normals = outward(start, pair);
    let overlapping = || start.facing(place).filter(|row| row.opening < 0.0);
    let looks_alike = |row: &&ContactRow| {
        normals.get(&row.node).is_some_and(|[x, y]| x * row.normal[0] + y * row.normal[1] > 0.0)
    };
    let alike = overlapping().filter(looks_alike).count();
    (alike > 0 && 2 * alike > overlapping().count()).then_some(alike)
}

/// The sums of the outward normals of the faces at every slave node, as long as these [L].
fn outward(start: &Start<'_>, pair: &ContactPair) -> HashMap<NodeIndex, ProfilePoint> {
    let mut normals: HashMap<NodeIndex, ProfilePoint> = HashMap::new();
    for [from, to] in pair.elements.iter().map(|element| element.nodes) {
        let along = less(start.model.nodes.position(to), start.model.nodes.position(from));
        for node in [from, to] {
            // the material is on the left of the way
            let normal = normals.entry(node).or_default();
            *normal = [normal[0] + along[1], normal[1] - along[0]];
        }
    }
    normals
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
        Master::Faces(faces) if !faces.meets_itself => {
            let said = wrong_side(start, pair, behind, facing).at(faces.origin);
            return Finding::said(said.help(
                "faces of solids look outward: do the parts overlap at the start, or does *SURFACE \
                 name faces on the far side?",
            ));
        }
        Master::Itself(OwnSurface { origin, .. }) | Master::Faces(MasterFaces { origin, .. }) => {
            let said = wrong_side(start, pair, behind, facing).at(*origin);
            return Finding::said(said.help(
                "faces of solids look outward: do parts of the surface stand in one another at the \
                 start?",
            ));
        }
        Master::SlideLine(line) if pair.vocabulary == Vocabulary::Faces => {
            let said = wrong_side(start, pair, behind, facing).at(line.origin);
            return Finding::said(said.help(
                "faces of solids look outward: do the parts overlap at the start, or does *SURFACE \
                 name faces on the far side?",
            ));
        }
        Master::SlideLine(line) => (line.origin, pair.vocabulary.turn_chain().to_owned()),
        Master::RigidSurface(surface) => (
            surface.origin,
            format!("give the points of {} in the opposite order", pair.vocabulary.rigid_surface()),
        ),
    };
    let help = format!(
        "{help}: the outward normal is 90 degrees counter-clockwise from the \
                        direction of travel"
    );
    let said = wrong_side(start, pair, behind, facing).at(origin).help(help);
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

fn wrong_side(start: &Start<'_>, pair: &ContactPair, behind: usize, facing: usize) -> Diagnostic {
    let place = start.model.contact_pairs.iter().position(|own| own == pair);
    let nearest = place.into_iter().flat_map(|place| start.facing(place));
    let deepest = nearest.map(|row| -row.opening).fold(0.0, f64::max);
    let message = format!(
        "the master of {} seems to face the wrong way: {behind} of {facing} slave points lie \
         behind it at the start, the deepest by {deepest:.3e}",
        pair.name
    );
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
