//! What the turning of T makes of forces: f . d2u/dq2.

use super::following::Constraints;
use super::linear::Kept;
use super::numbering::Role;
use super::rows::Rows;
use slideline_mech::turn::Turn;

impl Constraints<'_> {
    /// Stiffness by the turning of T, f . d2u/dq2, for forces `f` on all dofs
    /// (those that act on dependent ones count; they are used up): calls back
    /// with pairs of rotations, or of dofs that a shape follows, and their stiffness.
    pub fn turning(
        &self,
        rows: &Rows,
        at: (&[f64], &[Turn]),
        f: &mut [f64],
        mut call: impl FnMut(usize, usize, f64),
    ) {
        // what follows a body linearly presses on it too
        for (place, constraint) in self.linear.iter().enumerate().skip(self.leading).rev() {
            let dependent = constraint.dependent;
            match &constraint.kept {
                Kept::Nothing => constraint.carry(self.motion.linear(place).0, f),
                Kept::Shape(shape) => {
                    let Role::Dependent(row) = self.roles[dependent] else { continue };
                    let force = std::mem::take(&mut f[dependent]);
                    let followed = || self.row(row, rows);
                    let places = (&self.motion.places[..], at.0);
                    shape.turning((dependent, force), places, followed, &mut call);
                    followed().for_each(|(dof, a)| f[dof] += a * force);
                }
                // all of its rows, when the forces on each of them are whole
                Kept::Mean(Some(mean)) => {
                    mean.turning(self.motion.cloud(mean.place), at, f, &mut call)
                }
                Kept::Mean(None) => {}
            }
        }
        for (link, &arm) in self.rigid.iter().zip(&self.motion.arms) {
            link.turning((arm, self.axes_of(link)), at, f, &mut call);
        }
    }
}
