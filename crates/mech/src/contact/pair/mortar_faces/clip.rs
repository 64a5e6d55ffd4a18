//! What a piece of the master covers of a piece of the slave.
//!
//! ```text
//!       m---------m             the piece of the master is cut along the edges of the slave,
//!    s--|---------|--s          one after the other; every edge of the polygon knows which
//!    |  |  polygon|  |          edge it came from, so that every corner knows what moves it
//!    s--x---------x--s
//! ```
//!
//! [sutherland1974]

use super::face_places::FacePlaces;
use super::places::{cross, dot, flat_cross, flat_sub, scale, sub};

/// Most corners of an overlap.
pub const MOST: usize = 8;
/// Part of a piece below which places are one [1].
const SAME: f64 = 1e-9;
/// Part of a piece below which an overlap is none [1].
const LEAST: f64 = 1e-12;

/// What moves a corner of an overlap. Numbers are those of corners of the pieces; an edge begins at
/// the corner of its number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Corner {
    /// It is a corner of the slave.
    Slave(usize),
    /// It is a corner of the master, upon the slave.
    Master(usize),
    /// A corner of the master stands upon an edge of the slave.
    Upon {
        /// The edge of the slave.
        edge: usize,
        /// The corner of the master.
        master: usize,
    },
    /// An edge of the slave meets an edge of the master.
    Crossing {
        /// The edge of the slave.
        edge: usize,
        /// The ends of the edge of the master.
        master: [usize; 2],
    },
}

/// What a piece of a face of the master covers of a piece of the slave.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overlap {
    /// The piece of the slave.
    pub piece: usize,
    /// The face of the master, by its place in a list.
    pub master: usize,
    /// Its piece.
    pub master_piece: usize,
    /// How much of its integrals counts [1]: one, but where it goes over into what is left out.
    pub counts: f64,
    /// Whether some of it is left out as it went in through another side of the master.
    pub went_in_elsewhere: bool,
    corners: [Corner; MOST],
    count: usize,
}

impl Overlap {
    /// Its corners, counter-clockwise upon the slave.
    pub fn corners(&self) -> &[Corner] {
        &self.corners[..self.count]
    }
}

/// Where an edge of a polygon comes from.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Edge {
    Slave(usize),
    Master([usize; 2]),
}

#[derive(Debug, Clone, Copy)]
struct Vertex {
    at: [f64; 2],
    corner: Corner,
    /// The edge that leaves it.
    edge: Edge,
}

/// Most vertices while a polygon is cut.
const ROOM: usize = MOST + 4;

/// The vertices of a polygon that is cut.
#[derive(Debug, Clone, Copy)]
struct Vertices {
    all: [Vertex; ROOM],
    count: usize,
}

impl Vertices {
    const NONE: Self = {
        let none = Vertex { at: [0.0; 2], corner: Corner::Slave(0), edge: Edge::Slave(0) };
        Self { all: [none; ROOM], count: 0 }
    };

    fn own(&self) -> &[Vertex] {
        &self.all[..self.count]
    }

    /// Adds a vertex; `None` where there are more than cut pieces have.
    fn push(&mut self, vertex: Vertex) -> Option<()> {
        *self.all.get_mut(self.count)? = vertex;
        self.count += 1;
        Some(())
    }
}

/// A polygon in the plane of a piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Polygon {
    places: [[f64; 2]; MOST],
    count: usize,
}

/// A piece of the slave in the coordinates of its plane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Window {
    /// Its normal [1].
    pub normal: [f64; 3],
    axes: [[f64; 3]; 2],
    corners: Polygon,
    /// Its area [L2].
    pub area: f64,
}

impl Polygon {
    /// Its corners [L].
    pub fn places(&self) -> &[[f64; 2]] {
        &self.places[..self.count]
    }

    /// Its area, positive counter-clockwise [L2].
    pub fn area(&self) -> f64 {
        let places = self.places();
        let after = places.iter().cycle().skip(1);
        places.iter().zip(after).map(|(&a, &b)| 0.5 * flat_cross(a, b)).sum()
    }

    /// The mean of its corners [L].
    pub fn middle(&self) -> [f64; 2] {
        let sum = self.places().iter().fold([0.0; 2], |sum, at| [sum[0] + at[0], sum[1] + at[1]]);
        sum.map(|own| own / self.count.max(1) as f64)
    }

    /// The area that it has in common with another one [L2].
    pub fn common(&self, other: &Self) -> f64 {
        let mut own: Vec<[f64; 2]> = self.places().to_vec();
        let edges = other.places();
        for (k, &from) in edges.iter().enumerate() {
            let along = flat_sub(edges[(k + 1) % edges.len()], from);
            let off = |at: [f64; 2]| flat_cross(along, flat_sub(at, from));
            let mut left = Vec::with_capacity(own.len() + 1);
            for (place, &at) in own.iter().enumerate() {
                let next = own[(place + 1) % own.len()];
                let (here, there) = (off(at), off(next));
                if here >= 0.0 {
                    left.push(at);
                }
                if (here < 0.0) != (there < 0.0) {
                    let t = here / (here - there);
                    left.push([at[0] + t * (next[0] - at[0]), at[1] + t * (next[1] - at[1])]);
                }
            }
            own = left;
        }
        let after = own.iter().cycle().skip(1);
        own.iter().zip(after).map(|(&a, &b)| 0.5 * flat_cross(a, b)).sum()
    }
}

impl Window {
    /// The window of a piece; `None` where it has collapsed.
    pub fn new(slave: &FacePlaces<f64>, piece: usize) -> Option<Self> {
        let normal = slave.plane(piece)?.normal;
        let own = slave.piece(piece);
        let edge = sub(own.nodes[1], own.nodes[0]);
        let along = sub(edge, scale(dot(edge, normal), normal));
        let first = scale(1.0 / dot(along, along).sqrt(), along);
        let axes = [first, cross(normal, first)];
        let none = Polygon { places: [[0.0; 2]; MOST], count: 0 };
        let mut window = Self { normal, axes, corners: none, area: 0.0 };
        window.corners = window.seen(&own);
        window.area = window.corners.area();
        (window.area > 0.0).then_some(window)
    }

    /// Corners of the piece as they are seen [L].
    pub fn corners(&self) -> &[[f64; 2]] {
        self.corners.places()
    }

    /// The place of its plane through the origin that is seen there [L].
    pub fn in_space(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        std::array::from_fn(|axis| x * self.axes[0][axis] + y * self.axes[1][axis])
    }

    fn see(&self, at: [f64; 3]) -> [f64; 2] {
        self.axes.map(|axis| dot(axis, at))
    }

    fn seen(&self, piece: &FacePlaces<f64>) -> Polygon {
        let mut places = [[0.0; 2]; MOST];
        for (into, &at) in places.iter_mut().zip(&piece.nodes[..piece.count]) {
            *into = self.see(at);
        }
        Polygon { places, count: piece.count }
    }

    /// What a piece of the master covers, with its corners as they are seen; `None`: nothing.
    pub fn cut(
        &self,
        (piece, master, master_piece): (usize, usize, usize),
        of_master: &FacePlaces<f64>,
    ) -> Option<(Overlap, Polygon)> {
        let seen = self.seen(of_master);
        let mut polygon = subject(&seen);
        let edges = self.corners.places();
        for edge in 0..edges.len() {
            polygon = self.cut_along(edge, &polygon)?;
        }
        let count = polygon.count;
        if !(3..=MOST).contains(&count) {
            return None;
        }
        let mut corners = [Corner::Slave(0); MOST];
        let mut places = [[0.0; 2]; MOST];
        for (k, vertex) in polygon.own().iter().enumerate() {
            (corners[k], places[k]) = (vertex.corner, vertex.at);
        }
        let left = Polygon { places, count };
        let (counts, went_in_elsewhere) = (1.0, false);
        let overlap =
            Overlap { piece, master, master_piece, counts, went_in_elsewhere, corners, count };
        (left.area() > LEAST * self.area).then_some((overlap, left))
    }

    /// What of a polygon is on the inner side of an edge; `None` where it is cut as no sound piece
    /// is.
    fn cut_along(&self, edge: usize, polygon: &Vertices) -> Option<Vertices> {
        let edges = self.corners.places();
        let from = edges[edge];
        let along = flat_sub(edges[(edge + 1) % edges.len()], from);
        let length = along[0].hypot(along[1]);
        let same = SAME * self.area.sqrt();
        let off = |vertex: &Vertex| match flat_cross(along, flat_sub(vertex.at, from)) / length {
            own if own.abs() <= same => 0.0,
            own => own,
        };
        let mut left = Vertices::NONE;
        for (k, vertex) in polygon.own().iter().enumerate() {
            let next = &polygon.all[(k + 1) % polygon.count];
            let (here, there) = (off(vertex), off(next));
            if here == 0.0 {
                let corner = upon(vertex.corner, edge, edges.len());
                // an edge upon that of the slave bounds nothing: what is beyond it is another face's
                let leaves = if there > 0.0 { vertex.edge } else { Edge::Slave(edge) };
                left.push(Vertex { corner, edge: leaves, ..*vertex })?;
            } else if here > 0.0 {
                left.push(*vertex)?;
            }
            if here * there < 0.0 {
                let t = here / (here - there);
                let at = std::array::from_fn(|axis| {
                    vertex.at[axis] + t * (next.at[axis] - vertex.at[axis])
                });
                let corner = match vertex.edge {
                    Edge::Master(master) => Corner::Crossing { edge, master },
                    Edge::Slave(other) => Corner::Slave(meeting(edge, other, edges.len())?),
                };
                let leaves = if here > 0.0 { Edge::Slave(edge) } else { vertex.edge };
                left.push(Vertex { at, corner, edge: leaves })?;
            }
        }
        Some(left)
    }
}

/// A piece of the master as a polygon that runs counter-clockwise.
fn subject(seen: &Polygon) -> Vertices {
    let (count, mut own) = (seen.count, Vertices::NONE);
    let is_turned = seen.area() < 0.0;
    let number = |k: usize| if is_turned { count - 1 - k % count } else { k % count };
    let vertex = |k: usize| Vertex {
        at: seen.places[number(k)],
        corner: Corner::Master(number(k)),
        edge: Edge::Master([number(k), number(k + 1)]),
    };
    own.all.iter_mut().zip((0..count).map(vertex)).for_each(|(into, vertex)| *into = vertex);
    own.count = count;
    own
}

/// A corner that stands upon an edge.
fn upon(corner: Corner, edge: usize, edges: usize) -> Corner {
    match corner {
        Corner::Master(master) => Corner::Upon { edge, master },
        Corner::Upon { edge: other, .. } | Corner::Crossing { edge: other, .. } => {
            meeting(edge, other, edges).map_or(corner, Corner::Slave)
        }
        Corner::Slave(_) => corner,
    }
}

/// The corner that two edges have in common.
fn meeting(a: usize, b: usize, edges: usize) -> Option<usize> {
    if a == (b + 1) % edges {
        Some(a)
    } else if b == (a + 1) % edges {
        Some(b)
    } else {
        None
    }
}
