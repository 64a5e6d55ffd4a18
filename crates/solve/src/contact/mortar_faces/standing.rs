//! How slave corners stand: what their points sum over faces, normals and tangential directions.

use super::place::FaceRoom;
use super::slave::FaceMortar;
use slideline_mech::contact::pair::Footing;
use slideline_mech::contact::pair::mortar_faces::{Place, Standing};
use slideline_mech::vector::{Vector, add, cross, dot, scale, size, sub};

/// What a point sums over its faces.
#[derive(Clone, Copy, Debug, Default)]
pub struct PointSums {
    /// Area that is covered [L2].
    pub area: f64,
    /// Weighted gap, positive where open [L3].
    pub gap: f64,
    /// From the slave to the master, weighted [L3].
    pub way: Vector,
}

impl FaceRoom {
    /// What a point sums.
    pub fn sums(&self, mortar: &FaceMortar, point: usize) -> PointSums {
        let mut sums = PointSums::default();
        self.each_corner(mortar, point, |face, corner| {
            let state = &self.faces[face];
            for (overlap, (own, weights)) in state.overlaps.iter().zip(&state.parts) {
                let master = &state.masters[overlap.master].places;
                sums.area += own.areas[corner];
                sums.gap += own.gaps[corner];
                let way = weights.way(corner, &state.places.nodes, &master.nodes);
                sums.way = add(sums.way, way);
            }
        });
        sums
    }

    /// Calls with the corners of faces whose functions a point has.
    pub fn each_corner(
        &self,
        mortar: &FaceMortar,
        point: usize,
        mut call: impl FnMut(usize, usize),
    ) {
        for &(face, own) in &mortar.of_point[point] {
            for (corner, given) in self.faces[face].given.iter().enumerate() {
                if *given == Some(own) {
                    call(face, corner);
                }
            }
        }
    }

    /// Across the edges that meet at a point, outward, and the first of these edges [L2, L].
    fn across(&self, mortar: &FaceMortar, point: usize) -> (Vector, Vector) {
        let (mut across, mut first) = ([0.0; 3], None);
        for &(face, corner) in &mortar.of_point[point] {
            let [next, last] = self.edges((mortar, face), corner);
            across = add(across, cross(next, last));
            first.get_or_insert(next);
        }
        (across, first.unwrap_or_default())
    }

    /// The edges that leave a corner of a face [L].
    fn edges(&self, (mortar, face): (&FaceMortar, usize), corner: usize) -> [Vector; 2] {
        let nodes = &self.faces[face].places.nodes;
        mortar.faces[face].beside(corner).map(|other| sub(nodes[other], nodes[corner]))
    }

    /// How a point stands, with how it stood at the last commit; `None` where its faces have
    /// collapsed.
    pub fn standing(
        &self,
        mortar: &FaceMortar,
        point: usize,
        before: Option<&Footing>,
    ) -> Option<Standing> {
        let (across, edge) = self.across(mortar, point);
        let whole = size(across);
        if whole <= 0.0 {
            return None;
        }
        let axis = mortar.axes.get(point).copied();
        Standing::new(scale(across, -1.0 / whole), (edge, axis), before)
    }

    /// What a derivative by the normal of a point, from the master to the slave, is by the nodes of
    /// its faces: `add(face, node, value)`.
    pub fn pull_normal(
        &self,
        (mortar, point): (&FaceMortar, usize),
        by: Vector,
        mut add: impl FnMut(usize, usize, Place<f64>),
    ) {
        let (across, _) = self.across(mortar, point);
        let whole = size(across);
        let normal = scale(across, 1.0 / whole);
        let by = scale(sub(by, scale(normal, dot(normal, by))), -1.0 / whole);
        for &(face, corner) in &mortar.of_point[point] {
            let [next, last] = self.edges((mortar, face), corner);
            let [to_next, to_last] = [cross(last, by), cross(by, next)];
            let [next, last] = mortar.faces[face].beside(corner);
            add(face, next, to_next);
            add(face, last, to_last);
            add(face, corner, scale(slideline_mech::vector::add(to_next, to_last), -1.0));
        }
    }
}
