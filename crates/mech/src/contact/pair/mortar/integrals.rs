//! The mortar integrals of a slave face over what is covered of it.
//!
//! ```text
//!       n(t)                   y: the place of the master on the line through x(t) along n(t)
//!   o----+----o                area of node j          D_j = int N_j dA
//!       x(t)                   weighted gap of node j  r_j = int N_j (y - x) dA
//! ```
//!
//! docs/theory.md eqs. (5.21) to (5.24)

use super::curve::{
    Curve, MOST_CONTROLS, Place, Shapes, add_scaled, cross, dot, shapes, sub, zero,
};
use super::face::{FIRST_MASTER, MortarFace, OWN, field, field_slope};
use super::normals::MeanNormal;
use super::reference::Reference;
use crate::differentiate::Real;

/// Part of a face within which a bound goes over into the end of its surface [1].
pub(super) const MERGING: f64 = 0.01;

/// Where a segment ends on its slave face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bound {
    /// At an end of the face: 0 or 1.
    End(usize),
    /// At the projection of the first (0) or last (1) point of a curve.
    Projected {
        /// The curve.
        curve: usize,
        /// Which of its ends.
        end: usize,
        /// The parameter of the face there [1].
        at: f64,
        /// The end of the face, 0 or 1, into which it goes over smoothly, as the surface ends there.
        merges: Option<usize>,
    },
}

impl Bound {
    /// The parameter of the face there [1].
    pub fn at(&self) -> f64 {
        match *self {
            Self::End(end) => end as f64,
            Self::Projected { at, .. } => at,
        }
    }
}

/// A part of a slave face that one curve faces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// The curve.
    pub curve: usize,
    /// Where it begins and ends.
    pub bounds: [Bound; 2],
    /// How much of its integrals counts [1]: one, but where it goes over into what is left out.
    pub counts: f64,
    /// Whether some of it is left out as it went in through another side of the master.
    pub went_in_elsewhere: bool,
}

impl Segment {
    /// A part that counts as a whole.
    pub fn new(curve: usize, bounds: [Bound; 2]) -> Self {
        Self { curve, bounds, counts: 1.0, went_in_elsewhere: false }
    }
}

/// A node of a face and the nodes whose shape functions weight its gap: its own, and those of nodes
/// that so little of the face is left to that they carry no contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shares {
    /// The node.
    pub node: usize,
    /// Whose shape functions it has.
    pub has: [bool; MOST_CONTROLS],
}

/// A place of integration.
#[derive(Debug, Clone, Copy)]
pub(super) struct Station<R> {
    pub segment: usize,
    /// Where in its segment, 0 to 1, and with which weight.
    pub fraction: f64,
    pub weight: f64,
    /// Shape functions of the slave there, its area by the parameter and the derivative of that.
    pub slave: Shapes<R>,
    pub measure: [R; 2],
    /// Parameter of the face, and shape functions of the curve where it is faced.
    pub t: R,
    pub master: Shapes<R>,
    /// Derivative of the faced place by the parameter of the curve [L].
    pub along: Place<R>,
    /// Derivative of x by the parameter of the face [L].
    pub own_along: Place<R>,
    /// x - y [L], and the normal field.
    pub apart: Place<R>,
    pub normal: Place<R>,
    /// Derivatives of (x - y) x n by both parameters [L].
    pub by_slave: R,
    pub by_master: R,
}

/// The integrals of a face, in a list that is used again.
#[derive(Debug, Clone)]
pub struct Integrals<R> {
    pub(super) ends: Option<[MeanNormal<R>; 2]>,
    pub(super) middle: Option<MeanNormal<R>>,
    pub(super) spans: Vec<[R; 2]>,
    pub(super) stations: Vec<Station<R>>,
    /// D [L2].
    pub areas: [R; MOST_CONTROLS],
    /// r [L3].
    pub gaps: [Place<R>; MOST_CONTROLS],
}

impl<R: Real> Default for Integrals<R> {
    fn default() -> Self {
        let (spans, stations) = (Vec::new(), Vec::new());
        let areas = [R::from_f64(0.0); MOST_CONTROLS];
        let gaps = [zero(); MOST_CONTROLS];
        Self { ends: None, middle: None, spans, stations, areas, gaps }
    }
}

/// Gauss's rules on 0 to 1: places and weights.
const THREE: &[(f64, f64)] = &[
    (0.112_701_665_379_258_31, 5.0 / 18.0),
    (0.5, 8.0 / 18.0),
    (0.887_298_334_620_741_7, 5.0 / 18.0),
];
const FIVE: &[(f64, f64)] = &[
    (0.046_910_077_030_668_0, 0.118_463_442_528_094_54),
    (0.230_765_344_947_158_45, 0.239_314_335_249_683_23),
    (0.5, 0.284_444_444_444_444_44),
    (0.769_234_655_052_841_5, 0.239_314_335_249_683_23),
    (0.953_089_922_969_332, 0.118_463_442_528_094_54),
];

impl Integrals<f64> {
    /// How deep a place of the face lies in what it faces beyond its mean overclosure [L]; `None` where
    /// it faces nothing. docs/theory.md section 5.11
    pub fn unseen_depth(&self, face: &MortarFace<'_, f64>, segments: &[Segment]) -> Option<f64> {
        let (slave, ends) = (face.curve(), self.ends?);
        let gap = |(place, t): (usize, f64)| {
            let (normal, at) = (field(&ends, t), slave.blend(&slave.shapes(t).value));
            let master = &face.curves[segments[place].curve];
            let faced = master.blend(&master.shapes(master.crossed(at, normal)?).value);
            Some(dot(sub(faced, at), normal))
        };
        let is_of_this_side = |segment: usize| !segments[segment].went_in_elsewhere;
        let bounds = self.spans.iter().enumerate().filter(|&(segment, _)| is_of_this_side(segment));
        let bounds = bounds.flat_map(|(segment, span)| span.map(|t| (segment, t)));
        let of_station = |station: &Station<f64>| -dot(station.apart, station.normal);
        let stations = self.stations.iter().filter(|own| is_of_this_side(own.segment));
        let all = bounds.filter_map(gap).chain(stations.map(of_station));
        let least = all.reduce(f64::min)?;
        let area: f64 = self.stations.iter().map(|own| self.area(own)).sum();
        let sum: f64 = self.stations.iter().map(|own| self.area(own) * of_station(own)).sum();
        (area > 0.0).then(|| (sum / area).min(0.0) - least)
    }
}

impl<R: Real> Integrals<R> {
    /// Takes the integrals over segments of a face; false where the face has collapsed or some place
    /// faces nothing.
    pub fn take(&mut self, face: &MortarFace<'_, R>, segments: &[Segment]) -> bool {
        self.spans.clear();
        self.stations.clear();
        self.ends = face.end_normals();
        self.middle = face.middle_normal();
        let Some(ends) = self.ends else { return false };
        for (place, segment) in segments.iter().enumerate() {
            let span = segment.bounds.map(|bound| parameter(&bound, face, &ends));
            self.spans.push(span);
            if !self.add_stations((place, segment), span, face, &ends) {
                return false;
            }
        }
        self.sum(face.reference.count());
        !segments.is_empty()
    }

    fn add_stations(
        &mut self,
        (place, segment): (usize, &Segment),
        [begin, end]: [R; 2],
        face: &MortarFace<'_, R>,
        ends: &[MeanNormal<R>; 2],
    ) -> bool {
        let (slave, master) = (face.curve(), &face.curves[segment.curve]);
        let rule = if slave.count + master.count == 4 { THREE } else { FIVE };
        for &(fraction, weight) in rule {
            let t = begin + R::from_f64(fraction) * (end - begin);
            let normal = field(ends, t);
            let own = slave.shapes(t);
            let at = slave.blend(&own.value);
            let Some(eta) = master.crossed(at, normal) else { return false };
            let other = master.shapes(eta);
            let (faced, along) = (master.blend(&other.value), master.blend(&other.slope));
            let (apart, own_along) = (sub(at, faced), slave.blend(&own.slope));
            self.stations.push(Station {
                segment: place,
                fraction,
                weight: segment.counts * weight,
                slave: own,
                measure: face.reference.measure(t),
                t,
                master: other,
                along,
                own_along,
                apart,
                normal,
                by_slave: cross(own_along, normal) + cross(apart, field_slope(ends)),
                by_master: -cross(along, normal),
            });
        }
        true
    }

    fn sum(&mut self, count: usize) {
        self.areas = [R::from_f64(0.0); MOST_CONTROLS];
        self.gaps = [zero(); MOST_CONTROLS];
        for station in &self.stations {
            let area = self.area(station);
            for (node, &shape) in station.slave.value[..count].iter().enumerate() {
                let own = shape * area;
                self.areas[node] = self.areas[node] + own;
                self.gaps[node] = add_scaled(self.gaps[node], -own, station.apart);
            }
        }
    }

    /// Area of a station [L2].
    pub(super) fn area(&self, station: &Station<R>) -> R {
        let [begin, end] = self.spans[station.segment];
        R::from_f64(station.weight) * (end - begin) * station.measure[0]
    }

    /// Outward normal at a node of the face [1].
    pub fn normal(&self, node: usize, count: usize) -> Place<R> {
        let of = |normal: &MeanNormal<R>| normal.normal;
        match (self.ends, self.middle) {
            (Some([first, _]), _) if node == 0 => of(&first),
            (Some([_, last]), _) if node + 1 == count => of(&last),
            (_, Some(middle)) => of(&middle),
            _ => zero(),
        }
    }

    /// Area of a node [L2].
    pub fn area_of(&self, shares: Shares) -> R {
        shares.nodes().fold(R::from_f64(0.0), |sum, k| sum + self.areas[k])
    }

    /// Weighted gap of a node as a vector, from the slave to the master [L3].
    pub fn gap_of(&self, shares: Shares) -> Place<R> {
        shares.nodes().fold(zero(), |sum, k| add_scaled(sum, R::from_f64(1.0), self.gaps[k]))
    }

    /// Weights of places in the weighted gap of a node, negative for those of the slave:
    /// `add(place, weight)` [L2].
    pub fn weights(
        &self,
        (face, segments): (&MortarFace<'_, R>, &[Segment]),
        shares: Shares,
        mut add: impl FnMut(usize, R),
    ) {
        let count = face.reference.count();
        for station in &self.stations {
            let own = shares.sum(&station.slave.value) * self.area(station);
            let curve = segments[station.segment].curve;
            for (control, &shape) in station.slave.value[..count].iter().enumerate() {
                add(OWN + control, -(own * shape));
            }
            for (control, &shape) in station.master.value.iter().enumerate() {
                add(FIRST_MASTER + MOST_CONTROLS * curve + control, own * shape);
            }
        }
    }
}

impl Shares {
    /// A node with its own shape function alone.
    pub fn of(node: usize) -> Self {
        Self { node, has: std::array::from_fn(|k| k == node) }
    }

    /// Those whose shape functions are its own.
    fn nodes(self) -> impl Iterator<Item = usize> {
        (0..MOST_CONTROLS).filter(move |&k| self.has[k])
    }

    /// Their sum.
    pub(super) fn sum<R: Real>(self, of_nodes: &[R; MOST_CONTROLS]) -> R {
        self.nodes().fold(R::from_f64(0.0), |sum, k| sum + of_nodes[k])
    }
}

/// The parameter of a bound, with its derivatives.
fn parameter<R: Real>(bound: &Bound, face: &MortarFace<'_, R>, ends: &[MeanNormal<R>; 2]) -> R {
    let Bound::Projected { curve, end, at, merges } = *bound else {
        return R::from_f64(bound.at());
    };
    let t = projection(R::from_f64(at), face.curves[curve].end(end), face, ends);
    merged(t, merges)[0]
}

/// Where a point projects on a face, from a place that is right in value: with its derivatives.
pub(super) fn projection<R: Real>(
    near: R,
    point: Place<R>,
    face: &MortarFace<'_, R>,
    ends: &[MeanNormal<R>; 2],
) -> R {
    let slave = face.curve();
    let mut t = near;
    for _ in 0..2 {
        let (off, slope) = across(&slave, ends, point, t);
        t = t - off / slope;
    }
    t
}

/// The parameter of a bound that goes over into an end of its face, and its derivative by that of the
/// projection: without it the force along the face would leap where an end of the master passes that
/// of the slave. docs/theory.md section 5.10, where both surfaces end
pub(super) fn merged<R: Real>(t: R, end: Option<usize>) -> [R; 2] {
    let Some(end) = end else { return [t, R::from_f64(1.0)] };
    let (one, two, three) = (R::from_f64(1.0), R::from_f64(2.0), R::from_f64(3.0));
    let width = R::from_f64(MERGING);
    let part = (if end == 0 { t } else { one - t }) / width;
    let rest = width * part * part * (two - part);
    let slope = part * (two * two - three * part);
    [if end == 0 { rest } else { one - rest }, slope]
}

/// (x(t) - y) x n(t), which vanishes where y projects, and its derivative [L].
pub(super) fn across<R: Real>(
    slave: &Curve<R>,
    ends: &[MeanNormal<R>; 2],
    point: Place<R>,
    t: R,
) -> (R, R) {
    let own = slave.shapes(t);
    let (apart, normal) = (sub(slave.blend(&own.value), point), field(ends, t));
    let slope = cross(slave.blend(&own.slope), normal) + cross(apart, field_slope(ends));
    (cross(apart, normal), slope)
}

impl Reference {
    /// Areas of its nodes where it is covered as a whole [L2].
    pub fn areas(&self) -> [f64; MOST_CONTROLS] {
        let mut areas = [0.0; MOST_CONTROLS];
        for &(t, weight) in FIVE {
            let own = shapes(self.count(), 1.0, t);
            let [area, _] = self.measure(t);
            areas.iter_mut().zip(own.value).for_each(|(sum, shape)| *sum += weight * area * shape);
        }
        areas
    }
}
