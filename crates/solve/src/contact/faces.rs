//! Slave nodes against faces in space.
//!
//! ```text
//!            x  slave node                 rows over its dofs, those of the nodes that
//!       o----|----o----o                   the face follows, and those of the face on
//!      /     |   /    /                    which the node stood at the last commit
//!     o-----(+)-o----o
//! ```

use super::before::Before;
use super::facing::Facing;
use super::kinematics::{ContactKinematics, GeometryScratch, PointRows};
use super::master::MasterSurface;
use super::pairs::{Carrier, Contact, SlavePoint};
use super::positions::{MasterPositions, distance};
use crate::dofs::Translations;
use crate::state::PointState;
use slideline_mech::contact::pair::{FacePoint, FaceRoom, Footing};
use slideline_mech::contact::search::faces::FacePlace;
use slideline_mech::contact::search::outlook::Outlook;
use slideline_mech::contact::search::own_faces::{OwnFaces, PlacedOwn};
use slideline_mech::contact::search::sharp_faces::closest;
use slideline_mech::contact::tangential::Tangential;
use slideline_mech::surface::mesh::FaceMesh;

/// Faces by which an open end is prolonged to tell what has slid off [1].
const OFF: f64 = 1.0;

/// A master of faces where it stands.
struct PlacedFaces<'a> {
    mesh: &'a FaceMesh,
    nodes: &'a [([f64; 3], Translations)],
    positions: &'a [[f64; 3]],
    extension: f64,
    itself: Option<&'a OwnFaces>,
}

/// The faces of a pair that meet themselves where they stand.
fn own_faces<'a>(
    (pair, placed): (usize, &PlacedFaces<'a>),
    positions: &'a MasterPositions,
) -> Option<PlacedOwn<'a>> {
    let (tree, standing) = (positions.face_tree(pair)?, positions.standing.get(pair)?);
    Some(PlacedOwn { mesh: placed.mesh, positions: placed.positions, standing, tree })
}

impl Contact {
    fn placed_faces<'a>(
        &'a self,
        pair: usize,
        positions: &'a MasterPositions,
    ) -> Option<PlacedFaces<'a>> {
        let MasterSurface::Faces { mesh, nodes, offset, extension, itself } = &self.masters[pair]
        else {
            return None;
        };
        let positions = positions.nodes.get(*offset..offset + nodes.len())?;
        let (extension, itself) = (*extension, itself.as_deref());
        Some(PlacedFaces { mesh, nodes, positions, extension, itself })
    }

    /// The place of faces that faces a point in space, where open ends are prolonged by
    /// `extension` of their faces, or as the pair says; the face `before` holds it as long as it
    /// hardly stands beyond an edge.
    pub(super) fn face_at(
        &self,
        point: &SlavePoint,
        (position, extension, before): ([f64; 3], Option<f64>, Option<usize>),
        outlook: &Outlook,
        positions: &MasterPositions,
        room: &mut FaceRoom,
    ) -> Option<FacePlace> {
        let placed = self.placed_faces(point.pair, positions)?;
        let tree = positions.face_tree(point.pair)?;
        let reach = extension.unwrap_or(placed.extension);
        if let Some(own) = placed.itself {
            let on = own_faces((point.pair, &placed), positions)?;
            return own.closest(on, (point.seat, reach, before), room.face());
        }
        let at = (position, reach, before, outlook);
        closest(placed.mesh, placed.positions, tree, at, room.face())
    }

    /// The same within the extension of the pair, where the point meets it.
    fn face_met(
        &self,
        point: &SlavePoint,
        (at, before): ([f64; 3], Option<usize>),
        outlook: &Outlook,
        positions: &MasterPositions,
        room: &mut FaceRoom,
    ) -> Option<FacePlace> {
        let facing = self.face_at(point, (at, None, before), outlook, positions, room)?;
        (!self.leaves_out(point, facing.face)).then_some(facing)
    }

    /// Overclosure of the node of a surface that meets itself against what it meets, whichever of
    /// both is the slave [L]; `None` where it meets nothing.
    pub(super) fn met_itself(
        &self,
        point: &SlavePoint,
        positions: &MasterPositions,
    ) -> Option<f64> {
        let Some(placed) = self.placed_faces(point.pair, positions) else {
            return self.masters[point.pair].met_itself((positions, point.pair), point.seat);
        };
        let (on, mut room) = (own_faces((point.pair, &placed), positions)?, FaceRoom::default());
        let place = placed.itself?.met(on, (point.seat, placed.extension), room.face())?;
        let at = (place, placed.positions[point.seat]);
        Some(-FacePoint::new(placed.mesh, placed.positions, at, None, &mut room)?.gap().gap)
    }

    /// Overclosure of a point that faces nothing, were open ends prolonged [L].
    pub(super) fn beyond_faces(
        &self,
        point: &SlavePoint,
        at: [f64; 3],
        positions: &MasterPositions,
    ) -> Option<f64> {
        let placed = self.placed_faces(point.pair, positions)?;
        // where the faces of a surface that meets itself end, its part turns away
        if placed.itself.is_some() {
            return None;
        }
        let (mut room, everywhere) = (FaceRoom::default(), &Outlook::EVERYWHERE);
        if self.face_at(point, (at, None, None), everywhere, positions, &mut room).is_some() {
            return None;
        }
        let off = (at, Some(OFF), None);
        let place = self.face_at(point, off, everywhere, positions, &mut room)?;
        let own = FacePoint::new(placed.mesh, placed.positions, (place, at), None, &mut room)?;
        Some(-own.gap().gap)
    }

    /// How deep a point stands behind the faces that it faces [L].
    pub(super) fn depth_in_faces(
        &self,
        point: &SlavePoint,
        at: [f64; 3],
        positions: &MasterPositions,
        room: &mut FaceRoom,
    ) -> Option<f64> {
        let everywhere = &Outlook::EVERYWHERE;
        let place = self.face_met(point, (at, None), everywhere, positions, room)?;
        let placed = self.placed_faces(point.pair, positions)?;
        let own = FacePoint::new(placed.mesh, placed.positions, (place, at), None, room)?;
        Some(-own.gap().gap)
    }

    /// Where a slave node stands against the faces of its master.
    pub(super) fn locate_face(
        &self,
        place: usize,
        (u, before): (&[f64], Before<'_>),
        positions: &MasterPositions,
        into: &mut ContactKinematics,
    ) {
        let mut room = std::mem::take(&mut into.room);
        let mut unknowns = std::mem::take(&mut into.unknowns);
        self.locate_face_in(place, (u, before), positions, (&mut room, &mut unknowns), into);
        (into.room, into.unknowns) = (room, unknowns);
    }

    fn locate_face_in(
        &self,
        place: usize,
        (u, before): (&[f64], Before<'_>),
        positions: &MasterPositions,
        (room, unknowns): (&mut FaceRoom, &mut Vec<usize>),
        into: &mut ContactKinematics,
    ) {
        let point = &self.points[place];
        let mut into = into.at_mut(place);
        let Carrier::Node { position, dofs, .. } = &point.carrier else { return };
        let at = dofs.displace(*position, u);
        into.point.position = at;
        let (held, allowed) = (before.face(place), self.allowed_of_node(place, before));
        let before = before.points.get(place);
        let footing = before.and_then(|before| before.footing.as_ref());
        let known = self.outlook(point, u);
        let outlook = Outlook::of(&known);
        let facing = self.face_met(point, (at, held), outlook, positions, room);
        let found = facing.and_then(|facing| {
            let placed = self.placed_faces(point.pair, positions)?;
            let faces = (placed.mesh, placed.positions);
            let own = FacePoint::new(faces.0, faces.1, (facing, at), footing, room)?;
            Some((placed, facing, own))
        });
        let Some((placed, facing, own)) = found else {
            into.turn_away_in_place();
            return;
        };
        let origin = before.and_then(|before| before.along).unwrap_or(Tangential::ZERO);
        if self.came_from_behind(place, -own.gap().gap, before) {
            into.turn_away_in_place();
            return;
        }
        into.point.faces = true;
        into.point.overclosure = -own.gap().gap;
        into.point.allow(allowed);
        into.point.along = origin + own.slip;
        into.point.normal = own.gap().normal;
        into.point.facing = Some(Facing::Face(facing));
        into.point.footing = Some(own.footing());
        let mesh = placed.mesh;
        let (stencil, count) = (mesh.stencil(facing.face), dofs.as_slice().len());
        let other = own.other_face().map_or(&[][..], |face| mesh.stencil(face));
        let further = || other.iter().filter(|node| !stencil.contains(node));
        unknowns.clear();
        unknowns.extend_from_slice(dofs.as_slice());
        for &node in stencil.iter().chain(further()) {
            unknowns.extend_from_slice(placed.nodes[node].1.as_slice());
        }
        let width = unknowns.len();
        let rows = into.rows.start(unknowns);
        own.rows(mesh, room, |row, side, node, value| {
            let node = match side {
                2 => {
                    let own = other[node];
                    let of_stencil = stencil.iter().position(|&node| node == own);
                    of_stencil.unwrap_or_else(|| {
                        let place = further().position(|&node| node == own).unwrap_or(0);
                        stencil.len() + place
                    })
                }
                _ => node,
            };
            let first = if side == 0 { 0 } else { count + 3 * node };
            let row = &mut rows[row * width..][first..first + 3];
            row.iter_mut().zip(value).for_each(|(into, value)| *into += value);
        });
    }

    /// The tangent of the geometry of a point on a face, as [`Contact::geometric_tangent`].
    pub(super) fn tangent_of_face(
        &self,
        (pair, facing): (usize, FacePlace),
        (kinematics, before, positions): (&PointRows<'_>, &PointState, &MasterPositions),
        forces: (f64, Tangential),
        scratch: &mut GeometryScratch,
    ) {
        let m = kinematics.rows.width();
        let GeometryScratch { tangent, room, kernel, .. } = scratch;
        tangent.clear();
        tangent.resize(m * m, 0.0);
        let Some(placed) = self.placed_faces(pair, positions) else { return };
        let at = (facing, kinematics.position);
        let (mesh, footing) = (placed.mesh, before.footing.as_ref());
        let Some(own) = FacePoint::new(mesh, placed.positions, at, footing, room) else { return };
        own.derivative(mesh, forces, room, kernel);
        let wide = 3 * (1 + mesh.stencil(facing.face).len());
        for (row, from) in tangent.chunks_exact_mut(m).zip(kernel.chunks_exact(wide)) {
            row[..wide].copy_from_slice(from);
        }
    }

    /// The face that faces a slave node, those about it and the one `before` on which it stood,
    /// where it is near: within `reach` distances of neighbouring slave points or lengths of the
    /// face.
    pub(super) fn near_faces(
        &self,
        place: usize,
        (u, reach, before): (&[f64], f64, Option<&Footing>),
        positions: &MasterPositions,
        into: &mut Vec<usize>,
    ) {
        let point = &self.points[place];
        let Carrier::Node { position, dofs, .. } = &point.carrier else { return };
        let at = dofs.displace(*position, u);
        let (mut room, known) = (FaceRoom::default(), self.outlook(point, u));
        let outlook = Outlook::of(&known);
        let Some(facing) = self.face_at(point, (at, None, None), outlook, positions, &mut room)
        else {
            return;
        };
        let Some(placed) = self.placed_faces(point.pair, positions) else { return };
        if placed.mesh.swept().is_some() {
            // all parts of an analytical surface follow the same markers
            into.extend(into.is_empty().then_some(facing.face));
            return;
        }
        let nodes = &placed.mesh.faces()[facing.face].nodes;
        let distances = nodes.iter().map(|&node| distance(at, placed.positions[node]));
        let corner = |k: usize| placed.positions[nodes[k]];
        let size = distance(corner(0), corner(1)).max(distance(corner(1), corner(2)));
        let nearest = distances.fold(f64::INFINITY, f64::min);
        if nearest > reach * self.spacing[point.pair].max(size) {
            return;
        }
        let about = placed.mesh.around(facing.face).iter().copied();
        let before = before.map(|footing| footing.place.face);
        for face in before.into_iter().chain([facing.face]).chain(about) {
            if !into.contains(&face) {
                into.push(face);
            }
        }
    }
}
