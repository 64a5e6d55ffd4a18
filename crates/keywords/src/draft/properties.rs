//! What elements are made of from step to step, as the cards say it.

use slideline_diag::Span;

use super::sections::Yielding;
use crate::surfaces::Named;

/// What becomes of elements in a step, in the order of the cards.
#[derive(Clone, Debug)]
pub(crate) enum PropertyChange {
    /// `*CHANGE SOLID SECTION`.
    Section { set: Named, material: Named, orientation: Option<(String, Span)>, origin: Span },
    /// `*CHANGE MATERIAL` with the `*CHANGE PLASTIC` behind it; `None`: there is none.
    Material { material: Named, yielding: Option<Yielding>, origin: Span },
}
