//! A traction on a face that moves: its direction turns with the face or stays, its area is the
//! one of now or the undeformed one.
//!
//! ```text
//!        t   n            R n   R t        dx = F dX within the face, F = R U:
//!        |  /               \  /           U stretches and shears the face in its own plane,
//!     o-----o     ->     o---\/            R turns it, with its normal
//!                            o
//! ```
//! docs/theory.md eqs (4.21) to (4.24).

use crate::pressure::{At, Face, MOST_NODES, place, radius, tangents};
use crate::vector::{add, cross, dot, scale, size, sub};

/// What a traction does when its face moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Follows {
    /// Its direction turns with the face; else it stays.
    pub turns: bool,
    /// It acts on the area as it is now; else on the undeformed one.
    pub grows: bool,
}

/// A traction of size one on a face.
#[derive(Clone, Debug, PartialEq)]
pub struct Traction {
    face: Face,
    follows: Follows,
    /// At every point of the rule, along the axes of the model, undeformed [1].
    directions: Vec<[f64; 3]>,
}

/// A point of a face with its undeformed axes: two along the face, the outward normal.
#[derive(Clone, Debug)]
struct Point {
    axes: [[f64; 3]; 3],
    /// Undeformed area of the point [L2].
    area: f64,
    /// Derivatives of the shape functions along the first two axes [1/L].
    slopes: [[f64; 2]; MOST_NODES],
    shapes: [f64; MOST_NODES],
    /// Whether it is of an edge, whose second axis is across the plane.
    edge: bool,
    /// Undeformed radius [L] of an edge that runs about the second axis of the model.
    radius: Option<f64>,
}

impl Traction {
    /// One whose direction is given at each undeformed place, on a face with nodes at `x` [L].
    pub fn new(
        face: Face,
        follows: Follows,
        x: &[[f64; 3]],
        direction: impl Fn([f64; 3]) -> [f64; 3],
    ) -> Self {
        let directions = face.points().map(|at| direction(place(&at, x))).collect();
        Self { face, follows, directions }
    }

    /// One along the face, where a unit vector, given at each place, points when it is laid onto it;
    /// `None` where that stands across at a point.
    pub fn along(
        face: Face,
        follows: Follows,
        x: &[[f64; 3]],
        direction: impl Fn([f64; 3]) -> [f64; 3],
    ) -> Option<Self> {
        let laid = face.points().map(|at| {
            let direction = direction(place(&at, x));
            let normal = Point::new(&face, &at, x).axes[2];
            let laid = sub(direction, scale(normal, dot(direction, normal)));
            let size = size(laid);
            (size > ACROSS).then(|| scale(laid, 1.0 / size))
        });
        Some(Self { face, follows, directions: laid.collect::<Option<_>>()? })
    }

    /// What it does when its face moves.
    pub fn follows(&self) -> Follows {
        self.follows
    }

    /// The same where its nodes were at `rest` [L].
    pub fn at_rest(&self, rest: &[[f64; 3]]) -> Placed {
        let points = self.face.points().zip(&self.directions);
        let placed = points.map(|(at, &direction)| {
            let point = Point::new(&self.face, &at, rest);
            let components = point.components(direction);
            (point, components)
        });
        let follows = self.follows;
        Placed { follows, points: placed.filter(|(point, _)| point.area != 0.0).collect() }
    }
}

/// A traction of size one on a face whose undeformed places are known.
#[derive(Clone, Debug)]
pub struct Placed {
    follows: Follows,
    /// Points that have an area, and the direction at each along their axes and along those of the model.
    points: Vec<(Point, [[f64; 3]; 2])>,
}

impl Placed {
    /// Forces of a traction of this size [F/L2] on nodes at `x` [L]: adds to `force`, three for each
    /// node [F].
    pub fn pull(&self, traction: f64, x: &[[f64; 3]], force: &mut [[f64; 3]]) {
        for (point, direction) in &self.points {
            let now = Now::new(point.carried(x), *direction, self.follows);
            for (own, shape) in force.iter_mut().zip(point.shapes) {
                *own = add(*own, scale(now.force(), traction * point.area * shape));
            }
        }
    }

    /// Derivative of the forces by the positions: adds to `tangent`, a row for each force and a
    /// column for each position, three of each a node [F/L].
    pub fn stiffness(&self, traction: f64, x: &[[f64; 3]], tangent: &mut [f64]) {
        let width = 3 * x.len();
        for (point, direction) in &self.points {
            let now = Now::new(point.carried(x), *direction, self.follows);
            for column in 0..width {
                let change = now.change(point.carried_by(column));
                for (i, shape) in point.shapes.iter().enumerate().take(x.len()) {
                    let factor = traction * point.area * shape;
                    for (k, part) in change.iter().enumerate() {
                        tangent[(3 * i + k) * width + column] += factor * part;
                    }
                }
            }
        }
    }
}

impl Point {
    fn new(face: &Face, at: &At, rest: &[[f64; 3]]) -> Self {
        let [a, b] = tangents(at, rest);
        let length = size(a);
        let first = scale(a, 1.0 / length);
        let edge = !matches!(face, Face::Area(..));
        let spanned = cross(a, b);
        let (second, area) = match edge {
            true => ([0.0, 0.0, 1.0], length),
            false => (cross(scale(spanned, 1.0 / size(spanned)), first), size(spanned)),
        };
        let slopes = at.slopes.map(|[u, v]| match edge {
            true => [u / length, 0.0],
            false => [u / length, (v - dot(first, b) / length * u) / dot(second, b)],
        });
        let radius = matches!(face, Face::Ring { .. }).then(|| radius(at, rest));
        Self {
            axes: [first, second, cross(first, second)],
            area: at.weight * area * radius.unwrap_or(1.0),
            slopes,
            shapes: at.shapes,
            edge,
            radius,
        }
    }

    /// A vector along the undeformed axes, with itself along those of the model.
    fn components(&self, vector: [f64; 3]) -> [[f64; 3]; 2] {
        [self.axes.map(|axis| dot(axis, vector)), vector]
    }

    /// What has become of the two axes along the face, with nodes at `x`: the columns of F [1].
    fn carried(&self, x: &[[f64; 3]]) -> [[f64; 3]; 2] {
        let mut carried = [[0.0; 3]; 2];
        for (x, slope) in x.iter().zip(self.slopes) {
            carried = [0, 1].map(|k| add(carried[k], scale(*x, slope[k])));
        }
        if self.edge {
            let now: f64 = self.shapes.iter().zip(x).map(|(shape, x)| shape * x[0]).sum();
            carried[1][2] = self.radius.map_or(1.0, |radius| now / radius);
        }
        carried
    }

    /// Their derivative by a component of a position, three a node [1/L].
    fn carried_by(&self, column: usize) -> [[f64; 3]; 2] {
        let (node, axis) = (column / 3, column % 3);
        let mut unit = [0.0; 3];
        unit[axis] = 1.0;
        let mut change = self.slopes[node].map(|slope| scale(unit, slope));
        if let Some(radius) = self.radius.filter(|_| axis == 0) {
            change[1][2] = self.shapes[node] / radius;
        }
        change
    }
}

/// A traction at a point, per undeformed area.
struct Now {
    follows: Follows,
    /// Its components along the undeformed axes.
    own: [f64; 3],
    /// The carried axes along the face [1].
    carried: [[f64; 3]; 2],
    /// The normal as it is, and by how much the area has grown [1].
    normal: [f64; 3],
    growth: f64,
    /// The first axis as it has turned, and the length of the sum that it was made of [1].
    first: [f64; 3],
    length: f64,
    /// The direction as it is.
    direction: [f64; 3],
}

impl Now {
    fn new(carried: [[f64; 3]; 2], [own, stays]: [[f64; 3]; 2], follows: Follows) -> Self {
        let [f, g] = carried;
        let spanned = cross(f, g);
        let growth = size(spanned);
        let normal = scale(spanned, 1.0 / growth);
        let sum = add(f, cross(g, normal));
        let length = size(sum);
        let first = scale(sum, 1.0 / length);
        let along = add(scale(first, own[0]), scale(cross(normal, first), own[1]));
        let turned = add(along, scale(normal, own[2]));
        let direction = if follows.turns { turned } else { stays };
        Self { follows, own, carried, normal, growth, first, length, direction }
    }

    /// Its force per undeformed area [1].
    fn force(&self) -> [f64; 3] {
        if self.follows.grows { scale(self.direction, self.growth) } else { self.direction }
    }

    /// The change of that force with one of the carried axes.
    fn change(&self, [df, dg]: [[f64; 3]; 2]) -> [f64; 3] {
        let [f, g] = self.carried;
        let spanned = add(cross(df, g), cross(f, dg));
        let growth = dot(self.normal, spanned);
        let normal = scale(sub(spanned, scale(self.normal, growth)), 1.0 / self.growth);
        let mut change = [0.0; 3];
        if self.follows.turns {
            change = self.turning(normal, add(df, add(cross(dg, self.normal), cross(g, normal))));
        }
        if self.follows.grows {
            change = add(scale(change, self.growth), scale(self.direction, growth));
        }
        change
    }

    /// The change of the direction with those of the normal and of the sum along the first axis.
    fn turning(&self, normal: [f64; 3], sum: [f64; 3]) -> [f64; 3] {
        let along = dot(self.first, sum);
        let first = scale(sub(sum, scale(self.first, along)), 1.0 / self.length);
        let second = add(cross(normal, self.first), cross(self.normal, first));
        let within = add(scale(first, self.own[0]), scale(second, self.own[1]));
        add(within, scale(normal, self.own[2]))
    }
}

/// What of a unit vector lies along a face, below which it stands across but for rounding [1].
const ACROSS: f64 = 1e-8;

#[cfg(test)]
mod tests;
