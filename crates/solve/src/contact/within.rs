//! Slave nodes of faces that stand in a master without contact.
//!
//! ```text
//!      |  slave |           the corner's point on the side faces nothing, that of its
//!      |        |           foot presses: between its nodes a face may sink in a little
//!   ===o========o=====
//!        master
//! ```

use super::master::MasterSurface;
use super::pairs::Contact;
use super::positions::MasterPositions;
use crate::state::PointState;
use slideline_mech::contact::pair::FaceRoom;

impl Contact {
    /// How deep the node of a point that belongs to faces, and that faces nothing, stands in its
    /// master without contact [L]; zero where another face of the node faces the master, and where
    /// the node stands beside it.
    pub(super) fn depth_without_contact(
        &self,
        place: usize,
        (u, points): (&[f64], &[PointState]),
        positions: &MasterPositions,
    ) -> f64 {
        let point = &self.points[place];
        let held = self.points.iter().zip(points).any(|(other, state)| {
            other.pair == point.pair && other.node == point.node && state.along.is_some()
        });
        if held {
            return 0.0;
        }
        let at = self.place(point, 0.0, u);
        let master = &self.masters[point.pair];
        let depth = match master {
            MasterSurface::Nothing => None,
            MasterSurface::Body { surface, .. } => surface.depth(master.placed_body(u).to_body(at)),
            MasterSurface::Faces { .. } => {
                self.depth_in_faces(point, at, positions, &mut FaceRoom::default())
            }
            MasterSurface::Line { .. } => {
                let stands = self.stands(place, u, positions);
                stands.faces.then_some(stands.overclosure)
            }
        };
        depth.map_or(0.0, |depth| depth.max(0.0))
    }
}
