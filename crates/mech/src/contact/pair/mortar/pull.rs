//! Derivatives of the weighted gap of a node by all places, by hand.
//!
//! ```text
//!   psi = d . r_j + beta D_j,   d = -a n_j + b T_j        a, b, beta: numbers
//!
//!   d psi = int N_j d . (dy - dx) dA + what bounds, projections and normals do
//! ```
//!
//! Generic in the number type: with numbers that carry derivatives it gives second ones.
//! docs/theory.md eqs. (5.26) and (5.27)

use super::curve::{MOST_CONTROLS, Place, add_scaled, dot, scale, sub, zero};
use super::face::{FIRST_MASTER, MortarFace, OWN};
use super::integrals::{Bound, Integrals, Segment, Shares, Station, across, merged, projection};
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

/// What is integrated beside the shape function, with its slopes by the parameters of both sides.
struct Heights<R> {
    height: R,
    own_slope: R,
    other_slope: R,
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
        shares: Shares,
        direction: &Direction<R>,
        into: &mut [Place<R>],
    ) {
        let Some(ends) = self.ends else { return };
        let count = face.reference.count();
        let d = direction.of(self.normal(shares.node, count));
        let mut chain = Chain { face, into, by_ends: [zero(); 2] };
        let mut by_bounds = [R::from_f64(0.0); 2];
        for (k, station) in self.stations.iter().enumerate() {
            let at = (station, segments[station.segment].curve);
            let by = self.by_bounds(at, shares, (d, direction.area), &mut chain);
            by_bounds = [by_bounds[0] + by[0], by_bounds[1] + by[1]];
            if self.ends_segment(k) {
                let segment = (&segments[station.segment], self.spans[station.segment]);
                chain.move_bounds(segment, by_bounds, &ends);
                by_bounds = [R::from_f64(0.0); 2];
            }
        }
        let Chain { into, by_ends, .. } = chain;
        for (end, by) in by_ends.into_iter().enumerate() {
            face.pull_end(end, &ends[end], by, into);
        }
        self.pull_normal(face, shares.node, direction.by_normal(self.gap_of(shares)), into);
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
        shares: Shares,
        (d, by_area): (Place<R>, R),
        chain: &mut Chain<'_, R>,
    ) -> [R; 2] {
        let force = scale(shares.sum(&station.slave.value) * self.area(station), d);
        chain.move_master(curve, station, force);
        chain.move_slave(&station.slave.value, force);
        let heights = Heights {
            height: by_area - dot(d, station.apart),
            own_slope: -dot(d, station.own_along),
            other_slope: dot(d, station.along),
        };
        self.by_bounds_of((station, curve), shares, &heights, chain)
    }

    /// The same for a height over the face of which values and slopes by both parameters are known:
    /// what moves the station.
    fn by_bounds_of(
        &self,
        (station, curve): (&Station<R>, usize),
        shares: Shares,
        heights: &Heights<R>,
        chain: &mut Chain<'_, R>,
    ) -> [R; 2] {
        let [begin, end] = self.spans[station.segment];
        let [area, area_slope] = station.measure;
        let (shape, slope) = (shares.sum(&station.slave.value), shares.sum(&station.slave.slope));
        let inner = shape * heights.height;
        let inner_slope = slope * heights.height + shape * heights.own_slope;
        let whole = R::from_f64(station.weight) * (end - begin);
        let by_eta = whole * shape * area * heights.other_slope;
        let turned = chain.project(curve, station, by_eta / station.by_master);
        let by_t = whole * (inner_slope * area + inner * area_slope) - turned;
        let by_span = R::from_f64(station.weight) * inner * area;
        let fraction = R::from_f64(station.fraction);
        [(R::from_f64(1.0) - fraction) * by_t - by_span, fraction * by_t + by_span]
    }

    /// Whether a station is the last one of its segment.
    fn ends_segment(&self, station: usize) -> bool {
        let own = self.stations[station].segment;
        self.stations.get(station + 1).is_none_or(|next| next.segment != own)
    }

    /// Weighted distance along `tangent` of what faces a node now, where it stood before: places of
    /// the master less those of the slave at the last commit, by the weights of now [L3]. Adds its
    /// derivative and that of the area, `factors` times, to `into`.
    pub fn carried(
        &self,
        (face, segments): (&MortarFace<'_, R>, &[Segment]),
        (before, shares): (&MortarFace<'_, R>, Shares),
        tangent: Place<R>,
        factors: Option<(R, R)>,
        into: &mut [Place<R>],
    ) -> R {
        let mut whole = R::from_f64(0.0);
        let Some(ends) = self.ends else { return whole };
        let mut chain = Chain { face, into, by_ends: [zero(); 2] };
        let mut by_bounds = [R::from_f64(0.0); 2];
        for (k, station) in self.stations.iter().enumerate() {
            let curve = segments[station.segment].curve;
            let (slave, master) = (before.curve(), &before.curves[curve]);
            let way = sub(master.blend(&station.master.value), slave.blend(&station.slave.value));
            let own = shares.sum(&station.slave.value);
            whole = whole + own * self.area(station) * dot(tangent, way);
            let Some((factor, by_area)) = factors else { continue };
            let height = factor * dot(tangent, way) + by_area;
            let own_slope = -(factor * dot(tangent, slave.blend(&station.slave.slope)));
            let other_slope = factor * dot(tangent, master.blend(&station.master.slope));
            let heights = Heights { height, own_slope, other_slope };
            let by = self.by_bounds_of((station, curve), shares, &heights, &mut chain);
            by_bounds = [by_bounds[0] + by[0], by_bounds[1] + by[1]];
            if self.ends_segment(k) {
                chain.move_bounds(
                    (&segments[station.segment], self.spans[station.segment]),
                    by_bounds,
                    &ends,
                );
                by_bounds = [R::from_f64(0.0); 2];
            }
        }
        let Chain { into, by_ends, .. } = chain;
        for (end, by) in by_ends.into_iter().enumerate() {
            face.pull_end(end, &ends[end], by, into);
        }
        whole
    }

    /// Adds the force of a tangential force on a node, `factor` times: as the slip follows places
    /// where the weights of the master stand still. Force and moment balance.
    pub fn drag(
        &self,
        (face, segments): (&MortarFace<'_, R>, &[Segment]),
        shares: Shares,
        factor: R,
        into: &mut [Place<R>],
    ) {
        let n = self.normal(shares.node, face.reference.count());
        let t = [-(factor * n[1]), factor * n[0]];
        self.weights((face, segments), shares, |place, weight| {
            into[place] = add_scaled(into[place], -weight, t);
        });
        let r = self.gap_of(shares);
        self.pull_normal(face, shares.node, [-(factor * r[1]), factor * r[0]], into);
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

    /// What derivatives by both bounds of a segment are by places.
    fn move_bounds(
        &mut self,
        (segment, span): (&Segment, [R; 2]),
        by: [R; 2],
        ends: &[super::normals::MeanNormal<R>; 2],
    ) {
        for (end, by) in by.into_iter().enumerate() {
            self.move_bound((&segment.bounds[end], span[end]), by, ends);
        }
    }

    /// What a derivative by a bound is by places.
    fn move_bound(
        &mut self,
        (bound, t): (&Bound, R),
        by: R,
        ends: &[super::normals::MeanNormal<R>; 2],
    ) {
        let Bound::Projected { curve, end, at, merges } = *bound else { return };
        let (slave, other) = (self.face.curve(), &self.face.curves[curve]);
        let point = other.end(end);
        let (t, by) = match merges {
            None => (t, by),
            Some(_) => {
                let t = projection(R::from_f64(at), point, self.face, ends);
                (t, by * merged(t, merges)[1])
            }
        };
        let (_, slope) = across(&slave, ends, point, t);
        let by = by / slope;
        let own = slave.shapes(t);
        let apart = sub(slave.blend(&own.value), point);
        let normal = super::face::field(ends, t);
        self.turn(t, apart, by);
        let force = [by * normal[1], -(by * normal[0])];
        self.move_slave(&own.value, force);
        let place = FIRST_MASTER + MOST_CONTROLS * curve + other.last_control(end);
        self.into[place] = add_scaled(self.into[place], R::from_f64(1.0), force);
    }
}
