//! Room for the steps of the condensed contact problem, kept from one to the next.

use super::laws::LawAnswers;
use slideline_linalg::DenseLu;

/// What a Newton step writes to, of either way to the solution.
#[derive(Clone, Debug, Default)]
pub(super) struct StepRoom {
    pub(super) residual: Vec<f64>,
    pub(super) step: Vec<f64>,
    /// C times the step; in a descent how the energy falls with the residual of each row.
    pub(super) yielded: Vec<f64>,
    /// Unknowns and their values at the end of a step; in a descent at its beginning.
    pub(super) trial: [Vec<f64>; 2],
    /// Displacements of the interface rows.
    pub(super) values: Vec<f64>,
    pub(super) jacobian: Vec<f64>,
    /// Its factors.
    pub(super) factors: DenseLu,
    /// dF/dd of the interface rows, row-major over all rows.
    pub(super) stiffness: Vec<f64>,
    /// What the laws said last of the rows: of a trial that may not have been taken.
    pub(super) laws: LawAnswers,
}

impl StepRoom {
    /// Room for so many rows and points, so that later steps allocate nothing.
    pub(super) fn reserve(&mut self, rows: usize, points: usize) {
        self.vectors().into_iter().for_each(|vector| vector.reserve(rows));
        self.jacobian.reserve(rows * rows);
        // factored once, so that what it needs is there
        self.factors.matrix_mut(rows);
        self.factors.factor();
        self.laws.rows.reserve(rows);
        self.laws.points.reserve(points);
    }

    /// The size of `m` rows and so many integration points.
    pub(super) fn resize(&mut self, m: usize, integration_points: usize) {
        self.vectors().into_iter().for_each(|vector| vector.resize(m, 0.0));
        self.jacobian.resize(m * m, 0.0);
        self.stiffness.resize(if integration_points == 0 { 0 } else { m * m }, 0.0);
        self.laws.make_room(m, integration_points);
    }

    fn vectors(&mut self) -> [&mut Vec<f64>; 6] {
        let [trial, trial_values] = &mut self.trial;
        let Self { residual, step, yielded, values, .. } = self;
        [residual, step, yielded, values, trial, trial_values]
    }
}
