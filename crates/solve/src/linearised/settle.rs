//! The contact problem of an iteration solved with factors that are near, and made good.
//!
//! ```text
//!   du = base - K~^-1 F' A (q - anchor)   K~: the factors at hand, in single precision or of the
//!                                         symmetric part; q solves the contact problem over them
//!   rest = -r - F' A q - K_s du           nothing, were they those of K_s
//!   base = du + K~^-1 rest, anchor = q    and the contact problem again, from there
//! ```
//!
//! What is left shrinks every time by the part by which the factors are wrong, and so does what they
//! are asked for; where they are exact it is rounding at once. docs/theory.md eqs (8.34) and (8.35).

use super::augmentation::Stiffness;
use super::compliance::{Compliance, MatrixFree};
use super::condensed::LinearisedContact;
use super::context::LawContext;
use super::points::LinearPoints;
use slideline_linalg::SolveError;

/// Backward error at which equilibrium counts as reached [1].
const BALANCED: f64 = 1e-11;
/// And up to which it does where rounding leaves no less, of near factors and of exact ones [1].
const NEARLY: f64 = 1e-9;
const ROUNDED: f64 = 1e-6;
/// The most corrections, and the part of the error that each has to leave at most.
const CORRECTIONS: usize = 20;
const SLOW: f64 = 0.3;

impl LinearisedContact {
    /// As [`LinearisedContact::solve`], without forming C.
    pub(super) fn solve_matrix_free(
        &mut self,
        points: &mut LinearPoints,
        context: &LawContext<'_>,
        stiffness: &mut Stiffness<'_>,
        correction: &mut [f64],
    ) -> Result<(), SolveError> {
        let mut work = std::mem::take(&mut self.matrix_free);
        work.solves = 0;
        work.right_side.clear();
        work.right_side.extend_from_slice(correction);
        for vector in [&mut work.full, &mut work.pushed, &mut work.correction] {
            vector.resize(correction.len(), 0.0);
        }
        let solver = &*stiffness.solver;
        work.on_interface =
            points.with_rows().all(|point| solver.is_on_interface(point.rows.unknowns));
        let result = self.settle(points, context, stiffness, &mut work);
        if result.is_ok() {
            correction.copy_from_slice(&self.moved);
            self.back_substitute_matrix_free(points, context, &work);
        }
        self.matrix_free = work;
        result
    }

    /// Solves the contact problem over the factors at hand until the displacements are in
    /// equilibrium; exact factors are made where near ones do not get there.
    fn settle(
        &mut self,
        points: &mut LinearPoints,
        context: &LawContext<'_>,
        stiffness: &mut Stiffness<'_>,
        work: &mut MatrixFree,
    ) -> Result<(), SolveError> {
        work.find_base(stiffness)?;
        self.anchor.clear();
        self.moved.clone_from(&work.base);
        self.rounds_matrix_free(points, context, stiffness, (work, true))?;
        let mut before = f64::INFINITY;
        for _ in 0..CORRECTIONS {
            let error = self.balance(points, stiffness, work)?;
            if error <= BALANCED {
                return Ok(());
            }
            let slow = error.is_nan() || error > SLOW * before;
            match (slow, stiffness.solver.is_exact()) {
                (true, false) if error <= NEARLY => return Ok(()),
                (true, true) if error <= ROUNDED => return Ok(()),
                // nothing solves it: this says why
                (true, true) => return stiffness.solver.solve(&mut work.pushed),
                (true, false) => {
                    stiffness.solver.factor_exactly()?;
                    work.find_base(stiffness)?;
                    self.anchor.fill(0.0);
                    before = f64::INFINITY;
                }
                (false, _) => {
                    let moved = self.moved.iter().zip(&work.correction);
                    work.base.clear();
                    work.base.extend(moved.map(|(du, rest)| du + rest));
                    self.anchor.clone_from(&self.unknown);
                    before = error;
                }
            }
            self.rounds_matrix_free(points, context, stiffness, (work, false))?;
        }
        Ok(())
    }

    /// Displacements of all equations under the multipliers found, the backward error of their
    /// equilibrium, and what the factors make of the rest.
    fn balance(
        &mut self,
        points: &LinearPoints,
        stiffness: &mut Stiffness<'_>,
        work: &mut MatrixFree,
    ) -> Result<f64, SolveError> {
        let MatrixFree { full, base, right_side, pushed, correction, solves, .. } = work;
        let (rows, unknown, anchor) = (&self.rows, &self.unknown, &self.anchor);
        let mut c = Compliance { rows, points, full, on_interface: false, solves, fault: None };
        c.push(|i| unknown[i]);
        pushed.iter_mut().zip(&*right_side).zip(&*c.full).for_each(|((own, b), f)| *own = b - f);
        if unknown != anchor {
            c.push(|i| unknown[i] - anchor[i]);
            *c.solves += 1;
            stiffness.solver.respond_on_interface(full, false)?;
        } else {
            full.fill(0.0);
        }
        self.moved.clear();
        self.moved.extend(base.iter().zip(&*full).map(|(base, yielded)| base - yielded));
        stiffness.solver.correction((pushed, &self.moved), BALANCED, correction)
    }
}
