//! A face of a surface in space: flat, smoothed by the normals at its corners, or analytical over
//! the markers of a rigid body.
//!
//! ```text
//!      N_4       N_3        X = sum N_i P_i - sum phi_ab ((P_b - P_a) . N_a) N_a
//!        \_______/
//!        /       /          every edge is a cubic that leaves its corners at right angles
//!    P_1/_______/P_2        to their normals; the inside is blended between the edges
//! ```
//!
//! [docs/theory.md, eq. (5.15)] [vlachos2001] [coons1967]

use super::jet::Jet;
use super::swept::Chart;
use crate::element::cell::{Cell, QUAD4};
use crate::vector::{Vector, add, cross, dot, scale, size, sub};

/// The most nodes of a face.
pub const MOST_NODES: usize = 8;
/// The most corners of a face.
pub const MOST_CORNERS: usize = 4;
/// The most vectors that a gap against a face follows: the slave, then nodes, then normals.
pub const MOST_PARTS: usize = 9;

/// A covector of the variables of a gap: a force on each of them.
pub type Parts = [Vector; MOST_PARTS];

/// A face in its current place.
#[derive(Debug, Clone)]
pub struct Patch {
    cell: &'static Cell,
    nodes: [Vector; MOST_NODES],
    /// Normals at the corners [1], where the face is smoothed.
    normals: Option<[Vector; MOST_CORNERS]>,
    /// Of an analytical surface, whose nodes are the markers of its body.
    chart: Option<Chart>,
}

/// Weights of the nodes, and of the bends of its edges: of a place, or derivatives of them.
#[derive(Debug, Clone, Copy, Default)]
pub struct Weights {
    shapes: [f64; MOST_NODES],
    /// Of every edge as it leaves its first corner, and as it leaves its second one.
    bends: [[f64; 2]; MOST_CORNERS],
}

/// Weights at a place with their first and second derivatives (11, 22, 12) by its coordinates.
#[derive(Debug, Clone, Copy)]
pub struct Place {
    /// Of the place.
    pub value: Weights,
    /// By each coordinate.
    pub first: [Weights; 2],
    /// By both, twice.
    pub second: [Weights; 3],
}

impl Place {
    /// The weights of two coordinates' second derivative.
    pub fn second(&self, a: usize, b: usize) -> &Weights {
        &self.second[if a == b { a } else { 2 }]
    }
}

impl Patch {
    /// The face of a cell with three or four corners; `normals` are unit vectors.
    pub fn new(cell: &'static Cell, nodes: &[Vector], normals: Option<&[Vector]>) -> Self {
        let mut own = Self { cell, nodes: [[0.0; 3]; MOST_NODES], normals: None, chart: None };
        own.nodes.iter_mut().zip(nodes).for_each(|(own, node)| *own = *node);
        if let Some(given) = normals {
            let mut all = [[0.0; 3]; MOST_CORNERS];
            all.iter_mut().zip(given).for_each(|(own, normal)| *own = *normal);
            own.normals = Some(all);
        }
        own
    }

    /// A part of an analytical surface on the markers of its body.
    pub fn on_markers(chart: Chart, markers: &[Vector]) -> Self {
        let mut own = Self::new(&QUAD4, markers, None);
        own.chart = Some(chart);
        own
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.cell.nodes
    }

    /// Number of corners.
    pub fn corners(&self) -> usize {
        self.cell.faces.len()
    }

    /// The middle of the reference cell.
    pub fn middle(&self) -> [f64; 2] {
        if self.corners() == 3 { [1.0 / 3.0; 2] } else { [0.0; 2] }
    }

    /// Vectors that a gap against it follows: the slave, nodes, normals.
    pub fn parts(&self) -> usize {
        1 + self.nodes() + if self.normals.is_some() { self.corners() } else { 0 }
    }

    /// Weights at a place of the reference cell.
    pub fn place(&self, at: [f64; 2]) -> Place {
        let mut place = Place {
            value: Weights::default(),
            first: [Weights::default(); 2],
            second: [Weights::default(); 3],
        };
        match &self.chart {
            Some(chart) => markers(chart, at, &mut place),
            None => self.shapes(at, &mut place),
        }
        if self.normals.is_some() {
            self.bends(at, &mut place);
        }
        place
    }

    fn shapes(&self, at: [f64; 2], place: &mut Place) {
        let [x, y] = at;
        let slopes = |x: f64, y: f64| {
            let mut slopes = [[0.0; 3]; MOST_NODES];
            (self.cell.slopes)(&[x, y, 0.0], &mut slopes);
            slopes
        };
        (self.cell.shapes)(&[x, y, 0.0], &mut place.value.shapes);
        // slopes have degree two at most in a coordinate: their central difference is exact
        let own = slopes(x, y);
        let by_x = [slopes(x + 1.0, y), slopes(x - 1.0, y)];
        let by_y = [slopes(x, y + 1.0), slopes(x, y - 1.0)];
        for node in 0..self.nodes() {
            for (first, slope) in place.first.iter_mut().zip(own[node]) {
                first.shapes[node] = slope;
            }
            let difference = |[plus, minus]: &[[Vector; MOST_NODES]; 2], axis: usize| {
                0.5 * (plus[node][axis] - minus[node][axis])
            };
            place.second[0].shapes[node] = difference(&by_x, 0);
            place.second[1].shapes[node] = difference(&by_y, 1);
            place.second[2].shapes[node] = difference(&by_y, 0);
        }
    }

    fn bends(&self, at: [f64; 2], place: &mut Place) {
        let mut put = |edge: usize, side: usize, jet: Jet| {
            place.value.bends[edge][side] = jet.value;
            for axis in 0..2 {
                place.first[axis].bends[edge][side] = jet.first[axis];
            }
            for k in 0..3 {
                place.second[k].bends[edge][side] = jet.second[k];
            }
        };
        let one = |jet: Jet| Jet::constant(1.0).plus(jet.times(-1.0));
        if self.corners() == 3 {
            let (x, y) = (Jet::coordinate(at[0], 0), Jet::coordinate(at[1], 1));
            let corner = [one(x.plus(y)), x, y];
            let inside = corner[0].by(corner[1]).by(corner[2]).times(0.5);
            for edge in 0..3 {
                let (a, b) = (corner[edge], corner[(edge + 1) % 3]);
                put(edge, 0, a.by(a).by(b).plus(inside));
                put(edge, 1, b.by(b).by(a).plus(inside));
            }
            return;
        }
        let half =
            |axis: usize| Jet::coordinate(at[axis], axis).plus(Jet::constant(1.0)).times(0.5);
        let (a, b) = (half(0), half(1));
        let edges = [(a, one(b)), (b, a), (one(a), b), (one(b), one(a))];
        for (edge, (along, beside)) in edges.into_iter().enumerate() {
            let left = one(along);
            put(edge, 0, along.by(left).by(left).by(beside));
            put(edge, 1, along.by(along).by(left).by(beside));
        }
    }

    /// The directed edges: number, side, corner that is left, corner that is reached.
    fn edges(&self) -> impl Iterator<Item = (usize, usize, usize, usize)> + use<> {
        let corners = self.corners();
        (0..corners).flat_map(move |edge| {
            let next = (edge + 1) % corners;
            [(edge, 0, edge, next), (edge, 1, next, edge)]
        })
    }

    /// sum of weights times positions: a place, or a derivative of it [L].
    pub fn position(&self, weights: &Weights) -> Vector {
        let mut at = [0.0; 3];
        for (node, weight) in self.nodes[..self.nodes()].iter().zip(weights.shapes) {
            at = add(at, scale(*node, weight));
        }
        if let Some(normals) = &self.normals {
            for (edge, side, a, b) in self.edges() {
                let rise = dot(sub(self.nodes[b], self.nodes[a]), normals[a]);
                at = sub(at, scale(normals[a], weights.bends[edge][side] * rise));
            }
        }
        at
    }

    /// Adds `factor` times the derivative of m . position(weights) by nodes and normals.
    pub fn pull(&self, weights: &Weights, m: Vector, factor: f64, into: &mut Parts) {
        let count = self.nodes();
        for node in 0..count {
            into[1 + node] = add(into[1 + node], scale(m, factor * weights.shapes[node]));
        }
        let Some(normals) = &self.normals else { return };
        for (edge, side, a, b) in self.edges() {
            let c = factor * weights.bends[edge][side];
            let (way, n) = (sub(self.nodes[b], self.nodes[a]), normals[a]);
            let along = dot(m, n);
            into[1 + b] = sub(into[1 + b], scale(n, c * along));
            into[1 + a] = add(into[1 + a], scale(n, c * along));
            let by_normal = add(scale(way, along), scale(m, dot(way, n)));
            into[1 + count + a] = sub(into[1 + count + a], scale(by_normal, c));
        }
    }

    /// Adds `factor` times the second derivative of m . position(weights): `add(i, j, block)` takes
    /// blocks of parts i and j, both triangles.
    pub fn pull_twice(
        &self,
        weights: &Weights,
        m: Vector,
        factor: f64,
        add_block: &mut impl FnMut(usize, usize, [Vector; 3]),
    ) {
        let Some(normals) = &self.normals else { return };
        let count = self.nodes();
        for (edge, side, a, b) in self.edges() {
            let c = -factor * weights.bends[edge][side];
            let (way, n) = (sub(self.nodes[b], self.nodes[a]), normals[a]);
            let along = dot(m, n);
            let mixed = |i: usize, j: usize| c * (if i == j { along } else { 0.0 } + n[i] * m[j]);
            let block = block_of(mixed);
            let turned = block_of(|i, j| mixed(j, i));
            let (at, from, to) = (1 + count + a, 1 + a, 1 + b);
            add_block(to, at, block);
            add_block(at, to, turned);
            add_block(from, at, block.map(|row| scale(row, -1.0)));
            add_block(at, from, turned.map(|row| scale(row, -1.0)));
            add_block(at, at, block_of(|i, j| c * (way[i] * m[j] + m[i] * way[j])));
        }
    }

    /// Tangents by both coordinates [L] and the unit normal; `None` where the face has collapsed.
    pub fn frame(&self, place: &Place) -> Option<([Vector; 2], Vector)> {
        let tangents = [0, 1].map(|axis| self.position(&place.first[axis]));
        let normal = cross(tangents[0], tangents[1]);
        let area = size(normal);
        let lengths = size(tangents[0]) * size(tangents[1]);
        (area > f64::EPSILON * lengths).then(|| (tangents, scale(normal, 1.0 / area)))
    }
}

/// Weights of the four markers: those of the axes are coordinates over the markers' distance, that of
/// the origin is what is left of 1. [docs/theory.md, section 5.9]
fn markers(chart: &Chart, at: [f64; 2], place: &mut Place) {
    let along = chart.coordinates(at);
    let origin = along.iter().fold(Jet::constant(1.0), |left, own| left.plus(own.times(-1.0)));
    for (node, jet) in [origin].iter().chain(&along).enumerate() {
        place.value.shapes[node] = jet.value;
        for (first, slope) in place.first.iter_mut().zip(jet.first) {
            first.shapes[node] = slope;
        }
        for (second, bend) in place.second.iter_mut().zip(jet.second) {
            second.shapes[node] = bend;
        }
    }
}

/// A block by its entries.
fn block_of(entry: impl Fn(usize, usize) -> f64) -> [Vector; 3] {
    std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
}
