//! Roots of scalar functions that are bracketed by a change of sign.

use crate::error::TheoryError;

/// Root of `f` between `a` and `b`, where `f` changes sign.
///
/// Regula falsi with the Illinois weight, and bisection whenever three steps
/// have not halved the bracket: never leaves the bracket, ends at round-off.
///
/// # Errors
/// [`TheoryError::InvalidInput`] if the signs at the ends agree or `f` is not finite there.
pub(crate) fn bracketed(f: impl Fn(f64) -> f64, a: f64, b: f64) -> Result<f64, TheoryError> {
    fallible(|x| Ok(f(x)), a, b)
}

/// As [`bracketed`], for a function that may itself fail.
///
/// # Errors
/// Those of [`bracketed`], and the first error of `f`.
pub(crate) fn fallible(
    mut f: impl FnMut(f64) -> Result<f64, TheoryError>,
    a: f64,
    b: f64,
) -> Result<f64, TheoryError> {
    let (mut a, mut b) = (a, b);
    let (mut fa, mut fb) = (f(a)?, f(b)?);
    if fa == 0.0 {
        return Ok(a);
    }
    if fb == 0.0 {
        return Ok(b);
    }
    if fa.is_nan() || fb.is_nan() || (fa > 0.0) == (fb > 0.0) {
        return Err(TheoryError::InvalidInput("no change of sign between the ends of the bracket"));
    }
    let mut earlier = (b - a).abs();
    for step in 0..400 {
        let width = (b - a).abs();
        if width <= 2.0 * f64::EPSILON * a.abs().max(b.abs()) {
            break;
        }
        // every third step asks for progress, and bisects without it
        let halve = step % 3 == 2 && width > 0.5 * earlier;
        if step % 3 == 2 {
            earlier = width;
        }
        let secant = (a * fb - b * fa) / (fb - fa);
        let inside = secant > a.min(b) && secant < a.max(b);
        let x = if halve || !inside { 0.5 * (a + b) } else { secant };
        if x == a || x == b {
            break;
        }
        let fx = f(x)?;
        if fx == 0.0 {
            return Ok(x);
        }
        if (fx > 0.0) == (fb > 0.0) {
            fa *= 0.5;
        } else {
            (a, fa) = (b, fb);
        }
        (b, fb) = (x, fx);
    }
    Ok(b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_roots_to_round_off() {
        let x = bracketed(|x| x.cos() - x, 0.0, 1.0).unwrap();
        assert!((x - 0.739_085_133_215_160_6).abs() < 4e-16);
        // a steep exponential, where the plain secant creeps
        let x = bracketed(|x| (50.0 * x).exp() - 2.0, -1.0, 1.0).unwrap();
        assert!((x - 2f64.ln() / 50.0).abs() < 1e-16);
    }

    #[test]
    fn refuses_a_bracket_without_change_of_sign() {
        assert!(bracketed(|x| x * x + 1.0, -1.0, 1.0).is_err());
    }
}
