//! Conjugate gradients for definite matrices, with whatever is near their inverse.
//!
//! ```text
//!   x_k+1 = x_k + a p_k      a from the residual and the curvature p' A p of the direction,
//!   p_k+1 = M r + b p_k      M ~ 1/A: a multigrid cycle, the factors of a matrix near A
//! ```
//!
//! [hestenes1952]. A direction of no or negative curvature ends them: the matrix is not definite.

use crate::krylov::Stop;

/// A definite matrix and what is near its inverse.
pub(crate) trait Definite {
    /// y = A x.
    fn multiply(&mut self, x: &[f64], y: &mut [f64]);
    /// z = M r; false where that fails.
    fn precondition(&mut self, r: &[f64], z: &mut [f64]) -> bool;
}

/// Vectors of the iteration, kept from one solution to the next.
#[derive(Clone, Debug, Default)]
pub(crate) struct Conjugate {
    x: Vec<f64>,
    residual: Vec<f64>,
    z: Vec<f64>,
    product: Vec<f64>,
    direction: Vec<f64>,
}

impl Conjugate {
    /// Solves in place from zero; false, and the right-hand side as it was, where that fails or
    /// takes more iterations than allowed.
    pub fn solve(&mut self, b: &mut [f64], stop: Stop, system: &mut impl Definite) -> bool {
        let size = norm(b);
        if size == 0.0 {
            return true;
        }
        self.begin(b);
        let Self { x, residual, z, product, direction } = self;
        let mut descent = 0.0;
        for _ in 0..stop.iterations {
            if !system.precondition(residual, z) {
                return false;
            }
            let next = dot(residual, z);
            let along = if descent > 0.0 { next / descent } else { 0.0 };
            descent = next;
            direction.iter_mut().zip(&*z).for_each(|(d, z)| *d = z + along * *d);
            system.multiply(direction, product);
            let curvature = dot(direction, product);
            if !(curvature > 0.0 && descent > 0.0) {
                return false;
            }
            let step = descent / curvature;
            x.iter_mut().zip(&*direction).for_each(|(x, d)| *x += step * d);
            residual.iter_mut().zip(&*product).for_each(|(r, p)| *r -= step * p);
            if norm(residual) <= stop.tolerance * size {
                b.copy_from_slice(x);
                return true;
            }
        }
        false
    }

    fn begin(&mut self, b: &[f64]) {
        let Self { x, residual, z, product, direction } = self;
        for vector in [x, z, product, direction] {
            vector.clear();
            vector.resize(b.len(), 0.0);
        }
        residual.clear();
        residual.extend_from_slice(b);
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(crate) fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}
