//! Profiles of analytic surfaces, ready to be searched.
//!
//! ```text
//!    start o----o  line         segments one after the other, each from the end of the one before
//!               (  arc
//!                o--  parabola
//! ```

use slideline_mech::contact::pair::RigidSurface;
use slideline_mech::contact::search::rigid::RigidSegment;
use slideline_mech::surface::swept::Swept;
use slideline_model::{ProfilePoint, SurfaceSegment, SweptSurface};

/// A model's rigid surface with its arc coordinates, undeformed. `None`: an
/// arc without end or with ends at different distances of its centre.
pub fn placed(surface: &slideline_model::RigidSurface) -> Option<RigidSurface> {
    let mut segments = Vec::with_capacity(surface.segments.len());
    for segment in placed_segments(surface) {
        segments.push(segment?);
    }
    Some(RigidSurface::new(segments))
}

/// The profile of an analytical surface in space; `None` as of [`placed`].
pub(super) fn swept_profile(surface: &SweptSurface) -> Option<Swept> {
    let segments: Option<Vec<_>> = in_place(surface.start, &surface.segments).collect();
    Some(Swept { segments: segments?, sweep: surface.sweep, length: surface.length })
}

/// Its segments one after the other; `None` in place of an impossible arc.
pub(super) fn placed_segments(
    surface: &slideline_model::RigidSurface,
) -> impl Iterator<Item = Option<RigidSegment>> {
    in_place(surface.start, &surface.segments)
}

fn in_place(
    start: ProfilePoint,
    segments: &[SurfaceSegment],
) -> impl Iterator<Item = Option<RigidSegment>> {
    let mut from = start;
    segments.iter().map(move |segment| {
        let placed = match *segment {
            SurfaceSegment::Line { end } => RigidSegment::Line { a: from, b: end },
            SurfaceSegment::Circle { end, centre } => RigidSegment::arc(from, end, centre)?,
            SurfaceSegment::Parabola { middle, end } => {
                RigidSegment::Parabola { start: from, mid: middle, end }
            }
        };
        from = placed.end();
        Some(placed)
    })
}
