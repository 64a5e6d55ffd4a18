//! Least squares with a handful of unknowns.
//!
//! ```text
//!   linear:     min |A x - b|              Householder's QR, columns scaled and exchanged
//!   nonlinear:  min |r(p)|                 steps of  min |J s + r|^2 + damping |D s|^2
//! ```
//!
//! Sources: Golub and Van Loan, Matrix Computations, section 5.4; [more1978] for the scales D,
//! [nielsen1999] for the damping.

/// Part of a column below which it follows from the others [1].
const DEPENDENT: f64 = 1e-10;
/// Most steps of a nonlinear search.
const MOST_STEPS: usize = 500;
/// Change of the sum of squares, relative, at which a search has arrived [1].
const ARRIVED: f64 = 1e-13;
/// Cosine of residual and columns of a minimum that rounding keeps from coming closer [1].
const UPRIGHT: f64 = 1e-6;
/// First damping and the largest [1].
const DAMPING: [f64; 2] = [1e-3, 1e14];

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

/// The x of the least |A x - b|, A by its columns; `None` where they do not determine it.
pub(super) fn linear(mut columns: Vec<Vec<f64>>, mut right: Vec<f64>) -> Option<Vec<f64>> {
    let count = columns.len();
    if right.len() < count {
        return None;
    }
    let mut scales = Vec::with_capacity(count);
    for column in &mut columns {
        let scale = norm(column);
        if !(scale > 0.0 && scale.is_finite()) {
            return None;
        }
        column.iter_mut().for_each(|entry| *entry /= scale);
        scales.push(scale);
    }
    let mut order: Vec<usize> = (0..count).collect();
    let mut diagonal = vec![0.0; count];
    for k in 0..count {
        let left = |j: &usize| norm(&columns[*j][k..]);
        let pivot = (k..count).max_by(|a, b| left(a).total_cmp(&left(b)))?;
        columns.swap(k, pivot);
        order.swap(k, pivot);
        let size = norm(&columns[k][k..]);
        if size.is_nan() || size <= DEPENDENT {
            return None;
        }
        diagonal[k] = -size.copysign(columns[k][k]);
        let mut mirror = columns[k][k..].to_vec();
        mirror[0] -= diagonal[k];
        let length = dot(&mirror, &mirror);
        let others = columns[k + 1..].iter_mut().chain(std::iter::once(&mut right));
        for other in others {
            let by = 2.0 * dot(&mirror, &other[k..]) / length;
            other[k..].iter_mut().zip(&mirror).for_each(|(entry, m)| *entry -= by * m);
        }
    }
    let mut solution = vec![0.0; count];
    for k in (0..count).rev() {
        let known: f64 = (k + 1..count).map(|j| columns[j][k] * solution[order[j]]).sum();
        solution[order[k]] = (right[k] - known) / diagonal[k];
    }
    solution.iter_mut().zip(&scales).for_each(|(x, scale)| *x /= scale);
    solution.iter().all(|x| x.is_finite()).then_some(solution)
}

/// Residuals of a trial and their derivatives, a column a parameter.
pub(super) type Linearised = (Vec<f64>, Vec<Vec<f64>>);

/// Parameters of the least sum of squares near a start (Levenberg, Marquardt), with that sum;
/// `None` where the search does not arrive.
pub(super) fn nonlinear(
    start: Vec<f64>,
    model: impl Fn(&[f64]) -> Linearised,
) -> Option<(Vec<f64>, f64)> {
    let mut at = start;
    let (mut residual, mut columns) = model(&at);
    let mut sum = dot(&residual, &residual);
    let mut scales = vec![0.0_f64; at.len()];
    let [mut damping, most] = DAMPING;
    let mut growth = 2.0;
    for _ in 0..MOST_STEPS {
        if !sum.is_finite() {
            return None;
        }
        if sum <= f64::EPSILON * f64::EPSILON * residual.len() as f64 {
            return Some((at, sum));
        }
        scales.iter_mut().zip(&columns).for_each(|(scale, own)| *scale = scale.max(norm(own)));
        let step = damped(&columns, &residual, &scales, damping)?;
        let trial: Vec<f64> = at.iter().zip(&step).map(|(p, s)| p + s).collect();
        let (next, next_columns) = model(&trial);
        let lower = dot(&next, &next);
        let foretold = sum - rest(&columns, &residual, &step);
        if lower.is_finite() && lower <= sum {
            let arrived = foretold <= ARRIVED * sum && sum - lower <= ARRIVED * sum;
            let gain = ((sum - lower) / foretold).clamp(0.0, 1.0);
            damping *= (1.0_f64 / 3.0).max(1.0 - (2.0 * gain - 1.0).powi(3));
            growth = 2.0;
            (at, residual, columns, sum) = (trial, next, next_columns, lower);
            if arrived {
                return Some((at, sum));
            }
        } else {
            damping *= growth;
            growth *= 2.0;
        }
        if damping > most {
            let upright = is_upright(&columns, &residual);
            return upright.then_some((at, sum));
        }
    }
    None
}

/// The step that a damping leaves.
fn damped(
    columns: &[Vec<f64>],
    residual: &[f64],
    scales: &[f64],
    damping: f64,
) -> Option<Vec<f64>> {
    let count = columns.len();
    let root = damping.sqrt();
    let below = |place: usize| (0..count).map(move |row| if row == place { root } else { 0.0 });
    let scaled = columns.iter().zip(scales).enumerate().map(|(place, (column, scale))| {
        column.iter().copied().chain(below(place).map(|entry| entry * scale)).collect()
    });
    let right = residual.iter().map(|r| -r).chain(std::iter::repeat_n(0.0, count)).collect();
    linear(scaled.collect(), right)
}

/// Sum of squares that the linearised model foretells behind a step.
fn rest(columns: &[Vec<f64>], residual: &[f64], step: &[f64]) -> f64 {
    let mut left = residual.to_vec();
    for (column, by) in columns.iter().zip(step) {
        left.iter_mut().zip(column).for_each(|(r, entry)| *r += by * entry);
    }
    dot(&left, &left)
}

/// Whether no column has a part along the residual.
fn is_upright(columns: &[Vec<f64>], residual: &[f64]) -> bool {
    let size = norm(residual);
    columns.iter().all(|own| dot(own, residual).abs() <= UPRIGHT * size * norm(own))
}
