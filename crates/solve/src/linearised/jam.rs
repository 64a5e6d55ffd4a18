//! Whether friction locks a contact.
//!
//! ```text
//!     p + dp            dh/dp = -(C_nn + mu s C_nt)
//!        \|/            C_nn: how a pressure opens the contact
//!     ____v____/        C_nt: how its friction, that way or against it, does
//! ```
//!
//! A point that slides in the direction s opens under a greater pressure as
//! long as C_nn + mu s C_nt > 0. At zero and below, the friction of the greater
//! pressure closes it by more than the pressure opens it: no pressure holds
//! the balance, and the contact jams. On a slope this is mu tan a >= 1. (derived)

use super::{Kind, LawContext, LinearPoint, LinearisedContact};

impl LinearisedContact {
    /// Whether the point at `place` jams when it slides in the direction of
    /// the sign of `way`, by the system that was solved last, at `pressure`
    /// [F/L2]. Stations of integrated contact are not asked.
    pub fn jams(
        &self,
        points: &[LinearPoint],
        place: usize,
        (way, pressure): (f64, f64),
        context: &LawContext<'_>,
    ) -> bool {
        let m = self.rows.len();
        let row = |kind| self.rows.iter().position(|row| row.point() == Some((place, kind)));
        let (Some(n), Some(t)) = (row(Kind::Normal), row(Kind::Tangential)) else { return false };
        if way == 0.0 || pressure <= 0.0 || self.compliance.len() < m * m {
            return false;
        }
        let c = |i: usize, j: usize| self.compliance[i * m + j];
        let law = &context.laws[points[place].pair].friction;
        let limit = |pressure| law.limit_traction(pressure, 0.0, context.dt);
        let mu = (limit(pressure * (1.0 + 1e-6)) - limit(pressure)) / (1e-6 * pressure);
        if !mu.is_finite() {
            return false;
        }
        // what the augmentation stiffness of the point itself takes off its compliance
        let augmentation = self.rows[t].augmentation * (c(n, n) * c(t, t) - c(n, t) * c(t, n));
        let opens = c(n, n) + mu * way.signum() * c(n, t) - augmentation;
        opens <= 1e-9 * c(n, n).abs()
    }
}
