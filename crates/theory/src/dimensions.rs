//! Dimensions of the two problems by name, for those who change one.

use crate::cantilever::Cantilever;
use crate::problem::{FirstProblem, SecondProblem};
use crate::softened_law::ExponentialLaw;

/// Names of the dimensions that both problems have.
const COMMON: &[&str] = &[
    "base-x",
    "base-y",
    "tip-x",
    "tip-y",
    "width",
    "thickness",
    "modulus",
    "poisson",
    "shear-factor",
    "clearance",
    "pressure",
    "radius",
];

impl Cantilever {
    fn dimension(&mut self, name: &str) -> Option<&mut f64> {
        Some(match name {
            "base-x" => &mut self.base[0],
            "base-y" => &mut self.base[1],
            "tip-x" => &mut self.tip[0],
            "tip-y" => &mut self.tip[1],
            "width" => &mut self.width,
            "thickness" => &mut self.thickness,
            "modulus" => &mut self.modulus,
            "poisson" => &mut self.poisson,
            "shear-factor" => &mut self.shear_factor,
            _ => return None,
        })
    }
}

impl ExponentialLaw {
    fn dimension(&mut self, name: &str) -> Option<&mut f64> {
        match name {
            "clearance" => Some(&mut self.clearance),
            "pressure" => Some(&mut self.pressure),
            _ => None,
        }
    }
}

impl FirstProblem {
    /// Names of the dimensions that [`FirstProblem::dimension`] knows.
    pub fn dimensions() -> Vec<&'static str> {
        [COMMON, &["circle-x", "start-y", "travel"]].concat()
    }

    /// The dimension of that name, in the units of the problem; `None` if there is none.
    pub fn dimension(&mut self, name: &str) -> Option<&mut f64> {
        match name {
            "radius" => Some(&mut self.radius),
            "circle-x" => Some(&mut self.circle_x),
            "start-y" => Some(&mut self.start_y),
            "travel" => Some(&mut self.stroke),
            _ => self.beam.dimension(name).or_else(|| self.law.dimension(name)),
        }
    }
}

impl SecondProblem {
    /// Names of the dimensions that [`SecondProblem::dimension`] knows.
    pub fn dimensions() -> Vec<&'static str> {
        [COMMON, &["pivot-x", "pivot-y", "arm", "start-angle", "sweep"]].concat()
    }

    /// The dimension of that name, in the units of the problem (angles in radians); `None` if
    /// there is none.
    pub fn dimension(&mut self, name: &str) -> Option<&mut f64> {
        match name {
            "radius" => Some(&mut self.radius),
            "pivot-x" => Some(&mut self.pivot[0]),
            "pivot-y" => Some(&mut self.pivot[1]),
            "arm" => Some(&mut self.arm),
            "start-angle" => Some(&mut self.start_angle),
            "sweep" => Some(&mut self.sweep),
            _ => self.beam.dimension(name).or_else(|| self.law.dimension(name)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: every name that is offered names one dimension of its own.
    #[test]
    fn every_name_is_known() {
        let (mut first, mut second) = (FirstProblem::diehl(), SecondProblem::project());
        for (k, name) in FirstProblem::dimensions().iter().enumerate() {
            *first.dimension(name).unwrap() = k as f64 + 0.5;
        }
        for (k, name) in FirstProblem::dimensions().iter().enumerate() {
            assert_eq!(*first.dimension(name).unwrap(), k as f64 + 0.5, "{name}");
        }
        for (k, name) in SecondProblem::dimensions().iter().enumerate() {
            *second.dimension(name).unwrap() = k as f64 + 0.5;
        }
        for (k, name) in SecondProblem::dimensions().iter().enumerate() {
            assert_eq!(*second.dimension(name).unwrap(), k as f64 + 0.5, "{name}");
        }
        assert!(first.dimension("pivot-x").is_none() && second.dimension("travel").is_none());
    }
}
