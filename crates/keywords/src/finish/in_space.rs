//! Contact of nodes with faces in space.

use std::collections::HashSet;

use slideline_model::{ContactFace, Dialect, Master, MasterFaces, NodeIndex};

use super::sides::{Parts, Sides, Slaves, refuse};
use super::surfaces::{Found, Touching, faces_between};
use crate::draft::Draft;
use crate::surfaces::Pairing;

/// Contact of nodes with faces in space.
pub(super) fn at_nodes_in_space(
    pairing: &Pairing,
    (slave, master): (Found, MasterFaces),
    draft: &mut Draft,
) -> Parts {
    let help = "contact in space is between faces of solids: give the slave as elements with their \
                faces, or as nodes of such faces";
    let slaves = match slave {
        Found::Faces(faces) => Slaves { faces, ..Slaves::default() },
        Found::Nodes(nodes) => slaves_of_nodes(pairing, nodes, draft)?,
        Found::Facets(_) | Found::Rigid(_) | Found::Swept(_) => {
            let [name, other] = [&pairing.slave.name, &pairing.master.name];
            let message = format!("{name} is not made of faces in space, {other} is");
            return refuse(pairing.slave.span, message, help, draft);
        }
    };
    Some((slaves, Master::Faces(master)))
}

/// Faces of solids as a master.
pub(super) fn faces_of(pairing: &Pairing, sides: &Sides, faces: Vec<ContactFace>) -> MasterFaces {
    let (smooth, extension) = (pairing.smooth > 0.0, pairing.extension);
    MasterFaces { faces, smooth, extension, swept: None, origin: sides.master.origin }
}

/// Slave nodes in space with the faces that give them areas: those all of whose nodes are in the
/// surface, or in CalculiX all free faces at a node.
fn slaves_of_nodes(pairing: &Pairing, nodes: Vec<NodeIndex>, draft: &mut Draft) -> Option<Slaves> {
    let name = &pairing.slave.name;
    let every = draft.dialect == Dialect::Calculix;
    let which = if every { Touching::AnyNode } else { Touching::AllNodes };
    let faces = faces_between(&nodes, which, pairing.slave.span, draft);
    let covered: HashSet<NodeIndex> =
        faces.iter().flat_map(|face| face.nodes.iter().copied()).collect();
    let Some(&bare) = nodes.iter().find(|node| !covered.contains(node)) else {
        let nodes = if every { nodes } else { Vec::new() };
        return Some(Slaves { faces, nodes, ..Slaves::default() });
    };
    let bare = draft.model.nodes.label(bare);
    let (message, help) = match every {
        true => (
            format!("node {bare} of {name} has no area: it belongs to no free face of a solid"),
            "a slave node stands for its share of the free faces that it belongs to",
        ),
        false => (
            format!(
                "node {bare} of {name} has no area: no face of a solid has all its nodes in the \
                 surface"
            ),
            "contact in space is between faces of solids: give the slave as elements with their \
             faces, or as nodes of such faces",
        ),
    };
    refuse(pairing.slave.span, message, help, draft);
    None
}
