//! What `*MODEL CHANGE` cards ask for.

use slideline_diag::Span;
use slideline_model::Interaction;

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

/// A `*CHANGE FRICTION` card with the law that follows it.
#[derive(Clone, Debug)]
pub(crate) struct FrictionChange {
    pub of: FrictionOf,
    /// `RESET`: the law of the model again.
    pub reset: bool,
    /// What a `*FRICTION` behind it fills in.
    pub interaction: Interaction,
}

/// A `*CHANGE SURFACE BEHAVIOR` card with the law that follows it.
#[derive(Clone, Debug)]
pub(crate) struct PressureChange {
    /// The surface interaction.
    pub of: Named,
    /// What a `*SURFACE BEHAVIOR` behind it fills in.
    pub interaction: Interaction,
}

/// A data line of `*CONTACT INTERFERENCE`.
#[derive(Clone, Debug)]
pub(crate) struct InterferenceCard {
    pub slave: Named,
    pub master: Named,
    /// [L]; none: `SHRINK`.
    pub value: Option<f64>,
    pub amplitude: Option<(String, Span)>,
    /// The data line.
    pub origin: Span,
}

/// Whose friction changes.
#[derive(Clone, Debug)]
pub(crate) enum FrictionOf {
    /// All pairs of a `*SURFACE INTERACTION`.
    Interaction(Named),
    /// The pair of an `*INTERFACE`.
    Elements(Named),
}
