//! A cantilever rolled up by a moment at its end: an arc of a circle.

/// Tip (x/L, y/L) [-] of a cantilever under the end moment M = q EI/L:
/// (sin q/q, (1 - cos q)/q). Any q; exact for extensible and shear-flexible
/// beams too, for no force acts [Simo and Vu-Quoc 1986].
pub fn tip(q: f64) -> [f64; 2] {
    let half = 0.5 * q;
    // sin(q)/q and (1 - cos q)/q without loss at small q
    let quotient = if half == 0.0 { 1.0 } else { half.sin() / half };
    [quotient * half.cos(), quotient * half.sin()]
}

/// Tip (x/L, y/L) [-] of the regular polygon that `elements` equal two-node
/// elements of uniform curvature make of it: each chord has the length of its
/// element and the mean of the angles at its ends (derived).
pub fn polygon_tip(q: f64, elements: usize) -> [f64; 2] {
    let n = elements as f64;
    let chord = |i: usize| (q * (i as f64 + 0.5) / n).sin_cos();
    let sum = (0..elements).map(chord).fold([0.0; 2], |t, (s, c)| [t[0] + c, t[1] + s]);
    [sum[0] / n, sum[1] / n]
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// Requirement: the values of verification section 5, to nine decimals.
    #[test]
    #[allow(clippy::approx_constant)]
    fn table() {
        let table = [
            (PI / 4.0, [0.900316316, 0.372923229]),
            (PI / 2.0, [0.636619772, 0.636619772]),
            (PI, [0.0, 0.636619772]),
            (1.5 * PI, [-0.212206591, 0.212206591]),
            (2.0 * PI, [0.0, 0.0]),
            (0.0, [1.0, 0.0]),
        ];
        for (q, [x, y]) in table {
            let found = tip(q);
            assert!((found[0] - x).abs() < 6e-10 && (found[1] - y).abs() < 6e-10, "{q}: {found:?}");
        }
    }

    #[test]
    fn polygon_closes_and_converges() {
        let closed = polygon_tip(2.0 * PI, 10);
        assert!(closed[0].abs() < 1e-15 && closed[1].abs() < 1e-15);
        let error = |n| (polygon_tip(1.0, n)[0] - tip(1.0)[0]).abs();
        assert!((error(10) / error(20) - 4.0).abs() < 0.02);
    }
}
