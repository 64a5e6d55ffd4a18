//! How far slave points slid on what they face.

use super::kinematics::PointKinematics;
use super::pairs::Contact;
use super::positions::MasterPositions;
use crate::state::PointState;
use slideline_mech::contact::pair::History;
use slideline_mech::contact::tangential::Tangential;

impl Contact {
    /// Change of the slip coordinates of a point since its commit [L]; zero
    /// where it faced nothing then or faces nothing now. An integration point compares
    /// the same material place in both configurations.
    pub fn slip(
        &self,
        place: usize,
        history: &History,
        kinematics: &PointKinematics,
        committed: &[f64],
    ) -> Tangential {
        let point = &self.points[place];
        if !kinematics.faces {
            return Tangential::ZERO;
        }
        if point.mortar.is_some() {
            // what slides in from beyond an end has slid
            return kinematics.along - history.along.unwrap_or(Tangential::ZERO);
        }
        if !point.is_integration_point() {
            return self.change(point, history, kinematics.along);
        }
        let mut stencil = self.slave(point, kinematics.xi, committed);
        let before =
            self.face(point, kinematics.xi, committed, &MasterPositions::default(), &mut stencil);
        let along = before.map(|(gap, _)| stencil.along(&gap, committed));
        self.change(point, &History { along, ..*history }, kinematics.along)
    }

    /// Change of the slip coordinates of a point that opened, between its
    /// committed state `old` and `new`, at displacements `from` and `to` [L];
    /// an integration point where it stood on its element before. Zero where it faces
    /// nothing in one of them.
    pub fn opening_slip(
        &self,
        place: usize,
        (old, new): (&PointState, &PointState),
        (from, to): (&[f64], &[f64]),
    ) -> Tangential {
        let point = &self.points[place];
        let (history, along) = if point.is_integration_point() {
            let none = MasterPositions::default();
            let along = |u: &[f64]| {
                let mut stencil = self.slave(point, old.xi, u);
                let gap = self.face(point, old.xi, u, &none, &mut stencil);
                gap.map(|(gap, _)| stencil.along(&gap, u))
            };
            (History { along: along(from), ..History::default() }, along(to))
        } else {
            (old.history(), new.along)
        };
        let slip = |along| self.change(point, &history, along);
        along.map_or(Tangential::ZERO, slip)
    }
}
