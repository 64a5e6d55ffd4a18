//! Newton iteration for a few equations, Jacobian by central differences.

use crate::error::TheoryError;

/// Root of `f` near `start`. Unknowns and equations are to be scaled by the
/// caller so that changes of order one matter.
///
/// Steps are shortened until the residual falls; the iteration ends when the
/// correction is at round-off, or when it has stopped falling below `1e-10`.
///
/// # Errors
/// [`TheoryError::NotConverged`], or the first error of `f` at `start`.
pub(crate) fn solve<const N: usize>(
    f: impl Fn(&[f64; N]) -> Result<[f64; N], TheoryError>,
    start: [f64; N],
) -> Result<[f64; N], TheoryError> {
    let mut z = start;
    let mut residual = f(&z)?;
    let mut last = f64::INFINITY;
    for _ in 0..60 {
        let jacobian = differences(&f, &z)?;
        let step = eliminate(jacobian, residual)?;
        let correction = norm(&step);
        if correction < 1e-15 {
            return Ok(z);
        }
        let Some((new, value)) = shortened(&f, &z, &step, norm(&residual)) else {
            // no decrease possible: round-off if the correction is already tiny
            return if correction < 1e-10 {
                Ok(z)
            } else {
                Err(TheoryError::NotConverged { correction })
            };
        };
        (z, residual) = (new, value);
        if correction < 1e-10 && correction >= 0.2 * last {
            return Ok(z);
        }
        last = correction;
    }
    Err(TheoryError::NotConverged { correction: last })
}

type Point<const N: usize> = ([f64; N], [f64; N]);

fn shortened<const N: usize>(
    f: &impl Fn(&[f64; N]) -> Result<[f64; N], TheoryError>,
    z: &[f64; N],
    step: &[f64; N],
    size: f64,
) -> Option<Point<N>> {
    let mut fraction = 1.0;
    for _ in 0..30 {
        let new = std::array::from_fn(|i| z[i] - fraction * step[i]);
        if let Ok(value) = f(&new)
            && norm(&value) < size
        {
            return Some((new, value));
        }
        fraction *= 0.5;
    }
    None
}

fn differences<const N: usize>(
    f: &impl Fn(&[f64; N]) -> Result<[f64; N], TheoryError>,
    z: &[f64; N],
) -> Result<[[f64; N]; N], TheoryError> {
    let mut jacobian = [[0.0; N]; N];
    for j in 0..N {
        let d = 2e-6 * z[j].abs().max(1e-2);
        let (mut below, mut above) = (*z, *z);
        below[j] -= d;
        above[j] += d;
        let (a, b) = (f(&below)?, f(&above)?);
        for i in 0..N {
            jacobian[i][j] = (b[i] - a[i]) / (above[j] - below[j]);
        }
    }
    Ok(jacobian)
}

/// Gaussian elimination with row pivoting.
fn eliminate<const N: usize>(
    mut a: [[f64; N]; N],
    mut b: [f64; N],
) -> Result<[f64; N], TheoryError> {
    for k in 0..N {
        let pivot = (k..N).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs())).unwrap_or(k);
        a.swap(k, pivot);
        b.swap(k, pivot);
        if !(a[k][k].abs() > 0.0 && a[k][k].is_finite()) {
            return Err(TheoryError::NotConverged { correction: f64::INFINITY });
        }
        for i in k + 1..N {
            let factor = a[i][k] / a[k][k];
            let row = a[k];
            for (entry, above) in a[i].iter_mut().zip(row) {
                *entry -= factor * above;
            }
            b[i] -= factor * b[k];
        }
    }
    for k in (0..N).rev() {
        let known: f64 = (k + 1..N).map(|j| a[k][j] * b[j]).sum();
        b[k] = (b[k] - known) / a[k][k];
    }
    Ok(b)
}

fn norm<const N: usize>(v: &[f64; N]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_a_small_system() {
        let z =
            solve(|z: &[f64; 2]| Ok([z[0] * z[0] + z[1] * z[1] - 4.0, z[0] - z[1]]), [3.0, 0.5])
                .unwrap();
        assert!((z[0] - 2f64.sqrt()).abs() < 1e-15 && (z[1] - 2f64.sqrt()).abs() < 1e-15);
    }

    #[test]
    fn says_when_there_is_no_root() {
        assert!(solve(|z: &[f64; 1]| Ok([z[0] * z[0] + 1.0]), [1.0]).is_err());
    }
}
