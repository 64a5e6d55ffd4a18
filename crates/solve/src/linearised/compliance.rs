//! Products with the compliance of contact, without forming it.

use super::augmentation::Stiffness;
use super::laws::LawAnswers;
use super::points::LinearPoints;
use super::rows::{Row, Unknown};
use slideline_linalg::SolveError;
use slideline_linalg::krylov;

/// Scratch of the matrix-free way, kept from iteration to iteration.
#[derive(Clone, Debug, Default)]
pub(super) struct MatrixFree {
    /// Right-hand side of the iteration, -r.
    pub(super) right_side: Vec<f64>,
    /// K_s^-1 of it.
    pub(super) base: Vec<f64>,
    /// A right-hand side and its solution, an entry an equation.
    pub(super) full: Vec<f64>,
    /// e = free - C q, a row each.
    pub(super) values: Vec<f64>,
    pub(super) residual: Vec<f64>,
    pub(super) step: Vec<f64>,
    /// C times the step.
    pub(super) yielded: Vec<f64>,
    pub(super) trial: [Vec<f64>; 2],
    pub(super) scaled: Vec<f64>,
    pub(super) laws: LawAnswers,
    pub(super) krylov: krylov::Workspace,
    /// Forces on all equations that no multiplier balances, and what the factors make of them.
    pub(super) pushed: Vec<f64>,
    pub(super) correction: Vec<f64>,
    /// Whether all rows lie on the interface that the stiffness was analysed for.
    pub(super) on_interface: bool,
    /// Solutions with the factored stiffness in this iteration.
    pub solves: usize,
}

impl MatrixFree {
    pub(super) fn make_room(&mut self, rows: usize, integration_points: usize) {
        let [a, b] = &mut self.trial;
        let vectors = [
            &mut self.values,
            &mut self.residual,
            &mut self.step,
            &mut self.yielded,
            &mut self.scaled,
            a,
            b,
        ];
        for vector in vectors {
            vector.resize(rows, 0.0);
        }
        self.laws.make_room(rows, integration_points);
    }

    /// K_s^-1 of the right-hand side, with the factors at hand.
    pub(super) fn find_base(&mut self, stiffness: &mut Stiffness<'_>) -> Result<(), SolveError> {
        self.base.clone_from(&self.right_side);
        self.solves += 1;
        stiffness.solver.respond_on_interface(&mut self.base, false)
    }
}

/// Products with C of a set of rows.
pub(super) struct Compliance<'a> {
    pub(super) rows: &'a [Row],
    pub(super) points: &'a LinearPoints,
    pub(super) full: &'a mut Vec<f64>,
    pub(super) on_interface: bool,
    pub(super) solves: &'a mut usize,
    pub(super) fault: Option<SolveError>,
}

impl Compliance<'_> {
    /// Forces of the multipliers `q` of the rows on the equations: F' A q.
    pub(super) fn push(&mut self, q: impl Fn(usize) -> f64) {
        self.full.fill(0.0);
        for (i, row) in self.rows.iter().enumerate() {
            let q = q(i);
            match row.unknown {
                Unknown::Multiplier { point, kind, .. } => {
                    self.points.at(point).push(kind, q, self.full);
                }
                Unknown::Interface { equation } => self.full[equation] += q,
            }
        }
    }

    /// C q with the factors at hand, into a value a row; the displacements of the rows are left in
    /// `full`.
    pub(super) fn product(&mut self, stiffness: &mut Stiffness<'_>, q: &[f64], into: &mut [f64]) {
        self.push(|i| q[i]);
        self.respond(stiffness, into);
    }

    /// What the forces in `full` move.
    pub(super) fn respond(&mut self, stiffness: &mut Stiffness<'_>, into: &mut [f64]) {
        *self.solves += 1;
        if let Err(fault) = stiffness.solver.respond_on_interface(self.full, self.on_interface) {
            self.fault = Some(fault);
        }
        for (value, row) in into.iter_mut().zip(self.rows) {
            *value = match row.unknown {
                Unknown::Multiplier { point, kind, .. } => {
                    self.points.at(point).dot(kind, self.full)
                }
                Unknown::Interface { equation } => self.full[equation],
            };
        }
    }
}
