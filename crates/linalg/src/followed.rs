//! A matrix near one that was factored, solved with its factors.
//!
//! ```text
//!   K_0 = L D L'    K_1 ~ K_0:  conjugate gradients for K_1 with (L D L')^-1
//! ```
//!
//! Their error falls with each iteration by the part by which the matrices differ: where that is a
//! tenth, eight of them give eight digits.

use crate::conjugate::Definite;
use crate::krylov::Stop;
use crate::pattern::Matrix;
use crate::system::{BackEnd, Description, Kind, LinearSystem};

/// Operations of a factorisation for each entry of the factors from which on iterations with
/// factors that are near take less time [1]: a factorisation of so many takes as long as five of
/// them (measured).
const WORTH: f64 = 400.0;
/// And from which on factors in single precision pay: with 310 they take as long as those in double,
/// iterations included, and half the memory (measured).
const WORTH_SINGLE: f64 = 300.0;
/// How far they go, and after how many the factorisation is the better choice. What is left of a
/// correction is below what the next linearisation changes: histories agree to 1e-12 (measured).
pub(crate) const NEAR: Stop = Stop { tolerance: 1e-8, iterations: 12 };

/// The same with factors of the matrix itself in single precision.
pub(crate) const EXACT: Stop = Stop { tolerance: 1e-12, iterations: 12 };

/// Whether solutions with factors that are near are worth their iterations.
pub(crate) fn pays(system: &Description) -> bool {
    is_worth(system, WORTH)
}

/// Whether those with factors in single precision are.
pub(crate) fn single_pays(system: &Description) -> bool {
    is_worth(system, WORTH_SINGLE)
}

fn is_worth(system: &Description, operations: f64) -> bool {
    let symmetric = system.back_end == BackEnd::Sparse && system.kind == Kind::Symmetric;
    symmetric && system.predicted_operations >= operations * system.predicted_entries
}

/// A matrix with the factors of one near it.
pub(crate) struct Followed<'a> {
    pub matrix: Matrix<'a>,
    pub factors: &'a mut dyn LinearSystem,
}

impl Definite for Followed<'_> {
    fn multiply(&mut self, x: &[f64], y: &mut [f64]) {
        self.matrix.multiply(x, y);
    }

    fn precondition(&mut self, r: &[f64], z: &mut [f64]) -> bool {
        z.copy_from_slice(r);
        self.factors.solve(z, 1).is_ok()
    }
}
