//! Stress of an element before the first step.

use crate::presence::ElementIndex;
use slideline_diag::Span;
use slideline_mech::material::tensor::Symmetric;

/// `*INITIAL CONDITIONS, TYPE=HARDENING` of an element, whose material yields.
#[derive(Clone, Debug, PartialEq)]
pub struct InitialHardening {
    /// The element.
    pub element: ElementIndex,
    /// Equivalent plastic strain [1].
    pub plastic_strain: f64,
    /// First back stress 11, 22, 33, 12, 13, 23, along the axes of the material [F/L2].
    pub back_stress: Symmetric,
    /// Where it was said.
    pub origin: Span,
}

/// `*INITIAL CONDITIONS, TYPE=STRESS` of an element. Its material must have room for it: that of
/// [`Prestressed`](slideline_mech::material::Prestressed).
#[derive(Clone, Debug, PartialEq)]
pub struct InitialStress {
    /// The element.
    pub element: ElementIndex,
    /// One of its integration points; `None`: all.
    pub point: Option<usize>,
    /// Cauchy stress 11, 22, 33, 12, 13, 23, along the axes of the material [F/L2].
    pub stress: Symmetric,
    /// Where it was said.
    pub origin: Span,
}
