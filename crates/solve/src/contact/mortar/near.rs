//! Which parts of a deforming master the faces of a point may touch before long.

use super::super::master::MasterSurface;
use super::super::pairs::Contact;
use super::place::MortarRoom;
use super::slave::{Control, Mortar};
use std::ops::Range;

impl Contact {
    /// Nodes of the master chain that the faces of a point of a mortar face, where these are near:
    /// within `reach` [L].
    pub fn near_mortar(
        &self,
        mortar: &Mortar,
        point: usize,
        (room, reach): (&MortarRoom, f64),
    ) -> Option<Range<usize>> {
        let MasterSurface::Line { .. } = &self.masters[mortar.pair] else { return None };
        let mut range: Option<Range<usize>> = None;
        for &(face, node) in mortar.of_point[point].iter().flatten() {
            let state = &room.faces[face];
            let Some(shares) = state.shares[node] else { continue };
            let [x, y] = state.integrals.gap_of(shares);
            if x.hypot(y) > reach * state.integrals.area_of(shares) {
                continue;
            }
            for &curve in &state.near {
                let controls = room.curves[curve].controls;
                let own = controls[..room.curves[curve].count].iter();
                for node in own.flat_map(|control| control.nodes()).map(|(node, _)| node) {
                    let known = range.get_or_insert(node..node + 1);
                    *known = known.start.min(node)..known.end.max(node + 1);
                }
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
