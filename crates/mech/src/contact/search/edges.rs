//! Do two sharp edges stand against one another?
//!
//! ```text
//!      \   /  slave        all four faces at the two edges fall away from the plane across n:
//!       \ /    ^ n         edges carry; else a face of one side stands before the other edge, and
//!   =====x=====            faces carry
//!     master edge
//! ```
//!
//! [docs/theory.md, section 5.18]

use super::tree::Bounds;
use crate::vector::{Vector, cross, dot, scale, size, sub};

/// Sine of the angle by which a face at an edge may rise above the plane across the normal and still falls away from
/// it [1]: faces that are pressed bend.
const RISE: f64 = 0.1;

/// An edge with the ways from it into its two faces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlacedEdge {
    /// Its ends [L].
    pub ends: [Vector; 2],
    /// Unit vectors across it that lead into its faces [1].
    pub into_faces: [Vector; 2],
    /// How far its faces go that way [L].
    pub widths: [f64; 2],
}

impl PlacedEdge {
    /// An edge between two faces by their normals, of any length, and their corners: the first face has it counter-clockwise.
    pub fn new<C: IntoIterator<Item = Vector>>(
        ends: [Vector; 2],
        [first, second]: [Vector; 2],
        corners: [C; 2],
    ) -> Self {
        let way = sub(ends[1], ends[0]);
        let unit = |v: Vector| {
            let long = size(v);
            if long > 0.0 { scale(v, 1.0 / long) } else { v }
        };
        let into_faces = [unit(cross(first, way)), unit(cross(way, second))];
        let mut widths = [0.0_f64; 2];
        for ((width, into), corners) in widths.iter_mut().zip(into_faces).zip(corners) {
            let along = corners.into_iter().map(|corner| dot(into, sub(corner, ends[0])));
            *width = along.fold(0.0, f64::max);
        }
        Self { ends, into_faces, widths }
    }

    /// How far its body goes behind it along a normal, by its two faces at least [L].
    pub fn reach(&self, normal: Vector) -> f64 {
        let along = self.into_faces.iter().zip(self.widths);
        along.map(|(way, width)| width * dot(*way, normal).abs()).fold(0.0, f64::max)
    }

    /// Its length [L].
    pub fn length(&self) -> f64 {
        size(sub(self.ends[1], self.ends[0]))
    }

    /// Out of the body that it is of, between its faces.
    pub fn outward(&self) -> Vector {
        let [a, b] = self.into_faces;
        std::array::from_fn(|k| -a[k] - b[k])
    }

    /// The box of what is nearer to it than it is long [L].
    pub fn bounds(&self) -> Bounds<3> {
        let ([a, b], room) = (self.ends, self.length());
        let low = std::array::from_fn(|k| a[k].min(b[k]) - room);
        (low, std::array::from_fn(|k| a[k].max(b[k]) + room))
    }

    /// Whether the faces of a slave, and of a master, fall away from the plane across `normal`, which points out of
    /// the master.
    pub fn stands_against(&self, master: &Self, normal: Vector) -> bool {
        let above = self.into_faces.iter().all(|&way| dot(way, normal) >= -RISE);
        let below = master.into_faces.iter().all(|&way| dot(way, normal) <= RISE);
        above && below && dot(self.outward(), normal) < 0.0 && dot(master.outward(), normal) > 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: a ridge on a ridge across it is met; one that comes from the other side of either is not, nor is
    /// an edge on a face that does not fall away.
    #[test]
    fn ridges_meet_from_outside_alone() {
        let along = [[-1.0, 0.0, 0.1], [1.0, 0.0, 0.1]];
        let across = [[0.0, -1.0, 0.0], [0.0, 1.0, 0.0]];
        // a roof upside down above a roof
        let slave = PlacedEdge::new(along, [[0.0, -1.0, -1.0], [0.0, 1.0, -1.0]], [[]; 2]);
        let master = PlacedEdge::new(across, [[-1.0, 0.0, 1.0], [1.0, 0.0, 1.0]], [[]; 2]);
        let up = [0.0, 0.0, 1.0];
        assert!(dot(slave.outward(), up) < 0.0 && dot(master.outward(), up) > 0.0);
        assert!(slave.stands_against(&master, up));
        assert!(!master.stands_against(&slave, up));
        assert!(!slave.stands_against(&master, scale(up, -1.0)));
        let steep = PlacedEdge::new(across, [[-1.0, 0.0, 1.0], [1.0, 0.0, -0.5]], [[]; 2]);
        assert!(slave.stands_against(&steep, up));
        // a body goes as far behind its edge as the corners of its faces
        let corners = [[[0.0, 0.0, 0.0], [-1.0, 0.0, -1.0]], [[0.0, 0.0, 0.0], [2.0, 0.0, -2.0]]];
        let roof = PlacedEdge::new(across, [[-1.0, 0.0, 1.0], [1.0, 0.0, 1.0]], corners);
        assert!((roof.reach(up) - 2.0).abs() < 1e-15 && roof.reach([0.0, 1.0, 0.0]) == 0.0);
        let hollow = PlacedEdge::new(across, [[1.0, 0.0, 1.0], [-1.0, 0.0, 1.0]], [[]; 2]);
        assert!(!slave.stands_against(&hollow, up));
    }
}
