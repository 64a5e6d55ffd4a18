//! Masters in the plane that are in several pieces: each is a master of its own.
//!
//! ```text
//!     |  s  |        a hook s in a slot: both walls are one surface, and two lines; what slides on one of
//!    _|     |_       them has one direction of travel, so there are two pairs
//! ```

use slideline_diag::{Code, Diagnostic};
use slideline_model::NodeIndex;

use super::chain::{Broken, Facet};
use super::hollows::joined;
use super::master_chain::{join, of_no_chain, within_reach};
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
    let mut met = within_reach(facets, &places, draft);
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
