//! Size of a curve and of its distance from a reference.

use crate::paired::paired;

/// Root mean square sqrt(mean(v^2)), in the units of the values; `None` for no values.
pub fn rms(values: &[f64]) -> Option<f64> {
    let scale = maximum(values)?;
    if scale == 0.0 {
        return Some(0.0);
    }
    // scaled by the largest value: no overflow, no underflow
    let mean = values.iter().map(|v| (v / scale).powi(2)).sum::<f64>() / values.len() as f64;
    Some(scale * mean.sqrt())
}

/// Largest magnitude max|v|, in the units of the values; `None` for no values or a NaN.
pub fn maximum(values: &[f64]) -> Option<f64> {
    let largest = |m: f64, v: &f64| if v.is_nan() { f64::NAN } else { m.max(v.abs()) };
    // fold keeps a NaN once met, for NaN.max(x) would lose it
    let found = values.iter().fold(0.0, |m: f64, v| if m.is_nan() { m } else { largest(m, v) });
    (!values.is_empty() && !found.is_nan()).then_some(found)
}

/// Relative RMS error [-]: rms(values - reference)/max|reference|
/// [verification: metrics]. `None` for lengths that differ or a reference of zero.
pub fn rms_error(values: &[f64], reference: &[f64]) -> Option<f64> {
    relative(values, reference, rms)
}

/// Relative largest error [-]: max|values - reference|/max|reference|
/// [verification: metrics]. `None` as for [`rms_error`].
pub fn max_error(values: &[f64], reference: &[f64]) -> Option<f64> {
    relative(values, reference, maximum)
}

fn relative(
    values: &[f64],
    reference: &[f64],
    size: impl Fn(&[f64]) -> Option<f64>,
) -> Option<f64> {
    let difference: Vec<f64> = paired(values, reference)?.map(|(v, r)| v - r).collect();
    let peak = maximum(reference)?;
    if peak > 0.0 { Some(size(&difference)? / peak) } else { None }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes() {
        assert_eq!(rms(&[3.0, -4.0, 0.0, 0.0]), Some(2.5));
        assert_eq!(maximum(&[3.0, -4.0]), Some(4.0));
        assert_eq!((rms(&[]), maximum(&[]), maximum(&[f64::NAN, 1.0])), (None, None, None));
        assert_eq!(rms(&[0.0]), Some(0.0));
        assert!((rms(&[1e300, 1e300]).unwrap() / 1e300 - 1.0).abs() < 1e-15);
    }

    /// Property: errors do not depend on the units and vanish on the reference.
    #[test]
    fn errors_are_relative() {
        let reference = [0.0, -1.0, -3.0, -10.0];
        let values = [0.1, -1.2, -2.9, -10.0];
        let scaled = |v: &[f64]| v.iter().map(|x| x * 1024.0).collect::<Vec<_>>();
        assert_eq!(
            rms_error(&values, &reference),
            rms_error(&scaled(&values), &scaled(&reference))
        );
        assert!((max_error(&values, &reference).unwrap() - 0.02).abs() < 1e-15);
        assert_eq!(rms_error(&reference, &reference), Some(0.0));
        assert_eq!(rms_error(&values, &reference[1..]), None);
        assert_eq!(rms_error(&[1.0], &[0.0]), None);
    }
}
