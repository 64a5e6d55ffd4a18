//! Iterative solution of systems that are known only by their action on vectors.
//!
//! ```text
//!   operator:        v  ->  A v            (a product with factored stiffness, say)
//!   preconditioner:  v  ->  M v, M ~ 1/A   (may be another one in every iteration)
//!
//!   A [z1 .. zk] = [v1 .. vk+1] H,  z = M v,   x = x0 + [z1 .. zk] y,  |beta e1 - H y| smallest
//! ```
//!
//! Flexible GMRES without restarts: [saad1986], [saad1993]; the basis is made
//! orthogonal by the modified Gram-Schmidt process and once more where cancellation was strong
//! [daniel1976].

use crate::kernel::dot;

/// Share of its length below which a vector made orthogonal has lost digits and is treated again.
const CANCELLED: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// When an iteration ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stop {
    /// Residual to be reached, relative to the norm of the right-hand side.
    pub tolerance: f64,
    /// Largest number of iterations.
    pub iterations: usize,
}

/// How an iteration ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// The residual is as small as asked for.
    Converged,
    /// The largest number of iterations was made.
    Limit,
    /// The space of all iterates is exhausted and holds no solution: the operator is singular to
    /// working precision. The best solution found is given.
    Exhausted,
    /// The operator, the preconditioner or the right-hand side gave an infinite value or one that
    /// is not a number. The solution before that is given.
    NotFinite,
}

/// What an iteration achieved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// How it ended.
    pub ending: Ending,
    /// Number of iterations: each is one product with the operator and one with the preconditioner.
    /// A start that is not zero costs one product more.
    pub iterations: usize,
    /// Norm of the residual relative to that of the right-hand side, as the recurrence of the
    /// iteration gives it; it agrees with the true one to rounding times the condition of the basis.
    pub residual: f64,
}

impl Progress {
    /// Whether the residual is as small as asked for.
    pub fn converged(&self) -> bool {
        self.ending == Ending::Converged
    }
}

/// Memory of an iteration. It grows with the iterations made and is kept: a further solution that
/// needs no more of them allocates nothing.
#[derive(Clone, Debug, Default)]
pub struct Workspace {
    /// Orthonormal vectors v, one after another.
    basis: Vec<f64>,
    /// Preconditioned vectors z, one after another.
    direction: Vec<f64>,
    /// Upper triangle of the rotated Hessenberg matrix; column k holds k + 1 entries.
    triangle: Vec<f64>,
    /// Cosines and sines of the rotations.
    rotation: Vec<(f64, f64)>,
    /// Rotated right-hand side of the small least-squares problem, then its solution.
    small: Vec<f64>,
    /// Column of the Hessenberg matrix at work.
    column: Vec<f64>,
}

impl Workspace {
    /// Memory for `iterations` iterations with vectors of length `n`, so that even the first
    /// solution allocates nothing.
    pub fn for_iterations(n: usize, iterations: usize) -> Self {
        let mut workspace = Self::default();
        workspace.make_room(n, iterations);
        workspace
    }

    fn make_room(&mut self, n: usize, iterations: usize) {
        let grow = |array: &mut Vec<f64>, length: usize| {
            if array.len() < length {
                array.resize(length, 0.0);
            }
        };
        grow(&mut self.basis, n * (iterations + 1));
        grow(&mut self.direction, n * iterations);
        grow(&mut self.triangle, iterations * (iterations + 1) / 2);
        grow(&mut self.small, iterations + 1);
        grow(&mut self.column, iterations + 1);
        if self.rotation.len() < iterations {
            self.rotation.resize(iterations, (1.0, 0.0));
        }
    }

    /// Makes vector `k + 1` of the basis orthogonal to those before and normal; the coefficients
    /// are left in `column`. Returns the length it had left, none where a value is not finite.
    fn orthogonalise(&mut self, n: usize, k: usize) -> Option<f64> {
        let (before, rest) = self.basis.split_at_mut(n * (k + 1));
        let w = &mut rest[..n];
        self.column[..=k].fill(0.0);
        let original = norm(w);
        let mut length = original;
        for pass in 0..2 {
            let entering = length;
            for (v, h) in before.chunks_exact(n).zip(&mut self.column) {
                let share = dot(v, w);
                *h += share;
                w.iter_mut().zip(v).for_each(|(w_i, v_i)| *w_i -= share * v_i);
            }
            length = norm(w);
            if pass == 0 && length > CANCELLED * entering {
                break;
            }
        }
        if !length.is_finite() {
            return None;
        }
        // What is left is rounding of the subtraction.
        if length <= original * f64::EPSILON {
            length = 0.0;
        }
        let factor = if length > 0.0 { 1.0 / length } else { 0.0 };
        w.iter_mut().for_each(|w_i| *w_i *= factor);
        Some(length)
    }

    /// Rotates column k of the Hessenberg matrix, whose entry below the diagonal is `below`, into
    /// the triangle. Returns the new diagonal entry and by what the residual shrinks.
    fn rotate(&mut self, k: usize, below: f64) -> (f64, f64) {
        for (i, &(cosine, sine)) in self.rotation[..k].iter().enumerate() {
            let (upper, lower) = (self.column[i], self.column[i + 1]);
            self.column[i] = cosine * upper + sine * lower;
            self.column[i + 1] = cosine * lower - sine * upper;
        }
        let diagonal = self.column[k].hypot(below);
        let (cosine, sine) =
            if diagonal > 0.0 { (self.column[k] / diagonal, below / diagonal) } else { (1.0, 0.0) };
        self.rotation[k] = (cosine, sine);
        self.column[k] = diagonal;
        let start = k * (k + 1) / 2;
        self.triangle[start..=start + k].copy_from_slice(&self.column[..=k]);
        self.small[k + 1] = -sine * self.small[k];
        self.small[k] *= cosine;
        (diagonal, sine.abs())
    }

    /// Adds the combination of the first `count` directions that makes the residual smallest.
    fn add_solution(&mut self, count: usize, x: &mut [f64]) {
        for k in (0..count).rev() {
            let column = &self.triangle[k * (k + 1) / 2..][..=k];
            let y = self.small[k] / column[k];
            self.small[k] = y;
            self.small[..k].iter_mut().zip(column).for_each(|(s, r)| *s -= r * y);
        }
        for (z, y) in self.direction.chunks_exact(x.len().max(1)).zip(&self.small[..count]) {
            x.iter_mut().zip(z).for_each(|(x_i, z_i)| *x_i += y * z_i);
        }
    }
}

/// Solves A x = b from the start given in `x`, with the residual made smallest in each iteration.
/// `operator(v, w)` writes w = A v, `precondition(v, z)` writes an approximate solution of A z = v
/// and may be another one each time. `x` and `b` have equal length; the tolerance is relative to
/// the norm of `b`.
///
/// A breakdown is no error: the ending tells it, and `x` holds the best solution found.
pub fn gmres(
    mut operator: impl FnMut(&[f64], &mut [f64]),
    mut precondition: impl FnMut(&[f64], &mut [f64]),
    b: &[f64],
    x: &mut [f64],
    stop: Stop,
    workspace: &mut Workspace,
) -> Progress {
    let n = x.len();
    let size = norm(b);
    workspace.make_room(n, 0);
    let first = &mut workspace.basis[..n];
    if x.iter().any(|&x_i| x_i != 0.0) {
        operator(x, first);
        first.iter_mut().zip(b).for_each(|(r, b_i)| *r = b_i - *r);
    } else {
        first.copy_from_slice(b);
    }
    let beta = norm(first);
    if size == 0.0 || !size.is_finite() || !beta.is_finite() {
        if size == 0.0 {
            x.fill(0.0);
        }
        let ending = if size == 0.0 { Ending::Converged } else { Ending::NotFinite };
        return Progress {
            ending,
            iterations: 0,
            residual: if size == 0.0 { 0.0 } else { f64::NAN },
        };
    }
    let scale = if beta > 0.0 { 1.0 / beta } else { 0.0 };
    first.iter_mut().for_each(|r| *r *= scale);
    workspace.small[0] = beta / size;
    let progress = iterate(&mut operator, &mut precondition, n, stop, workspace);
    let count = progress.1;
    workspace.small[..count].iter_mut().for_each(|y| *y *= size);
    workspace.add_solution(count, x);
    progress.0
}

/// Builds the basis until an ending; the relative residual at the start is in `small[0]`. Returns
/// with the progress the number of directions that the solution uses.
fn iterate(
    operator: &mut impl FnMut(&[f64], &mut [f64]),
    precondition: &mut impl FnMut(&[f64], &mut [f64]),
    n: usize,
    stop: Stop,
    workspace: &mut Workspace,
) -> (Progress, usize) {
    let mut residual = workspace.small[0];
    let end =
        |ending, iterations, residual, used| (Progress { ending, iterations, residual }, used);
    for k in 0..stop.iterations {
        if residual <= stop.tolerance {
            return end(Ending::Converged, k, residual, k);
        }
        workspace.make_room(n, k + 1);
        let z = &mut workspace.direction[n * k..n * (k + 1)];
        precondition(&workspace.basis[n * k..n * (k + 1)], z);
        operator(z, &mut workspace.basis[n * (k + 1)..n * (k + 2)]);
        let Some(below) = workspace.orthogonalise(n, k) else {
            return end(Ending::NotFinite, k + 1, residual, k);
        };
        let largest = workspace.column[..=k].iter().fold(below, |m, h| m.max(h.abs()));
        let (diagonal, shrink) = workspace.rotate(k, below);
        if diagonal.is_nan() || diagonal <= largest * f64::EPSILON {
            return end(Ending::Exhausted, k + 1, residual, k);
        }
        residual *= shrink;
        if below == 0.0 && residual > stop.tolerance {
            return end(Ending::Exhausted, k + 1, residual, k + 1);
        }
    }
    let ending = if residual <= stop.tolerance { Ending::Converged } else { Ending::Limit };
    end(ending, stop.iterations, residual, stop.iterations)
}

/// Euclidean norm, whatever the exponents of the components.
fn norm(v: &[f64]) -> f64 {
    let largest =
        v.iter().fold(0.0_f64, |m, v_i| if v_i.is_nan() { f64::NAN } else { v_i.abs().max(m) });
    if !(largest > 0.0 && largest.is_finite()) {
        return if v.iter().any(|v_i| v_i.is_nan()) { f64::NAN } else { largest };
    }
    v.iter().map(|v_i| (v_i / largest).powi(2)).sum::<f64>().sqrt() * largest
}

#[cfg(test)]
mod tests {
    use super::*;

    const STOP: Stop = Stop { tolerance: 1e-12, iterations: 200 };

    fn copy(v: &[f64], z: &mut [f64]) {
        z.copy_from_slice(v);
    }

    /// Unsymmetric tridiagonal product.
    fn tridiagonal(v: &[f64], w: &mut [f64], (below, middle, above): (f64, f64, f64)) {
        for i in 0..v.len() {
            let left = if i > 0 { v[i - 1] } else { 0.0 };
            let right = v.get(i + 1).copied().unwrap_or(0.0);
            w[i] = below * left + middle * v[i] + above * right;
        }
    }

    fn relative_residual(operator: impl Fn(&[f64], &mut [f64]), x: &[f64], b: &[f64]) -> f64 {
        let mut r = vec![0.0; b.len()];
        operator(x, &mut r);
        r.iter_mut().zip(b).for_each(|(r, b)| *r = b - *r);
        norm(&r) / norm(b)
    }

    /// Requirement: the residual promised is the true one, with and without a start, and what is
    /// asked for is reached. Tolerance: rounding of a well conditioned system.
    #[test]
    fn the_residual_is_the_true_one() {
        let operator = |v: &[f64], w: &mut [f64]| tridiagonal(v, w, (-1.3, 2.5, -0.4));
        let b: Vec<f64> = (0..150).map(|i| ((i * 37) % 19) as f64 - 9.0).collect();
        let mut workspace = Workspace::default();
        for tolerance in [1e-2, 1e-6, 1e-12] {
            for start in [0.0, 3.0] {
                let mut x = vec![start; b.len()];
                let stop = Stop { tolerance, ..STOP };
                let progress = gmres(operator, copy, &b, &mut x, stop, &mut workspace);
                let true_residual = relative_residual(operator, &x, &b);
                assert!(progress.converged() && progress.residual <= tolerance);
                assert!((progress.residual - true_residual).abs() < 1e-14, "{progress:?}");
            }
        }
    }

    /// Requirement: identity plus rank k is solved in k + 1 iterations (its minimal polynomial has
    /// that degree), an exact preconditioner in one.
    #[test]
    fn as_many_iterations_as_the_minimal_polynomial_has_degrees() {
        let n = 60;
        let rank = |v: &[f64], w: &mut [f64]| {
            w.copy_from_slice(v);
            for k in 0..3 {
                w[5 * k] += (k + 1) as f64 * v.iter().skip(k).step_by(3).sum::<f64>();
            }
        };
        let b: Vec<f64> = (0..n).map(|i| 1.0 + (i % 7) as f64).collect();
        let mut x = vec![0.0; n];
        let progress = gmres(rank, copy, &b, &mut x, STOP, &mut Workspace::default());
        assert_eq!((progress.iterations, progress.converged()), (4, true));
        let diagonal = |v: &[f64], w: &mut [f64]| {
            w.iter_mut().zip(v).enumerate().for_each(|(i, (w, v))| *w = v * (1.0 + i as f64));
        };
        let inverse = |v: &[f64], z: &mut [f64]| {
            z.iter_mut().zip(v).enumerate().for_each(|(i, (z, v))| *z = v / (1.0 + i as f64));
        };
        let mut x = vec![0.0; n];
        let progress = gmres(diagonal, inverse, &b, &mut x, STOP, &mut Workspace::default());
        assert_eq!((progress.iterations, progress.converged()), (1, true));
    }

    /// Requirement: the preconditioner may be another one in every iteration (here an inexact
    /// inner solution that changes), the residual stays the true one.
    #[test]
    fn the_preconditioner_may_change() {
        let operator = |v: &[f64], w: &mut [f64]| tridiagonal(v, w, (-1.0, 2.2, -1.1));
        let mut count = 0;
        let changing = |v: &[f64], z: &mut [f64]| {
            count += 1;
            let sweeps = 1 + count % 3;
            let mut w = vec![0.0; v.len()];
            z.fill(0.0);
            for _ in 0..sweeps {
                operator(z, &mut w);
                z.iter_mut().zip(v).zip(&w).for_each(|((z, v), w)| *z += (v - w) / 2.2);
            }
        };
        let b: Vec<f64> = (0..80).map(|i| (i as f64).sin()).collect();
        let mut x = vec![0.0; b.len()];
        let progress = gmres(operator, changing, &b, &mut x, STOP, &mut Workspace::default());
        assert!(progress.converged());
        assert!(relative_residual(operator, &x, &b) < 1.1e-12);
    }

    /// Requirement: the result scales with the units of the right-hand side down and up to the ends
    /// of the exponents, bit for bit for powers of two.
    #[test]
    fn scale_does_not_matter() {
        let operator = |v: &[f64], w: &mut [f64]| tridiagonal(v, w, (-1.0, 3.0, -0.5));
        let solve = |factor: f64| {
            let b: Vec<f64> = (0..40).map(|i| factor * (1.0 + (i % 5) as f64)).collect();
            let mut x = vec![0.0; 40];
            let progress = gmres(operator, copy, &b, &mut x, STOP, &mut Workspace::default());
            assert!(progress.converged());
            x.iter_mut().for_each(|x| *x /= factor);
            (x, progress)
        };
        let one = solve(1.0);
        for power in [-900, -300, 300, 900] {
            assert_eq!(solve(2.0_f64.powi(power)), one);
        }
    }

    /// Requirement: what cannot be solved is told, with the best solution: a singular operator, one
    /// that gives no number, too few iterations, nothing to solve.
    #[test]
    fn endings_are_told() {
        let mut workspace = Workspace::default();
        let singular = |v: &[f64], w: &mut [f64]| {
            w.copy_from_slice(v);
            w[2] = 0.0;
        };
        let mut x = [0.0; 4];
        let b = [1.0, 2.0, 3.0, 4.0];
        let progress = gmres(singular, copy, &b, &mut x, STOP, &mut workspace);
        assert_eq!(progress.ending, Ending::Exhausted);
        assert!(x.iter().zip(b).take(2).all(|(x, b)| (x - b).abs() < 1e-14), "{x:?}");
        let nothing = |_: &[f64], w: &mut [f64]| w.fill(0.0);
        let progress = gmres(nothing, copy, &b, &mut [0.0; 4], STOP, &mut workspace);
        assert_eq!((progress.ending, progress.residual), (Ending::Exhausted, 1.0));
        let broken = |_: &[f64], w: &mut [f64]| w.fill(f64::NAN);
        let mut x = [0.0; 4];
        let progress = gmres(broken, copy, &b, &mut x, STOP, &mut workspace);
        assert_eq!((progress.ending, x), (Ending::NotFinite, [0.0; 4]));
        let operator = |v: &[f64], w: &mut [f64]| tridiagonal(v, w, (-1.0, 2.0, -1.0));
        let few = Stop { iterations: 2, ..STOP };
        let progress = gmres(operator, copy, &b, &mut [0.0; 4], few, &mut workspace);
        assert_eq!((progress.ending, progress.iterations), (Ending::Limit, 2));
        assert!(progress.residual > 0.0 && progress.residual < 1.0);
        let mut x = [1.0; 4];
        let progress = gmres(operator, copy, &[0.0; 4], &mut x, STOP, &mut workspace);
        assert_eq!((progress.ending, x), (Ending::Converged, [0.0; 4]));
        let progress = gmres(operator, copy, &[], &mut [], STOP, &mut workspace);
        assert_eq!(progress.iterations, 0);
    }

    /// Requirement: vectors stay orthogonal where Gram-Schmidt alone loses it: the solution of an
    /// ill-conditioned system (condition 1e10) has the residual that the recurrence promises.
    #[test]
    fn ill_conditioned_systems_keep_an_orthogonal_basis() {
        let n = 40;
        let operator = |v: &[f64], w: &mut [f64]| {
            tridiagonal(v, w, (0.0, 0.0, 1.0));
            w.iter_mut().zip(v).enumerate().for_each(|(i, (w, v))| {
                *w += 10.0_f64.powf(-10.0 * i as f64 / n as f64) * v;
            });
        };
        let b = vec![1.0; n];
        let mut x = vec![0.0; n];
        let mut workspace = Workspace::default();
        let progress = gmres(operator, copy, &b, &mut x, STOP, &mut workspace);
        let count = progress.iterations;
        let vectors: Vec<&[f64]> = workspace.basis.chunks_exact(n).take(count).collect();
        for (i, v) in vectors.iter().enumerate() {
            for (j, w) in vectors.iter().enumerate() {
                let unit = if i == j { 1.0 } else { 0.0 };
                assert!((dot(v, w) - unit).abs() < 1e-14, "{i} {j}");
            }
        }
    }

    /// Requirement: a further solution that needs no more iterations uses the same memory.
    #[test]
    fn memory_is_kept() {
        let operator = |v: &[f64], w: &mut [f64]| tridiagonal(v, w, (-1.0, 3.0, -0.5));
        let b = vec![1.0; 30];
        let mut workspace = Workspace::for_iterations(30, 30);
        let before = (workspace.basis.as_ptr(), workspace.direction.as_ptr());
        for _ in 0..2 {
            let stop = Stop { iterations: 30, ..STOP };
            let mut x = vec![0.0; 30];
            assert!(gmres(operator, copy, &b, &mut x, stop, &mut workspace).converged());
            assert_eq!((workspace.basis.as_ptr(), workspace.direction.as_ptr()), before);
        }
    }
}
