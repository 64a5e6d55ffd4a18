//! How deep slave faces in the plane lie in the master beyond what their mean gaps show.
//!
//! docs/theory.md section 5.11

use super::place::MortarRoom;
use super::slave::Mortar;

impl MortarRoom {
    /// The slave face that lies deepest in the master beyond its mean: by how much, in lengths of the
    /// face [1], and one of its points.
    pub fn unseen(&self, mortar: &Mortar) -> Option<(f64, usize)> {
        let covered = self.faces.iter().enumerate().filter(|(_, state)| state.is_covered);
        let all = covered.filter_map(|(place, state)| {
            let face = state.face(mortar, place);
            let depth = state.integrals.unseen_depth(&face, &state.segments)?;
            Some((depth / face.length(), mortar.faces[place].points[0]))
        });
        all.filter(|own| own.0 > 0.0).max_by(|a, b| a.0.total_cmp(&b.0))
    }
}
