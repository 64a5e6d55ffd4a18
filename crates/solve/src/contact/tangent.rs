//! How the rows of a slave point turn with what it faces.

use super::facing::Facing;
use super::kinematics::{GeometryScratch, PointRows};
use super::master::MasterSurface;
use super::pairs::Contact;
use super::positions::MasterPositions;
use crate::state::PointState;
use slideline_mech::contact::gap::Quadratic;
use slideline_mech::contact::search::through::CONTROLS;
use slideline_mech::contact::tangential::Tangential;
use slideline_mech::rigid::push_forward;

/// The most kernel variables of a point in the plane: itself and what a curve through nodes follows.
const MOST_VARIABLES: usize = 2 + 2 * CONTROLS;

impl Contact {
    /// Tangent of the geometry of a point, normal * D dh + tangential *
    /// D direction, with `normal` and `tangential` forces [F]; row-major, as wide
    /// as its rows. The point faces what it faced when it was met, with masters at `positions`. Of a
    /// point that is spread over faces in space it is what turns with the point alone
    /// ([`Contact::tangents_of_faces`]).
    pub fn geometric_tangent(
        &self,
        place: usize,
        (u, positions, before): (&[f64], &MasterPositions, &PointState),
        kinematics: &PointRows<'_>,
        (normal, tangential): (f64, Tangential),
        scratch: &mut GeometryScratch,
    ) {
        let point = &self.points[place];
        if let Some(Facing::Face(facing)) = kinematics.facing {
            let (facing, forces) = ((point.pair, facing), (normal, tangential));
            self.tangent_of_face(facing, (kinematics, before, positions), forces, scratch);
            return;
        }
        if let Some(Facing::Edges(edges)) = kinematics.facing {
            let forces = (normal, tangential);
            self.tangent_of_crossing((point.pair, edges), u, kinematics, forces, scratch);
            return;
        }
        if let Some(own) = point.mortar {
            let m = kinematics.rows.width();
            scratch.tangent.clear();
            scratch.tangent.resize(m * m, 0.0);
            let forces = (normal, tangential);
            if let MasterSurface::Faces { .. } = &self.masters[point.pair] {
                let rooms = &kinematics.face_mortars[own];
                self.tangent_of_face_mortar((own, place), rooms, kinematics, forces, scratch);
                return;
            }
            let rooms = &kinematics.mortars[own];
            self.tangent_of_mortar((own, place), (u, rooms), kinematics, forces, scratch);
            return;
        }
        let mut stencil = self.slave(point, kinematics.xi, u);
        let m = kinematics.rows.width();
        let GeometryScratch { tangent, direct, force, .. } = scratch;
        tangent.clear();
        tangent.resize(m * m, 0.0);
        let Some(facing) = &kinematics.facing else { return };
        let slave = self.attachment(point, kinematics.xi);
        let master = &self.masters[point.pair];
        let Some(gap) = master.gap::<Quadratic>(facing, slave, (u, &positions.nodes), &mut stencil)
        else {
            return;
        };
        let (from, n) = (gap.derivatives(), gap.width());
        let mut gradient = [0.0; MOST_VARIABLES];
        let mut hessian = [0.0; MOST_VARIABLES * MOST_VARIABLES];
        combine(&mut gradient[..n], normal, (from.gradient, from.direction), tangential);
        let [second, of_direction] = gap.second_derivatives();
        combine(&mut hessian[..n * n], normal, (second, of_direction), tangential);
        let width = stencil.width();
        force.clear();
        force.resize(width, 0.0);
        direct.clear();
        direct.resize(if stencil.shear.is_some() { width * width } else { 0 }, 0.0);
        let room = match stencil.shear {
            Some(_) => &mut *direct,
            None => &mut *tangent,
        };
        let (attachments, values) = (stencil.attachments(), stencil.values());
        push_forward(attachments, values, &gradient[..n], &hessian[..n * n], force, room);
        if let Some(shear) = stencil.shear {
            let dofs = kinematics.rows.unknowns;
            shear.push_tangent((dofs, u), force, (direct, width), tangent);
        }
    }
}

/// normal * of.0 + tangential . of.1, the latter direction after direction.
fn combine(
    into: &mut [f64],
    normal: f64,
    (along_normal, along_tangents): (&[f64], &[f64]),
    tangential: Tangential,
) {
    for (into, h) in into.iter_mut().zip(along_normal) {
        *into = normal * h;
    }
    for (of, force) in along_tangents.chunks_exact(along_normal.len()).zip(tangential.0) {
        into.iter_mut().zip(of).for_each(|(into, s)| *into += force * s);
    }
}
