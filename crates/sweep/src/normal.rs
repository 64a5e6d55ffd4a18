//! The normal distribution.

/// Share of a standard normal distribution below `z` [1].
pub(crate) fn below(z: f64) -> f64 {
    0.5 * libm::erfc(-z / std::f64::consts::SQRT_2)
}

/// The place below which a standard normal distribution has the share `u`, between 0 and 1.
///
/// Newton's method on ln below(z) = ln u, which is concave: from the left it comes nearer without
/// passing by. Below half of the distribution exp(-z^2/2)/2 is larger than below(z), so that
/// z = -sqrt(-2 ln u) is on the left.
pub(crate) fn quantile(u: f64) -> f64 {
    const MOST: usize = 60;
    if u > 0.5 {
        return -quantile(1.0 - u);
    }
    let mut z = -(-2.0 * u.ln()).sqrt();
    for _ in 0..MOST {
        let density = (-0.5 * z * z).exp() / (2.0 * std::f64::consts::PI).sqrt();
        let share = below(z);
        let step = (u / share).ln() * share / density;
        z += step;
        if step.abs() <= 4.0 * f64::EPSILON * z.abs().max(1.0) {
            break;
        }
    }
    z
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Source: tables of the normal distribution, 15 digits (Abramowitz and Stegun 26.2).
    #[test]
    fn known_quantiles() {
        let known = [
            (0.5, 0.0),
            (0.975, 1.959_963_984_540_054),
            (0.99, 2.326_347_874_040_841),
            (0.025, -1.959_963_984_540_054),
            (1e-9, -5.997_807_015_007_687),
        ];
        for (u, z) in known {
            assert!((quantile(u) - z).abs() < 1e-12, "{u}: {}", quantile(u));
        }
    }

    #[test]
    fn back_and_forth() {
        for k in 1..200 {
            let u = f64::from(k) / 200.0;
            assert!((below(quantile(u)) / u - 1.0).abs() < 1e-13);
        }
        for u in [1e-300, 1e-100, 1e-20] {
            assert!((below(quantile(u)) / u - 1.0).abs() < 1e-10);
        }
    }
}
