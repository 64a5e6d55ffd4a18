//! A master as curves.
//!
//! ```text
//!   o---o---m---o      a straight face, one with a middle node; of a rigid surface
//!                      lines, parabolas, and arcs in parts of 30 degrees at most
//! ```

use super::super::master::MasterSurface;
use super::slave::Control;
use slideline_mech::contact::search::rigid::RigidSegment;

/// A curve of a master.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MasterCurve {
    /// Its control points.
    pub controls: [Control; 3],
    /// How many they are.
    pub count: usize,
    /// Weight of the middle one [1].
    pub weight: f64,
}

/// Largest angle of a part of an arc [rad].
const ANGLE: f64 = std::f64::consts::FRAC_PI_6;

/// The curves of a master, in the order of travel.
pub fn curves(master: &MasterSurface, into: &mut Vec<MasterCurve>) {
    into.clear();
    match master {
        MasterSurface::Line { nodes, middles, .. } => {
            let mut first = 0;
            while first + 1 < nodes.len() {
                let has_middle = middles.get(first + 1).is_some_and(|&is_middle| is_middle);
                let count = if has_middle && first + 2 < nodes.len() { 3 } else { 2 };
                let [a, b, c] = [first, first + 1, first + 2];
                let second = match count {
                    3 => Control::Middle([a, b, c]),
                    _ => Control::Node(b),
                };
                let controls = [Control::Node(a), second, Control::Node(c)];
                into.push(MasterCurve { controls, count, weight: 1.0 });
                first += count - 1;
            }
        }
        MasterSurface::Body { surface, .. } => {
            surface.segments().iter().for_each(|segment| of_segment(segment, into));
        }
        MasterSurface::Faces { .. } | MasterSurface::Nothing => {}
    }
}

fn of_segment(segment: &RigidSegment, into: &mut Vec<MasterCurve>) {
    let raised = |[x, y]: slideline_model::ProfilePoint| Control::Body([x, y, 0.0]);
    match *segment {
        RigidSegment::Line { a, b } => {
            let controls = [raised(a), raised(b), raised(b)];
            into.push(MasterCurve { controls, count: 2, weight: 1.0 });
        }
        RigidSegment::Parabola { start, mid, end } => {
            let controls = RigidSegment::parabola_control(start, mid, end).map(raised);
            into.push(MasterCurve { controls, count: 3, weight: 1.0 });
        }
        RigidSegment::Arc { centre, sweep, .. } => {
            let parts = (sweep / ANGLE).ceil().max(1.0);
            let weight = (0.5 * sweep / parts).cos();
            for part in 0..parts as usize {
                let at = |by: f64| segment.place((part as f64 + by) / parts);
                let top = at(0.5);
                // where the tangents at both ends meet
                let meet = [0, 1].map(|axis| centre[axis] + (top[axis] - centre[axis]) / weight);
                let controls = [at(0.0), meet, at(1.0)].map(raised);
                into.push(MasterCurve { controls, count: 3, weight });
            }
        }
    }
}
