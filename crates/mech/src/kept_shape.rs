//! Shapes that nodes keep: a line, a plane, a mean turn.
//!
//! ```text
//!   line    1 ----- k ----- 2     (r x d)_ij = r_i d_j - r_j d_i = 0
//!   plane   k in 1, 2, 3          det(d, e, r) = 0
//!   link    1 ----- 2             (d.d - D.D)/2 = 0, D the undeformed d
//!   turn    o  o                  mean of the angles about an axis = angle
//!           o  o
//!   with r = x_k - x_1, d = x_2 - x_1, e = x_3 - x_1
//! ```
//!
//! Each is a function g of the positions of its nodes that is zero; docs/theory.md eqs (4.16),
//! (4.17). Derivatives are exact.

use crate::vector::{cross, dot};
/// A place or a direction.
type Vector = [f64; 3];

/// A function of the positions of nodes that a shape keeps at zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum KeptShape {
    /// The last of three nodes stays on the line of the first two, seen along all directions but
    /// these two [L2].
    Line(usize, usize),
    /// The last of four nodes stays in the plane of the first three [L3].
    Plane,
    /// Two nodes stay as far from one another as they were [L2].
    Distance,
    /// The mean turn of the nodes about an axis of length one through their centre, less an angle
    /// [1].
    MeanTurn(Vector),
}

/// Nodes of a shape: where they began and where they are.
pub trait Nodes {
    /// How many.
    fn count(&self) -> usize;
    /// Undeformed position of a node [L].
    fn before(&self, node: usize) -> Vector;
    /// Its position now [L].
    fn now(&self, node: usize) -> Vector;
}

impl KeptShape {
    /// Whether motion along an axis of the model may change it.
    pub fn sees(self, direction: usize) -> bool {
        match self {
            Self::Line(i, j) => [i, j].contains(&direction),
            Self::Plane | Self::Distance => true,
            Self::MeanTurn(axis) => (0..3).any(|k| k != direction && axis[k] != 0.0),
        }
    }

    /// The function; of a mean turn without the angle that is taken away.
    pub fn value(self, nodes: &impl Nodes) -> f64 {
        match self {
            Self::Line(i, j) => {
                let [d, r] = [1, 2].map(|node| less(nodes.now(node), nodes.now(0)));
                r[i] * d[j] - r[j] * d[i]
            }
            Self::Plane => {
                let [d, e, r] = [1, 2, 3].map(|node| less(nodes.now(node), nodes.now(0)));
                dot(cross(d, e), r)
            }
            Self::Distance => {
                let d = less(nodes.now(1), nodes.now(0));
                let before = less(nodes.before(1), nodes.before(0));
                0.5 * (dot(d, d) - dot(before, before))
            }
            Self::MeanTurn(axis) => {
                let turns = Turns::of(axis, nodes);
                let all = (0..nodes.count()).map(|node| turns.angle(nodes, node));
                all.sum::<f64>() / nodes.count() as f64
            }
        }
    }

    /// Its derivative by the position of a node.
    pub fn slope(self, nodes: &impl Nodes, node: usize) -> Vector {
        match self {
            Self::Line(i, j) => {
                let [d, r] = [1, 2].map(|node| less(nodes.now(node), nodes.now(0)));
                let mut by_d = [0.0; 3];
                (by_d[i], by_d[j]) = (-r[j], r[i]);
                let mut by_r = [0.0; 3];
                (by_r[i], by_r[j]) = (d[j], -d[i]);
                match node {
                    0 => std::array::from_fn(|k| -(by_d[k] + by_r[k])),
                    1 => by_d,
                    _ => by_r,
                }
            }
            Self::Plane => {
                let [d, e, r] = [1, 2, 3].map(|node| less(nodes.now(node), nodes.now(0)));
                let [by_d, by_e, by_r] = [cross(e, r), cross(r, d), cross(d, e)];
                match node {
                    0 => std::array::from_fn(|k| -(by_d[k] + by_e[k] + by_r[k])),
                    1 => by_d,
                    2 => by_e,
                    _ => by_r,
                }
            }
            Self::Distance => less(nodes.now(node), nodes.now(1 - node.min(1))),
            Self::MeanTurn(axis) => {
                let turns = Turns::of(axis, nodes);
                let share = 1.0 / nodes.count() as f64;
                let mean = mean(nodes.count(), |node| turns.slope(nodes, node));
                less(turns.slope(nodes, node), mean).map(|x| share * x)
            }
        }
    }

    /// Calls back with its second derivatives by the positions of two nodes each: node, direction,
    /// node, direction, derivative; pairs that call twice add.
    pub fn bends(
        self,
        nodes: &impl Nodes,
        mut call: impl FnMut((usize, usize), (usize, usize), f64),
    ) {
        match self {
            Self::Line(i, j) => {
                for (a, i, b, j, sign) in [(2, i, 1, j, 1.0), (2, j, 1, i, -1.0)] {
                    relative([a, b], (i, j), sign, &mut call);
                }
            }
            Self::Plane => {
                let [d, e, r] = [1, 2, 3].map(|node| less(nodes.now(node), nodes.now(0)));
                // det(d, e, r): by two of its rows the third one stays
                for (a, b, row) in [(1, 2, r), (2, 3, d), (3, 1, e)] {
                    for (p, q, k) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
                        relative([a, b], (p, q), row[k], &mut call);
                        relative([a, b], (q, p), -row[k], &mut call);
                    }
                }
            }
            Self::Distance => {
                (0..3).for_each(|k| relative([1, 1], (k, k), 0.5, &mut call));
            }
            Self::MeanTurn(axis) => mean_turn_bends(axis, nodes, &mut call),
        }
    }
}

/// A product of the relative positions of two nodes, p of `a` and q of `b` against node 0, in both
/// orders of derivation.
fn relative(
    [a, b]: [usize; 2],
    (p, q): (usize, usize),
    value: f64,
    call: &mut impl FnMut((usize, usize), (usize, usize), f64),
) {
    for (first, one) in [(a, 1.0), (0, -1.0)] {
        for (second, other) in [(b, 1.0), (0, -1.0)] {
            call((first, p), (second, q), one * other * value);
            call((second, q), (first, p), one * other * value);
        }
    }
}

/// Angles about an axis through the centre of nodes.
struct Turns {
    axis: Vector,
    /// The centre before and now [L].
    centres: [Vector; 2],
}

impl Turns {
    fn of(axis: Vector, nodes: &impl Nodes) -> Self {
        let before = mean(nodes.count(), |node| nodes.before(node));
        let now = mean(nodes.count(), |node| nodes.now(node));
        Self { axis, centres: [before, now] }
    }

    /// The arms of a node across the axis, before and now [L].
    fn arms(&self, nodes: &impl Nodes, node: usize) -> [Vector; 2] {
        let [before, now] = self.centres;
        [less(nodes.before(node), before), less(nodes.now(node), now)].map(|arm| {
            let along = dot(arm, self.axis);
            less(arm, self.axis.map(|x| along * x))
        })
    }

    fn angle(&self, nodes: &impl Nodes, node: usize) -> f64 {
        let [p, q] = self.arms(nodes, node);
        dot(self.axis, cross(p, q)).atan2(dot(p, q))
    }

    /// Derivative of an angle by its arm, (a x q)/q.q.
    fn slope(&self, nodes: &impl Nodes, node: usize) -> Vector {
        let [_, q] = self.arms(nodes, node);
        let square = dot(q, q);
        cross(self.axis, q).map(|x| x / square)
    }

    /// Second derivative of an angle by its arm, -(q m' + m q')/(q.q)^2 with m = a x q.
    fn bend(&self, nodes: &impl Nodes, node: usize) -> [Vector; 3] {
        let [_, q] = self.arms(nodes, node);
        let (m, square) = (cross(self.axis, q), dot(q, q));
        std::array::from_fn(|i| {
            std::array::from_fn(|j| -(q[i] * m[j] + m[i] * q[j]) / (square * square))
        })
    }
}

/// Of the mean of angles whose arms count from the mean of the positions.
fn mean_turn_bends(
    axis: Vector,
    nodes: &impl Nodes,
    call: &mut impl FnMut((usize, usize), (usize, usize), f64),
) {
    let turns = Turns::of(axis, nodes);
    let count = nodes.count();
    let share = 1.0 / count as f64;
    let mut mean = [[0.0; 3]; 3];
    for node in 0..count {
        let own = turns.bend(nodes, node);
        for (sum, row) in mean.iter_mut().zip(own) {
            sum.iter_mut().zip(row).for_each(|(sum, value)| *sum += share * value);
        }
    }
    for a in 0..count {
        let of_a = turns.bend(nodes, a);
        for b in 0..count {
            let of_b = turns.bend(nodes, b);
            for i in 0..3 {
                for j in 0..3 {
                    let alone = if a == b { of_a[i][j] } else { 0.0 };
                    let value = alone + share * (mean[i][j] - of_a[i][j] - of_b[i][j]);
                    call((a, i), (b, j), share * value);
                }
            }
        }
    }
}

/// The mean of some vectors.
fn mean(count: usize, of: impl Fn(usize) -> Vector) -> Vector {
    let mut sum = [0.0; 3];
    for own in (0..count).map(of) {
        sum.iter_mut().zip(own).for_each(|(sum, x)| *sum += x);
    }
    sum.map(|x| x / count as f64)
}

fn less(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|k| a[k] - b[k])
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Cloud {
        before: Vec<Vector>,
        now: Vec<Vector>,
    }

    impl Nodes for Cloud {
        fn count(&self) -> usize {
            self.now.len()
        }
        fn before(&self, node: usize) -> Vector {
            self.before[node]
        }
        fn now(&self, node: usize) -> Vector {
            self.now[node]
        }
    }

    fn cloud(count: usize) -> Cloud {
        // places without a pattern
        let place = |k: usize| -> Vector {
            std::array::from_fn(|axis| (1.7 * (k as f64) + 2.3 * (axis as f64) + 0.4).sin())
        };
        let moved = |k: usize| -> Vector {
            let x = place(k);
            std::array::from_fn(|axis| x[axis] + 0.2 * (2.9 * k as f64 + axis as f64).cos())
        };
        Cloud { before: (0..count).map(place).collect(), now: (0..count).map(moved).collect() }
    }

    const SHAPES: [(KeptShape, usize); 6] = [
        (KeptShape::Distance, 2),
        (KeptShape::Line(0, 2), 3),
        (KeptShape::Line(2, 1), 3),
        (KeptShape::Plane, 4),
        (KeptShape::MeanTurn([0.0, 0.6, 0.8]), 4),
        (KeptShape::MeanTurn([1.0, 0.0, 0.0]), 3),
    ];

    /// Requirement: first and second derivatives are those of central differences.
    #[test]
    fn derivatives_are_those_of_differences() {
        let h = 1e-5;
        for (shape, count) in SHAPES {
            let mut nodes = cloud(count);
            let slopes = |nodes: &Cloud| -> Vec<Vector> {
                (0..count).map(|node| shape.slope(nodes, node)).collect()
            };
            let exact = slopes(&nodes);
            let mut bends = vec![0.0; 9 * count * count];
            let at = |(a, i): (usize, usize), (b, j): (usize, usize)| {
                3 * count * (3 * a + i) + 3 * b + j
            };
            shape.bends(&nodes, |row, column, value| bends[at(row, column)] += value);
            for node in 0..count {
                for axis in 0..3 {
                    let mut seen = |step: f64| {
                        nodes.now[node][axis] += step;
                        let seen = (shape.value(&nodes), slopes(&nodes));
                        nodes.now[node][axis] -= step;
                        seen
                    };
                    let (up, down) = (seen(h), seen(-h));
                    let slope = (up.0 - down.0) / (2.0 * h);
                    assert!((slope - exact[node][axis]).abs() < 1e-8, "{shape:?}");
                    for other in 0..count {
                        for j in 0..3 {
                            let bend = (up.1[other][j] - down.1[other][j]) / (2.0 * h);
                            let own = bends[at((node, axis), (other, j))];
                            assert!((bend - own).abs() < 1e-7, "{shape:?} {bend} {own}");
                        }
                    }
                }
            }
        }
    }

    /// Requirement: a rigid turn about the axis, with any shift, is that angle, up to half a turn.
    #[test]
    fn a_rigid_turn_is_its_angle() {
        let mut nodes = cloud(5);
        for angle in [0.1_f64, 1.5, -2.9] {
            let (sin, cos) = angle.sin_cos();
            nodes.now = nodes
                .before
                .iter()
                .map(|[x, y, z]| [cos * x - sin * y + 3.0, sin * x + cos * y - 1.0, z + 0.5])
                .collect();
            let value = KeptShape::MeanTurn([0.0, 0.0, 1.0]).value(&nodes);
            assert!((value - angle).abs() < 1e-12, "{value} {angle}");
        }
    }

    /// Requirement: nodes on a line and in a plane keep the shapes at zero.
    #[test]
    fn what_is_on_the_shape_is_zero() {
        let mut nodes = cloud(4);
        let [a, b, c] = [0, 1, 2].map(|k| nodes.now[k]);
        nodes.now[3] = std::array::from_fn(|k| 0.2 * a[k] + 0.5 * b[k] + 0.3 * c[k]);
        assert!(KeptShape::Plane.value(&nodes).abs() < 1e-15);
        nodes.now[2] = std::array::from_fn(|k| 1.4 * a[k] - 0.4 * b[k]);
        assert!(KeptShape::Line(0, 1).value(&nodes).abs() < 1e-15);
        nodes.now[2][0] += 0.1;
        assert!(KeptShape::Line(0, 1).value(&nodes).abs() > 1e-3);
    }
}
