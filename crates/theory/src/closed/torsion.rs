//! A round bar of rubber, twisted between plates that keep their distance.
//!
//! ```text
//!    ____
//!   (____)  angle psi l, torque M, force N     every section turns, none warps
//!   |    |
//!   |    |  l, radius a
//!   (____)
//! ```

use std::f64::consts::PI;

/// An incompressible bar of Mooney's energy C10 (I1 - 3) + C01 (I2 - 3).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RubberBar {
    /// Radius a [L].
    pub radius: f64,
    /// C10 [F/L2].
    pub c10: f64,
    /// C01 [F/L2].
    pub c01: f64,
}

impl RubberBar {
    /// Torque M [F L] at the twist `psi` [1/L]: pi psi a^4 (C10 + C01). [rivlin1949]
    pub fn torque(&self, psi: f64) -> f64 {
        PI * psi * self.radius.powi(4) * (self.c10 + self.c01)
    }

    /// Force N of the plates along the axis [F], negative: the bar pushes them apart, - pi/2 psi^2
    /// a^4 (C10 + 2 C01). [rivlin1949]
    pub fn force(&self, psi: f64) -> f64 {
        -0.5 * PI * psi * psi * self.radius.powi(4) * (self.c10 + 2.0 * self.c01)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: both follow from the energy of bars that are twisted and stretched by l at
    /// constant volume: I1 = l^2 + 2/l + s/l, I2 = 2 l + 1/l^2 + s/l^2, s = psi^2 R^2 with the
    /// twist per undeformed length times l, so that dW/dpsi is the torque and dW/dl the force at l
    /// = 1 under a fixed turn. Tolerance: that of central differences.
    #[test]
    fn derivatives_of_the_energy() {
        let bar = RubberBar { radius: 1.3, c10: 0.4, c01: 0.1 };
        // turn by unit of undeformed length; (R turn)^2/l and /l^2: C = F'F of r = R/sqrt l
        let energy = |stretch: f64, turn: f64| {
            let (a2, a4) = (bar.radius.powi(2), bar.radius.powi(4));
            let first = (stretch * stretch + 2.0 / stretch - 3.0) * a2 / 2.0
                + turn * turn / stretch * a4 / 4.0;
            let second = (2.0 * stretch + 1.0 / (stretch * stretch) - 3.0) * a2 / 2.0
                + turn * turn / (stretch * stretch) * a4 / 4.0;
            2.0 * PI * (bar.c10 * first + bar.c01 * second)
        };
        let (turn, step) = (0.7, 1e-5);
        let torque = (energy(1.0, turn + step) - energy(1.0, turn - step)) / (2.0 * step);
        let force = (energy(1.0 + step, turn) - energy(1.0 - step, turn)) / (2.0 * step);
        assert!((torque - bar.torque(turn)).abs() < 1e-8, "{torque}");
        assert!((force - bar.force(turn)).abs() < 1e-8, "{force}");
    }
}
