//! Analytical surfaces in space on their rigid bodies: four markers that move with the reference node.

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{
    ContactFace, MasterFaces, Node, NodeIndex, ProfilePoint, SurfaceSegment, SweptSurface,
};

use super::owners::owner;
use crate::draft::Draft;
use crate::rule::Subject;
use crate::surfaces::{NamedSurface, SweptAxes};

/// Distance of the markers over the size of the profile [1].
const MARKERS: f64 = 0.1;

/// The surface as a master: each of its two charts a segment has the markers for nodes.
pub(super) fn swept(
    surface: &NamedSurface,
    (start, segments, axes): (ProfilePoint, &[SurfaceSegment], &SweptAxes),
    user: Span,
    draft: &mut Draft,
) -> Option<MasterFaces> {
    if !draft.model.is_in_space() {
        let message = format!("{} is a surface in space, the model is plane", surface.named.name);
        let error = Diagnostic::error(Code("SL0332"), message).at(user);
        let error = error.label(surface.origin, "here");
        draft.consequence(Subject::Contact, error.help("in the plane give TYPE=SEGMENTS"));
        return None;
    }
    let (body, reference) = owner(surface, user, draft)?;
    let origin = surface.origin;
    let length = MARKERS * size(start, segments);
    let known = draft.bodies[body].markers;
    let markers = known.unwrap_or_else(|| markers(axes, length, origin, draft));
    draft.bodies[body].markers = Some(markers);
    let face = ContactFace { label: 0, nodes: markers.to_vec(), origin };
    let (sweep, segments) = (axes.sweep, segments.to_vec());
    let faces = vec![face; 2 * segments.len()];
    let swept = SweptSurface { sweep, reference, start, segments, length };
    Some(MasterFaces {
        faces,
        smooth: false,
        extension: 0.0,
        swept: Some(swept),
        meets_itself: false,
        origin,
    })
}

/// The largest extent of a profile [L].
fn size(start: ProfilePoint, segments: &[SurfaceSegment]) -> f64 {
    let places = || std::iter::once(start).chain(segments.iter().map(SurfaceSegment::end));
    let range = |c: usize| {
        let most = places().map(|place| place[c]).fold(f64::NEG_INFINITY, f64::max);
        most - places().map(|place| place[c]).fold(f64::INFINITY, f64::min)
    };
    range(0).max(range(1))
}

/// Nodes at the origin of the axes and along them, with numbers above all others.
fn markers(axes: &SweptAxes, length: f64, origin: Span, draft: &mut Draft) -> [NodeIndex; 4] {
    let highest = draft.model.nodes.iter().map(|node| node.label).max().unwrap_or(0);
    let mut number = highest;
    let mut add = |position: [f64; 3]| {
        number += 1;
        draft.model.nodes.insert(Node { label: number, position, origin })
    };
    let at = |way: [f64; 3]| std::array::from_fn(|k| axes.origin[k] + length * way[k]);
    let [a, b, c] = axes.directions;
    [add(axes.origin), add(at(a)), add(at(b)), add(at(c))]
}
