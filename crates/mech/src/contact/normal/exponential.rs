//! The two exponential laws without dimensions: x = h/c0, pressure in p0, slope in p0/c0, energy in
//! p0 c0.

use std::f64::consts::{E, LN_10};

/// Overclosure over clearance from which the Abaqus law is continued linearly. [semantics: h* = 6 c0]
const LINEAR_FROM: f64 = 6.0;

/// Exponent b h above which the CalculiX law is continued linearly.
const LARGEST_EXPONENT: f64 = 23.0;

/// b c0 = ln 100.
const STEEPNESS: f64 = 2.0 * LN_10;

/// 1/(e - 1).
const SCALE: f64 = 1.0 / (E - 1.0);

/// Pressure and slope of xi (exp(xi) - 1)/(e - 1), xi = 1 + x. [semantics: softened contact]
pub(super) fn dimensionless(x: f64) -> (f64, f64) {
    if x > LINEAR_FROM {
        let (p, slope) = curve(LINEAR_FROM);
        return (p + slope * (x - LINEAR_FROM), slope);
    }
    if x > -1.0 { curve(x) } else { (0.0, 0.0) }
}

fn curve(x: f64) -> (f64, f64) {
    let xi = 1.0 + x;
    let growth = xi.exp_m1();
    (SCALE * (xi * growth), SCALE * (growth + xi * (growth + 1.0)))
}

/// Energy of the same law.
pub(super) fn energy(x: f64) -> f64 {
    if x > LINEAR_FROM {
        let ((p, slope), d) = (curve(LINEAR_FROM), x - LINEAR_FROM);
        return energy_of_curve(LINEAR_FROM) + p * d + 0.5 * slope * d * d;
    }
    if x > -1.0 { energy_of_curve(x) } else { 0.0 }
}

fn energy_of_curve(x: f64) -> f64 {
    let xi = 1.0 + x;
    // w = (xi-1) e^xi + 1 - xi^2/2; its series sum xi^n (n-1)/n! - xi^2/2 where that cancels.
    let w = if xi < 0.5 {
        let mut term = xi * xi * xi / 6.0; // xi^n/n!
        let (mut sum, mut n) = (2.0 * term, 3.0);
        while term.abs() > 1e-18 * sum {
            n += 1.0;
            term *= xi / n;
            sum += (n - 1.0) * term;
        }
        sum
    } else {
        (xi - 1.0) * xi.exp() + 1.0 - 0.5 * xi * xi
    };
    SCALE * w
}

/// x and dx/dp at the pressure y > 0 (in p0): Newton on xi (exp(xi) - 1) = y (e - 1), convex.
pub(super) fn inverse(y: f64) -> (f64, f64) {
    let (top, top_slope) = curve(LINEAR_FROM);
    if y >= top {
        return (LINEAR_FROM + (y - top) / top_slope, 1.0 / top_slope);
    }
    let target = y * (E - 1.0);
    let mut xi = target.sqrt().min(1.0 + LINEAR_FROM); // above the root: exp(xi) - 1 >= xi
    for _ in 0..60 {
        let growth = xi.exp_m1();
        let step = (xi * growth - target) / (growth + xi * (growth + 1.0));
        xi -= step;
        if step.abs() <= 2.0 * f64::EPSILON * xi {
            break;
        }
    }
    let growth = xi.exp_m1();
    (xi - 1.0, (E - 1.0) / (growth + xi * (growth + 1.0)))
}

/// Pressure, slope, energy of the CalculiX law exp(x ln 100); zero pressure below x = -1.
pub(super) fn calculix(x: f64) -> (f64, f64, f64) {
    if x <= -1.0 {
        return (0.0, 0.0, 0.01 / STEEPNESS);
    }
    let exponent = STEEPNESS * x;
    if exponent > LARGEST_EXPONENT {
        let p = LARGEST_EXPONENT.exp();
        let d = x - LARGEST_EXPONENT / STEEPNESS;
        let slope = STEEPNESS * p;
        return (p + slope * d, slope, p / STEEPNESS + p * d + 0.5 * slope * d * d);
    }
    let p = exponent.exp();
    (p, STEEPNESS * p, p / STEEPNESS)
}

/// x and dx/dp of the CalculiX law; on the jump x = -1 with dx/dp = 0.
pub(super) fn calculix_inverse(y: f64) -> (f64, f64) {
    if y <= 0.01 {
        return (-1.0, 0.0);
    }
    let top = LARGEST_EXPONENT.exp();
    if y > top {
        let slope = STEEPNESS * top;
        return (LARGEST_EXPONENT / STEEPNESS + (y - top) / slope, 1.0 / slope);
    }
    (y.ln() / STEEPNESS, 1.0 / (STEEPNESS * y))
}
