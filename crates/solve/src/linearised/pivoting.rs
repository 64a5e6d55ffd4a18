//! Dense work of the small system: elimination, and the pivoting method that
//! finds which hard points press.
//!
//! ```text
//!   h = b - C p <= 0,  p >= 0,  p h = 0:   take the worst violation in,
//!   close the set exactly, drop what pulls, until nothing is violated
//! ```

use super::system::System;

/// Non-negative least squares on the rows `candidates` of a system; the
/// other unknowns stay as they are.
pub(super) fn pivoting(system: &System<'_>, candidates: &[usize], unknown: &mut [f64]) {
    let scale = candidates.iter().map(|&i| system.rows[i].free.abs()).fold(0.0, f64::max);
    for &i in candidates {
        // p = 0: q = -s (h - h0), to first order without the other rows.
        unknown[i] = 0.0;
    }
    let mut active: Vec<usize> = Vec::new();
    for _ in 0..4 * candidates.len() + 8 {
        let value = |i: usize| system.multiplier_and_value(i, unknown).1;
        let open = candidates.iter().copied().filter(|i| !active.contains(i));
        let Some(worst) = open.max_by(|&a, &b| value(a).total_cmp(&value(b))) else { return };
        if value(worst) <= 1e-13 * scale {
            return;
        }
        active.push(worst);
        while !close(system, &mut active, unknown) {}
    }
}

/// Closes the active rows (h = 0, others p = 0); drops the row whose pressure
/// turns negative first. False: a row was dropped, close again.
fn close(system: &System<'_>, active: &mut Vec<usize>, unknown: &mut [f64]) -> bool {
    let m = active.len();
    let n = system.rows.len();
    let mut matrix = vec![0.0; m * m];
    let mut rhs = vec![0.0; m];
    for (a, &i) in active.iter().enumerate() {
        rhs[a] = system.multiplier_and_value(i, unknown).1;
        for (b, &j) in active.iter().enumerate() {
            matrix[a * m + b] = system.compliance[i * n + j];
        }
    }
    eliminate(&mut matrix, &mut rhs);
    let mut fraction = 1.0;
    let mut leaves = None;
    for (a, &i) in active.iter().enumerate() {
        let end = unknown[i] + rhs[a];
        if end < 0.0 && a + 1 < m {
            let until = unknown[i] / (unknown[i] - end);
            if until < fraction {
                (fraction, leaves) = (until.max(0.0), Some(a));
            }
        }
    }
    for (a, &i) in active.iter().enumerate() {
        unknown[i] += fraction * rhs[a];
    }
    match leaves {
        Some(a) => {
            unknown[active[a]] = 0.0;
            active.remove(a);
            false
        }
        None => true,
    }
}

/// Solves a dense system in place by elimination with row pivoting. A row
/// that depends on the others (an overconstrained point) is given a zero
/// change.
pub(super) fn eliminate(matrix: &mut [f64], rhs: &mut [f64]) {
    let m = rhs.len();
    let scale = matrix.iter().fold(0.0_f64, |largest, entry| largest.max(entry.abs()));
    for k in 0..m {
        let pivot = (k..m)
            .max_by(|&a, &b| matrix[a * m + k].abs().total_cmp(&matrix[b * m + k].abs()))
            .unwrap_or(k);
        if pivot != k {
            for j in 0..m {
                matrix.swap(k * m + j, pivot * m + j);
            }
            rhs.swap(k, pivot);
        }
        if matrix[k * m + k].abs() <= 1e-14 * scale {
            for j in 0..m {
                matrix[k * m + j] = if j == k { 1.0 } else { 0.0 };
            }
            rhs[k] = 0.0;
            continue;
        }
        for i in k + 1..m {
            let factor = matrix[i * m + k] / matrix[k * m + k];
            if factor != 0.0 {
                for j in k..m {
                    matrix[i * m + j] -= factor * matrix[k * m + j];
                }
                rhs[i] -= factor * rhs[k];
            }
        }
    }
    for k in (0..m).rev() {
        let known: f64 = (k + 1..m).map(|j| matrix[k * m + j] * rhs[j]).sum();
        rhs[k] = (rhs[k] - known) / matrix[k * m + k];
    }
}
