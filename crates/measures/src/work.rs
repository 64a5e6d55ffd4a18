//! Work of a force over a path.

use crate::paired::paired;

/// Work [F L] of `force` over `position` by the trapezoidal rule,
/// sum of (F_i + F_(i+1))/2 (u_(i+1) - u_i); `None` for lengths that differ or fewer
/// than two values.
pub fn work(force: &[f64], position: &[f64]) -> Option<f64> {
    let points: Vec<(f64, f64)> = paired(force, position)?.collect();
    let step = |w: &[(f64, f64)]| 0.5 * (w[0].0 + w[1].0) * (w[1].1 - w[0].1);
    (points.len() > 1).then(|| points.windows(2).map(step).sum())
}

/// Ratio [-] of the work of `force` to that of `reference` over the same
/// positions [verification: metrics]; `None` where either does not exist or the
/// reference does no work.
pub fn work_ratio(force: &[f64], reference: &[f64], position: &[f64]) -> Option<f64> {
    let done = work(reference, position)?;
    if done == 0.0 { None } else { Some(work(force, position)? / done) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn trapezoid() {
        assert_eq!(work(&[0.0, 2.0, 2.0], &[0.0, 1.0, 3.0]), Some(5.0));
        // there and back along the same forces: nothing
        assert_eq!(work(&[0.0, 2.0, 0.0], &[0.0, 1.0, 0.0]), Some(0.0));
        assert_eq!(work(&[1.0], &[0.0]), None);
        assert_eq!(work(&[1.0, 2.0], &[0.0]), None);
    }

    #[test]
    fn ratio() {
        let (u, f) = ([0.0, -1.0, -2.0], [0.0, -1.0, -3.0]);
        assert_eq!(work_ratio(&f.map(|v| 2.0 * v), &f, &u), Some(2.0));
        assert_eq!(work_ratio(&f, &[0.0; 3], &u), None);
    }
}
