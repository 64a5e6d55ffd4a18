//! How deep slave faces lie in the master beyond what their mean gaps show.
//!
//! ```text
//!   slave     \    /         contact takes the mean gap over a face: it is open here, although
//!   master  ---\--/---       the edge between the faces lies in the master
//!               `'
//! ```
//!
//! docs/theory.md section 5.11

use super::place::{FaceRoom, FaceState};
use super::slave::{FaceMortar, SlaveFace};
use slideline_mech::contact::pair::mortar_faces::corners;

impl FaceRoom {
    /// The slave face that lies deepest in the master beyond its mean: by how much, in sizes of the face
    /// [1], and one of its points.
    pub fn unseen(&self, mortar: &FaceMortar) -> Option<(f64, usize)> {
        let faces = mortar.faces.iter().zip(&self.faces);
        let all = faces.filter_map(|(own, state)| Some((state.depth_unseen(own)?, own.points[0])));
        all.filter(|own| own.0 > 0.0).max_by(|a, b| a.0.total_cmp(&b.0))
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
        let of_this_side = self.overlaps.iter().filter(|over| !over.went_in_elsewhere);
        let gaps = of_this_side.filter_map(|over| self.couple(own, over).least_gap(over));
        let least = gaps.reduce(f64::min)?;
        Some((mean.min(0.0) - least) / sum(&self.places.corner_areas(&own.measure)).sqrt())
    }
}
