//! A surface that meets itself: in the plane its faces in runs, in space its faces.
//!
//! ```text
//!   o->-o->-o->-o      open        .->-.
//!                                  |   |  closed: the outside is on the left of travel
//!                                  '-<-'
//! ```

use std::collections::{HashMap, HashSet};

use slideline_diag::{Code, Diagnostic};
use slideline_model::{
    ContactFace, Formulation, Master, MasterFaces, NodeIndex, OwnSurface, SurfaceRun,
};

use super::chain::Facet;
use super::sides::{Parts, Slaves, refuse};
use super::surfaces::{Found, between_nodes};
use crate::draft::Draft;
use crate::rule::Subject;
use crate::surfaces::{NamedSurface, Pairing};

/// `SMOOTH` of a surface that meets itself where it is absent (manual) [1].
const SMOOTH: f64 = 0.2;

/// Slaves and master of a surface of faces of solids that meets itself.
pub(super) fn own_surface(
    pairing: &Pairing,
    surface: &NamedSurface,
    found: Found,
    draft: &mut Draft,
) -> Parts {
    let name = &pairing.slave.name;
    let facets = match found {
        Found::Facets(facets) if facets.iter().all(|facet| facet.face.is_some()) => facets,
        Found::Faces(faces) => return in_space(pairing, surface, faces, draft),
        Found::Facets(_) => {
            let message = format!("contact of the beams of {name} with themselves");
            return unsupported(pairing, message, draft);
        }
        Found::Nodes(_) | Found::Rigid(_) | Found::Swept(_) => {
            let message = format!("{name} has no faces that could meet one another");
            let help =
                "name a *SURFACE of elements with their faces, or a master surface behind it";
            return refuse(pairing.slave.span, message, help, draft);
        }
    };
    if is_adjusted(pairing, draft) {
        return None;
    }
    let runs = match runs(&facets) {
        Ok(runs) => runs,
        Err(node) => {
            let node = draft.model.nodes.label(node);
            let message = format!("faces of {name} fold back or branch at node {node}");
            let help = "name each outer face of the part once, and none inside it";
            return refuse(pairing.slave.span, message, help, draft);
        }
    };
    say(pairing, draft);
    let (smooth, extension) = (pairing.smooth.unwrap_or(SMOOTH), pairing.extension);
    let master = OwnSurface { runs, smooth, extension, origin: surface.origin };
    let slaves = Slaves { elements: between_nodes(&facets), ..Slaves::default() };
    Some((slaves, Master::Itself(master)))
}

/// The same of faces in space.
fn in_space(
    pairing: &Pairing,
    surface: &NamedSurface,
    faces: Vec<ContactFace>,
    draft: &mut Draft,
) -> Parts {
    if is_adjusted(pairing, draft) {
        return None;
    }
    say(pairing, draft);
    let (smooth, extension) = (pairing.smooth != Some(0.0), pairing.extension);
    let (swept, meets_itself, origin) = (None, true, surface.origin);
    let slaves = Slaves { faces: faces.clone(), ..Slaves::default() };
    let master = MasterFaces { faces, smooth, extension, swept, meets_itself, origin };
    Some((slaves, Master::Faces(master)))
}

/// Complains where an overclosure of the start is to be taken away.
fn is_adjusted(pairing: &Pairing, draft: &mut Draft) -> bool {
    let Some((_, span)) = &pairing.adjust else { return false };
    let error = Diagnostic::error(Code("SL0221"), "ADJUST of a surface that meets itself");
    let help = "leave it out: an overclosure at the start is resolved in the first increment, with \
                strain";
    draft.consequence(Subject::Contact, error.at(*span).help(help));
    true
}

fn unsupported(pairing: &Pairing, message: String, draft: &mut Draft) -> Parts {
    let error = Diagnostic::error(Code("SL0221"), format!("{message} is not supported"));
    let help = "faces of solids may meet themselves; else name two surfaces that share no node";
    draft.consequence(Subject::Contact, error.at(pairing.slave.span).help(help));
    None
}

/// What follows from one surface in place of two.
fn say(pairing: &Pairing, draft: &mut Draft) {
    let name = &pairing.slave.name;
    let message = match pairing.alone {
        true => format!("{name} meets itself"),
        false => format!("{name} is both sides of this contact: it meets itself"),
    };
    let note = Diagnostic::note(Code("SL0361"), message).at(pairing.origin);
    let help = match pairing.formulation {
        Formulation::NodeToSurface => {
            "the program chooses which of two faces that meet carries the points"
        }
        _ => {
            "its contact is sampled at its nodes, as TYPE=NODE TO SURFACE; the program chooses \
             which of two faces that meet carries them"
        }
    };
    draft.log.push(note.help(help));
}

/// The runs of faces, travelled with the material on the right; a node at which more than two of
/// them meet, or two that look against one another.
fn runs(facets: &[Facet]) -> Result<Vec<SurfaceRun>, NodeIndex> {
    let (mut next, mut entered) = (HashMap::new(), HashSet::new());
    let mut order = Vec::new();
    for facet in facets.iter().flat_map(Facet::parts) {
        // the material is on the left of a facet's own direction
        let [to, from] = facet.nodes;
        if next.insert(from, to).is_some() {
            return Err(from);
        }
        if !entered.insert(to) {
            return Err(to);
        }
        order.push(from);
    }
    let mut taken = HashSet::new();
    let mut runs = Vec::new();
    let open = order.iter().filter(|&node| !entered.contains(node));
    for &start in open.chain(&order) {
        if taken.contains(&start) {
            continue;
        }
        let mut nodes = vec![start];
        taken.insert(start);
        let mut here = start;
        while let Some(&to) = next.get(&here).filter(|&&to| to != start) {
            taken.insert(to);
            nodes.push(to);
            here = to;
        }
        let is_closed = next.contains_key(&here);
        if is_closed && nodes.len() < 3 {
            return Err(start);
        }
        runs.push(SurfaceRun { nodes, is_closed });
    }
    Ok(runs)
}

#[cfg(test)]
mod tests {
    use super::*;
    use slideline_diag::Span;

    fn facet(nodes: [NodeIndex; 2]) -> Facet {
        let (middle, origin) = (None, Span::default());
        Facet { label: 1, nodes, middle, origin, side: None, face: Some(0) }
    }

    fn found(facets: &[[NodeIndex; 2]]) -> Result<Vec<(Vec<NodeIndex>, bool)>, NodeIndex> {
        let facets: Vec<_> = facets.iter().map(|&nodes| facet(nodes)).collect();
        Ok(runs(&facets)?.into_iter().map(|run| (run.nodes, run.is_closed)).collect())
    }

    /// Requirement: runs are found whatever the order of the faces, open ones first, with the
    /// material on the right.
    #[test]
    fn faces_stand_in_runs() {
        assert_eq!(found(&[[1, 0], [3, 2], [2, 1]]), Ok(vec![(vec![0, 1, 2, 3], false)]));
        assert_eq!(found(&[[1, 0], [2, 1], [0, 2]]), Ok(vec![(vec![0, 1, 2], true)]));
        let two = found(&[[1, 0], [2, 1], [0, 2], [6, 5]]);
        assert_eq!(two, Ok(vec![(vec![5, 6], false), (vec![0, 1, 2], true)]));
    }

    /// Requirement: where faces branch or look against one another the node is named.
    #[test]
    fn folds_and_branches_are_named() {
        assert_eq!(found(&[[1, 0], [2, 0]]), Err(0));
        assert_eq!(found(&[[2, 0], [2, 1]]), Err(2));
        assert_eq!(found(&[[1, 0], [0, 1]]), Err(0), "both sides of one face");
    }
}
