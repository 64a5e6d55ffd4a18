//! Elements with their sections and stiffnesses become blocks.

use slideline_diag::{Code, Diagnostic, Span};
use slideline_mech::element::b22::axis_runs_forward;
use slideline_mech::material::Elastic;
use slideline_model::{
    Allowable, BeamBlock, BeamElement, BeamSection, ElementBlock, NodeIndex, SpringBlock,
    SpringElement, SpringKind,
};

use crate::draft::{Draft, Element, ElementKind, Section, Spring};
use crate::rule::Subject;

/// `*BEAM SECTION` with its elements and its material.
pub(super) fn beams(draft: &mut Draft) {
    let mut owner = vec![None; draft.elements.len()];
    for section in draft.sections.clone() {
        let Some(found) = draft.elements_of(&section.set, section.set_span) else { continue };
        let mut elements: [Vec<BeamElement>; 3] = Default::default();
        for index in found {
            let element = draft.elements[index];
            if claim(&element, &mut owner[index], &section, draft) {
                let kind = ElementKind::BEAMS.iter().position(|&kind| kind == element.kind);
                elements[kind.unwrap_or(0)].extend(beam(&element, draft));
            }
        }
        if let Some(material) = material(&section, draft) {
            let shape = BeamSection {
                width: section.width,
                height: section.height,
                poisson: section.poisson,
                material,
                shear: section.shear,
            };
            beam_blocks(&section, shape, elements, draft);
        }
    }
    allowables(draft);
    let owned: Vec<bool> = owner.iter().map(Option::is_some).collect();
    for kind in ElementKind::BEAMS {
        without(kind, "*BEAM SECTION", &owned, draft);
    }
}

/// A block for every type of beam in a section's set; one without elements
/// where there are none at all.
fn beam_blocks(
    section: &Section,
    shape: BeamSection,
    elements: [Vec<BeamElement>; 3],
    draft: &mut Draft,
) {
    let none = elements.iter().all(Vec::is_empty);
    let variants = [ElementBlock::B21, ElementBlock::B22, ElementBlock::B23];
    for (place, (elements, variant)) in elements.into_iter().zip(variants).enumerate() {
        if !elements.is_empty() || (none && place == 0) {
            let (name, origin) = (section.set.clone(), section.origin);
            let block = BeamBlock { name, section: shape, elements, origin };
            draft.model.blocks.push(variant(block));
        }
    }
}

/// Allowables of the blocks whose material has one.
fn allowables(draft: &mut Draft) {
    for allowable in draft.allowables.clone() {
        if !draft.materials.iter().any(|material| material.name == allowable.material) {
            no_material(&allowable.material, allowable.material_span, draft);
        }
        let sections = draft.sections.iter().filter(|own| own.material == allowable.material);
        let origins: Vec<Span> = sections.map(|section| section.origin).collect();
        for (place, block) in draft.model.blocks.iter().enumerate() {
            let Some(block) = block.beams().filter(|block| origins.contains(&block.origin)) else {
                continue;
            };
            let modulus = block.section.material.modulus;
            let strain = allowable.strain.or(allowable.stress.map(|stress| stress / modulus));
            draft.model.allowables.extend(strain.map(|strain| Allowable {
                block: place,
                strain,
                stress: allowable.stress,
                origin: allowable.origin,
            }));
        }
    }
}

/// Gives an element to a section; false where it is no beam or is taken.
fn claim(
    element: &Element,
    owner: &mut Option<slideline_diag::Span>,
    section: &Section,
    draft: &mut Draft,
) -> bool {
    if !element.kind.is_beam() {
        let message = format!(
            "element {} of the set {} is of type {}, which has no beam section",
            element.label,
            section.set,
            element.kind.name()
        );
        let error = Diagnostic::error(Code("SL0325"), message).at(section.set_span);
        draft.consequence(Subject::Elements, error);
        return false;
    }
    if let Some(first) = *owner {
        let message = format!("element {} has two sections", element.label);
        let error = Diagnostic::error(Code("SL0320"), message).at(section.set_span);
        draft.consequence(Subject::Elements, error.label(first, "the first one"));
        return false;
    }
    *owner = Some(section.origin);
    true
}

fn beam(element: &Element, draft: &mut Draft) -> Option<BeamElement> {
    let mut nodes = draft.ends_of(element)?;
    let middle = if element.kind == ElementKind::B22 {
        // In the deck the nodes stand in order along the beam.
        let last = draft.model.nodes.find(element.nodes[2])?;
        Some(std::mem::replace(&mut nodes[1], last))
    } else {
        None
    };
    if draft.has_no_length(element, nodes) || !middle_is_sound(element, nodes, middle, draft) {
        return None;
    }
    Some(BeamElement { label: element.label, nodes, middle, origin: element.origin })
}

/// Complains about a middle node so far from the middle that the axis would
/// turn back; false if so.
fn middle_is_sound(
    element: &Element,
    [first, last]: [NodeIndex; 2],
    middle: Option<NodeIndex>,
    draft: &mut Draft,
) -> bool {
    let Some(middle) = middle else { return true };
    let reference = [first, middle, last].map(|node| draft.model.nodes.plane(node));
    let sound = axis_runs_forward(&reference);
    if !sound {
        let label = |node| draft.model.nodes.label(node);
        let message = format!(
            "element {}: its middle node {} is not in the middle half between {} and {}",
            element.label,
            label(middle),
            label(first),
            label(last)
        );
        let error = Diagnostic::error(Code("SL0345"), message).at(element.origin);
        let help = "B22 takes its nodes in order along the beam: end, middle, end";
        draft.consequence(Subject::Nodes, error.help(help));
    }
    sound
}

fn material(section: &Section, draft: &mut Draft) -> Option<Elastic> {
    let found = draft.materials.iter().find(|material| material.name == section.material).cloned();
    let Some(material) = found else {
        no_material(&section.material, section.material_span, draft);
        return None;
    };
    if !material.has_card {
        let message = format!("the material {} has no *ELASTIC", material.name);
        let error = Diagnostic::error(Code("SL0309"), message).at(material.origin);
        draft.consequence(Subject::Sections, error.help("put *ELASTIC behind *MATERIAL: E, nu"));
    }
    material.elastic
}

fn no_material(name: &str, span: Span, draft: &mut Draft) {
    let message = format!("there is no material {name}");
    let mut error = Diagnostic::error(Code("SL0308"), message).at(span);
    let names = draft.materials.iter().map(|material| material.name.as_str());
    if let Some(near) = slideline_deck::nearest(name, names) {
        error = error.help(format!("did you mean {near}?"));
    }
    draft.consequence(Subject::Sections, error);
}

/// Complains about elements that no card gave a stiffness.
fn without(kind: ElementKind, card: &str, owned: &[bool], draft: &mut Draft) {
    let lonely = |&(index, element): &(usize, &Element)| element.kind == kind && !owned[index];
    let count = draft.elements.iter().enumerate().filter(lonely).count();
    let Some((_, first)) = draft.elements.iter().enumerate().find(lonely) else { return };
    let more = if count > 1 { format!(" (and {} more)", count - 1) } else { String::new() };
    let message = format!("element {}{more} of type {} has no {card}", first.label, kind.name());
    let error = Diagnostic::error(Code("SL0307"), message).at(first.origin);
    if draft.is_complete(Subject::Elements) {
        draft.consequence(Subject::Sections, error);
    }
}

/// `*SPRING` with its elements.
pub(super) fn springs(draft: &mut Draft) {
    let mut owned = vec![false; draft.elements.len()];
    for spring in draft.springs.clone() {
        let Some(found) = draft.elements_of(&spring.set, spring.set_span) else { continue };
        for kind in [ElementKind::Spring1, ElementKind::SpringA] {
            spring_block(&spring, kind, &found, &mut owned, draft);
        }
        if let Some(&index) = found.iter().find(|&&index| !draft.elements[index].kind.is_spring()) {
            let element = draft.elements[index];
            let message = format!(
                "element {} of the set {} is of type {}, which is not a spring",
                element.label,
                spring.set,
                element.kind.name()
            );
            let error = Diagnostic::error(Code("SL0325"), message).at(spring.set_span);
            draft.consequence(Subject::Elements, error);
        }
    }
    for kind in [ElementKind::Spring1, ElementKind::SpringA] {
        without(kind, "*SPRING", &owned, draft);
    }
}

fn spring_block(
    spring: &Spring,
    kind: ElementKind,
    found: &[usize],
    owned: &mut [bool],
    draft: &mut Draft,
) {
    let mut elements = Vec::new();
    for &index in found {
        let mut element = draft.elements[index];
        if element.kind != kind {
            continue;
        }
        owned[index] = true;
        if kind == ElementKind::Spring1 {
            element.nodes[1] = element.nodes[0];
        }
        let Some(nodes) = draft.ends_of(&element) else { continue };
        if kind == ElementKind::SpringA && draft.has_no_length(&element, nodes) {
            continue;
        }
        elements.push(SpringElement { label: element.label, nodes, origin: element.origin });
    }
    if elements.is_empty() {
        return;
    }
    let kind = match (kind, spring.dof) {
        (ElementKind::Spring1, Some(dof)) if dof.is_plane() => SpringKind::Ground(dof),
        (ElementKind::Spring1, given) => {
            let message = match given {
                Some(dof) => format!("a plane model has no dof {}", dof.number()),
                None => "SPRING1 needs its degree of freedom on the first data line".to_owned(),
            };
            let error = Diagnostic::error(Code("SL0251"), message).at(spring.origin);
            draft.consequence(Subject::Sections, error);
            return;
        }
        _ => SpringKind::Axial,
    };
    let (name, stiffness, origin) = (spring.set.clone(), spring.stiffness, spring.origin);
    let block = SpringBlock { name, stiffness, kind, elements, origin };
    draft.model.blocks.push(ElementBlock::Spring(block));
}
