//! The two example problems, with any dimensions.
//!
//! ```text
//!   problem 1                           problem 2
//!
//!   Y   ( O )  circle, moves along Y     pivot o--- arm
//!   |    \_/ /                                  \ phi
//!   |       / beam                              (O) cam
//!   |      /                            |============------ beam
//!   +-----/-------- X                   clamp          -> X
//! ```

use crate::cantilever::Cantilever;
use crate::error::{TheoryError, check_positive};
use crate::frame::{Circle, Frame};
use crate::references::equilibrium::{Equilibrium, Stroke};
use crate::references::{self, Reference};
use crate::softened_law::ExponentialLaw;

/// The 1995 paper's first problem: a rigid circle pushed along the Y axis
/// against an inclined cantilever.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FirstProblem {
    /// The beam.
    pub beam: Cantilever,
    /// Radius r of the circle [L].
    pub radius: f64,
    /// X coordinate of the circle's centre [L].
    pub circle_x: f64,
    /// Y coordinate of the centre at increment 0 [L].
    pub start_y: f64,
    /// Signed travel of the centre along Y over the stroke [L].
    pub stroke: f64,
    /// Softened contact law, for the references that use it.
    pub law: ExponentialLaw,
}

/// The second problem: a cam, a circle on an arm, turned against a cantilever.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SecondProblem {
    /// The beam.
    pub beam: Cantilever,
    /// Radius r of the circle [L].
    pub radius: f64,
    /// Pivot (x, y) [L].
    pub pivot: [f64; 2],
    /// Distance R from the pivot to the centre of the circle [L].
    pub arm: f64,
    /// Angle phi at increment 0 [rad]; the centre is pivot + R (sin phi, -cos phi).
    pub start_angle: f64,
    /// Signed rotation over the stroke, right-handed [rad].
    pub sweep: f64,
    /// Softened contact law, for the references that use it.
    pub law: ExponentialLaw,
}

/// One row of the first problem's curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FirstRow {
    /// Increment, from 0.
    pub increment: usize,
    /// Fraction of the stroke [-].
    pub time: f64,
    /// Support force on the circle along X [F].
    pub rf1: f64,
    /// Support force on the circle along Y [F].
    pub rf2: f64,
    /// Displacement of the circle along Y [L].
    pub u2: f64,
    /// Contact length xi_L (arc length for the exact references) [L]; none without contact.
    pub contact_length: Option<f64>,
    /// Normal contact force F [F]; zero without contact.
    pub force: f64,
}

/// One row of the second problem's curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SecondRow {
    /// Increment, from 0.
    pub increment: usize,
    /// Fraction of the sweep [-].
    pub time: f64,
    /// Driver's moment about the pivot, right-handed [F L].
    pub rm3: f64,
    /// Rotation of the cam [rad].
    pub ur3: f64,
    /// Contact length xi_L (arc length for the exact references) [L]; none without contact.
    pub contact_length: Option<f64>,
    /// Normal contact force F [F]; zero without contact.
    pub force: f64,
}

impl FirstProblem {
    /// The dimensions of the 1995 paper's decks (SI units).
    pub fn diehl() -> Self {
        Self {
            beam: Cantilever {
                base: [7.0e-3, 0.0],
                tip: [9.222e-3, 50.0e-3],
                width: 25.0e-3,
                thickness: 1.5e-3,
                modulus: 6.9e9,
                poisson: 0.3,
                shear_factor: 0.85,
            },
            radius: 9.0e-3,
            circle_x: 0.0,
            start_y: 45.0e-3,
            stroke: -30.0e-3,
            law: ExponentialLaw::diehl(),
        }
    }

    /// Tributary area [L2] of a slave node on the circle between neighbours `spacing`
    /// [rad] apart: width times chord, 2 b r sin(spacing/2) [semantics: areas]. The interior
    /// nodes of the paper's ISL deck near the contact are 4 degrees apart.
    pub fn slave_area(&self, spacing: f64) -> f64 {
        2.0 * self.beam.width * self.radius * (0.5 * spacing).sin()
    }

    /// Rows of increments 0 to `increments` of the push, equally spaced in the travel.
    ///
    /// # Errors
    /// [`TheoryError::AtIncrement`] with the reason; a circle that is clear of
    /// the beam now and then is no error but a row of zeros,
    /// [`TheoryError::NeverTouches`] one that is so throughout.
    pub fn rows(
        &self,
        mu: f64,
        increments: usize,
        reference: Reference,
    ) -> Result<Vec<FirstRow>, TheoryError> {
        self.stroke_rows(mu, increments, reference, Stroke::Push)
    }

    /// As [`FirstProblem::rows`], with the direction of sliding given. Row k of
    /// the return stroke is at the same position as row k of the push.
    ///
    /// # Errors
    /// As [`FirstProblem::rows`].
    pub fn stroke_rows(
        &self,
        mu: f64,
        increments: usize,
        reference: Reference,
        direction: Stroke,
    ) -> Result<Vec<FirstRow>, TheoryError> {
        let row = |increment, time| {
            let u2 = self.stroke * time;
            let found = self.equilibrium(u2, mu, reference, direction)?;
            let [rf1, rf2] = found.map_or([0.0; 2], |e| e.reaction);
            let force = found.map_or(0.0, |e| e.force);
            Ok(FirstRow {
                increment,
                time,
                rf1,
                rf2,
                u2,
                contact_length: found.map(|e| e.contact_length),
                force,
            })
        };
        each_increment(increments, row, |row| row.contact_length.is_some())
    }

    /// Equilibrium with the circle displaced by `u2` [L] from its start;
    /// `None` if the circle is clear of the beam.
    ///
    /// # Errors
    /// Why the reference does not exist at this position.
    pub fn equilibrium(
        &self,
        u2: f64,
        mu: f64,
        reference: Reference,
        direction: Stroke,
    ) -> Result<Option<Equilibrium>, TheoryError> {
        self.beam.check()?;
        check_circle(self.radius, mu)?;
        let frame = Frame::facing(&self.beam, [self.circle_x, self.start_y]);
        // the circle drags the beam in the direction in which it moves
        let along = self.stroke.signum() * frame.along[1];
        let circle =
            Circle { centre: frame.local([self.circle_x, self.start_y + u2]), radius: self.radius };
        let drag = mu * along.signum() * direction.sign();
        references::solve(&self.beam, &self.law, circle, drag, reference)
            .map(|found| found.map(|e| e.in_global(&frame)))
    }
}

impl SecondProblem {
    /// The dimensions this project uses for the second problem (SI units); the
    /// paper's figure with its dimensions is lost.
    pub fn project() -> Self {
        Self {
            beam: Cantilever { base: [0.0; 2], tip: [50.0e-3, 0.0], ..FirstProblem::diehl().beam },
            radius: 9.0e-3,
            pivot: [30.0e-3, 17.0e-3],
            arm: 10.0e-3,
            start_angle: 40f64.to_radians(),
            sweep: -60f64.to_radians(),
            law: ExponentialLaw::diehl(),
        }
    }

    /// Centre of the circle for the angle `phi` [rad]. Diehl (1995) eq. (10).
    pub fn centre(&self, phi: f64) -> [f64; 2] {
        [self.pivot[0] + self.arm * phi.sin(), self.pivot[1] - self.arm * phi.cos()]
    }

    /// Tributary area [L2] of a slave node on the cam between neighbours `spacing`
    /// [rad] apart: width times chord [semantics: areas]; 3 degrees in this project's model.
    pub fn slave_area(&self, spacing: f64) -> f64 {
        2.0 * self.beam.width * self.radius * (0.5 * spacing).sin()
    }

    /// Rows of increments 0 to `increments` of the sweep, equally spaced in the angle.
    ///
    /// # Errors
    /// As [`FirstProblem::rows`].
    pub fn rows(
        &self,
        mu: f64,
        increments: usize,
        reference: Reference,
    ) -> Result<Vec<SecondRow>, TheoryError> {
        self.stroke_rows(mu, increments, reference, Stroke::Push)
    }

    /// As [`SecondProblem::rows`], with the direction of sliding given. Row k of
    /// the return stroke is at the same angle as row k of the push.
    ///
    /// # Errors
    /// As [`FirstProblem::rows`].
    pub fn stroke_rows(
        &self,
        mu: f64,
        increments: usize,
        reference: Reference,
        direction: Stroke,
    ) -> Result<Vec<SecondRow>, TheoryError> {
        let row = |increment, time| {
            let ur3 = self.sweep * time;
            let found = self.equilibrium(ur3, mu, reference, direction)?;
            let rm3 = found.map_or(0.0, |e| self.moment(&e));
            let force = found.map_or(0.0, |e| e.force);
            Ok(SecondRow {
                increment,
                time,
                rm3,
                ur3,
                contact_length: found.map(|e| e.contact_length),
                force,
            })
        };
        each_increment(increments, row, |row| row.contact_length.is_some())
    }

    /// Equilibrium with the cam turned by `ur3` [rad] from its start; `None`
    /// if the circle is clear of the beam.
    ///
    /// # Errors
    /// Why the reference does not exist at this angle.
    pub fn equilibrium(
        &self,
        ur3: f64,
        mu: f64,
        reference: Reference,
        direction: Stroke,
    ) -> Result<Option<Equilibrium>, TheoryError> {
        self.beam.check()?;
        check_circle(self.radius, mu)?;
        check_positive(&[(self.arm, "the arm must be positive")])?;
        let frame = Frame::facing(&self.beam, self.centre(self.start_angle));
        // velocity, along the beam, of the point of the cam that touches it
        let turning = frame.handed * self.sweep.signum();
        let along = turning * frame.local(self.pivot)[1];
        let circle = Circle {
            centre: frame.local(self.centre(self.start_angle + ur3)),
            radius: self.radius,
        };
        let drag = mu * along.signum() * direction.sign();
        references::solve(&self.beam, &self.law, circle, drag, reference)
            .map(|found| found.map(|e| e.in_global(&frame)))
    }

    /// Driver's moment about the pivot [F L], right-handed. Diehl (1995) eq. (11):
    /// the moment of the contact force at the point of contact.
    pub fn moment(&self, equilibrium: &Equilibrium) -> f64 {
        let lever = [equilibrium.point[0] - self.pivot[0], equilibrium.point[1] - self.pivot[1]];
        lever[0] * equilibrium.reaction[1] - lever[1] * equilibrium.reaction[0]
    }
}

fn each_increment<R>(
    increments: usize,
    row: impl Fn(usize, f64) -> Result<R, TheoryError>,
    touches: impl Fn(&R) -> bool,
) -> Result<Vec<R>, TheoryError> {
    if increments == 0 {
        return Err(TheoryError::InvalidInput("at least one increment is needed"));
    }
    let at = |increment: usize| {
        row(increment, increment as f64 / increments as f64)
            .map_err(|reason| TheoryError::AtIncrement { increment, reason: Box::new(reason) })
    };
    let rows: Vec<R> = (0..=increments).map(at).collect::<Result<_, _>>()?;
    if rows.iter().any(touches) { Ok(rows) } else { Err(TheoryError::NeverTouches) }
}

fn check_circle(radius: f64, mu: f64) -> Result<(), TheoryError> {
    check_positive(&[(radius, "the radius must be positive")])?;
    if mu.is_finite() && mu >= 0.0 {
        Ok(())
    } else {
        Err(TheoryError::InvalidInput("the coefficient of friction must not be negative"))
    }
}
