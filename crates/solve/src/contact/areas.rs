//! Areas of slave nodes: their shares of the faces that look at what they meet.
//!
//! ```text
//!       |     |                      |/    |      tipped over, the side counts more and more
//!       x-----o    its side          x-----o
//!    -------------  counts nothing    \_________  as it comes to look at the master
//! ```
//!
//! docs/theory.md eq. (5.59).

use super::before::Before;
use super::kinematics::PointKinematics;
use super::pairs::{Contact, SlavePoint};
use slideline_mech::contact::points::faces::tributary_areas as face_areas;
use slideline_mech::contact::points::{Across, looking, tributary_areas};
use slideline_mech::vector::{dot, scale, size};
use slideline_model::{ContactPair, Formulation, Model, NodeIndex};
use std::collections::HashMap;
use std::iter::once;

impl SlavePoint {
    /// Adds its share of a face; without a number, one that counts wherever it looks.
    fn add_share(&mut self, face: Option<usize>, area: f64) {
        self.area += area;
        self.shares.extend(face.map(|face| (face, area)));
    }
}

impl Contact {
    /// Areas of the nodes of contact elements, which are edges of solids or beams.
    pub(super) fn take_element_areas(&mut self, model: &Model, place: usize, pair: &ContactPair) {
        let position = |node: NodeIndex| model.nodes.get(node).position;
        let Self { points, edges, first_faces, .. } = self;
        if pair.formulation == Formulation::Mortar {
            return;
        }
        let across = across(model, pair);
        for (own, (element, &edge)) in pair.elements.iter().zip(&edges[place]).enumerate() {
            let face = pair.of_solids.then_some(first_faces[place] + own);
            let element = (edge, element.lumping.shares(), element.nodes.map(position));
            tributary_areas(once(element), across, |point, area| {
                points[point].add_share(face, area);
            });
        }
    }

    /// Areas of the slave nodes of a pair in space.
    pub(super) fn take_face_areas(&mut self, model: &Model, place: usize, pair: &ContactPair) {
        let Some(first) = self.points.iter().position(|point| point.pair == place) else { return };
        let nodes = &self.slave_nodes[place];
        let of_node: HashMap<_, _> =
            nodes.iter().enumerate().map(|(k, &n)| (n, first + k)).collect();
        let cells = pair.faces.iter().filter_map(|face| Some((face, face.cell()?)));
        for (own, (face, cell)) in cells.enumerate() {
            let number = (!pair.counts_sides).then_some(self.first_faces[place] + own);
            let at: Vec<_> = face.nodes.iter().map(|&n| model.nodes.get(n).position).collect();
            let points = &mut self.points;
            face_areas(cell, &at, |node, area| {
                if let Some(&point) = of_node.get(&face.nodes[node]) {
                    points[point].add_share(number, area);
                }
            });
        }
    }

    /// The area of a slave node against what it met at the last commit, with its faces as they stood then: over an increment it
    /// is one number, and the tangent has no part of it. One that met nothing then is held against what it meets now.
    pub(crate) fn area_of_node(
        &self,
        place: usize,
        (u, before): (&[f64], Before<'_>),
        now: &PointKinematics,
    ) -> f64 {
        let mut lost = 0.0;
        self.each_share(place, (u, before), now, |area, part| lost += area * (1.0 - part));
        self.points[place].area - lost
    }

    /// Whether a face about it counts in part, so that its area follows its master and its faces.
    pub(crate) fn counts_in_part(
        &self,
        place: usize,
        (u, before): (&[f64], Before<'_>),
        now: &PointKinematics,
    ) -> bool {
        let mut in_part = false;
        self.each_share(place, (u, before), now, |_, part| in_part |= part > 0.0 && part < 1.0);
        in_part
    }

    /// Calls with the shares of a slave node and the part of each that counts, unless all of them do.
    fn each_share(
        &self,
        place: usize,
        (u, before): (&[f64], Before<'_>),
        now: &PointKinematics,
        mut call: impl FnMut(f64, f64),
    ) {
        let point = &self.points[place];
        let committed = before.points.get(place).filter(|point| point.along.is_some());
        let met = committed.map(|point| point.normal);
        let Some(normal) = met.or(now.faces.then_some(now.normal)) else { return };
        let (way, u) = (scale(normal, -1.0), if before.u.is_empty() { u } else { before.u });
        let outward = |face: usize| {
            let own = self.slave_faces[face].stands(u).0;
            let long = size(own);
            if long > 0.0 { scale(own, 1.0 / long) } else { own }
        };
        let (mut most, mut largest, mut least) = ([0.0; 3], 0.0, 1.0);
        for &(face, _) in &point.shares {
            let own = outward(face);
            let cosine = dot(own, way);
            if cosine > largest {
                (most, largest) = (own, cosine);
            }
            least = cosine.min(least);
        }
        if least >= looking::WHOLE || largest == 0.0 {
            return;
        }
        for &(face, area) in &point.shares {
            call(area, looking::counted(outward(face), most, way));
        }
    }
}

/// How far the contact of a pair of the plane reaches across it.
pub(super) fn across(model: &Model, pair: &ContactPair) -> Across {
    match model.is_of_rings() {
        true => Across::Ring,
        false => Across::Width(pair.interaction.width),
    }
}
