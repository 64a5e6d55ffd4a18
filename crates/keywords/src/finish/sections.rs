//! Elements with their sections and stiffnesses become blocks.

use slideline_diag::{Code, Diagnostic, Span};
use slideline_mech::element::b22::axis_runs_forward;
use slideline_mech::element::solid::{smallest_jacobian, worst_node};
use slideline_model::{
    Allowable, Dialect, ElementBlock, ElementType, Elements, Kinematics, NodeIndex, TYPES,
};

use super::axes_of_elements::SectionAxes;
use super::beam_normals::Normals;
use super::changed_sections::parted;
use super::fibres;
use super::materials::{in_plane_stress, lines_have_no_axes, material, no_material};
use super::middle_nodes::past_the_quarter;
use super::space_beams as space;
use crate::draft::{Draft, Element, ElementKind, Section};
use crate::rule::Subject;

/// Section cards with their elements and their material.
pub(super) fn sections(draft: &mut Draft) {
    let mut owner = vec![None; draft.elements.len()];
    let sections = draft.sections.clone();
    let normals = Normals::of(draft);
    let found = named(&sections, draft);
    for (section, found) in &parted(&sections, found, draft) {
        let axes = SectionAxes::named(section.orientation.as_ref(), draft);
        let mut claimed: Vec<(&'static ElementType, Elements)> = Vec::new();
        let mut pointing: Vec<space::Pointing> = Vec::new();
        for &index in found {
            let element = draft.elements[index];
            let Some(row) = claim(&element, &mut owner[index], section, draft) else { continue };
            if !claimed.iter().any(|(kind, _)| *kind == row) {
                claimed.push((row, Elements::new(row.cell.nodes)));
            }
            if let Some(nodes) = nodes(&element, row, draft)
                && axes.as_ref().and_then(|axes| axes.of(index)).is_none_or(|own| {
                    let at = (&nodes[..], section.set_span);
                    super::orientations::suits(&own, (&element, row), at, draft)
                })
                && let Some(direction) = space::direction(&element, &nodes, draft)
                && let Some(direction) =
                    normals.turned(index, (row, &nodes), (section, direction), draft)
                && space::is_sound((section, direction), (&element, row), &nodes, draft)
            {
                if let Some(direction) = direction {
                    draft.first_axes.insert(index, direction);
                }
                let own = match direction {
                    Some(direction) => space::pointing(direction, row, &mut pointing),
                    None => claimed.iter_mut().find(|(kind, _)| *kind == row).map(|own| &mut own.1),
                };
                let label = element.label;
                own.into_iter().for_each(|own| own.push(label, &nodes, element.origin));
            }
        }
        let Some(axes) = axes else { continue };
        in_plane_stress(section, &claimed, draft);
        lines_have_no_axes(section, &claimed, draft);
        let made = material(section, draft).and_then(|made| fibres::laid(section, made, draft));
        if let Some(made) = made {
            blocks((section, &axes), &made, (claimed, pointing), draft);
        }
    }
    allowables(draft);
    // what has no section is looked at all the same
    for index in (0..draft.elements.len()).filter(|&index| owner[index].is_none()) {
        let element = draft.elements[index];
        if let ElementKind::Structural(row) = element.kind {
            nodes(&element, row, draft);
        }
    }
    let owned: Vec<bool> = owner.iter().map(Option::is_some).collect();
    let elements = draft.elements.iter().zip(&owned);
    let lonely = elements.filter(|(element, owned)| !**owned && element.kind.card().is_some());
    let lonely: Vec<ElementKind> = lonely.map(|(element, _)| element.kind).collect();
    for row in TYPES.into_iter().filter(|row| lonely.contains(&ElementKind::Structural(row))) {
        if let Some(card) = row.kinematics.card().filter(|_| row.joins()) {
            without(row, card, &owned, draft);
        }
    }
}

/// The elements that each section names; in CalculiX a later section takes those of an earlier one.
fn named(sections: &[Section], draft: &mut Draft) -> Vec<Option<Vec<usize>>> {
    let mut found: Vec<Option<Vec<usize>>> =
        sections.iter().map(|section| draft.elements_of(&section.set, section.set_span)).collect();
    if draft.dialect != Dialect::Calculix {
        return found;
    }
    let mut later = vec![false; draft.elements.len()];
    for (section, own) in sections.iter().zip(&mut found).rev() {
        let Some(own) = own else { continue };
        let count = own.len();
        own.retain(|&index| !std::mem::replace(&mut later[index], true));
        if own.len() < count {
            let message = format!("a later section takes {} of these elements", count - own.len());
            draft.log.note("SL0253", message, section.set_span);
        }
    }
    found
}

/// A block for every type of element in a section's set, in the order of the
/// table; one without elements where there are none at all.
fn blocks(
    (section, axes): (&Section, &SectionAxes),
    made: &slideline_model::Section,
    (mut claimed, pointing): (Vec<(&'static ElementType, Elements)>, Vec<space::Pointing>),
    draft: &mut Draft,
) {
    claimed.retain(|(_, elements)| !elements.is_empty());
    let none = claimed.is_empty() && pointing.is_empty();
    let of_card =
        TYPES.into_iter().filter(|row| row.kinematics.card() == Some(section.body.card()));
    for (place, row) in of_card.enumerate() {
        let own = claimed.iter().position(|(kind, _)| *kind == row);
        if own.is_some() || (none && place == 0) {
            let mut block = ElementBlock::new(row, &section.set, made.clone(), section.origin);
            if let Some(own) = own {
                block.elements = claimed.swap_remove(own).1;
                block.section = axes.put_on(block.section, &block.elements, draft);
            }
            draft.model.blocks.push(block);
        }
        let turned = pointing.iter().filter(|own| own.kind == row);
        draft.model.blocks.extend(turned.map(|own| own.block(section, made)));
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
        let (limit, origin) = (allowable.limit, allowable.origin);
        let blocks = draft.model.blocks.iter().enumerate();
        let own = blocks.filter(|(_, block)| origins.contains(&block.origin));
        let own: Vec<Allowable> =
            own.map(|(block, _)| Allowable { block, limit, origin }).collect();
        draft.model.allowables.extend(own);
    }
}

/// Gives an element to a section; `None` where it takes none like it or is taken.
fn claim(
    element: &Element,
    owner: &mut Option<slideline_diag::Span>,
    section: &Section,
    draft: &mut Draft,
) -> Option<&'static ElementType> {
    let card = section.body.card();
    let needs_none = element.kind.is_reference() || element.kind.is_gap();
    if needs_none && draft.dialect == Dialect::Calculix {
        return None; // a section is no harm to it there
    }
    let row = match element.kind {
        ElementKind::Structural(row) if row.kinematics.card() == Some(card) => row,
        kind => {
            let what = card.trim_start_matches('*').to_lowercase();
            let message = format!(
                "element {} of the set {} is of type {}, which has no {what}",
                element.label,
                section.set,
                kind.name()
            );
            let mut error = Diagnostic::error(Code("SL0325"), message).at(section.set_span);
            if let Some(own) = kind.card().filter(|_| !kind.is_beam()) {
                error = error.help(format!("its card is {own}"));
            }
            draft.consequence(Subject::Elements, error);
            return None;
        }
    };
    if let Some(first) = *owner {
        let message = format!("element {} has two sections", element.label);
        let error = Diagnostic::error(Code("SL0320"), message).at(section.set_span);
        draft.consequence(Subject::Elements, error.label(first, "the first one"));
        return None;
    }
    *owner = Some(section.origin);
    Some(row)
}

/// Its nodes, where they make a sound element.
fn nodes(element: &Element, row: &ElementType, draft: &mut Draft) -> Option<Vec<NodeIndex>> {
    let labels = element.nodes().iter();
    let nodes: Vec<NodeIndex> =
        labels.map(|&label| draft.model.nodes.find(label)).collect::<Option<_>>()?;
    let sound = match *nodes {
        _ if row.is_truss() || row.is_space_beam() => bar_is_sound(element, &nodes, draft),
        [first, last] if row.is_beam() => !draft.has_no_length(element, [first, last]),
        [first, middle, last] if row.is_beam() => {
            !draft.has_no_length(element, [first, last])
                && middle_is_sound(element, [first, middle, last], draft)
        }
        _ => solid_is_sound(element, row, &nodes, draft),
    };
    sound.then_some(nodes)
}

/// Complains about a truss or a beam in space without length, or whose middle node lies so far from the middle that
/// its axis would turn back; false if so.
fn bar_is_sound(element: &Element, nodes: &[NodeIndex], draft: &mut Draft) -> bool {
    let (Some(&first), Some(&last)) = (nodes.first(), nodes.last()) else { return false };
    if draft.has_no_length(element, [first, last]) {
        return false;
    }
    let &[first, middle, last] = nodes else { return true };
    let [a, b, c] = [first, middle, last].map(|node| draft.model.nodes.position(node));
    let chord: [f64; 3] = std::array::from_fn(|k| c[k] - a[k]);
    let part = (0..3).map(|k| (b[k] - a[k]) * chord[k]).sum::<f64>()
        / chord.iter().map(|part| part * part).sum::<f64>();
    let sound = part > 0.25 && part < 0.75;
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
        let help = "give the nodes in their order along the axis: end, middle, end";
        draft.consequence(Subject::Nodes, error.help(help));
    }
    sound
}

/// Complains about a solid whose nodes do not run around it as its type wants them, or that is
/// folded; false if so.
fn solid_is_sound(
    element: &Element,
    row: &ElementType,
    nodes: &[NodeIndex],
    draft: &mut Draft,
) -> bool {
    let Kinematics::Solid { rule, .. } = row.kinematics else { return true };
    let at: Vec<[f64; 3]> = nodes.iter().map(|&node| draft.model.nodes.position(node)).collect();
    if row.is_ring() && !is_beside_the_axis(element, &at, draft) {
        return false;
    }
    let sound = smallest_jacobian(row.cell, rule, &at) > 0.0;
    if !sound {
        let mirrored: Vec<[f64; 3]> = at.iter().map(|&[x, y, z]| [-x, y, z]).collect();
        let wrong_way = smallest_jacobian(row.cell, rule, &mirrored) > 0.0;
        let (what, help) = match (wrong_way, row.cell.name) {
            (true, "quad4") => (
                "its nodes run clockwise",
                "turn their order round: first, fourth, third, second node",
            ),
            (true, _) if row.cell.dimension == 2 => {
                ("its nodes run clockwise", "give its corners counter-clockwise")
            }
            (true, _) => (
                "its nodes run the wrong way round",
                "give the corners of its first face counter-clockwise as seen from inside",
            ),
            (false, _) if row.cell.dimension == 2 => (
                "it is folded or far re-entrant",
                "give its corners in their order around it, and none of its inner angles much over \
                 180 degrees",
            ),
            (false, _) => (
                "it is flat, folded or far re-entrant",
                "give its nodes in the order of its type, middle nodes near the middle of their edges",
            ),
        };
        let worst = match wrong_way {
            true => String::new(),
            false => format!(
                ", worst at its node {}",
                draft.model.nodes.label(nodes[worst_node(row.cell, &at)])
            ),
        };
        let message = format!("element {}: {what}{worst}", element.label);
        let error = Diagnostic::error(Code("SL0346"), message).at(element.origin);
        draft.consequence(Subject::Nodes, error.help(help));
    } else {
        past_the_quarter(element, row, nodes, draft);
    }
    sound
}

/// Part of an element's width by which rounding may take a node across the axis [1].
const ROUNDING: f64 = 1e-9;

/// Complains about a ring with a node at a negative radius; false if so.
fn is_beside_the_axis(element: &Element, at: &[[f64; 3]], draft: &mut Draft) -> bool {
    let radii = || at.iter().map(|x| x[0]);
    let (inner, outer) = (radii().fold(f64::INFINITY, f64::min), radii().fold(0.0, f64::max));
    let beside = inner >= -ROUNDING * (outer - inner);
    if !beside {
        let across = element.nodes().iter().zip(radii()).find(|(_, radius)| *radius == inner);
        let node = across.map_or(String::new(), |(node, _)| format!(" of its node {node}"));
        let message = format!(
            "element {}: the radius{node} is negative, {inner:?}; the first coordinate of an \
             axisymmetric element is its distance from the axis",
            element.label
        );
        let error = Diagnostic::error(Code("SL0350"), message).at(element.origin);
        let help = "model the half on the side of positive first coordinates";
        draft.consequence(Subject::Nodes, error.help(help));
    }
    beside
}

/// Complains about a middle node so far from the middle that the axis would
/// turn back; false if so.
fn middle_is_sound(
    element: &Element,
    [first, middle, last]: [NodeIndex; 3],
    draft: &mut Draft,
) -> bool {
    let reference = [first, middle, last].map(|node| draft.model.nodes.position(node));
    let reference = reference.map(|[x, y, _]| [x, y]);
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

/// Complains about elements that no card gave a stiffness.
pub(super) fn without(row: &'static ElementType, card: &str, owned: &[bool], draft: &mut Draft) {
    let kind = ElementKind::Structural(row);
    let lonely = |&(index, element): &(usize, &Element)| !owned[index] && element.kind == kind;
    let count = draft.elements.iter().enumerate().filter(lonely).count();
    let Some((_, first)) = draft.elements.iter().enumerate().find(lonely) else { return };
    let more = if count > 1 { format!(" (and {} more)", count - 1) } else { String::new() };
    let message = format!("element {}{more} of type {} has no {card}", first.label, kind.name());
    let error = Diagnostic::error(Code("SL0307"), message).at(first.origin);
    if draft.is_complete(Subject::Elements) {
        draft.consequence(Subject::Sections, error);
    }
}
