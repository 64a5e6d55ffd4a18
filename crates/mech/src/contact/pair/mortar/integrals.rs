//! The mortar integrals of a slave face over what is covered of it.
//!
//! ```text
//!   M_kl = int N_k N_l dA     D_k = int N_k dA     H_k = int N_k y dA     Phi = D M^-1 N
//!
//!       n(t)                   y: the place of the master on the line through x(t) along n(t)
//!   o----+----o                weighted gap of node j: r_j = sum_k A_jk H_k - D_j x_j,
//!       x(t)                                           A = D M^-1
//! ```
//!
//! docs/theory.md eqs. (5.29) to (5.33)

use super::curve::{Curve, MOST_CONTROLS, Place, Shapes, add_scaled, cross, shapes, sub, zero};
use super::dual::{self, Matrix};
use super::face::{MortarFace, field, field_slope};
use super::normals::MeanNormal;
use super::reference::Reference;
use crate::differentiate::Real;

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
    /// The faced place y and its derivative by the parameter of the curve [L].
    pub faced: Place<R>,
    pub along: Place<R>,
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
    pub(super) inverse: Matrix<R>,
    /// Rows of dual shape functions by shape functions [1].
    pub(super) dual: Matrix<R>,
    /// D [L2].
    pub areas: [R; MOST_CONTROLS],
    /// H [L3].
    pub(super) faced: [Place<R>; MOST_CONTROLS],
}

impl<R: Real> Default for Integrals<R> {
    fn default() -> Self {
        let (spans, stations) = (Vec::new(), Vec::new());
        let (inverse, dual) = (dual::zeros(), dual::zeros());
        let areas = [R::from_f64(0.0); MOST_CONTROLS];
        let faced = [zero(); MOST_CONTROLS];
        Self { ends: None, middle: None, spans, stations, inverse, dual, areas, faced }
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
            let apart = sub(at, faced);
            self.stations.push(Station {
                segment: place,
                fraction,
                weight,
                slave: own,
                measure: face.reference.measure(t),
                t,
                master: other,
                faced,
                along,
                apart,
                normal,
                by_slave: cross(slave.blend(&own.slope), normal) + cross(apart, field_slope(ends)),
                by_master: -cross(along, normal),
            });
        }
        true
    }

    fn sum(&mut self, count: usize) {
        let mut mass: Matrix<R> = dual::zeros();
        self.areas = [R::from_f64(0.0); MOST_CONTROLS];
        self.faced = [zero(); MOST_CONTROLS];
        for station in &self.stations {
            let [begin, end] = self.spans[station.segment];
            let area = R::from_f64(station.weight) * (end - begin) * station.measure[0];
            for k in 0..count {
                let own = station.slave.value[k] * area;
                self.areas[k] = self.areas[k] + own;
                self.faced[k] = add_scaled(self.faced[k], own, station.faced);
                for (l, entry) in mass[k][..count].iter_mut().enumerate() {
                    *entry = *entry + own * station.slave.value[l];
                }
            }
        }
        self.inverse = dual::inverse(&mass, count);
        for k in 0..count {
            self.dual[k] = self.inverse[k].map(|entry| self.areas[k] * entry);
        }
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

    /// Weighted gap of a node as a vector, from the slave to the master [L3].
    pub fn gap(&self, node: usize, face: &MortarFace<'_, R>) -> Place<R> {
        let own = self.dual[node][..face.reference.count()].iter().zip(self.faced);
        let faced = own.fold(zero(), |sum, (&by, faced)| add_scaled(sum, by, faced));
        add_scaled(faced, -self.areas[node], face.places.own[node])
    }

    /// Dual shape function of a node at a station.
    pub(super) fn multiplier(&self, node: usize, station: &Station<R>, count: usize) -> R {
        dual::along(&self.dual[node], &station.slave.value, count)
    }

    /// Weights of the master's control points in the weighted gap of a node: `add(segment, control,
    /// weight)` [L2].
    pub fn weights(&self, node: usize, count: usize, mut add: impl FnMut(usize, usize, R)) {
        for station in &self.stations {
            let [begin, end] = self.spans[station.segment];
            let area = R::from_f64(station.weight) * (end - begin) * station.measure[0];
            let own = self.multiplier(node, station, count) * area;
            for (control, &shape) in station.master.value.iter().enumerate() {
                add(station.segment, control, own * shape);
            }
        }
    }
}

/// The parameter of a bound, with its derivatives.
fn parameter<R: Real>(bound: &Bound, face: &MortarFace<'_, R>, ends: &[MeanNormal<R>; 2]) -> R {
    let Bound::Projected { curve, end, at } = *bound else { return R::from_f64(bound.at()) };
    let (slave, point) = (face.curve(), face.curves[curve].end(end));
    let mut t = R::from_f64(at);
    for _ in 0..2 {
        let (off, slope) = across(&slave, ends, point, t);
        t = t - off / slope;
    }
    t
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
