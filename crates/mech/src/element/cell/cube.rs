//! Quadrilaterals and hexahedra on [-1, 1]: linear, and quadratic without nodes inside faces.
//!
//! ```text
//!   4---7---3    p: place of a node, x: place asked for, a factor an axis
//!   |       |    linear:  product of (1 + p x)/2
//!   8       6    corner:  the same times (sum p x - (D - 1))
//!   |       |    middle:  (1 - x^2) along its edge, (1 + p x)/2 across
//!   1---5---2
//! ```

/// Corners of the quadrilateral.
pub(super) const QUAD4: &[[f64; 3]] =
    &[[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];

/// Those, then the middles of its edges.
pub(super) const QUAD8: &[[f64; 3]] = &[
    [-1.0, -1.0, 0.0],
    [1.0, -1.0, 0.0],
    [1.0, 1.0, 0.0],
    [-1.0, 1.0, 0.0],
    [0.0, -1.0, 0.0],
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [-1.0, 0.0, 0.0],
];

/// Corners of the hexahedron.
pub(super) const HEX8: &[[f64; 3]] = &[
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
];

/// Those, then the middles of its edges.
pub(super) const HEX20: &[[f64; 3]] = &[
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
    [0.0, -1.0, -1.0],
    [1.0, 0.0, -1.0],
    [0.0, 1.0, -1.0],
    [-1.0, 0.0, -1.0],
    [0.0, -1.0, 1.0],
    [1.0, 0.0, 1.0],
    [0.0, 1.0, 1.0],
    [-1.0, 0.0, 1.0],
    [-1.0, -1.0, 0.0],
    [1.0, -1.0, 0.0],
    [1.0, 1.0, 0.0],
    [-1.0, 1.0, 0.0],
];

/// Factor of an axis and its slope, for a node at `p` on it.
fn factor(p: f64, x: f64) -> [f64; 2] {
    if p == 0.0 { [1.0 - x * x, -2.0 * x] } else { [0.5 * (1.0 + p * x), 0.5 * p] }
}

/// Shape function and slopes of the node at `place`.
fn node<const D: usize>(place: &[f64; 3], at: &[f64; 3], quadratic: bool) -> (f64, [f64; 3]) {
    let factors: [[f64; 2]; 3] = std::array::from_fn(|axis| match axis < D {
        true => factor(place[axis], at[axis]),
        false => [1.0, 0.0],
    });
    let product = factors[0][0] * factors[1][0] * factors[2][0];
    let slopes: [f64; 3] = std::array::from_fn(|axis| {
        let own = |other: usize| factors[other][usize::from(other == axis)];
        own(0) * own(1) * own(2)
    });
    let corner = place[..D].iter().all(|p| *p != 0.0);
    if !(quadratic && corner) {
        return (product, slopes);
    }
    let sum: f64 = (0..D).map(|axis| place[axis] * at[axis]).sum::<f64>() - (D as f64 - 1.0);
    let by = std::array::from_fn(|axis| {
        let own = if axis < D { place[axis] } else { 0.0 };
        slopes[axis] * sum + product * own
    });
    (product * sum, by)
}

fn shapes<const D: usize>(places: &[[f64; 3]], at: &[f64; 3], quadratic: bool, into: &mut [f64]) {
    for (shape, place) in into.iter_mut().zip(places) {
        *shape = node::<D>(place, at, quadratic).0;
    }
}

fn slopes<const D: usize>(
    places: &[[f64; 3]],
    at: &[f64; 3],
    quadratic: bool,
    into: &mut [[f64; 3]],
) {
    for (slopes, place) in into.iter_mut().zip(places) {
        *slopes = node::<D>(place, at, quadratic).1;
    }
}

pub(super) fn quad4_shapes(at: &[f64; 3], into: &mut [f64]) {
    shapes::<2>(QUAD4, at, false, into);
}

pub(super) fn quad4_slopes(at: &[f64; 3], into: &mut [[f64; 3]]) {
    slopes::<2>(QUAD4, at, false, into);
}

pub(super) fn quad8_shapes(at: &[f64; 3], into: &mut [f64]) {
    shapes::<2>(QUAD8, at, true, into);
}

pub(super) fn quad8_slopes(at: &[f64; 3], into: &mut [[f64; 3]]) {
    slopes::<2>(QUAD8, at, true, into);
}

pub(super) fn hex8_shapes(at: &[f64; 3], into: &mut [f64]) {
    shapes::<3>(HEX8, at, false, into);
}

pub(super) fn hex8_slopes(at: &[f64; 3], into: &mut [[f64; 3]]) {
    slopes::<3>(HEX8, at, false, into);
}

pub(super) fn hex20_shapes(at: &[f64; 3], into: &mut [f64]) {
    shapes::<3>(HEX20, at, true, into);
}

pub(super) fn hex20_slopes(at: &[f64; 3], into: &mut [[f64; 3]]) {
    slopes::<3>(HEX20, at, true, into);
}
