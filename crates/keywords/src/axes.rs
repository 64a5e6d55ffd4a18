//! Axes of nodes and of materials while the deck is read.

use slideline_diag::Span;
use slideline_model::System;

use crate::instances::Target;
use crate::motion::Motion;

/// `*TRANSFORM`.
#[derive(Clone, Debug)]
pub(crate) struct Transform {
    pub set: String,
    pub set_span: Span,
    pub system: System,
    pub origin: Span,
}

/// `*ORIENTATION`.
#[derive(Clone, Debug)]
pub(crate) struct Orientation {
    pub name: String,
    pub given: Given,
    /// The axis, 0 to 2, and the angle about it [1].
    pub turn: Option<(usize, f64)>,
    /// Directions of fibres along its axes, unit vectors.
    pub directions: Vec<[f64; 3]>,
    /// Where the points stand.
    pub line: Span,
}

/// What its axes are given by.
#[derive(Clone, Debug)]
pub(crate) enum Given {
    /// Points.
    System(System),
    /// The name of the system, and nodes by their labels.
    Nodes(&'static str, [Option<u64>; 3]),
    /// Nodes of the element, from 0.
    Own([usize; 3]),
    /// The name of the system, and that of a `*DISTRIBUTION` that has the points a and b of every element.
    Distribution(&'static str, String),
}

/// `*DISTRIBUTION`: numbers of every element.
#[derive(Clone, Debug)]
pub(crate) struct Distribution {
    pub name: String,
    /// The name of its table.
    pub table: (String, Span),
    /// Numbers of elements that no line names.
    pub default: Numbers,
    pub lines: Vec<(Target, Numbers)>,
    /// Where the instance stands that has it.
    pub motion: Option<Motion>,
}

/// The numbers of a line of a `*DISTRIBUTION`, as far as axes need them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Numbers {
    pub first: [f64; 6],
    /// Where they stand.
    pub span: Span,
}

/// The system through points: of a cylinder and a sphere, a and b are those of the axis.
pub(crate) fn system_of(system: &str, [a, b, c]: [[f64; 3]; 3]) -> Option<System> {
    let from = |x: [f64; 3]| std::array::from_fn(|k| x[k] - c[k]);
    match system {
        "CYLINDRICAL" => System::cylindrical(a, b),
        "SPHERICAL" => System::spherical(a, b),
        "Z RECTANGULAR" => System::z_rectangular(from(a), from(b)),
        _ => System::rectangular(from(a), from(b)),
    }
}
