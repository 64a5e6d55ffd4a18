//! T at a configuration: how dependent dofs follow the others.

use super::following::Constraints;
use super::linear::{Kept, LinearConstraint};
use super::numbering::{ConstraintNumbering, Role};
use slideline_linalg::Pattern;
use slideline_mech::rigid::PlaneTurn;
use slideline_mech::turn::Turn;

/// Coefficients of T at a configuration, in the order of the rows.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Rows {
    coefficients: Vec<f64>,
}

impl Constraints<'_> {
    /// T at displacements, the rotations of nodes in space counting from the turns: writes `into`.
    pub fn linearise(&self, at: (&[f64], &[Turn]), into: &mut Rows) {
        let list = &mut into.coefficients;
        list.clear();
        list.reserve_exact(self.row_dofs.len());
        let mut linear = 0..self.linear.len();
        for row in linear.by_ref().take(self.leading) {
            list.extend(self.motion.linear(row).0);
        }
        let mut turned = PlaneTurn::NONE;
        for (link, &arm) in self.rigid.iter().zip(&self.motion.arms) {
            let axes = self.axes_of(link);
            link.push_coefficients((arm, axes), (at, &mut turned), list);
        }
        for row in linear {
            let LinearConstraint { dependent, kept, .. } = &self.linear[row];
            match kept {
                Kept::Nothing => list.extend(self.motion.linear(row).0),
                Kept::Shape(shape) => {
                    shape.push_coefficients(*dependent, (&self.motion.places, at.0), list);
                }
                // those of all its rows, which stand behind the first one
                Kept::Mean(Some(mean)) => {
                    mean.push_coefficients(self.motion.cloud(mean.place), at, list)
                }
                Kept::Mean(None) => {}
            }
        }
    }
}

impl ConstraintNumbering {
    /// What a dependent dof follows, with coefficients.
    pub(super) fn row<'a>(
        &'a self,
        row: usize,
        rows: &'a Rows,
    ) -> impl Iterator<Item = (usize, f64)> + 'a {
        let range = self.row_start[row]..self.row_start[row + 1];
        let dofs = self.row_dofs[range.clone()].iter().copied();
        dofs.zip(rows.coefficients[range].iter().copied())
    }

    /// Fills in the changes of dependent dofs, du = T dq.
    pub fn expand(&self, rows: &Rows, change: &mut [f64]) {
        for &(dof, row) in &self.led {
            change[dof] = self.row(row, rows).map(|(from, a)| a * change[from]).sum();
        }
    }

    /// How large the shares of forces [1] and their levers [L] are by which dofs that follow hand them to others: so
    /// much of the rounding of a force arrives there.
    pub fn largest_shares(&self, rows: &Rows, is_rotation: impl Fn(usize) -> bool) -> (f64, f64) {
        let mut largest = (0.0_f64, 0.0_f64);
        for &(_, row) in self.led.iter().filter(|(dof, _)| !is_rotation(*dof)) {
            for (from, share) in self.row(row, rows) {
                let field = if is_rotation(from) { &mut largest.1 } else { &mut largest.0 };
                *field = field.max(share.abs());
            }
        }
        largest
    }

    /// Hands forces on dependent dofs to those that they follow, T' f.
    pub fn carry(&self, rows: &Rows, force: &mut [f64]) {
        for &(dof, row) in self.led.iter().rev() {
            let own = std::mem::take(&mut force[dof]);
            if own != 0.0 {
                self.row(row, rows).for_each(|(to, a)| force[to] += a * own);
            }
        }
    }

    /// Calls back with every equation that a dof follows and its coefficient.
    pub fn for_each_equation(&self, rows: &Rows, dof: usize, call: &mut impl FnMut(usize, f64)) {
        match self.roles[dof] {
            Role::Free(equation) => call(equation, 1.0),
            Role::Dependent(row) => {
                for (from, a) in self.row(row, rows) {
                    match self.roles[from] {
                        Role::Free(equation) => call(equation, a),
                        Role::Dependent(_) => self.through(rows, (from, a), call),
                        Role::Inactive | Role::Prescribed(_) => {}
                    }
                }
            }
            Role::Inactive | Role::Prescribed(_) => {}
        }
    }

    /// The equations of a dependent dof that another one follows.
    fn through(&self, rows: &Rows, (dof, a): (usize, f64), call: &mut dyn FnMut(usize, f64)) {
        let Role::Dependent(row) = self.roles[dof] else { return };
        for (from, b) in self.row(row, rows) {
            match self.roles[from] {
                Role::Free(equation) => call(equation, a * b),
                Role::Dependent(_) => self.through(rows, (from, a * b), call),
                Role::Inactive | Role::Prescribed(_) => {}
            }
        }
    }

    /// Adds T' K T of a stencil to matrix values: `dofs` are its own, `tangent`
    /// row by row.
    pub fn scatter(
        &self,
        (rows, pattern): (&Rows, &Pattern),
        dofs: &[usize],
        tangent: impl Fn(usize, usize) -> f64,
        values: &mut [f64],
    ) {
        for (i, &row_dof) in dofs.iter().enumerate() {
            self.for_each_equation(rows, row_dof, &mut |row, a| {
                let mut next = usize::MAX;
                for (j, &column_dof) in dofs.iter().enumerate() {
                    self.for_each_equation(rows, column_dof, &mut |column, b| {
                        if let Some(at) = pattern.position_at((row, column), &mut next) {
                            values[at] += a * b * tangent(i, j);
                        }
                    });
                }
            });
        }
    }
}
