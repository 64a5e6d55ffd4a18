//! Stiffness of hourglass modes: bending and twist of a block with the sides of the element.
//!
//! ```text
//!       j_2                 amount of xi eta along j_1: curvature in the plane 1 2
//!     ___|___                                along j_2: curvature in the plane 2 1
//!    /   |   /                               along j_3: twist, with eta zeta along j_1 and
//!   /    o--/-- j_1                                     zeta xi along j_2
//!  /_______/
//! ```
//!
//! docs/theory.md eqs. (3.54), (3.118).

use crate::vector::{Vector, add, dot, scale};

/// Modes of a hexahedron; a quadrilateral has the first one.
pub(super) const MODES: usize = 4;

/// Amounts of the modes [L], or the forces on them [F].
pub(super) type Amounts = [Vector; MODES];

/// The mode that is the product of two coordinates.
const PRODUCT: [[usize; 3]; 3] = [[usize::MAX, 0, 2], [0, usize::MAX, 1], [2, 1, usize::MAX]];

/// How the modes of an element are held, along the axes of the undeformed model.
#[derive(Debug, Clone, Copy)]
pub(super) enum Bending {
    /// Every amount alike [F/L].
    Even(f64),
    /// Along the halves of the sides of a quadrilateral [L], with modulus times volume [F L].
    InPlane([Vector; 3], f64),
    /// The same of a hexahedron, and Poisson's ratio.
    InSpace([Vector; 3], f64, f64),
}

impl Bending {
    /// A stiffness that is the same for all amounts [F/L].
    pub fn even(stiffness: f64) -> Self {
        Self::Even(stiffness)
    }

    /// A quadrilateral with these halves of its sides [L], modulus of bending times volume [F L].
    pub fn in_plane(sides: [Vector; 3], modulus: f64) -> Self {
        Self::InPlane(sides, modulus)
    }

    /// A hexahedron with these halves of its sides [L], modulus of elasticity times volume [F L].
    pub fn in_space(sides: [Vector; 3], modulus: f64, poisson: f64) -> Self {
        Self::InSpace(sides, modulus, poisson)
    }

    /// Forces on the amounts [F]: a symmetric and positive linear function of them.
    pub fn forces(&self, amounts: &Amounts) -> Amounts {
        match self {
            Self::Even(stiffness) => amounts.map(|amount| scale(amount, *stiffness)),
            Self::InPlane(sides, modulus) => {
                let mut forces = [[0.0; 3]; MODES];
                forces[0] = along_sides(&sides[..2], modulus / 3.0, amounts[0]);
                forces
            }
            Self::InSpace(sides, modulus, poisson) => {
                let mut forces = [[0.0; 3]; MODES];
                for axis in 0..3 {
                    add_plate(axis, sides, (*modulus, *poisson), (amounts, &mut forces));
                }
                forces[3] = along_sides(sides, modulus / 9.0, amounts[3]);
                forces
            }
        }
    }
}

/// Force of an amount that is stretched along the sides.
fn along_sides(sides: &[Vector], modulus: f64, amount: Vector) -> Vector {
    let along = |side: &Vector| {
        let square = dot(*side, *side);
        scale(*side, modulus * dot(*side, amount) / (square * square))
    };
    sides.iter().map(along).fold([0.0; 3], add)
}

/// Adds the forces of the curvatures of the layers across an axis, which are plates in plane stress.
fn add_plate(
    across: usize,
    sides: &[Vector; 3],
    (modulus, poisson): (f64, f64),
    (amounts, into): (&Amounts, &mut Amounts),
) {
    let [a, b] = [(across + 1) % 3, (across + 2) % 3];
    let (j, k) = (sides[a], sides[b]);
    let (first, second) = (PRODUCT[a][across], PRODUCT[b][across]);
    let (of_first, of_second) = (amounts[first], amounts[second]);
    let curvature =
        [dot(j, of_first), dot(k, of_second), 0.5 * (dot(j, of_second) + dot(k, of_first))];
    // the metric of the layer, inverted: j j, k k, j k
    let (jj, kk, jk) = (dot(j, j), dot(k, k), dot(j, k));
    let det = jj * kk - jk * jk;
    let metric = [kk / det, jj / det, -jk / det];
    let trace =
        metric[0] * curvature[0] + metric[1] * curvature[1] + 2.0 * metric[2] * curvature[2];
    // g K g by its components
    let [p, q, r] = metric;
    let [x, y, z] = curvature;
    let raised = [
        p * p * x + 2.0 * p * r * z + r * r * y,
        r * r * x + 2.0 * r * q * z + q * q * y,
        p * r * x + (p * q + r * r) * z + r * q * y,
    ];
    let part = modulus / (3.0 * (1.0 - poisson * poisson));
    let moment: [f64; 3] =
        std::array::from_fn(|c| part * (poisson * trace * metric[c] + (1.0 - poisson) * raised[c]));
    into[first] = add(into[first], add(scale(j, moment[0]), scale(k, moment[2])));
    into[second] = add(into[second], add(scale(k, moment[1]), scale(j, moment[2])));
}
