//! Thickness that nodes give to the plane solids around them.

use std::collections::HashMap;

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::Dialect;

use crate::draft::{Body, Draft, ElementKind, Section};
use crate::rule::Subject;

/// The thickness of every section of plane solids whose nodes have one: it must be even.
pub(super) fn of_nodes(draft: &mut Draft) {
    let asks = |own: &Section| matches!(own.body, Body::Solid { by_nodes: true, .. });
    if draft.thicknesses.is_empty() && !draft.sections.iter().any(asks) {
        return;
    }
    let mut at: HashMap<u64, (f64, Span)> = HashMap::new();
    for line in std::mem::take(&mut draft.thicknesses) {
        for node in draft.nodes_of(&line.target, line.target_span) {
            at.insert(draft.model.nodes.label(node), (line.thickness, line.origin));
        }
    }
    for place in 0..draft.sections.len() {
        let section = draft.sections[place].clone();
        let Body::Solid { by_nodes, thickness } = section.body else { continue };
        let Some(found) = of_section(&section, &at, draft) else {
            if by_nodes && thickness.is_none() {
                none_given(&section, draft);
            }
            continue;
        };
        match found {
            Ok((_, origin)) | Err(origin) if !by_nodes => without_effect(&section, origin, draft),
            Ok((thickness, _)) => {
                let thickness = Some(thickness);
                draft.sections[place].body = Body::Solid { thickness, by_nodes };
            }
            Err(origin) => {
                let message =
                    "a thickness that changes over the elements of a section is not supported";
                let error = Diagnostic::error(Code("SL0221"), message).at(origin);
                let error = error.label(section.origin, "the section");
                let help = "give every thickness a *SOLID SECTION of its own elements";
                draft.consequence(Subject::Sections, error.help(help));
            }
        }
    }
}

/// A section that asks for what none of its nodes has.
fn none_given(section: &Section, draft: &mut Draft) {
    let message = format!("no node of the elements of {} has a thickness", section.set);
    let help = "give it on the data line of *SOLID SECTION, and leave NODAL THICKNESS out";
    let said = match draft.dialect {
        // there nodes give thicknesses to shells alone
        Dialect::Abaqus => Diagnostic::note(Code("SL0257"), message + ": it is one"),
        Dialect::Calculix => Diagnostic::error(Code("SL0221"), message),
    };
    draft.consequence(Subject::Sections, said.at(section.origin).help(help));
}

/// A section takes the thickness of its nodes where it says so alone, as in CalculiX.
fn without_effect(section: &Section, origin: Span, draft: &mut Draft) {
    let message =
        format!("the elements of {} do not take the thickness of their nodes", section.set);
    let note = Diagnostic::note(Code("SL0257"), message).at(origin);
    let note = note.label(section.origin, "its thickness, one where none is given, acts");
    draft.log.push(note.help("they do with *SOLID SECTION, NODAL THICKNESS"));
}

/// The thickness of the nodes of the plane solids of a section; `Err`: a node that has another one
/// or none, `None`: none of them has one.
fn of_section(
    section: &Section,
    at: &HashMap<u64, (f64, Span)>,
    draft: &Draft,
) -> Option<Result<(f64, Span), Span>> {
    let labels = draft.element_sets.labels(&section.set)?;
    let elements = labels.iter().filter_map(|label| draft.element_by_label.get(label));
    let plane = elements.map(|&index| &draft.elements[index]).filter(|element| {
        matches!(element.kind, ElementKind::Structural(row)
            if row.joins() && !row.is_spatial() && !row.is_ring() && !row.is_truss())
    });
    let nodes: Vec<u64> =
        plane.flat_map(|element| element.nodes()).map(|&node| draft.uncut(node)).collect();
    let first = nodes.iter().find_map(|node| at.get(node))?;
    let other = nodes.iter().find(|node| at.get(node).is_none_or(|own| own.0 != first.0));
    Some(match other {
        Some(node) => Err(at.get(node).unwrap_or(first).1),
        None => Ok(*first),
    })
}
