//! Integration points of integrated contact in the condensed contact problem.
//!
//! Many integration points press on few equations: none has a row of its own, the
//! equations that they press on have.

use super::condensed::LinearisedContact;
use super::context::LawContext;
use super::points::{LinearPoints, LinearRows};

impl LinearisedContact {
    /// Lets an integration point join; its equations that none has touched yet
    /// become rows.
    pub(super) fn add_integration_point(
        &mut self,
        (point, place): (&LinearRows<'_>, usize),
        context: &LawContext<'_>,
        base: &[f64],
    ) {
        for &equation in point.rows.unknowns {
            let row = match self.interface.get(&equation) {
                Some(&known) => known,
                None => {
                    let unit = context.units.get(equation).copied().unwrap_or(1.0);
                    self.add_interface((equation, unit), base)
                }
            };
            self.integration_points.push_row(row);
        }
        self.integration_points.finish(place);
    }

    fn add_interface(&mut self, (equation, unit): (usize, f64), base: &[f64]) -> usize {
        let begin = self.response.len();
        self.response.resize(begin + base.len(), 0.0);
        self.response[begin + equation] = 1.0;
        let place = self.push_interface(equation, unit);
        self.rows[place].free = base[equation];
        place
    }

    /// Starts the forces of the interface rows from the pressures and
    /// tractions that the iteration estimates.
    pub(super) fn press(&mut self, points: &LinearPoints) {
        for integration_point in self.integration_points.iter() {
            let point = points.at(integration_point.point);
            for (a, &row) in integration_point.rows.iter().enumerate() {
                let force = point.force_at(a, point.pressure, point.traction());
                self.unknown[row] += point.area * force;
            }
        }
    }
}
