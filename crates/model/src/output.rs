//! What the deck asks to be written.

use crate::NodeIndex;
use slideline_diag::Span;

/// Requests of one step.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct OutputRequests {
    /// `*RESTART, WRITE`: states to go on from.
    pub restart: Option<SavedStates>,
    /// Node tables.
    pub node_prints: Vec<NodePrint>,
    /// Element tables.
    pub element_prints: Vec<ElementPrint>,
    /// Contact tables.
    pub contact_prints: Vec<ContactPrint>,
    /// `*PRINT, CONTACT=YES`: contact status changes into the message file.
    pub contact_changes: bool,
}

/// `*RESTART, WRITE, FREQUENCY=N`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SavedStates {
    /// Every how many increments; the end of the step always.
    pub every: usize,
    /// `OVERLAY`: only the last state of a step is kept.
    pub overlay: bool,
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
    /// `*NODE PRINT`, `*EL PRINT`, `*CONTACT PRINT`: the printed table.
    Table,
    /// `*NODE FILE`, `*ELEMENT OUTPUT` and the like: the result files.
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

/// A table of beam results.
#[derive(Clone, Debug, PartialEq)]
pub struct ElementPrint {
    /// Name of the element set as written; empty for all beams.
    pub set: String,
    /// Labels of its beams, ascending.
    pub elements: Vec<u64>,
    /// Columns.
    pub variables: Vec<ElementVariable>,
    /// Section points of the stresses, from 1 to [`SECTION_POINTS`].
    pub section_points: Vec<usize>,
    /// Every how many increments; the last one always.
    pub frequency: usize,
    /// Where it goes.
    pub target: PrintTarget,
    /// The card.
    pub origin: Span,
}

/// Section points over the height of a beam: 1 on the side against the normal
/// that stands 90 degrees counter-clockwise of the beam's direction, 5 on the
/// side of it, evenly spaced.
pub const SECTION_POINTS: usize = 5;

/// A quantity of a beam, at its middle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ElementVariable {
    /// Axial force SF1, shear force SF2.
    SF,
    /// Bending moment SM1.
    SM,
    /// Axial strain SE1, shear strain SE2.
    SE,
    /// Curvature SK1.
    SK,
    /// Axial stress S11 at section points.
    S,
    /// Mises stress at section points 1 and 5, where there is no shear stress.
    MISES,
}

/// A table of contact results.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactPrint {
    /// Name of the node set as written; empty for all slave nodes.
    pub set: String,
    /// Its nodes.
    pub nodes: Vec<NodeIndex>,
    /// Columns.
    pub variables: Vec<ContactVariable>,
    /// Every how many increments; the last one always.
    pub frequency: usize,
    /// Where it goes.
    pub target: PrintTarget,
    /// The card.
    pub origin: Span,
}

/// A quantity of a contact point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactVariable {
    /// Pressure CPRESS and shear traction CSHEAR1.
    CSTRESS,
    /// Gap COPEN and slip CSLIP1.
    CDISP,
    /// Normal force CNORMF and shear force CSHEARF.
    CFORCE,
}
