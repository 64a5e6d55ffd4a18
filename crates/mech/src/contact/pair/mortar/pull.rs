//! Derivatives of the weighted gap of a node by all places, by hand.
//!
//! ```text
//!   psi = d . r_j + beta D_j,   d = -a n_j + b T_j        a, b, beta: numbers
//!
//!   d psi = int N_j d . (dy - dx) dA + what bounds, projections and normals do
//! ```
//!
//! Generic in the number type: with numbers that carry derivatives it gives second ones.
//! docs/theory.md eqs. (5.34) to (5.37)

use super::curve::{MOST_CONTROLS, Place, add_scaled, dot, scale, zero};
use super::face::{FIRST_MASTER, MortarFace, OWN};
use super::integrals::{Bound, Integrals, Segment, Station, across};
use crate::differentiate::Real;

/// Which derivative is asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Direction<R> {
    /// a: factor of the weighted overclosure -n . r.
    pub normal: R,
    /// b: factor of the weighted slip T . r.
    pub tangent: R,
    /// beta: factor of the area.
    pub area: R,
}

impl<R: Real> Direction<R> {
    /// d for a normal of the slave.
    fn of(&self, n: Place<R>) -> Place<R> {
        let (a, b) = (self.normal, self.tangent);
        [-(a * n[0]) - b * n[1], b * n[0] - a * n[1]]
    }

    /// What a derivative by d is by the normal.
    fn by_normal(&self, by: Place<R>) -> Place<R> {
        let (a, b) = (self.normal, self.tangent);
        [b * by[1] - a * by[0], -(b * by[0]) - a * by[1]]
    }
}

/// Derivatives on their way from integrals to places.
struct Chain<'a, R> {
    face: &'a MortarFace<'a, R>,
    into: &'a mut [Place<R>],
    by_ends: [Place<R>; 2],
}

impl<R: Real> Integrals<R> {
    /// Adds the derivatives of psi of a node to `into`, over the places of the face.
    pub fn pull(
        &self,
        (face, segments): (&MortarFace<'_, R>, &[Segment]),
        node: usize,
        direction: &Direction<R>,
        into: &mut [Place<R>],
    ) {
        let Some(ends) = self.ends else { return };
        let count = face.reference.count();
        let d = direction.of(self.normal(node, count));
        let mut chain = Chain { face, into, by_ends: [zero(); 2] };
        let mut by_bounds = [R::from_f64(0.0); 2];
        for (k, station) in self.stations.iter().enumerate() {
            let at = (station, segments[station.segment].curve);
            let by = self.by_bounds(at, node, (d, direction.area), &mut chain);
            by_bounds = [by_bounds[0] + by[0], by_bounds[1] + by[1]];
            let last = self.stations.get(k + 1).is_none_or(|next| next.segment != station.segment);
            if last {
                for (end, by) in by_bounds.into_iter().enumerate() {
                    let bound = &segments[station.segment].bounds[end];
                    let at = self.spans[station.segment][end];
                    chain.move_bound((bound, at), by, &ends);
                }
                by_bounds = [R::from_f64(0.0); 2];
            }
        }
        let Chain { into, by_ends, .. } = chain;
        for (end, by) in by_ends.into_iter().enumerate() {
            face.pull_end(end, &ends[end], by, into);
        }
        self.pull_normal(face, node, direction.by_normal(self.gaps[node]), into);
    }

    /// Adds what a derivative by the normal of a node is by places.
    pub fn pull_normal(
        &self,
        face: &MortarFace<'_, R>,
        node: usize,
        by_normal: Place<R>,
        into: &mut [Place<R>],
    ) {
        let Some(ends) = &self.ends else { return };
        match (node, &self.middle) {
            (0, _) => face.pull_end(0, &ends[0], by_normal, into),
            (_, Some(middle)) if node + 1 < face.reference.count() => {
                face.pull_middle(middle, by_normal, into);
            }
            _ => face.pull_end(1, &ends[1], by_normal, into),
        }
    }

    /// Adds the derivatives of a station that faces a curve, and gives those by the bounds of its
    /// segment.
    fn by_bounds(
        &self,
        (station, curve): (&Station<R>, usize),
        node: usize,
        (d, by_area): (Place<R>, R),
        chain: &mut Chain<'_, R>,
    ) -> [R; 2] {
        let [begin, end] = self.spans[station.segment];
        let [area, area_slope] = station.measure;
        let (shape, slope) = (station.slave.value[node], station.slave.slope[node]);
        let height = by_area - dot(d, station.apart);
        let inner = shape * height;
        let inner_slope = slope * height - shape * dot(d, station.own_along);
        let whole = R::from_f64(station.weight) * (end - begin);
        let force = scale(whole * shape * area, d);
        chain.move_master(curve, station, force);
        chain.move_slave(&station.slave.value, force);
        let turned = chain.project(curve, station, dot(force, station.along) / station.by_master);
        let by_t = whole * (inner_slope * area + inner * area_slope) - turned;
        let by_span = R::from_f64(station.weight) * inner * area;
        let fraction = R::from_f64(station.fraction);
        [(R::from_f64(1.0) - fraction) * by_t - by_span, fraction * by_t + by_span]
    }

    /// Adds the force of a tangential force on a node, `factor` times: as the slip follows places
    /// where the weights of the master stand still. Force and moment balance.
    pub fn drag(
        &self,
        (face, segments): (&MortarFace<'_, R>, &[Segment]),
        node: usize,
        factor: R,
        into: &mut [Place<R>],
    ) {
        let n = self.normal(node, face.reference.count());
        let t = [-(factor * n[1]), factor * n[0]];
        self.weights((face, segments), node, |place, weight| {
            into[place] = add_scaled(into[place], -weight, t);
        });
        let r = self.gaps[node];
        self.pull_normal(face, node, [-(factor * r[1]), factor * r[0]], into);
    }
}

impl<R: Real> Chain<'_, R> {
    /// A force on the place that a station faces.
    fn move_master(&mut self, curve: usize, station: &Station<R>, force: Place<R>) {
        let first = FIRST_MASTER + MOST_CONTROLS * curve;
        for (control, &shape) in station.master.value.iter().enumerate() {
            let into = &mut self.into[first + control];
            *into = add_scaled(*into, shape, force);
        }
    }

    /// Takes a force on a place of the slave with these shape functions off.
    fn move_slave(&mut self, shapes: &[R; MOST_CONTROLS], force: Place<R>) {
        for (k, &shape) in shapes[..self.face.reference.count()].iter().enumerate() {
            self.into[OWN + k] = add_scaled(self.into[OWN + k], -shape, force);
        }
    }

    /// What a derivative by the parameter of the curve is by places, of a station that keeps its
    /// place on the slave: `by` is divided by that of the projection. Gives the part by the
    /// parameter of the slave, to be taken off.
    fn project(&mut self, curve: usize, station: &Station<R>, by: R) -> R {
        self.turn(station.t, station.apart, by);
        let across = [by * station.normal[1], -(by * station.normal[0])];
        self.move_slave(&station.slave.value, across);
        self.move_master(curve, station, across);
        by * station.by_slave
    }

    /// What turning the normal at t does to a projection, taken off `by` times.
    fn turn(&mut self, t: R, apart: Place<R>, by: R) {
        let across = [by * apart[1], -(by * apart[0])];
        let rest = R::from_f64(1.0) - t;
        self.by_ends[0] = add_scaled(self.by_ends[0], rest, across);
        self.by_ends[1] = add_scaled(self.by_ends[1], t, across);
    }

    /// What a derivative by a bound is by places.
    fn move_bound(
        &mut self,
        (bound, t): (&Bound, R),
        by: R,
        ends: &[super::normals::MeanNormal<R>; 2],
    ) {
        let Bound::Projected { curve, end, .. } = *bound else { return };
        let (slave, other) = (self.face.curve(), &self.face.curves[curve]);
        let point = other.end(end);
        let (_, slope) = across(&slave, ends, point, t);
        let by = by / slope;
        let own = slave.shapes(t);
        let apart = super::curve::sub(slave.blend(&own.value), point);
        let normal = super::face::field(ends, t);
        self.turn(t, apart, by);
        let force = [by * normal[1], -(by * normal[0])];
        self.move_slave(&own.value, force);
        let place = FIRST_MASTER + MOST_CONTROLS * curve + other.last_control(end);
        self.into[place] = add_scaled(self.into[place], R::from_f64(1.0), force);
    }
}
