//! Amplitudes by their names.

use slideline_diag::{Code, Diagnostic, Span};

use crate::draft::Draft;
use crate::rule::Subject;

/// The amplitude of that name, by its place in the list of the model; complains where there is
/// none.
pub(super) fn amplitude((name, span): &(String, Span), draft: &mut Draft) -> Option<usize> {
    let list = &draft.model.amplitudes;
    let found = list.iter().rposition(|amplitude| amplitude.name == *name);
    if found.is_none() {
        let mut error =
            Diagnostic::error(Code("SL0321"), format!("there is no amplitude {name}")).at(*span);
        let names = list.iter().map(|amplitude| amplitude.name.as_str());
        if let Some(near) = slideline_deck::nearest(name, names) {
            error = error.help(format!("did you mean {near}?"));
        }
        draft.consequence(Subject::Amplitudes, error);
    }
    found
}
