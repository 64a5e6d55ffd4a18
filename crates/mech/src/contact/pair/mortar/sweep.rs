//! Second derivatives: the gradient swept over all places.
//!
//! ```text
//!   places x seeds, three places at a time --> force, columns of its derivative
//! ```

use super::curve::{Curve, MOST_CONTROLS, Place};
use super::face::{AFTER, FIRST_MASTER, FacePlaces, MortarFace, OWN};
use super::integrals::{Integrals, Segment, Shares};
use super::pull::Direction;
use crate::first_order::First;

/// Directions of a sweep: those of three places.
const WIDE: usize = 2 * MOST_CONTROLS;
type Number = First<WIDE>;

/// A force on the places of a face with its derivative.
#[derive(Debug, Clone, Default)]
pub struct FaceTangent {
    /// The force, a place each [F].
    pub force: Vec<Place<f64>>,
    /// Its derivative, square, by component [F/L].
    pub derivative: Vec<f64>,
}

/// Room for a sweep.
#[derive(Debug, Clone, Default)]
pub struct SweepRoom {
    curves: Vec<Curve<Number>>,
    integrals: Integrals<Number>,
    force: Vec<Place<Number>>,
}

impl SweepRoom {
    /// The force of a node of a face and its derivative: `pressure` times the gradient of weighted
    /// overclosure less `overclosure` times the area, and `traction` times the direction of its drag
    /// [F/L2, L].
    pub fn tangent(
        &mut self,
        (face, segments): (&MortarFace<'_, f64>, &[Segment]),
        shares: Shares,
        (pressure, overclosure, traction): (f64, f64, f64),
        into: &mut FaceTangent,
    ) {
        let places = FIRST_MASTER + MOST_CONTROLS * face.curves.len();
        let columns = 2 * places;
        into.force.clear();
        into.force.resize(places, [0.0; 2]);
        into.derivative.clear();
        into.derivative.resize(columns * columns, 0.0);
        for first in (0..places).step_by(MOST_CONTROLS) {
            self.sweep((face, segments), shares, (pressure, overclosure, traction), first);
            for (place, force) in self.force.iter().enumerate() {
                into.force[place] = force.map(|own| own.value);
                for (axis, own) in force.iter().enumerate() {
                    let row = (2 * place + axis) * columns + 2 * first;
                    into.derivative[row..][..WIDE].copy_from_slice(&own.gradient);
                }
            }
        }
    }

    /// The force with its derivatives by three places.
    fn sweep(
        &mut self,
        (face, segments): (&MortarFace<'_, f64>, &[Segment]),
        shares: Shares,
        (pressure, overclosure, traction): (f64, f64, f64),
        first: usize,
    ) {
        let seeded = |place: usize, at: Place<f64>| -> Place<Number> {
            let axis = |axis: usize| match place.checked_sub(first) {
                Some(own) => Number::variable(at[axis], 2 * own + axis),
                None => Number::constant(at[axis]),
            };
            [axis(0), axis(1)]
        };
        let FacePlaces { before, own, after } = face.places;
        let places = FacePlaces {
            before: before.map(|at| seeded(0, at)),
            own: std::array::from_fn(|k| seeded(OWN + k, own[k])),
            after: after.map(|at| seeded(AFTER, at)),
        };
        self.curves.clear();
        self.curves.extend(face.curves.iter().enumerate().map(|(k, curve)| {
            let place = |control: usize| FIRST_MASTER + MOST_CONTROLS * k + control;
            let controls = std::array::from_fn(|c| seeded(place(c), curve.controls[c]));
            Curve { controls, count: curve.count, weight: curve.weight }
        }));
        let face = MortarFace { reference: face.reference, places: &places, curves: &self.curves };
        self.force.clear();
        self.force
            .resize(FIRST_MASTER + MOST_CONTROLS * self.curves.len(), [Number::constant(0.0); 2]);
        if !self.integrals.take(&face, segments) {
            return;
        }
        let [nothing, normal, area] =
            [0.0, pressure, -pressure * overclosure].map(Number::constant);
        let direction = Direction { normal, tangent: nothing, area };
        self.integrals.pull((&face, segments), shares, &direction, &mut self.force);
        if traction != 0.0 {
            let traction = Number::constant(traction);
            self.integrals.drag((&face, segments), shares, traction, &mut self.force);
        }
    }
}
