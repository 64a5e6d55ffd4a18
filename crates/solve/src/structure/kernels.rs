//! The kernels of all blocks: positions, sections and materials of the elements.

use super::block::Block;
use super::numbering::ElementNumbering;
use super::reference::Reference;
use slideline_mech::element::{Kernel, Scale};
use slideline_model::{ChangedSection, Model, Undeformed};

/// The elements of a model in their undeformed state, block by block as numbered.
#[derive(Debug, Default)]
pub struct Kernels {
    blocks: Vec<Box<dyn Kernel>>,
    /// Positions of the nodes of a block, element by element [L].
    nodes: Vec<[f64; 3]>,
    /// Largest EA/l [F/L].
    pub stiffest: f64,
    /// Length of the element that has it [L].
    pub stiffest_length: f64,
}

impl Kernels {
    /// Takes the elements of a model that the numbering is of, in the room of those
    /// before. Those with a reference stand where they begin, the others where the deck has them;
    /// blocks that change have another section than that of the model.
    ///
    /// Errors: the index in the model of a block whose section is not one of its type, or of one
    /// with an element that cannot begin there.
    pub fn take(
        &mut self,
        numbering: &ElementNumbering,
        model: &Model,
        (references, changed): (&[Reference], &[ChangedSection]),
    ) -> Result<(), usize> {
        let known = self.blocks.len() == numbering.blocks.len();
        (self.stiffest, self.stiffest_length) = (0.0, 0.0);
        for numbered in &numbering.blocks {
            let block = &model.blocks[numbered.block];
            self.nodes.clear();
            let elements = numbered.members.iter().map(|&at| block.elements.get(at));
            let corners = elements.flat_map(|element| element.nodes);
            self.nodes.extend(corners.map(|&node| model.nodes.get(node).position));
            self.begin_at(numbered, references);
            let other = changed.iter().find(|own| own.block == numbered.block);
            let section = other.map_or(&block.section, |own| &own.section);
            let nodes = &self.nodes[..];
            let (kind, dialect) = (block.kind, model.dialect);
            let members = &numbered.members[..];
            let undeformed = Undeformed { kind, section, dialect, nodes, members };
            let room = known.then(|| self.blocks.remove(0));
            let made = (kind.kernel)(&undeformed, room);
            let shape = (numbered.members.len(), numbered.variables);
            let fitting = made.filter(|kernel| (kernel.count(), kernel.variables()) == shape);
            let Some(kernel) = fitting else {
                self.blocks.clear();
                return Err(numbered.block);
            };
            self.note(&*kernel);
            self.blocks.push(kernel);
        }
        Ok(())
    }

    /// Moves the elements of a block that have a reference to where they begin.
    fn begin_at(&mut self, block: &Block, references: &[Reference]) {
        let own = references.partition_point(|own| own.element < block.elements.start);
        let within = |own: &&Reference| own.element < block.elements.end;
        for reference in references[own..].iter().take_while(within) {
            let first = block.width * block.number(reference.element);
            let nodes = self.nodes.iter_mut().skip(first).take(block.width);
            for (number, position) in nodes.enumerate() {
                let moved = reference.translation(number, block.dofs);
                position.iter_mut().zip(moved).for_each(|(x, u)| *x += u);
            }
        }
    }

    /// What the elements of a block add to the scales.
    fn note(&mut self, kernel: &dyn Kernel) {
        for scale in (0..kernel.count()).map(|element| kernel.scale(element)) {
            if scale.stiffness > self.stiffest {
                self.stiffest = scale.stiffness;
                self.stiffest_length = scale.length.unwrap_or(self.stiffest_length);
            }
        }
    }

    /// The scales of all elements, with the block and the member of each in the model.
    pub fn scales<'a>(
        &'a self,
        numbering: &'a ElementNumbering,
    ) -> impl Iterator<Item = ((usize, usize), Scale)> + 'a {
        let blocks = numbering.blocks.iter().zip(&self.blocks);
        blocks.flat_map(|(numbered, kernel)| {
            let members = numbered.members.iter().enumerate();
            members.map(|(element, &member)| ((numbered.block, member), kernel.scale(element)))
        })
    }

    /// The kernels of all blocks, in order.
    pub(super) fn iter(&self) -> impl Iterator<Item = &dyn Kernel> {
        self.blocks.iter().map(|kernel| &**kernel)
    }

    /// The kernel of a block.
    pub(super) fn of(&self, block: usize) -> &dyn Kernel {
        &*self.blocks[block]
    }
}
