//! Sharp edges of surfaces that are in contact: their nodes meet the other side by themselves.
//!
//! ```text
//!        \   /  slave                slave  o-----------------o
//!         \ /                                     .-X-.             X: a node of a sharp edge
//!     -----X-----  master             master     /     \
//! ```
//!
//! Contact over faces takes means over a face, and contact at nodes sees nothing between two of them:
//! an edge goes into a face unseen by both.
//!
//! docs/theory.md section 5.17

use crate::contact::{ContactElement, ContactPair, Formulation, Offset};
use crate::edge_lines::crossing_edges;
use crate::edge_pair::EdgePair;
use crate::left_out::LeftOut;
use crate::model::Model;
use crate::node::NodeIndex;
use crate::surface::{ContactFace, Master, MasterFaces, SlideLine};
use slideline_mech::surface::lone::{is_lone, nodes_of_edges};
use slideline_mech::surface::mesh::{MeshFace, SHARP, smooth_groups};
use slideline_mech::vector::{cross, dot, size, sub};
use std::collections::{HashMap, HashSet};

impl Model {
    /// Finds the sharp edges of its pairs of solids anew.
    pub fn find_edges(&mut self) {
        let pairs = self.contact_pairs.iter().enumerate();
        self.edge_pairs = pairs.flat_map(|(of, pair)| edges_of(self, (of, pair))).collect();
        let pairs = self.contact_pairs.iter().enumerate();
        self.crossing_edges = pairs.filter_map(|own| crossing_edges(self, own)).collect();
    }
}

/// The sharp edges of both sides of a pair.
fn edges_of(model: &Model, (of, pair): (usize, &ContactPair)) -> Vec<EdgePair> {
    let is_of_faces = pair.of_solids || !pair.faces.is_empty();
    if !is_of_faces || pair.meets_itself() || pair.offset != Offset::NONE {
        return Vec::new();
    }
    let of_master: HashSet<_> = pair.master.deforming_nodes().into_iter().collect();
    let of_slave: HashSet<_> = nodes_of_slave(pair).collect();
    let at = |node: NodeIndex| model.nodes.position(node);
    let mut found = Vec::new();
    if pair.formulation == Formulation::Mortar {
        let sharp = match pair.faces.is_empty() {
            true => edges_of_line(&pair.elements, at),
            false => pair.corners.clone(),
        };
        let nodes = alone(sharp, &of_master);
        let (met, left_out) = (as_met_by_nodes(&pair.master), pair.left_out.clone());
        found.push(EdgePair { of, nodes, is_of_master: false, met, left_out });
    }
    let sharp = alone(sharp_of_master(pair, at), &of_slave);
    for met in surfaces_of_slave(pair, &sharp, at) {
        let nodes = sharp.clone();
        let left_out = pair.left_out.iter().map(LeftOut::turned).collect();
        found.push(EdgePair { of, nodes, is_of_master: true, met, left_out });
    }
    found.retain(|own| !own.nodes.is_empty());
    found
}

/// Each node once, those of the other side left out: they meet no face that they belong to.
fn alone(nodes: Vec<NodeIndex>, other: &HashSet<NodeIndex>) -> Vec<NodeIndex> {
    let mut seen = HashSet::new();
    nodes.into_iter().filter(|node| !other.contains(node) && seen.insert(*node)).collect()
}

fn nodes_of_slave(pair: &ContactPair) -> impl Iterator<Item = NodeIndex> + '_ {
    let of_faces = pair.faces.iter().flat_map(|face| face.nodes.iter().copied());
    pair.elements.iter().flat_map(|element| element.nodes).chain(of_faces)
}

/// Nodes at which the master of a pair turns away sharply.
fn sharp_of_master(pair: &ContactPair, at: impl Fn(NodeIndex) -> [f64; 3]) -> Vec<NodeIndex> {
    match &pair.master {
        Master::SlideLine(line) => sharp_nodes(&line.nodes, -1.0, at),
        Master::Faces(MasterFaces { faces, swept: None, .. }) => {
            let mut nodes = nodes_at_creases(faces, &at);
            if pair.formulation == Formulation::NodeToSurface {
                nodes.extend(nodes_of_edges(&mesh_of(faces), &at));
            }
            nodes
        }
        Master::Faces(_) | Master::RigidSurface(_) | Master::Itself(_) => Vec::new(),
    }
}

/// Corners of a slave line of solids in the plane, in the order of its elements: its edges, and the bottoms of sharp valleys.
pub fn corners_of_line(
    elements: &[ContactElement],
    at: impl Fn(NodeIndex) -> [f64; 3],
) -> Vec<NodeIndex> {
    let runs = runs(elements);
    let hollow = runs.iter().flat_map(|run| turns(run, -1.0, &at));
    let valleys = hollow.filter(|own| own.1 > SHARP.acos()).map(|own| own.0);
    let found: HashSet<_> = edges_of_line(elements, &at).into_iter().chain(valleys).collect();
    elements.iter().map(|own| own.nodes[0]).filter(|node| found.contains(node)).collect()
}

/// Nodes at which a slave line of solids in the plane turns away sharply, or by less but alone.
fn edges_of_line(
    elements: &[ContactElement],
    at: impl Fn(NodeIndex) -> [f64; 3],
) -> Vec<NodeIndex> {
    runs(elements).iter().flat_map(|run| sharp_nodes(run, 1.0, &at)).collect()
}

/// Nodes at which a line of the plane turns sharply to the side of the material, to its left (1) or to its right (-1), or
/// by less but alone, as at the foot of a chamfer.
fn sharp_nodes(
    nodes: &[NodeIndex],
    side: f64,
    at: impl Fn(NodeIndex) -> [f64; 3],
) -> Vec<NodeIndex> {
    let all = turns(nodes, side, at);
    let is_loop = nodes.len() > 2 && nodes.first() == nodes.last();
    let beside = |place: usize| {
        let [before, behind] = match is_loop {
            true => [(place + all.len() - 1) % all.len(), (place + 1) % all.len()],
            false => [place.wrapping_sub(1), place + 1],
        };
        [before, behind].map(|to| all.get(to).map(|own| own.1)).into_iter()
    };
    let is_edge = |(place, turn): (usize, f64)| turn > SHARP.acos() || is_lone(turn, beside(place));
    all.iter().enumerate().filter(|(k, own)| is_edge((*k, own.1))).map(|(_, own)| own.0).collect()
}

/// By how much a line of the plane turns at its inner nodes, one after another, to the side of the material [rad]; that
/// of the seam of a closed one comes last.
fn turns(
    nodes: &[NodeIndex],
    side: f64,
    at: impl Fn(NodeIndex) -> [f64; 3],
) -> Vec<(NodeIndex, f64)> {
    let turn = |[before, here, behind]: [NodeIndex; 3]| {
        let (one, other) = (sub(at(here), at(before)), sub(at(behind), at(here)));
        (here, (side * cross(one, other)[2]).atan2(dot(one, other)))
    };
    let inner = nodes.windows(3).map(|own| turn([own[0], own[1], own[2]]));
    let seam = match nodes {
        [first, second, .., before, last] if first == last => {
            Some(turn([*before, *first, *second]))
        }
        _ => None,
    };
    inner.chain(seam).collect()
}

/// Corners of faces in space about which the surface has a crease, each as often as faces that meet there are
/// apart from the first ones.
pub fn nodes_at_creases(
    faces: &[ContactFace],
    at: impl Fn(NodeIndex) -> [f64; 3],
) -> Vec<NodeIndex> {
    let mesh = mesh_of(faces);
    let groups = smooth_groups(&mesh, at);
    let (mut first, mut seen, mut found) = (HashMap::new(), HashSet::new(), Vec::new());
    for (face, groups) in mesh.iter().zip(groups) {
        for (&node, group) in face.nodes.iter().zip(groups).take(face.cell.faces.len()) {
            let is_apart = *first.entry(node).or_insert(group) != group;
            if is_apart && seen.insert((node, group)) {
                found.push(node);
            }
        }
    }
    found
}

/// Faces as the mechanics knows them, those of a known cell.
fn mesh_of(faces: &[ContactFace]) -> Vec<MeshFace> {
    faces.iter().filter_map(ContactFace::of_mesh).collect()
}

/// A master that contact over faces slides on as what nodes meet.
fn as_met_by_nodes(master: &Master) -> Master {
    match master {
        Master::SlideLine(line) => {
            Master::SlideLine(SlideLine { middles: Vec::new(), smooth: None, ..line.clone() })
        }
        Master::Faces(faces) => {
            Master::Faces(MasterFaces { smooth: faces.swept.is_none(), ..faces.clone() })
        }
        other => other.clone(),
    }
}

/// The slave surface of a pair as what nodes meet, its pieces one by one.
fn surfaces_of_slave(
    pair: &ContactPair,
    met_by: &[NodeIndex],
    at: impl Fn(NodeIndex) -> [f64; 3],
) -> Vec<Master> {
    let origin = pair.origin;
    if pair.faces.is_empty() {
        let line = |mut nodes: Vec<NodeIndex>| {
            // a master has its material on the right of its way, a slave on the left
            nodes.reverse();
            turn_seam_away(&mut nodes, met_by, &at);
            let (middles, smooth, extension) = (Vec::new(), None, 0.0);
            Master::SlideLine(SlideLine { nodes, middles, smooth, extension, origin })
        };
        return runs(&pair.elements).into_iter().map(line).collect();
    }
    let faces = pair.faces.clone();
    let (swept, smooth, extension, meets_itself) = (None, true, 0.0, false);
    vec![Master::Faces(MasterFaces { faces, smooth, extension, swept, meets_itself, origin })]
}

/// Lets a closed line begin and end at its node that is farthest from what meets it.
fn turn_seam_away(
    nodes: &mut Vec<NodeIndex>,
    met_by: &[NodeIndex],
    at: impl Fn(NodeIndex) -> [f64; 3],
) {
    if nodes.len() < 3 || nodes.first() != nodes.last() {
        return;
    }
    nodes.pop();
    let nearest = |node: NodeIndex| {
        let distances = met_by.iter().map(|&other| size(sub(at(node), at(other))));
        distances.fold(f64::INFINITY, f64::min)
    };
    let places = nodes.iter().enumerate().map(|(place, &node)| (nearest(node), place));
    let farthest = places.reduce(|known, other| if other.0 > known.0 { other } else { known });
    nodes.rotate_left(farthest.map_or(0, |own| own.1));
    nodes.push(nodes[0]);
}

/// The nodes of contact elements piece by piece, each in their order of travel; a closed one begins and ends
/// at the same node.
fn runs(elements: &[ContactElement]) -> Vec<Vec<NodeIndex>> {
    let next: HashMap<_, _> = elements.iter().map(|own| (own.nodes[0], own.nodes[1])).collect();
    let ends: HashSet<_> = elements.iter().map(|own| own.nodes[1]).collect();
    let (mut seen, mut found) = (HashSet::new(), Vec::new());
    let starts = elements.iter().map(|own| own.nodes[0]);
    let open = starts.clone().filter(|start| !ends.contains(start));
    for start in open.chain(starts) {
        if seen.contains(&start) {
            continue;
        }
        let (mut run, mut here) = (vec![start], start);
        while let Some(&end) = next.get(&here).filter(|_| seen.insert(here)) {
            run.push(end);
            here = end;
        }
        found.push(run);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: a line that turns by 45 degrees is sharp wherever it stands and however it is turned; one that turns
    /// by 44, of which no more is known, is not.
    #[test]
    fn chamfers_of_45_degrees_are_sharp() {
        for (degrees, is_sharp) in [(45.0, true), (44.0, false)] {
            for (away, turn) in [(0.0, 0.0), (64.0, 0.3), (1e4, 1.1), (-333.3, 2.0), (0.1, 5.0)] {
                let at = |node: NodeIndex| {
                    let (long, turned): (f64, f64) = if node == 2 {
                        (0.7, turn + f64::to_radians(degrees))
                    } else {
                        (1.3, turn)
                    };
                    let way = if node == 0 { 0.0 } else { long };
                    let corner =
                        if node == 2 { [1.3 * turn.cos(), 1.3 * turn.sin()] } else { [0.0; 2] };
                    let [x, y] = corner;
                    [away + x + way * turned.cos(), y - away + way * turned.sin(), 0.0]
                };
                let found = sharp_nodes(&[0, 1, 2], 1.0, at);
                assert_eq!(found == [1], is_sharp, "{degrees} {away} {turn}");
            }
        }
    }

    /// Requirement: rounds of few chords have no edges but those of 45 degrees and more, nor have their ends, where chords turn
    /// by half; the feet of a chamfer have, of one chord or of three.
    #[test]
    fn rounds_have_no_edges() {
        let edges = |turns: &[f64]| {
            let (mut way, mut places) = (0.0_f64, vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]);
            for turn in turns {
                way += turn.to_radians();
                let [x, y, _] = places[places.len() - 1];
                places.push([x + way.cos(), y + way.sin(), 0.0]);
            }
            let nodes: Vec<NodeIndex> = (0..places.len()).collect();
            sharp_nodes(&nodes, 1.0, |node| places[node]).len()
        };
        for chords in [3.0, 4.0, 5.0, 8.0] {
            let turn = 90.0 / chords;
            let whole = vec![turn; 8];
            let tangent = [&[turn / 2.0], &whole[1..], &[turn / 2.0]].concat();
            assert_eq!((edges(&whole), edges(&tangent)), (0, 0), "{turn}");
            // half of it, on to a plane of symmetry
            assert_eq!((edges(&[turn]), edges(&[turn, turn / 2.0])), (0, 0), "{turn}");
        }
        assert_eq!(edges(&[0.0, 40.0, 50.0, 0.0]), 2);
        assert_eq!(edges(&[0.0, 30.0, 0.0, 0.0, 60.0]), 2);
        assert_eq!(edges(&[0.0, 25.0, 0.0]), 1);
        assert_eq!(edges(&[-30.0, -60.0]), 0);
    }
}
