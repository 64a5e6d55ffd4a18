//! Profile of a rigid surface, as a designer changes it: angles of its flanks, radii of its corners and
//! arcs, its place.
//!
//! ```text
//!            V2 ______ V3             written: START, LINE, CIRCL, LINE, ...
//!            .-'      '-.             understood: corners V joined by flanks, an arc that is tangent
//!   flank  .'            '.           to the flanks on both its sides being the rounding of a corner
//!     V1 -'                '- V4
//! ```
//!
//! What is written is moved by what the drawing of these values differs from the drawing of the
//! deck's values: the deck's own values give the deck's own numbers, whatever they are rounded to.

use crate::drawing::{Drawing, Piece, Segment, Swing};
use crate::plane::{Point, cross, distance, minus, turned};

/// Least angle between neighbours that meet at a point [rad].
const MEETS: f64 = 1e-3;
/// More straight flanks than this are a curve that is given by points.
const FLANKS: usize = 8;

/// What may be changed of a profile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Kind {
    /// Angle of a flank to the first axis [degrees].
    Angle(usize),
    /// Radius of the corners that are rounded by this much.
    Fillet,
    /// Radius of an arc.
    Radius(usize),
    /// What is added along an axis.
    Shift(usize),
}

/// A number of a profile that may be changed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Handle {
    pub kind: Kind,
    /// The deck's.
    pub value: f64,
}

/// A profile that was read.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Profile {
    /// Coordinates in the order in which they are written.
    pub written: Vec<f64>,
    drawing: Drawing,
    /// What may be changed of it.
    pub handles: Vec<Handle>,
}

impl Profile {
    /// That of the segments that are written behind a start.
    /// `shifts`: whether it lies in the plane of the model, and may be moved there.
    pub fn of(start: Point, segments: &[Segment], shifts: bool) -> Self {
        let mut written = start.to_vec();
        for own in segments {
            written.extend(match *own {
                Segment::Line(end) => end.to_vec(),
                Segment::Arc(end, centre) => [end, centre].concat(),
                Segment::Parabola(middle, end) => [middle, end].concat(),
            });
        }
        let drawing = Drawing::of(start, segments);
        let mut own = Self { written, drawing, handles: Vec::new() };
        own.handles = own.found(shifts);
        own
    }

    fn found(&self, shifts: bool) -> Vec<Handle> {
        let Drawing { corners, pieces, radii, .. } = &self.drawing;
        let mut handles = Vec::new();
        let flanks = pieces.iter().filter(|own| **own == Piece::Flank).count();
        for (place, ends) in corners.windows(2).enumerate() {
            let value = match &pieces[place] {
                Piece::Flank if flanks <= FLANKS && self.swing(place).is_some() => {
                    let value = inclination(minus(ends[1], ends[0]));
                    Handle { kind: Kind::Angle(place), value }
                }
                Piece::Arc(points) if !self.drawing.closed || pieces.len() == 1 => {
                    let value = rounded(distance(ends[0], points[0]));
                    Handle { kind: Kind::Radius(place), value }
                }
                _ => continue,
            };
            handles.push(value);
        }
        let mut known: Vec<f64> = Vec::new();
        for radius in radii.iter().filter(|own| **own > 0.0) {
            if !known.iter().any(|own| is_same(*own, *radius)) {
                known.push(rounded(*radius));
                handles.push(Handle { kind: Kind::Fillet, value: rounded(*radius) });
            }
        }
        if shifts {
            handles.extend([0, 1].map(|axis| Handle { kind: Kind::Shift(axis), value: 0.0 }));
        }
        handles
    }

    /// How a flank turns; `None`: it cannot.
    fn swing(&self, place: usize) -> Option<Swing> {
        let (last, drawing) = (self.drawing.pieces.len() - 1, &self.drawing);
        let around =
            |place: usize| if self.drawing.closed { Some(place % (last + 1)) } else { None };
        let next = if place < last { Some(place + 1) } else { around(place + 1) };
        let before = if place > 0 { Some(place - 1) } else { around(place + last) };
        let slides = |other: Option<usize>| {
            let other = other.filter(|own| *own != place)?;
            let [own, along] = [place, other].map(|own| drawing.direction(own));
            let meets = drawing.pieces[other] == Piece::Flank && cross(own, along).abs() > MEETS;
            meets.then_some(other)
        };
        match (before, next) {
            (None, Some(_)) => Some(Swing::Start),
            (_, None) => Some(Swing::End),
            _ => match (slides(next), slides(before)) {
                (Some(along), _) => Some(Swing::EndAlong(along)),
                (None, Some(along)) => Some(Swing::StartAlong(along)),
                (None, None) => None,
            },
        }
    }

    /// Which of the written segments a flank is, from 1.
    pub fn line(&self, flank: usize) -> usize {
        let drawing = &self.drawing;
        let written = |place: usize| match &drawing.pieces[place] {
            Piece::Flank => 1 + usize::from(drawing.radii[place + 1] > 0.0),
            Piece::Arc(points) => points.len().div_ceil(2),
            Piece::Parabola(_) => 1,
        };
        1 + (0..flank).map(written).sum::<usize>()
    }

    /// Smallest and largest coordinate along an axis.
    pub fn ends(&self, axis: usize) -> [f64; 2] {
        let along = self.drawing.corners.iter().map(|own| own[axis]);
        along.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], own| {
            [low.min(own), high.max(own)]
        })
    }

    /// Coordinates in the order in which they are written, for values of the handles. `Err`: there is
    /// no such profile.
    pub fn moved(&self, values: &[f64]) -> Result<Vec<f64>, &'static str> {
        let deck: Vec<f64> = self.handles.iter().map(|own| own.value).collect();
        let mut moved = self.written.clone();
        let shape = |own: &Handle| !matches!(own.kind, Kind::Shift(_));
        let pairs = || self.handles.iter().zip(values);
        if pairs().any(|(own, value)| shape(own) && own.value != *value) {
            let (new, old) = (self.drawn(values)?, self.drawn(&deck)?);
            for (own, (new, old)) in moved.iter_mut().zip(new.iter().zip(old)) {
                *own += new - old;
            }
        }
        for (own, value) in pairs() {
            if let Kind::Shift(axis) = own.kind {
                moved.iter_mut().skip(axis).step_by(2).for_each(|own| *own += value);
            }
        }
        Ok(moved)
    }

    fn drawn(&self, values: &[f64]) -> Result<Vec<f64>, &'static str> {
        let mut drawing = self.drawing.clone();
        for (own, value) in self.handles.iter().zip(values) {
            match own.kind {
                Kind::Fillet | Kind::Radius(_) if *value <= 0.0 => {
                    return Err("a radius is positive");
                }
                Kind::Fillet => {
                    let radii = drawing.radii.iter_mut().zip(&self.drawing.radii);
                    for (radius, _) in radii.filter(|(_, deck)| is_same(**deck, own.value)) {
                        *radius = *value;
                    }
                }
                Kind::Radius(place) => drawing.widen(place, value / own.value),
                Kind::Angle(place) => {
                    if let Some(swing) = self.swing(place) {
                        drawing.turn(place, swing, (value - own.value).to_radians());
                    }
                }
                Kind::Shift(_) => {}
            }
        }
        drawing.written(&self.directions(values))
    }

    /// Directions of the flanks, which show whether one is turned over.
    fn directions(&self, values: &[f64]) -> Vec<Point> {
        let mut all: Vec<Point> =
            (0..self.drawing.pieces.len()).map(|own| self.drawing.direction(own)).collect();
        for (own, value) in self.handles.iter().zip(values) {
            if let Kind::Angle(place) = own.kind {
                all[place] = turned(all[place], (value - own.value).to_radians());
            }
        }
        all
    }
}

/// Whether radii are one, as decks are rounded.
fn is_same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-4 * b.abs()
}

/// Angle of a line to the first axis, from -90 to 90 degrees, to a ten-thousandth.
fn inclination([x, y]: Point) -> f64 {
    let angle = y.atan2(x).to_degrees();
    let angle = (1e4 * angle).round() / 1e4;
    let angle = if angle > 90.0 { angle - 180.0 } else { angle };
    // a whole turn is none, and zero has no sign
    if angle <= -90.0 { angle + 180.0 } else { angle + 0.0 }
}

/// A size to seven digits.
fn rounded(value: f64) -> f64 {
    format!("{value:.6e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::expect_used)] // a test may fail where it stands

    use super::*;
    use crate::plane::{plus, times};
    use Segment::{Arc, Line, Parabola};

    /// A catch with lines before and behind it; one with rounded corners; a ball; a ski; a finger; a
    /// closed wedge; a cam that ends in a parabola.
    fn shapes() -> Vec<(Point, Vec<Segment>)> {
        let rounded = vec![
            Line([54.9, 1.97320508]),
            Arc([55.0, 2.0], [55.0, 1.8]),
            Line([57.0, 2.0]),
            Arc([57.14142136, 1.94142136], [57.0, 1.8]),
            Line([60.08284271, -1.0]),
        ];
        vec![
            (
                [0.0, 0.0],
                [[4.0, 0.0], [7.0, 2.0], [9.0, 2.0], [10.0, 0.0], [15.0, 0.0]].map(Line).to_vec(),
            ),
            ([50.61628314, -0.5], rounded),
            ([-9.0, 54.0], vec![Arc([0.0, 45.0], [-9.0, 45.0]), Arc([-9.0, 36.0], [-9.0, 45.0])]),
            ([0.0, 0.0], vec![Line([10.0, 0.0]), Arc([15.0, 5.0], [10.0, 5.0])]),
            (
                [0.0, 0.0],
                vec![
                    Line([9.0, 0.0]),
                    Arc([10.0, 1.0], [9.0, 1.0]),
                    Arc([9.0, 2.0], [9.0, 1.0]),
                    Line([0.0, 2.0]),
                ],
            ),
            ([0.0, 0.0], [[4.0, -3.0], [5.0, 1.0], [0.0, 0.0]].map(Line).to_vec()),
            (
                [0.0, 0.0],
                vec![Line([4.0, 3.0]), Line([8.0, 3.0]), Parabola([9.0, 2.5], [10.0, 1.0])],
            ),
        ]
    }

    /// Turned and made larger, as a model of other units and another orientation has it.
    fn seen((start, segments): &(Point, Vec<Segment>), angle: f64, size: f64) -> Profile {
        let map = |point: Point| times(turned(point, angle), size);
        let own = segments.iter().map(|own| match *own {
            Line(end) => Line(map(end)),
            Arc(end, centre) => Arc(map(end), map(centre)),
            Parabola(middle, end) => Parabola(map(middle), map(end)),
        });
        Profile::of(map(*start), &own.collect::<Vec<_>>(), true)
    }

    /// The same kinds of segments with other numbers.
    fn redrawn(of: &[Segment], numbers: &[f64]) -> Profile {
        let mut points = numbers.chunks(2).map(|own| [own[0], own[1]]);
        let mut next = || points.next().unwrap();
        let start = next();
        let segments: Vec<Segment> = of
            .iter()
            .map(|own| match own {
                Line(_) => Line(next()),
                Arc(..) => Arc(next(), next()),
                Parabola(..) => Parabola(next(), next()),
            })
            .collect();
        Profile::of(start, &segments, true)
    }

    /// Requirement: shapes have the flanks, corners and arcs that a designer sees in them.
    #[test]
    fn flanks_corners_and_arcs_are_seen() {
        let found: Vec<(usize, usize, usize)> = shapes()
            .iter()
            .map(|shape| {
                let own = seen(shape, 0.0, 1.0).handles;
                let count = |is: fn(&Kind) -> bool| own.iter().filter(|own| is(&own.kind)).count();
                (
                    count(|own| matches!(own, Kind::Angle(_))),
                    count(|own| matches!(own, Kind::Fillet)),
                    count(|own| matches!(own, Kind::Radius(_))),
                )
            })
            .collect();
        let all = [(5, 0, 0), (3, 1, 0), (0, 0, 1), (1, 0, 1), (2, 0, 1), (3, 0, 0), (2, 0, 0)];
        assert_eq!(found, all);
        let catch = seen(&shapes()[1], 0.0, 1.0).handles;
        let values: Vec<f64> = catch.iter().map(|own| own.value).collect();
        assert_eq!(values, [30.0, 0.0, -45.0, 0.2, 0.0, 0.0]);
    }

    /// Requirement: whatever its orientation and unit, a profile that is drawn with another angle or
    /// radius has this one, all others as before, arcs that are tangent where they were, and the
    /// numbers of the deck where nothing is changed.
    #[test]
    fn what_is_set_is_what_comes_back() {
        for shape in shapes() {
            for (angle, size) in [(0.0, 1.0), (0.4, 1e-3), (2.2, 40.0), (-1.3, 1.0)] {
                let own = seen(&shape, angle, size);
                let values: Vec<f64> = own.handles.iter().map(|own| own.value).collect();
                assert_eq!(own.moved(&values).unwrap(), own.written);
                for (place, handle) in own.handles.iter().enumerate() {
                    let (mut other, turns) =
                        (values.clone(), matches!(handle.kind, Kind::Angle(_)));
                    if matches!(handle.kind, Kind::Shift(_)) {
                        continue;
                    }
                    other[place] = if turns { handle.value + 4.0 } else { 1.1 * handle.value };
                    let again = redrawn(&shape.1, &own.moved(&other).unwrap());
                    assert_eq!(again.handles.len(), values.len(), "{handle:?} of {shape:?}");
                    for (new, old) in again.handles.iter().zip(&other) {
                        let folded = if turns { (new.value - old).abs() % 180.0 } else { 0.0 };
                        let off = if folded > 90.0 { 180.0 - folded } else { folded };
                        let same = (new.value - old).abs() <= 2e-4 * old.abs().max(1.0);
                        assert!(same || turns && off < 1e-3, "{handle:?}: {new:?} {old}");
                    }
                }
            }
        }
    }

    /// Requirement: a flank between others turns about its start, its end slides on the line of the
    /// next one; what is free turns about what is not.
    #[test]
    fn a_flank_turns_about_its_start() {
        let shapes = shapes();
        let trapezoid = seen(&shapes[0], 0.0, 1.0);
        let mut values: Vec<f64> = trapezoid.handles.iter().map(|own| own.value).collect();
        values[1] = 45.0;
        let moved = trapezoid.moved(&values).unwrap();
        let (same, other) = (&trapezoid.written, [6.0, 2.0]);
        assert!((0..12).all(|k| {
            let expected = if k / 2 == 2 { other[k % 2] } else { same[k] };
            (moved[k] - expected).abs() < 1e-4
        }));
        let catch = seen(&shapes[1], 0.0, 1.0);
        let mut values: Vec<f64> = catch.handles.iter().map(|own| own.value).collect();
        values[0] = 40.0;
        let moved = catch.moved(&values).unwrap();
        // the sharp corner of the deck stays where it was
        let (corner, before) = (55.0 - 0.2 * 15f64.to_radians().tan(), 2.0);
        let way = minus([corner, before], [moved[0], moved[1]]);
        assert!((way[1] / way[0] - 40f64.to_radians().tan()).abs() < 1e-6);
        assert_eq!(moved[8..], catch.written[8..]);
    }

    /// Requirement: what cannot be drawn is refused, and a shift is added to every point.
    #[test]
    fn what_has_no_room_is_refused() {
        let catch = seen(&shapes()[1], 0.0, 1.0);
        let values: Vec<f64> = catch.handles.iter().map(|own| own.value).collect();
        for (place, value) in [(3, 0.0), (3, -1.0), (3, 9.0), (0, 179.0), (0, f64::NAN)] {
            let mut other = values.clone();
            other[place] = value;
            assert!(catch.moved(&other).is_err(), "{place} {value}");
        }
        let mut shifted = values;
        (shifted[4], shifted[5]) = (0.5, -0.25);
        let moved = catch.moved(&shifted).unwrap();
        for (new, old) in moved.chunks(2).zip(catch.written.chunks(2)) {
            assert_eq!([new[0], new[1]], plus([old[0], old[1]], [0.5, -0.25]));
        }
    }
}
