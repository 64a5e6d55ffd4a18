//! Contact at one point: elastica and Reissner beam, hard or softened.
//!
//! ```text
//!  |\                     .--.
//!  |=====____            ( c  )      reaction n, constant along the arc
//!  |/        ``--__       `-.'
//!                  ``--__  / n = N (m + mu w)
//!                        `x--__      free end: straight
//!                          angle f_c
//! ```
//!
//! Between clamp and contact the force n is constant, and with n_1, n_2 its
//! components along and across the section,
//! H = M^2/(2 EI) + n_1 + n_1^2/(2 EA) + n_2^2/(2 kGA) is constant too (derived:
//! dH/ds = 0 by the equations of equilibrium). With M = 0 at the contact, M is
//! thus known as a function of the angle, and arc length and position are
//! integrals over the angle: two equations remain, in N and f_c.

use super::equilibrium::Local;
use super::linear;
use super::section::Section;
use crate::error::TheoryError;
use crate::frame::Circle;
use crate::numerics::{gauss, newton, root};
use crate::softened_law::ExponentialLaw;
use std::cell::Cell;
use std::sync::OnceLock;

/// Points of the quadrature over the angle.
const POINTS: usize = 32;
/// Smallest share of the way in the search from first touch to the position asked for.
const SMALLEST_ADVANCE: f64 = 1e-4;

/// Force on the beam and the slope at the contact for a normal force and an angle.
struct Load {
    n: [f64; 2],
    /// Mean angle of the centreline at the load.
    mean: f64,
}

/// The arc from clamp to contact.
struct Arc {
    length: f64,
    tip: [f64; 2],
    strain_energy: f64,
}

impl Load {
    /// n = N (m + mu w), with m normal to the mean of the two slopes of the
    /// centreline at the load: half the shear angle beyond the section
    /// [semantics: slope jump under a point load].
    fn new(section: &Section, normal: f64, angle: f64, drag: f64) -> Self {
        let mut half = 0.0f64;
        for _ in 0..50 {
            let n_1 = normal * (half.sin() + drag * half.cos());
            let n_2 = normal * (drag * half.sin() - half.cos());
            let next = 0.5 * (n_2 * section.shear).atan2(1.0 + n_1 * section.stretch);
            let settled = (next - half).abs() <= f64::EPSILON * next.abs();
            half = next;
            if settled {
                break;
            }
        }
        let mean = angle + half;
        let (s, c) = mean.sin_cos();
        Self { n: [normal * (s + drag * c), normal * (drag * s - c)], mean }
    }

    fn along(&self, angle: f64) -> f64 {
        self.n[0] * angle.cos() + self.n[1] * angle.sin()
    }
    fn across(&self, angle: f64) -> f64 {
        self.n[1] * angle.cos() - self.n[0] * angle.sin()
    }
}

/// Half the square of the moment over EI at the angle `f`: H at the contact
/// less what forces alone make of it, in differences that do not cancel.
fn bending_energy(section: &Section, load: &Load, contact: f64, f: f64) -> f64 {
    let (middle, half) = (0.5 * (contact + f), 0.5 * (contact - f));
    // n_1(contact) - n_1(f) and n_2(contact) - n_2(f) by sums to products
    let d_along = 2.0 * half.sin() * load.across(middle);
    let d_across = -2.0 * half.sin() * load.along(middle);
    let sum_along = load.along(contact) + load.along(f);
    let sum_across = load.across(contact) + load.across(f);
    d_along * (1.0 + 0.5 * section.stretch * sum_along)
        + 0.5 * section.shear * d_across * sum_across
}

/// Arc length, end point and strain energy of the arc that ends at the angle
/// `contact` without moment. The angle is contact (1 - tau^2): the integrand
/// is smooth where the moment vanishes.
fn arc(
    section: &Section,
    load: &Load,
    contact: f64,
    rule: &[(f64, f64)],
) -> Result<Arc, TheoryError> {
    let mut sum = [0.0; 4];
    for &(tau, weight) in rule {
        let f = contact * (1.0 - tau) * (1.0 + tau);
        let bending = bending_energy(section, load, contact, f);
        if bending.is_nan() || bending <= 0.0 {
            return Err(TheoryError::Inflection);
        }
        let ds = -2.0 * contact * tau * weight * (0.5 * section.bending / bending).sqrt();
        let (n_1, n_2) = (load.along(f), load.across(f));
        let (stretched, sheared) = (1.0 + n_1 * section.stretch, n_2 * section.shear);
        let (s, c) = f.sin_cos();
        let forces = 0.5 * (n_1 * n_1 * section.stretch + n_2 * n_2 * section.shear);
        let slopes =
            [1.0, stretched * c - sheared * s, stretched * s + sheared * c, bending + forces];
        for (total, slope) in sum.iter_mut().zip(slopes) {
            *total += ds * slope;
        }
    }
    Ok(Arc { length: sum[0], tip: [sum[1], sum[2]], strain_energy: sum[3] })
}

/// Hard contact at one point.
///
/// # Errors
/// Why there is no such equilibrium.
pub(super) fn hard(section: &Section, circle: Circle, drag: f64) -> Result<Local, TheoryError> {
    finish(section, circle, drag, search(section, circle, drag, None)?)
}

/// (N, f_c) of hard contact: from an earlier answer nearby, from linear theory, or
/// by bringing the circle down from first touch, whichever succeeds first.
fn search(
    section: &Section,
    circle: Circle,
    drag: f64,
    earlier: Option<[f64; 2]>,
) -> Result<[f64; 2], TheoryError> {
    let gap = circle.centre[1] - circle.radius;
    if gap >= 0.0 {
        return Err(TheoryError::NoContact { gap });
    }
    check_clamp(circle)?;
    let from = |guess| hard_from(section, circle, drag, guess, rule());
    if let Some(Ok(found)) = earlier.map(from) {
        return Ok(found);
    }
    linear::solve(section, circle, 0.0)
        .and_then(|start| from([start.force, start.angle.atan()]))
        .or_else(|_| approach(section, circle, drag, rule()))
}

/// The rule of the quadrature over the angle, computed once.
fn rule() -> &'static [(f64, f64)] {
    static RULE: OnceLock<Vec<(f64, f64)>> = OnceLock::new();
    RULE.get_or_init(|| gauss::rule(POINTS))
}

/// A finer rule, for the check of the answer.
fn finer_rule() -> &'static [(f64, f64)] {
    static RULE: OnceLock<Vec<(f64, f64)>> = OnceLock::new();
    RULE.get_or_init(|| gauss::rule(POINTS + 16))
}

/// The clamped end must stay outside the circle: no contact is possible else.
fn check_clamp(circle: Circle) -> Result<(), TheoryError> {
    if circle.centre[0].hypot(circle.centre[1]) <= circle.radius {
        Err(TheoryError::PastClamp)
    } else {
        Ok(())
    }
}

/// Solves for (N, f_c) from a guess of both.
fn hard_from(
    section: &Section,
    circle: Circle,
    drag: f64,
    guess: [f64; 2],
    rule: &[(f64, f64)],
) -> Result<[f64; 2], TheoryError> {
    let deflection = circle.radius - circle.centre[1];
    let residual = |z: &[f64; 2]| {
        let (normal, angle) = (guess[0] * z[0].exp(), guess[1] * z[1]);
        if !(-std::f64::consts::FRAC_PI_2..0.0).contains(&angle) {
            return Err(TheoryError::Inflection);
        }
        let load = Load::new(section, normal, angle, drag);
        check_jamming(&load, normal)?;
        let end = arc(section, &load, angle, rule)?.tip;
        let (s, c) = load.mean.sin_cos();
        let r = circle.radius;
        Ok([
            (end[0] - circle.centre[0] - r * s) / circle.centre[0],
            (end[1] - circle.centre[1] + r * c) / deflection,
        ])
    };
    let z = newton::solve(residual, [0.0, 1.0])?;
    Ok([guess[0] * z[0].exp(), guess[1] * z[1]])
}

fn check_jamming(load: &Load, normal: f64) -> Result<(), TheoryError> {
    if load.n[1] < 0.0 {
        Ok(())
    } else {
        Err(TheoryError::Jamming { transverse: -load.n[1] / normal })
    }
}

/// Brings the circle down from first touch, step by step, where the direct
/// search from linear theory fails.
fn approach(
    section: &Section,
    circle: Circle,
    drag: f64,
    rule: &[(f64, f64)],
) -> Result<[f64; 2], TheoryError> {
    let depth = circle.radius - circle.centre[1];
    let at =
        |share: f64| Circle { centre: [circle.centre[0], circle.radius - share * depth], ..circle };
    let (mut share, mut advance) = (1e-3, 0.05);
    let start = linear::solve(section, at(share), 0.0)?;
    let mut unknowns = hard_from(section, at(share), drag, [start.force, start.angle], rule)?;
    while share < 1.0 {
        let next = (share + advance).min(1.0);
        // to first order force and angle grow with the depth
        let growth = next / share;
        let guess = [unknowns[0] * growth, unknowns[1] * growth];
        match hard_from(section, at(next), drag, guess, rule)
            .or_else(|_| hard_from(section, at(next), drag, unknowns, rule))
        {
            Ok(found) => (share, unknowns, advance) = (next, found, 1.5 * advance),
            Err(reason) if advance < SMALLEST_ADVANCE => return Err(reason),
            Err(_) => advance *= 0.4,
        }
    }
    Ok(unknowns)
}

fn finish(
    section: &Section,
    circle: Circle,
    drag: f64,
    [normal, angle]: [f64; 2],
) -> Result<Local, TheoryError> {
    let load = Load::new(section, normal, angle, drag);
    check_jamming(&load, normal)?;
    let found = arc(section, &load, angle, rule())?;
    section.check_inside(found.length)?;
    // the same integral with more points: the promise of eight digits is kept or withdrawn
    let finer = arc(section, &load, angle, finer_rule())?;
    let change =
        (finer.length / found.length - 1.0).abs().max((finer.tip[1] / found.tip[1] - 1.0).abs());
    if change > 1e-11 {
        return Err(TheoryError::NotConverged { correction: change });
    }
    let (s, c) = load.mean.sin_cos();
    Ok(Local {
        contact_length: found.length,
        force: normal,
        reaction: load.n,
        point: [circle.centre[0] + circle.radius * s, circle.centre[1] - circle.radius * c],
        angle,
        overclosure: 0.0,
        strain_energy: found.strain_energy,
        contact_energy: 0.0,
    })
}

/// One softened contact point of tributary area A: the point lies at the
/// overclosure h with N = A p(h). For given h this is hard contact with a
/// circle of radius r - h, whose N falls with h while A p(h) rises: one root.
///
/// # Errors
/// Why there is no such equilibrium.
pub(super) fn softened(
    section: &Section,
    circle: Circle,
    drag: f64,
    law: &ExponentialLaw,
    area: f64,
) -> Result<Local, TheoryError> {
    law.check()?;
    if !(area.is_finite() && area > 0.0) {
        return Err(TheoryError::InvalidInput("the tributary area must be positive"));
    }
    // overclosure of the undeflected beam: the largest possible one
    let most = circle.radius - circle.centre[1];
    if most <= -law.clearance {
        return Err(TheoryError::NoContact { gap: -most });
    }
    let shrunk = |h: f64| Circle { radius: circle.radius - h, ..circle };
    let earlier = Cell::new(None);
    let excess = |h: f64| match search(section, shrunk(h), drag, earlier.get()) {
        Ok(found) => {
            earlier.set(Some(found));
            Ok(found[0] - area * law.at(h).pressure)
        }
        Err(TheoryError::NoContact { .. }) => Ok(-area * law.at(h).pressure),
        Err(reason) => Err(reason),
    };
    let least = lower_end(&excess, law, most)?;
    let h = root::fallible(excess, least, most)?;
    let found = hard(section, shrunk(h), drag)?;
    let contact_energy = area * law.at(h).energy;
    Ok(Local { overclosure: h, contact_energy, ..found })
}

/// Lower end of the bracket: -c0, raised where the hard problem for the larger
/// circle has no solution although the softened one may have. If no raised end
/// asks for more overclosure, the reason at -c0 stands.
fn lower_end(
    excess: &impl Fn(f64) -> Result<f64, TheoryError>,
    law: &ExponentialLaw,
    most: f64,
) -> Result<f64, TheoryError> {
    let mut low = -law.clearance;
    let Err(reason) = excess(low) else { return Ok(low) };
    for _ in 0..40 {
        low = 0.5 * (low + most);
        match excess(low) {
            Ok(value) if value > 0.0 => return Ok(low),
            Ok(_) => break,
            Err(_) => {}
        }
    }
    Err(reason)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::gauss::Collocation;

    fn section() -> Section {
        let shear = 1.0 / 84591.346;
        Section { bending: 0.048515625, stretch: 1.0 / 258750.0, shear, length: 0.05, width: 0.025 }
    }

    fn circle() -> Circle {
        Circle { centre: [14.7e-3, 7.66e-3], radius: 9e-3 }
    }

    /// Second derivation: the differential equations of the Reissner beam in the
    /// arc length, shot backwards from the contact, arrive at the clamp. The
    /// quadrature over the angle knows nothing of this route.
    #[test]
    fn backward_shooting_arrives_at_the_clamp() {
        for (elastic, drag) in [(1.0, 0.0), (1.0, -0.3), (1.0, 0.3), (0.0, -0.3), (200.0, -0.2)] {
            let s = Section {
                stretch: elastic * section().stretch,
                shear: elastic * section().shear,
                ..section()
            };
            let found = hard(&s, circle(), drag).unwrap();
            let n = found.reaction;
            let equations = |y: &[f64; 4]| {
                let (sin, cos) = y[2].sin_cos();
                let (e, g) = (
                    1.0 + s.stretch * (n[0] * cos + n[1] * sin),
                    s.shear * (n[1] * cos - n[0] * sin),
                );
                let (dx, dy) = (e * cos - g * sin, e * sin + g * cos);
                [dx, dy, y[3] / s.bending, dy * n[0] - dx * n[1]]
            };
            let from = [found.point[0], found.point[1], found.angle, 0.0];
            let clamp =
                Collocation::new(6).advance(from, -found.contact_length, 8, equations).unwrap();
            // relative to the deflection and the angle at the contact
            assert!(clamp[0].abs() < 1e-13, "{clamp:?}");
            assert!((clamp[1] / found.point[1]).abs() < 1e-10, "{clamp:?}");
            assert!((clamp[2] / found.angle).abs() < 1e-10, "{clamp:?}");
        }
    }

    /// The force is normal to the mean of the slopes on both sides of the load,
    /// and turned by the friction angle.
    #[test]
    fn reaction_has_the_friction_angle() {
        let found = hard(&section(), circle(), -0.3).unwrap();
        let m = [(found.point[0] - 14.7e-3) / 9e-3, (found.point[1] - 7.66e-3) / 9e-3];
        let normal = found.reaction[0] * m[0] + found.reaction[1] * m[1];
        let along = -found.reaction[0] * m[1] + found.reaction[1] * m[0];
        assert!((normal / found.force - 1.0).abs() < 1e-12);
        assert!((along / found.force + 0.3).abs() < 1e-12);
    }

    /// Limit: R becomes K as EA and kGA grow, linearly in the flexibilities.
    #[test]
    fn reissner_tends_to_the_elastica() {
        let force = |factor: f64| {
            let s = Section {
                stretch: factor * section().stretch,
                shear: factor * section().shear,
                ..section()
            };
            hard(&s, circle(), -0.3).unwrap().force
        };
        let stiff = force(0.0);
        let gaps: Vec<f64> =
            [1.0, 1e-2, 1e-4].iter().map(|f| (force(*f) / stiff - 1.0).abs()).collect();
        assert!(gaps[0] > 1e-3 && gaps[0] < 0.1);
        assert!((gaps[0] / gaps[1] / 100.0 - 1.0).abs() < 0.05, "{gaps:?}");
        assert!((gaps[1] / gaps[2] / 100.0 - 1.0).abs() < 0.01, "{gaps:?}");
    }

    /// Limit: softened contact becomes hard contact as c0 tends to zero.
    #[test]
    fn softened_tends_to_hard() {
        let hard = hard(&section(), circle(), -0.3).unwrap().force;
        let gap = |clearance: f64| {
            let law = ExponentialLaw { clearance, pressure: 4.8e6 };
            softened(&section(), circle(), -0.3, &law, 1.5705e-5).unwrap().force / hard - 1.0
        };
        let gaps = [gap(1e-5), gap(1e-7), gap(1e-9)];
        assert!(gaps[0].abs() < 0.02 && (gaps[0] / gaps[1] / 100.0 - 1.0).abs() < 0.02, "{gaps:?}");
        assert!((gaps[1] / gaps[2] / 100.0 - 1.0).abs() < 1e-3, "{gaps:?}");
    }

    /// A circle of another size against a long, limp beam: large angles, where
    /// linear theory is no starting point, and the promise of the accuracy.
    #[test]
    fn large_deflections() {
        let s = Section { length: 0.5, ..section() };
        for depth in [5e-3, 20e-3, 50e-3] {
            let c = Circle { centre: [60e-3, 9e-3 - depth], radius: 9e-3 };
            let found = hard(&s, c, -0.1).unwrap();
            assert!(found.force > 0.0 && found.angle < 0.0);
        }
    }
}
