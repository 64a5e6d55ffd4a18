//! Surfaces that stand off the lines on which contact is computed.
//!
//! ```text
//!      o--------x--------o      the line of a beam, at the distance g from the master
//!      :        | r     :
//!      '--------y--------'      its surface, on the side of the master
//!     ==========+==========     master; of a beam its surface, at its half thickness from its line
//! ```
//!
//! The line of a beam and its surface are parallel, so that both have the same projection: the
//! overclosure grows by the half thicknesses, and its derivatives stay. Friction acts at y, which turns
//! with the section. Equations (5.44) to (5.46) of docs/theory.md. [derived]

use super::curve::{Along, Weights};
use super::{Gap, Order};

/// How far the surfaces of a pair stand off their lines [L].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Offset {
    /// That of the slave.
    pub slave: f64,
    /// That of the master.
    pub master: f64,
}

impl Offset {
    /// Contact of the lines themselves.
    pub const NONE: Self = Self { slave: 0.0, master: 0.0 };

    /// Whether contact is of the lines themselves.
    pub fn is_none(&self) -> bool {
        *self == Self::NONE
    }

    /// Of both together [L].
    pub fn both(&self) -> f64 {
        self.slave + self.master
    }

    /// How far the surface of a slave has rolled, the section turned by `section` and the master's
    /// tangent along `tangent` [L]: known up to the perimeter 2 pi r.
    pub fn rolled(&self, section: f64, tangent: [f64; 3]) -> f64 {
        match self.slave == 0.0 {
            true => 0.0,
            false => self.slave * (section - tangent[1].atan2(tangent[0])),
        }
    }

    /// The way between two such lengths, the short way round [L].
    pub fn way(&self, from: f64, to: f64) -> f64 {
        let round = std::f64::consts::TAU * self.slave;
        match round > 0.0 {
            true => to - from - round * ((to - from) / round).round(),
            false => 0.0,
        }
    }
}

/// The turn of a master's tangent at a place that moves with it: by the variables of a gap, and the
/// derivatives of that.
pub struct Turn<const N: usize> {
    /// omega_i [1/L, or 1 of a rotation].
    pub value: [f64; N],
    /// d omega_i/dq_j.
    pub derivative: [[f64; N]; N],
}

impl Turn<5> {
    /// That of a body whose rotation is the last variable.
    pub const OF_BODY: Self = Self { value: [0.0, 0.0, 0.0, 0.0, 1.0], derivative: [[0.0; 5]; 5] };
}

impl<const N: usize> Turn<N> {
    /// That of a curve through control points, where `gap` has found the projection: w . v1 with
    /// w = e3 x a/m.
    pub fn of_curve<const K: usize, O: Order>(
        gap: &Gap<N, O>,
        control: &[[f64; 2]; K],
        weights: &Weights<K>,
        along: &Along,
    ) -> Self {
        const { assert!(N == 2 + 2 * K) }
        let sum = |weights: &[f64; K]| {
            let parts = weights.iter().zip(control);
            parts.fold([0.0; 2], |[x, y], (w, at)| [x + w * at[0], y + w * at[1]])
        };
        let (a, bent) = (sum(&weights.first), sum(&weights.second));
        let metric = a[0] * a[0] + a[1] * a[1];
        let w = [-a[1] / metric, a[0] / metric];
        let node = |i: usize| (i / 2 - 1, i % 2);
        let mut own = Self { value: [0.0; N], derivative: [[0.0; N]; N] };
        for i in 2..N {
            let (k, c) = node(i);
            own.value[i] = w[c] * weights.first[k];
        }
        for j in 0..N {
            let xi = gap.slip_gradient[j] / along.first;
            let mut change = bent.map(|b| b * xi);
            if j >= 2 {
                let (k, c) = node(j);
                change[c] += weights.first[k];
            }
            let stretch = 2.0 * (a[0] * change[0] + a[1] * change[1]) / metric;
            let turned =
                [-change[1] / metric - stretch * w[0], change[0] / metric - stretch * w[1]];
            for i in 2..N {
                let (k, c) = node(i);
                own.derivative[i][j] = turned[c] * weights.first[k] + w[c] * weights.second[k] * xi;
            }
        }
        own
    }
}

impl<const N: usize, O: Order> Gap<N, O> {
    /// Becomes that of the surfaces, of a master that turns so. What follows the rotation of the
    /// slave's section is left to who knows it: slip and drag grow by r times that rotation.
    pub fn stand_off(&mut self, offset: Offset, turn: impl FnOnce(&Self) -> Turn<N>) {
        self.overclosure += offset.both();
        if offset.slave == 0.0 {
            return;
        }
        let turn = turn(self);
        for (i, omega) in turn.value.into_iter().enumerate() {
            self.slip_gradient[i] -= offset.slave * (self.bend * self.direction[i] + omega);
            self.direction[i] -= offset.slave * omega;
        }
        if let Some(second) = O::kept_mut(&mut self.second) {
            let rows = second.direction_derivative.iter_mut().zip(&turn.derivative);
            for (into, by) in rows.flat_map(|(into, by)| into.iter_mut().zip(by)) {
                *into -= offset.slave * by;
            }
        }
    }
}
