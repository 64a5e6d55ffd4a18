//! Derivatives of mortar integrals by the nodes of both sides, by hand.
//!
//! ```text
//!   psi = int F(xi, eta) dA          F = sum L (a g + b): gaps and areas
//!   d psi = what moves the nodes + what moves places upon the faces + what moves the corners
//!           of the overlap + what turns the normal
//! ```
//!
//! Generic in the number type: with numbers that carry derivatives it gives second ones.
//! docs/theory.md eqs. (5.34) to (5.36)

use super::clip::{Corner, MOST, Overlap};
use super::couple::Couple;
use super::places::{Place, add_scaled, cross, dot, flat_add, flat_sub, scale, sub, zero};
use super::shapes::{MOST_CORNERS, MOST_NODES, corners, pieces, place_of};
use super::station::{Placed, Station, lift, meet};
use crate::differentiate::Real;

/// What is integrated: numbers of the corners.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load<R> {
    /// Factors of the gap.
    pub gap: [R; MOST_CORNERS],
    /// Factors of the area.
    pub area: [R; MOST_CORNERS],
    /// Tractions that drag: their weights stand still.
    pub drag: [Place<R>; MOST_CORNERS],
}

/// How far what is faced was away at the last commit, along directions of the corners.
#[derive(Debug, Clone, Copy)]
pub struct Carried<'a> {
    /// The corner.
    pub corner: usize,
    /// The direction [1].
    pub direction: Place<f64>,
    /// Factor of that way.
    pub factor: f64,
    /// Factor of the area.
    pub area: f64,
    /// Nodes of both sides at the last commit [L].
    pub slave: &'a [Place<f64>; MOST_NODES],
    /// Those of the master.
    pub master: &'a [Place<f64>; MOST_NODES],
}

/// An integrand at a place, without the measure, and how it changes.
struct Heights<R> {
    inner: R,
    /// By the place on the slave, that on the master kept, and the other way round.
    slope: [R; 2],
    by_faced: [R; 2],
    /// By the faced place, by the place, and by the normal.
    on_master: Place<R>,
    on_slave: Place<R>,
    on_normal: Place<R>,
}

/// Derivatives on their way to the nodes: those of the slave first.
struct Chain<'a, R> {
    into: &'a mut [Place<R>],
    by_normal: Place<R>,
    by_vertices: [[R; 2]; MOST],
}

/// The ends of an edge: node and place.
type Edge<R> = [(usize, Place<R>); 2];

impl<R: Real> Load<R> {
    /// No load.
    pub fn nothing() -> Self {
        let none = [R::from_f64(0.0); MOST_CORNERS];
        Self { gap: none, area: none, drag: [zero(); MOST_CORNERS] }
    }

    fn heights(&self, station: &Station<R>, normal: Place<R>) -> Heights<R> {
        let (a, a_slope) = station.blend(&self.gap);
        let (b, b_slope) = station.blend(&self.area);
        let gap = station.met.gap;
        let along = |side: &[Place<R>; 2]| side.map(|own| a * dot(normal, own));
        let own = along(&station.along);
        let slope = std::array::from_fn(|k| a_slope[k] * gap + b_slope[k] - own[k]);
        let drag = self.drag.iter().zip(&station.corners.value);
        let drag = drag.fold(zero(), |sum, (&drag, &by)| add_scaled(sum, by, drag));
        let force = sub(scale(a, normal), drag);
        Heights {
            inner: a * gap + b,
            slope,
            by_faced: along(&station.met.along),
            on_master: force,
            on_slave: scale(R::from_f64(-1.0), force),
            on_normal: scale(gap, drag),
        }
    }
}

impl Carried<'_> {
    fn heights(&self, station: &Station<f64>) -> Heights<f64> {
        let blend = |of: &[Place<f64>; MOST_NODES], by: &[f64; MOST_NODES]| {
            let sum = of.iter().zip(by);
            self.factor
                * dot(self.direction, sum.fold(zero(), |s, (&at, &by)| add_scaled(s, by, at)))
        };
        let met = &station.met.shapes;
        let height =
            blend(self.master, &met.value) - blend(self.slave, &station.slave.value) + self.area;
        let own = station.corners.value[self.corner];
        let turn = [0, 1].map(|k| station.corners.slope[k][self.corner]);
        let slope =
            [0, 1].map(|k| turn[k] * height - own * blend(self.slave, &station.slave.slope[k]));
        let by_faced = [0, 1].map(|k| own * blend(self.master, &met.slope[k]));
        let (on_master, on_slave, on_normal) = (zero(), zero(), zero());
        Heights { inner: own * height, slope, by_faced, on_master, on_slave, on_normal }
    }
}

impl<R: Real> Couple<'_, R> {
    /// Number of nodes of both sides.
    pub fn count(&self) -> usize {
        self.slave.count + self.master.count
    }

    /// Adds the derivatives of the integrals of loads over an overlap, by the nodes of the slave and
    /// then of the master, a list each; false where a place faces nothing.
    pub fn pull<const N: usize>(
        &self,
        overlap: &Overlap,
        loads: &[Load<R>; N],
        into: [&mut [Place<R>]; N],
    ) -> bool {
        let heights = |station: &Station<R>, normal, k: usize| loads[k].heights(station, normal);
        self.pull_all(overlap, heights, into)
    }

    fn pull_all<const N: usize>(
        &self,
        overlap: &Overlap,
        heights: impl Fn(&Station<R>, Place<R>, usize) -> Heights<R>,
        into: [&mut [Place<R>]; N],
    ) -> bool {
        let Some(placed) = self.place(overlap) else { return false };
        let by_vertices = [[R::from_f64(0.0); 2]; MOST];
        let mut chains = into.map(|into| Chain { into, by_normal: zero(), by_vertices });
        let normal = placed.plane.normal;
        let is_whole = self.stations(overlap, &placed, |station| {
            for (k, chain) in chains.iter_mut().enumerate() {
                self.pull_station(station, &placed, &heights(station, normal, k), chain);
            }
        });
        for chain in &mut chains {
            self.pull_vertices(overlap, &placed, chain);
            let (by_normal, plane) = (chain.by_normal, (overlap.piece, &placed.plane));
            self.slave.pull_normal(plane, by_normal, chain.into);
        }
        is_whole
    }

    fn pull_station(
        &self,
        station: &Station<R>,
        placed: &Placed<R>,
        heights: &Heights<R>,
        chain: &mut Chain<'_, R>,
    ) {
        let cell = R::from_f64(station.weight) * station.twice;
        let whole = cell * station.measure;
        let lifted = lift(&station.met.along, placed.plane.normal, heights.by_faced);
        let (slaves, one) = (self.slave.count, R::from_f64(1.0));
        let on_slave = scale(whole, add_scaled(heights.on_slave, one, lifted));
        let on_master = scale(whole, sub(heights.on_master, lifted));
        chain.add(0, &station.slave.value[..slaves], on_slave);
        chain.add(slaves, &station.met.shapes.value[..self.master.count], on_master);
        let turned = add_scaled(heights.on_normal, station.met.gap, lifted);
        chain.by_normal = add_scaled(chain.by_normal, whole, turned);
        let by_place: [R; 2] = std::array::from_fn(|k| {
            let slope = heights.slope[k] + dot(lifted, station.along[k]);
            cell * (station.measure_slope[k] * heights.inner + station.measure * slope)
        });
        let by_twice = R::from_f64(station.weight) * station.measure * heights.inner;
        chain.move_triangle(station, placed, by_place, by_twice);
    }

    /// What derivatives by the corners of the overlap are by nodes. A corner within the surface of the master bounds
    /// nothing: what one overlap loses with it another one wins, in the integrals to the error of the rule alone.
    /// Between two edges that are almost parallel that error would be divided by the angle between them.
    fn pull_vertices(&self, overlap: &Overlap, placed: &Placed<R>, chain: &mut Chain<'_, R>) {
        let piece = pieces(self.slave.count)[overlap.piece];
        let of_master = pieces(self.master.count)[overlap.master_piece];
        let of_node = |k: usize| place_of(self.slave.count, piece[k % piece.len()]);
        let slave = |k: usize| piece[k % piece.len()];
        let master = |k: usize| self.slave.count + of_master[k];
        let (own, other) = self.pieces(overlap);
        let at = |k: usize| own.nodes[k % piece.len()];
        let normal = placed.plane.normal;
        let one = R::from_f64(1.0);
        for (vertex, &corner) in overlap.corners().iter().enumerate() {
            if !self.is_bound(overlap, corner) {
                continue;
            }
            let stands = &placed.vertices[vertex];
            let by = chain.by_vertices[vertex];
            let by_edge = |edge: usize| {
                let way = flat_sub(of_node(edge + 1), of_node(edge)).map(R::from_f64);
                stands.slope * (by[0] * way[0] + by[1] * way[1])
            };
            let along = stands.along;
            match corner {
                Corner::Slave(_) => {}
                Corner::Master(k) => {
                    let Some(met) = meet(&own, other.nodes[k], normal) else { continue };
                    // the coordinates of a face are linear in those of its pieces
                    let by_moved = [0, 1].map(|axis: usize| {
                        let of = met.shapes.slope[axis].iter().take(piece.len()).enumerate();
                        of.fold(R::from_f64(0.0), |sum, (k, &slope)| {
                            let place = of_node(k).map(R::from_f64);
                            sum + slope * (by[0] * place[0] + by[1] * place[1])
                        })
                    });
                    let by_cell = [0, 1].map(|axis: usize| {
                        by_moved[0] * stands.by[0][axis] + by_moved[1] * stands.by[1][axis]
                    });
                    let lifted = lift(&met.along, normal, by_cell);
                    chain.push(master(k), one, lifted);
                    for (k, &shape) in met.shapes.value.iter().take(piece.len()).enumerate() {
                        chain.push(slave(k), -shape, lifted);
                    }
                    // from the corner to the slave along the normal
                    chain.by_normal = add_scaled(chain.by_normal, met.gap, lifted);
                }
                Corner::Upon { edge, master: k } => {
                    let (from, way) = (at(edge), sub(at(edge + 1), at(edge)));
                    let by = by_edge(edge) / dot(way, way);
                    let off = sub(other.nodes[k], from);
                    chain.push(master(k), by, way);
                    let two = R::from_f64(2.0) * along;
                    let by_way = sub(off, scale(two, way));
                    chain.push(slave(edge), -by, add_scaled(way, one, by_way));
                    chain.push(slave(edge + 1), by, by_way);
                }
                Corner::Crossing { edge, master: [c, d] } => {
                    let of_slave = [edge, edge + 1].map(|k| (slave(k), at(k)));
                    let of_master = [c, d].map(|k| (master(k), other.nodes[k]));
                    chain.move_crossing((of_slave, of_master), normal, (along, by_edge(edge)));
                }
            }
        }
    }
}

impl Couple<'_, f64> {
    /// The same of ways that were carried.
    pub fn pull_carried<const N: usize>(
        &self,
        overlap: &Overlap,
        carried: &[Carried<'_>; N],
        into: [&mut [Place<f64>]; N],
    ) -> bool {
        self.pull_all(overlap, |station, _, k| carried[k].heights(station), into)
    }

    /// Adds what turning the normal of an overlap does.
    pub fn pull_normal(&self, overlap: &Overlap, by: Place<f64>, into: &mut [Place<f64>]) {
        if let Some(plane) = self.plane(overlap) {
            self.slave.pull_normal((overlap.piece, &plane), by, into);
        }
    }

    /// Unit normal of the piece of an overlap [1].
    pub fn normal(&self, overlap: &Overlap) -> Place<f64> {
        self.plane(overlap).map_or([0.0; 3], |plane| plane.normal)
    }

    /// Corners of the slave.
    pub fn corners(&self) -> usize {
        corners(self.slave.count)
    }
}

impl<R: Real> Chain<'_, R> {
    fn push(&mut self, node: usize, factor: R, force: Place<R>) {
        self.into[node] = add_scaled(self.into[node], factor, force);
    }

    /// A force on a place of a face whose first node is `first`.
    fn add(&mut self, first: usize, shapes: &[R], force: Place<R>) {
        for (node, &shape) in shapes.iter().enumerate() {
            self.push(first + node, shape, force);
        }
    }

    /// What a derivative by the place of a crossing along the edge of the slave is by the ends of
    /// both edges.
    fn move_crossing(
        &mut self,
        ([(a, from), (b, to)], [(c, first), (d, last)]): (Edge<R>, Edge<R>),
        normal: Place<R>,
        (along, by_edge): (R, R),
    ) {
        let one = R::from_f64(1.0);
        let (way, edge) = (sub(to, from), sub(last, first));
        let by = -(by_edge / dot(cross(way, edge), normal));
        let off = sub(add_scaled(from, along, way), first);
        let (by_off, by_other) = (cross(edge, normal), cross(normal, off));
        self.push(a, by * (one - along), by_off);
        self.push(b, by * along, by_off);
        self.push(c, -by, add_scaled(by_off, one, by_other));
        self.push(d, by, by_other);
        self.by_normal = add_scaled(self.by_normal, by, cross(off, edge));
    }

    /// Derivatives by a place and by the area of its triangle, to the corners of that.
    fn move_triangle(
        &mut self,
        station: &Station<R>,
        placed: &Placed<R>,
        by_place: [R; 2],
        by_twice: R,
    ) {
        for (k, &vertex) in station.triangle.iter().enumerate() {
            let into = &mut self.by_vertices[vertex];
            *into = flat_add(*into, R::from_f64(station.fractions[k]), by_place);
            let [next, last] =
                [1, 2].map(|way| placed.vertices[station.triangle[(k + way) % 3]].at);
            let across = flat_sub(next, last);
            *into = flat_add(*into, by_twice, [across[1], -across[0]]);
        }
    }
}
