//! Where sharp edges cross.
//!
//! ```text
//!   edges in boxes about them --tree--> near pairs --gap--> crossings within both edges
//! ```
//!
//! docs/theory.md section 5.18

use super::sides::{EdgeCrossings, PlacedSides};
use slideline_mech::contact::gap::edges::{EdgeGap, Shares};
use slideline_mech::contact::search::edges::PlacedEdge;
use slideline_mech::vector::{size, sub};

/// Part of an edge by which a crossing may stand beyond it, where another edge of the line goes on [1]: the edge of the
/// last iteration keeps it, so that no iteration goes to and fro between two.
const SEAM: f64 = 0.05;

/// Two edges that cross.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Found {
    /// Of the slave and of the master.
    pub edges: [usize; 2],
    /// Where they cross.
    pub gap: EdgeGap,
    /// How far the bodies of both go behind them along the normal, together and by their faces at least [L].
    pub reach: f64,
}

impl PlacedSides {
    /// Calls back with all pairs of edges that are nearer than they are long.
    pub fn near_pairs(&self, mut each: impl FnMut([usize; 2], [&PlacedEdge; 2])) {
        let ([slaves, masters], Some(tree)) = (&self.edges, &self.tree) else { return };
        for (slave, own) in slaves.iter().enumerate() {
            let first = &mut each;
            tree.overlapping(own.bounds(), |master| {
                first([slave, master], [own, &masters[master]])
            });
        }
    }
}

impl EdgeCrossings {
    /// All crossings, each once, line by line; `held` says which are kept of two that are one.
    pub fn found(&self, placed: &PlacedSides, held: impl Fn([usize; 2]) -> bool) -> Vec<Found> {
        let mut all = Vec::new();
        placed.near_pairs(|edges, [slave, master]| {
            let ends = [slave.ends, master.ends];
            let Some(gap) = EdgeGap::new(ends, master.outward()) else { return };
            let is_near = gap.gap.abs() <= slave.length() + master.length();
            if is_near && self.is_within(edges, gap.at) && slave.stands_against(master, gap.normal)
            {
                let reach = slave.reach(gap.normal) + master.reach(gap.normal);
                all.push(Found { edges, gap, reach });
            }
        });
        all.sort_by_key(|own| (self.lines(own.edges), own.edges));
        let rank = |own: &Found| (held(own.edges), inside(own.gap.at));
        let is_better = |one: &Found, other: &Found| {
            let ((a, s), (b, t)) = (rank(one), rank(other));
            (a, s) > (b, t) || ((a, s) == (b, t) && one.edges < other.edges)
        };
        let mut once = Vec::with_capacity(all.len());
        for group in all.chunk_by(|a, b| self.lines(a.edges) == self.lines(b.edges)) {
            let is_other = |own: &Found, other: &Found| {
                own.edges != other.edges && self.is_one(own.edges, other.edges)
            };
            let keeps = |own: &&Found| {
                !group.iter().any(|other| is_other(own, other) && is_better(other, own))
            };
            once.extend(group.iter().filter(keeps));
        }
        once
    }

    /// How far a crossing is from the nearest end of a line of its edges at displacements `u` [L]; an edge that goes on counts
    /// with the next one.
    pub fn width(&self, found: &Found, u: &[f64]) -> f64 {
        let sides = self.sides().into_iter().zip(found.edges).zip(found.gap.at);
        let ends = sides.flat_map(|((side, edge), share)| {
            let long = |edge: usize| {
                let [a, b] = side.ends(edge, u);
                size(sub(b, a))
            };
            let beside = side.beside(edge).map(|other| other.map_or(0.0, long));
            [share * long(edge) + beside[0], (1.0 - share) * long(edge) + beside[1]]
        });
        ends.fold(f64::INFINITY, f64::min)
    }

    /// Whether a crossing is within both edges, or hardly beyond one where another goes on.
    fn is_within(&self, edges: [usize; 2], at: Shares) -> bool {
        let sides = self.sides().into_iter().zip(edges);
        sides.zip(at).all(|((side, edge), share)| {
            let room = side.beside(edge).map(|other| if other.is_some() { SEAM } else { 0.0 });
            (-room[0]..=1.0 + room[1]).contains(&share)
        })
    }

    /// Whether two crossings are one, beside a node of a line.
    fn is_one(&self, one: [usize; 2], other: [usize; 2]) -> bool {
        self.slave.are_near(one[0], other[0]) && self.master.are_near(one[1], other[1])
    }
}

/// How far a crossing is within both edges, in parts of them [1].
fn inside(at: Shares) -> f64 {
    at.into_iter().map(|share| share.min(1.0 - share)).fold(f64::INFINITY, f64::min)
}
