//! Temperatures of the points of a solid from those of its nodes.
//!
//! ```text
//!   4 nodes: one mean               8 nodes: what a linear strain can follow
//!    o-----o                         o--o--o   o: nodes
//!    | x x |   x: all points         o x x o   x: points of the reduced rule, where the field is
//!    | x x |      the same           |     |      taken; straight through them to the others
//!    o-----o                         o-x-x-o
//! ```
//!
//! A free element must be able to take the thermal strain up, or it is strained by its own
//! expansion: one order less than its displacements, docs/theory.md section 3.7.

use super::place::Reference;
use super::recipe::{Interpolation, Recipe};
use crate::element::cell::Cell;
use crate::element::quadrature::Quadrature;

/// What every node counts at every point.
pub(super) fn counts<const D: usize, const N: usize, const P: usize>(
    recipe: &Recipe,
) -> [[f64; N]; P] {
    let (cell, rule) = (recipe.cell, recipe.rule);
    match recipe.temperatures {
        Interpolation::Mean => [[1.0 / N as f64; N]; P],
        Interpolation::Shapes => std::array::from_fn(|point| shapes::<D, N>(cell, rule, point)),
        Interpolation::Linear => {
            let reduced = rule.reduced();
            let mut through = vec![0.0; reduced.points.len()];
            std::array::from_fn(|point| {
                (reduced.through)(rule.points.get(point).unwrap_or(&[0.0; 3]), &mut through);
                let mut own = [0.0; N];
                for (taken, part) in through.iter().enumerate() {
                    let shapes = shapes::<D, N>(cell, reduced, taken);
                    own.iter_mut().zip(shapes).for_each(|(own, shape)| *own += part * shape);
                }
                own
            })
        }
    }
}

fn shapes<const D: usize, const N: usize>(
    cell: &Cell,
    rule: &Quadrature,
    point: usize,
) -> [f64; N] {
    Reference::<D, N>::new(cell, rule.points.get(point).unwrap_or(&[0.0; 3]), 1.0).shapes
}
