//! Sections and materials: what elements are made of.

use slideline_diag::Span;
use slideline_mech::material::{Anisotropic, Elastic, Hardening, LargeStrain, Plastic, Rubber};
use slideline_mech::orientation::Orientation;
use slideline_model::{self as model, BeamSection, Dialect, ShearRule, SolidSection};

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
    Beam { width: f64, height: f64, poisson: f64, shear: ShearRule },
    Solid { thickness: f64 },
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
            Self::Beam { width, height, poisson, shear } => {
                let material = material.elastic?;
                model::Section::Beam(BeamSection { width, height, poisson, material, shear })
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
    pub elastic: Option<Elastic>,
    /// Elasticity without isotropy.
    pub anisotropic: Option<Anisotropic>,
    /// It is known in plane stress alone: `TYPE=LAMINA`.
    pub plane_stress_only: bool,
    pub rubber: Option<Rubber>,
    /// Yield stress and plastic strain, line by line.
    pub hardening: Option<Hardening>,
    /// An `*ELASTIC` or `*HYPERELASTIC` card was there, readable or not.
    pub has_card: bool,
    pub origin: Span,
}

impl Material {
    /// As solids take it.
    pub fn solid(&self, dialect: Dialect) -> Option<model::Material> {
        let large = match dialect {
            Dialect::Abaqus => LargeStrain::Logarithmic,
            Dialect::Calculix => LargeStrain::Green,
        };
        if let Some(rubber) = &self.rubber {
            return Some(model::Material::Rubber(rubber.clone()));
        }
        if let Some(anisotropic) = self.anisotropic {
            return Some(model::Material::Anisotropic(Box::new(anisotropic)));
        }
        let elastic = self.elastic?;
        Some(match &self.hardening {
            Some(table) => {
                model::Material::Plastic(Plastic { elastic, table: table.clone(), kinematic: 0.0 })
            }
            None => model::Material::Elastic(elastic, large),
        })
    }
}

/// What a material may be strained to: one of both.
#[derive(Clone, Debug)]
pub(crate) struct Allowable {
    pub material: String,
    pub material_span: Span,
    pub strain: Option<f64>,
    pub stress: Option<f64>,
    pub origin: Span,
}
