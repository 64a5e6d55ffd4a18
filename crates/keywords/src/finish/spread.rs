//! Contact that is integrated over faces of solids: mortar.
//!
//! ```text
//!      o-----o-----o      the master: faces; in the plane beams or an analytical surface too
//!    o----o-----o         the slave: faces of solids, which meet smoothly, or at corners
//!                \
//! ```

use std::collections::HashMap;

use slideline_diag::{Code, Diagnostic};
use slideline_model::{ContactFace, Master, MasterFaces, NodeIndex};

use super::chain::Facet;
use super::master_chain::slide_line;
use super::sides::{Parts, Sides, Slaves, refuse};
use super::surfaces::{Found, between_nodes};
use crate::draft::Draft;
use crate::surfaces::Pairing;

/// Contact spread over the faces of the slave.
pub(super) fn spread(
    pairing: &Pairing,
    sides: &Sides,
    (slave, master): (Found, Found),
    draft: &mut Draft,
) -> Parts {
    let (slave_name, master_name) = (&pairing.slave.name, &pairing.master.name);
    let (facets, master, surface) = match (slave, master) {
        (Found::Faces(slave), Found::Faces(master)) => {
            return in_space(pairing, sides, (slave, master), draft);
        }
        (Found::Faces(_), _) => {
            let message = format!("{slave_name} is made of faces in space, {master_name} is not");
            let help = "contact in space is between faces of solids: give the master as elements \
                        with their faces";
            return refuse(pairing.master.span, message, help, draft);
        }
        (Found::Facets(_) | Found::Rigid(_), Found::Faces(_)) => {
            let message = format!("{slave_name} is not made of faces in space, {master_name} is");
            let help = "contact in space is between faces of solids: give the slave as elements \
                        with their faces";
            return refuse(pairing.slave.span, message, help, draft);
        }
        (Found::Rigid(surface), Found::Facets(facets)) => {
            let message =
                format!("contact is integrated over {master_name}, named slave or master");
            let note = Diagnostic::note(Code("SL0335"), message).at(pairing.origin);
            draft.log.push(note.help("the order of the two surfaces does not change the result"));
            (facets, Found::Rigid(surface), &sides.slave)
        }
        (Found::Facets(facets), master) => (facets, master, &sides.master),
        (Found::Nodes(_) | Found::Rigid(_) | Found::Swept(_), _) => {
            let message = format!("contact cannot be integrated over the nodes of {slave_name}");
            let help =
                "define the slave by elements with their faces, or give TYPE=NODE TO SURFACE";
            return refuse(pairing.slave.span, message, help, draft);
        }
    };
    if let Some(beam) = facets.iter().find(|facet| facet.face.is_none()) {
        let message = format!(
            "element {} of {slave_name} is a beam: SURFACE TO SURFACE against faces of solids is \
             integrated over faces of solids",
            beam.label
        );
        let help = "name the solids first, as the slave, or give TYPE=NODE TO SURFACE";
        return refuse(pairing.slave.span, message, help, draft);
    }
    sound(&facets, pairing, draft)?;
    let elements = between_nodes(&facets);
    let master = match master {
        Found::Rigid(surface) => Master::RigidSurface(surface),
        Found::Facets(facets) => {
            Master::SlideLine(slide_line(pairing, surface, (&facets, &elements), draft)?)
        }
        Found::Nodes(_) | Found::Faces(_) | Found::Swept(_) => {
            let message = format!("the node surface {master_name} has no segments to slide on");
            let help = "give the master as elements, or name it first with TYPE=NODE TO SURFACE";
            return refuse(pairing.master.span, message, help, draft);
        }
    };
    Some((Slaves { elements, of_solids: true, ..Slaves::default() }, master))
}

/// Contact spread over the faces of a slave in space.
fn in_space(
    pairing: &Pairing,
    sides: &Sides,
    (faces, master): (Vec<ContactFace>, Vec<ContactFace>),
    draft: &mut Draft,
) -> Parts {
    let mut known: HashMap<Vec<NodeIndex>, u64> = HashMap::new();
    for face in &faces {
        let mut key = face.nodes.clone();
        key.sort_unstable();
        let Some(other) = known.insert(key, face.label) else { continue };
        let message = format!(
            "the faces of elements {other} and {} of {} lie on one another",
            face.label, pairing.slave.name
        );
        let help = "a slave surface is the outside of its bodies: name every face once";
        return refuse(pairing.slave.span, message, help, draft);
    }
    let (origin, extension) = (sides.master.origin, pairing.extension);
    let master = Master::Faces(MasterFaces {
        faces: master,
        swept: None,
        smooth: false,
        extension,
        meets_itself: false,
        origin,
    });
    Some((Slaves { faces, ..Slaves::default() }, master))
}

/// Faces of a slave meet two by two, one after the other: none is there twice, none is folded back
/// upon another.
fn sound(facets: &[Facet], pairing: &Pairing, draft: &mut Draft) -> Option<()> {
    let (mut begins, mut ends) = (HashMap::new(), HashMap::new());
    for facet in facets {
        let [from, to] = facet.nodes;
        let twice = [begins.insert(from, facet), ends.insert(to, facet)].into_iter().flatten();
        let folded = begins.get(&to).copied().filter(|other| other.nodes[1] == from);
        for other in twice.chain(folded) {
            if (other.label, other.face) == (facet.label, facet.face) {
                continue;
            }
            let message = format!(
                "the faces of elements {} and {} of {} lie on one another or make a branch",
                other.label, facet.label, pairing.slave.name
            );
            let help = "a slave surface is the outside of its bodies: each node joins two faces at \
                        most";
            refuse(pairing.slave.span, message, help, draft);
            return None;
        }
    }
    Some(())
}
