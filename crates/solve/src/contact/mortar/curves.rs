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
/// Part of that angle by which parts may be larger [1]: arcs are mostly quarters and halves of a
/// circle, and the last digits of a deck, as of one that was turned, must not say into how many
/// parts they are cut.
const SLACK: f64 = 0.01;

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
            let parts = (sweep / ANGLE - SLACK).ceil().max(1.0);
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: a quarter of a circle is cut in three, also where its ends are rounded, as in a
    /// deck that was turned.
    #[test]
    fn rounding_does_not_say_into_how_many_parts_an_arc_is_cut() {
        for angle in [0.0_f64, 0.3, 0.5, 1.0, 2.0, 3.0] {
            let at = |turn: f64| {
                let digits = |x: f64| (x * 1e5).round() / 1e5;
                [digits((angle + turn).cos()), digits((angle + turn).sin())]
            };
            let quarter = [at(0.0), at(std::f64::consts::FRAC_PI_2)];
            let arc = RigidSegment::arc(quarter[0], quarter[1], [0.0, 0.0]);
            let mut curves = Vec::new();
            arc.iter().for_each(|arc| of_segment(arc, &mut curves));
            assert_eq!(curves.len(), 3, "{angle}");
        }
    }
}
