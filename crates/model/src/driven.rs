//! Nodes that a deck drives together.

use crate::model::Model;
use crate::node::{Dof, NodeIndex};
use slideline_diag::Span;
use std::collections::HashMap;

/// Nodes with one prescribed motion: a driven node, or all nodes of a set that a card moves.
#[derive(Clone, Debug, PartialEq)]
pub struct Driven {
    /// The nodes, in the order of the deck.
    pub nodes: Vec<NodeIndex>,
    /// What is prescribed.
    pub dof: Dof,
    /// What they are called: the number of a single node, the name of a set, or the first and the
    /// last number.
    pub name: String,
    /// Where the motion was said first.
    pub origin: Span,
}

/// What a motion is told apart by: dof, card, and step by step value and amplitude. Rotations are
/// each their own: their moments do not add up.
type Way = (Dof, Span, Option<NodeIndex>, Vec<(usize, u64, Option<usize>)>);

impl Model {
    /// Prescribed motions that move in some step, nodes that a card moves alike taken together.
    pub fn driven(&self) -> Vec<Driven> {
        let mut ways: Vec<((NodeIndex, Dof), Way)> = Vec::new();
        let mut place_of: HashMap<(NodeIndex, Dof), usize> = HashMap::new();
        for own in self.steps.iter().flat_map(|step| &step.prescribed).filter(|own| own.moves()) {
            place_of.entry((own.node, own.dof)).or_insert_with(|| {
                let alone = own.dof.is_rotation().then_some(own.node);
                ways.push(((own.node, own.dof), (own.dof, own.origin, alone, Vec::new())));
                ways.len() - 1
            });
        }
        for (number, step) in self.steps.iter().enumerate() {
            for own in &step.prescribed {
                if let Some(&place) = place_of.get(&(own.node, own.dof)) {
                    ways[place].1.3.push((number, own.value.to_bits(), own.amplitude));
                }
            }
        }
        let mut driven: Vec<Driven> = Vec::new();
        let mut group_of: HashMap<Way, usize> = HashMap::new();
        for ((node, dof), way) in ways {
            let origin = way.1;
            let group = *group_of.entry(way).or_insert_with(|| {
                driven.push(Driven { nodes: Vec::new(), dof, name: String::new(), origin });
                driven.len() - 1
            });
            driven[group].nodes.push(node);
        }
        driven.iter_mut().for_each(|own| own.name = self.name_of(&own.nodes));
        driven
    }

    /// Name of the set with just these nodes, or the first and the last number; the number of a
    /// single one.
    pub fn name_of(&self, nodes: &[NodeIndex]) -> String {
        let mut sorted = nodes.to_vec();
        sorted.sort_unstable();
        let is_it = |own: &[NodeIndex]| {
            let mut own = own.to_vec();
            own.sort_unstable();
            own.dedup();
            own == sorted
        };
        match nodes {
            [node] => self.nodes.label(*node).to_string(),
            [first, .., last] => {
                let mut sets = self.node_sets.iter();
                let set = sets.find(|set| set.members.len() >= nodes.len() && is_it(&set.members));
                let [first, last] = [first, last].map(|node| self.nodes.label(*node));
                set.map_or_else(|| format!("{first}...{last}"), |set| set.name.clone())
            }
            [] => String::new(),
        }
    }
}
