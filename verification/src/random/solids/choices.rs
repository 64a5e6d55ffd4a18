//! What classes of solids choose alike: elements, materials, laws, increments.

use super::draft::{Draft, Material, World};
use super::mesh::{Kind, PLANE_STRAIN, PLANE_STRESS, RINGS, SPACE};
use crate::random::Sequence;
use crate::random::classes::{Friction, Normal, Stick};

/// Types of element of a model.
pub(super) fn kinds(world: World, s: &mut Sequence) -> &'static [Kind] {
    match world {
        World::Plane => s.one_of(&[&PLANE_STRAIN as &[Kind], &PLANE_STRESS]),
        World::Rings => &RINGS,
        World::Space => &SPACE,
    }
}

/// What a part is made of.
pub(super) fn material(kind: Kind, s: &mut Sequence) -> Material {
    let modulus = s.power(-0.7, 0.7);
    let plane_stress = kind.name.starts_with("CPS");
    match s.below(6) {
        0 if !plane_stress => {
            let shear = modulus / 3.0;
            Material::Rubber(shear, shear * s.power(0.5, 1.5))
        }
        1 => {
            let yields = modulus * s.power(-2.3, -1.3);
            Material::Plastic(modulus, s.between(0.2, 0.4), yields, modulus * s.power(-2.0, -1.0))
        }
        _ => Material::Elastic(modulus, s.between(0.0, 0.42)),
    }
}

/// Modulus at small strain.
pub(super) fn stiffness(material: Material) -> f64 {
    match material {
        Material::Elastic(modulus, _) | Material::Plastic(modulus, ..) => modulus,
        Material::Rubber(shear, bulk) => 9.0 * bulk * shear / (3.0 * bulk + shear),
    }
}

/// Pressure and friction; `most` is the largest coefficient.
pub(super) fn laws(draft: &mut Draft, most: f64, s: &mut Sequence) {
    let modulus = draft.parts.iter().map(|part| stiffness(part.1)).fold(f64::MAX, f64::min);
    let clearance = s.power(-3.5, -2.3);
    draft.normal = match s.below(4) {
        0 => Normal::Exponential(clearance, modulus * s.power(-3.0, -1.7)),
        1 => Normal::Linear(modulus * s.power(1.0, 2.5)),
        _ => Normal::Hard,
    };
    let mu = if s.below(4) == 0 { 0.0 } else { s.between(0.03, most) };
    let stick = match s.below(6) {
        0 => Stick::Lagrange,
        1 => Stick::ElasticSlip(s.power(-4.0, -3.0)),
        2 => Stick::Limit(modulus * s.power(-3.0, -1.0)),
        _ => Stick::Default,
    };
    draft.friction = Friction { mu, stick };
}

pub(super) fn increments(s: &mut Sequence) -> [f64; 3] {
    s.one_of(&[[0.1, 1e-6, 0.1], [0.05, 1e-7, 0.2], [0.25, 1e-7, 0.25], [0.02, 1e-7, 0.1]])
}
