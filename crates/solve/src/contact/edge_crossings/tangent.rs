//! How the rows of a crossing turn with its edges.

use crate::contact::kinematics::{GeometryScratch, PointRows};
use crate::contact::pairs::Contact;
use slideline_mech::contact::gap::edges::{EdgeGap, VARIABLES};
use slideline_mech::contact::tangential::Tangential;

impl Contact {
    /// The tangent of the geometry of a crossing, as [`Contact::geometric_tangent`]. docs/theory.md eq. (5.52)
    pub(crate) fn tangent_of_crossing(
        &self,
        (pair, edges): (usize, [usize; 2]),
        u: &[f64],
        kinematics: &PointRows<'_>,
        (normal, tangential): (f64, Tangential),
        scratch: &mut GeometryScratch,
    ) {
        let m = kinematics.rows.width();
        let tangent = &mut scratch.tangent;
        tangent.clear();
        tangent.resize(m * m, 0.0);
        let Some(own) = self.crossings_of(pair) else { return };
        let Some(gap) = EdgeGap::new(own.ends(edges, u), kinematics.normal) else { return };
        let mut own = [0.0; VARIABLES * VARIABLES];
        gap.derivative(normal, tangential.0, &mut own);
        for (row, from) in tangent.chunks_exact_mut(m).zip(own.chunks_exact(VARIABLES)) {
            row[..VARIABLES].copy_from_slice(from);
        }
    }
}
