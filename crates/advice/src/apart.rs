//! Pairs that nothing brings together.
//!
//! ```text
//!   [ slave ]  <---- gap ---->  [ master ]       gap > the way of all prescribed motions
//! ```
//!
//! The gap is that between the boxes about all faces, which none is nearer than. A force, a
//! temperature or a spring may move parts any way: then nothing is said.

use crate::finding::Finding;
use crate::start::{Start, length};
use slideline_diag::{Code, Diagnostic};
use slideline_model::{ContactPair, Master, NodeIndex, ProfilePoint, RigidSurface, SurfaceSegment};
use std::collections::HashMap;

/// Boxes that are held against one another at most.
const EFFORT: usize = 4_000_000;

/// A box about a face [L].
#[derive(Clone, Copy)]
struct Bounds {
    low: [f64; 3],
    high: [f64; 3],
}

/// SL0424: a pair that stays apart all the way.
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    if start.model.contact_pairs.is_empty() || !moved_by_supports_alone(start) {
        return;
    }
    let way = way_of_supports(start);
    for (place, pair) in start.model.contact_pairs.iter().enumerate() {
        let reach = -pair.interaction.normal.contact_begins();
        let touches = start.nearest(place).is_some_and(|row| row.opening <= reach);
        if touches || is_one_of_many(start, pair) || begins_inside(start, pair) {
            continue;
        }
        let Some(gap) = gap(start, pair) else { continue };
        if gap - reach > way && gap > 1e-6 * start.reach {
            findings.push(Finding::said(say(pair, gap, way)));
        }
    }
}

fn say(pair: &ContactPair, gap: f64, way: f64) -> Diagnostic {
    let message = format!(
        "the sides of {} never come near: they begin {gap:.4e} apart, and all prescribed motions \
         together go {way:.4e}",
        pair.name
    );
    Diagnostic::warning(Code("SL0424"), message).at(pair.origin).help(
        "is one part in the wrong place or in another unit, or is the wrong surface named? If the \
         pair is not needed, leave it out",
    )
}

/// Whether one card makes more pairs: of general contact some are meant to stay apart.
fn is_one_of_many(start: &Start<'_>, pair: &ContactPair) -> bool {
    start.model.contact_pairs.iter().filter(|other| other.origin == pair.origin).count() > 1
}

/// Whether bodies of both sides of a pair stand in one another: then the gap between faces is none.
fn begins_inside(start: &Start<'_>, pair: &ContactPair) -> bool {
    start.standing_in.iter().any(|two| start.brings(pair, two.bodies))
}

/// Whether nothing but prescribed motions moves anything.
fn moved_by_supports_alone(start: &Start<'_>) -> bool {
    let model = start.model;
    let heated = |step: &slideline_model::Step| !step.temperatures.is_empty();
    model.initial_stresses.is_empty()
        && model.steps.iter().all(|step| {
            let forces = &step.distributed;
            step.loads.is_empty()
                && forces.pressures.is_empty()
                && forces.forces.is_empty()
                && !heated(step)
        })
}

/// The farthest that supports go, those of all bodies together [L].
fn way_of_supports(start: &Start<'_>) -> f64 {
    let mut ways: HashMap<NodeIndex, f64> = HashMap::new();
    for step in &start.model.steps {
        let mut nodes: HashMap<NodeIndex, f64> = HashMap::new();
        for own in step.prescribed.iter().filter(|own| own.moves()) {
            let value = start.largest(own).abs();
            let arm = if own.dof.is_rotation() { start.size() } else { 1.0 };
            *nodes.entry(own.node).or_default() += arm * value;
        }
        for (node, way) in nodes {
            let most = ways.entry(start.bodies.of_node(node)).or_default();
            *most = most.max(way);
        }
    }
    ways.values().fold(0.0, |sum, way| sum + way)
}

/// The least distance of the boxes about the faces of both sides [L]; `None` where a side has no
/// end.
fn gap(start: &Start<'_>, pair: &ContactPair) -> Option<f64> {
    let box_of = |nodes: &[NodeIndex]| {
        Bounds::about(nodes.iter().map(|&node| start.model.nodes.position(node)))
    };
    let mut slaves: Vec<Bounds> = pair.faces.iter().map(|face| box_of(&face.nodes)).collect();
    slaves.extend(pair.elements.iter().map(|element| box_of(&element.nodes)));
    slaves.extend(pair.profile.iter().flat_map(profile));
    let mut masters: Vec<Bounds> = match &pair.master {
        Master::Faces(faces) if faces.swept.is_some() || faces.meets_itself => return None,
        Master::Faces(faces) => faces.faces.iter().map(|face| box_of(&face.nodes)).collect(),
        Master::SlideLine(line) => line.nodes.windows(2).map(box_of).collect(),
        Master::RigidSurface(surface) => profile(surface),
        Master::Itself(_) => return None,
    };
    if slaves.len().saturating_mul(masters.len()) > EFFORT {
        slaves = vec![Bounds::all(&slaves)];
        masters = vec![Bounds::all(&masters)];
    }
    let distances = slaves.iter().flat_map(|own| masters.iter().map(|other| own.distance(other)));
    distances.min_by(f64::total_cmp)
}

/// Boxes about the segments of a rigid surface; about the whole circle of an arc.
fn profile(surface: &RigidSurface) -> Vec<Bounds> {
    let raised = |[x, y]: ProfilePoint| [x, y, 0.0];
    let mut from = surface.start;
    let mut boxes = Vec::with_capacity(surface.segments.len());
    for segment in &surface.segments {
        let end = segment.end();
        let ends = [raised(from), raised(end)];
        boxes.push(match *segment {
            SurfaceSegment::Line { .. } => Bounds::about(ends.into_iter()),
            SurfaceSegment::Circle { centre: [x, y], .. } => {
                let radius = (from[0] - x).hypot(from[1] - y);
                let corners = [[x - radius, y - radius, 0.0], [x + radius, y + radius, 0.0]];
                Bounds::about(corners.into_iter())
            }
            SurfaceSegment::Parabola { middle, .. } => {
                // no farther beyond its ends than its middle is from their mean
                let mean = [0, 1].map(|k| 0.5 * (from[k] + end[k]));
                let beyond = [0, 1].map(|k| 2.0 * middle[k] - mean[k]);
                Bounds::about(ends.into_iter().chain([raised(middle), raised(beyond)]))
            }
        });
        from = end;
    }
    boxes
}

impl Bounds {
    fn about(points: impl Iterator<Item = [f64; 3]>) -> Self {
        let nothing = Self { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3] };
        points.fold(nothing, |own, at| Self {
            low: std::array::from_fn(|k| own.low[k].min(at[k])),
            high: std::array::from_fn(|k| own.high[k].max(at[k])),
        })
    }

    fn all(boxes: &[Self]) -> Self {
        Self::about(boxes.iter().flat_map(|own| [own.low, own.high]))
    }

    fn distance(&self, other: &Self) -> f64 {
        let between = |k: usize| (other.low[k] - self.high[k]).max(self.low[k] - other.high[k]);
        length(std::array::from_fn(|k| between(k).max(0.0)))
    }
}
