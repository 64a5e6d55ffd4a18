//! What the deck asks to be written.

use crate::NodeIndex;
use slideline_diag::Span;

/// Requests of one step.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct OutputRequests {
    /// `*RESTART, WRITE, FREQUENCY=N`: write the state every N increments.
    pub restart_every: Option<usize>,
    /// Node tables.
    pub node_prints: Vec<NodePrint>,
    /// `*PRINT, CONTACT=YES`: contact status changes into the message file.
    pub contact_changes: bool,
}

/// A table of nodal values.
#[derive(Clone, Debug, PartialEq)]
pub struct NodePrint {
    /// Name of the node set as written; empty for all nodes.
    pub set: String,
    /// Its nodes.
    pub nodes: Vec<NodeIndex>,
    /// Columns.
    pub variables: Vec<NodeVariable>,
    /// Every how many increments; the last one always.
    pub frequency: usize,
    /// Where it goes.
    pub target: PrintTarget,
    /// The card.
    pub origin: Span,
}

/// Which file a request is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PrintTarget {
    /// `*NODE PRINT`: the printed table.
    Table,
    /// `*NODE FILE`, `*NODE OUTPUT`: the result files.
    File,
}

/// A nodal quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NodeVariable {
    /// Displacements and rotations.
    U,
    /// Reactions.
    RF,
    /// Applied loads.
    CF,
    /// Current coordinates.
    COORD,
}
