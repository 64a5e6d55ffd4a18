//! Solids that stand in one another before anything moves.
//!
//! ```text
//!      +-----+-----+
//!      |   +-|---+ |       points of each solid, a little inside of its corners, that are in a solid
//!      |   |.| . | |       of another body: what merely touches has none, and what overlaps by less
//!      +---|-+---|-+       than a part of an element has none either; there contact says more
//!          +-----+
//! ```

use crate::bodies::Bodies;
use crate::corners::corners;
use slideline_diag::Span;
use slideline_mech::contact::search::tree::{Bounds, BoxTree};
use slideline_mech::element::cell::{Cell, within};
use slideline_model::{Element, ElementBlock, Kinematics, Model, NodeIndex};
use std::collections::BTreeMap;

/// Part of the way from a corner to the middle of its element at which the element is looked at [1]: off all
/// nodes, edges and faces of a mesh of the same grid, and deeper than sides of round layers stand in one another.
const INWARDS: f64 = 0.77;
/// Distance from a cell at which a point is inside, in sizes of the model [1].
const UPON: f64 = 1e-9;

/// Solids of a body that stand in those of another one.
#[derive(Debug, Clone, Copy)]
pub struct StandingIn {
    /// Nodes that stand for the bodies, the lower one first.
    pub bodies: [NodeIndex; 2],
    /// Number and card of one of them.
    pub inner: (u64, Span),
    /// The number of one that it stands in.
    pub outer: u64,
}

/// A solid where it starts.
struct Solid {
    body: NodeIndex,
    label: u64,
    origin: Span,
    cell: &'static Cell,
    places: Vec<[f64; 3]>,
}

/// Solids of bodies that stand in others before anything moves, each two bodies once.
pub fn standing_in(model: &Model, bodies: &Bodies, reach: f64) -> Vec<StandingIn> {
    let solids = solids(model, bodies);
    let several = solids.iter().any(|own| own.body != solids[0].body);
    if !several {
        return Vec::new();
    }
    let bounds: Vec<Bounds<3>> = solids.iter().map(Solid::bounds).collect();
    let tree = BoxTree::<3>::new(solids.len(), |place| bounds[place]);
    let mut found: BTreeMap<[NodeIndex; 2], StandingIn> = BTreeMap::new();
    let mut near = Vec::new();
    for (own, &about) in solids.iter().zip(&bounds) {
        near.clear();
        tree.overlapping(about, |place| near.push(place));
        for &place in &near {
            let (other, (low, high)) = (&solids[place], bounds[place]);
            let bodies = [own.body.min(other.body), own.body.max(other.body)];
            let is_near = |at: [f64; 3]| (0..3).all(|k| low[k] <= at[k] && at[k] <= high[k]);
            if other.body != own.body
                && !found.contains_key(&bodies)
                && own.points().any(|at| is_near(at) && other.holds(at, UPON * reach))
            {
                let inner = (own.label, own.origin);
                found.insert(bodies, StandingIn { bodies, inner, outer: other.label });
            }
        }
    }
    found.into_values().collect()
}

fn solids(model: &Model, bodies: &Bodies) -> Vec<Solid> {
    present(model)
        .map(|(block, element)| Solid {
            body: bodies.of_node(element.nodes[0]),
            label: element.label,
            origin: element.origin,
            cell: block.kind.cell,
            places: element.nodes.iter().map(|&node| model.nodes.position(node)).collect(),
        })
        .collect()
}

/// Solids that no step takes away.
pub fn present(model: &Model) -> impl Iterator<Item = (&ElementBlock, Element<'_>)> {
    let gone = model.taken_away();
    let solid = |block: &ElementBlock| matches!(block.kind.kinematics, Kinematics::Solid { .. });
    let blocks = model.blocks.iter().enumerate().filter(move |(_, block)| solid(block));
    let all = blocks.flat_map(|(place, block)| {
        block.elements.iter().enumerate().map(move |(member, own)| ((place, member), block, own))
    });
    all.filter(move |(index, ..)| !gone.contains(index)).map(|(_, block, own)| (block, own))
}

impl Solid {
    fn bounds(&self) -> Bounds<3> {
        let all = self.places.iter().map(|&at| (at, at));
        all.reduce(joined).unwrap_or(([0.0; 3], [0.0; 3]))
    }

    /// Points a little inside of its corners [L].
    fn points(&self) -> impl Iterator<Item = [f64; 3]> {
        let count = corners(self.cell.dimension, self.cell.nodes).map_or(0, <[_]>::len);
        let corners = &self.places[..count];
        let mean = |k: usize| corners.iter().map(|at| at[k]).sum::<f64>() / count as f64;
        let middle: [f64; 3] = std::array::from_fn(mean);
        corners.iter().map(move |at| std::array::from_fn(|k| at[k] + INWARDS * (middle[k] - at[k])))
    }

    /// Whether a point is in it, to within a distance [L].
    fn holds(&self, point: [f64; 3], near: f64) -> bool {
        within(self.cell, &self.places, point).is_some_and(|own| own.distance <= near)
    }
}

fn joined(a: Bounds<3>, b: Bounds<3>) -> Bounds<3> {
    let of = |k: usize| (a.0[k].min(b.0[k]), a.1[k].max(b.1[k]));
    (std::array::from_fn(|k| of(k).0), std::array::from_fn(|k| of(k).1))
}
