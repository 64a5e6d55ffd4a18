//! The frame in which nodes have not turned, where what they make of a turn is known for small ones.
//!
//! ```text
//!      o----o             o
//!      |    |   -->      / \o      w = sum B (R' d) = 0: seen from the frame R
//!      o----o           o\ /       nothing is left of the turn
//!                         o
//! ```
//!
//! d are the arms of the nodes now, B what a displacement makes of a small turn; docs/theory.md sections 4.2 and 4.11.

use crate::best_fit::{Matrix, UNIT, composed, moved_by, times, whole};
use crate::vector::{Vector, cross, dot, scale, size};

/// Sums over nodes of which a frame can be told.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct FrameTurn {
    /// sum d b', a matrix for each row b of B.
    now: [Matrix; 3],
    /// sum b . v, v how d has moved: what of it no small turn hides behind.
    moved: Vector,
}

/// Steps of Newton's method at most.
const MOST: usize = 30;
/// Angle within which the frame is found [1].
const FOUND: f64 = 1e-9;

impl FrameTurn {
    /// Takes in a node: its part B of a small turn, its arm [L] and how the end of this has moved [L].
    pub fn add(&mut self, turns: &Matrix, arm: Vector, moved: Vector) {
        for (row, turn) in turns.iter().enumerate() {
            for (into, k) in self.now[row].iter_mut().zip(0..3) {
                *into = std::array::from_fn(|j| into[j] + (arm[k] + moved[k]) * turn[j]);
            }
            self.moved[row] += dot(*turn, moved);
        }
    }

    /// What is left of the turn in a frame R, by R - 1.
    pub fn value(&self, moved: &Matrix) -> Vector {
        let by = self.change(moved);
        std::array::from_fn(|row| self.moved[row] + by[row])
    }

    /// How much that changes where the frame changes by a matrix.
    pub fn change(&self, by: &Matrix) -> Vector {
        self.now.map(|own| own.iter().zip(by).map(|(own, by)| dot(*own, *by)).sum())
    }

    /// The rotation vector of the frame, from one that is near; about the third axis in the plane. `None` where
    /// there is none.
    pub fn refined(&self, near: Vector, in_space: bool) -> Option<Vector> {
        let (mut found, mut before) = (near, f64::INFINITY);
        for _ in 0..MOST {
            let turn = self.turn_left(&moved_by(found), in_space);
            let largest = size(turn);
            if !largest.is_finite() {
                return None;
            }
            found = composed(turn, found);
            if largest <= f64::EPSILON || largest < FOUND && largest >= 0.5 * before {
                return Some(found);
            }
            before = largest;
        }
        (before < FOUND).then_some(found)
    }

    /// The step of Newton's method: the turn of the frame that takes away what is left.
    fn turn_left(&self, moved: &Matrix, in_space: bool) -> Vector {
        let (whole, value) = (whole(moved), self.value(moved));
        let columns = |matrix: &Matrix| -> Matrix {
            std::array::from_fn(|i| std::array::from_fn(|j| matrix[j][i]))
        };
        let turned = |axis: Vector| columns(&columns(&whole).map(|column| cross(axis, column)));
        let [a, b, c] = UNIT.map(|axis| self.change(&turned(axis)));
        if !in_space {
            return [0.0, 0.0, -value[2] / c[2]];
        }
        let rows: Matrix = [cross(b, c), cross(c, a), cross(a, b)];
        scale(times(&rows, value), -1.0 / dot(a, rows[0]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::face_turn::turn;
    use crate::pressure::Face;
    use crate::rotation;

    /// Requirement: the frame of a face that turns rigidly is its turn, however far; 1e-13.
    #[test]
    fn rigid_turns_are_those_of_the_frame() {
        let x = vec![[0.1, 0.0, 0.2], [1.2, 0.1, 0.0], [1.0, 0.9, 0.4], [-0.1, 1.1, 0.1]];
        let own = turn(&Face::of(3, 4, 1.0).expect("a face"), &x, [0.4, 0.6, 0.2]).expect("turns");
        for angle in [1e-9, 0.7, 2.0, 3.0] {
            let vector = scale([0.48, -0.6, 0.64], angle);
            let mut frame = FrameTurn::default();
            for (at, turns) in x.iter().zip(&own) {
                frame.add(turns, *at, rotation::displacement(&vector, *at));
            }
            let near = scale(vector, 0.8);
            let found = frame.refined(near, true).expect("a frame");
            let off = size(std::array::from_fn(|k| found[k] - vector[k]));
            assert!(off < 1e-13, "{angle} {off:e}");
        }
    }

    /// Requirement: a face without a size has no frame.
    #[test]
    fn no_face_has_no_frame() {
        assert_eq!(FrameTurn::default().refined([0.0; 3], true), None);
        assert_eq!(FrameTurn::default().refined([0.0; 3], false), None);
    }
}
