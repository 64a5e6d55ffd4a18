//! Beams in a row: the order of their nodes, and the face they turn outwards.
//!
//! ```text
//!            n            outward normal: 90 degrees counter-clockwise of travel
//!            ^
//!   o----->--+---->--o-->--o      one open chain, without branch, or one ring
//! ```

use std::collections::HashMap;

use slideline_diag::Span;
use slideline_model::{NodeIndex, Nodes};

use crate::surfaces::Side;

/// An element of a surface between its end nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Facet {
    pub label: u64,
    pub nodes: [NodeIndex; 2],
    /// Its middle node, of a three-node beam.
    pub middle: Option<NodeIndex>,
    /// The element's data line.
    pub origin: Span,
    pub side: Option<Side>,
    /// Number of the face of a solid, from 0; `None`: a beam.
    pub face: Option<usize>,
}

impl Facet {
    /// The facet between its neighbouring nodes: in two parts, where there is
    /// a middle node.
    pub fn parts(&self) -> impl Iterator<Item = Self> {
        let [a, b] = self.nodes;
        let part = |nodes| Self { nodes, middle: None, ..*self };
        let parts = match self.middle {
            Some(middle) => [Some(part([a, middle])), Some(part([middle, b]))],
            None => [Some(*self), None],
        };
        parts.into_iter().flatten()
    }
}

/// Facets in the order of travel.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Chain {
    /// One more than facets.
    pub nodes: Vec<NodeIndex>,
    /// Place of each facet in the list it came from, and whether travel goes
    /// from its first to its last node.
    pub steps: Vec<(usize, bool)>,
}

/// Why facets are no open chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Broken {
    /// Three or more meet at this node.
    Branch(NodeIndex),
    /// They close on themselves.
    Loop(NodeIndex),
    /// This node is not joined to the first one.
    Apart(NodeIndex),
}

/// Which way the facets ask to be travelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Travel {
    AsFound,
    Reversed,
    /// No facet has a label.
    Open,
    /// The facets at these places of the list contradict each other.
    Contradiction(usize, usize),
}

impl Chain {
    /// Walks from one open end to the other; from the end that is the first
    /// node of its element, where there is one.
    pub fn find(facets: &[Facet]) -> Result<Self, Broken> {
        Self::walk(facets, None)
    }

    /// Walks once round facets that close on themselves, from this node back to it.
    pub fn ring(facets: &[Facet], start: NodeIndex) -> Result<Self, Broken> {
        Self::walk(facets, Some(start))
    }

    fn walk(facets: &[Facet], from: Option<NodeIndex>) -> Result<Self, Broken> {
        let mut at: HashMap<NodeIndex, Vec<usize>> = HashMap::new();
        for (place, facet) in facets.iter().enumerate() {
            for node in facet.nodes {
                at.entry(node).or_default().push(place);
            }
        }
        let in_order = || facets.iter().flat_map(|facet| facet.nodes);
        if let Some(branch) = in_order().find(|node| at[node].len() > 2) {
            return Err(Broken::Branch(branch));
        }
        let is_end = |node: &NodeIndex| at[node].len() == 1;
        let first = facets.iter().map(|facet| facet.nodes[0]).find(is_end);
        let Some(start) = from.or(first).or_else(|| in_order().find(is_end)) else {
            return Err(Broken::Loop(facets.first().map_or(0, |facet| facet.nodes[0])));
        };
        let mut chain = Self { nodes: vec![start], steps: Vec::new() };
        let mut taken = vec![false; facets.len()];
        let mut here = start;
        while let Some(&next) = at[&here].iter().find(|&&place| !taken[place]) {
            taken[next] = true;
            let [a, b] = facets[next].nodes;
            chain.steps.push((next, here == a));
            here = if here == a { b } else { a };
            chain.nodes.push(here);
        }
        match taken.iter().position(|taken| !taken) {
            Some(left) => Err(Broken::Apart(facets[left].nodes[0])),
            None => Ok(chain),
        }
    }

    /// The same chain travelled from its other end.
    pub fn reverse(&mut self) {
        self.nodes.reverse();
        self.steps.reverse();
        for step in &mut self.steps {
            step.1 = !step.1;
        }
    }

    /// The direction of travel that puts the labelled faces outside.
    pub fn travel(&self, facets: &[Facet]) -> Travel {
        let mut asked: Option<(usize, bool)> = None;
        for &(place, forward) in &self.steps {
            let Some(side) = facets[place].side else { continue };
            let as_found = forward == (side == Side::Positive);
            let (first, agreed) = *asked.get_or_insert((place, as_found));
            if agreed != as_found {
                return Travel::Contradiction(first, place);
            }
        }
        match asked {
            None => Travel::Open,
            Some((_, true)) => Travel::AsFound,
            Some((_, false)) => Travel::Reversed,
        }
    }

    /// The label that stands for the face outwards on every facet, where the
    /// elements all run the same way.
    pub fn label(&self) -> Option<Side> {
        let (_, forward) = *self.steps.first()?;
        let uniform = self.steps.iter().all(|step| step.1 == forward);
        uniform.then_some(if forward { Side::Positive } else { Side::Negative })
    }

    /// Signed distance of a point from its nearest segment [L]: positive on
    /// the outer side; with the length of that segment [L].
    pub fn distance(&self, nodes: &Nodes, point: [f64; 3]) -> (f64, f64) {
        let mut nearest = (f64::INFINITY, 0.0, 0.0);
        for pair in self.nodes.windows(2) {
            let (a, b) = (nodes.position(pair[0]), nodes.position(pair[1]));
            let (t, r) = ([b[0] - a[0], b[1] - a[1]], [point[0] - a[0], point[1] - a[1]]);
            let length = t[0].hypot(t[1]);
            let along = ((r[0] * t[0] + r[1] * t[1]) / (length * length)).clamp(0.0, 1.0);
            let away = (r[0] - along * t[0]).hypot(r[1] - along * t[1]);
            if away < nearest.0 {
                nearest = (away, (t[0] * r[1] - t[1] * r[0]) / length, length);
            }
        }
        (nearest.1, nearest.2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use slideline_model::Node;

    fn facet(a: NodeIndex, b: NodeIndex, side: Option<Side>) -> Facet {
        Facet { label: 1, nodes: [a, b], middle: None, origin: Span::default(), side, face: None }
    }

    fn nodes(facets: &[(NodeIndex, NodeIndex)]) -> Result<Vec<NodeIndex>, Broken> {
        let facets: Vec<Facet> = facets.iter().map(|&(a, b)| facet(a, b, None)).collect();
        Chain::find(&facets).map(|chain| chain.nodes)
    }

    #[test]
    fn a_chain_is_found_in_any_order() {
        assert_eq!(nodes(&[(0, 1), (1, 2), (2, 3)]), Ok(vec![0, 1, 2, 3]));
        assert_eq!(nodes(&[(2, 3), (0, 1), (1, 2)]), Ok(vec![0, 1, 2, 3]));
        assert_eq!(nodes(&[(2, 1), (0, 1), (2, 3)]), Ok(vec![0, 1, 2, 3]));
        assert_eq!(nodes(&[(1, 0), (1, 2)]), Ok(vec![0, 1, 2]), "no first node is an end");
    }

    #[test]
    fn what_is_no_chain_is_named() {
        assert_eq!(nodes(&[(0, 1), (1, 2), (1, 3)]), Err(Broken::Branch(1)));
        assert_eq!(nodes(&[(0, 1), (1, 2), (2, 0)]), Err(Broken::Loop(0)));
        assert_eq!(nodes(&[(0, 1), (2, 3)]), Err(Broken::Apart(2)));
        assert_eq!(nodes(&[(0, 1), (2, 3), (3, 4), (4, 2)]), Err(Broken::Apart(2)));
        assert_eq!(nodes(&[(0, 1), (0, 1)]), Err(Broken::Loop(0)));
    }

    #[test]
    fn a_ring_ends_where_it_begins() {
        let ring = [(0, 1), (2, 0), (1, 2)].map(|(a, b)| facet(a, b, None));
        let found = Chain::ring(&ring, 2).map(|chain| chain.nodes);
        assert_eq!(found, Ok(vec![2, 0, 1, 2]));
        let apart = [(0, 1), (1, 0), (2, 3), (3, 2)].map(|(a, b)| facet(a, b, None));
        assert_eq!(Chain::ring(&apart, 0), Err(Broken::Apart(2)));
    }

    #[test]
    fn labels_choose_the_travel() {
        let (positive, negative) = (Some(Side::Positive), Some(Side::Negative));
        let travel = |sides: [Option<Side>; 2]| {
            let facets = [facet(0, 1, sides[0]), facet(2, 1, sides[1])];
            Chain::find(&facets).expect("a chain").travel(&facets)
        };
        assert_eq!(travel([positive, negative]), Travel::AsFound);
        assert_eq!(travel([negative, positive]), Travel::Reversed);
        assert_eq!(travel([None, positive]), Travel::Reversed);
        assert_eq!(travel([None, None]), Travel::Open);
        assert_eq!(travel([positive, positive]), Travel::Contradiction(0, 1));
    }

    /// Semantics, surfaces: the outward normal stands 90 degrees
    /// counter-clockwise of travel; exact in these coordinates.
    #[test]
    fn the_outer_side_is_to_the_left_of_travel() {
        let mut nodes = Nodes::default();
        for (label, position) in [(1, [0.0; 3]), (2, [2.0, 0.0, 0.0]), (3, [2.0, 4.0, 0.0])] {
            nodes.insert(Node { label, position, origin: Span::default() });
        }
        let facets = [facet(0, 1, None), facet(1, 2, None)];
        let mut chain = Chain::find(&facets).expect("a chain");
        assert_eq!(chain.distance(&nodes, [1.0, 0.5, 0.0]), (0.5, 2.0));
        assert_eq!(chain.distance(&nodes, [2.25, 3.0, 0.0]), (-0.25, 4.0));
        assert_eq!(chain.label(), Some(Side::Positive));
        chain.reverse();
        assert_eq!(chain.distance(&nodes, [1.0, 0.5, 0.0]), (-0.5, 2.0));
        assert_eq!((chain.nodes.as_slice(), chain.label()), (&[2, 1, 0][..], Some(Side::Negative)));
    }
}
