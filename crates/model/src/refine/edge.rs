//! What is halved: the edge between two nodes; and the refusals where that is not possible.

use crate::node::NodeIndex;
use slideline_diag::{Code, Diagnostic, Span};

/// A mesh that cannot be halved.
const NOT_HALVED: Code = Code("SL0602");

/// Two nodes in either order.
pub(super) type Edge = [NodeIndex; 2];

/// The edge between two nodes.
pub(super) fn edge([a, b]: [NodeIndex; 2]) -> Edge {
    [a.min(b), a.max(b)]
}

/// Refuses to halve where nobody knows what lies between two nodes, given by their labels.
pub(super) fn refusal([a, b]: [u64; 2], reason: &str, origin: Span) -> Box<Diagnostic> {
    let message = format!(
        "the mesh cannot be halved: what lies between nodes {a} and {b} is not known, since {reason}"
    );
    Box::new(Diagnostic::error(NOT_HALVED, message).at(origin).help(
        "Run without error bars, or run decks of two meshes and compare. Contact elements can \
         be halved on beams and on rigid rims that are circular or straight.",
    ))
}

/// Refuses elements of a type that has no rule.
pub(super) fn unknown_cell(word: &str, origin: Span) -> Box<Diagnostic> {
    let message = format!("the mesh cannot be halved: elements of type {word} have no rule for it");
    let help = "Run without error bars, or run decks of two meshes and compare.";
    Box::new(Diagnostic::error(NOT_HALVED, message).at(origin).help(help))
}
