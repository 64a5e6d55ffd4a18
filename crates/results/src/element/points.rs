//! Quantities of solids at their integration points.

use slideline_mech::material::tensor::{deviator, eigen, trace};
use slideline_model::{
    Dialect, Element, ElementBlock, ElementType, ElementVariable, Kinematics, Location, MOST_NODES,
    NodeIndex, Section,
};
use slideline_solve::observe::Frame;

/// What is told of solids.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// A field of their type, by its name.
    Field(&'static str),
    /// Logarithmic strain [1].
    LogarithmicStrain,
    /// Plastic strain [1].
    PlasticStrain,
    /// Creep strain [1].
    CreepStrain,
    /// Mises stress [F/L2].
    Mises,
    /// Principal stresses, ascending [F/L2].
    Principal,
    /// Current place [L].
    Place,
}

impl Quantity {
    /// What a variable of a request stands for; `None`: it is one of beams alone.
    pub fn of(variable: ElementVariable) -> Option<Self> {
        Some(match variable {
            ElementVariable::S => Self::Field("S"),
            ElementVariable::E => Self::Field("E"),
            ElementVariable::LE => Self::LogarithmicStrain,
            ElementVariable::PE => Self::PlasticStrain,
            ElementVariable::PEEQ => Self::Field("PEEQ"),
            ElementVariable::CE => Self::CreepStrain,
            ElementVariable::CEEQ => Self::Field("CEEQ"),
            ElementVariable::MISES => Self::Mises,
            ElementVariable::SP => Self::Principal,
            ElementVariable::ENER => Self::Field("ENER"),
            ElementVariable::PENER => Self::Field("PENER"),
            ElementVariable::COORD => Self::Place,
            ElementVariable::ELSE => Self::Field("ELSE"),
            ElementVariable::ELPD => Self::Field("ELPD"),
            ElementVariable::EVOL => Self::Field("EVOL"),
            ElementVariable::SF
            | ElementVariable::SM
            | ElementVariable::SE
            | ElementVariable::SK => return None,
        })
    }

    /// Names of its components for elements of a type, read in a dialect; none where they lack it.
    /// Logarithmic and plastic strains are those of a dialect whose strains are logarithmic.
    pub fn components(self, kind: &ElementType, dialect: Dialect) -> &'static [&'static str] {
        let (count, _) = stress_field(kind).unwrap_or_default();
        let logarithmic = dialect == Dialect::Abaqus;
        match self {
            // across a truss nothing is prescribed, and nothing told
            Self::Field("E") if kind.is_truss() => &["E11"],
            Self::Field(name) => kind.field(name).map_or(&[], |(field, _)| field.components),
            Self::LogarithmicStrain if logarithmic => &STRAINS[..count],
            Self::PlasticStrain | Self::CreepStrain if kind.is_truss() => &[],
            Self::PlasticStrain if logarithmic => &PLASTIC_STRAINS[..count],
            Self::CreepStrain if logarithmic => &CREEP_STRAINS[..count],
            Self::Mises if count > 0 => &["MISES"],
            Self::Principal if count > 0 => &["SP1", "SP2", "SP3"],
            Self::Place if matches!(kind.kinematics, Kinematics::Solid { .. }) => {
                &["COOR1", "COOR2", "COOR3"][..kind.cell.dimension]
            }
            _ => &[],
        }
    }
}

const STRAINS: [&str; 6] = ["LE11", "LE22", "LE33", "LE12", "LE13", "LE23"];
const PLASTIC_STRAINS: [&str; 6] = ["PE11", "PE22", "PE33", "PE12", "PE13", "PE23"];
const CREEP_STRAINS: [&str; 6] = ["CE11", "CE22", "CE33", "CE12", "CE13", "CE23"];
const STRESSES: [&str; 6] = ["S11", "S22", "S33", "S12", "S13", "S23"];

/// How many components the stress of a type has at its points, of a truss that along it alone, and where it
/// begins among its values; `None`: it has no such stress.
fn stress_field(kind: &ElementType) -> Option<(usize, usize)> {
    let (field, first) = kind.field("S")?;
    let width = field.components.len();
    let known = (width >= 4 || kind.is_truss()) && STRESSES.starts_with(field.components);
    (known && field.location == Location::Points).then_some((width, first))
}

/// The largest of three, pulled or pressed; what is no number is the largest.
fn largest(values: [f64; 3]) -> f64 {
    let worse = |most: f64, own: f64| if own.is_nan() || own > most { own } else { most };
    values.iter().map(|value| value.abs()).fold(0.0, worse)
}

/// A solid, or another element that is no beam, with its results.
#[derive(Clone, Copy, Debug)]
pub struct Solid<'a> {
    pub(super) frame: &'a Frame<'a>,
    /// Index of its block in the model.
    pub number: usize,
    /// Its block.
    pub block: &'a ElementBlock,
    /// The element.
    pub element: Element<'a>,
    /// Its place in the block.
    pub place: usize,
    values: &'a [f64],
}

/// All elements of a frame that are no beams and have results, block by block.
pub fn solids<'a>(frame: &'a Frame<'a>) -> impl Iterator<Item = Solid<'a>> {
    let blocks = frame.elements.iter().filter_map(|results| {
        let block = frame.model.blocks.get(results.block)?;
        (!block.kind.is_beam() && !block.kind.fields.is_empty()).then_some((block, results))
    });
    blocks.flat_map(move |(block, results)| {
        let own = results.members.iter().zip(results.elements(frame.model));
        own.map(move |(&place, (element, values))| Solid {
            frame,
            number: results.block,
            block,
            element,
            place,
            values,
        })
    })
}

impl<'a> Solid<'a> {
    /// Whether it creeps.
    pub fn creeps(&self) -> bool {
        let Section::Solid(section) = &self.block.section else { return false };
        section.material.creeps()
    }

    /// Every component of every field with its mean over the element; creep strain only where there
    /// may be one.
    pub fn means(&self) -> impl Iterator<Item = (&'static str, f64)> + use<'a> {
        let (kind, values, creeps) = (self.block.kind, self.values, self.creeps());
        let fields = kind.fields.iter().filter(move |field| creeps || field.name != "CEEQ");
        fields.flat_map(move |field| {
            let first = kind.field(field.name).map_or(0, |(_, first)| first);
            let own = values.get(first..first + kind.values(field)).unwrap_or_default();
            let width = field.components.len();
            let places = (own.len() / width.max(1)) as f64;
            field.components.iter().enumerate().map(move |(place, name)| {
                (*name, own.iter().skip(place).step_by(width).sum::<f64>() / places)
            })
        })
    }

    /// All its values, field by field.
    pub(super) fn values(&self) -> &'a [f64] {
        self.values
    }

    /// Number of integration points with a stress.
    pub fn points(&self) -> usize {
        stress_field(self.block.kind).map_or(0, |_| self.block.kind.points)
    }

    /// Cauchy stress at a point, counted from 0: 11, 22, 33, 12, 13, 23, of a truss along it [F/L2].
    pub fn stress(&self, point: usize) -> [f64; 6] {
        let mut stress = [0.0; 6];
        if let Some((width, first)) = stress_field(self.block.kind) {
            let own = self.values.get(first + width * point..).unwrap_or_default();
            stress.iter_mut().zip(own).take(width).for_each(|(s, own)| *s = *own);
        }
        stress
    }

    /// Appends a quantity at a point, counted from 0: as many values as it has components.
    pub fn push(&self, quantity: Quantity, point: usize, into: &mut Vec<f64>) {
        let kind = self.block.kind;
        let count = quantity.components(kind, self.frame.model.dialect).len();
        match quantity {
            Quantity::Field(name) => {
                into.extend_from_slice(self.field(name, point).get(..count).unwrap_or_default());
            }
            Quantity::LogarithmicStrain => {
                into.extend_from_slice(&self.field("E", point)[..count]);
            }
            Quantity::PlasticStrain => {
                into.extend_from_slice(&self.flowed_strain("PEEQ", point)[..count]);
            }
            Quantity::CreepStrain => {
                into.extend_from_slice(&self.flowed_strain("CEEQ", point)[..count]);
            }
            Quantity::Mises if count > 0 => into.push(mises(self.stress(point))),
            Quantity::Principal if count > 0 => {
                into.extend_from_slice(&principal(self.stress(point)));
            }
            Quantity::Place => into.extend_from_slice(&self.place(point)[..count]),
            Quantity::Mises | Quantity::Principal => {}
        }
    }

    /// Largest principal strain at a point, pulled or pressed [1].
    pub fn principal_strain(&self, point: usize) -> f64 {
        largest(self.principal_strains(point))
    }

    /// What no principal strain at a point exceeds: the size of the strain [1].
    pub fn strain_bound(&self, point: usize) -> f64 {
        size(self.field("E", point))
    }

    /// Principal strains at a point [1].
    fn principal_strains(&self, point: usize) -> [f64; 3] {
        let mut strain = [0.0; 6];
        strain.iter_mut().zip(self.field("E", point)).for_each(|(e, own)| *e = *own);
        (3..6).for_each(|k| strain[k] *= 0.5);
        principal(strain)
    }

    /// Largest principal nominal strain at a point whose rubber is strained beyond its stability
    /// [1]: docs/theory.md eq. (3.86). `None`: it is not.
    pub fn unstable_strain(&self, point: usize) -> Option<f64> {
        let Section::Solid(section) = &self.block.section else { return None };
        let step = self.frame.model.steps.get(self.frame.step.wrapping_sub(1))?;
        if !step.nlgeom || section.material.is_linear() {
            return None;
        }
        let strains = self.principal_strains(point);
        let logs = match self.frame.model.dialect {
            Dialect::Abaqus => strains,
            Dialect::Calculix => strains.map(|green| 0.5 * (2.0 * green).ln_1p()),
        };
        let even = logs.iter().sum::<f64>() / 3.0;
        let temperature = self.at_point(point, |node| self.frame.nodal.temperature(node));
        let strained = [logs[0] - even, logs[1] - even];
        let stable = section.material.rubber(temperature, |own| own.is_stable(strained))?;
        (!stable).then(|| largest(logs.map(f64::exp_m1)))
    }

    /// Whether its stress is linear in its strain.
    pub fn is_linear(&self) -> bool {
        let Section::Solid(section) = &self.block.section else { return false };
        section.material.is_linear()
    }

    /// Values of a field at a point; of the whole element where it has one value.
    pub(super) fn field(&self, name: &str, point: usize) -> &[f64] {
        let Some((field, first)) = self.block.kind.field(name) else { return &[] };
        let width = field.components.len();
        let before = if field.location == Location::Centroid { 0 } else { width * point };
        self.values.get(first + before..first + before + width).unwrap_or_default()
    }

    /// Plastic strain or creep strain of a metal, shears as angles: the part of the strain that its
    /// stress does not answer for, which leaves the volume alone, docs/theory.md eq. (3.57); of that
    /// the share of the equivalent strain of that name.
    fn flowed_strain(&self, name: &str, point: usize) -> [f64; 6] {
        let Section::Solid(section) = &self.block.section else { return [0.0; 6] };
        let temperature = self.at_point(point, |node| self.frame.nodal.temperature(node));
        let Some(metal) = section.material.metal(temperature) else { return [0.0; 6] };
        let mut strain = [0.0; 6];
        strain.iter_mut().zip(self.field("E", point)).for_each(|(e, own)| *e = *own);
        (3..6).for_each(|k| strain[k] *= 0.5);
        let large = self.frame.model.steps.get(self.frame.step.wrapping_sub(1));
        let large = large.is_some_and(|step| step.nlgeom);
        let volume = if large { trace(&strain).exp() } else { 1.0 };
        let (strain, stress) = (deviator(&strain), deviator(&self.stress(point)));
        let twice = 2.0 * metal.shear_modulus();
        let size = |name| self.field(name, point).first().copied().unwrap_or(0.0);
        let own = size(name);
        let share = if own > 0.0 { own / (size("PEEQ") + size("CEEQ")) } else { 0.0 };
        std::array::from_fn(|k| {
            let left = strain[k] - volume * stress[k] / twice;
            share * if k < 3 { left } else { 2.0 * left }
        })
    }

    /// Current place of a point [L].
    fn place(&self, point: usize) -> [f64; 3] {
        let at =
            |axis: usize| self.at_point(point, |node| crate::node::place(self.frame, node)[axis]);
        std::array::from_fn(at)
    }

    /// What nodes have, at a point by shape functions.
    fn at_point(&self, point: usize, of: impl Fn(NodeIndex) -> f64) -> f64 {
        let Kinematics::Solid { rule, .. } = self.block.kind.kinematics else { return 0.0 };
        let mut shapes = [0.0; MOST_NODES];
        let shapes = &mut shapes[..self.element.nodes.len()];
        let Some(at) = rule.points.get(point) else { return 0.0 };
        (self.block.kind.cell.shapes)(at, shapes);
        self.element.nodes.iter().zip(shapes.iter()).map(|(&node, shape)| shape * of(node)).sum()
    }
}

/// Mises stress of a tensor 11, 22, 33, 12, 13, 23 [F/L2].
pub fn mises([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> f64 {
    let normal = (xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2);
    (0.5 * normal + 3.0 * (xy * xy + yz * yz + xz * xz)).sqrt()
}

/// Principal values of a tensor, ascending.
pub(super) fn principal(tensor: [f64; 6]) -> [f64; 3] {
    let (mut values, _) = eigen(&tensor);
    values.sort_by(f64::total_cmp);
    values
}

/// Size of a strain with its shears as angles: the root of the sum of squares of its principal
/// values, of which none is larger [1].
fn size(strain: &[f64]) -> f64 {
    let square = |(k, e): (usize, &f64)| if k < 3 { e * e } else { 0.5 * e * e };
    strain.iter().enumerate().map(square).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: the size of a strain is that of its principal values, so that none exceeds it.
    /// Tolerance: rounding.
    #[test]
    fn no_principal_strain_exceeds_the_size() {
        for k in 0..50 {
            let strain: [f64; 6] =
                std::array::from_fn(|i| f64::from((k * 31 + i as i32 * 17) % 23) / 11.0 - 1.0);
            let mut tensor = strain;
            tensor[3..].iter_mut().for_each(|shear| *shear *= 0.5);
            let values = principal(tensor);
            let square: f64 = values.iter().map(|value| value * value).sum();
            assert!((square.sqrt() - size(&strain)).abs() < 1e-12, "{strain:?}");
        }
    }
}
