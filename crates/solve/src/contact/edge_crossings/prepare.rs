//! The points of the crossings of sharp edges, prepared.

use super::sides::{EdgeCrossings, EdgeSide};
use crate::contact::master::MasterSurface;
use crate::contact::pairs::{Carrier, Contact};
use crate::contact::stencil::NO_TURN;
use crate::dofs::DofMap;
use slideline_model::{CrossingEdges, Model, NodeIndex};
use std::collections::HashMap;

impl Contact {
    /// Adds the crossings of the edges of a pair that has been added, and its points.
    pub(crate) fn add_crossings(&mut self, model: &Model, dofs: &DofMap, said: &CrossingEdges) {
        let (of, place) = (said.of, self.masters.len());
        let mut slave = EdgeSide::new(&said.slave, dofs);
        let mut master = EdgeSide::new(&said.master, dofs);
        self.note_points(of, [&mut slave, &mut master]);
        let pair = &model.contact_pairs[of];
        let mut slots = Vec::with_capacity(said.slave.len());
        for line in &said.slave {
            let first = self.points.len();
            for _ in 0..line.most_crossings(said.master.len()) {
                let node = line.edges[0].nodes[0];
                let (position, dofs) = ([0.0; 3], dofs.translations(node));
                let carrier = Carrier::Node { position, dofs, section: NO_TURN };
                self.add_point(place, pair, node, carrier);
            }
            self.points[first..].iter_mut().for_each(|point| point.is_crossing = true);
            slots.push(first..self.points.len());
        }
        let mut nodes: Vec<NodeIndex> = slave.nodes.iter().map(|own| own.node).collect();
        nodes.sort_unstable();
        self.slave_nodes.push(nodes.clone());
        self.spread_nodes.push(nodes);
        self.edges.push(Vec::new());
        self.laws.push(self.laws[of].clone());
        self.keeps.push(pair.interaction.no_separation);
        self.offsets.push(pair.offset);
        self.spacing.push(self.spacing[of]);
        self.masters.push(MasterSurface::Nothing);
        self.crossings.push(EdgeCrossings { of, slave, master, slots, is_absent: false });
    }

    /// Notes which points of a pair, and of the nodes of its edges, are at the nodes of both sides.
    fn note_points(&self, of: usize, sides: [&mut EdgeSide; 2]) {
        let mut at_node: HashMap<NodeIndex, Vec<usize>> = HashMap::new();
        for (place, point) in self.points.iter().enumerate() {
            if !point.is_crossing && self.parent(point.pair) == of {
                at_node.entry(point.node).or_default().push(place);
            }
        }
        for own in sides.into_iter().flat_map(|side| &mut side.nodes) {
            own.points = at_node.get(&own.node).cloned().unwrap_or_default();
        }
    }

    /// Takes positions, laws and areas of crossings: those of their pairs, areas the mean of the slave nodes of a
    /// line, or of the pair.
    pub(crate) fn take_crossings(&mut self, model: &Model) {
        let first = self.masters.len() - self.crossings.len();
        for place in 0..self.crossings.len() {
            let own = &mut self.crossings[place];
            own.slave.take(model);
            own.master.take(model);
            let (of, pair) = (own.of, first + place);
            self.laws[pair] = self.laws[of].clone();
            self.keeps[pair] = self.keeps[of];
            self.spacing[pair] = self.spacing[of];
            self.offsets[pair] = self.offsets[of];
            let areas = self.areas_of_lines(place);
            for (slots, area) in self.crossings[place].slots.iter().zip(areas) {
                self.points[slots.clone()].iter_mut().for_each(|point| point.area = area);
            }
        }
    }

    fn areas_of_lines(&self, place: usize) -> Vec<f64> {
        let own = &self.crossings[place];
        let of_pair = |&point: &usize| self.points[point].pair == own.of;
        let area = |node: usize| {
            let points = own.slave.nodes[node].points.iter().copied().filter(of_pair);
            points.map(|point| self.points[point].area).sum::<f64>()
        };
        let whole = mean(self.points.iter().filter(|p| p.pair == own.of).map(|p| p.area));
        let of_line = |(range, _): &(std::ops::Range<usize>, bool)| {
            let corners = own.slave.edges[range.clone()].iter().flat_map(|edge| edge.corners);
            let mean = mean(corners.map(area));
            if mean > 0.0 { mean } else { whole }
        };
        own.slave.lines.iter().map(of_line).collect()
    }
}

/// The mean of those that are positive.
fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let positive = values.filter(|value| *value > 0.0);
    let (sum, count) = positive.fold((0.0, 0.0), |(sum, count), own| (sum + own, count + 1.0));
    if count > 0.0 { sum / count } else { 0.0 }
}
