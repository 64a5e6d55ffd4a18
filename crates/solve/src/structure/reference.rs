//! Where elements begin that were added free of strain.
//!
//! ```text
//!   X o----o        undeformed, where the deck has it
//!      \    \
//!       o----o      X + u0: begun here; strains count from this
//!        \    \
//!         o----o    X + u: the element sees u - u0, on its nodes at X + u0
//! ```
//!
//! docs/theory.md section 9.1.

use super::block::Block;
use serde::{Deserialize, Serialize};
use slideline_mech::element::{MOST_VARIABLES, Temperature};
use slideline_mech::rotation::{Quaternion, after, back};
use slideline_mech::turn::Turn;
use slideline_model::Dof;

/// Where an element begins: the motion of its nodes by then.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct Reference {
    /// Index among the structure's elements.
    pub element: usize,
    /// Displacements and rotations of its variables [L or 1].
    pub displacement: Vec<f64>,
    /// What its nodes had turned by in space; empty: they do not turn there.
    pub turned: Vec<Quaternion>,
    /// Temperatures of its nodes [theta]; empty: all are zero and were.
    pub temperatures: Vec<Temperature>,
}

impl Reference {
    /// Whether all its numbers are finite, and no more than an element has.
    pub fn is_sound(&self) -> bool {
        let finite = |list: &[f64]| list.iter().all(|value| value.is_finite());
        self.displacement.len() <= MOST_VARIABLES
            && finite(&self.displacement)
            && finite(self.turned.as_flattened())
            && self.temperatures.iter().all(|own| {
                own.value.is_finite() && own.slopes.iter().all(|slope| slope.is_finite())
            })
    }

    /// Takes what the element begins with from its variables. Rotations in space of large
    /// displacements stay: the turns that they count from are what changes.
    pub(super) fn take_from(&self, q: &mut [f64], block: &Block, nlgeom: bool) {
        let width = block.dofs.len().max(1);
        let counted = if nlgeom && block.turns_in_space() { block.translations } else { width };
        let nodes = q.chunks_exact_mut(width).zip(self.displacement.chunks_exact(width));
        for (node, from) in nodes {
            node.iter_mut().zip(from).take(counted).for_each(|(q, from)| *q -= from);
        }
    }

    /// What the rotations of its node of that number count from, as the element sees it, eq. (9.8).
    pub(super) fn turn(&self, node: usize, turn: &Turn) -> Turn {
        match self.turned.get(node) {
            Some(turned) => Turn { start: turn.start, before: after(&turn.before, &back(turned)) },
            None => *turn,
        }
    }

    /// The displacement of its node of that number [L], along the axes of the model.
    pub fn translation(&self, node: usize, dofs: &[Dof]) -> [f64; 3] {
        let mut moved = [0.0; 3];
        let own = self.displacement.chunks_exact(dofs.len().max(1)).nth(node).unwrap_or(&[]);
        for (&dof, value) in dofs.iter().zip(own).filter(|(dof, _)| !dof.is_rotation()) {
            moved[dof as usize] = *value;
        }
        moved
    }
}
