//! Hollows of plane parts: what stands outside never meets their walls, and what stands in one meets
//! no other outline.
//!
//! ```text
//!    o-----------o
//!    |  o-----o  |   s      s meets the outside of the plate, t the wall of its hole: nothing passes
//!    |  |  t  |  |          through a part
//!    |  o-----o  |
//!    o-----------o
//! ```
//!
//! [`Outlines`] are pieces of lines whose faces run as those of solids do, the part on their left. docs/theory.md
//! section 5.12. (derived)

use std::collections::HashMap;

use slideline_model::{NodeIndex, Nodes};

/// A place; the third coordinate means nothing in the plane [L].
type Place = [f64; 3];

/// Most distances between nodes and faces that are computed.
pub(super) const DISTANCES: usize = 10_000_000;

/// The faces of a part of the plane, one outline after the other.
pub(super) struct Outlines {
    all: Vec<Outline>,
}

struct Outline {
    faces: Vec<[Place; 2]>,
    /// Whether it closes on itself around what is no part.
    is_hollow: bool,
}

/// Faces that are joined at their ends, by their places in the list.
pub(super) fn joined(faces: &[[NodeIndex; 2]]) -> Vec<Vec<usize>> {
    let mut at: HashMap<NodeIndex, Vec<usize>> = HashMap::new();
    for (place, ends) in faces.iter().enumerate() {
        ends.iter().for_each(|&node| at.entry(node).or_default().push(place));
    }
    let (mut taken, mut pieces) = (vec![false; faces.len()], Vec::new());
    for first in 0..faces.len() {
        if std::mem::replace(&mut taken[first], true) {
            continue;
        }
        let (mut piece, mut next) = (vec![first], 0);
        while let Some(&face) = piece.get(next) {
            next += 1;
            for &other in faces[face].iter().flat_map(|node| &at[node]) {
                if !std::mem::replace(&mut taken[other], true) {
                    piece.push(other);
                }
            }
        }
        piece.sort_unstable();
        pieces.push(piece);
    }
    pieces
}

impl Outlines {
    /// The outlines that are made of these faces, each with whether all are of solids: others have no inside.
    pub fn new(pieces: &[(Vec<[NodeIndex; 2]>, bool)], nodes: &Nodes) -> Self {
        let place = |node: NodeIndex| nodes.position(node);
        let outline = |(piece, of_solids): &(Vec<[NodeIndex; 2]>, bool)| {
            let faces: Vec<_> = piece.iter().map(|ends| ends.map(place)).collect();
            let is_hollow = *of_solids && is_closed(piece) && area(&faces) < 0.0;
            Outline { faces, is_hollow }
        };
        Self { all: pieces.iter().map(outline).collect() }
    }

    /// Of every outline whether something with these nodes may meet it.
    pub fn met_by(&self, nodes: &[NodeIndex], known: &Nodes) -> Vec<bool> {
        if !self.all.iter().any(|outline| outline.is_hollow) {
            return vec![true; self.all.len()];
        }
        let faces = self.all.iter().map(|outline| outline.faces.len()).sum::<usize>();
        let step = nodes.len().div_ceil((DISTANCES / faces.max(1)).max(1)).max(1);
        let places = nodes.iter().step_by(step).map(|&node| known.position(node));
        let within: Vec<Vec<bool>> = places.map(|place| self.within(place)).collect();
        let all_in = |hollow: usize| within.iter().all(|own| own[hollow]);
        let hollows = || (0..self.all.len()).filter(|&own| self.all[own].is_hollow);
        let may = |own: usize| match self.all[own].is_hollow {
            true => within.iter().any(|places| places[own]),
            // what stands in a hollow meets of other outlines those in there
            false => !hollows().any(|hollow| all_in(hollow) && !self.stands_in(own, hollow)),
        };
        (0..self.all.len()).map(may).collect()
    }

    /// Of every hollow whether a place is in it: its wall goes around that, or is the nearest, as of a
    /// shaft that is wider than its bore.
    fn within(&self, place: Place) -> Vec<bool> {
        let distances = self.all.iter().map(|outline| outline.distance(place));
        let nearest = distances.enumerate().min_by(|a, b| a.1.total_cmp(&b.1));
        let is_nearest = |own: usize| nearest.is_some_and(|(nearest, _)| nearest == own);
        let all = self.all.iter().enumerate();
        all.map(|(k, own)| own.is_hollow && (is_nearest(k) || own.surrounds(place))).collect()
    }

    /// Whether an outline stands in a hollow.
    fn stands_in(&self, own: usize, hollow: usize) -> bool {
        let first = self.all[own].faces.first();
        first.is_some_and(|face| self.all[hollow].surrounds(face[0]))
    }
}

impl Outline {
    /// Square of the distance of a place from its faces [L2].
    fn distance(&self, place: Place) -> f64 {
        let square = |[a, b]: &[Place; 2]| {
            let (along, way) = (minus(*b, *a), minus(place, *a));
            let part = (dot(way, along) / dot(along, along)).clamp(0.0, 1.0);
            let apart = [way[0] - part * along[0], way[1] - part * along[1], 0.0];
            dot(apart, apart)
        };
        self.faces.iter().map(square).fold(f64::INFINITY, f64::min)
    }

    /// Whether it goes around a place: a ray from there crosses it an odd number of times.
    fn surrounds(&self, [x, y, _]: Place) -> bool {
        let crosses = |&&[a, b]: &&[Place; 2]| {
            (a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
        };
        self.faces.iter().filter(crosses).count() % 2 == 1
    }
}

/// Whether every node joins two faces.
fn is_closed(piece: &[[NodeIndex; 2]]) -> bool {
    let mut count: HashMap<NodeIndex, usize> = HashMap::new();
    piece.iter().flatten().for_each(|&node| *count.entry(node).or_default() += 1);
    count.values().all(|&count| count == 2)
}

/// The area that faces go around, with what they are the faces of on their left [L2]; negative around a hollow.
fn area(faces: &[[Place; 2]]) -> f64 {
    let from = faces.first().map_or([0.0; 3], |face| face[0]);
    let parts = faces.iter().map(|&[a, b]| {
        let (a, b) = (minus(a, from), minus(b, from));
        0.5 * (a[0] * b[1] - a[1] * b[0])
    });
    parts.sum()
}

fn minus(a: Place, b: Place) -> Place {
    [a[0] - b[0], a[1] - b[1], 0.0]
}

fn dot(a: Place, b: Place) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}
