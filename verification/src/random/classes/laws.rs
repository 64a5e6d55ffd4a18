//! Laws of contact in the range a designer would take: soft enough to be
//! found, stiff enough to stand for contact.

use super::draft::{Draft, Element, Friction, Normal, Stick};
use crate::random::Sequence;

/// Scales that the laws of a model are drawn from.
#[derive(Clone, Copy, Debug)]
pub struct Scale {
    /// Force of the contact.
    pub force: f64,
    /// Length of the structure.
    pub length: f64,
    /// Length of a contact element.
    pub element: f64,
}

/// Pressure and friction, mu up to `most`; hard contact where it may be.
pub fn draw(draft: &mut Draft, scale: Scale, (hard, most): (bool, f64), s: &mut Sequence) {
    let pressure = scale.force / (draft.width * scale.element) * s.power(0.0, 1.5);
    let clearance = scale.length * s.power(-4.5, -2.7);
    draft.normal = match s.below(4) {
        0 if hard => Normal::Hard,
        0 | 1 => Normal::Exponential(clearance, pressure),
        2 => Normal::Linear(pressure / clearance),
        _ => Normal::Tabular(vec![
            [0.0, -clearance],
            [pressure, 0.0],
            [5.0 * pressure, clearance],
            [20.0 * pressure, 2.0 * clearance],
        ]),
    };
    let mu = if s.below(3) == 0 { 0.0 } else { s.between(0.02, most) };
    let stick = match s.below(8) {
        0 => Stick::Lagrange,
        1 | 2 => Stick::ElasticSlip(scale.length * s.power(-4.5, -3.0)),
        3 => Stick::Tolerance(s.power(-3.0, -1.5)),
        4 => Stick::Limit(pressure * s.power(-1.0, 1.0)),
        5 => Stick::Decay(mu * s.between(0.7, 1.0), s.power(-1.0, 1.0) / scale.length),
        _ => Stick::Default,
    };
    draft.friction = Friction { mu, stick };
}

/// A type of beam.
pub fn element(s: &mut Sequence) -> Element {
    s.one_of(&[Element::B21, Element::B21, Element::B22, Element::B23])
}

/// First, smallest and largest increment.
pub fn increments(s: &mut Sequence) -> [f64; 3] {
    s.one_of(&[[0.05, 1e-6, 0.05], [0.02, 1e-7, 0.1], [0.1, 1e-7, 0.1], [0.01, 1e-8, 0.02]])
}
