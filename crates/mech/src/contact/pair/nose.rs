//! Corners and arcs of a rigid surface that may pass between slave points.
//!
//! ```text
//!     a o - - - - - - - o b      depth: how far the nose reaches through a-b
//!            \  ^  /             beside: where between a and b it does
//!             \ | /
//!         nose '-'
//! ```

use super::super::search::segment::RigidSegment;
use super::body::Body;
use std::f64::consts::FRAC_PI_2;

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
        /// Angles by which arcs that join it smoothly go on before it and behind it [rad].
        beyond: [f64; 2],
    },
}

/// Part of its width by which a nose narrower than the distance of two points may reach between
/// them [1].
const NARROW: f64 = 0.1;
/// Part of the distance of two points by which any other nose may [1]: what Abaqus allows as HCRIT.
const WIDE: f64 = 0.5;

impl Nose {
    /// Writes those of a surface.
    pub fn find(segments: &[RigidSegment], closed: bool, noses: &mut Vec<Self>) {
        noses.clear();
        for (index, segment) in segments.iter().enumerate() {
            if let RigidSegment::Arc { centre, radius, convex: true, .. } = *segment {
                let beyond = [false, true].map(|ahead| arcs_beyond(segments, closed, index, ahead));
                noses.push(Self::Arc { segment: *segment, centre, radius, beyond });
            }
            let Some(next) = neighbour(segments, closed, index, true) else { continue };
            let next = &segments[next];
            let tangents = [segment.tangent(false), next.tangent(true)];
            if turns_outward(tangents) {
                noses.push(Self::Corner { at: segment.end(), tangents });
            }
        }
    }

    /// How it reaches through the line between two points of space; `None` where it points
    /// elsewhere.
    pub fn reach(&self, body: &Body, edge: [[f64; 3]; 2]) -> Option<Reach> {
        let [a, b] = edge.map(|point| body.in_frame(point));
        let along = [b[0] - a[0], b[1] - a[1]];
        let length = along[0].hypot(along[1]);
        let across = [-along[1] / length, along[0] / length];
        let of = |at: [f64; 2], outward: [f64; 2]| {
            let apart = [at[0] - a[0], at[1] - a[1]];
            let depth = outward[0] * apart[0] + outward[1] * apart[1];
            let beside = (along[0] * apart[0] + along[1] * apart[1]) / (length * length);
            Reach { depth, beside, allowed: self.allowed(outward, length) }
        };
        let sides = [across, across.map(|x| -x)].into_iter();
        let depths = sides.filter(|side| self.points_along(*side)).map(|side| match *self {
            Self::Corner { at, .. } => of(at, side),
            Self::Arc { centre, radius, .. } => {
                of([centre[0] + radius * side[0], centre[1] + radius * side[1]], side)
            }
        });
        depths
            .min_by(|a, b| a.depth.abs().total_cmp(&b.depth.abs()))
            .filter(|reach| reach.depth.is_finite())
    }

    /// Whether a line across `side` could touch the nose alone.
    fn points_along(&self, side: [f64; 2]) -> bool {
        match self {
            Self::Corner { tangents: [before, after], .. } => {
                // the surface goes up to the corner and down behind it
                before[0] * side[0] + before[1] * side[1] >= 0.0
                    && after[0] * side[0] + after[1] * side[1] <= 0.0
            }
            Self::Arc { segment, centre, radius, .. } => {
                segment.holds([centre[0] + radius * side[0], centre[1] + radius * side[1]])
            }
        }
    }

    /// Depth that two points at a `distance` let it reach along `side` [L]: a nose that is wider than
    /// that touches them before, a narrower one never does.
    fn allowed(&self, side: [f64; 2], distance: f64) -> f64 {
        let width = self.width(side, WIDE * distance);
        if width < distance { NARROW * width } else { WIDE * distance }
    }

    /// Its width at a depth below its outermost place along `side`, flanks taken as straight [L].
    fn width(&self, side: [f64; 2], depth: f64) -> f64 {
        let flank = |radius: f64, slope: f64| {
            if slope >= FRAC_PI_2 {
                return radius;
            }
            let (sin, cos) = slope.sin_cos();
            let round = radius * (1.0 - cos);
            match depth <= round {
                true => (depth * (2.0 * radius - depth)).sqrt(),
                false => radius * sin + (depth - round) * cos / sin,
            }
        };
        match self {
            Self::Corner { tangents: [before, after], .. } => {
                let rise = |t: &[f64; 2]| (t[0] * side[0] + t[1] * side[1]).clamp(-1.0, 1.0);
                flank(0.0, rise(before).asin()) + flank(0.0, (-rise(after)).asin())
            }
            Self::Arc { segment, centre, radius, beyond } => {
                let top = [centre[0] + radius * side[0], centre[1] + radius * side[1]];
                let at = segment.angle_to(top).clamp(0.0, segment.sweep());
                let slopes = [at + beyond[0], segment.sweep() - at + beyond[1]];
                flank(*radius, slopes[0]) + flank(*radius, slopes[1])
            }
        }
    }
}

/// How a nose stands against the line between two points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reach {
    /// How far it reaches through the line [L], positive behind it.
    pub depth: f64,
    /// Where between the points, 0 to 1.
    pub beside: f64,
    /// Depth that is allowed [L].
    pub allowed: f64,
}

/// The segment before or behind another.
fn neighbour(segments: &[RigidSegment], closed: bool, index: usize, ahead: bool) -> Option<usize> {
    let last = segments.len() - 1;
    match (ahead, index) {
        (true, _) if index < last => Some(index + 1),
        (true, _) => closed.then_some(0),
        (false, 0) => closed.then_some(last),
        (false, _) => Some(index - 1),
    }
}

/// Angle by which convex arcs go on smoothly beyond an end of a segment [rad].
fn arcs_beyond(segments: &[RigidSegment], closed: bool, index: usize, ahead: bool) -> f64 {
    let (mut angle, mut at) = (0.0, index);
    for _ in 1..segments.len() {
        let Some(next) = neighbour(segments, closed, at, ahead) else { break };
        let (first, second) = if ahead { (at, next) } else { (next, at) };
        let tangents = [segments[first].tangent(false), segments[second].tangent(true)];
        let arc = matches!(segments[next], RigidSegment::Arc { convex: true, .. });
        if !arc || turns_outward(tangents) || turns_outward([tangents[1], tangents[0]]) {
            break;
        }
        angle += segments[next].sweep();
        at = next;
    }
    angle
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

/// Turn of a corner that is none of rounding [1].
const SMOOTH: f64 = 1e-9;

/// Whether a surface with these directions before and behind a corner turns outward there.
fn turns_outward([before, after]: [[f64; 2]; 2]) -> bool {
    before[0] * after[1] - before[1] * after[0] < -SMOOTH
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(segments: &[RigidSegment], closed: bool) -> Vec<Nose> {
        let mut noses = Vec::new();
        Nose::find(segments, closed, &mut noses);
        noses
    }

    fn body() -> Body {
        Body::STILL
    }

    fn circle(radius: f64) -> Vec<RigidSegment> {
        let corner = [[radius, 0.0], [0.0, -radius], [-radius, 0.0], [0.0, radius]];
        (0..4)
            .map(|k| RigidSegment::arc(corner[k], corner[(k + 1) % 4], [0.0; 2]).unwrap())
            .collect()
    }

    /// Requirement: a circle below a line reaches through it by its radius less the distance of its
    /// centre, and a circle narrower than the line may do so by a tenth of its width only.
    #[test]
    fn a_circle_between_two_points() {
        for (radius, allowed) in [(1.0, 0.2), (4.0, 3.0)] {
            let noses = found(&circle(radius), true);
            let edge = [[-3.0, radius - 0.1, 0.0], [3.0, radius - 0.1, 0.0]];
            let reaches: Vec<_> = noses.iter().filter_map(|n| n.reach(&body(), edge)).collect();
            let top = reaches.iter().find(|reach| reach.depth.abs() < radius).unwrap();
            assert!((top.depth - 0.1).abs() < 1e-14 && (top.beside - 0.5).abs() < 1e-14);
            assert!((top.allowed - allowed).abs() < 1e-12, "{top:?}");
        }
    }

    /// Requirement: a small fillet between wide flanks is no narrow nose.
    #[test]
    fn a_fillet_is_as_wide_as_its_flanks() {
        let (sin, cos) = 0.5f64.sin_cos();
        let left = [-0.1 * sin, 0.1 * cos];
        let right = [0.1 * sin, 0.1 * cos];
        let segments = [
            RigidSegment::Line { a: [left[0] - 5.0 * cos, left[1] - 5.0 * sin], b: left },
            RigidSegment::arc(left, right, [0.0; 2]).unwrap(),
            RigidSegment::Line { a: right, b: [right[0] + 5.0 * cos, right[1] - 5.0 * sin] },
        ];
        let noses = found(&segments, false);
        assert_eq!(noses.len(), 1, "{noses:?}");
        let reach = noses[0].reach(&body(), [[-1.0, 0.05, 0.0], [1.0, 0.05, 0.0]]).unwrap();
        assert!((reach.depth - 0.05).abs() < 1e-14 && (reach.allowed - 1.0).abs() < 1e-12);
    }
}
