//! Rows of slave nodes whose contact is spread over their faces.
//!
//! ```text
//!   overclosure  e = -n . r / D             r: weighted gap, D: area
//!   slip         T_c . (r_b / D - r_c / D_c)   r_b: places of the last commit by the weights of
//!                                              now, r_c: by those of then
//!   force        D p de + D tau (drag)
//! ```
//!
//! docs/theory.md eqs. (5.24) to (5.28)

use super::super::before::Before;
use super::super::coverage::{Allowed, Release};
use super::super::kinematics::{ContactKinematics, PointRowsMut};
use super::super::master::MasterSurface;
use super::super::pairs::{Carrier, Contact};
use super::place::{FaceState, MortarRoom, Sums};
use super::rooms::MortarRooms;
use super::slave::{Control, Mortar};
use slideline_mech::contact::pair::Body;
use slideline_mech::contact::pair::mortar::{
    Direction, FIRST_MASTER, MOST_CONTROLS, MortarFace, Place,
};
use slideline_mech::contact::tangential::Tangential;
use slideline_mech::vector::dot;

/// No column.
const NONE: usize = usize::MAX;

/// A side of a pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    Slave,
    Master,
}

/// A pair at work.
pub(super) struct At<'a> {
    pub contact: &'a Contact,
    pub mortar: &'a Mortar,
    pub body: Body,
}

impl Contact {
    /// Whether nodes of a pair of which little is covered are let go: under a hard law that lets part.
    pub(in crate::contact) fn lets_go(&self, pair: usize) -> bool {
        !self.keeps[pair] && !self.is_soft(pair)
    }

    /// Whether the tangent of some pair is not symmetric even without friction: where faces are
    /// covered in part, pressures of a softened law change with areas that move (docs/theory.md eq. (5.29)); in
    /// space forces are those of a potential but for the error of the rule of integration (5.11).
    pub fn has_unsymmetric_mortar(&self) -> bool {
        let is_soft = |mortar: &Mortar| self.is_soft(mortar.pair);
        !self.face_mortars.is_empty() || self.mortars.iter().any(is_soft)
    }

    /// Where all points of the mortars stand at displacements `u`, with slips since `before`.
    pub fn locate_mortars(&self, u: &[f64], before: Before<'_>, into: &mut ContactKinematics) {
        let mut rooms = std::mem::take(&mut into.mortars);
        rooms.resize_with(self.mortars.len(), MortarRooms::default);
        for (mortar, rooms) in self.mortars.iter().zip(&mut rooms) {
            self.place_mortar(mortar, u, &mut rooms.now);
            let has_history = !before.u.is_empty() && !before.points.is_empty();
            if has_history && rooms.placed_at != before.u {
                self.place_mortar(mortar, before.u, &mut rooms.before);
                rooms.before.releases(mortar, &mut rooms.releases);
                rooms.placed_at.clear();
                rooms.placed_at.extend_from_slice(before.u);
            }
            rooms.columns.resize(u.len(), NONE);
            let body = self.masters[mortar.pair].placed_body(u);
            let at = At { contact: self, mortar, body };
            for point in 0..mortar.of_point.len() {
                let place = mortar.first + point;
                let along = before.points.get(place).filter(|_| has_history).map(|p| p.along);
                at.locate_point(point, u, along, rooms, into);
            }
        }
        into.mortars = rooms;
    }
}

impl At<'_> {
    /// Where a point stands; `along`: its slip coordinates at the last commit, if there was one and
    /// it faced something then.
    fn locate_point(
        &self,
        point: usize,
        u: &[f64],
        along: Option<Option<Tangential>>,
        rooms: &mut MortarRooms,
        into: &mut ContactKinematics,
    ) {
        let place = self.mortar.first + point;
        let whole = self.contact.points[place].area;
        let sums = rooms.now.sums(self.mortar, point);
        self.list_unknowns(point, rooms);
        into.make_room(rooms.unknowns.len());
        let mut into = into.at_mut(place);
        if let Carrier::Node { position, dofs, .. } = &self.contact.points[place].carrier {
            into.point.position = dofs.displace(*position, u);
        }
        into.point.area = whole;
        if sums.area <= 0.0 {
            into.turn_away_in_place();
        } else {
            self.take_rows(point, sums, along, rooms, &mut into);
        }
        for &dof in &rooms.unknowns {
            rooms.columns[dof] = NONE;
        }
    }

    /// Fills in the dofs that a point follows, its own first, and the weights of the masters at the
    /// last commit.
    fn list_unknowns(&self, point: usize, rooms: &mut MortarRooms) {
        let MortarRooms { now, columns, unknowns, .. } = rooms;
        unknowns.clear();
        let note = |columns: &mut Vec<usize>, unknowns: &mut Vec<usize>, dof: usize| {
            if columns[dof] == NONE {
                columns[dof] = unknowns.len();
                unknowns.push(dof);
            }
        };
        if let Carrier::Node { dofs, .. } = &self.contact.points[self.mortar.first + point].carrier
        {
            dofs.as_slice().iter().for_each(|&dof| note(columns, unknowns, dof));
        }
        for &(face, _) in self.mortar.of_point[point].iter().flatten() {
            let state = &now.faces[face];
            for place in 0..FIRST_MASTER + MOST_CONTROLS * state.curves.len() {
                let Some((side, control)) = self.control(face, place, (state, now)) else {
                    continue;
                };
                self.follow(side, control, |dof, _| note(columns, unknowns, dof));
            }
        }
    }

    /// The control point at a place of a face; `None` where there is none.
    pub(super) fn control(
        &self,
        face: usize,
        place: usize,
        (state, room): (&FaceState, &MortarRoom),
    ) -> Option<(Side, Control)> {
        let Some(of_master) = place.checked_sub(FIRST_MASTER) else {
            let control = *self.mortar.controls(face).get(place)?;
            return control.map(|control| (Side::Slave, control));
        };
        let curve = &room.curves[*state.near.get(of_master / MOST_CONTROLS)?];
        let control = of_master % MOST_CONTROLS;
        (control < curve.count).then(|| (Side::Master, curve.controls[control]))
    }

    /// The dofs that a control point follows, each with the derivative of its place.
    pub(super) fn follow(
        &self,
        side: Side,
        control: Control,
        mut add: impl FnMut(usize, [f64; 3]),
    ) {
        let master = &self.contact.masters[self.mortar.pair];
        if let (Control::Body(_), MasterSurface::Body { dofs, .. }) = (control, master) {
            let [turn, _] = control.turning(&self.body);
            let by = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], turn];
            dofs.iter().zip(by).for_each(|(&dof, by)| add(dof, by));
            return;
        }
        for (node, weight) in control.nodes() {
            let dofs = match side {
                Side::Slave => self.mortar.dofs[node],
                Side::Master => master.nodes()[node].1,
            };
            for (axis, &dof) in dofs.as_slice().iter().enumerate() {
                let mut by = [0.0; 3];
                by[axis] = weight;
                add(dof, by);
            }
        }
    }

    fn take_rows(
        &self,
        point: usize,
        sums: Sums,
        along: Option<Option<Tangential>>,
        rooms: &mut MortarRooms,
        into: &mut PointRowsMut<'_>,
    ) {
        let gap = sums.opening();
        into.point.faces = true;
        into.point.facing = None;
        into.point.footing = None;
        into.point.overclosure = -gap;
        let allowed = self.allowed((point, sums.area), rooms);
        into.point.allow(allowed.overclosure);
        into.point.area = sums.area;
        into.point.normal = sums.normal.map(|x| -x);
        let width = rooms.unknowns.len();
        let rows = into.rows.start(&rooms.unknowns);
        let (row, rest) = rows.split_at_mut(width);
        let (slip, force) = rest.split_at_mut(width);
        let by_area = 1.0 / sums.area;
        let depth = if self.contact.is_soft(self.mortar.pair) { -gap } else { allowed.by_area };
        let normal = Direction { normal: by_area, tangent: 0.0, area: -depth * by_area };
        self.pull(point, Asked::Gradient(normal), rooms, row);
        self.pull(point, Asked::Drag(by_area), rooms, force);
        let Some(along) = along else {
            slip.copy_from_slice(force);
            into.point.along = Tangential::ZERO;
            return;
        };
        let way = self.add_slip(point, sums.area, rooms, slip);
        into.point.along = along.unwrap_or(Tangential::ZERO) + Tangential::along(way);
    }

    /// What a point with that area [L2] is allowed: by the step, and by how little of it is covered.
    pub(super) fn allowed(&self, (point, area): (usize, f64), rooms: &MortarRooms) -> Allowed {
        let release = rooms.releases.get(point).copied().flatten();
        let release = release.filter(|_| self.contact.lets_go(self.mortar.pair));
        let by_step = self.contact.allowed_at(self.mortar.first + point);
        release.unwrap_or(Release::HELD).at(area).and(by_step)
    }

    /// Slip of a point since the last commit [L]; its derivative is added to the row.
    fn add_slip(&self, point: usize, area: f64, rooms: &mut MortarRooms, row: &mut [f64]) -> f64 {
        let then = rooms.before.sums(self.mortar, point);
        let [nx, ny, _] = then.normal;
        let tangent = [-ny, nx];
        let way = self.carry(point, tangent, None, rooms, row) / area;
        self.carry(point, tangent, Some((1.0 / area, -way / area)), rooms, row);
        let offset = -ny * then.gap[0] + nx * then.gap[1];
        way - if then.area > 0.0 { offset / then.area } else { 0.0 }
    }

    /// The weighted way of what faces a point now, summed over its faces; its derivative is added to
    /// the row with these factors.
    fn carry(
        &self,
        point: usize,
        tangent: Place<f64>,
        factors: Option<(f64, f64)>,
        rooms: &mut MortarRooms,
        row: &mut [f64],
    ) -> f64 {
        let mut whole = 0.0;
        for &(face, node) in self.mortar.of_point[point].iter().flatten() {
            let state = &rooms.now.faces[face];
            let Some(shares) = state.shares[node] else { continue };
            rooms.carried.clear();
            rooms.carried.extend(state.near.iter().map(|&curve| rooms.before.placed()[curve]));
            let reference = &self.mortar.faces[face].reference;
            let places = &rooms.before.faces[face].places;
            let before = MortarFace { reference, places, curves: &rooms.carried };
            rooms.pulled.clear();
            rooms
                .pulled
                .resize(FIRST_MASTER + MOST_CONTROLS * state.curves.len(), Place::default());
            let of_face = state.face(self.mortar, face);
            let (at, then) = ((&of_face, &state.segments[..]), (&before, shares));
            whole += state.integrals.carried(at, then, tangent, factors, &mut rooms.pulled);
            self.add_pulled(face, (&rooms.now, &rooms.pulled), &rooms.columns, row);
        }
        whole
    }

    /// Adds derivatives by the places of a point's faces to a row.
    fn pull(&self, point: usize, asked: Asked, rooms: &mut MortarRooms, row: &mut [f64]) {
        for &(face, node) in self.mortar.of_point[point].iter().flatten() {
            let state = &rooms.now.faces[face];
            let Some(shares) = state.shares[node] else { continue };
            let places = FIRST_MASTER + MOST_CONTROLS * state.curves.len();
            rooms.pulled.clear();
            rooms.pulled.resize(places, Place::default());
            let of_face = state.face(self.mortar, face);
            let (whole, into) = ((&of_face, &state.segments[..]), &mut rooms.pulled[..]);
            match asked {
                Asked::Gradient(direction) => {
                    state.integrals.pull(whole, shares, &direction, into);
                }
                Asked::Drag(factor) => state.integrals.drag(whole, shares, factor, into),
            }
            self.add_pulled(face, (&rooms.now, &rooms.pulled), &rooms.columns, row);
        }
    }

    /// Adds derivatives by the places of a face to a row.
    fn add_pulled(
        &self,
        face: usize,
        (room, pulled): (&MortarRoom, &[Place<f64>]),
        columns: &[usize],
        row: &mut [f64],
    ) {
        for (place, &[x, y]) in pulled.iter().enumerate() {
            if [x, y] == Place::default() {
                continue;
            }
            let Some((side, control)) = self.control(face, place, (&room.faces[face], room)) else {
                continue;
            };
            self.follow(side, control, |dof, by| row[columns[dof]] += dot([x, y, 0.0], by));
        }
    }
}

/// Which derivatives are asked for.
#[derive(Clone, Copy)]
enum Asked {
    Gradient(Direction<f64>),
    Drag(f64),
}
