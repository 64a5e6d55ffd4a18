//! The elements behind a surface at each of its nodes.
//!
//! ```text
//!   o-----o-----o     a and c have faces on the surface ===, b touches it at the node n alone: all
//!    \ a / \ c /      three hand their forces over there. From a face's element the others are
//!     \ / b \ /       found through faces at n that are not of the surface
//!   ===o===n===o===
//! ```
//! Where that way leads round the rim of a surface to its other side, nothing tells the sides
//! apart: there elements with faces count alone. Where the surface is a patch of the skin, elements
//! beyond its rim are those of the next patch.

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

use slideline_mech::surface::mesh::is_crease;
use slideline_mech::vector::{Vector, cross, scale, size, sub};
use slideline_model::{ElementBlock, ElementIndex, NodeIndex};

/// Nodes of a face, in ascending order.
type Key = Vec<NodeIndex>;

/// Elements by the nodes at which they stand behind the faces, which are elements with nodes.
pub(super) fn behind(
    faces: &[(ElementIndex, &[NodeIndex])],
    (blocks, position): (&[ElementBlock], &impl Fn(NodeIndex) -> Vector),
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
        let skin = Skin::at(node, star, blocks);
        let is_next = |element: &ElementIndex| {
            !first.contains(element) && skin.goes_on(*element, &cut, position)
        };
        let counted: BTreeSet<ElementIndex> = match wraps {
            true => first.clone(),
            false => reached.into_iter().filter(|element| !is_next(element)).collect(),
        };
        for element in counted {
            found.entry(element).or_default().push(node);
        }
    }
    found
}

/// The faces at a node that one element alone has.
struct Skin(Vec<(ElementIndex, Key)>);

impl Skin {
    fn at(node: NodeIndex, star: &[ElementIndex], blocks: &[ElementBlock]) -> Self {
        let mut sides: BTreeMap<Key, Vec<ElementIndex>> = BTreeMap::new();
        for &element in star {
            keys(element, node, blocks).for_each(|key| sides.entry(key).or_default().push(element));
        }
        let alone = sides.into_iter().filter(|(_, elements)| elements.len() == 1);
        Self(alone.map(|(key, elements)| (elements[0], key)).collect())
    }

    /// Whether an element carries on the side of the body of which the surface has faces at the node.
    fn goes_on(
        &self,
        element: ElementIndex,
        cut: &HashSet<&Key>,
        position: &impl Fn(NodeIndex) -> Vector,
    ) -> bool {
        let surface: Vec<Vector> = self
            .0
            .iter()
            .filter(|(_, key)| cut.contains(key))
            .map(|(_, key)| bearing(key, position))
            .collect();
        let own = self.0.iter().filter(|(of, key)| *of == element && !cut.contains(key));
        // either way round: the nodes of a face are in no order here
        let joins = |a: Vector, b: Vector| !is_crease(a, b) || !is_crease(a, scale(b, -1.0));
        own.map(|(_, key)| bearing(key, position))
            .any(|own| surface.iter().any(|other| joins(own, *other)))
    }
}

/// Unit vector across a face, along an edge [1].
fn bearing(key: &Key, position: &impl Fn(NodeIndex) -> Vector) -> Vector {
    let from = position(key[0]);
    let ways: Vec<Vector> = key[1..].iter().map(|&node| sub(position(node), from)).collect();
    let across = ways.iter().skip(1).map(|way| cross(ways[0], *way));
    let longest = across.max_by(|a, b| size(*a).total_cmp(&size(*b)));
    let bearing = longest.unwrap_or(ways[0]);
    let length = size(bearing);
    bearing.map(|part| if length > 0.0 { part / length } else { 0.0 })
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
