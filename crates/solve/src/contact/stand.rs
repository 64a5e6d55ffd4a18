//! Where slave points stand against their masters in one configuration.

use super::before::Before;
use super::facing::Standing;
use super::kinematics::{ContactKinematics, PointKinematics, PointRowsMut};
use super::master::MasterSurface;
use super::pairs::{Carrier, Contact, SlavePoint};
use super::positions::MasterPositions;
use super::segment::{SEGMENT_POINTS, SlaveSegment};
use super::stencil::Stencil;

/// Dofs of the edges that cross, and of those of the last commit.
const MOST_DOFS_OF_CROSSING: usize = 24;

impl Contact {
    /// All points, facing nothing yet, each with room for the dofs it may follow.
    pub fn nowhere(&self) -> ContactKinematics {
        let mut kinematics = ContactKinematics::default();
        self.forget(&mut kinematics);
        kinematics
    }

    /// Lets points face nothing, in the room they have.
    pub fn forget(&self, kinematics: &mut ContactKinematics) {
        let room = |point: &SlavePoint| {
            let own = match &point.carrier {
                Carrier::Node { dofs, .. } => dofs.as_slice().len() + 1,
                Carrier::IntegrationPoint { segment } => self.segments[*segment].all_dofs().count(),
            };
            let of_crossing = if point.is_crossing { MOST_DOFS_OF_CROSSING } else { 0 };
            (own + self.masters[point.pair].most_dofs()).max(of_crossing)
        };
        let room = self.points.iter().map(room).max().unwrap_or(0);
        kinematics.forget(self.points.len(), room, self.directions);
    }

    /// Where every point stands at displacements `u`, with slips since the states `before`, of
    /// which there may be none. `positions` is scratch. Points that `idle` names are left as they
    /// are.
    pub fn locate(
        &self,
        (u, before): (&[f64], Before<'_>),
        idle: &[bool],
        positions: &mut MasterPositions,
        into: &mut ContactKinematics,
    ) {
        self.place_masters(u, positions);
        self.locate_mortars(u, before, into);
        self.locate_face_mortars(u, before, into);
        for (place, point) in self.points.iter().enumerate() {
            let is_idle = idle.get(place).is_some_and(|&idle| idle);
            if !is_idle && point.is_node() {
                self.locate_one(place, (u, before), positions, into);
                self.take_area(place, (u, before), into);
            }
        }
        self.locate_crossings(u, before, into);
        for segment in &self.segments {
            self.locate_segment(segment, (u, before), into);
        }
    }

    /// As [`Contact::locate`], with integration points left where they stand on their
    /// elements.
    pub fn locate_in_place(
        &self,
        (u, before): (&[f64], Before<'_>),
        positions: &mut MasterPositions,
        into: &mut ContactKinematics,
    ) {
        self.place_masters(u, positions);
        self.locate_mortars(u, before, into);
        self.locate_face_mortars(u, before, into);
        for (place, point) in self.points.iter().enumerate() {
            let is_there = into.points()[place].faces || point.is_node();
            if is_there && point.mortar.is_none() {
                self.locate_one(place, (u, before), positions, into);
            }
        }
        self.locate_crossings(u, before, into);
    }

    /// Where the points that `idle` names stand at displacements `u`, for which
    /// the masters are placed already.
    pub fn locate_idle(
        &self,
        (u, before): (&[f64], Before<'_>),
        idle: &[bool],
        positions: &MasterPositions,
        into: &mut ContactKinematics,
    ) {
        for place in (0..self.points.len()).filter(|&place| idle[place]) {
            self.locate_one(place, (u, before), positions, into);
            self.take_area(place, (u, before), into);
        }
    }

    /// The area of a slave node that was just looked at.
    fn take_area(&self, place: usize, at: (&[f64], Before<'_>), into: &mut ContactKinematics) {
        let point = into.at_mut(place).point;
        point.area = self.area_of_node(place, at, point);
    }

    /// Where all points stand at displacements `u`, however far from their masters;
    /// integration points where their cells, wholly closed, have them.
    pub fn stand(&self, u: &[f64], positions: &mut MasterPositions, into: &mut ContactKinematics) {
        self.place_masters(u, positions);
        self.locate_mortars(u, Before::NOTHING, into);
        self.locate_face_mortars(u, Before::NOTHING, into);
        let alone = |(_, point): &(usize, &SlavePoint)| point.mortar.is_none();
        for (place, point) in self.points.iter().enumerate().filter(alone) {
            into.at_mut(place).point.xi = self.resting_place(place);
            self.locate_one(place, (u, Before::NOTHING), positions, into);
            match point.is_integration_point() {
                true => into.at_mut(place).point.area = point.area,
                false => self.take_area(place, (u, Before::NOTHING), into),
            }
        }
        self.locate_crossings(u, Before::NOTHING, into);
    }

    /// Where one of them stands, without its rows; the masters are placed already.
    pub(super) fn stands(
        &self,
        place: usize,
        u: &[f64],
        positions: &MasterPositions,
    ) -> PointKinematics {
        let point = &self.points[place];
        let xi = self.resting_place(place);
        let mut kinematics = PointKinematics { area: point.area, xi, ..PointKinematics::NOWHERE };
        let mut stencil = self.slave(point, xi, u);
        kinematics.position = stencil.position;
        if let Some((gap, facing)) = self.face(point, xi, u, positions, &mut stencil) {
            kinematics.take(&gap, facing, stencil.along(&gap, u));
        }
        kinematics
    }

    /// Whether a point faces nothing because its master ends, and would touch
    /// it, up to a gap of `slack`, were that end prolonged; an integration point at `xi`
    /// of its element.
    pub fn has_slid_off(&self, place: usize, (xi, slack): (f64, f64), u: &[f64]) -> bool {
        let mut positions = MasterPositions::default();
        self.place_masters(u, &mut positions);
        let point = &self.points[place];
        let mut stencil = self.slave(point, xi, u);
        let begins = self.laws[point.pair].normal.contact_begins();
        if let MasterSurface::Faces { .. } = &self.masters[point.pair] {
            let beyond = self.beyond_faces(point, stencil.position, &positions);
            return beyond.is_some_and(|overclosure| overclosure > begins - slack);
        }
        if self.face(point, xi, u, &positions, &mut stencil).is_some() {
            return false;
        }
        let beyond = self.masters[point.pair].beyond_end(stencil.position, u, &positions.nodes);
        let begins = begins - self.offsets[point.pair].both();
        beyond.is_some_and(|overclosure| overclosure > begins - slack)
    }

    fn locate_one(
        &self,
        place: usize,
        (u, before): (&[f64], Before<'_>),
        positions: &MasterPositions,
        into: &mut ContactKinematics,
    ) {
        let point = &self.points[place];
        if let MasterSurface::Faces { .. } = &self.masters[point.pair] {
            self.locate_face(place, (u, before), positions, into);
            return;
        }
        let mut into = into.at_mut(place);
        let mut stencil = self.slave(point, into.point.xi, u);
        self.locate_stencil((point, before.face(place)), &mut stencil, (u, positions), &mut into);
        if into.point.faces {
            let allowed = match &point.carrier {
                Carrier::Node { .. } => self.allowed_of_node(place, before),
                Carrier::IntegrationPoint { segment } => {
                    self.allowed_along(&self.segments[*segment], into.point.xi)
                }
            };
            let deep = into.point.overclosure;
            into.point.allow(allowed);
            if self.came_from_behind(place, deep, before.points.get(place)) {
                into.turn_away_in_place();
            }
        }
    }

    fn locate_stencil(
        &self,
        (point, on): (&SlavePoint, Option<usize>),
        stencil: &mut Stencil<'_>,
        (u, positions): (&[f64], &MasterPositions),
        into: &mut PointRowsMut<'_>,
    ) {
        into.point.position = stencil.position;
        let slave = self.attachment(point, into.point.xi);
        let master = &self.masters[point.pair];
        let standing = Standing { at: stencil.position, on };
        let Some(facing) = self.faced(point, standing, (u, positions)) else {
            return into.turn_away_in_place();
        };
        match master.gap(&facing, slave, (u, &positions.nodes), stencil) {
            Some(gap) => {
                into.point.take(&gap, facing, stencil.along(&gap, u));
                into.take(&gap, stencil, u);
            }
            None => into.turn_away_in_place(),
        }
    }

    /// Integration points follow the closed part of their cells; those of cells that
    /// contact cannot reach in an iteration face nothing.
    fn locate_segment(
        &self,
        segment: &SlaveSegment,
        (u, before): (&[f64], Before<'_>),
        into: &mut ContactKinematics,
    ) {
        let own = segment.first..segment.first + SEGMENT_POINTS;
        own.for_each(|place| into.at_mut(place).turn_away());
        let (law, offset) = (&self.laws[segment.pair].normal, self.offsets[segment.pair]);
        let begins = law.contact_begins() - offset.both();
        let master = &self.masters[segment.pair];
        let MasterSurface::Body { surface, .. } = master else { return };
        let body = master.placed_body(u);
        let ends = segment.ends(u);
        let placed = segment.line.placed(&ends);
        let beyond = |xi: f64| {
            let overclosure = surface.overclosure(&body, placed.position(xi));
            let allowed = self.allowed_along(segment, xi);
            overclosure.unwrap_or(f64::NEG_INFINITY) - allowed - begins
        };
        let keeps = self.keeps[segment.pair];
        let kept = |cell: usize| segment.closed_before(cell, before.points).filter(|_| keeps);
        let none = MasterPositions::default();
        segment.place_integration_points(beyond, kept, |integration_point, xi, area| {
            let place = segment.first + integration_point;
            let mut into = into.at_mut(place);
            (into.point.xi, into.point.area) = (xi, area);
            let (point, mut stencil) = (&self.points[place], segment.stencil(&ends, xi));
            self.locate_stencil((point, None), &mut stencil, (u, &none), &mut into);
            if into.point.faces {
                into.point.allow(self.allowed_along(segment, xi));
            }
        });
    }
}
