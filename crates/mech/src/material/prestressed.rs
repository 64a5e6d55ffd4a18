//! A material that is under stress before it deforms.
//!
//! ```text
//!   free of stress --H0--> undeformed, under stress --H--> now      1 + H_m = (1 + H)(1 + H0)
//! ```
//!
//! Every point keeps its own H0, which is symmetric: the first of its state variables. docs/theory.md
//! section 3.15.

use super::answer::{Answer, Conditions};
use super::tensor::{COUNTS, INDEX, Matrix, Symmetric, dilation};

/// State variables of a point that are H0; zeros: it begins free of stress.
pub const STATES: usize = 6;
/// Most corrections of H0.
const MOST: usize = 200;
/// Roundings of the stress that a correction may leave.
const ROUNDINGS: f64 = 16.0;

/// A law of a body that is under stress before it deforms.
#[derive(Debug, Clone, PartialEq)]
pub struct Prestressed<L> {
    /// What it answers from where it is free of stress.
    pub law: L,
}

/// State variables of a point that begins under stress: those of that, and those of its law.
pub(super) fn parted(state: &[f64]) -> [&[f64]; 2] {
    let (first, rest) = state.split_at(STATES.min(state.len()));
    [first, rest]
}

/// A symmetric tensor by rows.
fn full(strain: &[f64]) -> Matrix {
    let entry = |place: usize| strain.get(place).copied().unwrap_or(0.0);
    INDEX.map(|row| row.map(entry))
}

/// Answer of the `law` from where it is free of stress, of a displacement gradient from the
/// undeformed body, eq. (3.110).
pub(super) fn respond(
    gradient: &Matrix,
    under: &Conditions,
    before: &[f64],
    law: impl FnOnce(&Matrix) -> Answer,
) -> Answer {
    let first = full(before);
    let mut all = *gradient;
    for i in 0..3 {
        for j in 0..3 {
            all[i][j] += first[i][j];
            if under.large {
                all[i][j] += (0..3).map(|k| gradient[i][k] * first[k][j]).sum::<f64>();
            }
        }
    }
    let answer = law(&all);
    if !under.large {
        return answer;
    }
    // of a unit of the undeformed volume
    let share = 1.0 / (1.0 + dilation(&first));
    Answer {
        stress: answer.stress.map(|stress| share * stress),
        moduli: answer.moduli.map(|row| row.map(|entry| share * entry)),
        energy: share * answer.energy,
        dissipation: share * answer.dissipation,
    }
}

/// H0 for which the `law` answers a Cauchy stress [F/L2]; `None`: it bears no such stress.
pub(super) fn before(
    stress: &Symmetric,
    large: bool,
    law: impl Fn(&Matrix) -> Answer,
) -> Option<Symmetric> {
    let largest = stress.iter().fold(0.0_f64, |most, own| most.max(own.abs()));
    let mut strain = [0.0; 6];
    if largest == 0.0 {
        return Some(strain);
    }
    let moduli = law(&full(&strain)).moduli;
    let stiffest = moduli.as_flattened().iter().fold(0.0_f64, |most, own| most.max(own.abs()));
    for _ in 0..MOST {
        let gradient = full(&strain);
        let share = if large { 1.0 / (1.0 + dilation(&gradient)) } else { 1.0 };
        let answer = law(&gradient).stress;
        let missing: Symmetric = std::array::from_fn(|k| stress[k] - share * answer[k]);
        if !missing.iter().all(|own| own.is_finite()) {
            return None;
        }
        // a small stress can be the difference of large ones: of volume and of shape in next to incompressible rubber
        let strained = strain.iter().fold(0.0_f64, |most, own| most.max(own.abs()));
        let made = largest + stiffest * strained;
        if missing.iter().all(|own| own.abs() <= ROUNDINGS * f64::EPSILON * made) {
            return Some(strain);
        }
        let step = solve(moduli, missing)?;
        (0..6).for_each(|k| strain[k] += step[k] / COUNTS[k]);
    }
    None
}

/// Solves six equations by elimination; `None`: they are singular.
fn solve(mut a: [[f64; 6]; 6], mut b: Symmetric) -> Option<Symmetric> {
    for k in 0..6 {
        let pivot = (k..6).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs()))?;
        a.swap(k, pivot);
        b.swap(k, pivot);
        if a[k][k] == 0.0 {
            return None;
        }
        let row = a[k];
        for i in k + 1..6 {
            let factor = a[i][k] / row[k];
            (k..6).for_each(|j| a[i][j] -= factor * row[j]);
            b[i] -= factor * b[k];
        }
    }
    for k in (0..6).rev() {
        let rest: f64 = (k + 1..6).map(|j| a[k][j] * b[j]).sum();
        b[k] = (b[k] - rest) / a[k][k];
    }
    Some(b)
}
