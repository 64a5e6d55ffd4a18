//! Stations of integrated contact in the small system.
//!
//! Many integration_points press on few equations: none has a row of its own, the
//! equations that they press on have.

use super::system::IntegrationPoint;
use super::{LawContext, LinearPoint, LinearisedContact, MOST_DOFS};
use slideline_linalg::{SolveError, Solver};

impl LinearisedContact {
    /// Lets a integration_point join; its equations that no integration_point has touched yet
    /// become rows.
    pub(super) fn add_integration_point(
        &mut self,
        (point, place): (&LinearPoint, usize),
        context: &LawContext<'_>,
        solver: &mut Solver,
        base: &[f64],
    ) -> Result<(), SolveError> {
        let mut integration_point = IntegrationPoint { point: place, rows: [0; MOST_DOFS] };
        for (row, &equation) in
            integration_point.rows.iter_mut().zip(&point.equations[..point.width])
        {
            *row = match self.interface.get(&equation) {
                Some(&known) => known,
                None => {
                    let unit = context.units.get(equation).copied().unwrap_or(1.0);
                    self.add_interface((equation, unit), solver, base)?
                }
            };
        }
        self.integration_points.push(integration_point);
        Ok(())
    }

    fn add_interface(
        &mut self,
        (equation, unit): (usize, f64),
        solver: &mut Solver,
        base: &[f64],
    ) -> Result<usize, SolveError> {
        let n = base.len();
        let begin = self.response.len();
        self.response.resize(begin + n, 0.0);
        self.response[begin + equation] = 1.0;
        solver.respond(&mut self.response[begin..])?;
        let place = self.push_interface(equation, unit);
        self.rows[place].free = base[equation];
        Ok(place)
    }

    /// Starts the forces of the interface rows from the pressures and
    /// tractions that the iteration estimates.
    pub(super) fn press(&mut self, points: &[LinearPoint]) {
        for integration_point in &self.integration_points {
            let point = &points[integration_point.point];
            let traction = point.sliding.map_or(0.0, |sliding| sliding.traction);
            for a in 0..point.width {
                let force = point.pressure * point.normal[a] + traction * point.direction[a];
                self.unknown[integration_point.rows[a]] += point.area * force;
            }
        }
    }
}
