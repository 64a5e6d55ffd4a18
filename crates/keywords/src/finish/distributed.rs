//! Loads on faces and volumes: pressures stay pressures, the rest becomes forces on nodes.

use std::collections::HashMap;

use slideline_diag::{Code, Diagnostic, Span};
use slideline_mech::pressure::Face;
use slideline_mech::volume;
use slideline_model::{self as model, Dof, Load, NodeIndex, Pressure};

use super::faces::{self, SolidFace, face_nodes};
use crate::distributed::{Distributed, Kind, On};
use crate::draft::{Body, Draft, ElementKind};
use crate::log::Target;
use crate::rule::Subject;

/// What rests on an element: pressures and forces.
#[derive(Clone, Default)]
pub(super) struct InForce {
    list: Vec<Entry>,
    place: HashMap<(usize, (u8, usize)), usize>,
}

#[derive(Clone)]
struct Entry {
    what: What,
    value: f64,
    amplitude: Option<usize>,
    origin: Span,
}

#[derive(Clone)]
enum What {
    Pressure(Face, Vec<NodeIndex>),
    /// Forces of a unit load.
    Forces(Vec<(NodeIndex, Dof, f64)>),
}

impl InForce {
    /// What a further step copies.
    pub fn size(&self) -> usize {
        self.list.len()
    }

    /// A value that followed an amplitude keeps what it had at the end.
    pub fn settle(&mut self, factor: impl Fn(&mut Option<usize>) -> f64) {
        self.list.iter_mut().for_each(|entry| entry.value *= factor(&mut entry.amplitude));
    }

    /// The loads of a step.
    pub fn loads(&self) -> model::Distributed {
        let mut loads = model::Distributed::default();
        for Entry { what, value, amplitude, origin } in &self.list {
            let (value, amplitude, origin) = (*value, *amplitude, *origin);
            match what {
                What::Pressure(face, nodes) => {
                    let (face, nodes) = (*face, nodes.clone());
                    loads.pressures.push(Pressure { face, nodes, value, amplitude, origin });
                }
                What::Forces(forces) => {
                    loads.forces.extend(forces.iter().map(|&(node, dof, share)| Load {
                        node,
                        dof,
                        value: share * value,
                        amplitude,
                        origin,
                    }));
                }
            }
        }
        loads
    }

    /// Puts a line into force; it replaces what rests there in the same way.
    pub fn take(&mut self, line: &Distributed, amplitude: Option<usize>, draft: &mut Draft) {
        for (element, key, what) in resolve(line, draft) {
            let entry = Entry { what, value: line.value, amplitude, origin: line.origin };
            match self.place.get(&(element, key)) {
                Some(&at) => self.list[at] = entry,
                None => {
                    self.place.insert((element, key), self.list.len());
                    self.list.push(entry);
                }
            }
        }
    }
}

type Resolved = Vec<(usize, (u8, usize), What)>;

fn resolve(line: &Distributed, draft: &mut Draft) -> Resolved {
    match (&line.on, line.kind) {
        (On::Elements(target, span), Kind::Pressure(Some(face))) => {
            let mut all = Vec::new();
            for index in elements(target, *span, draft) {
                match face_nodes(index, Some(face), draft) {
                    Some(nodes) => {
                        let face =
                            SolidFace { element: index, face: Some(face), nodes, span: *span };
                        all.push(face);
                    }
                    None => faces::no_face(index, face, line.origin, draft),
                }
            }
            all.into_iter().filter_map(|face| on_face(&face, line, draft)).collect()
        }
        (On::Surface(named), _) => {
            let Some(surface) = draft.surface(named) else { return Vec::new() };
            let all = faces::faces(&surface, draft);
            all.into_iter().filter_map(|face| on_face(&face, line, draft)).collect()
        }
        (On::Elements(target, span), kind) => {
            let found = elements(target, *span, draft);
            found.into_iter().filter_map(|index| on_volume(index, kind, line, draft)).collect()
        }
    }
}

/// The elements that a line names; all of them where it names none.
fn elements(target: &Target, span: Span, draft: &mut Draft) -> Vec<usize> {
    match target {
        Target::Set(set) if set.is_empty() => (0..draft.elements.len()).collect(),
        Target::Set(set) => draft.elements_of(set, span).unwrap_or_default(),
        Target::Label(label) => {
            let found = draft.element_by_label.get(label).copied();
            if found.is_none() {
                let message = format!("element {label} is not defined");
                let error = Diagnostic::error(Code("SL0308"), message).at(span);
                draft.consequence(Subject::Elements, error);
            }
            found.into_iter().collect()
        }
    }
}

fn on_face(
    own: &SolidFace,
    line: &Distributed,
    draft: &mut Draft,
) -> Option<(usize, (u8, usize), What)> {
    let element = draft.elements[own.element];
    let ElementKind::Structural(row) = element.kind else { return None };
    let thickness = section(own.element, draft).map_or(1.0, |(thickness, _)| thickness);
    let face = own.face.and_then(|_| match row.is_ring() {
        true => Face::of_ring(own.nodes.len()),
        false => Face::of(row.cell.dimension, own.nodes.len(), thickness),
    });
    let Some(face) = face else {
        let message = format!("a {} element takes no pressure on a face", element.kind.name());
        let error = Diagnostic::error(Code("SL0221"), message).at(line.origin);
        draft.consequence(Subject::Elements, error.help("use *CLOAD on its nodes"));
        return None;
    };
    let number = own.face.map_or(0, |face| face + 1);
    let what = match line.kind {
        Kind::Traction(direction) => {
            let x: Vec<[f64; 3]> =
                own.nodes.iter().map(|&node| draft.model.nodes.get(node).position).collect();
            let mut forces = vec![[0.0; 3]; x.len()];
            face.pull(direction, &x, &mut forces);
            What::Forces(shares(&own.nodes, &forces, draft))
        }
        _ => What::Pressure(face, own.nodes.clone()),
    };
    Some((own.element, (line.kind.key().0, number), what))
}

/// Forces on nodes, those that are zero or out of a plane model left out.
fn shares(nodes: &[NodeIndex], forces: &[[f64; 3]], draft: &Draft) -> Vec<(NodeIndex, Dof, f64)> {
    let axes = draft.model.directions();
    let each = nodes
        .iter()
        .zip(forces)
        .flat_map(|(&node, force)| (0..3).map(move |k| (node, Dof::ALL[k], force[k])));
    each.filter(|(_, dof, share)| *share != 0.0 && axes.contains(dof)).collect()
}

fn on_volume(
    index: usize,
    kind: Kind,
    line: &Distributed,
    draft: &mut Draft,
) -> Option<(usize, (u8, usize), What)> {
    let element = draft.elements[index];
    let ElementKind::Structural(row) = element.kind else { return None };
    let everything = matches!(&line.on, On::Elements(Target::Set(set), _) if set.is_empty());
    let nodes = face_nodes(index, None, draft)?;
    let x: Vec<[f64; 3]> = nodes.iter().map(|&node| draft.model.nodes.get(node).position).collect();
    let (thickness, material) = section(index, draft).unwrap_or((1.0, String::new()));
    let density = match kind {
        Kind::Body(_) => 1.0,
        _ => match draft.densities.get(&material) {
            Some(&density) => density,
            None if everything || !row.joins() => return None,
            None => {
                let message = format!("the material {material} has no *DENSITY for this load");
                let error = Diagnostic::error(Code("SL0309"), message).at(line.origin);
                draft.consequence(Subject::Sections, error);
                return None;
            }
        },
    };
    let body = |at: [f64; 3]| -> [f64; 3] {
        match kind {
            Kind::Body(axis) => std::array::from_fn(|k| if k == axis { 1.0 } else { 0.0 }),
            Kind::Gravity(direction) => direction.map(|d| density * d),
            Kind::Centrifugal(point, axis) => {
                let arm: [f64; 3] = std::array::from_fn(|k| at[k] - point[k]);
                let along: f64 = (0..3).map(|k| arm[k] * axis[k]).sum();
                std::array::from_fn(|k| density * (arm[k] - along * axis[k]))
            }
            _ => [0.0; 3],
        }
    };
    // a ring is as thick as its circle
    let ring = row.is_ring();
    let thickness = if ring { 2.0 * std::f64::consts::PI } else { thickness };
    let weighted = |at: [f64; 3]| body(at).map(|force| if ring { at[0] * force } else { force });
    let Some(forces) = volume::spread(row.cell, thickness, &x, weighted) else {
        if !everything && row.joins() {
            let message = format!("a {} element takes no load per volume", element.kind.name());
            let error = Diagnostic::error(Code("SL0221"), message).at(line.origin);
            draft.consequence(Subject::Elements, error.help("use *CLOAD on its nodes"));
        }
        return None;
    };
    let what = What::Forces(shares(&nodes, &forces, draft));
    Some((index, line.kind.key(), what))
}

/// Thickness and material of the section that an element belongs to.
fn section(index: usize, draft: &mut Draft) -> Option<(f64, String)> {
    let label = draft.elements[index].label;
    if draft.section_of.is_empty() {
        for (place, section) in draft.sections.clone().into_iter().enumerate() {
            for member in draft.element_sets.labels(&section.set).unwrap_or_default() {
                draft.section_of.entry(member).or_insert(place);
            }
        }
    }
    let section = draft.sections.get(*draft.section_of.get(&label)?)?;
    let thickness = match section.body {
        Body::Solid { thickness, .. } => thickness,
        Body::Beam { .. } => 1.0,
    };
    Some((thickness, section.material.clone()))
}
