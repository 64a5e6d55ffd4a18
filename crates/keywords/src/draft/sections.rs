//! Sections and materials: what elements are made of.

use slideline_diag::Span;
use slideline_mech::material::{Anisotropic, Elastic, Hardening, LargeStrain, Plastic, Rubber};
use slideline_mech::orientation::Orientation;
use slideline_model::{self as model, BeamSection, Dialect, Limit, Shape, ShearRule, SolidSection};

use crate::test_data::{Test, Wanted};

#[derive(Clone, Debug)]
pub(crate) struct Section {
    pub set: String,
    pub material: String,
    pub material_span: Span,
    pub set_span: Span,
    pub body: Body,
    /// The axes of its material by name.
    pub orientation: Option<(String, Span)>,
    pub origin: Span,
}

/// What a section says of the body around its nodes.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Body {
    /// Its elasticity is its own in a `*BEAM GENERAL SECTION`, else that of the material.
    Beam {
        shape: Shape,
        poisson: f64,
        shear: ShearRule,
        elastic: Option<Elastic>,
    },
    Solid {
        thickness: f64,
    },
}

impl Body {
    /// The card that gives it.
    pub fn card(self) -> &'static str {
        match self {
            Self::Beam { .. } => "*BEAM SECTION",
            Self::Solid { .. } => "*SOLID SECTION",
        }
    }

    /// The same with a material; `None` where a beam is given another than an isotropic elastic one.
    pub fn of(
        self,
        material: &Material,
        orientation: Option<Orientation>,
        dialect: Dialect,
    ) -> Option<model::Section> {
        Some(match self {
            Self::Beam { shape, poisson, shear, elastic } => {
                let material = elastic.or(material.isotropic())?;
                model::Section::Beam(BeamSection { shape, poisson, material, shear })
            }
            Self::Solid { thickness } => {
                let material = material.solid(dialect)?;
                model::Section::Solid(SolidSection { thickness, material, orientation })
            }
        })
    }
}

#[derive(Clone, Debug)]
pub(crate) struct Material {
    pub name: String,
    pub elasticity: Option<(Elasticity, Card)>,
    /// Yield stress and plastic strain, line by line; `None` in it: unreadable.
    pub hardening: Option<(Option<Hardening>, Card)>,
    /// Tests of a rubber, in the order of the deck.
    pub tests: Vec<Test>,
    /// Mass per volume [M/L3]; `None` in it: unreadable.
    pub density: Option<(Option<f64>, Card)>,
    pub origin: Span,
}

/// What a material does against strain.
#[derive(Clone, Debug)]
pub(crate) enum Elasticity {
    Isotropic(Elastic),
    Anisotropic(Box<Anisotropic>),
    /// Known in plane stress alone: `TYPE=LAMINA`.
    Ply(Box<Anisotropic>),
    Rubber(Rubber),
    /// Rubber that its test data will give.
    Tested(Wanted),
    /// A card that could not be read, which has been said.
    Unread,
}

impl Elasticity {
    /// What such a material is, for messages.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Isotropic(_) | Self::Unread => "is isotropic",
            Self::Anisotropic(_) | Self::Ply(_) => "is not isotropic",
            Self::Rubber(_) | Self::Tested(_) => "is rubber",
        }
    }
}

/// The card that gave a property of a material: its name without the star, and its place.
pub(crate) type Card = (&'static str, Span);

impl Material {
    /// One without properties yet.
    pub fn new(name: String, origin: Span) -> Self {
        Self { name, elasticity: None, hardening: None, tests: Vec::new(), density: None, origin }
    }

    /// Its constants, where it is isotropic and linear.
    pub fn isotropic(&self) -> Option<Elastic> {
        match self.elasticity {
            Some((Elasticity::Isotropic(elastic), _)) => Some(elastic),
            _ => None,
        }
    }

    /// As solids take it.
    pub fn solid(&self, dialect: Dialect) -> Option<model::Material> {
        let large = match dialect {
            Dialect::Abaqus => LargeStrain::Logarithmic,
            Dialect::Calculix => LargeStrain::Green,
        };
        Some(match &self.elasticity.as_ref()?.0 {
            Elasticity::Rubber(rubber) => model::Material::Rubber(rubber.clone()),
            Elasticity::Anisotropic(own) | Elasticity::Ply(own) => {
                model::Material::Anisotropic(own.clone())
            }
            Elasticity::Isotropic(elastic) => match &self.hardening {
                Some((table, _)) => model::Material::Plastic(Plastic {
                    elastic: *elastic,
                    table: table.clone()?,
                    kinematic: 0.0,
                }),
                None => model::Material::Elastic(*elastic, large),
            },
            Elasticity::Unread | Elasticity::Tested(_) => return None,
        })
    }
}

/// What a material may be strained to: one of both.
#[derive(Clone, Debug)]
pub(crate) struct Allowable {
    pub material: String,
    pub material_span: Span,
    pub limit: Limit,
    pub origin: Span,
}
