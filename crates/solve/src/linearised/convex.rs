//! The contact problem with the limits of friction held fixed: a convex one.
//!
//! ```text
//!   energy |\         /      K0/2 du.du - beta.du + sum A W(e):   W convex,
//!          | \___   _/       so the slope along a Newton direction only grows
//!          |     \_/         and has one zero: there the step ends
//!          +--------> step
//! ```
//!
//! Newton by the norm of the residual can be caught between the limits of
//! friction, or among the active sets of a hard law, where a body is held by
//! little else than contact. With limits mu p of fixed p (Tresca friction) the
//! same equations are the gradient of a convex energy, and a step that ends where
//! that energy is least never leaves the way to the solution. From there the laws
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
/// Halvings that find the end of a step.
const HALVINGS: usize = 40;
/// Part of a step to which its end is found, and of the slope at its beginning that counts as
/// none [1].
const LEVEL: f64 = 1e-9;
/// Stiffness, in that which a row feels, that holds rows in a step where nothing else holds them [1].
pub(super) const HOLDING: f64 = 1e-8;
/// Residual, relative to the multipliers, at which a step that does not halve it is rounding [1].
const ROUNDED: f64 = 1e-8;
/// Change of all pressures, relative to the largest, that ends the rounds [1].
const STEADY: f64 = 1e-6;

impl LinearisedContact {
    /// Moves the unknowns to where the energy is least, rounds of fixed limits
    /// after one another.
    pub(super) fn minimise(&mut self, points: &LinearPoints, context: &LawContext<'_>) {
        let mut work = std::mem::take(&mut self.descent);
        let mut held = std::mem::take(&mut work.held);
        held.copy_from(points);
        let fixed = LawContext { symmetrised: true, ..*context };
        work.steps = 0;
        for _ in 0..ROUNDS {
            self.descend(&held, &fixed, &mut work);
            if self.follow_pressures(&mut held, &fixed, &mut work.values) {
                break;
            }
        }
        work.held = held;
        self.descent = work;
    }

    /// Newton with steps that end where the energy is least.
    fn descend(&mut self, points: &LinearPoints, fixed: &LawContext<'_>, work: &mut Descent) {
        work.make_room(self.rows.len());
        let mut unknown = std::mem::take(&mut self.unknown);
        let system = System {
            rows: &self.rows,
            compliance: &self.compliance,
            integration_points: &self.integration_points,
        };
        let (mut before, mut part) = (f64::INFINITY, 0.0);
        for _ in 0..STEPS {
            let size = work.evaluate(&system, &unknown, points, fixed);
            let largest = system.largest_multiplier(&unknown);
            // with many rows rounding leaves more than the least that is asked for, and all
            // further steps would go into it
            let stays = size > 0.25 * before;
            let rounded = stays && size <= ROUNDED * ROUNDED * largest;
            if !size.is_finite() || size <= 1e-24 * largest || rounded {
                break;
            }
            if stays && part == 1.0 && work.went_straight(system.rows, size) {
                if work.holding > 0.0 {
                    break; // downhill without end, or no more than rounding
                }
                work.hold(&system, &unknown, points, fixed);
            }
            before = size;
            work.steps += 1;
            if !work.find_way_down(&system, &unknown, points, fixed) {
                break; // no way down: rows that depend on one another
            }
            work.from.clone_from(&unknown);
            part = work.walk(&system, &mut unknown, points, fixed);
        }
        self.unknown = unknown;
    }

    /// Gives the points the pressures of the present unknowns; says whether
    /// they are what they were.
    fn follow_pressures(
        &mut self,
        points: &mut LinearPoints,
        fixed: &LawContext<'_>,
        values: &mut Vec<f64>,
    ) -> bool {
        let system = System {
            rows: &self.rows,
            compliance: &self.compliance,
            integration_points: &self.integration_points,
        };
        values.clear();
        let rows = 0..self.rows.len();
        values.extend(rows.map(|i| system.multiplier_and_value(i, &self.unknown).1));
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

impl Descent {
    /// Holds the rows where they are in each step from here on: something moves that only contact holds.
    fn hold(
        &mut self,
        system: &System<'_>,
        unknown: &[f64],
        points: &LinearPoints,
        fixed: &LawContext<'_>,
    ) {
        self.holding = HOLDING;
        self.evaluate(system, unknown, points, fixed);
    }

    /// Finds a step along which the energy falls; false: there is none.
    fn find_way_down(
        &mut self,
        system: &System<'_>,
        unknown: &[f64],
        points: &LinearPoints,
        fixed: &LawContext<'_>,
    ) -> bool {
        self.find_step(system);
        if self.slope() > 0.0 {
            return true;
        }
        // Sliding, the structure gives way; sticking it may not: the steepest the laws can be lies
        // above them all the way.
        self.steepest = true;
        self.evaluate(system, unknown, points, fixed);
        self.find_step(system);
        if self.slope() <= 0.0 && self.holding == 0.0 {
            self.hold(system, unknown, points, fixed);
            self.find_step(system);
        }
        self.steepest = false;
        self.slope() > 0.0
    }

    /// Goes along the step to where the energy is least, or to its end; says how far.
    fn walk(
        &mut self,
        system: &System<'_>,
        unknown: &mut [f64],
        points: &LinearPoints,
        fixed: &LawContext<'_>,
    ) -> f64 {
        let level = LEVEL * self.slope();
        let (mut low, mut high, mut at) = (0.0, 1.0, 1.0);
        for _ in 0..HALVINGS {
            self.go(system, (unknown, at), points, fixed);
            let slope = self.slope();
            if at == 1.0 && slope >= -level {
                break; // not uphill at its end
            }
            if slope >= 0.0 {
                low = at;
            } else {
                high = at;
            }
            if high - low <= LEVEL * high {
                break;
            }
            at = 0.5 * (low + high);
        }
        at
    }
}
