//! Materials: pure functions of a strain and a committed state.
//!
//! ```text
//!   displacement gradient H, committed state, conditions (kinematics, temperatures, time)
//!        |
//!        v      +--> stress      Cauchy's where strains are small, Kirchhoff's where large
//!     respond --+--> moduli      consistent with the trial state
//!        |      +--> trial state
//!        v
//!   energy, dissipation
//! ```
//!
//! All in three dimensions; plane stress and plane strain are the element's. Tensors are made by
//! hand; where a law is differentiated it is by three invariants or stretches at most. Moduli at
//! large strain: with C' = (1 + l)'(1 + l) the energy grows by tau:eps + eps:c:eps/2, eps = (C' -
//! 1)/2, docs/theory.md eq. (3.39).

mod back_stress;
pub mod creep;
mod elastic;
mod expansion;
mod graded;
pub mod hyperelastic;
mod logarithmic;
pub mod plastic;
mod principal;
pub mod tensor;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod time_tests;
mod uniaxial;
mod viscoelastic;

pub use back_stress::BackStress;
pub use creep::{CreepHardening, Creeping, PowerLaw};
pub use elastic::{Anisotropic, LargeStrain, Unsound};
pub(crate) use expansion::between;
pub use expansion::{Expanding, Expansion, Growth};
pub use graded::Graded;
pub use hyperelastic::{MOST_TERMS, Rubber, Volume};
pub use plastic::{Hardening, Plastic};
pub use principal::Axes;
pub use uniaxial::Uniaxial;
pub use viscoelastic::{Relaxation, Viscoelastic};

use std::fmt::Debug;
use std::sync::Arc;
use tensor::{Matrix, Moduli, Symmetric, symmetric};

/// Isotropic linear elasticity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elastic {
    /// Young's modulus E [F/L2].
    pub modulus: f64,
    /// Poisson's ratio nu [1].
    pub poisson: f64,
}

impl Elastic {
    /// Shear modulus G = E / 2(1 + nu) [F/L2]. [semantics: keywords, `*ELASTIC`]
    pub fn shear_modulus(&self) -> f64 {
        self.modulus / (2.0 * (1.0 + self.poisson))
    }

    /// Part of the way to another one, E and nu each.
    pub fn towards(&self, other: &Self, part: f64) -> Self {
        let number = |low: f64, high: f64| low + part * (high - low);
        Self {
            modulus: number(self.modulus, other.modulus),
            poisson: number(self.poisson, other.poisson),
        }
    }

    /// That of a shear modulus and a bulk modulus [F/L2].
    pub fn of_moduli(shear: f64, bulk: f64) -> Self {
        let modulus = 9.0 * bulk * shear / (3.0 * bulk + shear);
        Self { modulus, poisson: modulus / (2.0 * shear) - 1.0 }
    }

    /// Bulk modulus K = E / 3(1 - 2 nu) [F/L2].
    pub fn bulk_modulus(&self) -> f64 {
        self.modulus / (3.0 * (1.0 - 2.0 * self.poisson))
    }
}

/// What a material answers under.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Conditions {
    /// Whether strains are not linearised.
    pub large: bool,
    /// Temperature [theta].
    pub temperature: f64,
    /// Temperature before the first step, at which it is free of stress [theta].
    pub initial: f64,
    /// What the clock shows.
    pub clock: Clock,
}

/// What a clock shows to a material.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Clock {
    /// Time that passes on the way from the committed state [T]: zero for instantaneous, infinite
    /// for long-term behaviour.
    pub passed: f64,
    /// Total time at the end of that way [T].
    pub total: f64,
}

/// What a material answers.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Answer {
    /// Cauchy stress where strains are small, Kirchhoff stress where large [F/L2].
    pub stress: Symmetric,
    /// Its moduli [F/L2].
    pub moduli: Moduli,
    /// Work done on the undeformed volume so far, dissipation included [F/L2].
    pub energy: f64,
    /// The part of it that is not given back [F/L2].
    pub dissipation: f64,
}

/// A material that somebody else has written.
pub trait Law: Debug + Send + Sync {
    /// Number of state variables of a point.
    fn states(&self) -> usize;

    /// Answers the displacement gradient H.
    fn respond(
        &self,
        gradient: &Matrix,
        under: &Conditions,
        committed: &[f64],
        state: &mut [f64],
    ) -> Answer;

    /// A stiffness that bounds that of a stretch [F/L2], for the rounding floor of residuals.
    fn stiffest(&self) -> f64;

    /// Shear modulus of small strains [F/L2].
    fn shear_modulus(&self) -> f64;
}

/// A material of solids.
#[derive(Debug, Clone)]
pub enum Material {
    /// Linear elasticity.
    Elastic(Elastic, LargeStrain),
    /// Linear elasticity without isotropy.
    Anisotropic(Box<Anisotropic>),
    /// Rubber.
    Rubber(Rubber),
    /// Metal that yields.
    Plastic(Plastic),
    /// Somebody else's.
    User(Arc<dyn Law>),
    /// With constants over temperature.
    Graded(Arc<Graded>),
    /// One that expands.
    Expanding(Box<Expanding>),
    /// One that relaxes.
    Viscoelastic(Box<Viscoelastic>),
    /// One that creeps.
    Creeping(Box<Creeping>),
}

impl PartialEq for Material {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Elastic(a, large), Self::Elastic(b, other)) => a == b && large == other,
            (Self::Anisotropic(a), Self::Anisotropic(b)) => a == b,
            (Self::Rubber(a), Self::Rubber(b)) => a == b,
            (Self::Plastic(a), Self::Plastic(b)) => a == b,
            (Self::User(a), Self::User(b)) => Arc::ptr_eq(a, b),
            (Self::Graded(a), Self::Graded(b)) => a == b,
            (Self::Expanding(a), Self::Expanding(b)) => a == b,
            (Self::Viscoelastic(a), Self::Viscoelastic(b)) => a == b,
            (Self::Creeping(a), Self::Creeping(b)) => a == b,
            _ => false,
        }
    }
}

impl Material {
    /// Number of state variables of a point.
    pub fn states(&self) -> usize {
        match self {
            Self::Elastic(..) | Self::Anisotropic(_) | Self::Rubber(_) => 0,
            Self::Plastic(plastic) => plastic.states(),
            Self::User(law) => law.states(),
            Self::Graded(graded) => graded.rows().map(Self::states).max().unwrap_or(0),
            Self::Expanding(expanding) => expanding.law.states(),
            Self::Viscoelastic(own) => own.states(),
            Self::Creeping(_) => creep::STATES,
        }
    }

    /// Answers the displacement gradient H, linearised or not.
    pub fn respond(
        &self,
        gradient: &Matrix,
        under: &Conditions,
        committed: &[f64],
        state: &mut [f64],
    ) -> Answer {
        match (self, under.large) {
            (Self::Elastic(elastic, _), false) => elastic.small(&symmetric(gradient)),
            (Self::Elastic(elastic, LargeStrain::Logarithmic), true) => elastic.hencky(gradient),
            (Self::Elastic(elastic, LargeStrain::Green), true) => elastic.green(gradient),
            (Self::Anisotropic(elastic), false) => elastic.small(&symmetric(gradient)),
            (Self::Anisotropic(elastic), true) => elastic.green(gradient),
            (Self::Rubber(rubber), false) => rubber.small().small(&symmetric(gradient)),
            (Self::Rubber(rubber), true) => rubber.large(gradient),
            (Self::Plastic(plastic), false) => {
                plastic.small(&symmetric(gradient), committed, state)
            }
            (Self::Plastic(plastic), true) => plastic.large(gradient, committed, state),
            (Self::User(law), _) => law.respond(gradient, under, committed, state),
            (Self::Graded(graded), _) => graded
                .at(under.temperature, |own| own.respond(gradient, under, committed, state))
                .unwrap_or_default(),
            (Self::Expanding(own), _) => own.respond(gradient, under, committed, state),
            (Self::Viscoelastic(own), large) => own.law.of_temperature(under.temperature, |law| {
                own.respond(law, (gradient, large), under.clock.passed, (committed, state))
            }),
            (Self::Creeping(own), _) => own.metal.of_temperature(under.temperature, |metal| {
                own.respond(metal, gradient, under, (committed, state))
            }),
        }
    }

    /// Whatever is made of the material with its constants at a temperature.
    fn of_temperature<R: Default>(&self, temperature: f64, then: impl FnOnce(&Self) -> R) -> R {
        match self {
            Self::Graded(graded) => graded.at(temperature, then).unwrap_or_default(),
            only => then(only),
        }
    }

    /// H33 of a sheet with no stress across, where it follows from the gradient in the plane.
    pub fn across(&self, gradient: &Matrix, large: bool) -> Option<f64> {
        let Self::Elastic(elastic, strain) = self else { return None };
        Some(elastic.across(gradient, large.then_some(*strain))).filter(|across| across.is_finite())
    }

    /// Equivalent plastic strain of a state [1]; `None`: it has none.
    pub fn plastic_strain(&self, state: &[f64]) -> Option<f64> {
        match self {
            Self::Plastic(_) => state.get(plastic::PEEQ).copied(),
            Self::Graded(graded) => graded.rows().next()?.plastic_strain(state),
            Self::Expanding(expanding) => expanding.law.plastic_strain(state),
            Self::Creeping(_) => state.get(plastic::PEEQ).copied(),
            _ => None,
        }
    }

    /// Equivalent creep strain of a state [1]; `None`: it has none.
    pub fn creep_strain(&self, state: &[f64]) -> Option<f64> {
        match self {
            Self::Creeping(_) => Creeping::strain(state),
            Self::Expanding(expanding) => expanding.law.creep_strain(state),
            _ => None,
        }
    }

    /// By how much the creep strains of the last increment differ where they are those of the stresses
    /// at its beginning, or at its end [1]; `None`: nothing of it takes time.
    pub fn creep_difference(&self, state: &[f64]) -> Option<f64> {
        match self {
            Self::Creeping(_) => Creeping::difference(state),
            Self::Viscoelastic(_) => Viscoelastic::difference(state),
            Self::Expanding(expanding) => expanding.law.creep_difference(state),
            _ => None,
        }
    }

    /// Whether it creeps.
    pub fn creeps(&self) -> bool {
        match self {
            Self::Creeping(_) => true,
            Self::Expanding(expanding) => expanding.law.creeps(),
            _ => false,
        }
    }

    /// Whether time means something to it: it creeps or relaxes.
    pub fn takes_time(&self) -> bool {
        match self {
            Self::Creeping(_) | Self::Viscoelastic(_) => true,
            Self::Expanding(expanding) => expanding.law.takes_time(),
            _ => false,
        }
    }

    /// Elasticity of a metal at a temperature; `None`: it is none.
    pub fn metal(&self, temperature: f64) -> Option<Elastic> {
        match self {
            Self::Plastic(plastic) => Some(plastic.elastic),
            Self::Graded(graded) => graded.at(temperature, |own| own.metal(temperature)).flatten(),
            Self::Expanding(expanding) => expanding.law.metal(temperature),
            Self::Creeping(own) => own.metal.of_temperature(temperature, Self::elastic),
            Self::Viscoelastic(_)
            | Self::Elastic(..)
            | Self::Anisotropic(_)
            | Self::Rubber(_)
            | Self::User(_) => None,
        }
    }

    /// Whatever is made of its rubber at a temperature; `None`: it is none.
    pub fn rubber<R>(&self, temperature: f64, then: impl FnOnce(&Rubber) -> R) -> Option<R> {
        match self {
            Self::Rubber(rubber) => Some(then(rubber)),
            Self::Graded(graded) => graded
                .at(temperature, |own| match own {
                    Self::Rubber(rubber) => Some(then(rubber)),
                    _ => None,
                })
                .flatten(),
            Self::Expanding(expanding) => expanding.law.rubber(temperature, then),
            Self::Viscoelastic(own) => own.law.rubber(temperature, then),
            Self::Elastic(..)
            | Self::Anisotropic(_)
            | Self::Plastic(_)
            | Self::User(_)
            | Self::Creeping(_) => None,
        }
    }

    /// Whether it may take work that it does not give back.
    pub fn dissipates(&self) -> bool {
        match self {
            Self::Plastic(_) | Self::User(_) | Self::Viscoelastic(_) | Self::Creeping(_) => true,
            Self::Elastic(..) | Self::Anisotropic(_) | Self::Rubber(_) => false,
            Self::Graded(graded) => graded.rows().any(Self::dissipates),
            Self::Expanding(expanding) => expanding.law.dissipates(),
        }
    }

    /// Whether its stress is linear in its strain.
    pub fn is_linear(&self) -> bool {
        match self {
            Self::Elastic(..) | Self::Anisotropic(_) => true,
            Self::Plastic(_)
            | Self::User(_)
            | Self::Rubber(_)
            | Self::Viscoelastic(_)
            | Self::Creeping(_) => false,
            Self::Graded(graded) => graded.rows().all(Self::is_linear),
            Self::Expanding(expanding) => expanding.law.is_linear(),
        }
    }

    /// Volume of a free body over that of the cold one [1].
    pub fn thermal_volume(&self, under: &Conditions) -> f64 {
        match self {
            Self::Expanding(expanding) => expanding.volume(under),
            _ => 1.0,
        }
    }

    /// A stiffness that bounds that of a stretch [F/L2].
    pub fn stiffest(&self) -> f64 {
        let of = |elastic: &Elastic| elastic.bulk_modulus() + 4.0 / 3.0 * elastic.shear_modulus();
        match self {
            Self::Elastic(elastic, _) | Self::Plastic(Plastic { elastic, .. }) => of(elastic),
            Self::Anisotropic(elastic) => elastic.stiffest(),
            Self::Rubber(rubber) => rubber.bulk_modulus() + 4.0 / 3.0 * rubber.shear_modulus(),
            Self::User(law) => law.stiffest(),
            Self::Graded(graded) => graded.rows().map(Self::stiffest).fold(0.0, f64::max),
            Self::Expanding(expanding) => expanding.law.stiffest(),
            Self::Viscoelastic(own) => own.law.stiffest(),
            Self::Creeping(own) => own.metal.stiffest(),
        }
    }

    /// Shear modulus of small strains [F/L2]; without isotropy the mean of three.
    pub fn shear_modulus(&self) -> f64 {
        match self {
            Self::Elastic(elastic, _) | Self::Plastic(Plastic { elastic, .. }) => {
                elastic.shear_modulus()
            }
            Self::Anisotropic(elastic) => (3..6).map(|k| elastic.moduli[k][k]).sum::<f64>() / 3.0,
            Self::Rubber(rubber) => rubber.shear_modulus(),
            Self::User(law) => law.shear_modulus(),
            Self::Graded(graded) => graded.rows().map(Self::shear_modulus).fold(0.0, f64::max),
            Self::Expanding(expanding) => expanding.law.shear_modulus(),
            Self::Viscoelastic(own) => own.law.shear_modulus(),
            Self::Creeping(own) => own.metal.shear_modulus(),
        }
    }

    /// Isotropic elasticity of small strains, where it has one; over temperature that of the
    /// lowest one.
    pub fn elastic(&self) -> Option<Elastic> {
        match self {
            Self::Elastic(elastic, _) | Self::Plastic(Plastic { elastic, .. }) => Some(*elastic),
            Self::Rubber(rubber) => Some(rubber.small()),
            Self::Anisotropic(_) | Self::User(_) => None,
            Self::Graded(graded) => graded.rows().next()?.elastic(),
            Self::Expanding(expanding) => expanding.law.elastic(),
            Self::Viscoelastic(own) => own.law.elastic(),
            Self::Creeping(own) => own.metal.elastic(),
        }
    }
}

impl Rubber {
    /// Elasticity of small strains.
    pub fn small(&self) -> Elastic {
        Elastic::of_moduli(self.shear_modulus(), self.bulk_modulus())
    }
}
