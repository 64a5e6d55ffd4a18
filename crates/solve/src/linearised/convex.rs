//! The contact problem with the limits of friction held fixed: a convex one.
//!
//! ```text
//!   energy |\         /      K0/2 du.du - beta.du + sum A W(e):   W convex,
//!          | \___   _/       so the slope along a Newton direction only grows
//!          |     \_/         and has one zero: a little before it the step ends
//!          +--------> step
//! ```
//!
//! Newton by the norm of the residual can be caught between the limits of
//! friction, or among the active sets of a hard law, where a body is held by
//! little else than contact. With limits mu p of fixed p (Tresca friction) the
//! same equations are the gradient of a convex energy, and a step that ends before
//! that energy grows again never leaves the way to the solution. From there the laws
//! are taken as they are again. docs/theory.md eq. (8.25). (derived)

use super::condensed::LinearisedContact;
use super::context::LawContext;
use super::descent::Descent;
use super::points::{Kind, LinearPoint, LinearPoints};
use super::system::System;

/// Rounds in which the limits of friction follow the pressures.
const ROUNDS: usize = 8;
/// The most Newton steps of a round.
const STEPS: usize = 60;
/// Residual, relative to the multipliers, at which a step that does not halve it is rounding [1].
const ROUNDED: f64 = 1e-8;
/// Change of all pressures, relative to the largest, that ends the rounds [1].
const STEADY: f64 = 1e-6;

impl LinearisedContact {
    /// Moves the unknowns to where the energy is least, rounds of fixed limits
    /// after one another.
    pub(super) fn minimise(&mut self, points: &LinearPoints, context: &LawContext<'_>) {
        let mut work = std::mem::take(&mut self.descent);
        std::mem::swap(&mut work.room, &mut self.room);
        let mut held = std::mem::take(&mut work.held);
        held.copy_from(points);
        let fixed = LawContext { symmetrised: true, ..*context };
        work.steps = 0;
        for _ in 0..ROUNDS {
            self.descend(&held, &fixed, &mut work);
            if self.follow_pressures(&mut held, &fixed, &mut work.room.values) {
                break;
            }
        }
        work.held = held;
        std::mem::swap(&mut work.room, &mut self.room);
        self.descent = work;
    }

    /// Newton with steps that end where the energy is least.
    fn descend(&mut self, points: &LinearPoints, fixed: &LawContext<'_>, work: &mut Descent) {
        work.room.resize(self.rows.len(), self.integration_points.len());
        let unknown = &mut self.unknown;
        let system = System {
            rows: &self.rows,
            compliance: &self.compliance,
            integration_points: &self.integration_points,
        };
        let mut before = f64::INFINITY;
        for _ in 0..STEPS {
            system.values(unknown, &mut work.room.values);
            let size = work.evaluate(&system, unknown, points, fixed);
            let largest = system.largest_multiplier(unknown, &work.room.values);
            // with many rows rounding leaves more than the least that is asked for, and all
            // further steps would go into it
            let rounded = size <= ROUNDED * ROUNDED * largest && size > 0.25 * before;
            if !size.is_finite() || size <= 1e-24 * largest || rounded {
                break;
            }
            before = size;
            work.steps += 1;
            work.find_step(&system, points);
            if work.slope() <= 0.0 {
                // Sliding, the structure gives way; sticking it may not: the
                // steepest the laws can be lies above them all the way.
                work.steepest = true;
                work.evaluate(&system, unknown, points, fixed);
                work.steepest = false;
                work.find_step(&system, points);
                if work.slope() <= 0.0 {
                    break; // no way down: rows that depend on one another
                }
            }
            work.descend_along_step(&system, unknown, points, fixed);
        }
    }

    /// Gives the points the pressures of the present unknowns; says whether
    /// they are what they were.
    fn follow_pressures(
        &mut self,
        points: &mut LinearPoints,
        fixed: &LawContext<'_>,
        values: &mut [f64],
    ) -> bool {
        let system = System {
            rows: &self.rows,
            compliance: &self.compliance,
            integration_points: &self.integration_points,
        };
        system.values(&self.unknown, values);
        let (mut change, mut largest) = (0.0_f64, 0.0_f64);
        let mut follow = |point: &mut LinearPoint, pressure: f64| {
            change = change.max((pressure - point.pressure).abs());
            largest = largest.max(pressure.abs());
            point.pressure = pressure;
        };
        for (i, row) in self.rows.iter().enumerate() {
            if let Some((place, Kind::Normal)) = row.point() {
                let pressure = fixed.inserted_pressure(row, &points[place], values[i]).value;
                follow(&mut points[place], pressure);
            }
        }
        for integration_point in self.integration_points.iter() {
            let place = integration_point.point;
            let answer = fixed.integration_point(integration_point, &points.at(place), values);
            follow(&mut points[place], answer.pressure);
        }
        change <= STEADY * largest
    }
}
