//! Deck of the second problem: a cam turned into a cantilever.
//!
//! ```text
//!            o 9999, turns
//!             \ arm
//!             (O)
//!   |============------ beam
//! ```

use std::fmt::Write as _;

/// The second problem's deck with the project's dimensions: contact elements
/// on the cam, slide line on the beam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cam {
    /// Equal increments of the turn.
    pub increments: usize,
    /// Coefficient of friction [1].
    pub mu: f64,
    /// Friction onset.
    pub onset: &'static str,
    /// Distance of the slave nodes on the cam [degree].
    pub spacing: f64,
}

impl Cam {
    /// Label of the pivot.
    pub const PIVOT: u64 = 9999;

    /// The deck.
    pub fn deck(&self) -> String {
        let mut text = String::from("*HEADING\ncam on a cantilever\n*NODE, NSET=BEAM\n");
        let _ = writeln!(text, "1, 0.0, 0.0\n25, 50.0E-3, 0.0\n*NGEN, NSET=BEAM\n1, 25, 1\n*NODE");
        let slaves = (72.0 / self.spacing).round() as usize;
        let (pivot, phi) = ([30.0e-3, 17.0e-3], 40f64.to_radians());
        let centre = [pivot[0] + 10.0e-3 * phi.sin(), pivot[1] - 10.0e-3 * phi.cos()];
        for j in 0..=slaves {
            // from the arm's direction, counter-clockwise
            let angle = phi + (-45.0 + self.spacing * j as f64).to_radians();
            let [x, y] = [centre[0] + 9.0e-3 * angle.sin(), centre[1] - 9.0e-3 * angle.cos()];
            let _ = writeln!(text, "{}, {x:?}, {y:?}", 9000 + j);
        }
        let _ = writeln!(
            text,
            "9999, 30.0E-3, 17.0E-3\n*NSET, NSET=CAM, GENERATE\n9000, {last}, 1\n\
             *ELEMENT, TYPE=B21, ELSET=BEAM\n101, 1, 2\n*ELGEN, ELSET=BEAM\n101, 24, 1, 1\n\
             *BEAM SECTION, ELSET=BEAM, SECTION=RECT, MATERIAL=POLYCARB\n25.0E-3, 1.5E-3\n\
             *MATERIAL, NAME=POLYCARB\n*ELASTIC\n6.9E9, 0.3\n*MPC\nBEAM, CAM, 9999\n\
             *ELEMENT, TYPE=ISL21, ELSET=ISL\n9901, 9000, 9001\n\
             *ELGEN, ELSET=ISL\n9901, {slaves}, 1, 1\n\
             *SLIDE LINE, TYPE=LINEAR, ELSET=ISL, SMOOTH=0.25, GENERATE\n2, 25, 1\n\
             *INTERFACE, ELSET=ISL\n25.0E-3\n*FRICTION\n{mu:?}\n\
             *SURFACE CONTACT, SOFTENED\n1.0E-5, 4.8E6\n\
             *CONTACT CONTROLS, FRICTION ONSET={onset}\n\
             *STEP, NLGEOM, INC=100000\n*STATIC\n{dt:?}, 1.0, 1.0E-6, {dt:?}\n*BOUNDARY\n\
             1, 1, 6\n9999, 1, 2\n9999, 6, 6, {turn:?}\n\
             *CONTROLS, ANALYSIS=DISCONTINUOUS\n*END STEP",
            last = 9000 + slaves,
            mu = self.mu,
            onset = self.onset,
            dt = 1.0 / self.increments as f64,
            turn = -60f64.to_radians(),
        );
        text
    }
}
