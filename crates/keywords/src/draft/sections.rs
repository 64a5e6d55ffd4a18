//! Sections and materials: what elements are made of.

use slideline_diag::Span;
use slideline_mech::element::BeamHeat;
use slideline_mech::material::hyperelastic::{Form, Mode};
use slideline_mech::material::{
    Anisotropic, BackStress, CreepHardening, Creeping, Elastic, Expanding, Expansion, Fibrous,
    Foam, Graded, Growth, Hardening, LargeStrain, Plastic, PowerLaw, RambergOsgood, Relaxation,
    Rubber, Viscoelastic,
};
use slideline_model::{self as model, BeamSection, Dialect, Limit, Shape, ShearRule, SolidSection};
use std::sync::Arc;

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
#[derive(Clone, Debug)]
pub(crate) enum Body {
    /// Elasticity and expansion are its own in a `*BEAM GENERAL SECTION`, else those of the material.
    Beam {
        shape: Shape,
        poisson: f64,
        shear: ShearRule,
        /// Direction of axis 1 of the section.
        first_axis: [f64; 3],
        elastic: Option<(Elastic, f64)>,
        /// Mass per volume that the card gives [M/L3]; `None`: that of the material.
        density: Option<f64>,
    },
    /// Thickness out of the plane, of a truss its area; one where it is not given.
    Solid {
        thickness: Option<f64>,
        /// Whether its nodes say it: `NODAL THICKNESS`.
        by_nodes: bool,
    },
}

impl Body {
    /// The card that gives it.
    pub fn card(&self) -> &'static str {
        match self {
            Self::Beam { .. } => "*BEAM SECTION",
            Self::Solid { .. } => "*SOLID SECTION",
        }
    }

    /// The same with a material; `None` where a beam is given another than an isotropic elastic one.
    pub fn of(self, material: &Material, dialect: Dialect) -> Option<model::Section> {
        Some(match self {
            Self::Beam { shape, poisson, shear, first_axis, elastic, density: _ } => {
                let (table, expansion) = match elastic {
                    Some((elastic, 0.0)) => (vec![(0.0, elastic)], None),
                    Some((elastic, even)) => (vec![(0.0, elastic)], Some(Expansion::even(even))),
                    None => (material.isotropic()?.clone(), material.expansion()?),
                };
                let material = table.first()?.1;
                let given_shear = shear.stiffness.is_some();
                let heat = BeamHeat { expansion, elastic: table, given_shear };
                let heat = heat.changes_anything().then(|| Box::new(heat));
                let section = BeamSection { shape, poisson, material, heat, shear, first_axis };
                model::Section::Beam(section)
            }
            Self::Solid { thickness, .. } => {
                let thickness = thickness.unwrap_or(1.0);
                let material = material.solid(dialect)?;
                model::Section::Solid(SolidSection { thickness, material, orientation: None })
            }
        })
    }
}

/// Constants over temperature, ascending; one line holds for all temperatures.
pub(crate) type Table<T> = Vec<(f64, T)>;

#[derive(Clone, Debug)]
pub(crate) struct Material {
    pub name: String,
    pub elasticity: Option<(Elasticity, Card)>,
    /// How it yields; `None` in it: unreadable.
    pub hardening: Option<(Option<Yielding>, Card)>,
    /// Yield stresses of combined hardening; `None` in it: unreadable.
    pub growth: Option<(Option<Table<Hardening>>, Card)>,
    /// What of its stress fades with time; `None` in it: unreadable.
    pub relaxation: Option<(Option<Vec<Relaxation>>, Card)>,
    /// How it creeps; `None` in it: unreadable.
    pub creep: Option<(Option<CreepLaw>, Card)>,
    /// `MODULI=INSTANTANEOUS`: its elastic constants are those before anything has faded.
    pub at_once: bool,
    /// How it expands; `None` in it: unreadable.
    pub expansion: Option<(Option<Expansion>, Card)>,
    /// Tests of a rubber, in the order of the deck.
    pub tests: Vec<Test>,
    /// Mass per volume [M/L3]; `None` in it: unreadable.
    pub density: Option<(Option<Table<f64>>, Card)>,
    pub origin: Span,
}

/// How a metal yields.
#[derive(Clone, Debug)]
pub(crate) struct Yielding {
    /// Yield stress and plastic strain, line by line.
    pub table: Table<Hardening>,
    /// What moves the yield surface.
    pub back_stresses: Vec<BackStress>,
    /// Whether the surface may also grow.
    pub combined: bool,
}

impl Yielding {
    /// Whether its yield stress is zero throughout: CalculiX' word for creep at any stress.
    pub fn is_none(&self) -> bool {
        self.table.iter().flat_map(|(_, lines)| lines).all(|line| line[0] == 0.0)
    }
}

/// How a material creeps.
#[derive(Clone, Debug)]
pub(crate) struct CreepLaw {
    /// What slows it down.
    pub hardening: CreepHardening,
    /// The power law over temperature.
    pub table: Table<PowerLaw>,
    /// Whether the stress beyond the yield stress drives it.
    pub beyond_yield: bool,
}

/// What a material does against strain.
#[derive(Clone, Debug)]
pub(crate) enum Elasticity {
    Isotropic(Table<Elastic>),
    Anisotropic(Box<Anisotropic>),
    /// Known in plane stress alone: `TYPE=LAMINA`.
    Ply(Box<Anisotropic>),
    Rubber(Table<Rubber>),
    /// Rubber that its test data will give.
    Tested(Wanted),
    Foam(Foam),
    /// Its fibres not laid yet.
    Fibrous(Fibrous),
    /// Deformation plasticity.
    Deformation(RambergOsgood),
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
            Self::Foam(_) => "is foam",
            Self::Fibrous(_) => "has fibres",
            Self::Deformation(_) => "has *DEFORMATION PLASTICITY",
        }
    }
}

/// A law whose coefficients test data are to give.
#[derive(Clone, Debug)]
pub(crate) struct Wanted {
    /// Its form.
    pub form: Form,
    /// How many terms change its volume.
    pub volumes: usize,
    /// Poisson's ratio, where that is said instead of volumes.
    pub poisson: Option<f64>,
}

/// What was measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Nominal stress and nominal strain.
    Mode(Mode),
    /// Pressure and ratio of volumes.
    Volume,
}

/// The data of one card.
#[derive(Clone, Debug)]
pub(crate) struct Test {
    pub kind: Kind,
    /// Stress or pressure [F/L2], strain or ratio of volumes [1]; `None`: unreadable.
    pub points: Option<Vec<[f64; 2]>>,
    pub card: Card,
}

/// The card that gave a property of a material: its name without the star, and its place.
pub(crate) type Card = (&'static str, Span);

impl Material {
    /// One without properties yet.
    pub fn new(name: String, origin: Span) -> Self {
        Self {
            name,
            elasticity: None,
            hardening: None,
            growth: None,
            relaxation: None,
            creep: None,
            at_once: false,
            expansion: None,
            tests: Vec::new(),
            density: None,
            origin,
        }
    }

    /// Its constants over temperature, where it is isotropic and linear.
    pub fn isotropic(&self) -> Option<&Table<Elastic>> {
        match &self.elasticity {
            Some((Elasticity::Isotropic(table), _)) => Some(table),
            _ => None,
        }
    }

    /// As solids take it.
    pub fn solid(&self, dialect: Dialect) -> Option<model::Material> {
        let large = match dialect {
            Dialect::Abaqus => LargeStrain::Logarithmic,
            Dialect::Calculix => LargeStrain::Green,
        };
        let law = self.law(large)?;
        let growth = match (dialect, &self.elasticity.as_ref()?.0) {
            (Dialect::Calculix, _) => Growth::Length,
            (_, Elasticity::Rubber(_) | Elasticity::Foam(_) | Elasticity::Fibrous(_)) => {
                Growth::Length
            }
            _ => Growth::Logarithmic,
        };
        Some(match self.expansion()? {
            Some(expansion) => {
                model::Material::Expanding(Box::new(Expanding { expansion, growth, law }))
            }
            None => law,
        })
    }

    /// How it expands, if it does; `None`: its card could not be read.
    fn expansion(&self) -> Option<Option<Expansion>> {
        match &self.expansion {
            Some((expansion, _)) => expansion.clone().map(Some),
            None => Some(None),
        }
    }

    /// A metal of an elasticity.
    fn metal(&self, elastic: &Table<Elastic>, yielding: &Yielding) -> Option<model::Material> {
        let table = match &self.growth {
            Some((growth, _)) => growth.as_ref()?,
            None => &yielding.table,
        };
        if yielding.back_stresses.is_empty() {
            return graded(Graded::metal(elastic, table));
        }
        let [(_, elastic)] = elastic[..] else { return None };
        let (_, table) = table.first()?.clone();
        let back_stresses = yielding.back_stresses.clone();
        Some(model::Material::Plastic(Plastic { elastic, table, back_stresses }))
    }

    /// The law without its expansion.
    fn law(&self, large: LargeStrain) -> Option<model::Material> {
        if let Some((series, _)) = &self.relaxation {
            let series = series.clone()?;
            let law = self.without_time(large, self.before_relaxing(&series))?;
            return Some(model::Material::Viscoelastic(Box::new(Viscoelastic { law, series })));
        }
        let law = self.without_time(large, [1.0; 2])?;
        let Some((creep, _)) = &self.creep else { return Some(law) };
        let CreepLaw { hardening, table, beyond_yield } = creep.clone()?;
        let creeping = Creeping { metal: law, hardening, law: table, beyond_yield };
        Some(model::Material::Creeping(Box::new(creeping)))
    }

    /// Moduli before anything has faded over those of the card: against a change of shape, and of
    /// volume [1].
    fn before_relaxing(&self, series: &[Relaxation]) -> [f64; 2] {
        let left = |part: fn(&Relaxation) -> f64| 1.0 - series.iter().map(part).sum::<f64>();
        match self.at_once {
            true => [1.0; 2],
            false => [1.0 / left(|term| term.shear), 1.0 / left(|term| term.bulk)],
        }
    }

    /// The law as it is where no time passes, its moduli multiplied by factors.
    fn without_time(&self, large: LargeStrain, factors: [f64; 2]) -> Option<model::Material> {
        let elastic = |own: &Elastic| match factors {
            [1.0, 1.0] => *own,
            [shape, bulk] => {
                Elastic::of_moduli(shape * own.shear_modulus(), bulk * own.bulk_modulus())
            }
        };
        match &self.elasticity.as_ref()?.0 {
            Elasticity::Rubber(table) => graded(
                table.iter().map(|(at, own)| (*at, model::Material::Rubber(own.scaled(factors)))),
            ),
            Elasticity::Anisotropic(own) | Elasticity::Ply(own) => {
                Some(model::Material::Anisotropic(own.clone(), large))
            }
            Elasticity::Isotropic(table) => match &self.hardening {
                Some((yielding, _)) if !yielding.as_ref()?.is_none() => {
                    self.metal(table, yielding.as_ref()?)
                }
                _ => {
                    let row = |e| model::Material::Elastic(elastic(e), large);
                    graded(table.iter().map(|(at, e)| (*at, row(e))))
                }
            },
            Elasticity::Foam(own) => Some(model::Material::Foam(own.clone())),
            Elasticity::Fibrous(own) => Some(model::Material::Fibrous(Box::new(own.clone()))),
            Elasticity::Deformation(own) => Some(model::Material::RambergOsgood(Box::new(*own))),
            Elasticity::Unread | Elasticity::Tested(_) => None,
        }
    }
}

/// A material over temperature; with one line for all temperatures.
fn graded(rows: impl IntoIterator<Item = (f64, model::Material)>) -> Option<model::Material> {
    let mut rows: Vec<(f64, model::Material)> = rows.into_iter().collect();
    match rows.len() {
        0 | 1 => rows.pop().map(|(_, only)| only),
        _ => Graded::new(rows).map(|graded| model::Material::Graded(Arc::new(graded))),
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
