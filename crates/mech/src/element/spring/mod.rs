//! Springs: SPRING1 between a dof and the ground, SPRINGA between two nodes along their axis.
//!
//! ```text
//!   SPRING1   |/\/\/\o--> u        SPRINGA   1 o/\/\/\o 2   turns with its ends
//! ```

use super::kernel::{Element, Scale};
use crate::differentiate::Real;

/// SPRING1: a linear spring between one dof and the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GroundSpring {
    /// Stiffness k [F/L], or [F L] for a rotation.
    pub stiffness: f64,
    /// On which of the variables of its node it acts.
    pub component: usize,
}

impl GroundSpring {
    /// Energy k u^2 / 2 [F L].
    pub fn energy<R: Real>(&self, u: R) -> R {
        R::from_f64(0.5 * self.stiffness) * u * u
    }

    /// Force k u and stiffness k.
    pub fn force_and_tangent(&self, u: f64) -> (f64, f64) {
        (self.stiffness * u, self.stiffness)
    }
}

impl<const N: usize, const NN: usize> Element<N, NN> for GroundSpring {
    fn linear(&self, q: &[f64; N], force: &mut [f64; N], tangent: &mut [f64; NN]) -> f64 {
        let (value, stiffness) = self.force_and_tangent(q[self.component]);
        *force = [0.0; N];
        *tangent = [0.0; NN];
        force[self.component] = value;
        tangent[self.component * (N + 1)] = stiffness;
        self.energy(q[self.component])
    }

    fn exact(&self, q: &[f64; N], force: &mut [f64; N], tangent: &mut [f64; NN]) -> f64 {
        self.linear(q, force, tangent)
    }

    fn scale(&self) -> Scale {
        Scale { stiffness: self.stiffness.abs(), length: None }
    }

    fn results(&self, _q: &[f64; N], _linear: bool, _into: &mut [f64]) {}
}

/// SPRINGA: a linear spring between two nodes, acting along their current axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxialSpring {
    /// Undeformed positions of the two nodes [L].
    pub reference: [[f64; 2]; 2],
    /// Stiffness k [F/L].
    pub stiffness: f64,
}

impl AxialSpring {
    fn axis(&self) -> [f64; 2] {
        let [first, second] = self.reference;
        [second[0] - first[0], second[1] - first[1]]
    }

    /// Change of length [L]: (2 e.w + w.w)/(L + l) with w = u2 - u1, e = X2 - X1, which keeps its
    /// digits for small displacements.
    pub fn elongation<R: Real>(&self, q: &[R; 4]) -> R {
        let number = R::from_f64;
        let axis = self.axis();
        let length = number(axis[0].hypot(axis[1]));
        let (ex, ey) = (number(axis[0]), number(axis[1]));
        let (wx, wy) = (q[2] - q[0], q[3] - q[1]);
        let (dx, dy) = (ex + wx, ey + wy);
        let current = (dx * dx + dy * dy).sqrt();
        (number(2.0) * (ex * wx + ey * wy) + wx * wx + wy * wy) / (current + length)
    }

    /// Energy k (L - l)^2 / 2 [F L] of the displacements q = (u1x, u1y, u2x, u2y).
    pub fn energy<R: Real>(&self, q: &[R; 4]) -> R {
        let elongation = self.elongation(q);
        R::from_f64(0.5 * self.stiffness) * elongation * elongation
    }

    /// Writes internal force and tangent (row-major, symmetric), returns the energy [F L].
    ///
    /// Where both ends coincide the axis is undefined: the force is then zero and the tangent that
    /// of a spring in every direction.
    pub fn force_and_tangent(
        &self,
        q: &[f64; 4],
        force: &mut [f64; 4],
        tangent: &mut [f64; 16],
    ) -> f64 {
        let axis = self.axis();
        let d = [axis[0] + q[2] - q[0], axis[1] + q[3] - q[1]];
        let current = d[0].hypot(d[1]);
        if current <= 0.0 {
            *force = [0.0; 4];
            fill(tangent, [[self.stiffness, 0.0], [0.0, self.stiffness]]);
            return 0.5 * self.stiffness * (axis[0] * axis[0] + axis[1] * axis[1]);
        }
        let elongation = self.elongation(q);
        let pull = self.stiffness * elongation;
        let t = [d[0] / current, d[1] / current];
        *force = [-pull * t[0], -pull * t[1], pull * t[0], pull * t[1]];
        let across = pull / current;
        let entry = |i: usize, j: usize| {
            let unit = if i == j { 1.0 } else { 0.0 };
            self.stiffness * t[i] * t[j] + across * (unit - t[i] * t[j])
        };
        fill(tangent, [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]]);
        0.5 * pull * elongation
    }

    /// Force and tangent of a step without NLGEOM: axis and stiffness of the undeformed spring.
    pub fn linear_force_and_tangent(
        &self,
        q: &[f64; 4],
        force: &mut [f64; 4],
        tangent: &mut [f64; 16],
    ) -> f64 {
        let axis = self.axis();
        let length = axis[0].hypot(axis[1]);
        let t = if length > 0.0 { [axis[0] / length, axis[1] / length] } else { [0.0, 0.0] };
        let elongation = t[0] * (q[2] - q[0]) + t[1] * (q[3] - q[1]);
        let pull = self.stiffness * elongation;
        *force = [-pull * t[0], -pull * t[1], pull * t[0], pull * t[1]];
        let entry = |i: usize, j: usize| self.stiffness * t[i] * t[j];
        fill(tangent, [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]]);
        0.5 * pull * elongation
    }
}

impl Element<4, 16> for AxialSpring {
    fn linear(&self, q: &[f64; 4], force: &mut [f64; 4], tangent: &mut [f64; 16]) -> f64 {
        self.linear_force_and_tangent(q, force, tangent)
    }

    fn exact(&self, q: &[f64; 4], force: &mut [f64; 4], tangent: &mut [f64; 16]) -> f64 {
        self.force_and_tangent(q, force, tangent)
    }

    fn scale(&self) -> Scale {
        Scale { stiffness: self.stiffness.abs(), length: None }
    }

    fn results(&self, _q: &[f64; 4], _linear: bool, _into: &mut [f64]) {}
}

/// The 4 x 4 tangent [[B, -B], [-B, B]] of a 2 x 2 block.
fn fill(tangent: &mut [f64; 16], block: [[f64; 2]; 2]) {
    for i in 0..4 {
        for j in 0..4 {
            let sign = if (i < 2) == (j < 2) { 1.0 } else { -1.0 };
            tangent[4 * i + j] = sign * block[i % 2][j % 2];
        }
    }
}
