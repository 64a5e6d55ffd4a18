//! Ridges and rounds of analytical surfaces that stand in faces of the slave, between its nodes.
//!
//! ```text
//!         slave          contact is at the nodes of the slave, and an analytical surface has no nodes
//!      o----------o      that could be held: what lies between two slave nodes goes in unheld
//!       '-. /\ .-'
//!          '  '   master
//! ```

use super::edges::{EdgeInside, Found};
use super::falls::{FallsRoom, places};
use super::master::MasterSurface;
use super::pairs::Contact;
use super::positions::MasterPositions;
use crate::state::PointState;
use slideline_mech::contact::pair::FaceRoom;
use slideline_mech::vector::{size, sub};

/// Part of the size of a face by which its master may stand in it between its nodes unsaid [1].
const DEEP: f64 = 0.1;
/// The same by which a place is moved to see whether the master is met from before [1].
const ASIDE: f64 = 0.01;

/// How deep the master of a slave node stands in a face beyond what the nodes of the face show.
#[derive(Clone, Copy)]
struct Inside {
    place: usize,
    face: usize,
    depth: f64,
    /// The same in sizes of the face [1].
    share: f64,
}

impl Contact {
    /// The deepest analytical surface in a face between slave nodes none of which is closed.
    pub fn surface_inside(
        &self,
        (u, points): (&[f64], &[PointState]),
        positions: &MasterPositions,
        room: &mut FallsRoom,
    ) -> Option<EdgeInside> {
        if !(0..self.own_pairs()).any(|pair| self.is_analytical(pair)) {
            return None;
        }
        let FallsRoom { held, faces: rest, .. } = room;
        held.clear();
        held.resize(self.points.iter().map(|point| point.node + 1).max().unwrap_or(0), false);
        for (point, _) in self.points.iter().zip(points).filter(|(_, state)| state.closed) {
            held[point.node] = true;
        }
        let is_held = |node: usize| held.get(node).is_some_and(|&held| held);
        let mut found: Option<Inside> = None;
        for (place, point) in self.points.iter().enumerate() {
            let is_own = point.is_node() && point.pair < self.own_pairs();
            if !is_own || is_held(point.node) || !self.is_analytical(point.pair) {
                continue;
            }
            for &face in &point.faces {
                // each face once, by its first node
                let mut nodes = self.slave_faces[face].corners.iter().map(|(node, ..)| *node);
                if nodes.next() != Some(point.node) || nodes.any(is_held) {
                    continue;
                }
                let inside = self.in_face((place, face), u, positions, rest);
                let deeper = |own: &Inside| found.is_none_or(|other| own.share >= other.share);
                found = inside.filter(deeper).or(found);
            }
        }
        let Inside { place, face, depth, .. } = found?;
        let face = self.slave_faces[face].corners.iter().map(|(node, ..)| *node).collect();
        Some(EdgeInside { pair: self.points[place].pair, what: Found::Surface, face, depth })
    }

    fn is_analytical(&self, pair: usize) -> bool {
        match &self.masters[pair] {
            MasterSurface::Body { .. } => true,
            MasterSurface::Faces { mesh, .. } => mesh.swept().is_some(),
            _ => false,
        }
    }

    /// How deep the master of a slave node stands in a face that begins at the node; `None` where that is little.
    fn in_face(
        &self,
        (place, face): (usize, usize),
        u: &[f64],
        positions: &MasterPositions,
        room: &mut FaceRoom,
    ) -> Option<Inside> {
        let (point, own) = (&self.points[place], &self.slave_faces[face]);
        let mut depth = |at| self.depth_at(point, at, (u, positions), room);
        let (corners, (normal, long)) = (own.places(u), own.stands(u));
        let first = depth(corners[0]);
        // no gap changes by more than the way: a master that is far from one corner is far from all
        let wide = corners.iter().map(|&at| size(sub(at, corners[0]))).fold(long, f64::max);
        if long <= 0.0 || first.is_some_and(|own| own.abs() > long + wide) {
            return None;
        }
        let (mut shown, mut is_near) = (0.0, false);
        for own in corners.iter().filter_map(|&at| depth(at)) {
            (shown, is_near) = (own.max(shown), is_near || own.abs() <= long);
        }
        if !is_near {
            return None;
        }
        let (step, mut deepest) = (ASIDE * long / size(normal), 0.0);
        for at in places(&corners) {
            let Some(own) = depth(at) else { continue };
            let inside = own - shown;
            if inside < DEEP * long || inside <= deepest {
                continue;
            }
            let ahead = depth(std::array::from_fn(|axis| at[axis] + step * normal[axis]));
            if ahead.is_some_and(|ahead| ahead > own) {
                deepest = inside;
            }
        }
        let inside = Inside { place, face, depth: deepest, share: deepest / long };
        (DEEP * long..=long).contains(&deepest).then_some(inside)
    }
}
