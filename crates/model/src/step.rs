//! Steps: what is prescribed, and how the way there is walked.

use crate::controls::Controls;
use crate::element::section::Section;
use crate::friction::Friction;
use crate::load::{Distributed, Load};
use crate::node::{Dof, NodeIndex};
use crate::output::OutputRequests;
use crate::presence::Presence;
use crate::stabilisation::Stabilisation;
use slideline_diag::Span;
use slideline_mech::contact::normal::NormalLaw;
use slideline_mech::element::Temperature;

/// One step of the history. Boundary conditions and loads are listed whole:
/// what `OP=MOD` kept from the step before stands here again, and a load that ramps off stands here
/// with the value zero. A load that no load continues ends with its step.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// Title lines, joined by line feeds.
    pub title: String,
    /// Whether kinematics are nonlinear.
    pub nlgeom: bool,
    /// `INC`: largest number of increments.
    pub max_increments: usize,
    /// `UNSYMM=YES|NO`, where said.
    pub unsymmetric: Option<bool>,
    /// First guess of an increment.
    pub extrapolation: Extrapolation,
    /// `AMPLITUDE=STEP`: values without an amplitude of their own act at once.
    pub at_once: bool,
    /// Time and increments.
    pub procedure: Static,
    /// Prescribed motions at the end of the step.
    pub prescribed: Vec<Prescribed>,
    /// Concentrated loads at the end of the step.
    pub loads: Vec<Load>,
    /// Loads on faces and volumes at the end of the step.
    pub distributed: Distributed,
    /// Temperatures at the end of the step; other nodes have those before the first step then.
    pub temperatures: Vec<NodalTemperature>,
    /// Tolerances and limits.
    pub controls: Controls,
    /// Elements and contact pairs that are absent, and elements that begin.
    pub presence: Presence,
    /// Friction of contact pairs that is not that of their interactions, by ascending pairs.
    pub frictions: Vec<ChangedFriction>,
    /// Pressure laws of contact pairs that are not those of their interactions, by ascending pairs.
    pub pressures: Vec<ChangedPressure>,
    /// Sections of blocks that are not those of the model, by ascending blocks.
    pub sections: Vec<ChangedSection>,
    /// Overclosures of contact pairs that are taken away over the step.
    pub interferences: Vec<Interference>,
    /// Stabilisation of contact, where the deck asks for it.
    pub stabilisation: Option<Stabilisation>,
    /// What to write.
    pub output: OutputRequests,
    /// The `*STEP` card.
    pub origin: Span,
}

/// `EXTRAPOLATION`: the first guess of an increment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Extrapolation {
    /// The last increment again, scaled with time.
    #[default]
    Linear,
    /// A parabola through the last three states.
    Parabolic,
    /// The last state.
    None,
}

/// `*STATIC` and `*VISCO`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Static {
    /// First increment [T].
    pub initial: f64,
    /// Length of the step [T].
    pub period: f64,
    /// Smallest increment [T].
    pub minimum: f64,
    /// Largest increment [T].
    pub maximum: f64,
    /// `DIRECT`: increments of fixed size.
    pub direct: bool,
    /// What time means to the materials.
    pub passage: Passage,
    /// `CETOL`: by how much the creep strains of an increment may differ, taken by the conditions
    /// at its two ends [1].
    pub creep_tolerance: Option<f64>,
    /// The card, where there is one.
    pub origin: Option<Span>,
}

/// What the time of a step means to materials that creep or relax.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Passage {
    /// Nothing: they answer instantaneously.
    #[default]
    Still,
    /// It passes.
    Passing,
    /// All time there is: what relaxes has relaxed.
    LongTerm,
}

impl Passage {
    /// Time that passes for the materials in an increment [T].
    pub fn of(self, dt: f64) -> f64 {
        match self {
            Self::Still => 0.0,
            Self::Passing => dt,
            Self::LongTerm => f64::INFINITY,
        }
    }
}

/// Friction of a contact pair in a step.
#[derive(Clone, Debug, PartialEq)]
pub struct ChangedFriction {
    /// The pair, by its place in the model.
    pub pair: usize,
    /// The law at the end of the step before; its coefficients lead to those of the law of this
    /// step over the step, unless values act at once.
    pub from: Friction,
    /// The law of this step.
    pub to: Friction,
    /// Where it was said.
    pub origin: Span,
}

/// The pressure law of a contact pair in a step, from its beginning on.
#[derive(Clone, Debug, PartialEq)]
pub struct ChangedPressure {
    /// The pair, by its place in the model.
    pub pair: usize,
    /// Overclosure to pressure.
    pub normal: NormalLaw,
    /// Whether what has closed stays closed.
    pub no_separation: bool,
    /// Where it was said.
    pub origin: Span,
}

/// Section and material of a block in a step, from its beginning on. State variables go on with
/// them: a material that keeps others is no successor.
#[derive(Clone, Debug, PartialEq)]
pub struct ChangedSection {
    /// The block, by its place in the model.
    pub block: usize,
    /// What its elements are made of.
    pub section: Section,
    /// Where it was said.
    pub origin: Span,
}

/// `*CONTACT INTERFERENCE`: an overclosure that a contact pair is allowed, and that a step takes
/// away.
#[derive(Clone, Debug, PartialEq)]
pub struct Interference {
    /// The pair, by its place in the model.
    pub pair: usize,
    /// What is allowed when the step begins.
    pub allowed: Allowed,
    /// Amplitude of what is allowed, by place in the model's list; without one it goes to zero
    /// straight over the step.
    pub amplitude: Option<usize>,
    /// Where it was said.
    pub origin: Span,
}

/// An overclosure that is allowed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Allowed {
    /// `SHRINK`: what every point has in the undeformed model.
    Initial,
    /// The same everywhere [L].
    Value(f64),
}

/// A prescribed motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Prescribed {
    /// Node.
    pub node: NodeIndex,
    /// Degree of freedom.
    pub dof: Dof,
    /// Value at the end of the step [L or 1]; with an amplitude, its factor.
    pub value: f64,
    /// Amplitude by place in the model's list; without one the value is
    /// approached linearly from the step before.
    pub amplitude: Option<usize>,
    /// `FIXED`: it stays where the step before left it, and the value counts for nothing.
    pub fixed: bool,
    /// Where it was said.
    pub origin: Span,
}

impl Prescribed {
    /// Whether it asks for any motion.
    pub fn moves(&self) -> bool {
        self.value != 0.0 && !self.fixed
    }
}

/// A temperature of a node.
#[derive(Clone, Debug, PartialEq)]
pub struct NodalTemperature {
    /// Node.
    pub node: NodeIndex,
    /// Value at the end of the step; with an amplitude, its factor.
    pub temperature: Temperature,
    /// Amplitude by place in the model's list; without one the value is
    /// approached linearly from the step before.
    pub amplitude: Option<usize>,
    /// Where it was said.
    pub origin: Span,
}
