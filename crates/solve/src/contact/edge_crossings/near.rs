//! Which dofs crossings may couple before long.

use super::sides::PlacedSides;
use crate::contact::pairs::Contact;
use slideline_mech::contact::gap::edges::EdgeGap;
use std::collections::BTreeMap;
use std::ops::RangeInclusive;

/// Where the lines of two edges cross that may soon do so themselves, in parts of them [1].
const BESIDE: RangeInclusive<f64> = -1.5..=2.5;

impl Contact {
    /// Adds the dofs of edges that are near one another at displacements `u`, line by line, to lists by their lines.
    pub(crate) fn near_crossings(&self, u: &[f64], into: &mut BTreeMap<[usize; 3], Vec<usize>>) {
        for (place, own) in self.crossings.iter().enumerate().filter(|(_, own)| !own.is_absent) {
            let mut placed = PlacedSides::default();
            own.place(u, &mut placed);
            placed.near_pairs(|edges, [slave, master]| {
                let gap = EdgeGap::new([slave.ends, master.ends], master.outward());
                let is_near = |gap: &EdgeGap| {
                    let is_beside = gap.at.iter().all(|share| BESIDE.contains(share));
                    is_beside && gap.gap.abs() <= slave.length() + master.length()
                };
                if !gap.as_ref().is_some_and(is_near) {
                    return;
                }
                let [slave, master] = own.lines(edges);
                let list = into.entry([place, slave, master]).or_default();
                for (side, edge) in own.sides().into_iter().zip(edges) {
                    let nodes = side.edges[edge].ends.map(|node| &side.nodes[node].dofs);
                    list.extend(nodes.into_iter().flat_map(|dofs| dofs.as_slice()));
                }
            });
        }
        for list in into.values_mut() {
            list.sort_unstable();
            list.dedup();
        }
    }
}
