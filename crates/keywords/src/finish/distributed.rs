//! Loads on faces and volumes: pressures and tractions stay what they are, the rest becomes forces on
//! nodes.

use slideline_diag::{Code, Diagnostic, Span};
use slideline_mech::element::quadrature::Quadrature;
use slideline_mech::material::between;
use slideline_mech::orientation::{Basis, Orientation};
use slideline_mech::pressure::Face;
use slideline_mech::traction::{Follows, Traction};
use slideline_mech::volume;
use slideline_model::{Dialect, ElementType, Kinematics, NodeIndex, Pressed};

use super::faces::{self, SolidFace, face_nodes};
use super::load_forces::{
    NOUGHT, Resolved, What, per_volume, places, refuse, shares, turned, weight_leaves,
};
use super::unit_systems;
use super::{line_loads, orientations, point_masses};
use crate::distributed::{Along, Distributed, Key, Kind, On};
use crate::draft::{Body, Draft, ElementKind, Section};
use crate::log::Target;
use crate::rule::Subject;

/// What a line loads.
pub(super) fn resolve(line: &Distributed, draft: &mut Draft) -> Resolved {
    match (&line.on, line.face) {
        (On::Elements(target, span), Some(face)) => {
            let (mut all, mut across) = (Vec::new(), Resolved::new());
            for index in elements(target, *span, draft) {
                if line.kind == Kind::Pressure && is_loaded_beam(index, draft) && face < 2 {
                    across.extend(on_section(index, face, line, draft));
                    continue;
                }
                match face_nodes(index, Some(face), draft) {
                    Some(nodes) => {
                        let face =
                            SolidFace { element: index, face: Some(face), nodes, span: *span };
                        all.push(face);
                    }
                    None => faces::no_face(index, face, line.origin, draft),
                }
            }
            across.extend(all.into_iter().filter_map(|face| on_face(&face, line, draft)));
            across
        }
        (On::Surface(named), _) => {
            let Some(surface) = draft.surface(named) else { return Vec::new() };
            let all = faces::faces(&surface, named.span, draft);
            all.into_iter().filter_map(|face| on_face(&face, line, draft)).collect()
        }
        (On::Elements(target, span), _) => {
            let before = draft.log.errors();
            let found = elements(target, *span, draft);
            let some = !found.is_empty();
            let loaded: Resolved =
                found.into_iter().filter_map(|index| on_volume(index, line, draft)).collect();
            if some && loaded.is_empty() && draft.log.errors() == before {
                let message = "no element takes this load: none of them has a *DENSITY";
                let error = Diagnostic::error(Code("SL0309"), message).at(line.origin);
                let help = "give the material a *DENSITY, and name a set of solids";
                draft.consequence(Subject::Properties, error.help(help));
            }
            loaded
        }
    }
}

fn is_loaded_beam(index: usize, draft: &Draft) -> bool {
    let ElementKind::Structural(row) = draft.elements[index].kind else { return false };
    !row.is_truss() && line_loads::takes_loads(row)
}

/// A force per length along an axis of the section, which it follows.
fn on_section(
    index: usize,
    axis: usize,
    line: &Distributed,
    draft: &mut Draft,
) -> Option<((usize, Key), What)> {
    let nodes = face_nodes(index, None, draft)?;
    let section = section_of(index, draft)?.clone();
    let ElementKind::Structural(row) = draft.elements[index].kind else { return None };
    let own_axis = draft.first_axes.get(&index).copied();
    let shares = line_loads::across((&nodes, &section, row), own_axis, axis, line, draft)?;
    let what = What::Pressure(Pressed::Sections(shares), nodes);
    Some(((index, line.key(axis + 1, draft.dialect)), what))
}

/// The elements that a line names; all of them where it names none.
fn elements(target: &Target, span: Span, draft: &mut Draft) -> Vec<usize> {
    match target {
        Target::Set(set) if set.is_empty() => (0..draft.elements.len()).collect(),
        named => draft.elements_at(named, span),
    }
}

fn no_pressure(kind: ElementKind, line: &Distributed, draft: &mut Draft) {
    let message = format!("a {} element takes no pressure on a face", kind.name());
    let error = Diagnostic::error(Code("SL0221"), message).at(line.origin);
    draft.consequence(Subject::Elements, error.help("use *CLOAD on its nodes"));
}

fn on_face(own: &SolidFace, line: &Distributed, draft: &mut Draft) -> Option<((usize, Key), What)> {
    let element = draft.elements[own.element];
    let ElementKind::Structural(row) = element.kind else {
        no_pressure(element.kind, line, draft);
        return None;
    };
    let thickness = section(own.element, draft).map_or(1.0, |(thickness, _)| thickness);
    let face = own.face.and_then(|_| match row.is_ring() {
        true => Face::of_ring(own.nodes.len()),
        false => Face::of(row.cell.dimension, own.nodes.len(), thickness),
    });
    let Some(face) = face else {
        no_pressure(element.kind, line, draft);
        return None;
    };
    if let Some(why) = leaves(line.kind, row, draft.dialect) {
        refuse(why, row.name(), row.is_ring(), line, draft);
        return None;
    }
    let number = own.face.map_or(0, |face| face + 1);
    let axes = axes_of(line, draft)?;
    let tilted = |own: Orientation| own.at(&[], [0.0; 3])[2][2].abs() < 1.0 - NOUGHT;
    if !row.is_spatial() && axes.is_some_and(tilted) {
        refuse("takes no load out of its plane", row.name(), row.is_ring(), line, draft);
        return None;
    }
    let x = places(&own.nodes, draft);
    let along = |direction| move |at| in_axes(axes.as_ref(), at, direction);
    let traction = match line.kind {
        Kind::Traction(given) => Traction::new(face, line.follows, &x, along(given)),
        Kind::Shear(given) => match Traction::along(face, line.follows, &x, along(given)) {
            Some(traction) => traction,
            None => {
                across(line, draft);
                return None;
            }
        },
        _ => {
            let what = What::Pressure(Pressed::Face(face), own.nodes.clone());
            return Some(((own.element, line.key(number, draft.dialect)), what));
        }
    };
    let what = pulled(traction, &own.nodes, &x, draft);
    Some(((own.element, line.key(number, draft.dialect)), what))
}

/// A traction on a face with nodes at `x`; one that follows in no way is forces that stay.
fn pulled(traction: Traction, nodes: &[NodeIndex], x: &[[f64; 3]], draft: &Draft) -> What {
    if traction.follows() != (Follows { turns: false, grows: false }) {
        return What::Pressure(Pressed::Traction(traction), nodes.to_vec());
    }
    let mut forces = vec![[0.0; 3]; x.len()];
    traction.at_rest(x).pull(1.0, x, &mut forces);
    What::Forces(shares(nodes, &forces, draft))
}

/// The axes in which the direction of a load is given: `Some(None)` without, `None` after an error.
fn axes_of(line: &Distributed, draft: &mut Draft) -> Option<Option<Orientation>> {
    let axes = orientations::of_section(line.axes.as_ref(), draft)?;
    if axes.is_some_and(|own| matches!(own.basis, Basis::Nodes(_))) {
        let message = "axes of a load are not given by nodes of an element";
        let error = Diagnostic::error(Code("SL0221"), message).at(line.origin);
        draft.consequence(Subject::Steps, error.help("give points: DEFINITION=COORDINATES"));
        return None;
    }
    Some(axes)
}

/// A vector whose components are along axes at a place, in those of the model.
fn in_axes(axes: Option<&Orientation>, at: [f64; 3], vector: [f64; 3]) -> [f64; 3] {
    let Some(axes) = axes else { return vector };
    let own = axes.at(&[], at);
    std::array::from_fn(|k| (0..3).map(|axis| vector[axis] * own[axis][k]).sum())
}

/// Complains about a traction along a face whose direction stands across it.
fn across(line: &Distributed, draft: &mut Draft) {
    let message = "the direction of TRSHR stands across the face: it has no part along it";
    let error = Diagnostic::error(Code("SL0232"), message).at(line.origin);
    let help = "give a direction along the face, or a traction of any direction: TRVEC";
    draft.consequence(Subject::Steps, error.help(help));
}

/// The direction of a force per volume on an element of a row, by its coordinate. That of Abaqus'
/// BZ on a ring is its axis.
fn axis(along: Along, row: &ElementType, dialect: Dialect) -> Option<usize> {
    match (along, row.is_ring()) {
        (Along::Radius, ring) => ring.then_some(0),
        (Along::X, _) => Some(0),
        (Along::Y, _) => Some(1),
        (Along::Z, true) => (dialect == Dialect::Abaqus).then_some(1),
        (Along::Z, false) => row.is_spatial().then_some(2),
    }
}

/// Why a load does not act in the plane, or not evenly round the axis, of an element.
fn leaves(kind: Kind, row: &ElementType, dialect: Dialect) -> Option<&'static str> {
    if row.is_spatial() {
        return matches!(kind, Kind::Body(Along::Radius)).then_some("has no radius");
    }
    match kind {
        Kind::Pressure => None,
        Kind::Line(along) => (along == 2).then_some("takes no load out of its plane"),
        Kind::Body(along) if axis(along, row, dialect).is_some() => None,
        Kind::Body(Along::Radius) => Some("has no radius"),
        Kind::Body(_) => Some("takes no load out of its plane"),
        Kind::Traction([_, _, z]) | Kind::Shear([_, _, z]) => {
            (z.abs() > NOUGHT).then_some("takes no load out of its plane")
        }
        Kind::Gravity(_) | Kind::Centrifugal(..) => weight_leaves(kind, row.is_ring()),
    }
}

/// Whether a load acts on mass.
fn is_weight(kind: Kind) -> bool {
    matches!(kind, Kind::Gravity(_) | Kind::Centrifugal(..))
}

/// Complains about the weight of mass that is added, which is not computed.
fn weighs_otherwise(line: &Distributed, draft: &mut Draft) -> bool {
    if let Some(span) = draft.added_mass {
        let error = Diagnostic::error(Code("SL0221"), "the weight of added mass is not supported");
        let error = error.at(span).label(line.origin, "here it would weigh");
        draft.consequence(Subject::Sections, error.help("count it in *DENSITY"));
        return true;
    }
    false
}

fn on_volume(index: usize, line: &Distributed, draft: &mut Draft) -> Option<((usize, Key), What)> {
    let element = draft.elements[index];
    let kind = line.kind;
    if is_weight(kind) && element.kind.is_mass() {
        return point_masses::on_mass(element, line, draft);
    }
    if is_weight(kind) && weighs_otherwise(line, draft) {
        return None;
    }
    let ElementKind::Structural(row) = element.kind else { return None };
    let nodes = face_nodes(index, None, draft)?;
    let x = places(&nodes, draft);
    let (thickness, mass) = section(index, draft).unwrap_or((1.0, Mass::default()));
    let density = needed_density((&mass, row), &nodes, line, draft)?;
    if let Some(why) = leaves(kind, row, draft.dialect).filter(|_| row.joins()) {
        refuse(why, row.name(), row.is_ring(), line, draft);
        return None;
    }
    let along = match kind {
        Kind::Body(along) => axis(along, row, draft.dialect),
        _ => None,
    };
    let body = |at: [f64; 3]| per_volume((kind, along), density, at);
    // a ring is as thick as its circle
    let ring = row.is_ring();
    let thickness = if ring { 2.0 * std::f64::consts::PI } else { thickness };
    let weighted = |at: [f64; 3]| body(at).map(|force| if ring { at[0] * force } else { force });
    let is_line = line_loads::takes_loads(row);
    if is_line && density > 0.0 {
        let own_axis = draft.first_axes.get(&index).copied();
        let beside = section_of(index, draft).filter(|own| line_loads::is_beside(own)).cloned();
        if let Some(section) = beside {
            line_loads::acts_beside((&section, own_axis), &x, (row, along), line, draft);
        }
    }
    let forces = match kind {
        _ if is_line => Some(line_loads::spread(kind, thickness, &x, body)),
        Kind::Line(_) => None,
        _ => volume::spread((row.cell, own_rule(row, draft)), thickness, &x, weighted),
    };
    let Some(forces) = forces else {
        if row.joins() {
            let what = if matches!(kind, Kind::Line(_)) { "length" } else { "volume" };
            let message = format!("a {} element takes no load per {what}", element.kind.name());
            let error = Diagnostic::error(Code("SL0221"), message).at(line.origin);
            draft.consequence(Subject::Elements, error.help("use *CLOAD on its nodes"));
        }
        return None;
    };
    let masses = || match is_line {
        true => Some(volume::masses_along(&x, density * thickness)),
        false => {
            let dense = |at: [f64; 3]| if ring { at[0] * density } else { density };
            volume::masses((row.cell, own_rule(row, draft)), thickness, &x, dense)
        }
    };
    let what = turned(kind, &nodes, draft, masses);
    let what = what.unwrap_or_else(|| What::Forces(shares(&nodes, &forces, draft)));
    Some(((index, line.key(0, draft.dialect)), what))
}

/// The density that a load needs [M/L3], 1 for what is a force per volume or length itself; `None`
/// where there is none, with a complaint if an element was to have one.
fn needed_density(
    (mass, row): (&Mass, &ElementType),
    nodes: &[NodeIndex],
    line: &Distributed,
    draft: &mut Draft,
) -> Option<f64> {
    if matches!(line.kind, Kind::Body(_) | Kind::Line(_)) {
        return Some(1.0);
    }
    let everything = matches!(&line.on, On::Elements(Target::Set(set), _) if set.is_empty());
    let found = mass.density.or_else(|| density(&mass.material, nodes, draft));
    match found {
        Some(density) if mass.density.is_none() => weigh((&mass.material, density), line, draft),
        Some(_) => {}
        None if everything || !row.joins() => {}
        None => {
            let message = match mass.material.is_empty() {
                false => format!("the material {} has no *DENSITY for this load", mass.material),
                true => "the section has no DENSITY for this load".to_owned(),
            };
            let error = Diagnostic::error(Code("SL0309"), message).at(line.origin);
            draft.consequence(Subject::Properties, error);
        }
    }
    found
}

/// CalculiX takes forces per volume at the points of the stiffness, which in reduced elements does
/// not see all of one that grows with the place.
fn own_rule(row: &ElementType, draft: &Draft) -> Option<&'static Quadrature> {
    match row.kinematics {
        Kinematics::Solid { rule, .. } if draft.dialect == Dialect::Calculix => Some(rule),
        _ => None,
    }
}

/// Advises about a density whose unit is not that of the load or of the modulus.
fn weigh((name, density): (&str, f64), line: &Distributed, draft: &mut Draft) {
    if !draft.log.first_time(&format!("units of {name}")) {
        return;
    }
    let Some(material) = draft.materials.iter().find(|own| own.name == name).cloned() else {
        return;
    };
    let pull = match line.kind {
        Kind::Gravity(along) => Some(along.map(|d| line.value * d)),
        _ => None,
    };
    unit_systems::judge(&material, density, (pull, line.origin), draft);
}

/// Density of a material at the mean temperature that these nodes have before the first step
/// [M/L3]: mass stays what it was then. Straight between the lines of its table, constant outside.
fn density(material: &str, nodes: &[NodeIndex], draft: &Draft) -> Option<f64> {
    let material = draft.materials.iter().find(|own| own.name == material)?;
    let table = material.density.as_ref()?.0.as_ref()?;
    let sum: f64 = nodes.iter().map(|&node| draft.model.initial_temperature(node).value).sum();
    let mean = sum / nodes.len() as f64;
    let (low, high, part) = between(table, mean)?;
    Some(low + part * (high - low))
}

/// Where the mass of an element comes from.
#[derive(Default)]
struct Mass {
    /// Its material; empty: its section has moduli of its own.
    material: String,
    /// What its section gives [M/L3].
    density: Option<f64>,
}

/// Thickness, of a line its area, and what the section that an element belongs to is made of.
fn section(index: usize, draft: &mut Draft) -> Option<(f64, Mass)> {
    let section = section_of(index, draft)?;
    let (thickness, density) = match &section.body {
        Body::Solid { thickness, .. } => (thickness.unwrap_or(1.0), None),
        Body::Beam { shape, density, .. } => (shape.area(), *density),
    };
    Some((thickness, Mass { material: section.material.clone(), density }))
}

/// The section that an element belongs to.
fn section_of(index: usize, draft: &mut Draft) -> Option<&Section> {
    let label = draft.elements[index].label;
    if draft.section_of.is_empty() {
        for (place, section) in draft.sections.clone().into_iter().enumerate() {
            for member in draft.element_sets.labels(&section.set).unwrap_or_default() {
                draft.section_of.entry(member).or_insert(place);
            }
        }
    }
    draft.sections.get(*draft.section_of.get(&label)?)
}
