//! Cards and lines as they were read: what they name is not yet looked up.

use super::heat::Heat;
use super::properties::PropertyChange;
use crate::changes::{FrictionChange, InterferenceCard, ModelChange, PressureChange};
use crate::distributed::Distributed;
use crate::log::Target;
use crate::surfaces::Named;
use slideline_diag::Span;
use slideline_model::{
    ContactPrint, Controls, Dof, ElementPrint, Extrapolation, Interaction, NodePrint, PrintTarget,
    ProfilePoint, SavedStates, SectionPrint, Stabilisation, Static, SurfaceSegment,
};

#[derive(Clone, Debug)]
pub(crate) struct Spring {
    pub set: String,
    pub set_span: Span,
    /// `NONLINEAR`: a table of force and relative displacement.
    pub nonlinear: bool,
    /// The numbers of its lines.
    pub lines: Vec<(Vec<f64>, Span)>,
    pub origin: Span,
}

/// A line of `*NORMAL`.
#[derive(Clone, Debug)]
pub(crate) struct Normal {
    pub elements: Target,
    pub nodes: Target,
    /// Not of length one.
    pub direction: [f64; 3],
    pub origin: Span,
}

/// `*GAP`.
#[derive(Clone, Debug)]
pub(crate) struct Gap {
    pub set: String,
    pub set_span: Span,
    /// Opening before the first step.
    pub clearance: f64,
    /// Unit vector; `None`: the line between the nodes.
    pub direction: Option<[f64; 3]>,
    /// Of the closed gap.
    pub stiffness: Option<f64>,
    /// Largest pull of CalculiX' law.
    pub tension: Option<f64>,
    pub origin: Span,
}

/// `*MASS`.
#[derive(Clone, Debug)]
pub(crate) struct PointMass {
    pub set: String,
    pub set_span: Span,
    /// Of each of its points [M].
    pub mass: f64,
    pub origin: Span,
}

/// `*RIGID SURFACE` or `*SLIDE LINE`, named by its element set.
#[derive(Clone, Debug)]
pub(crate) struct Surface {
    pub set: String,
    pub set_span: Span,
    pub shape: Shape,
    pub origin: Span,
}

#[derive(Clone, Debug)]
pub(crate) enum Shape {
    Rigid { start: ProfilePoint, segments: Vec<SurfaceSegment> },
    Line { nodes: Vec<(u64, Span)>, smooth: f64, extension: f64 },
}

#[derive(Clone, Debug)]
pub(crate) struct Interface {
    pub set: String,
    pub set_span: Span,
    pub interaction: Interaction,
}

/// A line of `*NODAL THICKNESS`.
#[derive(Clone, Debug)]
pub(crate) struct NodalThickness {
    pub target: Target,
    pub target_span: Span,
    /// Out of the plane [L].
    pub thickness: f64,
    pub origin: Span,
}

/// A line of `*BOUNDARY` or `*CLOAD`.
#[derive(Clone, Debug)]
pub(crate) struct Boundary {
    pub target: Target,
    pub target_span: Span,
    pub dofs: Vec<Dof>,
    pub value: f64,
    pub amplitude: Option<(String, Span)>,
    /// `FIXED`: it stays where the step before left it.
    pub fixed: bool,
    /// A named support such as ENCASTRE: it holds, whatever the amplitude.
    pub is_named: bool,
    pub origin: Span,
}

#[derive(Clone, Debug)]
pub(crate) struct StepDraft {
    pub title: String,
    pub nlgeom: bool,
    /// `PERTURBATION`, where it was said.
    pub perturbation: Option<Span>,
    pub max_increments: usize,
    pub unsymmetric: Option<bool>,
    pub extrapolation: Extrapolation,
    /// `AMPLITUDE=STEP`; unsaid it is that of the procedure.
    pub at_once: Option<bool>,
    pub procedure: Option<Static>,
    pub new_boundary: bool,
    pub new_loads: bool,
    /// `OP=NEW` of `*DLOAD` and of `*DSLOAD`.
    pub new_distributed: [bool; 2],
    pub distributed: Vec<Distributed>,
    pub boundary: Vec<Boundary>,
    pub loads: Vec<Boundary>,
    pub new_temperatures: bool,
    pub temperatures: Vec<Heat>,
    pub controls: Option<Controls>,
    pub restart: Option<SavedStates>,
    pub stabilisation: Option<Stabilisation>,
    pub changes: Vec<ModelChange>,
    pub frictions: Vec<FrictionChange>,
    pub pressures: Vec<PressureChange>,
    pub properties: Vec<PropertyChange>,
    pub interferences: Vec<InterferenceCard>,
    pub prints: Vec<(NodePrint, Option<Span>)>,
    pub element_prints: Vec<(ElementPrint, Option<Span>)>,
    pub contact_prints: Vec<(ContactPrint, Option<Span>)>,
    pub section_prints: Vec<(SectionPrint, Named)>,
    /// File and `FREQUENCY` of the last `*OUTPUT`, which rules the requests
    /// below it.
    pub output: Option<(PrintTarget, usize)>,
    /// How often each card wants states.
    pub states_every: Vec<usize>,
    pub contact_changes: bool,
    pub origin: Span,
}

/// Between which numbers a parameter of the deck means anything; neither is one that does.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ParameterRange {
    pub low: f64,
    pub high: f64,
    pub origin: Span,
}
