//! Masters in the plane that are in several pieces: each is a master of its own.
//!
//! ```text
//!     |  s  |        a hook s in a slot: both walls are one surface, and two lines; what slides on one of
//!    _|     |_       them has one direction of travel, so there are two pairs
//! ```

use slideline_diag::{Code, Diagnostic};
use slideline_model::NodeIndex;

use super::chain::{Broken, Chain, Facet};
use super::hollows::{Outlines, joined};
use super::master_chain::{of_no_chain, one_face_each};
use super::one_node::is_at;
use super::surfaces::Found;
use crate::draft::Draft;
use crate::surfaces::{NamedSurface, Pairing};

/// The pieces of a master that the slaves can meet, one where its faces are one line or are not those of solids.
pub(super) fn pieces(
    pairing: &Pairing,
    surface: &NamedSurface,
    (slave, master): (&Found, Found),
    draft: &mut Draft,
) -> Vec<Found> {
    let facets = match master {
        Found::Facets(facets) if facets.iter().all(|facet| facet.face.is_some()) => facets,
        other => return vec![other],
    };
    let ends = |facets: &[Facet]| facets.iter().map(|facet| facet.nodes).collect::<Vec<_>>();
    let places: Vec<[NodeIndex; 2]> = match slave {
        Found::Facets(slaves) => ends(slaves),
        Found::Nodes(nodes) => nodes.iter().map(|&node| [node; 2]).collect(),
        Found::Faces(_) | Found::Rigid(_) | Found::Swept(_) => return vec![Found::Facets(facets)],
    };
    if joined(&ends(&facets)).len() < 2 {
        return vec![Found::Facets(facets)];
    }
    let Some(whole) = one_face_each(pairing, &facets, draft) else { return Vec::new() };
    let mut met = within_reach(whole, &places, draft);
    if let [_, second, ..] = &joined(&ends(&met))[..] {
        let apart = Broken::Apart(met[second[0]].nodes[0]);
        let said = of_no_chain(pairing, (surface, &met), apart, draft);
        // ends at one place may be joined by links
        join(&mut met, &said, draft);
    }
    let found = joined(&ends(&met));
    if found.len() > 1 {
        let name = |piece: usize| {
            format!("{}/{}", pairing.slave.name, numbered(&pairing.master.name, piece))
        };
        let to = if found.len() == 2 { "and" } else { "to" };
        let message = format!(
            "{} is in {} pieces that slaves can meet: each is a master of its own, in pairs {} {to} {}",
            pairing.master.name,
            found.len(),
            name(0),
            name(found.len() - 1)
        );
        let note = Diagnostic::note(Code("SL0431"), message).at(pairing.master.span);
        draft.log.push(note.help("no action is needed: cards that name the pair mean all of them"));
    }
    let piece = |own: Vec<usize>| Found::Facets(own.into_iter().map(|place| met[place]).collect());
    found.into_iter().map(piece).collect()
}

/// The name of a piece of a surface.
pub(super) fn numbered(name: &str, piece: usize) -> String {
    format!("{name}#{}", piece + 1)
}

/// The faces that something may meet: not the walls of hollows in which nothing stands, nor what is outside
/// a hollow in which all does.
fn within_reach(facets: Vec<Facet>, places: &[[NodeIndex; 2]], draft: &Draft) -> Vec<Facet> {
    let nodes = &draft.model.nodes;
    let ends: Vec<_> = facets.iter().map(|facet| facet.nodes).collect();
    let pieces = joined(&ends);
    let piece = |own: &Vec<usize>| {
        let of_solids = own.iter().all(|&face| facets[face].face.is_some());
        (own.iter().map(|&face| ends[face]).collect(), of_solids)
    };
    let outlines = Outlines::new(&pieces.iter().map(piece).collect::<Vec<_>>(), nodes);
    let mut met = vec![false; pieces.len()];
    for own in joined(places) {
        let own: Vec<NodeIndex> = own.into_iter().flat_map(|place| places[place]).collect();
        met.iter_mut().zip(outlines.met_by(&own, nodes)).for_each(|(met, may)| *met |= may);
    }
    let mut kept = vec![false; facets.len()];
    let all = pieces.iter().zip(met).filter(|(_, met)| *met);
    all.flat_map(|(piece, _)| piece).for_each(|&face| kept[face] = true);
    let faces = facets.iter().zip(&kept).filter(|(_, kept)| **kept).map(|(face, _)| *face);
    let faces: Vec<Facet> = faces.collect();
    if faces.is_empty() { facets } else { faces }
}

/// Makes a chain or a ring of pieces of faces of solids, where an end of one is at the end of another: that
/// node then stands for both. Whether they are one is known when links are: `said` is the complaint if not.
fn join(facets: &mut [Facet], said: &Diagnostic, draft: &mut Draft) {
    if facets.iter().any(|facet| facet.face.is_none()) {
        return;
    }
    let mut joined = facets.to_vec();
    let mut both = Vec::new();
    let nodes: Vec<NodeIndex> = facets.iter().flat_map(|facet| facet.nodes).collect();
    let mut count = std::collections::HashMap::new();
    nodes.iter().for_each(|node| *count.entry(*node).or_insert(0) += 1);
    let mut ends: Vec<(usize, NodeIndex)> = Vec::new();
    for (k, &node) in nodes.iter().enumerate().filter(|(_, node)| count[*node] == 1) {
        let near = |&&(other, end): &&(usize, NodeIndex)| {
            is_at(node, end, &facets[k / 2].nodes, draft)
                && is_at(node, end, &facets[other / 2].nodes, draft)
        };
        match ends.iter().find(near) {
            Some(&(_, end)) => {
                joined[k / 2].nodes[k % 2] = end;
                both.push([node, end]);
            }
            None if ends.len() < MOST_ENDS => ends.push((k, node)),
            None => return,
        }
    }
    if let Ok(_) | Err(Broken::Loop(_)) = Chain::find(&joined) {
        facets.copy_from_slice(&joined);
        draft.joined_ends.extend(both.into_iter().map(|both| (both, said.clone())));
    }
}

/// More ends of pieces than this are not compared with one another.
const MOST_ENDS: usize = 1000;
