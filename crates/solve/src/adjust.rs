//! Slave nodes that begin on their master, `ADJUST`, or at a gap from it, `*CLEARANCE`.
//!
//! ```text
//!      o  o  o          the nodes near the master move along its normal onto it,
//!     _____________     as the contact sees it: smoothed, with its arcs; nothing is strained
//! ```

use crate::commit::initial_contact;
use crate::contact::mean_length;
use crate::observe::ContactRow;
use slideline_diag::{Code, Diagnostic};
use slideline_model::{Adjust, ContactElement, ContactPair, Formulation, Master, Model, NodeIndex};
use std::collections::{HashMap, HashSet};

/// Most moves of a node: a curved master is met by Newton's method, mean gaps of faces one by one.
const MOST: usize = 100;
/// Longest way to a clearance, over the mean length of the faces [1].
const FAR: f64 = 0.5;
/// Gaps that are left, over the size of the model [1].
const CLOSE: f64 = 1e-13;

/// Moves the slave nodes of every pair that asks for it, and says which.
pub fn adjust(model: &mut Model) -> Vec<Diagnostic> {
    let asked = |pair: &ContactPair| pair.adjust != Adjust::Nothing;
    let pairs: Vec<usize> =
        (0..model.contact_pairs.len()).filter(|&p| asked(&model.contact_pairs[p])).collect();
    let said = pairs.iter().flat_map(|&pair| adjust_pair(pair, model)).collect();
    // two nodes that are one in contact stay at one place
    let moved: HashSet<NodeIndex> =
        pairs.iter().flat_map(|&pair| model.contact_pairs[pair].slave_nodes()).collect();
    for [follower, leader] in model.seams.clone() {
        if moved.contains(&leader) {
            model.nodes.place(follower, model.nodes.position(leader));
        }
    }
    said
}

fn adjust_pair(place: usize, model: &mut Model) -> Vec<Diagnostic> {
    let pair = &model.contact_pairs[place];
    let of_nodes = matches!(pair.adjust, Adjust::Within(_) | Adjust::Nodes(_));
    let is_sampled = match pair.formulation {
        Formulation::NodeToSurface => true,
        Formulation::Mortar => !of_nodes && !has_nodes_between(pair),
        Formulation::SurfaceToSurface => false,
    };
    if is_sampled {
        return move_slaves(place, model);
    }
    // nodes are moved, those in the middle of faces and beams too, whatever contact is later spread over
    let mut sampled = model.clone();
    let own = &mut sampled.contact_pairs[place];
    if own.formulation == Formulation::SurfaceToSurface {
        own.elements = between_nodes(own, model);
    }
    own.formulation = Formulation::NodeToSurface;
    match &mut own.master {
        Master::SlideLine(line) => line.smooth = Some(0.0),
        Master::Faces(faces) => faces.smooth = false,
        Master::RigidSurface(_) | Master::Itself(_) => {}
    }
    let said = move_slaves(place, &mut sampled);
    for node in sampled.contact_pairs[place].slave_nodes() {
        model.nodes.place(node, sampled.nodes.position(node));
    }
    said
}

/// Whether faces have nodes without a contact point of their own: middle nodes in space. A mean gap
/// of such a face hangs on all its nodes, and its corners alone cannot bring it about.
fn has_nodes_between(pair: &ContactPair) -> bool {
    let points: HashSet<NodeIndex> = pair.slave_nodes().into_iter().collect();
    pair.faces.iter().flat_map(|face| &face.nodes).any(|node| !points.contains(node))
}

/// The elements along which contact is integrated, those of three-node beams from node to node.
fn between_nodes(pair: &ContactPair, model: &Model) -> Vec<ContactElement> {
    let three = model.blocks.iter().flat_map(|block| block.elements.iter());
    let three = three.filter(|element| element.nodes.len() == 3);
    let sorted = |[a, b]: [NodeIndex; 2]| if a < b { [a, b] } else { [b, a] };
    let middle: HashMap<[NodeIndex; 2], NodeIndex> =
        three.map(|own| (sorted([own.nodes[0], own.nodes[2]]), own.nodes[1])).collect();
    let parts = pair.elements.iter().flat_map(|own| match middle.get(&sorted(own.nodes)) {
        Some(&middle) => {
            let [a, b] = own.nodes;
            vec![
                ContactElement { nodes: [a, middle], ..*own },
                ContactElement { nodes: [middle, b], ..*own },
            ]
        }
        None => vec![*own],
    });
    parts.collect()
}

fn move_slaves(place: usize, model: &mut Model) -> Vec<Diagnostic> {
    let positions = model.nodes.iter().flat_map(|node| node.position);
    let reach = positions.fold(0.0, |largest: f64, x| largest.max(x.abs()));
    let pair = &model.contact_pairs[place];
    let (goal, reach_of_faces) = (goal(&pair.adjust), FAR * mean_length(model, pair));
    let mut rows = asked_for(&pair.adjust, facing(place, model));
    let all = rows.len();
    if let Adjust::Clearance(_) = pair.adjust {
        rows.retain(|row| (row.opening - goal).abs() <= reach_of_faces);
    }
    let left = all - rows.len();
    let moved: HashMap<NodeIndex, [f64; 3]> =
        rows.iter().map(|row| (row.node, model.nodes.position(row.node))).collect();
    for _ in 0..MOST {
        let largest = rows.iter().map(|row| (row.opening - goal).abs()).fold(0.0, f64::max);
        if largest <= CLOSE * reach {
            break;
        }
        for row in &rows {
            let at = model.nodes.position(row.node);
            let way = row.opening - goal;
            let onto = std::array::from_fn(|k| at[k] - way * row.normal[k]);
            model.nodes.place(row.node, onto);
        }
        rows = facing(place, model);
        rows.retain(|row| moved.contains_key(&row.node));
    }
    let pair = &model.contact_pairs[place];
    said(pair, model, &moved).into_iter().chain(too_far(pair, (left, all))).collect()
}

/// The gap at which slave nodes begin [L].
fn goal(adjust: &Adjust) -> f64 {
    match adjust {
        Adjust::Clearance(gap) => *gap,
        _ => 0.0,
    }
}

/// Slave nodes that are left where they are, as the way to their clearance is long.
fn too_far(pair: &ContactPair, (left, all): (usize, usize)) -> Option<Diagnostic> {
    let message = format!(
        "{left} of {all} slave nodes of {} are further from their *CLEARANCE than half a face and \
         stay where they are",
        pair.name
    );
    let warning = Diagnostic::warning(Code("SL0418"), message).at(pair.origin);
    let help = "nodes are moved to their clearance: name the faces that lie along one another, and \
                draw them near it";
    (left > 0).then(|| warning.help(help))
}

/// The contact points of a pair that face its master.
fn facing(place: usize, model: &Model) -> Vec<ContactRow> {
    let mut rows = initial_contact(model);
    rows.retain(|row| row.pair == place && row.opening.is_finite());
    rows
}

/// Those of them that are to begin on it, or at a gap from it.
fn asked_for(adjust: &Adjust, mut rows: Vec<ContactRow>) -> Vec<ContactRow> {
    match adjust {
        Adjust::Nothing => rows.clear(),
        Adjust::Clearance(_) => {}
        Adjust::Within(distance) => rows.retain(|row| row.opening <= *distance),
        Adjust::Nodes(nodes) => {
            let asked: HashSet<NodeIndex> = nodes.iter().copied().collect();
            rows.retain(|row| asked.contains(&row.node));
        }
    }
    rows
}

/// How many nodes were moved, and the furthest one.
fn said(
    pair: &ContactPair,
    model: &Model,
    moved: &HashMap<NodeIndex, [f64; 3]>,
) -> Option<Diagnostic> {
    let way = |(&node, before): (&NodeIndex, &[f64; 3])| {
        let now = model.nodes.position(node);
        let way = (0..3).map(|k| (now[k] - before[k]).powi(2)).sum::<f64>().sqrt();
        (way, node)
    };
    let ways: Vec<(f64, NodeIndex)> = moved.iter().map(way).filter(|(way, _)| *way > 0.0).collect();
    // of nodes that went equally far the first one
    let further =
        |a: &&(f64, NodeIndex), b: &&(f64, NodeIndex)| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1));
    let (furthest, node) = *ways.iter().max_by(further)?;
    let (card, goal) = match pair.adjust {
        Adjust::Clearance(_) => ("*CLEARANCE", "to its gap from"),
        _ => ("ADJUST", "onto"),
    };
    let message = format!(
        "{card} moved {} slave node{} of {} {goal} the master, node {} by {furthest:.4e}",
        ways.len(),
        if ways.len() == 1 { "" } else { "s" },
        pair.name,
        model.nodes.name(node),
    );
    let help = "the nodes are moved before the first step, without strain; check that no element \
                is out of shape where the way is long";
    Some(Diagnostic::note(Code("SL0417"), message).at(pair.origin).help(help))
}
