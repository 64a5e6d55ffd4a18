//! What `*MODEL CHANGE` cards ask for.

use slideline_diag::Span;

use crate::instances::Target;
use crate::surfaces::Named;

/// A `*MODEL CHANGE` card.
#[derive(Clone, Debug)]
pub(crate) struct ModelChange {
    pub act: Act,
    pub of: Changed,
    pub origin: Span,
}

/// What happens to what is named.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Act {
    Remove,
    /// `ADD`: free of strain.
    Begin,
    /// `ADD=WITH STRAIN`.
    Return,
}

/// What is named.
#[derive(Clone, Debug)]
pub(crate) enum Changed {
    /// Elements and sets of them.
    Elements(Vec<(Target, Span)>),
    /// Slave and master surface of contact pairs, and the line.
    Pairs(Vec<([Named; 2], Span)>),
}
