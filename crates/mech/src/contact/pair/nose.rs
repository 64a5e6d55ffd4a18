//! Corners and arcs of a rigid surface that may pass between slave points.
//!
//! ```text
//!     a o - - - - - - - o b      depth: how far the nose reaches through a-b
//!            \  ^  /             beside: where between a and b it does
//!             \ | /
//!         nose '-'
//! ```

use super::super::search::rigid::{RigidSegment, beyond_corner};
use super::Body;

/// A part of a rigid surface that is turned outward, in the frame of the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Nose {
    /// A corner.
    Corner {
        /// Its position [L].
        at: [f64; 2],
        /// Directions of the surface before and behind it [1].
        tangents: [[f64; 2]; 2],
    },
    /// An arc, of which the outermost place counts.
    Arc {
        /// The arc.
        segment: RigidSegment,
        /// Its centre [L].
        centre: [f64; 2],
        /// Its radius [L].
        radius: f64,
    },
}

/// Part of its radius by which an arc narrower than the distance of two points may reach between
/// them [1].
const NARROW: f64 = 0.1;
/// Part of the distance of two points by which any other nose may [1]: what Abaqus allows as HCRIT.
const WIDE: f64 = 0.5;

impl Nose {
    /// Those of a surface.
    pub fn of(segments: &[RigidSegment], closed: bool) -> Vec<Self> {
        let mut noses = Vec::new();
        for (index, segment) in segments.iter().enumerate() {
            if let RigidSegment::Arc { centre, radius, convex: true, .. } = *segment {
                noses.push(Self::Arc { segment: *segment, centre, radius });
            }
            let next = match segments.get(index + 1) {
                None if closed => segments.first(),
                other => other,
            };
            let Some(next) = next else { continue };
            let tangents = [segment.tangent(false), next.tangent(true)];
            if beyond_corner(tangents) {
                noses.push(Self::Corner { at: segment.end(), tangents });
            }
        }
        noses
    }

    /// How far it reaches through the line between two points of space [L], positive behind them,
    /// and where between them, 0 to 1; `None` where it points elsewhere.
    pub fn depth(&self, body: &Body, edge: [[f64; 2]; 2]) -> Option<(f64, f64)> {
        let [a, b] = edge.map(|point| body.to_body(point));
        let along = [b[0] - a[0], b[1] - a[1]];
        let length = along[0].hypot(along[1]);
        let across = [-along[1] / length, along[0] / length];
        let of = |at: [f64; 2], outward: [f64; 2]| {
            let apart = [at[0] - a[0], at[1] - a[1]];
            let depth = outward[0] * apart[0] + outward[1] * apart[1];
            let beside = (along[0] * apart[0] + along[1] * apart[1]) / (length * length);
            (depth, beside)
        };
        let sides = [across, across.map(|x| -x)].into_iter();
        let depths = sides.filter(|side| self.points_along(*side)).map(|side| match *self {
            Self::Corner { at, .. } => of(at, side),
            Self::Arc { centre, radius, .. } => {
                of([centre[0] + radius * side[0], centre[1] + radius * side[1]], side)
            }
        });
        depths.min_by(|a, b| a.0.abs().total_cmp(&b.0.abs())).filter(|(depth, _)| depth.is_finite())
    }

    /// Whether a line across `side` could touch the nose alone.
    fn points_along(&self, side: [f64; 2]) -> bool {
        match self {
            Self::Corner { tangents: [before, after], .. } => {
                // the surface goes up to the corner and down behind it
                before[0] * side[0] + before[1] * side[1] >= 0.0
                    && after[0] * side[0] + after[1] * side[1] <= 0.0
            }
            Self::Arc { segment, centre, radius } => {
                segment.holds([centre[0] + radius * side[0], centre[1] + radius * side[1]])
            }
        }
    }

    /// Depth that points at a `distance` let it reach [L]: a nose that is wider than that touches
    /// them before, a narrower one never does.
    pub fn allowed(&self, distance: f64) -> f64 {
        match *self {
            Self::Arc { radius, .. } if 2.0 * radius < distance => NARROW * radius,
            _ => WIDE * distance,
        }
    }
}

/// A circle that holds all segments: about the middle of the box of their ends, with room for what
/// bulges between them.
pub(super) fn bounds(segments: &[RigidSegment]) -> ([f64; 2], f64) {
    let ends = segments.iter().flat_map(|segment| [segment.start(), segment.end()]);
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for end in ends {
        for axis in 0..2 {
            low[axis] = low[axis].min(end[axis]);
            high[axis] = high[axis].max(end[axis]);
        }
    }
    let bulge = segments.iter().map(|segment| match *segment {
        RigidSegment::Line { .. } => 0.0,
        _ => segment.length(),
    });
    let middle = [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])];
    let half = 0.5 * (high[0] - low[0]).hypot(high[1] - low[1]);
    (middle, half + bulge.fold(0.0, f64::max))
}
