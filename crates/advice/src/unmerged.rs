//! Solids whose faces lie on one another, node on node, and that nothing joins.
//!
//! ```text
//!    +-----+                 +-----+
//!    |  B  |                 |  B  |
//!   5+-----+6     or       5 +--+--+6      4 and 5 stand at one place, and nothing joins them:
//!   1+-----+2              1 +--+--+       a mesh that was not merged
//!    |  A  |                 |  A  |
//!    +-----+                 +-----+
//! ```
//!
//! What takes part in contact, ties, equations, rigid bodies or springs was meant to be two nodes, and
//! so was what a step takes away; what is held in all directions on both sides does not part.

use crate::finding::Finding;
use crate::start::{Start, length, less};
use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{Dof, ElementBlock, Kinematics, Master, Model, NodeIndex, Prescribed};
use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

/// Nodes nearer than this part of the shortest edge of their faces stand at one place [1].
const NEAR: f64 = 1e-3;
/// Pairs of nodes that a finding names.
const NAMED: usize = 3;
/// Corners of a face at most.
const CORNERS: usize = 4;

/// A face on the outside of a body.
struct Skin {
    /// Its corners, the first `count` of them.
    corners: [NodeIndex; CORNERS],
    count: usize,
    /// The mean of its corners [L].
    centre: [f64; 3],
    /// Its shortest edge [L].
    edge: f64,
    /// The block of its element.
    block: usize,
}

/// Pairs of nodes at one place, by the blocks that they are of, and whether the body is one
/// elsewhere.
type Loose = BTreeMap<(usize, usize, bool), BTreeSet<[NodeIndex; 2]>>;

/// SL0410: faces of solids on one another that are not joined.
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    let skins = skins(start.model);
    let largest = skins.iter().map(|skin| skin.edge).fold(0.0, f64::max);
    let width = NEAR * largest;
    if width <= 0.0 || !width.is_finite() {
        return;
    }
    let meant = (meant_apart(start), held(start.model).collect());
    let mut grid: HashMap<[i64; 3], Vec<usize>> = HashMap::new();
    let mut loose = Loose::new();
    for (place, skin) in skins.iter().enumerate() {
        let cell = skin.centre.map(|x| (x / width).floor() as i64);
        for other in around(cell).filter_map(|near| grid.get(&near)).flatten() {
            compare(start, &meant, [&skins[*other], skin], &mut loose);
        }
        grid.entry(cell).or_default().push(place);
    }
    findings.extend(loose.iter().map(|(key, pairs)| say(start, *key, pairs)));
}

/// The cell of a grid and those about it.
fn around([x, y, z]: [i64; 3]) -> impl Iterator<Item = [i64; 3]> {
    (0..27).map(move |k: i64| [x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1])
}

/// Takes note of two faces whose corners stand at the same places, were not `meant` to be two, and are
/// not `held` on both sides.
fn compare(
    start: &Start<'_>,
    (meant, held): &(HashSet<NodeIndex>, HashSet<NodeIndex>),
    [a, b]: [&Skin; 2],
    loose: &mut Loose,
) {
    let Some(pairs) = same_places(start.model, a, b) else { return };
    let apart: Vec<[NodeIndex; 2]> = pairs.into_iter().filter(|[a, b]| a != b).collect();
    let is_meant = |pair: &[NodeIndex; 2]| pair.iter().any(|node| meant.contains(node));
    let are_held = |pair: &[NodeIndex; 2]| pair.iter().all(|node| held.contains(node));
    if apart.is_empty() || apart.iter().any(is_meant) || apart.iter().all(are_held) {
        return;
    }
    let one_body = start.bodies.of_node(a.corners[0]) == start.bodies.of_node(b.corners[0]);
    let blocks = (a.block.min(b.block), a.block.max(b.block), one_body);
    let ordered = apart.into_iter().map(|[a, b]| [a.min(b), a.max(b)]);
    loose.entry(blocks).or_default().extend(ordered);
}

/// The corners of two faces that stand at the same places, pair by pair; `None`: not all do.
fn same_places(model: &Model, a: &Skin, b: &Skin) -> Option<Vec<[NodeIndex; 2]>> {
    let near = NEAR * a.edge.min(b.edge);
    let at = |node| model.nodes.position(node);
    let beside = |node: NodeIndex| {
        let mut corners = b.corners[..b.count].iter();
        corners.find(|&&other| length(less(at(node), at(other))) <= near)
    };
    if a.count != b.count {
        return None;
    }
    a.corners[..a.count].iter().map(|&node| Some([node, *beside(node)?])).collect()
}

/// The faces that one solid alone has, of what no step takes away.
fn skins(model: &Model) -> Vec<Skin> {
    let gone = model.taken_away();
    let mut owners: HashMap<[NodeIndex; CORNERS], Option<Skin>> = HashMap::new();
    for (place, block) in model.blocks.iter().enumerate() {
        if !matches!(block.kind.kinematics, Kinematics::Solid { .. }) {
            continue;
        }
        for (member, element) in block.elements.iter().enumerate() {
            if gone.contains(&(place, member)) {
                continue;
            }
            for face in block.kind.cell.faces {
                let Some(skin) = skin(model, (place, block), face, element.nodes) else { continue };
                let mut key = skin.corners;
                key.sort_unstable();
                // a face between two elements is on no outside
                let shared = owners.contains_key(&key);
                owners.insert(key, (!shared).then_some(skin));
            }
        }
    }
    let mut skins: Vec<Skin> = owners.into_values().flatten().collect();
    skins.sort_unstable_by_key(|skin| (skin.block, skin.corners));
    skins
}

/// A face of an element by its corners; `None` where two of them are one, and it has no area.
fn skin(
    model: &Model,
    (place, block): (usize, &ElementBlock),
    face: &[usize],
    nodes: &[NodeIndex],
) -> Option<Skin> {
    let count = corners_of(block, face.len());
    let own = |k: usize| -> Option<NodeIndex> {
        let last = if count == 2 && k == 1 { face.len() - 1 } else { k };
        nodes.get(*face.get(last)?).copied()
    };
    let mut corners = [NodeIndex::MAX; CORNERS];
    for (k, corner) in corners.iter_mut().enumerate().take(count) {
        *corner = own(k)?;
    }
    let at: Vec<[f64; 3]> =
        corners[..count].iter().map(|&node| model.nodes.position(node)).collect();
    let edges = (0..count).map(|k| length(less(at[k], at[(k + 1) % count])));
    let edge = edges.fold(f64::INFINITY, f64::min);
    let centre = std::array::from_fn(|axis| at.iter().map(|x| x[axis]).sum::<f64>() / count as f64);
    let sound = edge > 0.0 && edge.is_finite();
    sound.then_some(Skin { corners, count, centre, edge, block: place })
}

/// Number of corners of a face with so many nodes.
fn corners_of(block: &ElementBlock, nodes: usize) -> usize {
    match (block.kind.cell.dimension, nodes) {
        (3, 3 | 6) => 3,
        (3, _) => 4,
        _ => 2,
    }
}

/// Nodes that were meant to have another one at their place.
fn meant_apart(start: &Start<'_>) -> HashSet<NodeIndex> {
    let model = start.model;
    let mut meant: HashSet<NodeIndex> = HashSet::new();
    for constraint in &model.linear_constraints {
        meant.insert(constraint.dependent.0);
        meant.extend(constraint.terms.iter().map(|term| term.0));
    }
    meant.extend(model.rigid_links.iter().map(|link| link.dependent));
    let springs = model.blocks.iter().filter_map(|block| block.springs());
    meant.extend(springs.flat_map(|own| own.elements).flat_map(|element| element.nodes).copied());
    for pair in &model.contact_pairs {
        meant.extend(pair.slave_places());
        match &pair.master {
            Master::Faces(faces) => meant.extend(faces.nodes()),
            Master::SlideLine(line) => meant.extend(&line.nodes),
            Master::Itself(surface) => meant.extend(surface.nodes()),
            Master::RigidSurface(_) => {}
        }
    }
    meant
}

/// Nodes that the first step holds in all directions.
fn held(model: &Model) -> impl Iterator<Item = NodeIndex> {
    let wanted = if model.is_in_space() { 3 } else { 2 };
    let mut directions: HashMap<NodeIndex, BTreeSet<Dof>> = HashMap::new();
    let prescribed = model.steps.iter().take(1).flat_map(|step| &step.prescribed);
    let along = |own: &&Prescribed| !own.dof.is_rotation();
    for own in prescribed.filter(along) {
        directions.entry(own.node).or_default().insert(own.dof);
    }
    let all = directions.into_iter().filter(move |(_, dofs)| dofs.len() >= wanted);
    all.map(|(node, _)| node)
}

fn say(
    start: &Start<'_>,
    (first, second, one_body): (usize, usize, bool),
    pairs: &BTreeSet<[NodeIndex; 2]>,
) -> Finding {
    let nodes = &start.model.nodes;
    let named: Vec<String> = pairs
        .iter()
        .take(NAMED)
        .map(|&[a, b]| format!("{} and {}", nodes.name(a), nodes.name(b)))
        .collect();
    let name = |block: usize| start.model.blocks[block].name.as_str();
    let whose = match first == second {
        true => format!("two faces of {}", name(first)),
        false => format!("faces of {} and {}", name(first), name(second)),
    };
    let more = if pairs.len() > NAMED { ", and so on" } else { "" };
    let message = format!(
        "{whose} lie on one another, and nothing joins them: {} nodes stand at the place of another \
         one, {}{more}; the body {}",
        pairs.len(),
        named.join(", "),
        if one_body { "has a slit there" } else { "falls apart there" },
    );
    let origin: Option<Span> = pairs.first().map(|pair| nodes.get(pair[1]).origin);
    let said = match one_body {
        true => Diagnostic::advice(Code("SL0410"), message),
        false => Diagnostic::warning(Code("SL0410"), message),
    };
    Finding::said(said.at(origin).help(
        "merge the mesh: one node for both in *ELEMENT; or join the faces with *TIE or *EQUATION. \
         Faces that may part and close want a *CONTACT PAIR",
    ))
}
