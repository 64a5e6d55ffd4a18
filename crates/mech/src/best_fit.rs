//! The rotation that fits a cloud of nodes best, for turns of any size.
//!
//! ```text
//!      o   o               o
//!        +      -->      +    o      d = R b + what no rotation does
//!      o   o            o   o
//!    b from the centre, d from it now: sum w |d - R b|^2 least where sum w (R b) x d = 0
//! ```
//!
//! With S = sum w b d' the condition is that R S is symmetric; docs/theory.md section 4.2.

use crate::differentiate::Second;
use crate::rotation::{self, Quaternion};
use crate::vector::{Vector, cross, dot, scale, size};
use std::f64::consts::TAU;

/// Three rows.
pub type Matrix = [[f64; 3]; 3];

/// A rotation with its derivatives by its rotation vector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotation {
    /// R - 1: how far the ends of unit vectors move, without a difference of near numbers.
    pub moved: Matrix,
    /// First derivatives.
    pub slopes: [Matrix; 3],
    /// Second derivatives.
    pub bends: [[Matrix; 3]; 3],
}

impl Rotation {
    /// That of a rotation vector.
    pub fn of(vector: Vector) -> Self {
        let variables = Second::variables(&vector);
        let columns = UNIT.map(|axis| rotation::displacement(&variables, axis));
        let matrix = |of: &dyn Fn(&Second<3>) -> f64| -> Matrix {
            std::array::from_fn(|row| std::array::from_fn(|column| of(&columns[column][row])))
        };
        let slope = |a: usize| matrix(&|entry| entry.gradient[a]);
        let bend = |a: usize, b: usize| matrix(&|entry| entry.hessian[a][b]);
        Self {
            moved: matrix(&|entry| entry.value),
            slopes: [0, 1, 2].map(slope),
            bends: [0, 1, 2].map(|a| [0, 1, 2].map(|b| bend(a, b))),
        }
    }
}

/// R - 1 of a rotation vector, without derivatives.
pub(crate) fn moved_by(vector: Vector) -> Matrix {
    let columns = UNIT.map(|axis| rotation::displacement(&vector, axis));
    std::array::from_fn(|row| [0, 1, 2].map(|column: usize| columns[column][row]))
}

/// R of R - 1.
pub(crate) fn whole(moved: &Matrix) -> Matrix {
    let mut whole = *moved;
    (0..3).for_each(|k| whole[k][k] += 1.0);
    whole
}

/// The unit vectors.
pub(crate) const UNIT: Matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// A matrix times a vector.
pub fn times(matrix: &Matrix, vector: Vector) -> Vector {
    matrix.map(|row| dot(row, vector))
}

/// A matrix times a matrix.
pub fn product(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

/// The vector of what of a matrix is not symmetric: of a d' it is a x d.
pub fn axial(of: &Matrix) -> Vector {
    [of[1][2] - of[2][1], of[2][0] - of[0][2], of[0][1] - of[1][0]]
}

/// Moments of a cloud [L2].
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Moments {
    /// S = sum w b d'.
    pub now: Matrix,
    /// sum w b v', v = d - b: what of S no small turn hides behind.
    pub moved: Matrix,
}

impl Moments {
    /// Takes in a node: its weight, its arm [L] and how the end of this has moved against the centre [L].
    pub fn add(&mut self, weight: f64, arm: Vector, moved: Vector) {
        for i in 0..3 {
            for j in 0..3 {
                self.now[i][j] += weight * arm[i] * (arm[j] + moved[j]);
                self.moved[i][j] += weight * arm[i] * moved[j];
            }
        }
    }

    /// sum w (R b) x d of R - 1, which is zero at the rotation that fits best [L2].
    fn misfit(&self, moved: &Matrix) -> Vector {
        let [a, b] = [axial(&self.moved), axial(&product(moved, &self.now))];
        std::array::from_fn(|k| a[k] + b[k])
    }

    /// The rotation vector that fits best, of all that mean the same rotation the nearest to one; about the third
    /// axis in the plane. `None` where the cloud says none.
    pub fn fit(&self, near: Vector, in_space: bool) -> Option<Vector> {
        let mut found = if in_space { self.fit_in_space() } else { self.fit_in_plane() };
        for _ in 0..REFINED {
            let moved = moved_by(found);
            let turned = product(&whole(&moved), &self.now);
            let turn = turn_to_fit(&turned, self.misfit(&moved), in_space);
            found = composed(turn, found);
        }
        let found = nearest(found, near);
        found.iter().all(|part| part.is_finite()).then_some(found)
    }

    fn fit_in_plane(&self) -> Vector {
        let s = &self.now;
        [0.0, 0.0, (s[0][1] - s[1][0]).atan2(s[0][0] + s[1][1])]
    }

    /// Horn's quaternion: what belongs to the largest eigenvalue, by squaring.
    fn fit_in_space(&self) -> Vector {
        let ([[a, b, c], [d, e, f], [g, h, i]], shift) = (self.now, squares(&self.now));
        let mut power = [
            [a + e + i, f - h, g - c, b - d],
            [f - h, a - e - i, b + d, g + c],
            [g - c, b + d, e - a - i, f + h],
            [b - d, g + c, f + h, i - a - e],
        ];
        // the eigenvalues are not below minus twice the root of the sum of squares
        (0..4).for_each(|k| power[k][k] += 2.0 * shift.sqrt());
        for _ in 0..SQUARINGS {
            let largest = power.iter().flatten().fold(0.0_f64, |most, own| most.max(own.abs()));
            power.iter_mut().flatten().for_each(|own| *own /= largest);
            power = std::array::from_fn(|i| {
                std::array::from_fn(|j| (0..4).map(|k| power[i][k] * power[k][j]).sum())
            });
        }
        let place = (0..4).max_by(|&i, &j| power[i][i].total_cmp(&power[j][j])).unwrap_or(0);
        let whole = power[place].iter().map(|part| part * part).sum::<f64>().sqrt();
        let quaternion: Quaternion = power[place].map(|part| part / whole);
        rotation::vector(&quaternion)
    }
}

/// Squarings after which of a vector nothing but that of the largest eigenvalue is left.
const SQUARINGS: usize = 40;
/// Steps of Newton's method from a rotation that is known but for rounding.
const REFINED: usize = 2;

fn squares(of: &Matrix) -> f64 {
    of.iter().flatten().map(|entry| entry * entry).sum()
}

/// (tr M - M)^-1 h, M = R S: the turn that takes the misfit away.
fn turn_to_fit(whole: &Matrix, misfit: Vector, in_space: bool) -> Vector {
    let trace = whole[0][0] + whole[1][1] + whole[2][2];
    if !in_space {
        return [0.0, 0.0, misfit[2] / trace];
    }
    let [a, b, c]: Matrix = std::array::from_fn(|i| {
        std::array::from_fn(|j| if i == j { trace } else { 0.0 } - whole[i][j])
    });
    let columns = [cross(b, c), cross(c, a), cross(a, b)];
    let determinant = dot(a, columns[0]);
    std::array::from_fn(|i| (0..3).map(|k| columns[k][i] * misfit[k]).sum::<f64>() / determinant)
}

/// The rotation vector of one turn after another.
pub(crate) fn composed(turn: Vector, after: Vector) -> Vector {
    if turn == [0.0; 3] {
        return after;
    }
    let [turn, after] = [turn, after].map(|vector| rotation::quaternion(&vector));
    rotation::vector(&rotation::after(&turn, &after))
}

/// The nearest to a vector of those that are whole turns longer.
fn nearest(vector: Vector, near: Vector) -> Vector {
    let length = size(vector);
    let along =
        if length > 0.0 { scale(vector, 1.0 / length) } else { scale(near, 1.0 / size(near)) };
    let whole = ((dot(near, along) - length) / TAU).round();
    if whole == 0.0 || whole.is_nan() {
        return vector;
    }
    scale(along, length + TAU * whole)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn place(k: usize) -> Vector {
        std::array::from_fn(|axis| (1.7 * k as f64 + 2.3 * axis as f64 + 0.4).sin())
    }

    /// Moments of nodes that turn and are moved a little, from their centre.
    fn moments(count: usize, vector: Vector, part: f64, in_space: bool) -> Moments {
        let flat = |[x, y, z]: Vector| [x, y, if in_space { z } else { 0.0 }];
        let arms = centred((0..count).map(|k| flat(place(k))).collect());
        let off = centred((0..count).map(|k| flat(scale(place(3 * k + 1), part))).collect());
        let mut sum = Moments::default();
        for (arm, off) in arms.iter().zip(&off) {
            let turned = rotation::displacement(&vector, *arm);
            sum.add(1.0, *arm, std::array::from_fn(|k| turned[k] + off[k]));
        }
        sum
    }

    fn centred(mut places: Vec<Vector>) -> Vec<Vector> {
        let share = 1.0 / places.len() as f64;
        let mean: Vector = std::array::from_fn(|k| places.iter().map(|own| share * own[k]).sum());
        places.iter_mut().for_each(|own| (0..3).for_each(|k| own[k] -= mean[k]));
        places
    }

    /// Requirement: a rigid turn is found as it is, of any size, also beyond whole turns; 1e-14 of it, and of a
    /// hundredth at least.
    #[test]
    fn rigid_turns_are_found() {
        for angle in [1e-9, 0.4, 1.6, 3.1, 3.2, 6.0, 9.5, -9.5] {
            for axis in [[0.0, 0.0, 1.0], [0.48, -0.6, 0.64]] {
                let in_space = axis[0] != 0.0;
                let vector = scale(axis, angle);
                let near = scale(vector, 0.97);
                let found = moments(6, vector, 0.0, in_space).fit(near, in_space).unwrap();
                let off = size(std::array::from_fn(|k| found[k] - vector[k]));
                assert!(off < 1e-14 * angle.abs().max(1e-2), "{angle} {off:e}");
            }
        }
    }

    /// Requirement: the misfit vanishes, and no rotation beside it fits better.
    #[test]
    fn none_fits_better() {
        for in_space in [false, true] {
            let vector = if in_space { [1.0, -2.0, 0.7] } else { [0.0, 0.0, 2.4] };
            let own = moments(7, vector, 0.3, in_space);
            let found = own.fit(vector, in_space).unwrap();
            let fits = |vector: Vector| {
                let whole = product(&super::whole(&moved_by(vector)), &own.now);
                whole[0][0] + whole[1][1] + whole[2][2]
            };
            assert!(size(own.misfit(&moved_by(found))) < 1e-14);
            for k in 0..3 {
                for step in [-0.3, -1e-3, 1e-3, 0.3, 1.5] {
                    let mut beside = [0.0; 3];
                    beside[k] = step;
                    assert!(fits(composed(beside, found)) < fits(found), "{k} {step}");
                }
            }
        }
    }

    /// Requirement: derivatives of the rotation are those of differences; 1e-8.
    #[test]
    fn rotations_by_differences() {
        let (vector, h) = ([0.7, -1.1, 2.0], 1e-5);
        let at = Rotation::of(vector);
        for a in 0..3 {
            let [up, down] = [h, -h].map(|step| {
                let mut moved = vector;
                moved[a] += step;
                Rotation::of(moved)
            });
            for i in 0..3 {
                for j in 0..3 {
                    let slope = (up.moved[i][j] - down.moved[i][j]) / (2.0 * h);
                    assert!((slope - at.slopes[a][i][j]).abs() < 1e-8);
                    for b in 0..3 {
                        let bend = (up.slopes[b][i][j] - down.slopes[b][i][j]) / (2.0 * h);
                        assert!((bend - at.bends[a][b][i][j]).abs() < 1e-8);
                    }
                }
            }
        }
    }
}
