//! Where the reading of a deck stands among its parts.
//!
//! ```text
//!   *PART ... *END PART     *ASSEMBLY   *INSTANCE ... *END INSTANCE   *END ASSEMBLY
//!   contents of its own     the deck    contents of its own           the deck
//! ```

use slideline_diag::Span;

use crate::motion::Motion;

/// `*PART`, closed.
pub(crate) struct Part<C> {
    pub name: String,
    pub contents: C,
    pub origin: Span,
    pub instances: usize,
}

/// A part or an instance that is being read.
pub(crate) struct Open<C> {
    pub kind: Kind,
    pub name: String,
    /// What was read around it.
    pub outer: C,
    pub origin: Span,
}

pub(crate) enum Kind {
    Part,
    Instance(Motion),
}

/// Parts, and where the reading stands among them.
pub(crate) struct Parts<C> {
    pub list: Vec<Part<C>>,
    pub open: Option<Open<C>>,
    pub assembly: Assembly,
}

#[derive(Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum Assembly {
    #[default]
    None,
    Open(Span),
    Closed,
}

impl<C> Default for Parts<C> {
    fn default() -> Self {
        Self { list: Vec::new(), open: None, assembly: Assembly::default() }
    }
}
