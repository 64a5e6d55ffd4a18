//! A slave face in a configuration, with the curves that it may face.
//!
//! ```text
//!     before  own[0]   own[1]  own[2]  after      places in one list: these,
//!        x------o---------x------o-------x        then three for every curve
//! ```

use super::curve::{Curve, MOST_CONTROLS, Place, add_scaled, scale, sub};
use super::normals::MeanNormal;
use super::reference::Reference;
use crate::differentiate::Real;

/// Where the places of the first curve begin in the list of all: behind those of the slave.
pub const FIRST_MASTER: usize = 6;
/// Where the own control points of a face begin.
pub(super) const OWN: usize = 1;
/// The control point behind the face.
pub(super) const AFTER: usize = 4;

/// Control points of a slave face and of its neighbours.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FacePlaces<R> {
    /// The last control point but its own of the face before, where the surface goes on smoothly [L].
    pub before: Option<Place<R>>,
    /// Its own [L].
    pub own: [Place<R>; MOST_CONTROLS],
    /// The next one of the face behind, likewise [L].
    pub after: Option<Place<R>>,
}

/// A slave face with the curves that may face it.
#[derive(Debug, Clone, Copy)]
pub struct MortarFace<'a, R> {
    /// The face, undeformed.
    pub reference: &'a Reference,
    /// Its control points.
    pub places: &'a FacePlaces<R>,
    /// The curves.
    pub curves: &'a [Curve<R>],
}

impl MortarFace<'_, f64> {
    /// Its length from end to end [L].
    pub fn length(&self) -> f64 {
        let [first, last] = [0, 1].map(|end| self.curve().end(end));
        let [x, y] = sub(last, first);
        x.hypot(y)
    }
}

impl<R: Real> MortarFace<'_, R> {
    /// The face as a curve.
    pub fn curve(&self) -> Curve<R> {
        Curve { controls: self.places.own, count: self.reference.count(), weight: 1.0 }
    }

    /// Normals at both ends; `None` where the face has collapsed.
    pub fn end_normals(&self) -> Option<[MeanNormal<R>; 2]> {
        let FacePlaces { before, own, after } = self.places;
        let last = self.reference.count() - 1;
        let first_leg = before.map(|before| sub(own[0], before));
        let last_leg = after.map(|after| sub(after, own[last]));
        Some([
            MeanNormal::new([first_leg, Some(sub(own[1], own[0]))])?,
            MeanNormal::new([Some(sub(own[last], own[last - 1])), last_leg])?,
        ])
    }

    /// Normal at a middle node: across the chord.
    pub fn middle_normal(&self) -> Option<MeanNormal<R>> {
        let own = &self.places.own;
        MeanNormal::new([Some(sub(own[self.reference.count() - 1], own[0])), None])
    }

    /// Adds derivatives by the normal at one end (0 or 1) to those by places.
    pub(super) fn pull_end(
        &self,
        end: usize,
        normal: &MeanNormal<R>,
        by_normal: Place<R>,
        into: &mut [Place<R>],
    ) {
        let last = OWN + self.reference.count() - 1;
        let [first, second] = normal.pull(by_normal);
        let nodes = if end == 0 { [0, OWN, OWN + 1] } else { [last - 1, last, AFTER] };
        add_leg(into, [nodes[0], nodes[1]], first);
        add_leg(into, [nodes[1], nodes[2]], second);
    }

    /// The same for the normal at the middle node.
    pub(super) fn pull_middle(
        &self,
        normal: &MeanNormal<R>,
        by_normal: Place<R>,
        into: &mut [Place<R>],
    ) {
        let last = OWN + self.reference.count() - 1;
        add_leg(into, [OWN, last], normal.pull(by_normal)[0]);
    }
}

fn add_leg<R: Real>(into: &mut [Place<R>], [from, to]: [usize; 2], by: Place<R>) {
    let one = R::from_f64(1.0);
    into[from] = add_scaled(into[from], -one, by);
    into[to] = add_scaled(into[to], one, by);
}

/// The normal field at a parameter, between those at the ends [1].
pub(super) fn field<R: Real>(ends: &[MeanNormal<R>; 2], t: R) -> Place<R> {
    let rest = R::from_f64(1.0) - t;
    add_scaled(scale(rest, ends[0].normal), t, ends[1].normal)
}

/// How the field turns along the face [1].
pub(super) fn field_slope<R: Real>(ends: &[MeanNormal<R>; 2]) -> Place<R> {
    sub(ends[1].normal, ends[0].normal)
}

/// A place of space in the plane.
fn flat([x, y, _]: [f64; 3]) -> Place<f64> {
    [x, y]
}

impl FacePlaces<f64> {
    /// Control points of a face, with those of its neighbours [L].
    pub fn new(before: Option<[f64; 3]>, own: &[[f64; 3]], after: Option<[f64; 3]>) -> Self {
        let own = std::array::from_fn(|k| own.get(k).copied().map_or([0.0; 2], flat));
        Self { before: before.map(flat), own, after: after.map(flat) }
    }
}

impl Curve<f64> {
    /// The curve over two or three control points [L].
    pub fn new(controls: &[[f64; 3]], weight: f64) -> Self {
        let place = std::array::from_fn(|k| controls.get(k).copied().map_or([0.0; 2], flat));
        Self { controls: place, count: controls.len().clamp(2, MOST_CONTROLS), weight }
    }
}
