//! Gauss-Legendre quadrature and the implicit Runge-Kutta method built on it.
//!
//! The method with s stages has order 2 s, is symplectic and A-stable; its
//! coefficients are computed here, not copied.

use crate::error::TheoryError;

/// Nodes in (0, 1) and weights of the Gauss-Legendre rule with `n` points.
pub(crate) fn rule(n: usize) -> Vec<(f64, f64)> {
    (0..n).map(|i| node(i, n)).collect()
}

fn node(i: usize, n: usize) -> (f64, f64) {
    let mut x = -(std::f64::consts::PI * (i as f64 + 0.75) / (n as f64 + 0.5)).cos();
    for _ in 0..12 {
        let (p, dp) = legendre(n, x);
        x -= p / dp;
    }
    let (_, dp) = legendre(n, x);
    (0.5 * (1.0 + x), 1.0 / ((1.0 - x) * (1.0 + x) * dp * dp))
}

/// Legendre polynomial of degree n and its derivative.
fn legendre(n: usize, x: f64) -> (f64, f64) {
    let (mut before, mut p) = (1.0, x);
    for k in 2..=n {
        let k = k as f64;
        (before, p) = (p, ((2.0 * k - 1.0) * x * p - (k - 1.0) * before) / k);
    }
    (p, n as f64 * (x * p - before) / (x * x - 1.0))
}

/// Integral of `f` over (a, b) by a Gauss-Legendre rule.
pub(crate) fn integrate(rule: &[(f64, f64)], a: f64, b: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    rule.iter().map(|(x, w)| w * (b - a) * f(a + (b - a) * x)).sum()
}

/// Gauss collocation for y' = f(y) in `N` components.
pub(crate) struct Collocation {
    /// Stage matrix a_ij and weights b_j.
    stages: Vec<Vec<f64>>,
    weights: Vec<f64>,
}

impl Collocation {
    /// The method with `n` stages, order 2 n.
    pub fn new(n: usize) -> Self {
        let points = rule(n);
        let nodes: Vec<f64> = points.iter().map(|p| p.0).collect();
        // a_ij = integral of the j-th Lagrange polynomial from 0 to c_i, exact by the same rule
        let entry =
            |i: usize, j: usize| integrate(&points, 0.0, nodes[i], |x| lagrange(&nodes, j, x));
        Self {
            stages: (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect(),
            weights: points.iter().map(|p| p.1).collect(),
        }
    }

    /// Advances `y` over the interval `span` (negative: backwards) in `steps` equal steps.
    ///
    /// # Errors
    /// [`TheoryError::NotConverged`] if the stage equations do not settle.
    pub fn advance<const N: usize>(
        &self,
        mut y: [f64; N],
        span: f64,
        steps: usize,
        f: impl Fn(&[f64; N]) -> [f64; N],
    ) -> Result<[f64; N], TheoryError> {
        let h = span / steps as f64;
        for _ in 0..steps {
            let slopes = self.stage_slopes(&y, h, &f)?;
            y = combine(&y, h, &self.weights, &slopes);
        }
        Ok(y)
    }

    /// Stage slopes by fixed-point iteration down to round-off.
    fn stage_slopes<const N: usize>(
        &self,
        y: &[f64; N],
        h: f64,
        f: impl Fn(&[f64; N]) -> [f64; N],
    ) -> Result<Vec<[f64; N]>, TheoryError> {
        let mut slopes = vec![f(y); self.weights.len()];
        let mut change = f64::INFINITY;
        for sweep in 0..200 {
            let earlier = change;
            change = 0.0;
            for (i, row) in self.stages.iter().enumerate() {
                let new = f(&combine(y, h, row, &slopes));
                change = change.max(relative_change(&new, &slopes[i]));
                slopes[i] = new;
            }
            // settled: at round-off, or no longer falling a little above it, where
            // differences of nearly equal lengths carry the round-off of the lengths
            if change < 4e-16 || (sweep > 2 && change < 1e-11 && change >= 0.5 * earlier) {
                return Ok(slopes);
            }
            if !change.is_finite() {
                break;
            }
        }
        Err(TheoryError::NotConverged { correction: change })
    }
}

fn combine<const N: usize>(y: &[f64; N], h: f64, weights: &[f64], slopes: &[[f64; N]]) -> [f64; N] {
    std::array::from_fn(|k| {
        y[k] + h * weights.iter().zip(slopes).map(|(w, s)| w * s[k]).sum::<f64>()
    })
}

fn relative_change<const N: usize>(new: &[f64; N], old: &[f64; N]) -> f64 {
    let size = new.iter().fold(1e-300, |m: f64, v| m.max(v.abs()));
    let mut change = 0.0f64;
    for (a, b) in new.iter().zip(old) {
        let difference = (a - b).abs() / size;
        // a NaN must not be lost in the maximum
        change = if difference.is_nan() { f64::INFINITY } else { change.max(difference) };
    }
    change
}

fn lagrange(nodes: &[f64], j: usize, x: f64) -> f64 {
    let others = nodes.iter().enumerate().filter(|(k, _)| *k != j);
    others.map(|(_, c)| (x - c) / (nodes[j] - c)).product()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rule_is_exact_for_polynomials() {
        for n in [1, 2, 5, 12, 40] {
            let points = rule(n);
            let degree = 2 * n - 1;
            let value = integrate(&points, 0.0, 1.0, |x| x.powi(degree as i32));
            assert!((value * (degree as f64 + 1.0) - 1.0).abs() < 1e-13, "{n}");
        }
    }

    /// Order 2 s: halving the step of the three-stage method divides the error by about 64.
    #[test]
    fn order_of_the_method() {
        let method = Collocation::new(3);
        let pendulum = |y: &[f64; 2]| [y[1], -y[0].sin()];
        let fine = Collocation::new(8).advance([1.0, 0.0], 4.0, 40, pendulum).unwrap();
        let error =
            |steps| (method.advance([1.0, 0.0], 4.0, steps, pendulum).unwrap()[0] - fine[0]).abs();
        let ratio = error(8) / error(16);
        assert!((50.0..80.0).contains(&ratio), "{ratio}");
    }
}
