//! Which parts of a deforming master the faces of a point may touch before long.

use super::super::master::MasterSurface;
use super::super::pairs::Contact;
use super::place::MortarRoom;
use super::slave::{Control, Mortar};
use std::ops::Range;

impl Contact {
    /// Nodes of the master chain that the faces of a point of a mortar face, where it is near:
    /// its gap within `reach` [L], however deep it has sunk in.
    pub fn near_mortar(
        &self,
        mortar: &Mortar,
        point: usize,
        (room, reach): (&MortarRoom, f64),
    ) -> Option<Range<usize>> {
        let MasterSurface::Line { .. } = &self.masters[mortar.pair] else { return None };
        let sums = room.sums(mortar, point);
        if sums.area <= 0.0 || sums.opening() > reach {
            return None;
        }
        // all that its rows hold, also where a face has handed its functions on
        let of_point = mortar.of_point[point].iter().flatten();
        let curves = of_point.flat_map(|&(face, _)| &room.faces[face].near);
        let mut range: Option<Range<usize>> = None;
        for &curve in curves {
            let controls = room.curves[curve].controls;
            let own = controls[..room.curves[curve].count].iter();
            for node in own.flat_map(|control| control.nodes()).map(|(node, _)| node) {
                let known = range.get_or_insert(node..node + 1);
                *known = known.start.min(node)..known.end.max(node + 1);
            }
        }
        range
    }

    /// Nodes of the slave surface that a point of a mortar follows: `note(place)`.
    pub fn slaves_of_mortar(&self, mortar: &Mortar, point: usize, mut note: impl FnMut(usize)) {
        for &(face, _) in mortar.of_point[point].iter().flatten() {
            let controls = mortar.controls(face);
            let nodes = controls.into_iter().flatten().flat_map(Control::nodes);
            nodes.for_each(|(node, _)| note(node));
        }
    }
}
