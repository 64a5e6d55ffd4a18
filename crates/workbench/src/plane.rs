//! Points and directions of the plane.

/// A point or a direction.
pub(crate) type Point = [f64; 2];

pub(crate) fn plus(a: Point, b: Point) -> Point {
    [a[0] + b[0], a[1] + b[1]]
}

pub(crate) fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}

pub(crate) fn times(a: Point, factor: f64) -> Point {
    a.map(|own| factor * own)
}

pub(crate) fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// Component out of the plane of a x b.
pub(crate) fn cross(a: Point, b: Point) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

pub(crate) fn distance(a: Point, b: Point) -> f64 {
    let [x, y] = minus(a, b);
    x.hypot(y)
}

/// In the direction from a to b, of length 1.
pub(crate) fn towards(a: Point, b: Point) -> Point {
    times(minus(b, a), 1.0 / distance(a, b))
}

/// A quarter turn counter-clockwise.
pub(crate) fn left(a: Point) -> Point {
    [-a[1], a[0]]
}

/// Turned counter-clockwise by an angle [rad].
pub(crate) fn turned(a: Point, angle: f64) -> Point {
    let (sine, cosine) = angle.sin_cos();
    [cosine * a[0] - sine * a[1], sine * a[0] + cosine * a[1]]
}

/// Where two lines cross, each a point and a direction; not finite where they are parallel.
pub(crate) fn crossing((a, along): (Point, Point), (b, other): (Point, Point)) -> Point {
    plus(a, times(along, cross(minus(b, a), other) / cross(along, other)))
}
