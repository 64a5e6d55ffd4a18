//! A cantilever under a uniform load that stays across it.
//!
//! Balance of a piece in its own axes, s from the clamp, inextensible and stiff in shear, does not
//! ask how it stands: N' = k V, V' = -k N - q, M' = -V, k = M/EI. All three vanish at the free end,
//! so that they are integrated from there; the shape follows with theta' = k, and is turned until the
//! clamp lies level (derived).

use super::bisshopp_drucker::Tip;

/// Steps of the integration: the fourth order leaves about 1e-12 of the length.
const STEPS: usize = 4000;

/// The tip under q L^3/EI, for the length 1.
pub fn tip(load: f64) -> Tip {
    let h = 1.0 / STEPS as f64;
    let mut state = [0.0; 6];
    for _ in 0..STEPS {
        let moved = |by: f64, slope: &[f64; 6]| std::array::from_fn(|i| state[i] + by * slope[i]);
        let first = slopes(load, &state);
        let second = slopes(load, &moved(0.5 * h, &first));
        let third = slopes(load, &moved(0.5 * h, &second));
        let last = slopes(load, &moved(h, &third));
        for i in 0..6 {
            state[i] += h / 6.0 * (first[i] + 2.0 * second[i] + 2.0 * third[i] + last[i]);
        }
    }
    let [_, _, _, angle, x, y] = state;
    let (sin, cos) = angle.sin_cos();
    let (along, across) = (-cos * x - sin * y, sin * x - cos * y);
    Tip { angle: -angle, deflection: across, shortening: 1.0 - along }
}

/// Of N, V, M, theta, x, y, towards the clamp.
fn slopes(load: f64, &[n, v, m, theta, ..]: &[f64; 6]) -> [f64; 6] {
    [-m * v, m * n + load, v, -m, -theta.cos(), -theta.sin()]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: a small load bends as a clamped beam does, by q/8 and q/6.
    #[test]
    fn small_loads_bend_as_beams_do() {
        let small = tip(1e-4);
        assert!((small.deflection / 1e-4 - 0.125).abs() < 1e-8);
        assert!((small.angle / 1e-4 - 1.0 / 6.0).abs() < 1e-8);
    }

    /// Requirement: q L^3/EI = 3.6 turns the tip by 0.594305 and lifts it by 0.424999 (an integration of
    /// its own, in other steps and another language).
    #[test]
    fn a_large_load_turns_the_tip() {
        let large = tip(3.6);
        assert!((large.angle - 0.594_305).abs() < 1e-6);
        assert!((large.deflection - 0.424_999).abs() < 1e-6);
        assert!((1.0 - large.shortening - 0.889_494).abs() < 1e-6);
    }
}
