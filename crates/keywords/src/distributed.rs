//! Distributed loads as cards give them.

use slideline_diag::Span;

use crate::instances::Target;
use crate::surfaces::Named;

/// A line of `*DLOAD` or `*DSLOAD`.
#[derive(Clone, Debug)]
pub(crate) struct Distributed {
    pub on: On,
    pub kind: Kind,
    pub value: f64,
    pub amplitude: Option<(String, Span)>,
    pub origin: Span,
}

/// What is loaded.
#[derive(Clone, Debug)]
pub(crate) enum On {
    /// An element or a set of elements.
    Elements(Target, Span),
    /// A surface.
    Surface(Named),
}

/// How it is loaded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Kind {
    /// Pressure on a face, from 0; of a surface on all its faces.
    Pressure(Option<usize>),
    /// Traction of this direction.
    Traction([f64; 3]),
    /// Force per volume along an axis.
    Body(usize),
    /// Acceleration of this direction.
    Gravity([f64; 3]),
    /// Turning about an axis: a point of it and its unit direction; the value is omega squared.
    Centrifugal([f64; 3], [f64; 3]),
}

impl Kind {
    /// Loads of one kind replace one another: its number, and the face.
    pub fn key(self) -> (u8, usize) {
        match self {
            Self::Pressure(face) => (0, face.map_or(0, |face| face + 1)),
            Self::Traction(_) => (1, 0),
            Self::Body(axis) => (2, axis),
            Self::Gravity(_) => (3, 0),
            Self::Centrifugal(..) => (4, 0),
        }
    }
}
