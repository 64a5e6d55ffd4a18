//! The kernels of elements as they are compiled.
//!
//! ```text
//!   cell, rule, dimension --> code for these numbers of nodes, points and coordinates, once in the
//!                             program: everything above it knows kernels by their trait alone
//! ```
//!
//! The mechanics of an element are written once, generic in its numbers (`slideline_mech::element`); what is made of them
//! for each cell is most of what the compiler does for elements.

use slideline_mech::element::solid::{Recipe, Solids};
use slideline_mech::element::{Bar, Kernel, Trusses};
use slideline_mech::vector::Vector;

/// The kernel of solids, given the undeformed positions of the nodes of one after another [L]; `None` where there is no
/// solid of that cell and rule.
pub fn solids(recipe: Recipe, nodes: &[Vector]) -> Option<Box<dyn Kernel>> {
    let numbers = (recipe.cell.dimension, recipe.cell.nodes, recipe.rule.points.len());
    match numbers {
        (2, 3, 1) => solids_of::<2, 3, 1>(recipe, nodes),
        (2, 4, 1) => solids_of::<2, 4, 1>(recipe, nodes),
        (2, 4, 4) => solids_of::<2, 4, 4>(recipe, nodes),
        (2, 6, 3) => solids_of::<2, 6, 3>(recipe, nodes),
        (2, 8, 4) => solids_of::<2, 8, 4>(recipe, nodes),
        (2, 8, 9) => solids_of::<2, 8, 9>(recipe, nodes),
        (3, 4, 1) => solids_of::<3, 4, 1>(recipe, nodes),
        (3, 6, 2) => solids_of::<3, 6, 2>(recipe, nodes),
        (3, 8, 1) => solids_of::<3, 8, 1>(recipe, nodes),
        (3, 8, 8) => solids_of::<3, 8, 8>(recipe, nodes),
        (3, 10, 4) => solids_of::<3, 10, 4>(recipe, nodes),
        (3, 15, 9) => solids_of::<3, 15, 9>(recipe, nodes),
        (3, 20, 8) => solids_of::<3, 20, 8>(recipe, nodes),
        (3, 20, 27) => solids_of::<3, 20, 27>(recipe, nodes),
        _ => None,
    }
}

fn solids_of<const D: usize, const N: usize, const P: usize>(
    recipe: Recipe,
    nodes: &[Vector],
) -> Option<Box<dyn Kernel>> {
    Some(Box::new(Solids::<D, N, P>::new(recipe, places::<D, N>(nodes))?))
}

/// The kernel of trusses of so many nodes in so many dimensions, given the undeformed positions of the nodes of one after
/// another [L]; `None` where there is none of these numbers.
pub fn trusses(bar: Bar, numbers: [usize; 2], nodes: &[Vector]) -> Option<Box<dyn Kernel>> {
    match numbers {
        [2, 2] => trusses_of::<2, 2, 1>(bar, nodes),
        [2, 3] => trusses_of::<2, 3, 2>(bar, nodes),
        [3, 2] => trusses_of::<3, 2, 1>(bar, nodes),
        [3, 3] => trusses_of::<3, 3, 2>(bar, nodes),
        _ => None,
    }
}

fn trusses_of<const D: usize, const N: usize, const P: usize>(
    bar: Bar,
    nodes: &[Vector],
) -> Option<Box<dyn Kernel>> {
    Some(Box::new(Trusses::<D, N, P>::new(bar, places::<D, N>(nodes))?))
}

/// The first `D` coordinates of the `N` nodes of each element [L].
pub fn places<const D: usize, const N: usize>(
    nodes: &[Vector],
) -> impl Iterator<Item = [[f64; D]; N]> {
    let elements = nodes.as_chunks::<N>().0.iter();
    elements.map(|nodes| nodes.map(|node| std::array::from_fn(|axis| node[axis])))
}
