//! How the shear angle turns a smooth line against the sections of its beams.
//!
//! ```text
//!        left beam          own beam          right beam
//!    o----------------a----------------b----------------o
//!                     |\ tangent: section angle + mean shear angle of the beams that meet
//!                     | section
//! ```
//!
//! The tangent of a shear-flexible beam is its section angle plus its shear angle. An element
//! knows its mean shear angle: the turn of its chord less the mean turn of its sections. At a node
//! the line takes the mean of the beams that meet there, so that it has no corner although the
//! shear force of two elements with a load between them differs; under a load that stands on the
//! node that is the mean of both slopes, which is where a resultant points. Equations (8.19) and (8.20) of
//! docs/theory.md. [derived]

use std::f64::consts::{PI, TAU};

/// The most dofs that the slopes of a line follow.
pub const MOST_SLOPE_DOFS: usize = 18;

/// A beam whose shear angle turns the tangent at its ends; dofs by local numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShearedBeam {
    /// Undeformed chord [L].
    pub chord: [f64; 2],
    /// First dof (ux) of both ends; uy follows it.
    pub ends: [usize; 2],
    /// Rotations of its nodes, and their weights in the mean turn of its sections, sum 1.
    pub rotations: [(usize, f64); 3],
}

impl ShearedBeam {
    /// Current chord [L].
    fn bent(&self, dofs: &[f64]) -> [f64; 2] {
        let [a, b] = self.ends;
        [self.chord[0] + dofs[b] - dofs[a], self.chord[1] + dofs[b + 1] - dofs[a + 1]]
    }

    /// Mean shear angle: turn of the chord less mean turn of the sections [rad].
    pub fn shear_angle(&self, dofs: &[f64]) -> f64 {
        let ([x, y], [bx, by]) = (self.chord, self.bent(dofs));
        let turn = (x * by - y * bx).atan2(x * bx + y * by);
        let sections: f64 = self.rotations.iter().map(|&(dof, weight)| weight * dofs[dof]).sum();
        // The chord's turn is known but for full turns; a shear angle is small.
        let angle = turn - sections;
        if angle.abs() <= PI { angle } else { angle - TAU * (angle / TAU).round() }
    }

    /// Adds `factor` times the derivative of the shear angle by the dofs.
    fn add_gradient(&self, dofs: &[f64], factor: f64, into: &mut [f64]) {
        let [bx, by] = self.bent(dofs);
        let square = bx * bx + by * by;
        for (end, sign) in self.ends.into_iter().zip([-1.0, 1.0]) {
            into[end] -= sign * factor * by / square;
            into[end + 1] += sign * factor * bx / square;
        }
        for (dof, weight) in self.rotations {
            into[dof] -= factor * weight;
        }
    }

    /// Adds `factor` times the second derivative, row-major of `width`.
    fn add_hessian(&self, dofs: &[f64], factor: f64, (into, width): (&mut [f64], usize)) {
        let [bx, by] = self.bent(dofs);
        let fourth = (bx * bx + by * by).powi(2);
        let (mixed, pure) =
            (factor * (by * by - bx * bx) / fourth, factor * 2.0 * bx * by / fourth);
        for (a, of_a) in self.ends.into_iter().zip([-1.0, 1.0]) {
            for (b, of_b) in self.ends.into_iter().zip([-1.0, 1.0]) {
                let sign = of_a * of_b;
                into[a * width + b] += sign * pure;
                into[a * width + b + 1] += sign * mixed;
                into[(a + 1) * width + b] += sign * mixed;
                into[(a + 1) * width + b + 1] -= sign * pure;
            }
        }
    }
}

/// The turning of a line's end tangents beyond the turning of its nodes: at each end the mean shear
/// angle of the beams that meet there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShearSlopes {
    /// The beam before, the line's own, and the one behind.
    pub beams: [Option<ShearedBeam>; 3],
}

impl ShearSlopes {
    /// The beams of an end with their weights.
    fn at(&self, end: usize) -> impl Iterator<Item = (&ShearedBeam, f64)> {
        let beams = [&self.beams[end], &self.beams[end + 1]];
        let count = beams.iter().filter(|beam| beam.is_some()).count();
        beams.into_iter().flatten().map(move |beam| (beam, 1.0 / count as f64))
    }

    /// Further turn of the tangent at an end (0, 1) [rad].
    pub fn turn(&self, end: usize, dofs: &[f64]) -> f64 {
        self.at(end).map(|(beam, weight)| weight * beam.shear_angle(dofs)).sum()
    }

    /// Its derivative by the dofs [1, rad/L].
    pub fn gradient(&self, end: usize, dofs: &[f64]) -> [f64; MOST_SLOPE_DOFS] {
        let mut gradient = [0.0; MOST_SLOPE_DOFS];
        for (beam, weight) in self.at(end) {
            beam.add_gradient(dofs, weight, &mut gradient);
        }
        gradient
    }

    /// Adds `factor` times its second derivative, row-major of `width`.
    pub fn add_hessian(
        &self,
        end: usize,
        dofs: &[f64],
        factor: f64,
        (into, width): (&mut [f64], usize),
    ) {
        for (beam, weight) in self.at(end) {
            beam.add_hessian(dofs, factor * weight, (&mut *into, width));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn slopes() -> ShearSlopes {
        let own = ShearedBeam {
            chord: [2.0, 0.5],
            ends: [0, 3],
            rotations: [(2, 1.0 / 6.0), (12, 4.0 / 6.0), (5, 1.0 / 6.0)],
        };
        let left = ShearedBeam {
            chord: [1.0, 0.8],
            ends: [9, 0],
            rotations: [(11, 0.5), (2, 0.5), (2, 0.0)],
        };
        ShearSlopes { beams: [Some(left), Some(own), None] }
    }

    const DOFS: [f64; 13] = [0.1, -0.2, 0.3, 0.4, 0.5, 0.25, 0.0, 0.0, 0.0, -0.1, 0.2, 0.35, 0.28];

    /// Requirement: derivatives of the turns are those of the turns. Source: central differences.
    /// Tolerance: their truncation at a step of 1e-6 and rounding, 1e-9.
    #[test]
    fn derivatives_against_differences() {
        let slopes = slopes();
        let step = 1e-6;
        for end in 0..2 {
            let gradient = slopes.gradient(end, &DOFS);
            let mut hessian = [0.0; 13 * 13];
            slopes.add_hessian(end, &DOFS, 1.0, (&mut hessian, 13));
            for k in 0..13 {
                let moved = |by: f64| {
                    let mut dofs = DOFS;
                    dofs[k] += by;
                    (slopes.turn(end, &dofs), slopes.gradient(end, &dofs))
                };
                let ((up, gradient_up), (down, gradient_down)) = (moved(step), moved(-step));
                assert!(((up - down) / (2.0 * step) - gradient[k]).abs() < 1e-9, "{end} {k}");
                for j in 0..13 {
                    let difference = (gradient_up[j] - gradient_down[j]) / (2.0 * step);
                    assert!((difference - hessian[13 * k + j]).abs() < 1e-9, "{end} {k} {j}");
                }
            }
        }
    }

    /// Requirement: a rigid turn, however far, makes no shear angle; a shear angle is what the chord
    /// turns beyond its sections. Source: definition. Tolerance: rounding.
    #[test]
    fn rigid_turns_do_not_shear() {
        let beam = ShearedBeam {
            chord: [2.0, 0.5],
            ends: [0, 3],
            rotations: [(2, 0.5), (5, 0.5), (5, 0.0)],
        };
        for turn in [0.3_f64, 3.0, 7.0, -20.0] {
            for shear in [0.0, 0.01] {
                let (s, c) = (turn + shear).sin_cos();
                let mut dofs = [0.0, 0.0, turn, 0.0, 0.0, turn];
                dofs[3] = c * 2.0 - s * 0.5 - 2.0;
                dofs[4] = s * 2.0 + c * 0.5 - 0.5;
                assert!((beam.shear_angle(&dofs) - shear).abs() < 1e-13, "{turn} {shear}");
            }
        }
    }
}
