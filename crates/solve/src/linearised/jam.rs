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
//! Where C_nn itself is negative the structure gives way: it snaps, with friction or without.

use super::condensed::LinearisedContact;
use super::context::LawContext;
use super::points::{Kind, LinearPoints};
use slideline_mech::contact::tangential::Tangential;

/// Part of the compliance of a point below which it counts as none [1].
const ROUNDING: f64 = 1e-9;

impl LinearisedContact {
    /// The coefficient of friction from which on the point at `place` jams when it slides in the
    /// direction of `way`, by the system that was solved last, at `pressure` [F/L2]; `None` where it
    /// does not jam. Integration points of integrated contact are not asked.
    pub fn jams_from(
        &self,
        points: &LinearPoints,
        place: usize,
        (way, pressure): (Tangential, f64),
        context: &LawContext<'_>,
    ) -> Option<f64> {
        let m = self.rows.len();
        let row = |kind| self.rows.iter().position(|row| row.point() == Some((place, kind)));
        let n = row(Kind::Normal)?;
        let first = row(Kind::Tangential(0))?;
        if way == Tangential::ZERO || pressure <= 0.0 || self.compliance.len() < m * m {
            return None;
        }
        let law = &context.laws[points[place].law].friction;
        let limit = |pressure| law.limit_traction(pressure, Tangential::ZERO, context.dt);
        let mu = (limit(pressure * (1.0 + 1e-6)) - limit(pressure)) / (1e-6 * pressure);
        if !mu.is_finite() {
            return None;
        }
        let (d, directions) = (way.direction(), 0..points.directions());
        let ellipse = law.ellipse();
        let pull = ellipse.traction(ellipse.slip_on_circle(way).direction());
        let c = |i: usize, j: usize| self.compliance[i * m + j];
        let along = |row: usize| directions.clone().map(move |k| pull[k] * c(row, first + k)).sum();
        let (nn, nt): (f64, f64) = (c(n, n), along(n));
        let tt: f64 = directions.clone().map(|k| d[k] * along(first + k)).sum();
        // what the augmentation stiffness of the point itself takes off its compliance
        let tn: f64 = directions.clone().map(|k| d[k] * c(first + k, n)).sum();
        let augmentation = self.rows[first].augmentation * (nn * tt - nt * tn);
        let opens = nn - augmentation;
        let rounding = ROUNDING * nn.abs();
        if opens < -rounding {
            return None; // the structure gives way without any friction
        }
        let from = if opens > 0.0 && nt < 0.0 { -opens / nt } else { 0.0 };
        (opens + mu * nt <= rounding).then_some(from)
    }
}
