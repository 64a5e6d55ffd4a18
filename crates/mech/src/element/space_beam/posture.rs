//! How the nodes of a beam in space have turned, and what each has turned against one of them.
//!
//! ```text
//!   theta: a further small turn about fixed axes         R_a := exp(theta) R_a
//!   psi_a: rotation vector of R_r' R_a, what node a      r o-----o a
//!          has turned against the reference node r
//! ```
//! docs/theory.md eqs (3.71), (3.74).

use crate::differentiate::{Real, Second};
use crate::rotation::{self, Quaternion};
use crate::turn::Turn;

/// A rotation vector with its derivatives by the turns of the reference node and of its own.
pub(super) type Relative = [Second<6>; 3];

/// Rotations of the `N` nodes of an element.
#[derive(Clone, Debug)]
pub(super) struct Posture<const N: usize> {
    /// Rotation of the reference node.
    pub reference: Quaternion,
    /// What the nodes have turned against it; the reference node itself: nothing.
    pub relative: [Relative; N],
    /// Turn of each node by its own dofs, T: a row for each component.
    pub spins: [[[f64; 3]; 3]; N],
    /// Rotation vectors since the last start of each.
    pub vectors: [[f64; 3]; N],
}

/// The node that the others turn against.
pub(super) const fn reference_node(nodes: usize) -> usize {
    if nodes == 3 { 1 } else { 0 }
}

impl<const N: usize> Posture<N> {
    /// That of dofs (3 displacements, 3 rotations a node), each node with the turn that its
    /// rotations count from; none: from rest.
    pub fn new(q: &[f64], turns: &[Turn]) -> Self {
        let turn = |a: usize| turns.get(a).copied().unwrap_or(Turn::REST);
        let dofs = |a: usize| [q[6 * a + 3], q[6 * a + 4], q[6 * a + 5]];
        let vectors: [[f64; 3]; N] = std::array::from_fn(|a| turn(a).vector(dofs(a)));
        let rotations: [Quaternion; N] = std::array::from_fn(|a| turn(a).rotation(dofs(a)));
        let reference = rotations[reference_node(N)];
        let relative = std::array::from_fn(|a| match a == reference_node(N) {
            true => [Second::constant(0.0); 3],
            false => relative(&reference, &rotations[a]),
        });
        Self { reference, relative, spins: vectors.map(rotation::spin), vectors }
    }
}

/// exp(theta) to the second order: all that two derivatives at theta = 0 see.
pub(super) fn small<R: Real>(theta: &[R; 3]) -> Quaternion<R> {
    let square = theta[0] * theta[0] + theta[1] * theta[1] + theta[2] * theta[2];
    let [x, y, z] = theta.map(|part| part * R::from_f64(0.5));
    [R::from_f64(1.0) - square * R::from_f64(0.125), x, y, z]
}

/// The rotation vector of R_r' R_a with its derivatives by theta of both.
fn relative(reference: &Quaternion, own: &Quaternion) -> Relative {
    let turns = Second::<6>::variables(&[0.0; 6]);
    let [a, b, c, d, e, f] = turns;
    let fixed = |q: &Quaternion| q.map(Second::<6>::constant);
    let reference = rotation::after(&small(&[a, b, c]), &fixed(reference));
    let own = rotation::after(&small(&[d, e, f]), &fixed(own));
    rotation::vector(&rotation::after(&rotation::back(&reference), &own))
}
