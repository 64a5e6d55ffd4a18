//! Sets that nobody defined.

use slideline_diag::{Code, Diagnostic, Span};

/// What is said of a name that is no set of that kind, with the nearest one.
pub(crate) fn unknown_set<'a>(
    kind: &str,
    set: &str,
    span: Span,
    known: impl Iterator<Item = &'a str>,
) -> Diagnostic {
    let message = format!("there is no {kind} set {set}");
    let error = Diagnostic::error(Code(if kind == "node" { "SL0304" } else { "SL0308" }), message);
    let error = error.at(span);
    match slideline_deck::nearest(set, known) {
        Some(near) => error.help(format!("did you mean {near}?")),
        None => error,
    }
}

/// What helps where an element set is named in the place of a node set.
pub(crate) fn nodes_of_elements(set: &str) -> String {
    format!("{set} is an element set: *NSET, NSET={set}, ELSET={set} makes a set of its nodes")
}
