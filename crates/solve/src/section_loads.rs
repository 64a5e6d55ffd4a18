//! Forces per length that turn with the sections of beams: docs/theory.md eqs (4.19), (4.20).

use crate::dofs::DofMap;
use slideline_mech::section_load;
use slideline_mech::turn::Turn;
use slideline_model::{Dof, NodeIndex};

/// A node of a loaded line.
#[derive(Clone, Debug)]
struct Node {
    node: NodeIndex,
    /// Force of a unit load before it turns [L].
    share: [f64; 3],
    /// Its displacements; `None` where it lacks one.
    displacements: [Option<usize>; 3],
    /// Its rotations.
    rotations: [Option<usize>; 3],
}

/// A line with such a load.
#[derive(Clone, Debug)]
pub struct SectionLoad {
    nodes: Vec<Node>,
}

impl SectionLoad {
    /// Nodes with the forces of a unit load on them [L].
    pub fn new(nodes: &[NodeIndex], shares: &[[f64; 3]], dofs: &DofMap) -> Self {
        let of = |(&node, &share): (&NodeIndex, &[f64; 3])| {
            let find = |dof: Dof| dofs.find(node, dof);
            let displacements = [Dof::U1, Dof::U2, Dof::U3].map(find);
            let rotations = [Dof::UR1, Dof::UR2, Dof::UR3].map(find);
            Node { node, share, displacements, rotations }
        };
        Self { nodes: nodes.iter().zip(shares).map(of).collect() }
    }

    /// Adds the forces of a load of this size [F/L] to those on the dofs [F]; `at`: displacements and
    /// what they count from, `None` where they stay small.
    pub fn press(&self, size: f64, at: Option<(&[f64], &[Turn])>, force: &mut [f64]) {
        for node in &self.nodes {
            let own = match at {
                Some((u, turns)) => {
                    let (turn, u) = node.turned(u, turns);
                    section_load::force(node.share, turn, u)
                }
                None => node.share,
            };
            for (dof, own) in node.displacements.into_iter().zip(own) {
                if let Some(dof) = dof {
                    force[dof] += size * own;
                }
            }
        }
    }

    /// Hands over the derivative of the forces by the rotations, node by node: its dofs, displacements
    /// before rotations, and the entry of a row and a column of them [F].
    pub fn for_each_slope(
        &self,
        size: f64,
        (u, turns): (&[f64], &[Turn]),
        mut call: impl FnMut(&[usize], &dyn Fn(usize, usize) -> f64),
    ) {
        for node in &self.nodes {
            let (turn, u) = node.turned(u, turns);
            let slopes = section_load::slopes(node.share, turn, u);
            let mut room = [(0, 0); 6];
            let mut count = 0;
            let all = node.displacements.into_iter().chain(node.rotations).enumerate();
            for (place, dof) in all.filter_map(|(place, dof)| Some((place, dof?))) {
                room[count] = (place, dof);
                count += 1;
            }
            let own = room.map(|(_, dof)| dof);
            let entry = |row: usize, column: usize| match (room[row].0, room[column].0) {
                (force @ 0..3, turn @ 3..6) => size * slopes[force][turn - 3],
                _ => 0.0,
            };
            call(&own[..count], &entry);
        }
    }
}

impl Node {
    /// Its rotations, and what they count from.
    fn turned<'a>(&self, u: &[f64], turns: &'a [Turn]) -> (&'a Turn, [f64; 3]) {
        let turn = turns.get(self.node).unwrap_or(&Turn::REST);
        (turn, self.rotations.map(|dof| dof.map_or(0.0, |dof| u[dof])))
    }
}
