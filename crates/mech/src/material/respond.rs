//! What a material answers, whichever it is.

use super::answer::{Answer, Conditions};
use super::creep;
use super::elastic::{Elastic, LargeStrain};
use super::hyperelastic::Rubber;
use super::law::Material;
use super::plastic::{self, Plastic};
use super::prestressed::{self, parted};
use super::tensor::{Matrix, symmetric};
use super::viscoelastic::{self, Elasticity};

impl Material {
    /// Number of state variables of a point.
    pub fn states(&self) -> usize {
        match self {
            Self::Elastic(..)
            | Self::Anisotropic(..)
            | Self::Rubber(_)
            | Self::Foam(_)
            | Self::Fibrous(_)
            | Self::RambergOsgood(_) => 0,
            Self::Plastic(plastic) => plastic.states(),
            Self::User(law) => law.states(),
            Self::Graded(graded) => graded.rows().map(Self::states).max().unwrap_or(0),
            Self::Expanding(expanding) => expanding.law.states(),
            Self::Viscoelastic(own) => own.states(),
            Self::Creeping(_) => creep::STATES,
            Self::Prestressed(own) => prestressed::STATES + own.law.states(),
        }
    }

    /// Whether points of it may begin under stress.
    pub fn begins_under_stress(&self) -> bool {
        matches!(self, Self::Prestressed(_))
    }

    /// Whether its stress fades, or is somebody else's.
    pub fn relaxes(&self) -> bool {
        match self {
            Self::Viscoelastic(_) | Self::User(_) => true,
            Self::Expanding(own) => own.law.relaxes(),
            Self::Prestressed(own) => own.law.relaxes(),
            _ => false,
        }
    }

    /// Answers the displacement gradient H, linearised or not. Isotropic elasticity is told where it
    /// is asked, in the vectors of who asks.
    #[inline(always)]
    pub fn respond(
        &self,
        gradient: &Matrix,
        under: &Conditions,
        committed: &[f64],
        state: &mut [f64],
    ) -> Answer {
        match (self, under.large) {
            (Self::Elastic(elastic, LargeStrain::Logarithmic), true) => elastic.hencky(gradient),
            (Self::Elastic(elastic, LargeStrain::Green), true) => elastic.green(gradient),
            _ => self.respond_otherwise(gradient, under, (committed, state)),
        }
    }

    fn respond_otherwise(
        &self,
        gradient: &Matrix,
        under: &Conditions,
        (committed, state): (&[f64], &mut [f64]),
    ) -> Answer {
        match (self, under.large) {
            (Self::Elastic(elastic, _), _) => elastic.small(&symmetric(gradient)),
            (Self::Anisotropic(elastic, _), false) => elastic.small(&symmetric(gradient)),
            (Self::Anisotropic(elastic, LargeStrain::Logarithmic), true) => {
                elastic.hencky(gradient)
            }
            (Self::Anisotropic(elastic, LargeStrain::Green), true) => elastic.green(gradient),
            (Self::Rubber(rubber), false) => rubber.small().small(&symmetric(gradient)),
            (Self::Rubber(rubber), true) => rubber.large(gradient),
            (Self::Foam(foam), false) => foam.small().small(&symmetric(gradient)),
            (Self::Foam(foam), true) => foam.large(gradient),
            (Self::Fibrous(tissue), false) => tissue.small(&symmetric(gradient)),
            (Self::Fibrous(tissue), true) => tissue.large(gradient),
            (Self::RambergOsgood(metal), false) => metal.small(&symmetric(gradient)),
            (Self::RambergOsgood(metal), true) => metal.large(gradient),
            (Self::Plastic(plastic), false) => {
                plastic.small(&symmetric(gradient), committed, state)
            }
            (Self::Plastic(plastic), true) => plastic.large(gradient, committed, state),
            (Self::User(law), _) => law.respond(gradient, under, committed, state),
            (Self::Graded(graded), _) => graded
                .at(under.temperature, |own| own.respond(gradient, under, committed, state))
                .unwrap_or_default(),
            (Self::Expanding(own), _) => {
                own.respond(gradient, under, |left| own.law.respond(left, under, committed, state))
            }
            (Self::Viscoelastic(own), large) => own.law.of_temperature(under.temperature, |law| {
                let law = match law {
                    Self::Elastic(elastic, _) => Elasticity::Linear(elastic),
                    Self::Rubber(rubber) => Elasticity::Rubber(rubber),
                    _ => return Answer::default(),
                };
                own.respond(law, (gradient, large), under.clock.passed, (committed, state))
            }),
            (Self::Creeping(own), _) => own.metal.of_temperature(under.temperature, |metal| {
                let metal = match metal {
                    Self::Elastic(elastic, _) => (elastic, None),
                    Self::Plastic(plastic) => (&plastic.elastic, Some(plastic)),
                    _ => return Answer::default(),
                };
                own.respond(metal, gradient, under, (committed, state))
            }),
            (Self::Prestressed(own), _) => {
                let [first, rest] = parted(committed);
                let Some((kept, trial)) = state.split_at_mut_checked(first.len()) else {
                    return Answer::default();
                };
                kept.copy_from_slice(first);
                prestressed::respond(gradient, under, first, |all| {
                    own.law.respond(all, under, rest, trial)
                })
            }
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
            Self::Prestressed(own) => own.law.plastic_strain(parted(state)[1]),
            _ => None,
        }
    }

    /// Equivalent creep strain of a state [1]; `None`: it has none.
    pub fn creep_strain(&self, state: &[f64]) -> Option<f64> {
        match self {
            Self::Creeping(_) => creep::strain(state),
            Self::Expanding(expanding) => expanding.law.creep_strain(state),
            Self::Prestressed(own) => own.law.creep_strain(parted(state)[1]),
            _ => None,
        }
    }

    /// By how much the creep strains of the last increment differ where they are those of the stresses
    /// at its beginning, or at its end [1]; `None`: nothing of it takes time.
    pub fn creep_difference(&self, state: &[f64]) -> Option<f64> {
        match self {
            Self::Creeping(_) => creep::difference(state),
            Self::Viscoelastic(_) => viscoelastic::difference(state),
            Self::Expanding(expanding) => expanding.law.creep_difference(state),
            Self::Prestressed(own) => own.law.creep_difference(parted(state)[1]),
            _ => None,
        }
    }

    /// Whether it creeps.
    pub fn creeps(&self) -> bool {
        match self {
            Self::Creeping(_) => true,
            Self::Expanding(expanding) => expanding.law.creeps(),
            Self::Prestressed(own) => own.law.creeps(),
            _ => false,
        }
    }

    /// Whether time means something to it: it creeps or relaxes.
    pub fn takes_time(&self) -> bool {
        match self {
            Self::Creeping(_) | Self::Viscoelastic(_) => true,
            Self::Expanding(expanding) => expanding.law.takes_time(),
            Self::Prestressed(own) => own.law.takes_time(),
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
            Self::Prestressed(own) => own.law.metal(temperature),
            Self::Viscoelastic(_)
            | Self::Elastic(..)
            | Self::Anisotropic(..)
            | Self::Rubber(_)
            | Self::Foam(_)
            | Self::Fibrous(_)
            | Self::RambergOsgood(_)
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
            Self::Prestressed(own) => own.law.rubber(temperature, then),
            Self::Elastic(..)
            | Self::Anisotropic(..)
            | Self::Foam(_)
            | Self::Fibrous(_)
            | Self::RambergOsgood(_)
            | Self::Plastic(_)
            | Self::User(_)
            | Self::Creeping(_) => None,
        }
    }

    /// Whether it may take work that it does not give back.
    pub fn dissipates(&self) -> bool {
        match self {
            Self::Plastic(_) | Self::User(_) | Self::Viscoelastic(_) | Self::Creeping(_) => true,
            Self::Elastic(..)
            | Self::Anisotropic(..)
            | Self::Rubber(_)
            | Self::Foam(_)
            | Self::Fibrous(_)
            | Self::RambergOsgood(_) => false,
            Self::Graded(graded) => graded.rows().any(Self::dissipates),
            Self::Expanding(expanding) => expanding.law.dissipates(),
            Self::Prestressed(own) => own.law.dissipates(),
        }
    }

    /// Whether its stress is linear in its strain.
    pub fn is_linear(&self) -> bool {
        match self {
            Self::Elastic(..) | Self::Anisotropic(..) => true,
            Self::Plastic(_)
            | Self::User(_)
            | Self::Rubber(_)
            | Self::Foam(_)
            | Self::Fibrous(_)
            | Self::RambergOsgood(_)
            | Self::Viscoelastic(_)
            | Self::Prestressed(_)
            | Self::Creeping(_) => false,
            Self::Graded(graded) => graded.rows().all(Self::is_linear),
            Self::Expanding(expanding) => expanding.law.is_linear(),
        }
    }

    /// Volume of a free body over that of the cold one [1].
    pub fn thermal_volume(&self, under: &Conditions) -> f64 {
        match self {
            Self::Expanding(expanding) => expanding.volume(under),
            Self::Prestressed(own) => own.law.thermal_volume(under),
            _ => 1.0,
        }
    }

    /// A stiffness that bounds that of a stretch [F/L2].
    pub fn stiffest(&self) -> f64 {
        let of = |elastic: &Elastic| elastic.bulk_modulus() + 4.0 / 3.0 * elastic.shear_modulus();
        match self {
            Self::Elastic(elastic, _) | Self::Plastic(Plastic { elastic, .. }) => of(elastic),
            Self::RambergOsgood(metal) => of(&metal.elastic),
            Self::Fibrous(tissue) => tissue.stiffest(),
            Self::Foam(foam) => of(&foam.small()),
            Self::Anisotropic(elastic, _) => elastic.stiffest(),
            Self::Rubber(rubber) => rubber.bulk_modulus() + 4.0 / 3.0 * rubber.shear_modulus(),
            Self::User(law) => law.stiffest(),
            Self::Graded(graded) => graded.rows().map(Self::stiffest).fold(0.0, f64::max),
            Self::Expanding(expanding) => expanding.law.stiffest(),
            Self::Viscoelastic(own) => own.law.stiffest(),
            Self::Creeping(own) => own.metal.stiffest(),
            Self::Prestressed(own) => own.law.stiffest(),
        }
    }

    /// Shear modulus of small strains [F/L2]; without isotropy the mean of three.
    pub fn shear_modulus(&self) -> f64 {
        match self {
            Self::Elastic(elastic, _) | Self::Plastic(Plastic { elastic, .. }) => {
                elastic.shear_modulus()
            }
            Self::Anisotropic(elastic, _) => {
                (3..6).map(|k| elastic.moduli[k][k]).sum::<f64>() / 3.0
            }
            Self::Rubber(rubber) => rubber.shear_modulus(),
            Self::Foam(foam) => foam.shear_modulus(),
            Self::RambergOsgood(metal) => metal.elastic.shear_modulus(),
            Self::Fibrous(tissue) => tissue.small_matrix().shear_modulus(),
            Self::User(law) => law.shear_modulus(),
            Self::Graded(graded) => graded.rows().map(Self::shear_modulus).fold(0.0, f64::max),
            Self::Expanding(expanding) => expanding.law.shear_modulus(),
            Self::Viscoelastic(own) => own.law.shear_modulus(),
            Self::Creeping(own) => own.metal.shear_modulus(),
            Self::Prestressed(own) => own.law.shear_modulus(),
        }
    }

    /// Isotropic elasticity of small strains, where it has one; over temperature that of the
    /// lowest one.
    pub fn elastic(&self) -> Option<Elastic> {
        match self {
            Self::Elastic(elastic, _) | Self::Plastic(Plastic { elastic, .. }) => Some(*elastic),
            Self::Rubber(rubber) => Some(rubber.small()),
            Self::Foam(foam) => Some(foam.small()),
            Self::RambergOsgood(metal) => Some(metal.elastic),
            Self::Fibrous(tissue) => Some(tissue.small_matrix()),
            Self::Anisotropic(..) | Self::User(_) => None,
            Self::Graded(graded) => graded.rows().next()?.elastic(),
            Self::Expanding(expanding) => expanding.law.elastic(),
            Self::Viscoelastic(own) => own.law.elastic(),
            Self::Creeping(own) => own.metal.elastic(),
            Self::Prestressed(own) => own.law.elastic(),
        }
    }
}
