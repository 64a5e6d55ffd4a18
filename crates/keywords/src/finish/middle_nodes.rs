//! Middle nodes of solids that lie past the quarter points of their edges.
//!
//! ```text
//!   first           middle                     last
//!     o------+--------o--------+-------|---------o
//!            1/4              1/2     3/4
//! ```
//!
//! Along an edge of length l with its middle at the part p of it, dx/dxi = l (1/2 + xi (1 - 2 p)), which
//! vanishes at a corner for p = 1/4 and p = 3/4: elements about a crack's tip have it so. Past them the
//! edge turns back on itself.

use slideline_diag::{Code, Diagnostic};
use slideline_model::{ElementType, NodeIndex};

use crate::draft::{Draft, Element};

/// Part of an edge by which rounding may take a node past its quarter [1].
const ROUNDING: f64 = 1e-9;

/// Warns of the first middle node of a solid that is past the quarter of its edge. What the
/// element does is sound at its integration points, or that has been said.
pub(super) fn past_the_quarter(
    element: &Element,
    row: &ElementType,
    nodes: &[NodeIndex],
    draft: &mut Draft,
) {
    if !row.cell.is_quadratic() {
        return;
    }
    let at = |own: usize| draft.model.nodes.position(nodes[own]);
    let outside = |&[first, middle, last]: &[usize; 3]| {
        let part = along(at(first), at(middle), at(last));
        part.is_some_and(|part| (part - 0.5).abs() > 0.25 + ROUNDING)
    };
    let Some(edge) = row.cell.faces.iter().flat_map(|face| edges(face)).find(outside) else {
        return;
    };
    let [first, middle, last] = edge.map(|own| draft.model.nodes.label(nodes[own]));
    let message = format!(
        "element {}: its middle node {middle} is not in the middle half between {first} and {last}",
        element.label
    );
    let warning = Diagnostic::warning(Code("SL0345"), message).at(element.origin);
    let help =
        "move it to the middle of the edge: past a quarter of it the edge turns back on itself";
    draft.log.push(warning.help(help));
}

/// The edges of a face of a quadratic cell: corner, middle, corner.
fn edges(face: &[usize]) -> Vec<[usize; 3]> {
    if let [first, middle, last] = *face {
        return vec![[first, middle, last]];
    }
    let corners = face.len() / 2;
    let edge = |own: usize| [face[own], face[corners + own], face[(own + 1) % corners]];
    (0..corners).map(edge).collect()
}

/// The part of an edge at which its middle node stands, along the line between its corners [1]; `None`:
/// the edge has no length.
fn along(first: [f64; 3], middle: [f64; 3], last: [f64; 3]) -> Option<f64> {
    let chord: [f64; 3] = std::array::from_fn(|k| last[k] - first[k]);
    let square: f64 = chord.iter().map(|part| part * part).sum();
    let reached: f64 = (0..3).map(|k| (middle[k] - first[k]) * chord[k]).sum();
    (square > 0.0).then(|| reached / square)
}
