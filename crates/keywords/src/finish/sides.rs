//! Both sides of a contact pair while it is put together.

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{ContactElement, ContactFace, Master, NodeIndex};

use super::surfaces::Found;
use crate::draft::Draft;
use crate::rule::Subject;
use crate::surfaces::NamedSurface;

/// Both surfaces of a pair.
pub(super) struct Sides {
    pub slave: NamedSurface,
    pub master: NamedSurface,
}

/// Whether a side is made of faces of solids.
pub(super) fn is_of_solids(side: &Found) -> bool {
    match side {
        Found::Facets(facets) => facets.iter().any(|facet| facet.face.is_some()),
        Found::Faces(_) => true,
        _ => false,
    }
}

/// What carries the points of a pair.
#[derive(Default)]
pub(super) struct Slaves {
    pub elements: Vec<ContactElement>,
    pub faces: Vec<ContactFace>,
    /// The nodes of the faces that are slaves; empty: all.
    pub nodes: Vec<NodeIndex>,
}

pub(super) type Parts = Option<(Slaves, Master)>;

/// Says why the sides make no pair.
pub(super) fn refuse(
    span: Span,
    message: impl Into<String>,
    help: &str,
    draft: &mut Draft,
) -> Parts {
    let error = Diagnostic::error(Code("SL0332"), message).at(span);
    draft.consequence(Subject::Contact, error.help(help));
    None
}
