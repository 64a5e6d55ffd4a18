//! Shape functions of faces, and the pieces that their nodes make.
//!
//! ```text
//!    3---6---2      2
//!    | \   / |      | \        corners first, then the nodes between them; a face with middle
//!    7   .   5      5--4       nodes falls into corner triangles and a middle piece
//!    | /   \ |      | \| \
//!    0---4---1      0--3--1
//! ```

use crate::differentiate::Real;

/// Most nodes of a face.
pub const MOST_NODES: usize = 8;
/// Most corners of a face.
pub const MOST_CORNERS: usize = 4;

/// Shape functions of the nodes of a face and their derivatives by its coordinates [1].
#[derive(Debug, Clone, Copy)]
pub struct Shapes<R> {
    /// The functions.
    pub value: [R; MOST_NODES],
    /// Their derivatives by either coordinate.
    pub slope: [[R; MOST_NODES]; 2],
}

/// Places of the nodes of a triangle on its reference cell.
const TRIANGLE: [[f64; 2]; 6] =
    [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.5, 0.0], [0.5, 0.5], [0.0, 0.5]];
/// Places of the nodes of a quadrilateral on its reference cell.
const SQUARE: [[f64; 2]; 8] = [
    [-1.0, -1.0],
    [1.0, -1.0],
    [1.0, 1.0],
    [-1.0, 1.0],
    [0.0, -1.0],
    [1.0, 0.0],
    [0.0, 1.0],
    [-1.0, 0.0],
];

/// Number of corners of a face of so many nodes.
pub const fn corners(nodes: usize) -> usize {
    if nodes == 3 || nodes == 6 { 3 } else { 4 }
}

/// Where a node stands on the reference cell of a face.
pub fn place_of(nodes: usize, node: usize) -> [f64; 2] {
    if corners(nodes) == 3 { TRIANGLE[node] } else { SQUARE[node] }
}

/// The middle of the reference cell of a face.
pub fn middle(nodes: usize) -> [f64; 2] {
    if corners(nodes) == 3 { [1.0 / 3.0; 2] } else { [0.0; 2] }
}

/// The pieces of a face of so many nodes: their corners, counter-clockwise as the face's.
pub fn pieces(nodes: usize) -> &'static [&'static [usize]] {
    match nodes {
        3 => &[&[0, 1, 2]],
        6 => &[&[0, 3, 5], &[3, 1, 4], &[5, 4, 2], &[3, 4, 5]],
        8 => &[&[0, 4, 7], &[4, 1, 5], &[5, 2, 6], &[6, 3, 7], &[4, 5, 6, 7]],
        _ => &[&[0, 1, 2, 3]],
    }
}

/// The edge of a face of so many nodes that a piece of it shares between two nodes.
pub(super) fn edge_between(count: usize, a: usize, b: usize) -> Option<usize> {
    let corners = corners(count);
    let is_upon = |edge: usize, node: usize| {
        node == edge || node == (edge + 1) % corners || node == corners + edge
    };
    (0..corners).find(|&edge| is_upon(edge, a) && is_upon(edge, b))
}

/// Shape functions of a face of so many nodes.
pub fn shapes<R: Real>(nodes: usize, at: [R; 2]) -> Shapes<R> {
    let nothing = [R::from_f64(0.0); MOST_NODES];
    let mut into = Shapes { value: nothing, slope: [nothing; 2] };
    match nodes {
        3 => triangle(at, &mut into),
        6 => curved_triangle(at, &mut into),
        8 => serendipity(at, &mut into),
        _ => quadrilateral(at, &mut into),
    }
    into
}

fn triangle<R: Real>([x, y]: [R; 2], into: &mut Shapes<R>) {
    let one = R::from_f64(1.0);
    into.value[..3].copy_from_slice(&[one - x - y, x, y]);
    let slopes = [[-1.0, 1.0, 0.0], [-1.0, 0.0, 1.0]];
    for (into, of) in into.slope.iter_mut().zip(slopes) {
        into.iter_mut().zip(of).for_each(|(into, of)| *into = R::from_f64(of));
    }
}

fn curved_triangle<R: Real>(at: [R; 2], into: &mut Shapes<R>) {
    let linear = shapes(3, at);
    let (one, two, four) = (R::from_f64(1.0), R::from_f64(2.0), R::from_f64(4.0));
    for k in 0..3 {
        let next = (k + 1) % 3;
        let (a, b) = (linear.value[k], linear.value[next]);
        into.value[k] = a * (two * a - one);
        into.value[3 + k] = four * a * b;
        for axis in 0..2 {
            let (by_a, by_b) = (linear.slope[axis][k], linear.slope[axis][next]);
            into.slope[axis][k] = (four * a - one) * by_a;
            into.slope[axis][3 + k] = four * (by_a * b + a * by_b);
        }
    }
}

fn quadrilateral<R: Real>([x, y]: [R; 2], into: &mut Shapes<R>) {
    let (one, quarter) = (R::from_f64(1.0), R::from_f64(0.25));
    for (node, [s, t]) in SQUARE[..4].iter().map(|own| own.map(R::from_f64)).enumerate() {
        let (a, b) = (one + s * x, one + t * y);
        into.value[node] = quarter * a * b;
        into.slope[0][node] = quarter * s * b;
        into.slope[1][node] = quarter * t * a;
    }
}

fn serendipity<R: Real>([x, y]: [R; 2], into: &mut Shapes<R>) {
    let (one, two) = (R::from_f64(1.0), R::from_f64(2.0));
    let (half, quarter) = (R::from_f64(0.5), R::from_f64(0.25));
    for (node, place) in SQUARE.iter().enumerate() {
        let [s, t] = place.map(R::from_f64);
        let (a, b) = (one + s * x, one + t * y);
        let (value, slope) = if node < MOST_CORNERS {
            let (u, v) = (s * x, t * y);
            (
                quarter * a * b * (u + v - one),
                [quarter * s * b * (two * u + v), quarter * t * a * (two * v + u)],
            )
        } else if place[0] == 0.0 {
            let bubble = one - x * x;
            (half * bubble * b, [-(x * b), half * t * bubble])
        } else {
            let bubble = one - y * y;
            (half * a * bubble, [half * s * bubble, -(y * a)])
        };
        into.value[node] = value;
        (into.slope[0][node], into.slope[1][node]) = (slope[0], slope[1]);
    }
}
