//! A material: one of the laws, with constants of one temperature or of several.

use super::answer::Law;
use super::creep::Creeping;
use super::elastic::{Anisotropic, Elastic, LargeStrain};
use super::expansion::Expanding;
use super::fibrous::Fibrous;
use super::foam::Foam;
use super::hyperelastic::Rubber;
use super::plastic::Plastic;
use super::prestressed::Prestressed;
use super::ramberg_osgood::RambergOsgood;
use super::viscoelastic::Viscoelastic;
use std::sync::Arc;

/// A material of solids.
#[derive(Debug, Clone)]
pub enum Material {
    /// Linear elasticity.
    Elastic(Elastic, LargeStrain),
    /// Linear elasticity without isotropy.
    Anisotropic(Box<Anisotropic>, LargeStrain),
    /// Rubber.
    Rubber(Rubber),
    /// Foam of rubber.
    Foam(Foam),
    /// Soft tissue with fibres.
    Fibrous(Box<Fibrous>),
    /// Metal by deformation plasticity.
    RambergOsgood(Box<RambergOsgood>),
    /// Metal that yields.
    Plastic(Plastic),
    /// Somebody else's.
    User(Arc<dyn Law>),
    /// With constants over temperature.
    Graded(Arc<Graded>),
    /// One that expands.
    Expanding(Box<Expanding<Material>>),
    /// One that relaxes.
    Viscoelastic(Box<Viscoelastic<Material>>),
    /// One that creeps.
    Creeping(Box<Creeping<Material>>),
    /// One that is under stress before it deforms.
    Prestressed(Box<Prestressed<Material>>),
}

impl PartialEq for Material {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Elastic(a, large), Self::Elastic(b, other)) => a == b && large == other,
            (Self::Anisotropic(a, large), Self::Anisotropic(b, other)) => a == b && large == other,
            (Self::Rubber(a), Self::Rubber(b)) => a == b,
            (Self::Foam(a), Self::Foam(b)) => a == b,
            (Self::Fibrous(a), Self::Fibrous(b)) => a == b,
            (Self::RambergOsgood(a), Self::RambergOsgood(b)) => a == b,
            (Self::Plastic(a), Self::Plastic(b)) => a == b,
            (Self::User(a), Self::User(b)) => Arc::ptr_eq(a, b),
            (Self::Graded(a), Self::Graded(b)) => a == b,
            (Self::Expanding(a), Self::Expanding(b)) => a == b,
            (Self::Viscoelastic(a), Self::Viscoelastic(b)) => a == b,
            (Self::Creeping(a), Self::Creeping(b)) => a == b,
            (Self::Prestressed(a), Self::Prestressed(b)) => a == b,
            _ => false,
        }
    }
}

/// One law with the constants of several temperatures; yield stresses of all at the same strains.
/// Yield surfaces that move have one temperature.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Graded(pub(super) Vec<(f64, Material)>);
