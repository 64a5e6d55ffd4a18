//! A point against a circular arc, or against a vertex (radius zero).
//!
//! ```text
//!     convex:  g = |x_s - c| - r       concave:  g = r - |x_s - c|
//!              travel clockwise                  travel counter-clockwise
//! ```

use super::{Gap, Order, Second};

/// On which side of the arc its material lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// The normal points away from the centre; travel is clockwise.
    Convex,
    /// The normal points to the centre; travel is counter-clockwise.
    Concave,
}

/// A circle that rides on a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circle {
    /// Radius r >= 0 [L]; zero is a vertex, whose slip coordinate does not change.
    pub radius: f64,
    /// Side of the material.
    pub side: Side,
}

impl Circle {
    /// +1 where sigma grows with the polar angle.
    fn travel(&self) -> f64 {
        match self.side {
            Side::Convex => -1.0,
            Side::Concave => 1.0,
        }
    }

    /// Gap of a point against the circle about `centre` on a body turned by `rotation` [rad].
    ///
    /// Variables: (slave x, y, centre x, y, rotation). h = r - |x_s - c| (convex); sigma = -r
    /// (theta - rotation) along the travel (convex; concave: + r), wrapped to within pi r of
    /// `reference`. `None` where the point is on the centre. [semantics: circle]
    pub fn gap<O: Order>(
        &self,
        point: [f64; 2],
        centre: [f64; 2],
        rotation: f64,
        reference: f64,
    ) -> Option<Gap<5, O>> {
        let d = [point[0] - centre[0], point[1] - centre[1]];
        let distance = d[0].hypot(d[1]);
        if !(distance > 0.0 && distance.is_finite()) {
            return None;
        }
        let e = [d[0] / distance, d[1] / distance];
        let travel = self.travel();
        let angle = self.wrapped_angle(d[1].atan2(d[0]) - rotation, reference);
        let mut gap = Gap {
            overclosure: travel * (distance - self.radius),
            along: travel * self.radius * angle,
            gradient: [0.0; 5],
            slip_gradient: [0.0; 5],
            direction: [0.0; 5],
            second: O::second(|| second(e, distance, travel)),
            normal: [-travel * e[0], -travel * e[1]],
            tangent: [-travel * e[1], travel * e[0]],
            position: [centre[0] + self.radius * e[0], centre[1] + self.radius * e[1]],
            parameter: angle,
            bend: travel / distance,
        };
        gap.slip_gradient[4] = -travel * self.radius;
        gap.direction[4] = -travel * distance;
        let t = [-e[1], e[0]];
        let slip = travel * self.radius / distance;
        for i in 0..4 {
            gap.gradient[i] = travel * sign(i) * e[i % 2];
            gap.slip_gradient[i] = slip * sign(i) * t[i % 2];
            gap.direction[i] = travel * sign(i) * t[i % 2];
        }
        gap.is_finite().then_some(gap)
    }

    fn wrapped_angle(&self, angle: f64, reference: f64) -> f64 {
        let turn = 2.0 * std::f64::consts::PI;
        let target = if self.radius > 0.0 { self.travel() * reference / self.radius } else { 0.0 };
        let turns = ((target - angle) / turn).round();
        if turns.is_finite() { angle + turn * turns } else { angle }
    }
}

/// Of the variables of the slave and of the centre.
fn sign(variable: usize) -> f64 {
    if variable < 2 { 1.0 } else { -1.0 }
}

/// d|d| = e.dx, D d|d| = (t.dx)(t.Dx)/|d|, d theta = t.dx/|d|, dx relative to the centre; the direction is
/// t.dx and turns with D t = -e (t.Dx)/|d|, its lever about the centre is |d|.
fn second(e: [f64; 2], distance: f64, travel: f64) -> Second<5> {
    let t = [-e[1], e[0]];
    let mut second = Second::ZERO;
    for i in 0..4 {
        second.direction_derivative[4][i] = -travel * sign(i) * e[i % 2];
        for j in 0..4 {
            let both = travel * sign(i) * sign(j) / distance;
            let (a, b) = (i % 2, j % 2);
            second.hessian[i][j] = both * t[a] * t[b];
            second.direction_derivative[i][j] = -both * e[a] * t[b];
        }
    }
    second
}
