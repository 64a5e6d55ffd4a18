//! How far a face has turned at a place, by the displacements of its nodes.
//!
//! ```text
//!        o  what hangs at a face by an arm d:   u + w x d
//!      d |
//!   o----x-------o   w from the slopes of the displacements of the face
//! ```
//! docs/theory.md section 4.11.

use crate::pressure::{Face, MOST_NODES, tangents};
use crate::vector::{cross, dot};

/// What displacements of the nodes make of the turn of a face: a matrix for each [1/L].
pub type Turn = [[[f64; 3]; 3]; MOST_NODES];

/// The turn of a face with nodes at `x` [L], at the place nearest to a point, w = sum B_i u_i: exact of
/// rigid motions. `None` where the face has no normal there.
pub fn turn(face: &Face, x: &[[f64; 3]], point: [f64; 3]) -> Option<Turn> {
    let at = face.at(face.nearest_place(x, point));
    let [a, b] = tangents(&at, x);
    let (across, half) = match face {
        Face::Area(..) => (b, 0.5),
        // the plane itself, which stays
        Face::Edge { .. } | Face::Ring { .. } => ([0.0, 0.0, 1.0], 0.0),
    };
    let area = cross(a, across);
    let square = dot(area, area);
    if !(square > 0.0 && square.is_finite()) {
        return None;
    }
    let normal = area.map(|own| own / square.sqrt());
    // along the face, and at right angles to one another's tangents
    let by = [cross(across, area), cross(area, a)].map(|own| own.map(|own| own / square));
    let mut turn: Turn = Default::default();
    for (own, slope) in turn.iter_mut().zip(at.slopes).take(x.len()) {
        let gradient = std::array::from_fn(|k| slope[0] * by[0][k] + slope[1] * by[1][k]);
        let about = cross(normal, gradient);
        *own = std::array::from_fn(|row| {
            std::array::from_fn(|axis| half * normal[row] * about[axis] - about[row] * normal[axis])
        });
    }
    Some(turn)
}

/// What displacements of a node make of the way of an arm, w x d, by its part of the turn [1].
pub fn swing(turn: &[[f64; 3]; 3], arm: [f64; 3]) -> [[f64; 3]; 3] {
    let mut swing = [[0.0; 3]; 3];
    for axis in 0..3 {
        let way = cross([turn[0][axis], turn[1][axis], turn[2][axis]], arm);
        way.into_iter().enumerate().for_each(|(row, way)| swing[row][axis] = way);
    }
    swing
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: of a rigid motion the turn is its own, and an arm goes along, whatever the face.
    #[test]
    fn a_rigid_motion_takes_arms_along() {
        let (move_, turned) = ([0.3, -0.2, 0.7], [0.11, -0.23, 0.31]);
        let quad = vec![[0.1, 0.0, 0.2], [1.2, 0.1, 0.0], [1.0, 0.9, 0.4], [-0.1, 1.1, 0.1]];
        let tri = vec![[0.0, 0.0, 0.0], [0.9, 0.2, 0.1], [0.1, 1.1, -0.3]];
        let edge = vec![[0.0, 0.1, 0.0], [1.0, 0.4, 0.0], [0.45, 0.3, 0.0]];
        for (dimension, x) in [(3, quad), (3, tri), (2, edge)] {
            let face = Face::of(dimension, x.len(), 1.0).expect("a face");
            let spin = if dimension == 3 { turned } else { [0.0, 0.0, turned[2]] };
            let moves = |x: [f64; 3]| {
                let way = cross(spin, x);
                [0, 1, 2].map(|k| move_[k] + way[k])
            };
            let (point, arm) = ([0.4, 0.6, 0.2], [0.2, -0.5, 0.3]);
            let turn = turn(&face, &x, point).expect("a normal");
            let (mut found, mut swung) = ([0.0; 3], [0.0; 3]);
            for (x, own) in x.iter().zip(turn) {
                let u = moves(*x);
                let way = swing(&own, arm);
                for k in 0..3 {
                    found[k] += dot(own[k], u);
                    swung[k] += dot(way[k], u);
                }
            }
            let expected = cross(spin, arm);
            for k in 0..3 {
                assert!((found[k] - spin[k]).abs() < 1e-12, "{dimension}: {found:?}");
                assert!((swung[k] - expected[k]).abs() < 1e-12, "{dimension}: {swung:?}");
            }
        }
    }
}
