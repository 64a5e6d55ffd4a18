//! The faces of a slave surface in space.

use crate::dofs::{DofMap, Translations};
use slideline_mech::axes::Axes;
use slideline_mech::contact::pair::mortar_faces::{
    FaceEnds, FacePlaces, MOST_CORNERS, MOST_NODES, corners, reference_areas,
};
use slideline_mech::contact::search::thickness::thicknesses;
use slideline_mech::surface::axes::{Bearing, bearing_of_axis};
use slideline_mech::surface::mesh::{MeshFace, nodes_at_ends, smooth_groups, surface_ends};
use slideline_mech::vector::{Vector, add, cross, scale, size, sub};
use slideline_model::{ContactPair, Master, Model, NodeIndex};
use std::collections::HashMap;

/// A slave face.
#[derive(Clone, Debug)]
pub struct SlaveFace {
    /// Its nodes, by their places among those of the surface.
    pub nodes: [usize; MOST_NODES],
    /// How many they are.
    pub count: usize,
    /// The points of its corners among those of the pair.
    pub points: [usize; MOST_CORNERS],
    /// Undeformed area by the coordinates of its cell, at its nodes [L2].
    pub measure: [f64; MOST_NODES],
    /// Where the surface ends or has a crease.
    pub ends: FaceEnds,
}

/// The slave surface of a pair.
#[derive(Clone, Debug)]
pub struct FaceMortar {
    /// Place of its pair in the model.
    pub pair: usize,
    /// Its first point; slave corner by slave corner, then those that sharp edges add.
    pub first: usize,
    /// Its faces.
    pub faces: Vec<SlaveFace>,
    /// The faces of every point with the corners of these that the point is.
    pub of_point: Vec<Vec<(usize, usize)>>,
    /// Undeformed positions of its nodes [L].
    pub positions: Vec<[f64; 3]>,
    /// Its nodes, and their dofs.
    pub nodes: Vec<NodeIndex>,
    /// Dofs of the nodes.
    pub dofs: Vec<Translations>,
    /// Where friction has coefficients along the axes of the surface: how axis 1 stands to the first
    /// edge that leaves a point; empty else [1].
    pub axes: Vec<Bearing>,
    /// How thick the parts are behind the faces of both sides.
    pub thicknesses: Thicknesses,
}

/// How thick the parts of a pair are behind each of their undeformed faces [L].
#[derive(Clone, Debug, Default)]
pub struct Thicknesses {
    /// Behind those of the slave.
    pub slave: Vec<f64>,
    /// Behind those of the master; none of analytical surfaces.
    pub master: Vec<f64>,
}

impl Thicknesses {
    fn of(model: &Model, pair: &ContactPair) -> Self {
        let behind = |faces: &[MeshFace]| thicknesses(faces, |node| model.nodes.get(node).position);
        let master = match &pair.master {
            Master::Faces(master) if master.swept.is_none() => behind(&master.mesh_faces()),
            _ => Vec::new(),
        };
        Self { slave: behind(&pair.mesh_faces()), master }
    }
}

impl SlaveFace {
    /// Its nodes.
    pub fn nodes(&self) -> &[usize] {
        &self.nodes[..self.count]
    }

    /// Places of its nodes among those of the surface.
    pub fn places(&self, all: &[[f64; 3]]) -> FacePlaces<f64> {
        let nodes = self.nodes.map(|node| all.get(node).copied().unwrap_or_default());
        FacePlaces { nodes, count: self.count }
    }

    /// The nodes on the edges that leave a corner: in the order of travel, and against it.
    pub fn beside(&self, corner: usize) -> [usize; 2] {
        let corners = corners(self.count);
        let last = (corner + corners - 1) % corners;
        match self.count == corners {
            true => [(corner + 1) % corners, last],
            false => [corners + corner, corners + last],
        }
    }
}

impl FaceMortar {
    /// The slave surface of a pair with these slave corners, without its numbers.
    pub fn new(
        (place, pair): (usize, &ContactPair),
        first: usize,
        (slaves, model, dofs): (&[NodeIndex], &Model, &DofMap),
    ) -> Self {
        let point_of: HashMap<_, _> =
            slaves.iter().enumerate().map(|(k, &node)| (node, k)).collect();
        let mut nodes: Vec<NodeIndex> = Vec::new();
        let mut place_of: HashMap<NodeIndex, usize> = HashMap::new();
        let mut faces = Vec::new();
        for face in pair.faces.iter().filter(|face| face.cell().is_some()) {
            let mut own = SlaveFace {
                nodes: [0; MOST_NODES],
                count: face.nodes.len(),
                points: [0; MOST_CORNERS],
                measure: [0.0; MOST_NODES],
                ends: FaceEnds::default(),
            };
            for (into, &node) in own.nodes.iter_mut().zip(&face.nodes) {
                *into = *place_of.entry(node).or_insert_with(|| {
                    nodes.push(node);
                    nodes.len() - 1
                });
            }
            let corners = &face.nodes[..corners(own.count)];
            own.points.iter_mut().zip(corners).for_each(|(into, node)| *into = point_of[node]);
            faces.push(own);
        }
        let mut own = Self {
            pair: place,
            first,
            faces,
            of_point: vec![Vec::new(); slaves.len() + pair.corners.len()],
            positions: Vec::new(),
            dofs: nodes.iter().map(|&node| dofs.translations(node)).collect(),
            nodes,
            axes: Vec::new(),
            thicknesses: Thicknesses::default(),
        };
        own.part(model, pair, slaves.len());
        own
    }

    /// Notes the axes of the undeformed surface at its points, by the axes of space there.
    pub fn take_axes(&mut self, axes: impl Fn(Vector) -> Axes) {
        let edges = |&(face, corner): &(usize, usize)| {
            let own: &SlaveFace = &self.faces[face];
            let at = |corner: usize| self.positions[own.nodes[corner]];
            own.beside(corner).map(|other| sub(at(other), at(corner)))
        };
        let of_point = |corners: &Vec<(usize, usize)>| {
            let sum = |sum, [next, last]: [Vector; 2]| add(sum, cross(next, last));
            let across = corners.iter().map(edges).fold([0.0; 3], sum);
            let [first, _] = corners.first().map(edges).unwrap_or_default();
            let at = corners.first().map(|&(face, corner)| self.faces[face].nodes[corner]);
            let axes = axes(at.map_or([0.0; 3], |node| self.positions[node]));
            bearing_of_axis(axes, first, scale(across, -1.0 / size(across)))
        };
        self.axes = self.of_point.iter().map(of_point).collect();
    }

    /// Gives the faces beyond a sharp edge points of their own, and every point its faces.
    fn part(&mut self, model: &Model, pair: &ContactPair, slaves: usize) {
        let (mesh, at) = (pair.mesh_faces(), |node| model.nodes.get(node).position);
        let groups = smooth_groups(&mesh, at);
        let ends = surface_ends(&mesh, at);
        let nodes = nodes_at_ends(&mesh, &ends);
        for ((face, of_mesh), edges) in self.faces.iter_mut().zip(&mesh).zip(ends) {
            let is_end = |k: usize| {
                of_mesh.nodes.get(k).is_some_and(|node| nodes.binary_search(node).is_ok())
            };
            face.ends = FaceEnds { edges, nodes: std::array::from_fn(is_end) };
        }
        let mut owners: HashMap<(usize, usize), usize> = HashMap::new();
        let mut met = vec![false; slaves];
        let mut next = slaves;
        for (place, (face, groups)) in self.faces.iter_mut().zip(&groups).enumerate() {
            for (corner, &group) in groups[..corners(face.count)].iter().enumerate() {
                let point = face.points[corner];
                let owner = *owners.entry((point, group)).or_insert_with(|| {
                    let is_first = !std::mem::replace(&mut met[point], true);
                    if is_first || next >= self.of_point.len() {
                        return point;
                    }
                    next += 1;
                    next - 1
                });
                face.points[corner] = owner;
                self.of_point[owner].push((place, corner));
            }
        }
    }

    /// Takes the positions of its nodes; gives the areas of its points, covered as a whole:
    /// `add(point, area)` [L2].
    pub fn take(&mut self, model: &Model, mut add: impl FnMut(usize, f64)) {
        self.positions.clear();
        let at = |node: &NodeIndex| model.nodes.get(*node).position;
        self.positions.extend(self.nodes.iter().map(at));
        self.thicknesses = Thicknesses::of(model, &model.contact_pairs[self.pair]);
        for face in &mut self.faces {
            let places = face.places(&self.positions);
            face.measure = reference_areas(&places);
            let areas = places.corner_areas(&face.measure);
            let points = &face.points[..corners(face.count)];
            points.iter().zip(areas).for_each(|(&point, area)| add(point, area));
        }
    }
}
