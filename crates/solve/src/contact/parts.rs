//! How thick parts are behind their faces in the plane, before anything moves.
//!
//! ```text
//!     o-----o-----o
//!     |     |     |      from the middle of a face inwards to where the way leaves the part
//!     |     v     |
//!     o-----o-----o
//! ```
//!
//! docs/theory.md section 5.8

use super::master::MasterSurface;
use super::mortar::slave::{Control, Mortar};
use super::pairs::Contact;
use super::thicknesses::{Behind, Thicknesses};
use slideline_mech::contact::search::tree::{Bounds, BoxTree};
use slideline_mech::vector::{Vector, add, cross, scale, size, sub};
use slideline_model::{Kinematics, Master, Model, NodeIndex, Numbered};
use std::cell::Cell;
use std::collections::HashSet;

/// Part of a face beside it that still belongs to it: meshes have faces middle upon node [1].
const BESIDE: f64 = 1e-9;

/// A face at which a part ends; the part is on the left of the way from its first end to its second.
struct Face {
    ends: [Vector; 2],
    part: NodeIndex,
}

/// The solids of a model by the faces at which they end.
struct Parts {
    faces: Vec<Face>,
    /// Which of them has these nodes, the lower one first: both ends, or one and the middle node.
    places: Numbered<(NodeIndex, NodeIndex), usize>,
    tree: BoxTree<3>,
}

impl Contact {
    /// Measures the parts of all pairs in the plane.
    pub(super) fn take_thicknesses(&mut self, model: &Model) {
        self.thicknesses = Thicknesses::default();
        let is_line = |own: &MasterSurface| matches!(own, MasterSurface::Line { itself: None, .. });
        let in_plane = self.masters.iter().any(is_line) || !self.mortars.is_empty();
        if model.is_in_space() || !in_plane || sides(model).next().is_none() {
            return;
        }
        let parts = Parts::new(model);
        let mut of_points = vec![f64::INFINITY; self.points.len()];
        for mortar in &self.mortars {
            let nodes = &self.slave_nodes[mortar.pair][..];
            let own = mortar.of_point.len();
            let into = &mut of_points[mortar.first..mortar.first + own];
            into.iter_mut().zip(0..).for_each(|(own, point)| {
                *own = parts.behind_point(mortar, nodes, point);
            });
        }
        let of_masters =
            model.contact_pairs.iter().map(|pair| parts.of_master(&pair.master)).collect();
        let of_slaves = self.behind_slaves(&parts);
        self.thicknesses = Thicknesses { of_points, of_slaves, of_masters };
    }

    /// Behind every face of a slave that meets its master at nodes.
    fn behind_slaves(&self, parts: &Parts) -> Vec<Behind> {
        let mut all = vec![Behind::UNKNOWN; self.slave_faces.len()];
        let own = self.points.iter().filter(|point| point.pair < self.own_pairs());
        let faces = own.flat_map(|point| point.faces.iter().map(|&face| (point.pair, face)));
        let mut faces: Vec<(usize, usize)> = faces.collect();
        faces.sort_unstable();
        faces.dedup();
        for own in faces.chunk_by(|one, other| one.0 == other.0) {
            let ends = |&(_, face): &(usize, usize)| match &self.slave_faces[face].corners[..] {
                [(a, ..), (b, ..)] => Some([*a, *b]),
                _ => None,
            };
            let behind = parts.of_surface(own.iter().map(ends));
            own.iter().zip(behind).for_each(|(&(_, face), behind)| all[face] = behind);
        }
        all
    }
}

impl Parts {
    fn new(model: &Model) -> Self {
        let part = joined(model);
        let mut known: Numbered<(NodeIndex, NodeIndex), usize> = Numbered::default();
        for (nodes, side) in sides(model) {
            *known.entry(ends(nodes, side)).or_default() += 1;
        }
        let (mut faces, mut places) = (Vec::new(), Numbered::default());
        for (nodes, side) in sides(model) {
            let (first, last) = (nodes[side[0]], nodes[side[side.len() - 1]]);
            if known[&sorted(first, last)] == 1 {
                side.windows(2).for_each(|own| {
                    places.insert(sorted(nodes[own[0]], nodes[own[1]]), faces.len());
                });
                places.insert(sorted(first, last), faces.len());
                let ends = [first, last].map(|node| model.nodes.position(node));
                faces.push(Face { ends, part: part[first] });
            }
        }
        let bounds = |face: usize| -> Bounds<3> {
            let [a, b] = faces[face].ends;
            ([0, 1, 2].map(|k| a[k].min(b[k])), [0, 1, 2].map(|k| a[k].max(b[k])))
        };
        let tree = BoxTree::new(faces.len(), bounds);
        Self { faces, places, tree }
    }

    /// Behind every segment of a master.
    fn of_master(&self, master: &Master) -> Vec<Behind> {
        match master {
            Master::SlideLine(line) => {
                self.of_surface(line.nodes.windows(2).map(|own| Some([own[0], own[1]])))
            }
            _ => Vec::new(),
        }
    }

    /// Behind every face of a surface, by its nodes.
    fn of_surface(&self, faces: impl Iterator<Item = Option<[NodeIndex; 2]>>) -> Vec<Behind> {
        let place = |nodes: Option<[NodeIndex; 2]>| {
            nodes.and_then(|[a, b]| self.places.get(&sorted(a, b)).copied())
        };
        let all: Vec<Option<usize>> = faces.map(place).collect();
        let named: HashSet<usize> = all.iter().flatten().copied().collect();
        let behind = |own: &Option<usize>| {
            let Some(own) = *own else { return Behind::UNKNOWN };
            let (thickness, far) = self.behind(own);
            Behind { thickness, has_far_side: far.is_some_and(|far| named.contains(&far)) }
        };
        all.iter().map(behind).collect()
    }

    /// How thick a part is behind one of its faces [L], and at which other one it ends there; infinite where it ends at
    /// none.
    fn behind(&self, own: usize) -> (f64, Option<usize>) {
        let Face { ends: [a, b], part } = self.faces[own];
        let along = sub(b, a);
        let inward = scale([-along[1], along[0], 0.0], 1.0 / size(along));
        let middle = scale(add(a, b), 0.5);
        let (nearest, far) = (Cell::new(f64::INFINITY), Cell::new(None));
        self.tree.along((middle, inward), &nearest, |other| {
            let face = &self.faces[other];
            if other != own && face.part == part {
                let way = left_after(face.ends, (middle, inward)).unwrap_or(f64::INFINITY);
                if way < nearest.get() {
                    nearest.set(way);
                    far.set(Some(other));
                }
            }
        });
        (nearest.get(), far.get())
    }

    /// Behind the faces of a point of a mortar, the larger one [L].
    fn behind_point(&self, mortar: &Mortar, nodes: &[NodeIndex], point: usize) -> f64 {
        let of_point = mortar.of_point[point].iter().flatten();
        let behind = |&(face, _): &(usize, usize)| {
            let own = &mortar.faces[face];
            let ends = [own.controls[0], own.controls[own.count - 1]];
            match ends {
                [Control::Node(a), Control::Node(b)] => {
                    let own = self.places.get(&sorted(nodes[a], nodes[b]));
                    own.map_or(f64::INFINITY, |&own| self.behind(own).0)
                }
                _ => f64::INFINITY,
            }
        };
        of_point.map(behind).reduce(f64::max).unwrap_or(f64::INFINITY)
    }
}

/// After which way along a line from a place [L] it leaves a part through a face of that; `None`: it does not.
fn left_after([a, b]: [Vector; 2], (from, along): (Vector, Vector)) -> Option<f64> {
    let turn = |a: Vector, b: Vector| cross(a, b)[2];
    let (edge, to) = (sub(b, a), sub(a, from));
    let area = turn(along, edge);
    if area <= 0.0 {
        return None;
    }
    let (way, at) = (turn(to, edge) / area, turn(to, along) / area);
    (way > 0.0 && (-BESIDE..=1.0 + BESIDE).contains(&at)).then_some(way)
}

/// The sides of all solids, with their part on the left: nodes of the element, and places of those of
/// the side among them.
fn sides(model: &Model) -> impl Iterator<Item = (&[NodeIndex], &'static [usize])> {
    let is_solid = |kind| matches!(kind, Kinematics::Solid { .. });
    let blocks = model.blocks.iter().filter(move |block| is_solid(block.kind.kinematics));
    blocks.flat_map(|block| {
        let faces = block.kind.cell.faces;
        block.elements.iter().flat_map(move |own| faces.iter().map(move |&face| (own.nodes, face)))
    })
}

/// The nodes at both ends of a side, the lower one first.
fn ends(nodes: &[NodeIndex], side: &[usize]) -> (NodeIndex, NodeIndex) {
    sorted(nodes[side[0]], nodes[side[side.len() - 1]])
}

/// Of every node one that stands for all that solids join it to.
pub(super) fn joined(model: &Model) -> Vec<NodeIndex> {
    fn top(above: &mut [NodeIndex], mut node: NodeIndex) -> NodeIndex {
        while above[node] != node {
            above[node] = above[above[node]];
            node = above[node];
        }
        node
    }
    let mut above: Vec<NodeIndex> = (0..model.nodes.len()).collect();
    for (nodes, side) in sides(model) {
        for own in side.windows(2) {
            let [a, b] = [own[0], own[1]].map(|own| top(&mut above, nodes[own]));
            above[a.max(b)] = a.min(b);
        }
    }
    (0..above.len()).map(|node| top(&mut above, node)).collect()
}

fn sorted(a: NodeIndex, b: NodeIndex) -> (NodeIndex, NodeIndex) {
    (a.min(b), a.max(b))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: a way leaves through a face that looks along it, at whichever angle, its ends included; not
    /// through one by which it enters, nor behind its beginning, nor beside the face.
    #[test]
    fn ways_leave_through_faces_that_look_along_them() {
        let up = |x: f64| ([x, 0.0, 0.0], [0.0, 1.0, 0.0]);
        let face = [[3.0, 2.0, 0.0], [0.0, 5.0, 0.0]];
        let after = |x: f64| left_after(face, up(x));
        for x in [0.0, 1.0, 2.5, 3.0] {
            let way = after(x).unwrap();
            assert!((way - (5.0 - x)).abs() < 1e-12, "{x} {way}");
        }
        assert_eq!((after(-0.1), after(3.1)), (None, None));
        assert_eq!(left_after([face[1], face[0]], up(1.0)), None);
        assert_eq!(left_after(face, ([1.0, 6.0, 0.0], [0.0, 1.0, 0.0])), None);
    }
}
