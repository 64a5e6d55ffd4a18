//! Rows of slave corners whose contact is spread over faces in space.
//!
//! ```text
//!   overclosure  e = -r / D                     r: weighted gap, D: area
//!   slip         t_c . (w_b / D - w_c / D_c)    w_b: ways of the last commit by the weights of now,
//!                                               w_c: by those of then
//!   force        D p de + D tau . (drag)
//! ```
//!
//! docs/theory.md eqs. (5.33) to (5.38)

use super::super::before::Before;
use super::super::coverage::{Allowed, Release};
use super::super::kinematics::{ContactKinematics, PointRowsMut};
use super::super::master::MasterSurface;
use super::super::pairs::{Carrier, Contact};
use super::gradients::{OverlapGradients, before, lists};
use super::place::FaceRoom;
use super::rooms::{Asked, FaceMortarRooms, Standings};
use super::slave::FaceMortar;
use crate::state::PointState;
use slideline_mech::contact::pair::mortar_faces::{MOST_NODES, Overlap, Place, Standing};
use slideline_mech::contact::tangential::Tangential;
use slideline_mech::vector::{Vector, add, dot, scale};

/// No column.
const NONE: usize = usize::MAX;

/// A pair at work.
pub(super) struct At<'a> {
    pub contact: &'a Contact,
    pub mortar: &'a FaceMortar,
}

impl Contact {
    /// Where all points of the mortars in space stand at displacements `u`, with slips since
    /// `before`.
    pub fn locate_face_mortars(&self, u: &[f64], before: Before<'_>, into: &mut ContactKinematics) {
        let mut all = std::mem::take(&mut into.face_mortars);
        all.resize_with(self.face_mortars.len(), FaceMortarRooms::default);
        for (mortar, rooms) in self.face_mortars.iter().zip(&mut all) {
            if matches!(self.masters[mortar.pair], MasterSurface::Nothing) {
                self.face_nothing(mortar, u, into);
                continue;
            }
            self.place_face_mortar(mortar, u, &mut rooms.now);
            let has_history = !before.u.is_empty() && !before.points.is_empty();
            if has_history && rooms.placed_at != before.u {
                self.place_face_mortar(mortar, before.u, &mut rooms.before);
                rooms.before.releases(mortar, &mut rooms.releases);
                rooms.placed_at.clear();
                rooms.placed_at.extend_from_slice(before.u);
            }
            rooms.columns.resize(u.len(), NONE);
            let at = At { contact: self, mortar };
            let history = if has_history { Some(before.points) } else { None };
            at.locate(u, history, rooms, into);
        }
        into.face_mortars = all;
    }

    /// The points of a mortar whose pair is absent.
    fn face_nothing(&self, mortar: &FaceMortar, u: &[f64], into: &mut ContactKinematics) {
        for place in mortar.first..mortar.first + mortar.of_point.len() {
            let mut own = into.at_mut(place);
            if let Carrier::Node { position, dofs, .. } = &self.points[place].carrier {
                own.point.position = dofs.displace(*position, u);
            }
            own.point.area = self.points[place].area;
            own.turn_away_in_place();
        }
    }
}

impl At<'_> {
    fn locate(
        &self,
        u: &[f64],
        history: Option<&[PointState]>,
        rooms: &mut FaceMortarRooms,
        into: &mut ContactKinematics,
    ) {
        let mortar = self.mortar;
        let points = 0..mortar.of_point.len();
        let mut standings = std::mem::take(&mut rooms.standings);
        standings.clear();
        standings.extend(points.clone().map(|point| self.standings(point, history, rooms)));
        let rubs = history.is_some() && self.contact.laws[mortar.pair].has_friction();
        let mut asked = std::mem::take(&mut rooms.asked);
        asked.clear();
        if history.is_some() {
            let of_points = points.clone().zip(&standings);
            asked.extend(of_points.map(|(point, own)| self.ask(point, own, rooms)));
        }
        (rooms.standings, rooms.asked) = (standings, asked);
        rooms.take_gradients(mortar, rubs);
        for point in points {
            let standings = rooms.standings[point];
            let place = mortar.first + point;
            self.list_unknowns(point, rooms);
            into.make_room(rooms.unknowns.len());
            let mut own = into.at_mut(place);
            if let Carrier::Node { position, dofs, .. } = &self.contact.points[place].carrier {
                own.point.position = dofs.displace(*position, u);
            }
            own.point.area = self.contact.points[place].area;
            let area = rooms.now.sums(mortar, point).area;
            match standings.now {
                Some(standing) if area > 0.0 => {
                    let along = history.and_then(|points| points.get(place)?.along);
                    let asked = rooms.asked.get(point);
                    let slip = asked.map(|&own| (own, along.unwrap_or(Tangential::ZERO), rubs));
                    self.take_rows((point, &standing), slip, rooms, &mut own);
                }
                _ => own.turn_away_in_place(),
            }
            own.point.footing = standings.now.map(|standing| standing.footing);
            rooms.unknowns.iter().for_each(|&dof| rooms.columns[dof] = NONE);
        }
    }

    /// How a point stands now, and how it stood at the last commit.
    fn standings(
        &self,
        point: usize,
        history: Option<&[PointState]>,
        rooms: &FaceMortarRooms,
    ) -> Standings {
        let then = history.and_then(|points| {
            let known = points.get(self.mortar.first + point)?.footing;
            let stood = || rooms.before.standing(self.mortar, point, None).map(|own| own.footing);
            known.or_else(stood)
        });
        Standings { now: rooms.now.standing(self.mortar, point, then.as_ref()), then }
    }

    /// What the slip of a point asks for.
    fn ask(&self, point: usize, standings: &Standings, rooms: &FaceMortarRooms) -> Asked {
        let Some(then) = standings.then else { return Asked::default() };
        let directions = then.directions();
        let (mut area, mut way) = (0.0, [0.0; 3]);
        rooms.now.each_corner(self.mortar, point, |face, corner| {
            let state = &rooms.now.faces[face];
            for (overlap, (sums, weights)) in state.overlaps.iter().zip(&state.parts) {
                let sides = (self.mortar, &rooms.before);
                let (slave, master) = before(sides, (face, overlap), state);
                area += sums.areas[corner];
                let own = weights.way(corner, &slave, &master);
                way = add(way, own);
            }
        });
        let by_area = if area > 0.0 { 1.0 / area } else { 0.0 };
        Asked { directions, area, ways: Tangential(directions.map(|t| by_area * dot(t, way))) }
    }

    /// Fills in the dofs that a point follows, its own first.
    fn list_unknowns(&self, point: usize, rooms: &mut FaceMortarRooms) {
        let FaceMortarRooms { now, columns, unknowns, .. } = rooms;
        unknowns.clear();
        let mut note = |dofs: &[usize]| {
            for &dof in dofs {
                if columns[dof] == NONE {
                    columns[dof] = unknowns.len();
                    unknowns.push(dof);
                }
            }
        };
        let own = &self.contact.points[self.mortar.first + point].carrier;
        if let Carrier::Node { dofs, .. } = own {
            note(dofs.as_slice());
        }
        let masters = self.contact.masters[self.mortar.pair].nodes();
        for &(face, _) in &self.mortar.of_point[point] {
            let nodes = self.mortar.faces[face].nodes();
            nodes.iter().for_each(|&node| note(self.mortar.dofs[node].as_slice()));
            for master in &now.faces[face].masters {
                master.nodes().iter().for_each(|&node| note(masters[node].1.as_slice()));
            }
        }
    }

    /// The dofs of a node of an overlap: of the slave first, then of the master.
    pub(super) fn dofs(
        &self,
        (face, room): (usize, &FaceRoom),
        overlap: &Overlap,
        node: usize,
    ) -> &[usize] {
        let own = &self.mortar.faces[face];
        match node.checked_sub(own.count) {
            None => self.mortar.dofs[own.nodes[node]].as_slice(),
            Some(node) => {
                let node = room.faces[face].masters[overlap.master].nodes[node];
                self.contact.masters[self.mortar.pair].nodes()[node].1.as_slice()
            }
        }
    }

    fn take_rows(
        &self,
        (point, standing): (usize, &Standing),
        slip: Option<(Asked, Tangential, bool)>,
        rooms: &FaceMortarRooms,
        into: &mut PointRowsMut<'_>,
    ) {
        let sums = rooms.now.sums(self.mortar, point);
        let overclosure = -sums.gap / sums.area;
        into.point.faces = true;
        into.point.facing = None;
        into.point.overclosure = overclosure;
        let allowed = self.allowed((point, sums.area), rooms);
        into.point.allow(allowed.overclosure);
        into.point.area = sums.area;
        into.point.normal = standing.footing.normal;
        let width = rooms.unknowns.len();
        let rows = into.rows.start(&rooms.unknowns);
        let (normal, rest) = rows.split_at_mut(width);
        let (slips, forces) = rest.split_at_mut(2 * width);
        let by_area = 1.0 / sums.area;
        let is_soft = self.contact.is_soft(self.mortar.pair);
        let depth = if is_soft { overclosure } else { allowed.by_area };
        let rubs = slip.is_some_and(|(_, _, rubs)| rubs);
        self.each_overlap(point, rooms, rubs, |corner, whole, gradients| {
            let lists =
                [(gradients.gap(corner), -by_area), (gradients.area(corner), -by_area * depth)];
            for (list, factor) in lists {
                self.add(whole, rooms, (list, factor), normal);
            }
            for k in (0..2).filter(|_| rubs) {
                let list = gradients.slip(corner, k);
                self.add(whole, rooms, (list, 1.0), &mut slips[k * width..][..width]);
            }
        });
        for (k, t) in standing.directions().into_iter().enumerate() {
            let row = &mut forces[k * width..][..width];
            self.drag(point, scale(t, by_area), rooms, |column, value| row[column] += value);
        }
        if !rubs {
            slips.copy_from_slice(forces);
        }
        into.point.along = Tangential::ZERO;
        if let Some((asked, along, _)) = slip {
            let then = rooms.before.sums(self.mortar, point);
            let by_then = if then.area > 0.0 { 1.0 / then.area } else { 0.0 };
            let ways =
                [0, 1].map(|k| asked.ways.0[k] - by_then * dot(asked.directions[k], then.way));
            into.point.along = along + Tangential(ways);
        }
    }

    /// What a point with that area [L2] is allowed: by the step, and by how little of it is covered.
    pub(super) fn allowed(&self, (point, area): (usize, f64), rooms: &FaceMortarRooms) -> Allowed {
        let release = rooms.releases.get(point).copied().flatten();
        let release = release.filter(|_| self.contact.lets_go(self.mortar.pair));
        let by_step = self.contact.allowed_at(self.mortar.first + point);
        release.unwrap_or(Release::HELD).at(area).and(by_step)
    }

    /// Calls with the overlaps of the corners whose functions a point has, and their derivatives.
    fn each_overlap(
        &self,
        point: usize,
        rooms: &FaceMortarRooms,
        rubs: bool,
        mut call: impl FnMut(usize, (usize, &Overlap), OverlapGradients<'_>),
    ) {
        rooms.now.each_corner(self.mortar, point, |face, corner| {
            let state = &rooms.now.faces[face];
            let mut begin = rooms.begins[face];
            for overlap in &state.overlaps {
                let nodes = state.couple(&self.mortar.faces[face], overlap).count();
                let gradients = OverlapGradients::new(&rooms.gradients[begin..], nodes);
                call(corner, (face, overlap), gradients);
                begin += lists(rubs) * nodes;
            }
        });
    }

    /// Adds derivatives by the nodes of an overlap to a row.
    fn add(
        &self,
        (face, overlap): (usize, &Overlap),
        rooms: &FaceMortarRooms,
        (list, factor): (&[Place<f64>], f64),
        row: &mut [f64],
    ) {
        for (node, by) in list.iter().enumerate() {
            let dofs = self.dofs((face, &rooms.now), overlap, node);
            for (&dof, by) in dofs.iter().zip(by) {
                row[rooms.columns[dof]] += factor * by;
            }
        }
    }

    /// How a point's nodes drag along a vector: the weights stand still. `add(column, value)`.
    fn drag(
        &self,
        point: usize,
        along: Vector,
        rooms: &FaceMortarRooms,
        mut add: impl FnMut(usize, f64),
    ) {
        self.drags(point, along, &rooms.now, |dof, value| add(rooms.columns[dof], value));
    }

    /// The same by dofs. docs/theory.md eq. (5.36)
    pub(super) fn drags(
        &self,
        point: usize,
        along: Vector,
        room: &FaceRoom,
        mut add: impl FnMut(usize, f64),
    ) {
        room.each_corner(self.mortar, point, |face, corner| {
            let (own, state) = (&self.mortar.faces[face], &room.faces[face]);
            let mut push = |overlap: &Overlap, node: usize, value: Vector| {
                let dofs = self.dofs((face, room), overlap, node);
                dofs.iter().zip(value).for_each(|(&dof, value)| add(dof, value));
            };
            for (overlap, (sums, weights)) in state.overlaps.iter().zip(&state.parts) {
                let couple = state.couple(own, overlap);
                for node in 0..own.count {
                    push(overlap, node, scale(along, weights.slave[corner][node]));
                }
                for node in own.count..couple.count() {
                    let weight = weights.master[corner][node - own.count];
                    push(overlap, node, scale(along, -weight));
                }
                let mut turned = [[0.0; 3]; MOST_NODES];
                couple.pull_normal(overlap, scale(along, sums.gaps[corner]), &mut turned);
                for (node, &value) in turned[..own.count].iter().enumerate() {
                    push(overlap, node, value);
                }
            }
        });
    }
}
