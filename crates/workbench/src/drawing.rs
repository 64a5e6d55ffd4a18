//! Corners of a profile and what lies between them, as they are for some values.

use crate::plane::{
    Point, cross, crossing, distance, dot, left, minus, plus, times, towards, turned,
};

/// How far an arc may be from being tangent to a flank [rad].
const TANGENT: f64 = 1e-2;
/// Least and largest turn of a rounded corner [rad].
const TURNS: [f64; 2] = [1e-3, 3.0];

/// A segment as it is written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Segment {
    Line(Point),
    /// End and centre.
    Arc(Point, Point),
    /// A point between, and the end.
    Parabola(Point, Point),
}

impl Segment {
    fn end(self) -> Point {
        match self {
            Self::Line(end) | Self::Arc(end, _) | Self::Parabola(_, end) => end,
        }
    }
}

/// What lies between two corners.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Piece {
    Flank,
    /// Centre of an arc, then joint and centre of every further one about the same point.
    Arc(Vec<Point>),
    /// The point between.
    Parabola(Point),
}

impl Piece {
    fn mapped(&mut self, map: &dyn Fn(Point) -> Point) {
        match self {
            Self::Flank => {}
            Self::Arc(points) => points.iter_mut().for_each(|own| *own = map(*own)),
            Self::Parabola(point) => *point = map(*point),
        }
    }
}

/// How a flank turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Swing {
    /// About its end; its start is free.
    Start,
    /// About its start; its end is free.
    End,
    /// About its start; its end slides along the line of another flank.
    EndAlong(usize),
    /// About its end; its start slides along the line of another flank.
    StartAlong(usize),
}

/// The profile.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Drawing {
    /// Where pieces meet; of a closed profile the last one is the first one.
    pub corners: Vec<Point>,
    pub pieces: Vec<Piece>,
    /// Radius of the rounding of each corner; 0 is none.
    pub radii: Vec<f64>,
    pub closed: bool,
}

impl Drawing {
    /// That of the segments that are written behind a start.
    pub fn of(start: Point, segments: &[Segment]) -> Self {
        let ends = || segments.iter().map(|own| own.end());
        let points: Vec<Point> = std::iter::once(start).chain(ends()).collect();
        let size = points.iter().map(|own| distance(start, *own)).fold(0.0, f64::max);
        let closed = points.last().is_some_and(|end| distance(start, *end) <= 1e-9 * size);
        let mut own = Self { corners: vec![start], pieces: Vec::new(), radii: vec![0.0], closed };
        let rounding = |place: usize| rounding(&points, segments, place);
        for (place, segment) in segments.iter().enumerate() {
            let end = points[place + 1];
            match *segment {
                Segment::Line(_) => match rounding(place + 1) {
                    Some((corner, radius)) => own.push(Piece::Flank, corner, radius),
                    None => own.push(Piece::Flank, end, 0.0),
                },
                Segment::Parabola(middle, _) => own.push(Piece::Parabola(middle), end, 0.0),
                Segment::Arc(..) if rounding(place).is_some() => {}
                Segment::Arc(_, centre) => own.arc(centre, end),
            }
        }
        own
    }

    fn push(&mut self, piece: Piece, end: Point, radius: f64) {
        self.pieces.push(piece);
        self.corners.push(end);
        self.radii.push(radius);
    }

    /// An arc, which goes on with the one before where both are about the same point.
    fn arc(&mut self, centre: Point, end: Point) {
        if let (Some(Piece::Arc(points)), Some(joint)) =
            (self.pieces.last_mut(), self.corners.last_mut())
            && distance(points[0], centre) <= 1e-4 * distance(centre, end)
        {
            points.extend([*joint, centre]);
            *joint = end;
        } else {
            self.push(Piece::Arc(vec![centre]), end, 0.0);
        }
    }

    /// From corner to corner.
    pub fn direction(&self, place: usize) -> Point {
        minus(self.corners[place + 1], self.corners[place])
    }

    fn place(&mut self, corner: usize, point: Point) {
        let last = self.corners.len() - 1;
        self.corners[corner] = point;
        if self.closed && (corner == 0 || corner == last) {
            (self.corners[0], self.corners[last]) = (point, point);
        }
    }

    /// Turns a flank counter-clockwise by an angle [rad].
    pub fn turn(&mut self, flank: usize, swing: Swing, angle: f64) {
        let (start, end) = (self.corners[flank], self.corners[flank + 1]);
        let way = turned(minus(end, start), angle);
        match swing {
            Swing::Start => self.place(flank, minus(end, way)),
            Swing::End => self.place(flank + 1, plus(start, way)),
            Swing::EndAlong(other) => {
                let along = self.direction(other);
                self.place(flank + 1, crossing((start, way), (end, along)));
            }
            Swing::StartAlong(other) => {
                let along = self.direction(other);
                self.place(flank, crossing((end, way), (start, along)));
            }
        }
    }

    /// Makes an arc larger or smaller. It stays tangent to what it is joined with: where it is
    /// joined at its start, what follows moves along; a free one keeps its centre.
    pub fn widen(&mut self, place: usize, factor: f64) {
        let Piece::Arc(points) = &self.pieces[place] else { return };
        let (alone, first) = (self.pieces.len() == 1, place == 0);
        let fixed = match (alone, first) {
            (true, _) => points[0],
            (false, true) => self.corners[1],
            (false, false) => self.corners[place],
        };
        let larger = move |point: Point| plus(fixed, times(minus(point, fixed), factor));
        let end = self.corners[place + 1];
        self.pieces[place].mapped(&larger);
        if first {
            self.corners[0] = larger(self.corners[0]);
        }
        let moved = minus(larger(end), end);
        let along = move |point: Point| plus(point, moved);
        self.corners[place + 1..].iter_mut().for_each(|own| *own = along(*own));
        self.pieces[place + 1..].iter_mut().for_each(|own| own.mapped(&along));
    }

    /// Coordinates in the order in which they are written. `Err`: there is no such profile, flanks
    /// do not keep the directions that they should have.
    pub fn written(&self, directions: &[Point]) -> Result<Vec<f64>, &'static str> {
        let mut written = self.corners[0].to_vec();
        let mut from = self.corners[0];
        for (place, piece) in self.pieces.iter().enumerate() {
            let end = self.corners[place + 1];
            match piece {
                Piece::Flank => {
                    let arc = self.rounding(place + 1);
                    let to = arc.map_or(end, |[begin, ..]| begin);
                    let length = dot(minus(to, from), directions[place]);
                    if !length.is_finite() || length <= 0.0 {
                        return Err("a flank would have no length left");
                    }
                    written.extend(to);
                    from = to;
                    if let Some([_, to, centre]) = arc {
                        written.extend([to, centre].concat());
                        from = to;
                    }
                }
                Piece::Arc(points) => {
                    for own in points.chunks(2) {
                        written.extend(points_of(own, end));
                    }
                    from = end;
                }
                Piece::Parabola(middle) => {
                    written.extend([*middle, end].concat());
                    from = end;
                }
            }
        }
        Ok(written)
    }

    /// Start, end and centre of the arc that rounds a corner.
    fn rounding(&self, corner: usize) -> Option<[Point; 3]> {
        let radius = self.radii[corner];
        if radius == 0.0 {
            return None;
        }
        let [before, own, behind] = [corner - 1, corner, corner + 1].map(|at| self.corners[at]);
        let (into, out) = (towards(before, own), towards(own, behind));
        let turn = cross(into, out).atan2(dot(into, out));
        let cut = radius * (0.5 * turn).abs().tan();
        let begin = minus(own, times(into, cut));
        let centre = plus(begin, times(left(into), radius * turn.signum()));
        Some([begin, plus(own, times(out, cut)), centre])
    }
}

/// End and centre of an arc of a group: its end is the next joint, or the end of the group.
fn points_of(own: &[Point], end: Point) -> Vec<f64> {
    match own {
        [centre, joint] => [*joint, *centre].concat(),
        [centre, ..] => [end, *centre].concat(),
        [] => Vec::new(),
    }
}

/// The corner that an arc rounds, and its radius; `None`: it is no arc that is tangent to straight
/// segments on both its sides.
fn rounding(points: &[Point], segments: &[Segment], place: usize) -> Option<(Point, f64)> {
    let before = place.checked_sub(1)?;
    let Segment::Arc(end, centre) = *segments.get(place)? else { return None };
    let (Segment::Line(begin), Segment::Line(_)) = (segments[before], segments.get(place + 1)?)
    else {
        return None;
    };
    let (into, out) = (towards(points[before], begin), towards(end, points[place + 2]));
    let turn = cross(into, out).atan2(dot(into, out));
    let [from, to] = [begin, end].map(|own| times(left(towards(centre, own)), turn.signum()));
    let is_tangent = |a: Point, b: Point| cross(a, b).abs() <= TANGENT && dot(a, b) > 0.0;
    let turns = (TURNS[0]..TURNS[1]).contains(&turn.abs());
    let radius = 0.5 * (distance(centre, begin) + distance(centre, end));
    (turns && is_tangent(from, into) && is_tangent(to, out))
        .then(|| (crossing((begin, into), (end, out)), radius))
}
