//! How the rows of a point that is spread over faces turn with these.

use super::super::kinematics::{GeometryScratch, PointRows};
use super::super::pairs::Contact;
use super::place::FaceState;
use super::rooms::{MortarRooms, MortarScratch};
use super::rows::At;
use slideline_mech::contact::pair::mortar::{
    Direction, FIRST_MASTER, MOST_CONTROLS, Place, Shares,
};
use slideline_mech::contact::tangential::Tangential;

impl Contact {
    /// Adds the geometric tangent of a point of a mortar, as
    /// [`Contact::geometric_tangent`].
    pub fn tangent_of_mortar(
        &self,
        (own, place): (usize, usize),
        (u, rooms): (&[f64], &MortarRooms),
        kinematics: &PointRows<'_>,
        (normal, tangential): (f64, Tangential),
        scratch: &mut GeometryScratch,
    ) {
        let mortar = &self.mortars[own];
        let body = self.masters[mortar.pair].placed_body(u);
        let at = At { contact: self, mortar, body };
        let GeometryScratch { tangent, mortar: room, .. } = scratch;
        let m = kinematics.rows.width();
        let area = kinematics.area;
        room.by_area.clear();
        room.by_area.resize(m, 0.0);
        let is_soft = self.is_soft(mortar.pair);
        let allowed = at.allowed((place - mortar.first, area), rooms);
        let depth = match is_soft {
            true => kinematics.overclosure + kinematics.allowed,
            false => allowed.by_area,
        };
        for &(face, node) in mortar.of_point[place - mortar.first].iter().flatten() {
            let state = &rooms.now.faces[face];
            let Some(shares) = state.shares[node] else { continue };
            let of_face = state.face(mortar, face);
            let forces = (normal / area, depth, tangential[0] / area);
            room.sweep.tangent((&of_face, &state.segments), shares, forces, &mut room.of_face);
            let places = FIRST_MASTER + MOST_CONTROLS * state.curves.len();
            room.entries.clear();
            for place in 0..places {
                let Some((side, control)) = at.control(face, place, (state, &rooms.now)) else {
                    continue;
                };
                let [_, bend] = control.turning(&body);
                let force = room.of_face.force[place];
                at.follow(side, control, |dof, by| {
                    let column = kinematics.rows.unknowns.iter().position(|&own| own == dof);
                    let Some(column) = column else { return };
                    room.entries.push((place, column, by));
                    // of a body the third dof turns: its second derivative
                    if bend != [0.0; 3] && by[0] != 1.0 && by[1] != 1.0 {
                        tangent[column * m + column] += force[0] * bend[0] + force[1] * bend[1];
                    }
                });
            }
            if is_soft || allowed.bend != 0.0 {
                at.note_area((state, face, shares), (kinematics, rooms), room);
            }
            let wide = 2 * places;
            let derivative = &room.of_face.derivative;
            for &(i, row, left) in &room.entries {
                for &(j, column, right) in &room.entries {
                    let block = |a: usize, b: usize| derivative[(2 * i + a) * wide + 2 * j + b];
                    let half = |b: usize| left[0] * block(0, b) + left[1] * block(1, b);
                    tangent[row * m + column] += half(0) * right[0] + half(1) * right[1];
                }
            }
        }
        // the area of a face that is covered in part changes too
        let pressure = normal / area;
        let (by, factor) = match is_soft {
            true => (kinematics.rows.normal(), pressure),
            false => (&room.by_area[..], pressure * allowed.bend),
        };
        for (row, &by_area) in tangent.chunks_exact_mut(m).zip(&room.by_area) {
            row.iter_mut().zip(by).for_each(|(entry, by)| *entry -= factor * by_area * by);
        }
    }
}

impl At<'_> {
    /// Adds the derivative of the area of a node of a face that is covered in part.
    fn note_area(
        &self,
        (state, face, shares): (&FaceState, usize, Shares),
        (kinematics, rooms): (&PointRows<'_>, &MortarRooms),
        room: &mut MortarScratch,
    ) {
        let MortarScratch { pulled, by_area, .. } = room;
        pulled.clear();
        pulled.resize(FIRST_MASTER + MOST_CONTROLS * state.curves.len(), Place::default());
        let direction = Direction { normal: 0.0, tangent: 0.0, area: 1.0 };
        let of_face = state.face(self.mortar, face);
        state.integrals.pull((&of_face, &state.segments), shares, &direction, pulled);
        for (place, [x, y]) in pulled.iter().enumerate() {
            let Some((side, control)) = self.control(face, place, (state, &rooms.now)) else {
                continue;
            };
            self.follow(side, control, |dof, by| {
                if let Some(column) = kinematics.rows.unknowns.iter().position(|&own| own == dof) {
                    by_area[column] += x * by[0] + y * by[1];
                }
            });
        }
    }
}
