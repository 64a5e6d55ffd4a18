//! Distributed loads as cards give them.

use slideline_diag::Span;
use slideline_mech::traction::Follows;
use slideline_model::Dialect;

use crate::instances::Target;
use crate::surfaces::Named;

/// A line of `*DLOAD` or `*DSLOAD`.
#[derive(Clone, Debug)]
pub(crate) struct Distributed {
    pub on: On,
    pub kind: Kind,
    /// The face of the elements, from 0; of a surface all its faces.
    pub face: Option<usize>,
    pub value: f64,
    pub amplitude: Option<(String, Span)>,
    /// Name of the axes in which its direction is given; `None`: those of the model.
    pub axes: Option<(String, Span)>,
    /// What a traction does when its face moves.
    pub follows: Follows,
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
    /// Pressure on a face, or along an axis of the section of a beam.
    Pressure,
    /// Traction of this direction.
    Traction([f64; 3]),
    /// Traction along a face, where this direction points when it is laid onto it.
    Shear([f64; 3]),
    /// Force per length of a line along an axis of the model, 0 to 2.
    Line(usize),
    /// Force per volume.
    Body(Along),
    /// Acceleration of this direction.
    Gravity([f64; 3]),
    /// Turning about an axis: a point of it and its unit direction; the value is omega squared.
    Centrifugal([f64; 3], [f64; 3]),
}

/// The direction of a force per volume: BX, BY, BZ, BR.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Along {
    X,
    Y,
    Z,
    Radius,
}

/// What tells one load of an element from another: those of one key replace one another from step
/// to step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Key {
    /// Given to a surface, which CalculiX does not tell from the faces of its elements.
    pub of_surface: bool,
    what: What,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum What {
    Pressure(usize),
    Traction(usize),
    Shear(usize),
    Line(usize),
    Body(Along),
    Gravity([u64; 3]),
    Centrifugal([u64; 3], [u64; 3]),
}

impl Distributed {
    /// A load as its line says it; what its card says is added.
    pub fn new(on: On, (kind, face): (Kind, Option<usize>), value: f64, origin: Span) -> Self {
        let follows = Follows { turns: true, grows: true };
        Self { on, kind, face, value, amplitude: None, axes: None, follows, origin }
    }

    /// Its key on an element, with the number of the face. CalculiX tells gravities and turnings
    /// apart by their directions, Abaqus by their labels alone.
    pub fn key(&self, face: usize, dialect: Dialect) -> Key {
        let directed = dialect == Dialect::Calculix;
        let bits =
            |vector: [f64; 3]| vector.map(|x| if directed { (x + 0.0).to_bits() } else { 0 });
        let what = match self.kind {
            Kind::Pressure => What::Pressure(face),
            Kind::Traction(_) => What::Traction(face),
            Kind::Shear(_) => What::Shear(face),
            Kind::Line(axis) => What::Line(axis),
            Kind::Body(along) => What::Body(along),
            Kind::Gravity(direction) => What::Gravity(bits(direction)),
            Kind::Centrifugal(point, axis) => What::Centrifugal(bits(point), bits(axis)),
        };
        Key { of_surface: !directed && matches!(self.on, On::Surface(_)), what }
    }
}
