//! Surfaces that `*SECTION PRINT` names: their faces and the elements behind them.

use std::collections::HashMap;

use slideline_diag::{Code, Diagnostic};
use slideline_mech::pressure::Face;
use slideline_model::{
    ElementBlock, ElementIndex, NodeIndex, Section, SectionFace, SectionPrint, SectionShare,
};

use super::behind::behind;
use super::faces::faces;
use crate::draft::Draft;
use crate::rule::Subject;
use crate::surfaces::Named;

/// Requests with the faces of their surfaces; those whose surface has none are complained about.
pub(super) fn with_faces(asked: &[(SectionPrint, Named)], draft: &mut Draft) -> Vec<SectionPrint> {
    if asked.is_empty() {
        return Vec::new();
    }
    let places: HashMap<u64, ElementIndex> = places(&draft.model.blocks).collect();
    let own = asked.iter().filter_map(|(print, surface)| own(print, surface, &places, draft));
    own.collect()
}

/// The elements of all blocks by their labels.
fn places(blocks: &[ElementBlock]) -> impl Iterator<Item = (u64, ElementIndex)> + '_ {
    let all = blocks.iter().enumerate();
    all.flat_map(|(block, own)| {
        own.elements.iter().enumerate().map(move |(at, element)| (element.label, (block, at)))
    })
}

fn own(
    print: &SectionPrint,
    surface: &Named,
    places: &HashMap<u64, ElementIndex>,
    draft: &mut Draft,
) -> Option<SectionPrint> {
    let found = draft.surface(surface)?;
    let solids = faces(&found, surface.span, draft);
    let mut print = print.clone();
    let mut elements: Vec<(ElementIndex, &[NodeIndex])> = Vec::new();
    for solid in &solids {
        let label = draft.elements[solid.element].label;
        let Some(&element) = places.get(&label) else { continue }; // its section is missing
        let block = &draft.model.blocks[element.0];
        let Some(face) = solid.face.and_then(|_| face(block, solid.nodes.len())) else {
            let message =
                format!("the surface {} has lines, through which nothing is cut", surface.name);
            let error = Diagnostic::error(Code("SL0332"), message).at(surface.span);
            draft.consequence(Subject::Contact, error.help("name faces of solids"));
            return None;
        };
        print.faces.push(SectionFace { face, nodes: solid.nodes.clone() });
        elements.push((element, &solid.nodes));
    }
    let shares = behind(&elements, (&draft.model.blocks, &|node| draft.model.nodes.position(node)))
        .into_iter();
    print.shares = shares.map(|(element, nodes)| SectionShare { element, nodes }).collect();
    Some(print)
}

/// What a face of so many nodes is at an element of a block.
fn face(block: &ElementBlock, nodes: usize) -> Option<Face> {
    let Section::Solid(section) = &block.section else { return None };
    match block.kind.is_ring() {
        true => Face::of_ring(nodes),
        false => Face::of(block.kind.cell.dimension, nodes, section.thickness),
    }
}
