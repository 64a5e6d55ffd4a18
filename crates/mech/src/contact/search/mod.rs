//! Which part of the master faces this point?
//!
//! ```text
//!            x                 rigid:  line, arc, parabola segments in the frame of the body
//!            |                 chain:  nodes of a deforming line, smoothed corners, end extensions
//!    o---o---+--o---o
//! ```
//!
//! [`itself`] and [`own_faces`] are the searches of a surface that meets itself, [`outlook`] tells which
//! of the sides of a sharp edge a slave node meets.

pub mod chain;
mod continued;
pub mod edges;
pub mod faces;
pub mod itself;
pub mod nearest;
pub mod outlook;
pub mod own_faces;
pub mod pass;

mod ridge;
pub mod rigid;
pub mod segment;
pub mod sharp;
pub mod sharp_faces;
pub mod sharp_rigid;
pub mod sweep;
pub mod swept;
pub mod thickness;
pub mod through;
pub mod tree;

type Point = [f64; 2];

/// The place of a point in the plane of a chain.
pub fn flat([x, y, _]: [f64; 3]) -> [f64; 2] {
    [x, y]
}

/// A place in the plane of a chain as one in space.
pub fn raised([x, y]: [f64; 2]) -> [f64; 3] {
    [x, y, 0.0]
}

fn sub(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}

fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: Point, b: Point) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// Overshoot of parameters that still counts as inside: there is never a hole between pieces that
/// join smoothly.
const INSIDE: f64 = 1e-9;

/// Equality of two distances up to rounding.
const TIE: f64 = 1e-12;

/// Parameter of the projection of `point` on the quadratic Bezier curve through `control`, in
/// [0, 1] up to [`INSIDE`]; `None` if the point does not face it.
fn project_quadratic(control: &[Point; 3], point: Point) -> Option<f64> {
    // F/2 by powers of s, about the first point: (w - 2 s d - s^2 c) . (d + s c)
    let (w, d) = (sub(point, control[0]), sub(control[1], control[0]));
    let c = sub(sub(control[2], control[1]), d);
    let [f0, f1, f2, f3] = [dot(w, d), dot(w, c) - 2.0 * dot(d, d), -3.0 * dot(d, c), -dot(c, c)];
    let value = |s: f64| {
        let f = f0 + s * (f1 + s * (f2 + s * f3));
        (f, f1 + s * (2.0 * f2 + 3.0 * s * f3))
    };
    nearest_parameter(value, (0.0, 1.0))
}

/// Parameter of the nearest point of a curve, in this range up to [`INSIDE`]; `None` where the range has
/// none. `value` is F = (x - B).B' with its slope, which falls through zero there. Newton with bisection.
fn nearest_parameter(value: impl Fn(f64) -> (f64, f64), (low, high): (f64, f64)) -> Option<f64> {
    let mut s = 0.5 * (low + high);
    let (mut low, mut high) = (low - INSIDE, high + INSIDE);
    if value(low).0 < 0.0 || value(high).0 > 0.0 {
        return None;
    }
    for _ in 0..80 {
        let (f, slope) = value(s);
        if f >= 0.0 {
            low = s;
        } else {
            high = s;
        }
        let newton = s - f / slope;
        if (newton - s).abs() <= 2.0 * f64::EPSILON {
            s = newton;
            break;
        }
        s = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
    }
    // A nearest point, on a curve that has not collapsed.
    (s.is_finite() && value(s).1 < 0.0).then_some(s)
}

/// Straight projection parameter on a -> b; `None` if both coincide.
fn project_line(a: Point, b: Point, point: Point) -> Option<f64> {
    let along = sub(b, a);
    let square = dot(along, along);
    let xi = dot(sub(point, a), along) / square;
    (square > 0.0 && xi.is_finite()).then_some(xi)
}
