//! Roughness and reversals: noise seen in the shape of a curve.

use crate::difference::{maximum, rms};
use crate::paired;

/// Noise floor of [`reversals`] relative to the peak [-]: far above round-off
/// and the tolerance of an increment, far below the noise to be counted.
pub const DEFAULT_NOISE_FLOOR: f64 = 1e-6;

/// Roughness [-] of a curve without reference: sqrt(mean(d2(v)^2)/6)/max|v|, d2 the
/// second difference [verification: metrics].
///
/// White noise of standard deviation s on a smooth curve has second differences
/// of variance 6 s^2: the measure estimates s/peak. Use it with 200 increments
/// or more, so that the curve's own second differences are small. `None` for fewer than
/// three values or a peak of zero.
pub fn roughness(values: &[f64]) -> Option<f64> {
    scaled_roughness(values, maximum(values)?)
}

/// Roughness [-] against a reference: sqrt(mean(d2(v - r)^2)/6)/max|r|
/// [verification: metrics]. A smooth bias drops out. `None` as for [`roughness`],
/// or for lengths that differ.
pub fn roughness_against(values: &[f64], reference: &[f64]) -> Option<f64> {
    let difference: Vec<f64> = paired(values, reference)?.map(|(v, r)| v - r).collect();
    scaled_roughness(&difference, maximum(reference)?)
}

fn scaled_roughness(values: &[f64], peak: f64) -> Option<f64> {
    if peak <= 0.0 {
        return None;
    }
    let second: Vec<f64> = values.windows(3).map(|w| (w[2] - w[1]) - (w[1] - w[0])).collect();
    Some(rms(&second)? / 6f64.sqrt() / peak)
}

/// Number of sign changes of the slope. A change of direction counts once the
/// curve has gone back from its last extreme by more than `noise_floor` times
/// max|v|; smaller wiggles, plateaus and round-off do not.
///
/// [`DEFAULT_NOISE_FLOOR`] suits curves of a converged analysis.
pub fn reversals(values: &[f64], noise_floor: f64) -> usize {
    let (Some(peak), Some(&first)) = (maximum(values), values.first()) else { return 0 };
    let floor = noise_floor * peak;
    let (mut low, mut high, mut direction, mut count) = (first, first, 0i8, 0);
    for &v in values {
        low = low.min(v);
        high = high.max(v);
        let turned = match direction {
            1.. if high - v > floor => -1,
            ..=-1 if v - low > floor => 1,
            0 if v - low > floor => 1,
            0 if high - v > floor => -1,
            _ => direction,
        };
        if turned != direction {
            count += usize::from(direction != 0);
            direction = turned;
            // the next turn is counted from here on
            (low, high) = (v, v);
        }
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Deterministic noise, uniform on (-1, 1): variance 1/3.
    fn noise(n: usize) -> Vec<f64> {
        let mut state = 12345u64;
        (0..n)
            .map(|_| {
                state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
                (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
            })
            .collect()
    }

    /// Requirement: the measure is the standard deviation of white noise over the peak.
    #[test]
    fn roughness_estimates_white_noise() {
        let n = 20_000;
        let smooth: Vec<f64> = (0..n).map(|i| 10.0 * (i as f64 / n as f64)).collect();
        let noisy: Vec<f64> = smooth.iter().zip(noise(n)).map(|(s, e)| s + 0.1 * e).collect();
        let expected = 0.1 / 3f64.sqrt() / 10.0;
        assert!((roughness(&noisy).unwrap() / expected - 1.0).abs() < 0.03);
        assert!((roughness_against(&noisy, &smooth).unwrap() / expected - 1.0).abs() < 0.03);
    }

    /// Property: linear bias has no roughness; too short a curve has none either.
    #[test]
    fn bias_drops_out() {
        let reference: Vec<f64> = (0..50).map(|i| f64::from(i * i)).collect();
        let biased: Vec<f64> =
            reference.iter().enumerate().map(|(i, r)| r + 4.0 + 2.0 * i as f64).collect();
        assert!(roughness_against(&biased, &reference).unwrap() < 1e-15);
        assert_eq!(roughness(&[1.0, 2.0]), None);
        assert_eq!(roughness(&[0.0; 5]), None);
    }

    #[test]
    fn counts_reversals_above_the_floor() {
        assert_eq!(reversals(&[0.0, 1.0, 2.0, 3.0], 1e-6), 0);
        assert_eq!(reversals(&[0.0, 2.0, 1.0, 3.0], 1e-6), 2);
        assert_eq!(reversals(&[0.0, -2.0, -1.0, -3.0, -3.0, -1.0], 1e-6), 3);
        // wiggles of round-off and plateaus are not counted
        assert_eq!(reversals(&[0.0, 1.0, 1.0 - 1e-12, 1.0, 1.0 + 1e-12, 2.0], 1e-6), 0);
        // a slow fall of many steps below the floor is one reversal
        let fall: Vec<f64> = (0..100).map(|i| 1.0 - 1e-3 * f64::from(i)).collect();
        let up_down: Vec<f64> = [0.0].into_iter().chain(fall).collect();
        assert_eq!(reversals(&up_down, 1e-2), 1);
        assert_eq!(reversals(&[], 1e-6), 0);
    }

    /// Property: mirrored, reversed in time or in other units, the count stays.
    #[test]
    fn reversals_are_invariant() {
        let values = noise(200);
        let count = reversals(&values, 1e-3);
        let mirrored: Vec<f64> = values.iter().map(|v| -8.0 * v).collect();
        let backwards: Vec<f64> = values.iter().rev().copied().collect();
        assert!(count > 100);
        assert_eq!(reversals(&mirrored, 1e-3), count);
        assert_eq!(reversals(&backwards, 1e-9), reversals(&values, 1e-9));
    }
}
