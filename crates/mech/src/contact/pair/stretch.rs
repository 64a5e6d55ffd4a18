//! A part of a rigid profile along which contact is integrated.
//!
//! ```text
//!        o (x, y, phi)          the body's reference node
//!         \
//!          \ arm
//!     .--x--x--x--.             places of the stretch ride on it
//!    /             \
//! ```
//!
//! docs/theory.md eq. (5.47).

use super::super::search::rigid::RigidSegment;
use crate::rigid::{Attachment, PlaneTurn, PointMap};

/// A part of a segment of a rigid profile, and the place of the node that carries it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    segment: RigidSegment,
    /// Parameters of the segment at which it begins and ends [1].
    between: [f64; 2],
    /// Undeformed position of the reference node [L].
    reference: [f64; 2],
    length: f64,
}

impl Stretch {
    /// The part of a segment between two of its parameters, carried by a node at `reference` [L].
    pub fn new(segment: RigidSegment, between: [f64; 2], reference: [f64; 3]) -> Self {
        let [from, to] = between.map(|parameter| segment.arc_length(parameter));
        let [x, y, _] = reference;
        Self { segment, between, reference: [x, y], length: to - from }
    }

    /// Its length [L].
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Undeformed position at `xi` in [0, 1] [L].
    pub fn reference(&self, xi: f64) -> [f64; 2] {
        let [from, to] = self.between;
        self.segment.place(from + xi * (to - from))
    }

    fn arm(&self, xi: f64) -> [f64; 2] {
        let [x, y] = self.reference(xi);
        [x - self.reference[0], y - self.reference[1]]
    }

    /// How the place at `xi` follows the dofs (x, y, phi) of the node.
    pub fn attachment(&self, xi: f64) -> Attachment {
        Attachment::Point { map: PointMap::Arm { arm: self.arm(xi) }, first: 0 }
    }

    /// How far it leads on at `xi`, over its length [1]: one but on a parabola, whose parameter is no
    /// length.
    pub fn speed(&self, xi: f64) -> f64 {
        match self.segment {
            RigidSegment::Line { .. } | RigidSegment::Arc { .. } => 1.0,
            RigidSegment::Parabola { start, mid, end } => {
                let control = RigidSegment::parabola_control(start, mid, end);
                let [from, to] = self.between;
                let s = from + xi * (to - from);
                let along = |c: usize| {
                    let (p, q) = (control[1][c] - control[0][c], control[2][c] - control[1][c]);
                    2.0 * (p + s * (q - p))
                };
                along(0).hypot(along(1)) * (to - from) / self.length
            }
        }
    }

    /// It where the node has these dofs (x, y, phi).
    pub fn carried(&self, [x, y, turn]: [f64; 3]) -> CarriedStretch {
        CarriedStretch { stretch: *self, turn: PlaneTurn::by(turn), shift: [x, y] }
    }
}

/// A stretch in its current state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CarriedStretch {
    stretch: Stretch,
    turn: PlaneTurn,
    shift: [f64; 2],
}

impl CarriedStretch {
    /// Position at `xi` [L].
    pub fn position(&self, xi: f64) -> [f64; 3] {
        let [x, y] = self.stretch.reference(xi);
        let [a, b] = self.stretch.arm(xi);
        let [u, v] = self.turn.displacement(self.shift, [a, b, 0.0]);
        [x + u, y + v, 0.0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: places are those of the body, lengths those of the curve, for lines, arcs and
    /// parabolas. Source: the motion of a rigid body; sums of chords. Tolerance: rounding, and 1e-6 of
    /// the chords.
    #[test]
    fn a_stretch_rides_on_its_body() {
        let arc = RigidSegment::arc([0.0, 1.0], [1.0, 0.0], [0.0, 0.0]).unwrap();
        let line = RigidSegment::Line { a: [0.0, 1.0], b: [3.0, 5.0] };
        let parabola =
            RigidSegment::Parabola { start: [0.0, 0.0], mid: [1.0, 0.7], end: [2.5, 0.2] };
        let node = [0.3, -0.4, 0.0];
        for segment in [arc, line, parabola] {
            let own = Stretch::new(segment, [0.25, 0.75], node);
            let dofs = [0.2, -0.1, 0.9_f64];
            let (sin, cos) = dofs[2].sin_cos();
            let carried = own.carried(dofs);
            let count = 4000;
            let (mut chords, mut speeds) = (0.0, 0.0);
            for k in 0..count {
                let xi = (f64::from(k) + 0.5) / f64::from(count);
                let [x, y] = own.reference(xi);
                let arm = [x - node[0], y - node[1]];
                let expected = [
                    node[0] + dofs[0] + cos * arm[0] - sin * arm[1],
                    node[1] + dofs[1] + sin * arm[0] + cos * arm[1],
                ];
                let at = carried.position(xi);
                assert!((at[0] - expected[0]).hypot(at[1] - expected[1]) < 1e-13);
                let Attachment::Point { map, first: 0 } = own.attachment(xi) else { panic!() };
                let [u, v] = map.displacement(&dofs);
                assert!((at[0] - x - u).hypot(at[1] - y - v) < 1e-13);
                let [a, b] =
                    [0.0, 1.0].map(|end| own.reference((f64::from(k) + end) / f64::from(count)));
                chords += (b[0] - a[0]).hypot(b[1] - a[1]);
                speeds += own.speed(xi) / f64::from(count);
            }
            assert!((chords / own.length() - 1.0).abs() < 1e-6, "{segment:?}");
            assert!((speeds - 1.0).abs() < 1e-6, "{segment:?}");
        }
    }
}
