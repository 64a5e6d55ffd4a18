//! Which faces of the master the faces of a point may touch before long.

use super::super::master::MasterSurface;
use super::super::pairs::Contact;
use super::place::FaceRoom;
use super::slave::FaceMortar;

impl Contact {
    /// Adds the faces that the faces of a point face, and those about them, where these are near:
    /// within `reach` [L].
    pub fn near_face_mortar(
        &self,
        mortar: &FaceMortar,
        point: usize,
        (room, reach): (&FaceRoom, f64),
        into: &mut Vec<usize>,
    ) {
        let MasterSurface::Faces { mesh, .. } = &self.masters[mortar.pair] else { return };
        let sums = room.sums(mortar, point);
        if sums.gap > reach * sums.area {
            return;
        }
        for &(face, _) in &mortar.of_point[point] {
            for master in &room.faces[face].masters {
                let about = mesh.around(master.face).iter().copied();
                for face in about.chain([master.face]) {
                    if !into.contains(&face) {
                        into.push(face);
                    }
                }
            }
        }
    }

    /// Nodes of the slave surface that a point of a mortar follows: `note(place)`.
    pub fn slaves_of_face_mortar(
        &self,
        mortar: &FaceMortar,
        point: usize,
        mut note: impl FnMut(usize),
    ) {
        for &(face, _) in &mortar.of_point[point] {
            mortar.faces[face].nodes().iter().for_each(|&node| note(node));
        }
    }
}
