//! How deep slave faces lie in the master beyond what their mean gaps show.
//!
//! ```text
//!   slave     \    /         contact takes the mean gap over a face: it is open here, although
//!   master  ---\--/---       the edge between the faces lies in the master
//!               `'
//! ```
//!
//! docs/theory.md eq. (5.33b)

use super::super::kinematics::ContactKinematics;
use super::super::master::MasterSurface;
use super::super::pairs::Contact;
use super::place::{FaceRoom, FaceState};
use super::slave::{FaceMortar, SlaveFace};
use slideline_mech::contact::pair::mortar_faces::corners;
use slideline_model::NodeIndex;

/// A slave face that lies in the master.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unseen {
    /// Place of its pair in the model.
    pub pair: usize,
    /// How deep beyond its mean overclosure, in sizes of the face [1].
    pub depth: f64,
    /// A node of it.
    pub node: NodeIndex,
}

impl Contact {
    /// Of every pair that is spread over faces in space, the slave face that lies deepest in the master
    /// beyond its mean.
    pub fn unseen<'a>(
        &'a self,
        kinematics: &'a ContactKinematics,
    ) -> impl Iterator<Item = Unseen> + 'a {
        let mortars = self.face_mortars.iter().zip(&kinematics.face_mortars);
        let is_there = |pair: usize| !matches!(self.masters[pair], MasterSurface::Nothing);
        mortars
            .filter(move |(mortar, _)| is_there(mortar.pair))
            .filter_map(|(mortar, rooms)| rooms.now.unseen(mortar))
    }
}

impl FaceRoom {
    fn unseen(&self, mortar: &FaceMortar) -> Option<Unseen> {
        let faces = mortar.faces.iter().zip(&self.faces);
        let all = faces.filter_map(|(own, state)| {
            let node = mortar.nodes[own.nodes[0]];
            Some(Unseen { pair: mortar.pair, depth: state.depth_unseen(own)?, node })
        });
        all.filter(|own| own.depth > 0.0).max_by(|a, b| a.depth.total_cmp(&b.depth))
    }
}

impl FaceState {
    /// How deep a place of the face lies in the master beyond its mean overclosure, by the size of the
    /// face [1].
    fn depth_unseen(&self, own: &SlaveFace) -> Option<f64> {
        let sum = |of: &[f64]| of[..corners(own.count)].iter().sum::<f64>();
        let area = sum(&self.sums.areas);
        if area <= 0.0 {
            return None;
        }
        let mean = sum(&self.sums.gaps) / area;
        let gaps = self.overlaps.iter().filter_map(|over| self.couple(own, over).least_gap(over));
        let least = gaps.reduce(f64::min)?;
        Some((mean.min(0.0) - least) / sum(&self.places.corner_areas(&own.measure)).sqrt())
    }
}
