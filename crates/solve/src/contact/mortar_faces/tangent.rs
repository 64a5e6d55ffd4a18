//! How the forces of points that are spread over faces in space turn with these.
//!
//! ```text
//!   of a face, all its corners at a time:  sum p_j d(-dr_j) + ... over its overlaps
//!   of a point: what turns its traction with its normal, and areas under a softened law
//! ```
//!
//! docs/theory.md section 5.11 and eq. (5.29)

use super::super::kinematics::{ContactKinematics, GeometryScratch, PointRows};
use super::super::master::MasterSurface;
use super::super::pairs::Contact;
use super::place::FaceRoom;
use super::rooms::{FaceMortarRooms, FaceScratch};
use super::rows::At;
use slideline_mech::contact::pair::mortar_faces::{Load, MOST_CORNERS, Place, Standing};
use slideline_mech::contact::tangential::Tangential;
use slideline_mech::vector::{Vector, add, scale};

/// What acts on a point.
#[derive(Clone, Copy)]
struct Acting {
    /// Pressure [F/L2].
    pressure: f64,
    /// What of its overclosure counts where the area changes [L].
    depth: f64,
    /// How that changes with the area under a hard law [1/L]; `None`: with the overclosure, under a softened one.
    bend: Option<f64>,
    /// Traction [F/L2].
    traction: Vector,
}

impl Contact {
    /// Tangents of all faces in space that contact is spread over, under normal and tangential
    /// forces of points [F], where these are any: `add(dofs, tangent)`, square, row-major. What turns
    /// with a point alone is in [`Contact::geometric_tangent`].
    pub fn tangents_of_faces(
        &self,
        kinematics: &ContactKinematics,
        forces: impl Fn(usize) -> Option<(f64, Tangential)>,
        scratch: &mut GeometryScratch,
        mut add: impl FnMut(&[usize], &[f64]),
    ) {
        for (mortar, rooms) in self.face_mortars.iter().zip(&kinematics.face_mortars) {
            // a pair that is absent has placed no faces
            if matches!(self.masters[mortar.pair], MasterSurface::Nothing) {
                continue;
            }
            let at = At { contact: self, mortar };
            for face in 0..mortar.faces.len() {
                let acting = mortar.faces[face].points.map(|point| {
                    let place = mortar.first + point;
                    let (own, standing) = (kinematics.at(place), rooms.standings.get(point)?.now?);
                    let forces = forces(place).filter(|_| own.faces)?;
                    Some(at.acting((&own, point), &standing, forces, rooms))
                });
                at.add_face((face, &acting), &rooms.now, &mut scratch.face_mortar, &mut add);
            }
        }
    }

    /// Adds what turns with a point of a mortar in space alone to its geometric tangent.
    pub fn tangent_of_face_mortar(
        &self,
        (own, place): (usize, usize),
        rooms: &FaceMortarRooms,
        kinematics: &PointRows<'_>,
        forces: (f64, Tangential),
        scratch: &mut GeometryScratch,
    ) {
        let mortar = &self.face_mortars[own];
        let at = At { contact: self, mortar };
        let point = place - mortar.first;
        let Some(standing) = rooms.standings.get(point).and_then(|own| own.now) else { return };
        let acting = at.acting((kinematics, point), &standing, forces, rooms);
        let tractions = (1.0 / kinematics.area) * forces.1;
        let GeometryScratch { tangent, face_mortar: room, columns, .. } = scratch;
        list_columns(kinematics, columns);
        if acting.bend != Some(0.0) {
            at.add_areas(point, &acting, &rooms.now, (columns, room), (tangent, kinematics));
        }
        if tractions != Tangential::ZERO {
            let turning = (&standing, tractions);
            at.add_turn(point, turning, &rooms.now, (columns, room), (tangent, kinematics));
        }
        kinematics.rows.unknowns.iter().for_each(|&dof| columns[dof] = usize::MAX);
    }
}

/// Columns of the unknowns of a point, by dof.
fn list_columns(kinematics: &PointRows<'_>, columns: &mut Vec<usize>) {
    for (column, &dof) in kinematics.rows.unknowns.iter().enumerate() {
        if columns.len() <= dof {
            columns.resize(dof + 1, usize::MAX);
        }
        columns[dof] = column;
    }
}

impl At<'_> {
    /// What acts on a point under a normal and a tangential force [F].
    fn acting(
        &self,
        (point, place): (&PointRows<'_>, usize),
        standing: &Standing,
        (normal, tangential): (f64, Tangential),
        rooms: &FaceMortarRooms,
    ) -> Acting {
        let (depth, bend) = if self.contact.is_soft(self.mortar.pair) {
            (point.overclosure + point.allowed, None)
        } else {
            let allowed = self.allowed((place, point.area), rooms);
            (allowed.by_area, Some(allowed.bend))
        };
        let [first, second] = standing.directions();
        let [along_first, along_second] = tangential.0.map(|force| force / point.area);
        Acting {
            pressure: normal / point.area,
            depth,
            bend,
            traction: add(scale(first, along_first), scale(second, along_second)),
        }
    }

    /// What moves with the overlaps of a face.
    fn add_face(
        &self,
        (face, acting): (usize, &[Option<Acting>; MOST_CORNERS]),
        now: &FaceRoom,
        room: &mut FaceScratch,
        mut add: impl FnMut(&[usize], &[f64]),
    ) {
        let (slave, state) = (&self.mortar.faces[face], &now.faces[face]);
        let mut load = Load::nothing();
        let mut is_loaded = false;
        for (corner, given) in state.given.iter().enumerate() {
            let Some(acting) = given.and_then(|given| acting[given]) else { continue };
            load.gap[corner] = -acting.pressure;
            load.area[corner] = -acting.pressure * acting.depth;
            load.drag[corner] = acting.traction;
            is_loaded |= acting.pressure != 0.0 || acting.traction != [0.0; 3];
        }
        if !is_loaded {
            return;
        }
        for overlap in &state.overlaps {
            let couple = state.couple(slave, overlap);
            if !room.sweep.sweep(&couple, overlap, &load, &mut room.swept) {
                continue;
            }
            room.dofs.clear();
            for node in 0..couple.count() {
                room.dofs.extend_from_slice(self.dofs((face, now), overlap, node));
            }
            add(&room.dofs, &room.swept.derivative);
        }
    }

    /// The area of a face that is covered in part changes too: under a softened law its pressure
    /// does with it.
    fn add_areas(
        &self,
        point: usize,
        acting: &Acting,
        now: &FaceRoom,
        (columns, room): (&[usize], &mut FaceScratch),
        (tangent, kinematics): (&mut [f64], &PointRows<'_>),
    ) {
        let m = kinematics.rows.width();
        room.by_area.clear();
        room.by_area.resize(m, 0.0);
        for &(face, own) in &self.mortar.of_point[point] {
            let (slave, state) = (&self.mortar.faces[face], &now.faces[face]);
            let mut of_area = Load::nothing();
            for (corner, given) in state.given.iter().enumerate() {
                of_area.area[corner] = if *given == Some(own) { 1.0 } else { 0.0 };
            }
            for overlap in &state.overlaps {
                let couple = state.couple(slave, overlap);
                room.pulled.clear();
                room.pulled.resize(couple.count(), Place::default());
                couple.pull(overlap, &[of_area], [&mut room.pulled]);
                for (node, by) in room.pulled.iter().enumerate() {
                    let dofs = self.dofs((face, now), overlap, node);
                    let own = dofs.iter().zip(by);
                    own.for_each(|(&dof, by)| room.by_area[columns[dof]] += by);
                }
            }
        }
        let (by, factor) = match acting.bend {
            None => (kinematics.rows.normal(), acting.pressure),
            Some(bend) => (&room.by_area[..], acting.pressure * bend),
        };
        for (row, &by_area) in tangent.chunks_exact_mut(m).zip(&room.by_area) {
            row.iter_mut().zip(by).for_each(|(entry, by)| *entry -= factor * by_area * by);
        }
    }

    /// What turns the traction with the normal of the point.
    fn add_turn(
        &self,
        point: usize,
        (standing, tractions): (&Standing, Tangential),
        now: &FaceRoom,
        (columns, room): (&[usize], &mut FaceScratch),
        (tangent, kinematics): (&mut [f64], &PointRows<'_>),
    ) {
        let m = kinematics.rows.width();
        let FaceScratch { drags, turns, .. } = room;
        for axis in 0..3 {
            let mut unit = [0.0; 3];
            unit[axis] = 1.0;
            let own = &mut drags[axis];
            own.clear();
            own.resize(m, 0.0);
            self.drags(point, unit, now, |dof, value| own[columns[dof]] += value);
            let by_normal = [0, 1].map(|k| scale(standing.pull(k, unit), tractions.0[k]));
            let own = &mut turns[axis];
            own.clear();
            own.resize(m, 0.0);
            let whole = (self.mortar, point);
            now.pull_normal(whole, add(by_normal[0], by_normal[1]), |face, node, value| {
                let node = self.mortar.faces[face].nodes[node];
                let dofs = self.mortar.dofs[node].as_slice();
                dofs.iter().zip(value).for_each(|(&dof, value)| own[columns[dof]] += value);
            });
        }
        for (drag, turn) in drags.iter().zip(turns.iter()) {
            for (row, drag) in tangent.chunks_exact_mut(m).zip(drag) {
                row.iter_mut().zip(turn).for_each(|(entry, turn)| *entry += drag * turn);
            }
        }
    }
}
