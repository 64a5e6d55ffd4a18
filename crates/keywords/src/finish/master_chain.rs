//! Beams as the master of a contact pair: their chain, and the face that is
//! turned to the slaves.
//!
//! ```text
//!       o  o  o      slaves
//!
//!   o------o------o  travel to the right puts the outward normal up: SPOS of
//!                    beams that run to the right
//! ```

use slideline_diag::{Code, Diagnostic};
use slideline_model::{ContactElement, Formulation, NodeIndex, SlideLine};

use super::chain::{Broken, Chain, Facet, Travel};
use super::facing::places;
use super::hollows::DISTANCES;
use crate::crossing::crossing;
use crate::draft::Draft;
use crate::rule::Subject;
use crate::surfaces::{NamedSurface, Pairing};

/// The master chain of a surface of beams, its outer side to the slaves.
pub(super) fn slide_line(
    pairing: &Pairing,
    surface: &NamedSurface,
    (facets, slaves): (&[Facet], &[ContactElement]),
    draft: &mut Draft,
) -> Option<SlideLine> {
    let whole = one_face_each(pairing, facets, draft)?;
    let middles: Vec<_> = whole.iter().filter_map(|facet| facet.middle).collect();
    let facets: Vec<Facet> = whole.iter().flat_map(Facet::parts).collect();
    let found = match Chain::find(&facets) {
        Err(Broken::Loop(_)) if whole.len() > 2 => {
            Chain::ring(&facets, seam(&whole, slaves, draft))
        }
        found => found,
    };
    let mut chain = match found {
        Ok(chain) => chain,
        Err(broken) => {
            not_a_chain(pairing, (surface, &whole), broken, draft);
            return None;
        }
    };
    warn_of_crossing(pairing, (&chain, &facets), draft);
    // faces of solids look outward, and have no label that could be the wrong one
    let has_label = facets.iter().any(|facet| facet.face.is_none());
    let mean = mean_distance(&chain, slaves, draft).filter(|_| has_label);
    match chain.travel(&facets) {
        Travel::AsFound => behind(mean, pairing, draft),
        Travel::Reversed => {
            chain.reverse();
            behind(mean.map(|(distance, length)| (-distance, length)), pairing, draft);
        }
        Travel::Open => {
            let nodes: Vec<_> = slaves.iter().flat_map(|element| element.nodes).collect();
            let mean = mean_of(&chain, &places(&nodes, draft), draft);
            choose_side(&mut chain, mean, pairing, draft)?;
        }
        Travel::Contradiction(first, second) => {
            let [first, second] = [first, second].map(|place| facets[place].label);
            let message = format!(
                "the faces of elements {first} and {second} of {} point to opposite sides",
                pairing.master.name
            );
            let help = "one of the elements runs the other way: give its face the other label";
            undecided(pairing, message, help, draft);
            return None;
        }
    }
    Some(drawn(chain.nodes, &middles, pairing, surface))
}

/// The line of these nodes as its pair draws it.
fn drawn(
    nodes: Vec<NodeIndex>,
    middles: &[NodeIndex],
    pairing: &Pairing,
    surface: &NamedSurface,
) -> SlideLine {
    let middles = match pairing.formulation {
        Formulation::SurfaceToSurface if !middles.is_empty() => {
            let middles: std::collections::HashSet<_> = middles.iter().collect();
            nodes.iter().map(|node| middles.contains(node)).collect()
        }
        _ => Vec::new(),
    };
    let smooth = match pairing.formulation {
        Formulation::NodeToSurface => pairing.smooth,
        // what is integrated needs no smooth corners
        _ => Some(0.0),
    };
    let (extension, origin) = (pairing.extension, surface.origin);
    let mut line = SlideLine { nodes, middles, smooth, extension, origin };
    line.join_ends();
    line
}

/// Says so where a chain crosses itself.
fn warn_of_crossing(pairing: &Pairing, (chain, facets): (&Chain, &[Facet]), draft: &mut Draft) {
    let place = |node: NodeIndex| {
        let [x, y, _] = draft.model.nodes.position(node);
        [x, y]
    };
    let parts: Vec<_> =
        chain.nodes.windows(2).map(|ends| vec![place(ends[0]), place(ends[1])]).collect();
    let Some(found) = crossing(&parts) else { return };
    let of_part = |part: usize| chain.steps.get(part).map(|&(place, _)| facets[place]);
    let [Some(earlier), Some(later)] = found.parts.map(of_part) else { return };
    let [x, y] = found.at;
    let message = format!(
        "{} crosses itself at ({x:.4e}, {y:.4e}), where elements {} and {} meet",
        pairing.master.name, earlier.label, later.label
    );
    let said = Diagnostic::warning(Code("SL0339"), message).at(later.origin);
    let said = said.label(earlier.origin, "the element that it crosses");
    draft.consequence(
        Subject::Nodes,
        said.help(
            "beyond the crossing the outside of one element is the inside of another, and contact \
             there means nothing: correct the nodes, or give each part a surface of its own",
        ),
    );
}

/// Where what closes on itself begins and ends: its node that is farthest from the slaves.
fn seam(facets: &[Facet], slaves: &[ContactElement], draft: &Draft) -> NodeIndex {
    let at = |node: NodeIndex| draft.model.nodes.position(node);
    let looked_at = (DISTANCES / facets.len().max(1)).clamp(1, LOOKED_AT);
    let some = slaves.iter().step_by(slaves.len().div_ceil(looked_at).max(1));
    let near: Vec<_> = some.flat_map(|element| element.nodes).map(at).collect();
    let distance = |node: NodeIndex| {
        let place = at(node);
        let square = |other: &[f64; 3]| (0..2).map(|k| (place[k] - other[k]).powi(2)).sum::<f64>();
        near.iter().map(square).fold(f64::INFINITY, f64::min)
    };
    let ends = facets.iter().map(|facet| facet.nodes[0]).map(|node| (distance(node), node));
    let farthest = ends.reduce(|known, other| if other.0 > known.0 { other } else { known });
    farthest.map_or(0, |(_, node)| node)
}

/// A master turns one face to its slaves.
pub(super) fn one_face_each(
    pairing: &Pairing,
    facets: &[Facet],
    draft: &mut Draft,
) -> Option<Vec<Facet>> {
    let mut once = std::collections::HashMap::new();
    let mut kept: Vec<Facet> = Vec::with_capacity(facets.len());
    for facet in facets {
        let Some(&place) = once.get(&(facet.label, facet.face)) else {
            once.insert((facet.label, facet.face), kept.len());
            kept.push(*facet);
            continue;
        };
        if kept[place].side.is_some() && facet.side.is_some() {
            let message =
                format!("element {} of {} has both faces", facet.label, pairing.master.name);
            let help = "a master has one contact face: SPOS or SNEG, not both";
            undecided(pairing, message, help, draft);
            return None;
        }
        kept[place].side = kept[place].side.or(facet.side);
    }
    Some(kept)
}

fn undecided(pairing: &Pairing, message: String, help: &str, draft: &mut Draft) {
    let error = Diagnostic::error(Code("SL0331"), message).at(pairing.master.span);
    draft.consequence(Subject::Contact, error.help(help));
}

fn not_a_chain(
    pairing: &Pairing,
    (surface, facets): (&NamedSurface, &[Facet]),
    broken: Broken,
    draft: &mut Draft,
) {
    let said = of_no_chain(pairing, (surface, facets), broken, draft);
    draft.consequence(Subject::Elements, said);
}

pub(super) fn of_no_chain(
    pairing: &Pairing,
    (surface, facets): (&NamedSurface, &[Facet]),
    broken: Broken,
    draft: &Draft,
) -> Diagnostic {
    let label = |node| draft.model.nodes.label(node);
    let name = &pairing.master.name;
    let of_solids = facets.iter().all(|facet| facet.face.is_some());
    let (one, many) = if of_solids { ("face", "faces") } else { ("beam", "beams") };
    let (message, help) = match broken {
        Broken::Branch(node) => (
            format!("three or more {many} of {name} meet at node {}", label(node)),
            "define a surface and a pair for each branch",
        ),
        Broken::Loop(node) => (
            format!("the {many} of {name} form a closed ring at node {}", label(node)),
            "a master has two open ends: leave out an element that nothing slides on",
        ),
        Broken::Apart(node) => (
            format!("node {} of {name} is not connected to its first {one}", label(node)),
            match of_solids {
                true => {
                    "define a surface and a pair for each piece, and leave out faces between two \
                     elements, on which nothing can slide"
                }
                false => "define a surface and a pair for each piece",
            },
        ),
    };
    let error = Diagnostic::error(Code("SL0329"), message).at(pairing.master.span);
    error.label(surface.origin, "the surface").help(help)
}

/// So many stretches of slaves are looked at, evenly chosen, to tell their
/// side; fewer where the master is very long.
const LOOKED_AT: usize = 1000;

/// Mean signed distance of the slaves from the chain, and mean length of
/// their nearest segments [L]; `None` where they stand on both sides alike.
fn mean_distance(chain: &Chain, slaves: &[ContactElement], draft: &Draft) -> Option<(f64, f64)> {
    let nodes = slaves.iter().flat_map(|element| element.nodes);
    let places: Vec<_> = nodes.map(|node| draft.model.nodes.position(node)).collect();
    mean_of(chain, &places, draft)
}

/// The same of places [L].
fn mean_of(chain: &Chain, places: &[[f64; 3]], draft: &Draft) -> Option<(f64, f64)> {
    let looked_at = 2 * (DISTANCES / chain.nodes.len().max(1)).clamp(1, LOOKED_AT);
    let (mut signed, mut size, mut lengths, mut count) = (0.0, 0.0, 0.0, 0.0);
    for &place in places.iter().step_by(places.len().div_ceil(looked_at).max(1)) {
        let (distance, length) = chain.distance(&draft.model.nodes, place);
        signed += distance;
        size += distance.abs();
        lengths += length;
        count += 1.0;
    }
    (signed.abs() > 1e-6 * size).then(|| (signed / count, lengths / count))
}

/// Without a label the master turns to where its slaves are.
fn choose_side(
    chain: &mut Chain,
    mean: Option<(f64, f64)>,
    pairing: &Pairing,
    draft: &mut Draft,
) -> Option<()> {
    let (slave, master) = (&pairing.slave.name, &pairing.master.name);
    let Some((distance, _)) = mean else {
        let message = format!("{slave} lies on both sides of {master}, which has no face label");
        undecided(pairing, message, "give its elements a face: SPOS or SNEG", draft);
        return None;
    };
    if distance < 0.0 {
        chain.reverse();
    }
    let side = match chain.label() {
        Some(side) => format!("its face {}", side.name()),
        None => "the face".to_owned(),
    };
    let ends = [chain.nodes.first(), chain.nodes.last()];
    let [from, to] = ends.map(|node| node.map_or(0, |&node| draft.model.nodes.label(node)));
    let message =
        format!("{master} turns {side} to the side where {slave} is: from {from} to {to}");
    let note = Diagnostic::note(Code("SL0330"), message).at(pairing.master.span);
    let help = "a face label on the data line of *SURFACE, SPOS or SNEG, overrides this";
    draft.log.push(note.help(help));
    Some(())
}

/// A label that turns the master's back to all of its slaves.
fn behind(mean: Option<(f64, f64)>, pairing: &Pairing, draft: &mut Draft) {
    let Some((distance, length)) = mean else { return };
    if distance < -length {
        let message = format!(
            "{} lies behind {}, on average {:.3e} deep",
            pairing.slave.name, pairing.master.name, -distance
        );
        let warning = Diagnostic::warning(Code("SL0337"), message).at(pairing.origin);
        let help = "is the face label of the master the right one? SPOS and SNEG are opposite";
        draft.consequence(Subject::Contact, warning.help(help));
    }
}
