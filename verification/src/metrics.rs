//! Measures on curves, as verification section 3 defines them, written here
//! a second time on purpose.

/// How far a curve is from its reference, as fractions of the reference's peak.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// Root of the mean square [1].
    pub rms: f64,
    /// Largest [1].
    pub max: f64,
}

/// The largest of many numbers, not below zero; not a number if one of them is not.
pub fn worst(values: impl IntoIterator<Item = f64>) -> f64 {
    let larger = |most: f64, value: f64| if value <= most || most.is_nan() { most } else { value };
    values.into_iter().fold(0.0, larger)
}

/// Largest magnitude [unit of the curve].
pub fn peak(curve: &[f64]) -> f64 {
    worst(curve.iter().map(|value| value.abs()))
}

/// The larger of two curves' largest magnitudes [unit of the curves].
pub fn largest(a: &[f64], b: &[f64]) -> f64 {
    worst([peak(a), peak(b)])
}

/// Largest magnitude of a - b [unit of the curves]; infinite where they differ in length.
pub fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    if a.len() != b.len() {
        return f64::INFINITY;
    }
    worst(a.iter().zip(b).map(|(a, b)| (a - b).abs()))
}

/// RMS and largest difference over all rows, against the peak of `reference`.
/// Infinite where the curves differ in length.
pub fn differ(curve: &[f64], reference: &[f64]) -> Difference {
    let scale = peak(reference);
    if curve.len() != reference.len() {
        return Difference { rms: f64::INFINITY, max: f64::INFINITY };
    }
    let squares: f64 = curve.iter().zip(reference).map(|(a, b)| (a - b) * (a - b)).sum();
    Difference {
        rms: (squares / curve.len() as f64).sqrt() / scale,
        max: largest_difference(curve, reference) / scale,
    }
}

/// Sign changes of the slope.
pub fn reversals(curve: &[f64]) -> usize {
    let mut last = 0.0;
    let mut count = 0;
    for pair in curve.windows(2) {
        let rise = pair[1] - pair[0];
        if rise * last < 0.0 {
            count += 1;
        }
        if rise != 0.0 {
            last = rise;
        }
    }
    count
}

/// White noise in a curve, from the second differences of curve minus
/// reference, as a fraction of the reference's peak [1].
pub fn roughness(curve: &[f64], reference: &[f64]) -> f64 {
    let rest: Vec<f64> = curve.iter().zip(reference).map(|(a, b)| a - b).collect();
    let seconds = rest.windows(3).map(|w| w[0] - 2.0 * w[1] + w[2]);
    let squares: f64 = seconds.map(|d| d * d).sum();
    let count = rest.len().saturating_sub(2) as f64;
    (squares / count / 6.0).sqrt() / peak(reference)
}

/// Integral of `curve` over `abscissa` by the trapezoidal rule.
pub fn trapezoid(abscissa: &[f64], curve: &[f64]) -> f64 {
    let pieces = abscissa.windows(2).zip(curve.windows(2));
    pieces.map(|(x, y)| 0.5 * (y[0] + y[1]) * (x[1] - x[0])).sum()
}

/// Least squares slope of the logarithms of points.
pub fn order(points: &[[f64; 2]]) -> f64 {
    let points: Vec<[f64; 2]> = points.iter().map(|point| point.map(f64::ln)).collect();
    let mean = [0, 1].map(|k| points.iter().map(|p| p[k]).sum::<f64>() / points.len() as f64);
    let products = points.iter().map(|p| (p[0] - mean[0]) * (p[1] - mean[1]));
    let squares = points.iter().map(|p| (p[0] - mean[0]).powi(2));
    products.sum::<f64>() / squares.sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn by_hand() {
        assert_eq!(differ(&[1.0, 2.0], &[1.0, 4.0]).max, 0.5);
        assert!((differ(&[0.0, 2.0], &[0.0, 4.0]).rms - 0.125f64.sqrt()).abs() < 1e-15);
        assert_eq!(reversals(&[0.0, 1.0, 1.0, 2.0, 1.0, 1.0, 3.0]), 2);
        assert_eq!(trapezoid(&[0.0, 1.0, 3.0], &[0.0, 2.0, 2.0]), 5.0);
        // the rest 1, 2, 3, 3 has second differences of 0 and -1
        let rough = roughness(&[1.0, 2.0, 3.0, 4.0], &[0.0, 0.0, 0.0, 1.0]);
        assert!((rough - (1.0f64 / 12.0).sqrt()).abs() < 1e-15);
        assert_eq!(largest_difference(&[1.0], &[]), f64::INFINITY);
        // what is not a number is never overlooked
        assert!(largest_difference(&[f64::NAN, 1.0], &[0.0, 0.0]).is_nan());
        assert!(peak(&[2.0, f64::NAN, 1.0]).is_nan() && peak(&[-2.0, 1.0]) == 2.0);
    }
}
