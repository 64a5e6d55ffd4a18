//! What the elements of a block are made of.

use crate::node::Dof;
use slideline_mech::element::{BeamHeat, SpringLaw};
use slideline_mech::material::{Elastic, Material};
use slideline_mech::orientation::Orientations;
use slideline_mech::section::Shape;

/// Section and material of a block.
#[derive(Clone, Debug, PartialEq)]
pub enum Section {
    /// `*BEAM SECTION`.
    Beam(BeamSection),
    /// `*SPRING`, `*GAP`.
    Spring(SpringSection),
    /// `*SOLID SECTION`.
    Solid(SolidSection),
    /// Numbers for an element type that somebody else has defined; what they mean is
    /// his.
    Properties(Vec<f64>),
}

impl Section {
    /// Its elasticity at small strain; `None`: it has none.
    pub fn elastic(&self) -> Option<Elastic> {
        match self {
            Self::Beam(section) => Some(section.material),
            Self::Solid(section) => section.material.elastic(),
            Self::Spring(_) | Self::Properties(_) => None,
        }
    }

    /// By which factor all stresses of another section are those of this one at the same strains,
    /// where that is all that differs: by that of the modulus.
    pub fn stresses_of(&self, other: &Self) -> Option<f64> {
        let (own, other) = match (self, other) {
            (Self::Beam(own), Self::Beam(other)) => own.but_for_elasticity(other)?,
            (Self::Solid(own), Self::Solid(other)) => own.but_for_elasticity(other)?,
            _ => return None,
        };
        (own.poisson == other.poisson && own.modulus > 0.0).then(|| other.modulus / own.modulus)
    }
}

impl BeamSection {
    /// Both elasticities, where nothing else differs and all stiffness comes of them.
    fn but_for_elasticity(&self, other: &Self) -> Option<(Elastic, Elastic)> {
        let ShearRule { stiffness, across, .. } = self.shear;
        let of_elasticity = stiffness.is_none() && across.is_none() && self.heat.is_none();
        let alike = of_elasticity && Self { material: self.material, ..other.clone() } == *self;
        alike.then_some((self.material, other.material))
    }
}

impl SolidSection {
    /// The same.
    fn but_for_elasticity(&self, other: &Self) -> Option<(Elastic, Elastic)> {
        let alike = self.thickness == other.thickness && self.orientation == other.orientation;
        match (&self.material, &other.material) {
            (Material::Elastic(own, way), Material::Elastic(others, of_other)) => {
                (alike && way == of_other).then_some((*own, *others))
            }
            _ => None,
        }
    }
}

/// A section of an elastic material.
#[derive(Clone, Debug, PartialEq)]
pub struct BeamSection {
    /// Its shape.
    pub shape: Shape,
    /// Section Poisson ratio [1]; read, stated, and kept out of the energy.
    pub poisson: f64,
    /// Material.
    pub material: Elastic,
    /// What temperature does to it; `None`: nothing.
    pub heat: Option<Box<BeamHeat>>,
    /// Transverse shear.
    pub shear: ShearRule,
    /// Direction of the section's axis 1, as far as it is across the axis of the beam; of no
    /// meaning in the plane.
    pub first_axis: [f64; 3],
}

impl BeamSection {
    /// Axis 1 where a deck does not say: out of the plane of x and y.
    pub const FIRST_AXIS: [f64; 3] = [0.0, 0.0, -1.0];
}

/// How the transverse shear stiffness is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShearRule {
    /// `K23` of `*TRANSVERSE SHEAR STIFFNESS` [F]; default k G A.
    pub stiffness: Option<f64>,
    /// `K13`, out of the plane [F]; default k G A.
    pub across: Option<f64>,
    /// Slenderness compensation factor SCF [1]; default 0.25.
    pub slenderness_compensation: f64,
}

impl Default for ShearRule {
    fn default() -> Self {
        Self { stiffness: None, across: None, slenderness_compensation: 0.25 }
    }
}

/// Springs of one law.
#[derive(Clone, Debug, PartialEq)]
pub struct SpringSection {
    /// Force by relative displacement.
    pub law: SpringLaw,
    /// Which displacement that is.
    pub way: SpringWay,
}

/// What a spring resists.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SpringWay {
    /// A dof of its node, or of one node relative to the other (`SPRING1`, `SPRING2`).
    Dof(Dof),
    /// The distance of its nodes (`SPRINGA`), in the plane or in space.
    Line {
        /// Whether the nodes move in space.
        in_space: bool,
    },
    /// The distance of its nodes along a direction that stays (`GAPUNI`).
    Direction {
        /// Unit vector from the first to the second node; `None`: the line between them before the
        /// first step.
        direction: Option<[f64; 3]>,
        /// Whether the nodes move in space.
        in_space: bool,
    },
    /// The distance of its nodes, which closes a gap (`GAPCYL`, `GAPSPHER`).
    Around {
        /// Unit vector across which the distance is taken; `None`: the distance itself.
        axis: Option<[f64; 3]>,
        /// Whether the gap closes where the nodes are too far apart, as a bar in a tube; else where
        /// they are too near.
        inside: bool,
        /// Distance at which it closes [L].
        radius: f64,
        /// Whether the nodes move in space.
        in_space: bool,
    },
}

impl SpringWay {
    /// Whether it acts between two nodes that move in space.
    pub fn is_in_space(&self) -> bool {
        match self {
            Self::Dof(_) => false,
            Self::Line { in_space }
            | Self::Direction { in_space, .. }
            | Self::Around { in_space, .. } => *in_space,
        }
    }
}

/// A solid of one material.
#[derive(Clone, Debug, PartialEq)]
pub struct SolidSection {
    /// Thickness out of the plane [L]; of no meaning in space.
    pub thickness: f64,
    /// Material.
    pub material: Material,
    /// Axes of the material; `None`: those of the model.
    pub orientation: Option<Orientations>,
}

#[cfg(test)]
mod tests {
    use super::*;
    use slideline_mech::material::LargeStrain;

    fn beam(modulus: f64, poisson: f64) -> BeamSection {
        BeamSection {
            shape: Shape::Rectangle { width: 25.0, height: 1.5 },
            poisson: 0.3,
            material: Elastic { modulus, poisson },
            heat: None,
            shear: ShearRule::default(),
            first_axis: BeamSection::FIRST_AXIS,
        }
    }

    /// Requirement: stresses of another modulus are the same by a factor, and nothing else is.
    #[test]
    fn stresses_follow_the_modulus_alone() {
        let own = Section::Beam(beam(6900.0, 0.3));
        let to = |other: BeamSection| own.stresses_of(&Section::Beam(other));
        assert_eq!(to(beam(13800.0, 0.3)), Some(2.0));
        assert_eq!(to(beam(13800.0, 0.31)), None);
        let thick = Shape::Rectangle { width: 25.0, height: 1.6 };
        assert_eq!(to(BeamSection { shape: thick, ..beam(13800.0, 0.3) }), None);
        let shear = ShearRule { stiffness: Some(1e4), ..ShearRule::default() };
        let given = |modulus| Section::Beam(BeamSection { shear, ..beam(modulus, 0.3) });
        assert_eq!(given(6900.0).stresses_of(&given(13800.0)), None);
        let solid = |modulus, thickness| {
            let elastic = Elastic { modulus, poisson: 0.3 };
            let material = Material::Elastic(elastic, LargeStrain::Logarithmic);
            Section::Solid(SolidSection { thickness, material, orientation: None })
        };
        assert_eq!(solid(2.0, 1.0).stresses_of(&solid(3.0, 1.0)), Some(1.5));
        assert_eq!(solid(2.0, 1.0).stresses_of(&solid(3.0, 1.1)), None);
        assert_eq!(own.stresses_of(&solid(3.0, 1.0)), None);
    }
}
