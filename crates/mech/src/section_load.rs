//! Force per length on a beam that turns with its sections.
//!
//! ```text
//!    n |  | n                 n,   n     at every node its share of the undeformed length,
//!    o=====o     ->         o-'-..  \    along an axis of the section as the node has turned it
//!                                 `--o
//! ```
//! docs/theory.md eqs (4.19), (4.20).

use crate::rotation;
use crate::turn::Turn;

/// The force of a unit load on a node whose rotations are `u`: `share` is the integral of its shape
/// function times the axis of the undeformed section [L].
pub fn force(share: [f64; 3], turn: &Turn, u: [f64; 3]) -> [f64; 3] {
    let (arm, _) = turn.arm(share);
    let moved = rotation::displacement(&turn.vector(u), arm);
    std::array::from_fn(|k| arm[k] + moved[k])
}

/// Its derivative by the rotations [L]: a row for each component of the force.
pub fn slopes(share: [f64; 3], turn: &Turn, u: [f64; 3]) -> [[f64; 3]; 3] {
    let (arm, _) = turn.arm(share);
    rotation::slopes(turn.vector(u), arm)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: derivatives are those of differences, and the size of the force stays, from rest
    /// and from a start beyond it.
    #[test]
    fn turns_with_the_node() {
        let share = [0.3, -0.4, 1.2];
        let begun = Turn::REST.committed([2.0, 2.5, -1.0]);
        assert_ne!(begun, Turn::REST);
        for (turn, u) in [(Turn::REST, [0.4, -0.9, 0.2]), (begun, [2.3, 2.4, -0.8])] {
            let f = force(share, &turn, u);
            let size = f.iter().map(|x| x * x).sum::<f64>();
            assert!((size - 1.69).abs() < 1e-12, "{size}");
            let exact = slopes(share, &turn, u);
            for column in 0..3 {
                let moved = |h: f64| {
                    let mut u = u;
                    u[column] += h;
                    force(share, &turn, u)
                };
                let (more, less) = (moved(1e-5), moved(-1e-5));
                for row in 0..3 {
                    let difference = (more[row] - less[row]) / 2e-5;
                    assert!((difference - exact[row][column]).abs() < 1e-9);
                }
            }
        }
    }

    /// Requirement: in the plane an axis across a beam turns by the angle of its node.
    #[test]
    fn turns_in_the_plane() {
        let quarter = std::f64::consts::FRAC_PI_2;
        let f = force([0.0, 2.0, 0.0], &Turn::REST, [0.0, 0.0, quarter]);
        assert!((f[0] + 2.0).abs() < 1e-15 && f[1].abs() < 1e-15);
    }
}
