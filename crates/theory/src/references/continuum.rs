//! Softened pressure spread along a shear-flexible beam.
//!
//! ```text
//!              .-----.
//!             (   c   )
//!  |\          `-.|.-'        pressure q(s) = b p(h(s)) (u + mu w)
//!  |=====_____   vvv          acts for s_1 - l < s < s_1, where h > -c0
//!  |/     n    ``--____--__
//!         const  |<-l->|   ``   free end: straight, unloaded
//!                     s_1
//! ```
//!
//! n' = -q, M' = -(x' n_y - y' n_x), M = EI f'; x', y' as for the point load
//! [verification: reference model C]. The free end stays straight, so that the
//! integration starts at s_1, where h = -c0 and n = M = 0, and runs backwards
//! through the patch to its other end and on to the clamp. Unknown are the angle
//! there, the angle beta between beam and circle, s_1 and l; known x = y = f = 0
//! at the clamp and h = -c0 at the other end of the patch (derived). Inside the
//! patch everything is analytic, which a method of high order turns into digits.

use super::equilibrium::Local;
use super::point;
use super::section::Section;
use crate::error::TheoryError;
use crate::frame::Circle;
use crate::numerics::gauss::{self, Collocation};
use crate::numerics::{newton, root};
use crate::softened_law::ExponentialLaw;

/// Stages of the collocation method; its order is twice this.
const STAGES: usize = 8;
/// Agreement of two step sizes that the answer must show [-].
const AGREEMENT: f64 = 1e-9;
/// Smallest share of the depth in the search from a shallower contact [-].
const SMALLEST_ADVANCE: f64 = 1e-4;

/// x, y (counted from the point s_1), f, n_x, n_y, M, normal force, its first
/// moment in s, strain energy, contact energy.
type State = [f64; 10];

/// The problem in units of the beam's length and of a typical force.
struct Patch<'a> {
    section: Section,
    circle: Circle,
    drag: f64,
    law: ExponentialLaw,
    method: &'a Collocation,
}

/// Where the patch lies: beta, angle of the section at s_1, s_1, l.
#[derive(Clone, Copy)]
struct Place {
    beta: f64,
    angle: f64,
    start: f64,
    length: f64,
}

/// States at the ends of the patch and at the clamp.
struct Shot {
    patch_end: State,
    clamp: State,
    /// Largest and smallest overclosure at the steps inside the patch.
    overclosure: [f64; 2],
}

impl Patch<'_> {
    /// Vector from the circle's centre to the point s_1, where h = -c0.
    fn edge(&self, place: &Place) -> [f64; 2] {
        let (sin, cos) = (place.angle + place.beta).sin_cos();
        let distance = self.circle.radius + self.law.clearance;
        [distance * sin, -distance * cos]
    }

    /// Overclosure plus c0, from the move away from the edge of the patch: no
    /// difference of two lengths of the order of the radius is taken.
    fn above_edge(&self, y: &State, edge: [f64; 2]) -> f64 {
        let (x, z) = (edge[0] + y[0], edge[1] + y[1]);
        let squares = (edge[0] + x) * y[0] + (edge[1] + z) * y[1];
        -squares / (x.hypot(z) + self.circle.radius + self.law.clearance)
    }

    /// Derivatives with respect to s; `edge` where the pressure acts.
    fn derivative(&self, y: &State, s: f64, edge: Option<[f64; 2]>) -> State {
        let (sin, cos) = y[2].sin_cos();
        let (n_1, n_2) = (y[3] * cos + y[4] * sin, y[4] * cos - y[3] * sin);
        let (e, g) = (1.0 + n_1 * self.section.stretch, n_2 * self.section.shear);
        let (dx, dy) = (e * cos - g * sin, e * sin + g * cos);
        let curvature = y[5] / self.section.bending;
        let strain = 0.5
            * (y[5] * curvature
                + n_1 * n_1 * self.section.stretch
                + n_2 * n_2 * self.section.shear);
        let [q_x, q_y, p, w] = edge.map_or([0.0; 4], |edge| self.pressure(y, edge));
        [dx, dy, curvature, -q_x, -q_y, dy * y[3] - dx * y[4], p, p * s, strain, w]
    }

    /// Load per length, its normal part, and contact energy per length.
    fn pressure(&self, y: &State, edge: [f64; 2]) -> [f64; 4] {
        let (rx, ry) = (edge[0] + y[0], edge[1] + y[1]);
        let distance = rx.hypot(ry);
        let (u_x, u_y) = (rx / distance, ry / distance);
        let value = self.law.continued(self.above_edge(y, edge) - self.law.clearance);
        let p = self.section.width * value.pressure;
        [
            p * (u_x - self.drag * u_y),
            p * (u_y + self.drag * u_x),
            p,
            self.section.width * value.energy,
        ]
    }

    /// Integrates from s_1 backwards to the clamp.
    fn shoot(&self, place: &Place, steps: usize) -> Result<Shot, TheoryError> {
        let edge = self.edge(place);
        let mut y = [0.0; 10];
        y[2] = place.angle;
        let mut overclosure = [f64::NEG_INFINITY, f64::INFINITY];
        let step = -place.length / steps as f64;
        for i in 0..steps {
            // the position s is known at step ends; within a step it follows the stages
            let from = place.start + step * i as f64;
            y = self.step_in_patch(y, edge, from, step)?;
            let h = self.above_edge(&y, edge) - self.law.clearance;
            overclosure = [
                overclosure[0].max(h),
                if i + 1 < steps { overclosure[1].min(h) } else { overclosure[1] },
            ];
        }
        let span = place.length - place.start;
        let mut clamp = self.method.advance(y, span, steps, |y| self.derivative(y, 0.0, None))?;
        clamp[0] += self.circle.centre[0] + edge[0];
        clamp[1] += self.circle.centre[1] + edge[1];
        Ok(Shot { patch_end: y, clamp, overclosure })
    }

    /// One step; s travels as an eleventh component of the state.
    fn step_in_patch(
        &self,
        y: State,
        edge: [f64; 2],
        from: f64,
        step: f64,
    ) -> Result<State, TheoryError> {
        let mut with_s = [from; 11];
        with_s[..10].copy_from_slice(&y);
        let end = self.method.advance(with_s, step, 1, |y| {
            let mut slope = [1.0; 11];
            let mut state = [0.0; 10];
            state.copy_from_slice(&y[..10]);
            slope[..10].copy_from_slice(&self.derivative(&state, y[10], Some(edge)));
            slope
        })?;
        let mut state = [0.0; 10];
        state.copy_from_slice(&end[..10]);
        Ok(state)
    }

    /// Newton on the four unknowns, scaled by the guess.
    fn place(&self, guess: &Place, steps: usize) -> Result<Place, TheoryError> {
        let at = |z: &[f64; 4]| Place {
            beta: guess.beta * z[0],
            angle: guess.angle * z[1],
            start: guess.start + 0.5 * guess.length * (z[2] - 1.0),
            length: guess.length * z[3],
        };
        let height = self.circle.radius + self.law.clearance - self.circle.centre[1];
        let residual = |z: &[f64; 4]| {
            let place = at(z);
            if place.beta <= 0.0 || place.length <= 0.0 || place.start <= place.length {
                return Err(TheoryError::PastClamp);
            }
            let shot = self.shoot(&place, steps)?;
            let left = self.above_edge(&shot.patch_end, self.edge(&place)) / self.law.clearance;
            Ok([shot.clamp[0], shot.clamp[1] / height, shot.clamp[2] / guess.angle, left])
        };
        newton::solve(residual, [1.0; 4]).map(|z| at(&z))
    }

    /// The patch at a smaller depth: the circle raised so that only `share` of the
    /// overclosure of the undeflected beam, counted from -c0, is left.
    fn raised(&self, share: f64) -> Patch<'_> {
        let top = self.circle.radius + self.law.clearance;
        let centre = [self.circle.centre[0], top - share * (top - self.circle.centre[1])];
        Patch { circle: Circle { centre, ..self.circle }, ..*self }
    }

    /// First place: directly from the contact at one point of tributary area
    /// `area`, or by bringing the circle down from the depth where that succeeds.
    fn first_place(&self, area: f64, steps: usize) -> Result<Place, TheoryError> {
        let direct = |share: f64| {
            let patch = self.raised(share);
            let one = point::softened(&patch.section, patch.circle, self.drag, &self.law, area)?;
            patch.place(&patch.guess(&one)?, steps)
        };
        let mut share = 1.0;
        let mut place = loop {
            match direct(share) {
                Ok(place) => break place,
                Err(reason) if share < 1e-3 => return Err(reason),
                Err(_) => share *= 0.5,
            }
        };
        let mut advance = 0.25 * share;
        while share < 1.0 {
            let next = (share + advance).min(1.0);
            match self.raised(next).place(&place, steps) {
                Ok(found) => (share, place, advance) = (next, found, 1.6 * advance),
                Err(reason) if advance < SMALLEST_ADVANCE => return Err(reason),
                Err(_) => advance *= 0.4,
            }
        }
        Ok(place)
    }

    /// Place of the patch for a straight beam that carries the force `normal`
    /// at the contact found for one point: h + c0 = beta x - x^2/(2 r).
    fn guess(&self, contact: &Local) -> Result<Place, TheoryError> {
        let (r, c0) = (self.circle.radius, self.law.clearance);
        let rule = gauss::rule(20);
        let carried = |beta: f64| {
            let h = |x: f64| beta * x - 0.5 * x * x / r - c0;
            gauss::integrate(&rule, 0.0, 2.0 * r * beta, |x| {
                self.section.width * self.law.at(h(x)).pressure
            })
        };
        let mut high = (2.0 * c0 / r).sqrt();
        while carried(high) < contact.force {
            high *= 1.5;
        }
        let beta = root::bracketed(|beta| carried(beta) - contact.force, 0.0, high)?;
        let start = contact.contact_length + r * beta;
        Ok(Place { beta, angle: contact.angle, start, length: 2.0 * r * beta })
    }
}

/// Equilibrium with the pressure spread along the beam.
///
/// # Errors
/// Why there is no such equilibrium, or that it was not found to nine digits.
pub(super) fn solve(
    section: &Section,
    circle: Circle,
    drag: f64,
    law: &ExponentialLaw,
) -> Result<Local, TheoryError> {
    law.check()?;
    // one point with the area of a patch of half width sqrt(2 r c0) starts the search
    let area = 2.0 * section.width * (2.0 * circle.radius * law.clearance).sqrt();
    let unit = point::softened(section, circle, drag, law, area)?.force;
    let method = Collocation::new(STAGES);
    let patch = scaled(section, circle, drag, law, unit, &method);
    let mut steps = 4;
    let mut place = patch.first_place(area / (section.width * section.length), steps)?;
    let mut found = patch.read(&place, steps)?;
    while steps < 128 {
        steps *= 2;
        place = patch.place(&place, steps)?;
        let finer = patch.read(&place, steps)?;
        let agreed = agreement(&found, &finer);
        found = finer;
        if agreed < AGREEMENT {
            return Ok(in_model_units(found, section.length, unit));
        }
    }
    Err(TheoryError::NotConverged { correction: AGREEMENT })
}

fn agreement(a: &Local, b: &Local) -> f64 {
    let size = b.force;
    let reaction = (a.reaction[0] - b.reaction[0]).abs().max((a.reaction[1] - b.reaction[1]).abs());
    (reaction.max((a.force - b.force).abs()) / size).max((a.angle / b.angle - 1.0).abs())
}

fn scaled<'a>(
    section: &Section,
    circle: Circle,
    drag: f64,
    law: &ExponentialLaw,
    force: f64,
    method: &'a Collocation,
) -> Patch<'a> {
    let l = section.length;
    Patch {
        section: Section {
            bending: section.bending / (force * l * l),
            stretch: section.stretch * force,
            shear: section.shear * force,
            length: 1.0,
            width: 1.0,
        },
        circle: Circle {
            centre: [circle.centre[0] / l, circle.centre[1] / l],
            radius: circle.radius / l,
        },
        drag,
        law: ExponentialLaw {
            clearance: law.clearance / l,
            pressure: law.pressure * section.width * l / force,
        },
        method,
    }
}

fn in_model_units(found: Local, l: f64, force: f64) -> Local {
    Local {
        contact_length: found.contact_length * l,
        force: found.force * force,
        reaction: found.reaction.map(|v| v * force),
        point: found.point.map(|v| v * l),
        angle: found.angle,
        overclosure: found.overclosure * l,
        strain_energy: found.strain_energy * force * l,
        contact_energy: found.contact_energy * force * l,
    }
}

impl Patch<'_> {
    /// Answers from the solved place, after the checks that it means what the
    /// equations assume: the patch on the beam, and in one piece.
    fn read(&self, place: &Place, steps: usize) -> Result<Local, TheoryError> {
        if place.start > self.section.length {
            return Err(TheoryError::BeyondTip {
                contact_length: place.start,
                length: self.section.length,
            });
        }
        let shot = self.shoot(place, steps)?;
        if shot.overclosure[1] < -self.law.clearance {
            // the patch would fall into two
            return Err(TheoryError::NotConverged { correction: 1.0 });
        }
        let (y, at_clamp) = (shot.patch_end, shot.clamp);
        let n = [y[3], y[4]];
        // integrals run backwards in s: their sign is reversed
        let normal = -y[6];
        if n[1] >= 0.0 {
            return Err(TheoryError::Jamming { transverse: -n[1] / normal });
        }
        Ok(Local {
            contact_length: y[7] / y[6],
            force: normal,
            reaction: n,
            point: self.point_of_action(n, at_clamp[5]),
            angle: place.angle,
            overclosure: shot.overclosure[0],
            strain_energy: -at_clamp[8],
            contact_energy: -at_clamp[9],
        })
    }

    /// Point of the circle on the line of action of the resultant, whose moment
    /// about the clamp is the clamping moment.
    fn point_of_action(&self, n: [f64; 2], moment: f64) -> [f64; 2] {
        let (c, r) = (self.circle.centre, self.circle.radius);
        let size = n[0].hypot(n[1]);
        let unit = [n[0] / size, n[1] / size];
        let lever = (moment - (c[0] * n[1] - c[1] * n[0])) / size;
        let forward = (r * r - lever * lever).max(0.0).sqrt();
        [c[0] + lever * unit[1] + forward * unit[0], c[1] - lever * unit[0] + forward * unit[1]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn section() -> Section {
        let shear = 1.0 / 84591.346;
        Section { bending: 0.048515625, stretch: 1.0 / 258750.0, shear, length: 0.05, width: 0.025 }
    }

    /// Second derivation: classical Runge-Kutta steps with the law as it stands,
    /// zero outside the patch, from the edge of the patch to the clamp. Its
    /// order drops to three where the pressure ends: 1e-7 of the deflection.
    #[test]
    fn plain_integration_arrives_at_the_clamp() {
        let circle = Circle { centre: [14.7e-3, 7.66e-3], radius: 9e-3 };
        let law = ExponentialLaw::diehl();
        for drag in [0.0, -0.3] {
            let method = Collocation::new(STAGES);
            let patch = scaled(&section(), circle, drag, &law, 70.0, &method);
            let one =
                point::softened(&patch.section, patch.circle, drag, &patch.law, 0.02).unwrap();
            let place = patch.place(&patch.guess(&one).unwrap(), 12).unwrap();
            let found = patch.read(&place, 12).unwrap();
            let (c, edge) = (patch.circle.centre, patch.edge(&place));
            let mut y = [0.0; 10];
            y[2] = place.angle;
            let steps = 20_000;
            let ds = -place.start / f64::from(steps);
            for _ in 0..steps {
                y = runge_kutta(&patch, edge, &y, ds);
            }
            (y[0], y[1]) = (y[0] + c[0] + edge[0], y[1] + c[1] + edge[1]);
            let deflection = found.point[1];
            assert!((y[0].abs().max(y[1].abs()) / deflection.abs()) < 1e-7, "{y:?}");
            assert!((y[2] / place.angle).abs() < 1e-7, "{y:?}");
            assert!((y[4] / found.reaction[1] - 1.0).abs() < 1e-7);
        }
    }

    fn runge_kutta(patch: &Patch, edge: [f64; 2], y: &State, ds: f64) -> State {
        let (c, l) = (patch.circle.radius, patch.law.clearance);
        let slope = |y: &State| {
            let loaded = (edge[0] + y[0]).hypot(edge[1] + y[1]) < c + l;
            patch.derivative(y, 0.0, loaded.then_some(edge))
        };
        let moved = |k: &State, share: f64| std::array::from_fn(|i| y[i] + share * ds * k[i]);
        let a = slope(y);
        let b = slope(&moved(&a, 0.5));
        let c = slope(&moved(&b, 0.5));
        let d = slope(&moved(&c, 1.0));
        std::array::from_fn(|i| y[i] + ds / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]))
    }

    /// Limit: the patch shrinks with c0, and the answer tends to hard contact
    /// at one point. Its width is about 2 sqrt(2 r c0).
    #[test]
    fn tends_to_hard_contact() {
        let circle = Circle { centre: [14.7e-3, 7.66e-3], radius: 9e-3 };
        let hard = point::hard(&section(), circle, -0.3).unwrap();
        let gap = |clearance: f64, pressure: f64| {
            let law = ExponentialLaw { clearance, pressure };
            solve(&section(), circle, -0.3, &law).unwrap().force / hard.force - 1.0
        };
        let gaps = [gap(1e-5, 4.8e6), gap(1e-6, 1.6e7), gap(1e-7, 5e7)];
        assert!(gaps[0].abs() < 0.02 && gaps[1].abs() < 0.15 * gaps[0].abs(), "{gaps:?}");
        assert!(gaps[2].abs() < 0.2 * gaps[1].abs(), "{gaps:?}");
    }
}
