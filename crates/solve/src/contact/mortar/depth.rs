//! How deep slave faces in the plane lie in the master beyond what their mean gaps show.
//!
//! docs/theory.md section 5.11

use super::place::MortarRoom;
use super::slave::Mortar;

impl MortarRoom {
    /// The slave face that lies deepest in the master beyond its mean: by how much, in lengths of the
    /// face [1], and one of its points. Faces none of whose points faces the master do not meet it.
    pub fn unseen(&self, mortar: &Mortar, faces: impl Fn(usize) -> bool) -> Option<(f64, usize)> {
        let meets = |place: usize| {
            let own = &mortar.faces[place];
            own.points[..own.count].iter().any(|&point| faces(point))
        };
        let covered = self.faces.iter().enumerate();
        let covered = covered.filter(|&(place, state)| state.is_covered && meets(place));
        let all = covered.filter_map(|(place, state)| {
            let face = state.face(mortar, place);
            let depth = state.integrals.unseen_depth(&face, &state.segments)?;
            Some((depth / face.length(), mortar.faces[place].points[0]))
        });
        all.filter(|own| own.0 > 0.0).max_by(|a, b| a.0.total_cmp(&b.0))
    }
}
