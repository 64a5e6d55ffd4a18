//! Gauss's rules: where an element is integrated.
//!
//! ```text
//!   +-------+     x: integration points, the first coordinate running first;
//!   | x   x |     weights sum to the content of the reference cell;
//!   | x   x |     a rule also knows the polynomial through values at its points,
//!   +-------+     which carries results to the nodes
//! ```

use super::cell::Cell;

/// Abscissa of the two-point rule, 1/sqrt 3; both points have weight 1.
pub const GAUSS_2: f64 = 0.577_350_269_189_625_8;

/// Abscissa of the outer points of the three-point rule, sqrt(3/5).
pub const GAUSS_3: f64 = 0.774_596_669_241_483_4;

/// Abscissae of the four-point rule on [-1, 1].
pub const GAUSS_4: [f64; 4] = [
    -0.861_136_311_594_052_6,
    -0.339_981_043_584_856_26,
    0.339_981_043_584_856_26,
    0.861_136_311_594_052_6,
];

/// Weights of the four-point rule for a mean value [1].
pub const GAUSS_4_MEAN: [f64; 4] = [
    0.173_927_422_568_726_93,
    0.326_072_577_431_273_07,
    0.326_072_577_431_273_07,
    0.173_927_422_568_726_93,
];

/// The most points that a rule has.
pub const MOST_POINTS: usize = 27;

/// A rule on a reference cell.
#[derive(Debug)]
pub struct Quadrature {
    /// Its name.
    pub name: &'static str,
    /// Where its points stand.
    pub points: &'static [[f64; 3]],
    /// Their weights.
    pub weights: &'static [f64],
    /// Writes what the value at each point counts for the polynomial through all of them.
    pub through: fn(&[f64; 3], &mut [f64]),
}

impl PartialEq for Quadrature {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Quadrature {
    /// The rule of one order less where it has three points along an axis, else itself.
    pub fn reduced(&'static self) -> &'static Self {
        let rules: [(&'static Self, &'static Self); 3] =
            [(&QUAD_9, &QUAD_4), (&WEDGE_3X3, &WEDGE_2X3), (&HEX_27, &HEX_8)];
        rules.into_iter().find(|(full, _)| self == *full).map_or(self, |(_, reduced)| reduced)
    }

    /// Writes values at the nodes of a cell from those at the points, `components` values each,
    /// node after node and point after point.
    pub fn carry(&self, values: &[f64], components: usize, cell: &Cell, nodes: &mut [f64]) {
        let mut counts = [0.0; MOST_POINTS];
        let counts = &mut counts[..self.points.len()];
        let width = components.max(1);
        for (node, place) in nodes.chunks_exact_mut(width).zip(cell.places) {
            (self.through)(place, counts);
            node.fill(0.0);
            for (count, point) in counts.iter().zip(values.chunks_exact(width)) {
                node.iter_mut().zip(point).for_each(|(sum, value)| *sum += count * value);
            }
        }
    }
}

const LINE_1: [[f64; 2]; 1] = [[0.0, 2.0]];
const LINE_2: [[f64; 2]; 2] = [[-GAUSS_2, 1.0], [GAUSS_2, 1.0]];
const LINE_3: [[f64; 2]; 3] = [[-GAUSS_3, 5.0 / 9.0], [0.0, 8.0 / 9.0], [GAUSS_3, 5.0 / 9.0]];

/// Product of a line rule with itself in the plane: places and weights.
const fn square<const N: usize, const P: usize>(line: [[f64; 2]; N]) -> ([[f64; 3]; P], [f64; P]) {
    let (mut points, mut weights, mut k) = ([[0.0; 3]; P], [0.0; P], 0);
    while k < P {
        let (x, y) = (line[k % N], line[k / N % N]);
        points[k] = [x[0], y[0], 0.0];
        weights[k] = x[1] * y[1];
        k += 1;
    }
    (points, weights)
}

/// Product of a line rule with a rule of the plane, that of the plane running first.
const fn upright<const A: usize, const N: usize, const P: usize>(
    plane: ([[f64; 3]; A], [f64; A]),
    line: [[f64; 2]; N],
) -> ([[f64; 3]; P], [f64; P]) {
    let (mut points, mut weights, mut k) = ([[0.0; 3]; P], [0.0; P], 0);
    while k < P {
        let z = line[k / A];
        points[k] = [plane.0[k % A][0], plane.0[k % A][1], z[0]];
        weights[k] = plane.1[k % A] * z[1];
        k += 1;
    }
    (points, weights)
}

const SIXTH: f64 = 1.0 / 6.0;
const THIRD: f64 = 1.0 / 3.0;
const TRIANGLE_1: ([[f64; 3]; 1], [f64; 1]) = ([[THIRD, THIRD, 0.0]], [0.5]);
const TRIANGLE_3: ([[f64; 3]; 3], [f64; 3]) = (
    [[SIXTH, SIXTH, 0.0], [2.0 * THIRD, SIXTH, 0.0], [SIXTH, 2.0 * THIRD, 0.0]],
    [SIXTH, SIXTH, SIXTH],
);
/// (5 - sqrt 5)/20 and (5 + 3 sqrt 5)/20.
const NEAR: f64 = 0.138_196_601_125_010_5;
const FAR: f64 = 0.585_410_196_624_968_5;
const TETRAHEDRON_4: ([[f64; 3]; 4], [f64; 4]) = (
    [[NEAR, NEAR, NEAR], [FAR, NEAR, NEAR], [NEAR, FAR, NEAR], [NEAR, NEAR, FAR]],
    [0.25 * SIXTH; 4],
);
const SQUARE_1: ([[f64; 3]; 1], [f64; 1]) = square(LINE_1);
const SQUARE_4: ([[f64; 3]; 4], [f64; 4]) = square(LINE_2);
const SQUARE_9: ([[f64; 3]; 9], [f64; 9]) = square(LINE_3);
const WEDGE_2: ([[f64; 3]; 2], [f64; 2]) = upright(TRIANGLE_1, LINE_2);
const WEDGE_6: ([[f64; 3]; 6], [f64; 6]) = upright(TRIANGLE_3, LINE_2);
const WEDGE_9: ([[f64; 3]; 9], [f64; 9]) = upright(TRIANGLE_3, LINE_3);
const CUBE_1: ([[f64; 3]; 1], [f64; 1]) = upright(SQUARE_1, LINE_1);
const CUBE_8: ([[f64; 3]; 8], [f64; 8]) = upright(SQUARE_4, LINE_2);
const CUBE_27: ([[f64; 3]; 27], [f64; 27]) = upright(SQUARE_9, LINE_3);

const fn rule<const P: usize>(
    name: &'static str,
    rule: &'static ([[f64; 3]; P], [f64; P]),
    through: fn(&[f64; 3], &mut [f64]),
) -> Quadrature {
    Quadrature { name, points: &rule.0, weights: &rule.1, through }
}

/// The centre of the triangle.
pub static TRI_1: Quadrature = rule("tri 1", &TRIANGLE_1, |_, counts| counts.fill(1.0));
/// Three points of the triangle.
pub static TRI_3: Quadrature = rule("tri 3", &TRIANGLE_3, |at, counts| {
    simplex::<2>(at, SIXTH, 2.0 * THIRD, counts);
});
/// The centre of the square.
pub static QUAD_1: Quadrature = rule("quad 1", &SQUARE_1, |_, counts| counts.fill(1.0));
/// Two by two points.
pub static QUAD_4: Quadrature = rule("quad 4", &SQUARE_4, |at, counts| {
    product(&LINE_2, &at[..2], counts);
});
/// Three by three.
pub static QUAD_9: Quadrature = rule("quad 9", &SQUARE_9, |at, counts| {
    product(&LINE_3, &at[..2], counts);
});
/// The centre of the tetrahedron.
pub static TET_1: Quadrature = rule("tet 1", &([[0.25; 3]], [SIXTH]), |_, counts| counts.fill(1.0));
/// Four points of the tetrahedron.
pub static TET_4: Quadrature = rule("tet 4", &TETRAHEDRON_4, |at, counts| {
    simplex::<3>(at, NEAR, FAR, counts);
});
/// Two points on the axis of the wedge.
pub static WEDGE_AXIS_2: Quadrature = rule("wedge 2", &WEDGE_2, |at, counts| {
    product(&LINE_2, &at[2..], counts);
});
/// Three by three: triangles in three heights.
pub static WEDGE_3X3: Quadrature = rule("wedge 9", &WEDGE_9, |at, counts| {
    let (mut plane, mut line) = ([0.0; 3], [0.0; 3]);
    simplex::<2>(at, SIXTH, 2.0 * THIRD, &mut plane);
    product(&LINE_3, &at[2..], &mut line);
    for (k, count) in counts.iter_mut().enumerate() {
        *count = plane[k % 3] * line[k / 3 % 3];
    }
});
/// Three points of the triangle in two heights.
pub static WEDGE_2X3: Quadrature = rule("wedge 6", &WEDGE_6, |at, counts| {
    let (mut plane, mut line) = ([0.0; 3], [0.0; 2]);
    simplex::<2>(at, SIXTH, 2.0 * THIRD, &mut plane);
    product(&LINE_2, &at[2..], &mut line);
    for (k, count) in counts.iter_mut().enumerate() {
        *count = plane[k % 3] * line[k / 3 % 2];
    }
});
/// The centre of the cube.
pub static HEX_1: Quadrature = rule("hex 1", &CUBE_1, |_, counts| counts.fill(1.0));
/// Two by two by two.
pub static HEX_8: Quadrature = rule("hex 8", &CUBE_8, |at, counts| product(&LINE_2, at, counts));
/// Three by three by three.
pub static HEX_27: Quadrature = rule("hex 27", &CUBE_27, |at, counts| product(&LINE_3, at, counts));

/// Lagrange's polynomials of a line rule, multiplied along the axes.
fn product<const N: usize>(line: &[[f64; 2]; N], at: &[f64], counts: &mut [f64]) {
    counts.fill(1.0);
    let mut stride = 1;
    for &x in at {
        for (k, count) in counts.iter_mut().enumerate() {
            let own = k / stride % N;
            for other in (0..N).filter(|&other| other != own) {
                *count *= (x - line[other][0]) / (line[own][0] - line[other][0]);
            }
        }
        stride *= N;
    }
}

/// Linear through the points of a simplex rule, which stand at `near` along every axis but one at
/// most, where they stand at `far`.
fn simplex<const D: usize>(at: &[f64; 3], near: f64, far: f64, counts: &mut [f64]) {
    let mut rest = 1.0;
    for axis in 0..D {
        let count = (at[axis] - near) / (far - near);
        counts[axis + 1] = count;
        rest -= count;
    }
    counts[0] = rest;
}

#[cfg(test)]
mod tests;
