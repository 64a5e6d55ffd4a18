//! The normal at a node of a surface: the mean of the faces that meet there.
//!
//! ```text
//!        o-----o-----o
//!        |     |     |      S = sum of (next - own) x (previous - own) over the faces
//!        o-----*-----o      N = S / |S|
//!        |     |     |
//!        o-----o-----o
//! ```
//!
//! [docs/theory.md, section 5.9]

use super::mirror::across;
use crate::vector::{Vector, add, cross, dot, scale, size, sub};

/// A corner of a face at the node: places of the next and of the previous corner in a list.
pub type Corner = [usize; 2];

/// A node, and the corners that meet there.
#[derive(Debug, Clone, Copy)]
pub struct Star<'a> {
    /// Place of the node in a list of positions.
    pub node: usize,
    /// The corners.
    pub corners: &'a [Corner],
    /// Unit vectors across one another and across the planes of symmetry that the node lies in: there the faces
    /// cancel with their images [1].
    pub across: &'a [Vector],
}

/// Its normal in a configuration.
#[derive(Debug, Clone, Copy)]
pub struct StarNormal {
    /// The unit normal [1].
    pub normal: Vector,
    size: f64,
}

impl Star<'_> {
    fn edges(&self, positions: &[Vector], corner: &Corner) -> [Vector; 2] {
        corner.map(|other| sub(positions[other], positions[self.node]))
    }

    /// The normal at positions [L]; `None` where the faces cancel.
    pub fn normal(&self, positions: &[Vector]) -> Option<StarNormal> {
        let (mut sum, mut whole) = ([0.0; 3], 0.0);
        for corner in self.corners {
            let [next, previous] = self.edges(positions, corner);
            sum = add(sum, cross(next, previous));
            whole += size(next) * size(previous);
        }
        let sum = across(sum, self.across);
        let size = size(sum);
        (size > f64::EPSILON * whole).then(|| StarNormal { normal: scale(sum, 1.0 / size), size })
    }

    /// Adds y . dN by the positions, `factor` times.
    pub fn pull(
        &self,
        positions: &[Vector],
        (own, y): (&StarNormal, Vector),
        mut add_at: impl FnMut(usize, Vector),
    ) {
        let aside = sub(y, scale(own.normal, dot(y, own.normal)));
        let w = across(scale(aside, 1.0 / own.size), self.across);
        for corner in self.corners {
            let [next, previous] = self.edges(positions, corner);
            let (by_next, by_previous) = (cross(previous, w), cross(w, next));
            add_at(corner[0], by_next);
            add_at(corner[1], by_previous);
            add_at(self.node, scale(add(by_next, by_previous), -1.0));
        }
    }

    /// Adds the second derivative of y . N by the positions: `add_at(i, j, block)`.
    /// [docs/theory.md, eq. (5.18)]
    pub fn pull_twice(
        &self,
        positions: &[Vector],
        (own, y): (&StarNormal, Vector),
        mut add_at: impl FnMut(usize, usize, [Vector; 3]),
    ) {
        let n = own.normal;
        let along = dot(y, n);
        let aside = across(sub(y, scale(n, along)), self.across);
        let w = scale(aside, 1.0 / own.size);
        // of y . S / |S| by S
        let by_sum: [Vector; 3] = std::array::from_fn(|i| {
            let unit = std::array::from_fn(|j| f64::from(i == j));
            let plane = sub(across(unit, self.across), scale(n, n[i]));
            std::array::from_fn(|j| {
                -(n[i] * aside[j] + aside[i] * n[j] + along * plane[j]) / own.size.powi(2)
            })
        });
        // dS = sum over the corners of [next] dprevious - [previous] dnext
        let follows = |corner: &Corner| {
            let [next, previous] = self.edges(positions, corner);
            let (by_next, by_previous) = (spin(scale(previous, -1.0)), spin(next));
            let by_own = std::array::from_fn(|i| scale(add(by_next[i], by_previous[i]), -1.0));
            [(corner[0], by_next), (corner[1], by_previous), (self.node, by_own)]
        };
        for first in self.corners {
            for (i, left) in follows(first) {
                let half = product(&transposed(&left), &by_sum);
                for second in self.corners {
                    for (j, right) in follows(second) {
                        add_at(i, j, product(&half, &right));
                    }
                }
            }
            // w . (dnext x dprevious), twice
            let twist = spin(scale(w, -1.0));
            let back = transposed(&twist);
            let minus = |block: &[Vector; 3]| block.map(|row| scale(row, -1.0));
            let ([next, previous], own) = (*first, self.node);
            add_at(next, previous, twist);
            add_at(previous, next, back);
            add_at(next, own, minus(&twist));
            add_at(own, next, minus(&back));
            add_at(own, previous, minus(&twist));
            add_at(previous, own, minus(&back));
        }
    }
}

/// The matrix of a x.
fn spin(a: Vector) -> [Vector; 3] {
    [[0.0, -a[2], a[1]], [a[2], 0.0, -a[0]], [-a[1], a[0], 0.0]]
}

fn transposed(a: &[Vector; 3]) -> [Vector; 3] {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

fn product(a: &[Vector; 3], b: &[Vector; 3]) -> [Vector; 3] {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j])
    })
}
