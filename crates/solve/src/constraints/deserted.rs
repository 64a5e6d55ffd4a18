//! Dofs that the absent elements and contact pairs of a step leave without anything that moves them.
//!
//! ```text
//!   o====o====o----o----o        ==== there   ---- absent
//!             |    x    x        x: held where they stand
//!             '-- the elements that are there move it
//!
//!   o====o====o::::o----x        :::: follows what is there: it is moved, and hands its forces on
//! ```

use crate::dofs::DofMap;
use slideline_model::{Dof, Element, ElementBlock, Model, Step};

/// Who uses each dof.
struct Uses<'a> {
    dofs: &'a DofMap,
    /// Whether something that is there does.
    there: Vec<bool>,
    /// Whether something that is absent does.
    absent: Vec<bool>,
}

/// The dofs that only absent elements and contact pairs use, and that follow nothing that is there,
/// ascending. What uses a dependent dof uses those that it follows: `followed` has them, the rows
/// behind those that they follow. In return these move it, and feel the forces on it:
/// docs/theory.md section 9.1.
pub(super) fn deserted<'a>(
    (model, step): (&Model, &Step),
    dofs: &DofMap,
    followed: impl DoubleEndedIterator<Item = (usize, &'a [usize])> + Clone,
) -> Vec<usize> {
    if step.presence.is_whole() {
        return Vec::new();
    }
    let unused = || vec![false; dofs.len()];
    let mut uses = Uses { dofs, there: unused(), absent: unused() };
    uses.by_elements(model, step);
    uses.by_contact(model, step);
    for (dependent, leaders) in followed.clone().rev() {
        for &leader in leaders {
            uses.there[leader] |= uses.there[dependent];
            uses.absent[leader] |= uses.absent[dependent];
        }
    }
    for (dependent, leaders) in followed {
        uses.there[dependent] |= leaders.iter().any(|&leader| uses.there[leader]);
    }
    let alone = |&dof: &usize| uses.absent[dof] && !uses.there[dof];
    (0..dofs.len()).filter(alone).collect()
}

impl Uses<'_> {
    fn by_elements(&mut self, model: &Model, step: &Step) {
        for (index, block) in model.blocks.iter().enumerate() {
            for (member, element) in block.elements.iter().enumerate() {
                self.by_element(block, element, step.presence.has((index, member)));
            }
        }
    }

    fn by_element(&mut self, block: &ElementBlock, element: Element<'_>, there: bool) {
        for &node in element.nodes {
            for &kind in block.dofs() {
                let dof = match block.acts_along_own_axes() {
                    true => self.dofs.named(node, kind),
                    false => self.dofs.find(node, kind),
                };
                self.note(dof, there);
            }
        }
    }

    /// A rigid master is a body of its own: nothing is said of it.
    fn by_contact(&mut self, model: &Model, step: &Step) {
        for (place, pair) in model.contact_pairs.iter().enumerate() {
            let there = step.presence.has_pair(place);
            for node in pair.slave_places().chain(pair.master.deforming_nodes()) {
                for kind in [Dof::U1, Dof::U2, Dof::U3] {
                    self.note(self.dofs.find(node, kind), there);
                }
            }
        }
    }

    fn note(&mut self, dof: Option<usize>, there: bool) {
        let Some(dof) = dof else { return };
        let list = if there { &mut self.there } else { &mut self.absent };
        list[dof] = true;
    }
}
