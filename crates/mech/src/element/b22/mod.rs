//! B22: the geometrically exact (Reissner) three-node beam, two integration points.
//!
//! ```text
//!            x  ___2___  x        dofs of each node: ux, uy, rotation
//!         __---         ---__     x: integration points, xi = -+1/sqrt 3
//!       1                     3   the undeformed axis may be a parabola
//! ```
//!
//! Positions and rotations are quadratic in xi. Two integration points leave the quadratic element
//! without locking and without spurious modes (rank 6 of 9), and its end nodes exact in linear
//! bending by end loads. Strains are those of [`Beam21`](super::Beam21) with the mean values of the
//! element replaced by those of the point; the reference curve enters through its own tangent
//! there, so that an undeformed curved beam has no strain. [derived: docs/theory.md, "Three nodes: B22"]

mod derivatives;

use super::beam_strains::{BeamSectionForces, BeamStrains};
use super::cell::{line3_shapes, line3_slopes};
use super::heated::{BeamHeat, Heated, weighted};
use super::kernel::Surroundings;
use super::quadrature::GAUSS_2;
use crate::differentiate::Real;
use crate::section::BeamStiffness;

/// xi of the second integration point; both have weight 1. Why there: docs/theory.md eq. (3.13).
const GAUSS: f64 = GAUSS_2;

/// Whether the parabola through first end, middle node and second end [L] runs from end to end
/// without turning back: the tangents at both ends point along the chord, as they do for a middle
/// node on the chord between 1/4 and 3/4 of it.
pub fn axis_runs_forward([first, middle, last]: &[[f64; 2]; 3]) -> bool {
    let chord = [last[0] - first[0], last[1] - first[1]];
    let forward = |xi: f64| {
        let by_xi = line3_slopes(xi);
        let along = |k: usize| by_xi[0] * (first[k] - middle[k]) + by_xi[2] * (last[k] - middle[k]);
        along(0) * chord[0] + along(1) * chord[1] > 0.0
    };
    forward(-1.0) && forward(1.0)
}

/// What an integration point knows of the undeformed element.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Station {
    /// Undeformed length it stands for [L]: |dX/dxi|, the weight being 1.
    length: f64,
    /// Unit tangent of the undeformed axis [1].
    direction: [f64; 2],
    /// Shape functions [1].
    shapes: [f64; 3],
    /// Their derivatives by undeformed length [1/L].
    slopes: [f64; 3],
    /// Strains of the free element there.
    free: BeamStrains,
}

impl Station {
    fn new(reference: &[[f64; 2]; 3], xi: f64) -> Self {
        let by_xi = line3_slopes(xi);
        // Slopes sum to zero: differences keep the digits of elements far from the origin.
        let along: [f64; 2] = std::array::from_fn(|k| {
            by_xi[0] * (reference[0][k] - reference[1][k])
                + by_xi[2] * (reference[2][k] - reference[1][k])
        });
        let length = along[0].hypot(along[1]);
        let (inverse, direction) = if length > 0.0 {
            (1.0 / length, [along[0] / length, along[1] / length])
        } else {
            (0.0, [1.0, 0.0])
        };
        Self {
            length,
            direction,
            shapes: line3_shapes(xi),
            slopes: by_xi.map(|slope| slope * inverse),
            free: BeamStrains::ZERO,
        }
    }

    /// (du/ds, df/ds) and f of the point.
    fn motion<R: Real>(&self, q: &[R; 9]) -> ([R; 3], R) {
        let (first, last) = (R::from_f64(self.slopes[0]), R::from_f64(self.slopes[2]));
        let slope =
            std::array::from_fn(|k| first * (q[k] - q[3 + k]) + last * (q[6 + k] - q[3 + k]));
        let [a, b, c] = self.shapes.map(R::from_f64);
        (slope, a * q[2] + b * q[5] + c * q[8])
    }

    /// eps = c x' + s y' - 1, gam = -s x' + c y', kap = f', written in the frame of the undeformed
    /// tangent as those of B21 are: docs/theory.md eq. (3.10). [semantics: B21, strains; derived]
    fn strains<R: Real>(&self, q: &[R; 9]) -> BeamStrains<R> {
        let ([wx, wy, curvature], rotation) = self.motion(q);
        let number = R::from_f64;
        let (ex, ey) = (number(self.direction[0]), number(self.direction[1]));
        let (along, across) = (ex * wx + ey * wy, ex * wy - ey * wx);
        let half = (rotation * number(0.5)).sin();
        let versine = number(2.0) * half * half;
        let (s, c) = (rotation.sin(), rotation.cos());
        BeamStrains {
            axial: c * along + s * across - versine,
            shear: c * across - s * along - s,
            curvature,
        }
    }
}

/// Three-node plane beam element; nodes in the order first end, middle, second end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beam22 {
    /// Undeformed positions of first end, middle node and second end [L].
    pub reference: [[f64; 2]; 3],
    /// EA, K, EI.
    pub stiffness: BeamStiffness,
    stations: [Station; 2],
}

impl Beam22 {
    /// The element on three undeformed positions [L]: first end, middle, second end. The middle
    /// node belongs into the middle half (check [`axis_runs_forward`]).
    pub fn new(reference: [[f64; 2]; 3], stiffness: BeamStiffness) -> Self {
        let stations = [-GAUSS, GAUSS].map(|xi| Station::new(&reference, xi));
        Self { reference, stiffness, stations }
    }

    /// Undeformed length of the axis [L], by the two integration points.
    pub fn length(&self) -> f64 {
        self.stations[0].length + self.stations[1].length
    }

    /// Strain energy W = sum over the points of l_g/2 (EA eps^2 + K gam^2 + EI kap^2) [F L] of the
    /// displacements q = (ux, uy, f) of first end, middle, second end: docs/theory.md eq. (3.11).
    /// [semantics: B21, energy]
    pub fn energy<R: Real>(&self, q: &[R; 9]) -> R {
        let of = |station: &Station| {
            let twice = self.stiffness.twice_energy(&station.strains(q), &station.free);
            R::from_f64(0.5 * station.length) * twice
        };
        of(&self.stations[0]) + of(&self.stations[1])
    }

    /// Strains at the two integration points, xi = -1/sqrt 3 and 1/sqrt 3.
    pub fn station_strains(&self, q: &[f64; 9]) -> [BeamStrains; 2] {
        [self.stations[0].strains(q), self.stations[1].strains(q)]
    }

    /// Strains at xi in [-1, 1], linear through those of the integration points: elsewhere the
    /// interpolation itself holds spurious strains. docs/theory.md eq. (3.14).
    pub fn strains_at(&self, q: &[f64; 9], xi: f64) -> BeamStrains {
        between(&self.station_strains(q), xi)
    }

    /// Strains at the middle.
    pub fn strains(&self, q: &[f64; 9]) -> BeamStrains {
        self.strains_at(q, 0.0)
    }

    /// Section forces N = EA eps, V = K gam, M = EI kap at the middle.
    pub fn section_forces(&self, q: &[f64; 9]) -> BeamSectionForces {
        self.forces_at_middle(&self.strains(q))
    }

    /// Those of strains at the middle, free ones included.
    fn forces_at_middle(&self, strains: &BeamStrains) -> BeamSectionForces {
        let free = self.stations.map(|station| station.free);
        self.forces_of(&strains.less(&between(&free, 0.0)))
    }

    /// Those of the strains that the free element does not have.
    fn forces_of(&self, strains: &BeamStrains) -> BeamSectionForces {
        self.stiffness.forces(strains)
    }
}

/// The line through the strains of the two points, at xi.
fn between([first, second]: &[BeamStrains; 2], xi: f64) -> BeamStrains {
    let weight = 0.5 * (1.0 + xi / GAUSS);
    let mix = |a: f64, b: f64| (1.0 - weight) * a + weight * b;
    BeamStrains {
        axial: mix(first.axial, second.axial),
        shear: mix(first.shear, second.shear),
        curvature: mix(first.curvature, second.curvature),
    }
}

impl Heated<9, 81> for Beam22 {
    /// Temperatures of the integration points by the shape functions, the stiffness at their mean.
    fn warmed(&self, heat: &BeamHeat, under: &Surroundings<'_>) -> Self {
        let stations = self.stations.map(|station| {
            let [now, initial] =
                [under.temperatures, under.initial].map(|nodes| weighted(&station.shapes, nodes));
            Station { free: heat.free(&self.stiffness, now, initial), ..station }
        });
        let at = |k: usize| weighted(&self.stations[k].shapes, under.temperatures).value;
        let stiffness = heat.stiffness(&self.stiffness, 0.5 * (at(0) + at(1)));
        Self { stiffness, stations, ..*self }
    }
}
