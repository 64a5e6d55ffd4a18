//! Roughness and reversals: noise seen in the shape of a curve.

use crate::difference::{maximum, rms};
use crate::paired::paired;
use std::ops::Range;

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

/// Roughness [-] of the strokes of a curve: as [`roughness`], but second
/// differences are taken within strokes only, and so are fourth ones, in which
/// whatever is smooth all but vanishes: sqrt(mean(d4(v)^2)/70)/max|v|, for
/// white noise the same. `None` where neither exists.
///
/// A curve that bends sharply has large second and small fourth differences; noise has
/// both.
pub fn stroke_roughness(values: &[f64], strokes: &[Range<usize>]) -> Option<[f64; 2]> {
    let peak = maximum(values).filter(|&peak| peak > 0.0)?;
    let mut sums = [0.0; 2];
    let mut counts = [0usize; 2];
    for stroke in strokes.iter().filter_map(|stroke| values.get(stroke.clone())) {
        for w in stroke.windows(3) {
            sums[0] += ((w[2] - w[1]) - (w[1] - w[0])).powi(2);
            counts[0] += 1;
        }
        for w in stroke.windows(5) {
            sums[1] +=
                ((w[4] - w[3]) - 3.0 * (w[3] - w[2]) + 3.0 * (w[2] - w[1]) - (w[1] - w[0])).powi(2);
            counts[1] += 1;
        }
    }
    let rough = |k: usize, variance: f64| match counts[k] {
        0 => 0.0,
        count => (sums[k] / count as f64 / variance).sqrt() / peak,
    };
    (counts[0] > 0).then(|| [rough(0, 6.0), rough(1, 70.0)])
}

/// Reversals within the strokes of a curve, as [`reversals`] counts them, the
/// floor relative to the peak of the whole curve.
pub fn stroke_reversals(values: &[f64], strokes: &[Range<usize>], noise_floor: f64) -> usize {
    let Some(peak) = maximum(values) else { return 0 };
    let parts = strokes.iter().filter_map(|stroke| values.get(stroke.clone()));
    parts.map(|part| turns(part, noise_floor * peak)).sum()
}

/// The strokes of a motion: stretches over which it does not turn back.
/// `motion` has a value for each increment.
pub fn strokes(motion: &[f64]) -> Vec<Range<usize>> {
    let mut found: Vec<Range<usize>> = Vec::new();
    let (mut before, mut way, mut from) = (motion.first().copied().unwrap_or(0.0), 0.0, 0);
    for (place, &now) in motion.iter().enumerate() {
        let moved = now - before;
        if moved * way < 0.0 {
            found.push(from..place);
            from = place;
        }
        if moved != 0.0 {
            way = moved.signum();
        }
        before = now;
    }
    if from < motion.len() {
        found.push(from..motion.len());
    }
    found
}

/// The pushes within the strokes of a curve: stretches over which the reaction
/// keeps its sign. A snap drops off an edge and pulls instead of pushing: that
/// reversal is physical, and no push holds it. Stretches shorter than
/// `shortest` values, such as noise about zero has, stay with what is before.
///
/// ```text
///   RF | .-.        .-.
///      |/   `\     /   `\    two teeth: four pushes
///      +-----|---/-----|---> increments
///            `\/       `\/
/// ```
pub fn pushes(values: &[f64], strokes: &[Range<usize>], shortest: usize) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    for stroke in strokes {
        let mut from = stroke.start;
        let (mut sign, mut since, mut lasting) = (0.0, stroke.start, 0.0);
        for place in stroke.clone() {
            let now = values.get(place).copied().unwrap_or(0.0);
            if now * sign < 0.0 || sign == 0.0 {
                since = place;
            }
            if now != 0.0 {
                sign = now.signum();
            }
            if sign != 0.0 && place + 1 - since == shortest {
                // the sign lasts, and it is another one than that of the push
                if sign * lasting < 0.0 {
                    found.push(from..since);
                    from = since;
                }
                lasting = sign;
            }
        }
        if from < stroke.end {
            found.push(from..stroke.end);
        }
    }
    found
}

/// Number of sign changes of the slope. A change of direction counts once the
/// curve has gone back from its last extreme by more than `noise_floor` times
/// max|v|; smaller wiggles, plateaus and round-off do not.
///
/// [`DEFAULT_NOISE_FLOOR`] suits curves of a converged analysis.
pub fn reversals(values: &[f64], noise_floor: f64) -> usize {
    maximum(values).map_or(0, |peak| turns(values, noise_floor * peak))
}

/// Sign changes of the slope beyond wiggles of the size `floor`.
fn turns(values: &[f64], floor: f64) -> usize {
    let Some(&first) = values.first() else { return 0 };
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

    /// Requirement: a curve of known noise has the roughness of its closed form. On the ramp i
    /// stands a zigzag of amplitude a: second differences are 4 a, fourth ones 16 a, and the
    /// slope turns at every point but the ends where a > 1/2.
    #[test]
    fn a_zigzag_has_its_closed_form() {
        let (n, a) = (51usize, 0.75);
        let zigzag: Vec<f64> = (0..n).map(|i| i as f64 + if i % 2 == 0 { a } else { -a }).collect();
        let peak = (n - 1) as f64 + a;
        let whole = std::slice::from_ref(&(0..51));
        let [second, fourth] = stroke_roughness(&zigzag, whole).unwrap();
        assert!((second - 4.0 * a / 6f64.sqrt() / peak).abs() < 1e-15);
        assert!((fourth - 16.0 * a / 70f64.sqrt() / peak).abs() < 1e-15);
        assert!((roughness(&zigzag).unwrap() - second).abs() < 1e-15);
        assert_eq!(stroke_reversals(&zigzag, whole, 1e-6), n - 2);
        assert_eq!(reversals(&zigzag, 1e-6), n - 2);
    }

    /// Requirement: a sine of 20 points is smooth: its fourth differences are those of h^4 with
    /// h = 2 pi/20, 1/h^2 times smaller than the second ones (Taylor; 5 % for h^2/6).
    #[test]
    fn a_coarse_sine_is_not_noise() {
        let h = std::f64::consts::TAU / 20.0;
        let sine: Vec<f64> = (0..200).map(|i| (h * f64::from(i)).sin()).collect();
        let [second, fourth] = stroke_roughness(&sine, std::slice::from_ref(&(0..200))).unwrap();
        let mean = std::f64::consts::FRAC_1_SQRT_2;
        assert!((second / (mean * h * h / 6f64.sqrt()) - 1.0).abs() < 0.05);
        assert!((fourth / (mean * h.powi(4) / 70f64.sqrt()) - 1.0).abs() < 0.05);
    }

    /// Requirement: pushing and pulling are two strokes; the jump of friction between them is no
    /// noise, and neither is their turning.
    #[test]
    fn strokes_end_where_the_motion_turns() {
        let motion = [-1.0, -2.0, -2.0, -3.0, -2.0, -1.0, 0.0, 0.0];
        assert_eq!(strokes(&motion), [0..4, 4..8]);
        let force = [-1.0, -2.0, -3.0, -4.0, 5.0, 4.0, 3.0, 2.0];
        assert_eq!(stroke_reversals(&force, &strokes(&motion), 1e-6), 0);
        assert_eq!(stroke_roughness(&force, &strokes(&motion)).unwrap(), [0.0; 2]);
        assert!(strokes(&[]).is_empty());
        assert_eq!(stroke_roughness(&[1.0, 2.0], std::slice::from_ref(&(0..2))), None);
    }

    /// Requirement: each tooth of a ratchet is a push and its fall another one; noise about zero
    /// is one push, for its signs do not last.
    #[test]
    fn pushes_end_where_the_reaction_turns_for_good() {
        let tooth = [1.0, 2.0, 3.0, 2.5, 2.0, -1.0, -2.0, -1.5, -1.0, -0.5];
        let ratchet: Vec<f64> = tooth.iter().cycle().take(40).copied().collect();
        let found = pushes(&ratchet, std::slice::from_ref(&(0..40)), 5);
        assert_eq!(found, [0..5, 5..10, 10..15, 15..20, 20..25, 25..30, 30..35, 35..40]);
        assert!(found.iter().all(|push| reversals(&ratchet[push.clone()], 1e-6) <= 1));
        assert_eq!(
            pushes(&ratchet, std::slice::from_ref(&(0..40)), 6),
            std::slice::from_ref(&(0..40))
        );
        let about_zero: Vec<f64> = (0..40).map(|k| if k % 2 == 0 { 1.0 } else { -1.0 }).collect();
        assert_eq!(pushes(&about_zero, &[0..20, 20..40], 5), [0..20, 20..40]);
        // a zero keeps the sign that was, and so does one value of the other sign
        let push = [0.0, 0.0, -1.0, 0.0, -2.0, -3.0, 0.1, -4.0, -5.0];
        assert_eq!(pushes(&push, std::slice::from_ref(&(0..9)), 2), std::slice::from_ref(&(0..9)));
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
