//! The elements behind a surface at each of its nodes.
//!
//! ```text
//!   o-----o-----o     a and c have faces on the surface ===, b touches it at the node n alone: all
//!    \ a / \ c /      three hand their forces over there. From a face's element the others are
//!     \ / b \ /       found through faces at n that are not of the surface
//!   ===o===n===o===
//! ```
//! Where that way leads round the rim of a surface to its other side, nothing tells the sides
//! apart: there elements with faces count alone.

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

use slideline_model::{ElementBlock, ElementIndex, NodeIndex};

/// Nodes of a face, in ascending order.
type Key = Vec<NodeIndex>;

/// Elements by the nodes at which they stand behind the faces, which are elements with nodes.
pub(super) fn behind(
    faces: &[(ElementIndex, &[NodeIndex])],
    blocks: &[ElementBlock],
) -> BTreeMap<ElementIndex, Vec<NodeIndex>> {
    let named: HashSet<(ElementIndex, Key)> =
        faces.iter().map(|(element, nodes)| (*element, key(nodes.iter().copied()))).collect();
    let cut: HashSet<&Key> = named.iter().map(|(_, key)| key).collect();
    let mut own: BTreeMap<NodeIndex, BTreeSet<ElementIndex>> = BTreeMap::new();
    for (element, nodes) in faces {
        nodes.iter().for_each(|&node| _ = own.entry(node).or_default().insert(*element));
    }
    let stars = stars(&own, blocks);
    let mut found: BTreeMap<ElementIndex, Vec<NodeIndex>> = BTreeMap::new();
    for (node, first) in own {
        let star = stars.get(&node).map_or(&[][..], Vec::as_slice);
        let reached = reached(node, &first, star, (&cut, blocks));
        let is_beyond = |element: &ElementIndex| {
            let mut keys = keys(*element, node, blocks);
            keys.any(|key| cut.contains(&key) && !named.contains(&(*element, key)))
        };
        let wraps = reached.iter().any(is_beyond);
        for element in if wraps { first } else { reached } {
            found.entry(element).or_default().push(node);
        }
    }
    found
}

fn key(nodes: impl Iterator<Item = NodeIndex>) -> Key {
    let mut key: Key = nodes.collect();
    key.sort_unstable();
    key
}

/// The solids at each node of the surface.
fn stars(
    own: &BTreeMap<NodeIndex, BTreeSet<ElementIndex>>,
    blocks: &[ElementBlock],
) -> HashMap<NodeIndex, Vec<ElementIndex>> {
    let mut stars: HashMap<NodeIndex, Vec<ElementIndex>> = HashMap::new();
    for (place, block) in blocks.iter().enumerate().filter(|(_, own)| own.kind.joins()) {
        if block.kind.cell.dimension < 2 {
            continue;
        }
        for (member, element) in block.elements.iter().enumerate() {
            for node in element.nodes.iter().filter(|node| own.contains_key(node)) {
                stars.entry(*node).or_default().push((place, member));
            }
        }
    }
    stars
}

/// Faces of an element that have a node.
fn keys(
    (block, member): ElementIndex,
    node: NodeIndex,
    blocks: &[ElementBlock],
) -> impl Iterator<Item = Key> + '_ {
    let nodes = blocks[block].elements.get(member).nodes;
    let faces = blocks[block].kind.cell.faces.iter();
    let all = faces.map(move |face| key(face.iter().map(|&corner| nodes[corner])));
    all.filter(move |key| key.binary_search(&node).is_ok())
}

/// The elements that are reached from the first ones through faces that are not cut.
fn reached(
    node: NodeIndex,
    first: &BTreeSet<ElementIndex>,
    star: &[ElementIndex],
    (cut, blocks): (&HashSet<&Key>, &[ElementBlock]),
) -> BTreeSet<ElementIndex> {
    let mut sides: HashMap<Key, Vec<ElementIndex>> = HashMap::new();
    for &element in star {
        for key in keys(element, node, blocks).filter(|key| !cut.contains(key)) {
            sides.entry(key).or_default().push(element);
        }
    }
    let mut reached = first.clone();
    let mut open: Vec<ElementIndex> = first.iter().copied().collect();
    while let Some(element) = open.pop() {
        for key in keys(element, node, blocks) {
            for &other in sides.get(&key).map_or(&[][..], Vec::as_slice) {
                if reached.insert(other) {
                    open.push(other);
                }
            }
        }
    }
    reached
}
