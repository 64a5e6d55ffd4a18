//! Where the points of a committed state stand, as the next evaluation finds them.

use super::scratch::Scratch;
use crate::state::State;

/// The places of a committed state as the evaluation that led to it left
/// them, so that points without a master keep what was last said of them.
pub fn recall_points(committed: &State, work: &mut Scratch) {
    let kinematics = work.evaluation.kinematics.points_mut();
    for (point, kinematics) in committed.points.iter().zip(kinematics) {
        kinematics.position = point.position;
        kinematics.normal = point.normal;
        kinematics.area = point.area;
        kinematics.xi = point.xi;
    }
}
