//! Slave faces that look the same way as the outside of what they touch.
//!
//! ```text
//!     |  block  |
//!     +---------+  n of the faces: down          parts that touch look at one another;
//!     ===========  n of the plate: down too      here the plate is drawn the wrong way round
//! ```

use crate::start::{Start, less};
use slideline_model::{ContactPair, Formulation, Master, Model, NodeIndex};
use slideline_solve::observe::ContactRow;
use std::collections::{HashMap, HashSet};

/// Gap that counts as none, over the size of the model [1].
const TOUCH: f64 = 1e-6;
/// Cosine of the angle of normals up to which faces stand across a master, and look neither way [1]. (choice)
const ACROSS: f64 = 0.1;

/// How many points touch or overlap a master that was drawn, whose outside looks the same way as their own faces, and
/// how many face it; `None` where the first are not the most of all that touch it.
pub fn look_alike(start: &Start<'_>, place: usize, pair: &ContactPair) -> Option<[usize; 2]> {
    let is_of_faces = pair.of_solids || !pair.faces.is_empty();
    if !is_of_faces || !is_drawn(start.model, pair) {
        return None;
    }
    let normals = outward(start.model, pair);
    let of_nodes = at_nodes(start, place, pair);
    let facing: Vec<&ContactRow> = match &of_nodes {
        Some(rows) => rows.iter().filter(|row| row.opening.is_finite()).collect(),
        None => start.facing(place).collect(),
    };
    let touching = || facing.iter().copied().filter(|row| row.opening < TOUCH * start.reach);
    let looks_alike = |row: &&ContactRow| {
        let along = |own: &[f64; 3]| (0..3).map(|k| own[k] * row.normal[k]).sum::<f64>();
        let size = |own: &[f64; 3]| own.iter().map(|part| part * part).sum::<f64>().sqrt();
        normals.get(&row.node).is_some_and(|own| along(own) > ACROSS * size(own))
    };
    let alike = touching().filter(looks_alike).count();
    (alike > 0 && 2 * alike > touching().count()).then_some([alike, facing.len()])
}

/// What the nodes of a pair over faces see of its master, where no face does: faces that look the same way as their
/// master do not meet it, and their gaps tell nothing.
fn at_nodes(start: &Start<'_>, place: usize, pair: &ContactPair) -> Option<Vec<ContactRow>> {
    if pair.formulation != Formulation::Mortar || start.facing(place).next().is_some() {
        return None;
    }
    let mut twin = start.model.clone();
    twin.contact_pairs.get_mut(place)?.formulation = Formulation::NodeToSurface;
    let mut rows = slideline_solve::initial_contact(&twin);
    rows.retain(|row| row.pair == place);
    Some(rows)
}

/// Whether the outside of a master is as its points, or the side of its rigid elements or beams, say, and not that of
/// a body.
pub fn is_drawn(model: &Model, pair: &ContactPair) -> bool {
    let (nodes, is_swept) = match &pair.master {
        Master::RigidSurface(_) => return true,
        Master::Itself(_) => return false,
        Master::Faces(faces) if faces.meets_itself => return false,
        Master::Faces(faces) => (faces.nodes(), faces.swept.is_some()),
        Master::SlideLine(line) => (line.nodes.clone(), false),
    };
    let nodes: HashSet<NodeIndex> = nodes.into_iter().collect();
    let bodies = model.blocks.iter().filter(|block| block.beams().is_none());
    let mut of_bodies = bodies.flat_map(|block| &block.elements).flat_map(|own| own.nodes);
    is_swept || !of_bodies.any(|node| nodes.contains(node))
}

/// The sums of the outward normals of the faces at every slave node.
fn outward(model: &Model, pair: &ContactPair) -> HashMap<NodeIndex, [f64; 3]> {
    let mut normals: HashMap<NodeIndex, [f64; 3]> = HashMap::new();
    let mut add = |node: NodeIndex, own: [f64; 3]| {
        let normal = normals.entry(node).or_default();
        *normal = std::array::from_fn(|k| normal[k] + own[k]);
    };
    let way =
        |from: NodeIndex, to: NodeIndex| less(model.nodes.position(to), model.nodes.position(from));
    for [from, to] in pair.elements.iter().map(|element| element.nodes) {
        // the material is on the left of the way
        let along = way(from, to);
        [from, to].into_iter().for_each(|node| add(node, [along[1], -along[0], 0.0]));
    }
    for face in &pair.faces {
        let corners = face.cell().map_or(0, |cell| cell.faces.len());
        let [a, b] = match face.nodes[..corners] {
            [a, b, c] => [way(a, b), way(a, c)],
            [a, b, c, d] => [way(a, c), way(b, d)],
            _ => continue,
        };
        let own = std::array::from_fn(|k| {
            a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]
        });
        face.nodes.iter().for_each(|&node| add(node, own));
    }
    normals
}
