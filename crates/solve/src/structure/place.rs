//! The model's elements take their places.

use super::Structure;
use super::block::Block;
use crate::constraints::Constraints;
use crate::dofs::DofMap;
use slideline_model::{Element, ElementBlock, Model, Undeformed};

/// Where elements act: dofs and constraints.
type Numbering<'a> = (&'a DofMap, &'a Constraints);

impl Structure {
    /// Places every element that is not rigid as a whole.
    pub fn new(model: &Model, numbering: Numbering<'_>, nlgeom: bool) -> Self {
        let mut structure = Self { nlgeom, ..Self::default() };
        let mut first_state = 0;
        for block in 0..model.blocks.len() {
            structure.place(model, numbering, block, first_state);
            let block = &model.blocks[block];
            first_state += block.states() * block.elements.len();
        }
        structure
    }

    fn place(
        &mut self,
        model: &Model,
        (dofs, constraints): Numbering<'_>,
        index: usize,
        first_state: usize,
    ) {
        let block = &model.blocks[index];
        let kinds = block.dofs();
        let straining = |element: &Element<'_>| !is_rigid(element, block, constraints);
        let elements = || block.elements.iter().enumerate().filter(|(_, own)| straining(own));
        let corners = || elements().flat_map(|(_, own)| own.nodes);
        let mut nodes: Vec<[f64; 3]> = Vec::with_capacity(corners().count());
        nodes.extend(corners().map(|&node| model.nodes.get(node).position));
        let undeformed = Undeformed {
            kind: block.kind,
            section: &block.section,
            dialect: model.dialect,
            nodes: &nodes,
        };
        let Some(kernel) = (block.kind.kernel)(&undeformed) else { return };
        let (first, variables) = (self.count, kernel.variables());
        let mut placed = Block {
            elements: first..first,
            dofs: kinds,
            translations: kinds.iter().filter(|dof| !dof.is_rotation()).count(),
            variables,
            estimates: kernel.estimate_size(),
            first_own: self.own.len(),
            first_entry: self.entries.len(),
            first_stress: self.stresses,
            block: index,
            members: Vec::with_capacity(elements().count()),
            first_state,
            states: block.states(),
            results: block.kind.all_values(),
            kernel,
        };
        self.own.reserve_exact(variables * elements().count());
        for (member, element) in elements() {
            let begin = self.own.len();
            for &node in element.nodes {
                self.own.extend(kinds.iter().filter_map(|&kind| dofs.find(node, kind)));
            }
            if self.own[begin..].iter().any(|&dof| constraints.is_dependent(dof)) {
                self.dependent.push(self.count);
            }
            placed.members.push(member);
            self.note(&placed);
            self.count += 1;
            placed.elements.end = self.count;
        }
        self.entries
            .resize(placed.first_entry + variables * variables * placed.elements.len(), usize::MAX);
        self.stresses += placed.estimates * placed.elements.len();
        self.blocks.push(placed);
    }

    /// What the next element of a block adds to the scales.
    fn note(&mut self, placed: &Block) {
        let scale = placed.kernel.scale(placed.elements.len());
        if scale.stiffness > self.stiffest {
            self.stiffest = scale.stiffness;
            self.stiffest_length = scale.length.unwrap_or(self.stiffest_length);
        }
    }
}

/// Whether all of it belongs to one rigid body: nothing to strain.
fn is_rigid(element: &Element<'_>, block: &ElementBlock, constraints: &Constraints) -> bool {
    let carrier = |node: usize| constraints.carrier(node);
    let first = carrier(element.nodes[0]);
    block.kind.joins() && element.nodes.iter().all(|&node| carrier(node) == first)
}
