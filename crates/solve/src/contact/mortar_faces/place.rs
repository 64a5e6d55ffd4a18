//! The faces of a pair in a configuration, and their integrals.

use super::super::coverage::{LEAST_AREA, Release};
use super::super::master::MasterSurface;
use super::super::pairs::Contact;
use super::slave::{FaceMortar, SlaveFace, Thicknesses};
use slideline_mech::contact::pair::mortar_faces::{
    Couple, Cover, Ends, FaceEnds, FacePlaces, Faced, Looking, MOST_CORNERS, MOST_NODES, Overlap,
    Sums, Weights, corners,
};
use slideline_mech::contact::search::faces::{FaceTree, bounds, tree};
use slideline_mech::surface::mesh::FaceMesh;
use slideline_mech::vector::{Vector, add, scale, sub};

/// Part of a face that must be covered for any contact on it [1]: the gap of less, as where an end just comes in, is rounding.
const LEAST: f64 = 1e-6;

/// A slave face in a configuration.
#[derive(Clone, Debug)]
pub struct FaceState {
    /// Its nodes.
    pub places: FacePlaces<f64>,
    /// Faces of the master that cover it.
    pub masters: Vec<Faced>,
    /// What they cover.
    pub overlaps: Vec<Overlap>,
    /// Integrals over each of these, with the weights of the nodes.
    pub parts: Vec<(Sums, Weights)>,
    /// Integrals over all.
    pub sums: Sums,
    /// The corner whose point has the function of each corner here; `None`: nothing is covered.
    pub given: [Option<usize>; MOST_CORNERS],
}

/// The faces of the slave surface of a pair in a configuration.
#[derive(Clone, Debug, Default)]
pub struct FaceRoom {
    /// The faces.
    pub faces: Vec<FaceState>,
    /// Nodes of the slave and of the master [L].
    pub nodes: Vec<Vector>,
    /// Nodes of the master [L].
    pub masters: Vec<Vector>,
    tree: Option<FaceTree>,
    cover: Cover,
    near: Vec<Faced>,
    areas: Vec<f64>,
}

/// Part of a face by which what bulges is looked for beside it [1].
const BULGE: f64 = 0.1;

impl FaceState {
    fn new(places: FacePlaces<f64>) -> Self {
        Self {
            places,
            masters: Vec::new(),
            overlaps: Vec::new(),
            parts: Vec::new(),
            sums: Sums::default(),
            given: [None; MOST_CORNERS],
        }
    }

    /// The face with what an overlap faces.
    pub fn couple<'a>(&'a self, own: &'a SlaveFace, overlap: &Overlap) -> Couple<'a, f64> {
        let Faced { places: master, ends, .. } = &self.masters[overlap.master];
        let ends = Ends { slave: own.ends, master: *ends };
        Couple { slave: &self.places, measure: &own.measure, master, ends }
    }

    /// Integrates over the overlaps; what faces nothing is left out.
    fn integrate(&mut self, own: &SlaveFace) {
        self.sums = Sums::default();
        self.parts.clear();
        let mut kept = 0;
        for place in 0..self.overlaps.len() {
            let overlap = self.overlaps[place];
            let Some(part) = self.couple(own, &overlap).sums(&overlap) else { continue };
            self.sums.add(&part.0);
            self.parts.push(part);
            self.overlaps[kept] = overlap;
            kept += 1;
        }
        self.overlaps.truncate(kept);
        let whole: f64 = self.places.corner_areas(&own.measure).iter().sum();
        if self.sums.areas.iter().sum::<f64>() < LEAST * whole {
            self.overlaps.clear();
            self.parts.clear();
            self.sums = Sums::default();
        }
    }
}

impl Contact {
    /// Places the faces of the mortar of a pair at displacements `u`.
    pub fn place_face_mortar(&self, mortar: &FaceMortar, u: &[f64], room: &mut FaceRoom) {
        let MasterSurface::Faces { mesh, nodes, .. } = &self.masters[mortar.pair] else { return };
        room.nodes.clear();
        let slaves = mortar.positions.iter().zip(&mortar.dofs);
        room.nodes.extend(slaves.map(|(&at, dofs)| dofs.displace(at, u)));
        room.masters.clear();
        room.masters.extend(nodes.iter().map(|(at, dofs)| dofs.displace(*at, u)));
        match &mut room.tree {
            Some(tree) => tree.fit(|face| bounds(mesh, &room.masters, face)),
            None => room.tree = Some(tree(mesh, &room.masters)),
        }
        room.faces.truncate(mortar.faces.len());
        for (place, own) in mortar.faces.iter().enumerate() {
            room.place_face((place, own), (mesh, &mortar.thicknesses));
        }
        room.share_out(mortar);
    }
}

impl FaceRoom {
    /// Where nodes of the master stand [L].
    pub fn master_places(&self, nodes: &[usize]) -> [Vector; MOST_NODES] {
        let at = |k: usize| nodes.get(k).map_or([0.0; 3], |&node| self.masters[node]);
        std::array::from_fn(at)
    }

    fn place_face(
        &mut self,
        (place, own): (usize, &SlaveFace),
        (mesh, thick): (&FaceMesh, &Thicknesses),
    ) {
        let places = own.places(&self.nodes);
        if self.faces.len() <= place {
            self.faces.push(FaceState::new(places));
        }
        self.find_near(&places, (mesh, &thick.master));
        let state = &mut self.faces[place];
        state.places = places;
        state.overlaps.clear();
        let looking = Looking { places: &places, ends: &own.ends, thickness: thick.slave[place] };
        self.cover.find(looking, &self.near, &mut state.overlaps);
        // faces that cover nothing are forgotten
        state.masters.clear();
        let mut last = None;
        for face in 0..self.near.len() {
            for overlap in state.overlaps.iter_mut().filter(|own| own.master == face) {
                if last != Some(face) {
                    state.masters.push(self.near[face]);
                    last = Some(face);
                }
                overlap.master = state.masters.len() - 1;
            }
        }
        state.integrate(own);
    }

    /// Faces of the master that a slave face may face: those on its normals, no further than the
    /// nearest one and the face's own size.
    fn find_near(&mut self, own: &FacePlaces<f64>, (mesh, thick): (&FaceMesh, &[f64])) {
        self.near.clear();
        let Some(tree) = &self.tree else { return };
        let nodes = &own.nodes[..own.count];
        let middle =
            scale(nodes.iter().fold([0.0; 3], |sum, &at| add(sum, at)), 1.0 / own.count as f64);
        let square = |way: Vector| way[0] * way[0] + way[1] * way[1] + way[2] * way[2];
        let measure = |face: usize| {
            let nodes = mesh.faces()[face].nodes.iter();
            let distances = nodes.map(|&node| square(sub(self.masters[node], middle)));
            distances.fold(f64::INFINITY, f64::min)
        };
        let Some((_, nearest)) = tree.nearest(middle, measure) else { return };
        let size = 2.0 * nodes.iter().map(|&at| square(sub(at, middle))).fold(0.0, f64::max).sqrt();
        let reach = nearest.sqrt() + 2.0 * size;
        let mut window = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for normal in own.normals() {
            for way in [-reach, reach] {
                for &at in nodes {
                    let at = add(at, scale(normal, way));
                    for (axis, x) in at.into_iter().enumerate() {
                        window.0[axis] = window.0[axis].min(x - BULGE * size);
                        window.1[axis] = window.1[axis].max(x + BULGE * size);
                    }
                }
            }
        }
        let (near, masters) = (&mut self.near, &self.masters);
        tree.overlapping(window, |face| {
            let own = bounds(mesh, masters, face);
            let meets = (0..3).all(|k| own.0[k] <= window.1[k] && window.0[k] <= own.1[k]);
            if meets {
                let nodes = &mesh.faces()[face].nodes;
                let at = |k: usize| nodes.get(k).map_or([0.0; 3], |&node| masters[node]);
                let places = FacePlaces { nodes: std::array::from_fn(at), count: nodes.len() };
                let number = |k: usize| nodes.get(k).copied().unwrap_or_default();
                let at_end = |k: usize| nodes.get(k).is_some_and(|&node| mesh.is_at_end(node));
                let ends = FaceEnds { edges: mesh.ends(face), nodes: std::array::from_fn(at_end) };
                let thickness = thick.get(face).copied().unwrap_or(f64::INFINITY);
                let nodes = std::array::from_fn(number);
                near.push(Faced { face, nodes, places, ends, thickness });
            }
        });
        near.sort_unstable_by_key(|own| own.face);
    }

    /// What every point is let go by once less and less of it is covered.
    pub fn releases(&self, mortar: &FaceMortar, into: &mut Vec<Option<Release>>) {
        into.clear();
        into.resize(mortar.of_point.len(), None);
        for (own, state) in mortar.faces.iter().zip(&self.faces) {
            let whole = state.places.corner_areas(&own.measure);
            let points = &own.points[..corners(own.count)];
            let size = whole[..points.len()].iter().sum::<f64>().sqrt();
            let points = (points, &whole[..], !state.overlaps.is_empty());
            Release::of_face(points, &self.areas, size, into);
        }
    }

    /// Gives the functions of corners that have next to nothing of a face left to a corner beside them.
    fn share_out(&mut self, mortar: &FaceMortar) {
        self.areas.clear();
        self.areas.resize(mortar.of_point.len(), 0.0);
        for (own, state) in mortar.faces.iter().zip(&self.faces) {
            for corner in 0..corners(own.count) {
                self.areas[own.points[corner]] += state.sums.areas[corner];
            }
        }
        for (own, state) in mortar.faces.iter().zip(&mut self.faces) {
            state.given = [None; MOST_CORNERS];
            if state.overlaps.is_empty() {
                continue;
            }
            let count = corners(own.count);
            let area = |corner: usize| self.areas[own.points[corner]];
            let most = (0..count).max_by(|&a, &b| area(a).total_cmp(&area(b))).unwrap_or(0);
            let is_small = |corner: usize| area(corner) < LEAST_AREA * area(most);
            for corner in 0..count {
                // by how the face is made: a choice by areas would change to and fro between equals
                let others = [0, 1, count - 1, 2].map(|by| (corner + by) % count);
                state.given[corner] = others.into_iter().find(|&other| !is_small(other));
            }
        }
    }
}
