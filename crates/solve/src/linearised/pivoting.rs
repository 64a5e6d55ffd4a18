//! The pivoting method that finds which hard points press.
//!
//! ```text
//!   h = b - C p <= 0,  p >= 0,  p h = 0:   take the worst violation in,
//!   close the set exactly, drop what pulls, until nothing is violated
//! ```

use super::system::System;
use slideline_linalg::DenseLu;

/// Non-negative least squares on the rows `candidates` of a system; the
/// other unknowns stay as they are.
pub(super) fn pivoting(system: &System<'_>, candidates: &[usize], unknown: &mut [f64]) {
    let scale = candidates.iter().map(|&i| system.rows[i].free.abs()).fold(0.0, f64::max);
    for &i in candidates {
        // p = 0: q = -s (h - h0), to first order without the other rows.
        unknown[i] = 0.0;
    }
    let mut active: Vec<usize> = Vec::new();
    let mut factors = DenseLu::default();
    for _ in 0..4 * candidates.len() + 8 {
        let value = |i: usize| system.multiplier_and_value(i, unknown).1;
        let open = candidates.iter().copied().filter(|i| !active.contains(i));
        let Some(worst) = open.max_by(|&a, &b| value(a).total_cmp(&value(b))) else { return };
        if value(worst) <= 1e-13 * scale {
            return;
        }
        active.push(worst);
        while !close(system, &mut active, &mut factors, unknown) {}
    }
}

/// Closes the active rows (h = 0, others p = 0); drops the row whose pressure
/// turns negative first. False: a row was dropped, close again.
fn close(
    system: &System<'_>,
    active: &mut Vec<usize>,
    factors: &mut DenseLu,
    unknown: &mut [f64],
) -> bool {
    let m = active.len();
    let n = system.rows.len();
    let matrix = factors.matrix_mut(m);
    let mut rhs = vec![0.0; m];
    for (a, &i) in active.iter().enumerate() {
        rhs[a] = system.multiplier_and_value(i, unknown).1;
        for (b, &j) in active.iter().enumerate() {
            matrix[a * m + b] = system.compliance[i * n + j];
        }
    }
    factors.factor();
    // as many equations as were factored: it cannot fail
    let _ = factors.solve(&mut rhs);
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
