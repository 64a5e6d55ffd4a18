//! Contact of nodes with faces in space.

use std::collections::HashSet;

use slideline_diag::{Code, Diagnostic};
use slideline_model::{ContactFace, Dialect, Formulation, Master, MasterFaces, NodeIndex};

use super::sides::{Parts, Sides, Slaves, refuse};
use super::surfaces::{Found, Touching, between_nodes, faces_between, stretches};
use crate::draft::{Draft, Element, ElementKind};
use crate::surfaces::{NamedSurface, Pairing};

/// Contact of nodes with faces in space.
pub(super) fn at_nodes_in_space(
    pairing: &Pairing,
    (surface, slave, master): (&NamedSurface, Found, MasterFaces),
    draft: &mut Draft,
) -> Parts {
    let help = "slaves in space are faces of solids, beams and trusses, or nodes of these";
    let slaves = match slave {
        Found::Faces(faces) => Slaves { faces, ..Slaves::default() },
        Found::Nodes(nodes) if are_of_lines(&nodes, draft) => {
            Slaves { elements: stretches(surface, &nodes, draft), ..Slaves::default() }
        }
        Found::Nodes(nodes) => slaves_of_nodes(pairing, nodes, draft)?,
        Found::Facets(facets) if facets.iter().all(|facet| facet.face.is_none()) => {
            Slaves { elements: between_nodes(&facets), ..Slaves::default() }
        }
        Found::Facets(_) | Found::Rigid(_) | Found::Swept(_) => {
            let [name, other] = [&pairing.slave.name, &pairing.master.name];
            let message = format!("{name} is not made of faces in space, {other} is");
            return refuse(pairing.slave.span, message, help, draft);
        }
    };
    Some((slaves, Master::Faces(master)))
}

/// Whether several nodes all belong to beams and trusses.
fn are_of_lines(nodes: &[NodeIndex], draft: &Draft) -> bool {
    let lines = draft.elements.iter().filter(|element| element.kind.is_line());
    let all: HashSet<u64> = lines.flat_map(|element| element.nodes().iter().copied()).collect();
    nodes.len() > 1 && nodes.iter().all(|&node| all.contains(&draft.model.nodes.label(node)))
}

/// Complains of beams and trusses in space that meet something else than faces, or not at their
/// nodes.
pub(super) fn lines_fit(
    pairing: &Pairing,
    (first, second): (&Found, &Found),
    draft: &mut Draft,
) -> bool {
    let is_line = |found: &Found| matches!(found, Found::Facets(_));
    if !draft.model.is_in_space() || !(is_line(first) || is_line(second)) {
        return true;
    }
    let is_met = matches!(second, Found::Faces(_) | Found::Swept(_));
    let is_integrated =
        pairing.formulation == Formulation::SurfaceToSurface && !matches!(second, Found::Swept(_));
    if is_line(first) && is_met && !is_integrated {
        return true;
    }
    let message = "beams and trusses in space are slaves of faces and of analytical surfaces, at their \
                   nodes";
    let help = "name them first, with TYPE=NODE TO SURFACE, and faces of solids, a rigid mesh or \
                *SURFACE, TYPE=CYLINDER or REVOLUTION second";
    let _: Parts = refuse(pairing.origin, message, help, draft);
    false
}

/// Faces of solids as a master.
pub(super) fn faces_of(pairing: &Pairing, sides: &Sides, faces: Vec<ContactFace>) -> MasterFaces {
    let (smooth, extension) = (pairing.smooth != Some(0.0), pairing.extension);
    MasterFaces {
        faces,
        smooth,
        extension,
        swept: None,
        meets_itself: false,
        origin: sides.master.origin,
    }
}

/// Slave nodes in space with the faces that give them areas: those all of whose nodes are in the
/// surface. In CalculiX, and where a node has none of these, all free faces at a node; nodes within
/// a solid never touch and are left out.
fn slaves_of_nodes(pairing: &Pairing, nodes: Vec<NodeIndex>, draft: &mut Draft) -> Option<Slaves> {
    let span = pairing.slave.span;
    let covered = |faces: &[ContactFace]| -> HashSet<NodeIndex> {
        faces.iter().flat_map(|face| face.nodes.iter().copied()).collect()
    };
    if draft.dialect == Dialect::Abaqus {
        let faces = faces_between(&nodes, Touching::AllNodes, span, draft);
        let covered = covered(&faces);
        if nodes.iter().all(|node| covered.contains(node)) {
            return Some(Slaves { faces, ..Slaves::default() });
        }
    }
    let faces = faces_between(&nodes, Touching::AnyNode, span, draft);
    let covered = covered(&faces);
    let (outer, others): (Vec<NodeIndex>, Vec<NodeIndex>) =
        nodes.into_iter().partition(|node| covered.contains(node));
    let inner = if others.is_empty() { HashSet::new() } else { of_solids(draft) };
    let is_strange = |node: &&NodeIndex| !inner.contains(&draft.model.nodes.label(**node));
    let strange = others.iter().find(is_strange).or(match outer[..] {
        [] => others.first(),
        _ => None,
    });
    if let Some(&bare) = strange {
        let bare = draft.model.nodes.label(bare);
        let name = &pairing.slave.name;
        let message =
            format!("node {bare} of {name} has no area: it belongs to no free face of a solid");
        let help = "a slave node stands for its share of the free faces that it belongs to";
        refuse(span, message, help, draft);
        return None;
    }
    if !others.is_empty() {
        let message = format!("{} nodes within solids never touch: left out", others.len());
        draft.log.push(Diagnostic::note(Code("SL0254"), message).at(span));
    }
    let counts_sides = draft.dialect == Dialect::Calculix;
    Some(Slaves { faces, nodes: outer, counts_sides, ..Slaves::default() })
}

/// The numbers of the nodes of volumes.
fn of_solids(draft: &Draft) -> HashSet<u64> {
    let solid = |element: &&Element| matches!(element.kind, ElementKind::Structural(row) if row.cell.dimension == 3);
    let solids = draft.elements.iter().filter(solid);
    solids.flat_map(|element| element.nodes().iter().copied()).collect()
}
