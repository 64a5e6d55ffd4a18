//! The model's elements take their places.

use super::block::Block;
use crate::constraints::ConstraintNumbering;
use crate::dofs::DofMap;
use slideline_linalg::Pattern;
use slideline_mech::element::MOST_VARIABLES;
use slideline_model::{Element, ElementBlock, Model, NodeIndex, Undeformed};

/// Where the elements of a model stand and which dofs they have: what a plan holds of
/// them.
#[derive(Clone, Debug, Default)]
pub struct ElementNumbering {
    pub(super) blocks: Vec<Block>,
    /// Number of elements.
    pub(super) count: usize,
    /// Dofs of the elements' own variables, element by element.
    pub(crate) own: Vec<usize>,
    /// Nodes of the elements, element by element.
    pub(super) nodes: Vec<NodeIndex>,
    /// Number of tangent entries of all elements.
    entries: usize,
    /// How many stresses the elements have.
    pub(super) stresses: usize,
}

impl ElementNumbering {
    /// Numbers every element that is not rigid as a whole.
    pub fn new(model: &Model, dofs: &DofMap, constraints: &ConstraintNumbering) -> Self {
        let mut numbering = Self::default();
        let mut first_state = 0;
        for (index, block) in model.blocks.iter().enumerate() {
            numbering.place((model, index), (dofs, constraints), first_state);
            first_state += block.states() * block.elements.len();
        }
        numbering
    }

    fn place(
        &mut self,
        (model, index): (&Model, usize),
        (dofs, constraints): (&DofMap, &ConstraintNumbering),
        first_state: usize,
    ) {
        let block = &model.blocks[index];
        let kinds = block.dofs();
        let straining = |element: &Element<'_>| !is_rigid(element, block, constraints);
        let elements = || block.elements.iter().enumerate().filter(|(_, own)| straining(own));
        // one tells what all have
        let Some((first_member, one)) = elements().next() else { return };
        let nodes: Vec<[f64; 3]> =
            one.nodes.iter().map(|&node| model.nodes.get(node).position).collect();
        let undeformed = Undeformed {
            kind: block.kind,
            section: &block.section,
            dialect: model.dialect,
            nodes: &nodes,
            members: &[first_member],
        };
        let Some(kernel) = (block.kind.kernel)(&undeformed, None) else { return };
        let (first, variables) = (self.count, kernel.variables());
        let count = elements().count();
        let mut placed = Block {
            elements: first..first + count,
            dofs: kinds,
            translations: kinds.iter().filter(|dof| !dof.is_rotation()).count(),
            variables,
            estimates: kernel.estimate_size(),
            first_node: self.nodes.len(),
            width: block.kind.cell.nodes,
            first_own: self.own.len(),
            first_entry: self.entries,
            first_stress: self.stresses,
            block: index,
            members: Vec::with_capacity(count),
            first_state,
            states: block.states(),
            results: block.kind.all_values(),
        };
        self.own.reserve_exact(variables * count);
        let find = |node, kind| match block.acts_along_own_axes() {
            true => dofs.named(node, kind),
            false => dofs.find(node, kind),
        };
        for (member, element) in elements() {
            self.nodes.extend_from_slice(element.nodes);
            for &node in element.nodes {
                self.own.extend(kinds.iter().filter_map(|&kind| find(node, kind)));
            }
            placed.members.push(member);
        }
        self.count += count;
        self.entries += variables * variables * count;
        self.stresses += placed.estimates * count;
        self.blocks.push(placed);
    }

    /// All elements, each with the dofs of its variables.
    fn elements(&self) -> impl Iterator<Item = (&Block, usize, &[usize])> {
        let elements =
            self.blocks.iter().flat_map(|block| block.elements.clone().map(move |e| (block, e)));
        elements.map(|(block, element)| (block, element, &self.own[block.own(element)]))
    }

    /// Elements with dofs that follow others.
    pub fn dependent(&self, constraints: &ConstraintNumbering) -> Vec<usize> {
        let follows = |own: &[usize]| own.iter().any(|&dof| constraints.is_dependent(dof));
        let elements = self.elements().filter(|(_, _, own)| follows(own));
        elements.map(|(_, element, _)| element).collect()
    }

    /// Elements with a dof that does not stand for an unknown: prescribed, or following others.
    pub fn at_the_border(&self, constraints: &ConstraintNumbering) -> Vec<usize> {
        let bears = |own: &[usize]| own.iter().any(|&dof| constraints.equation(dof).is_none());
        let elements = self.elements().filter(|(_, _, own)| bears(own));
        elements.map(|(_, element, _)| element).collect()
    }

    /// Sets of dofs that couple.
    pub fn cliques(&self) -> impl Iterator<Item = &[usize]> {
        self.elements().map(|(_, _, own)| own)
    }

    /// How many sets [`Self::cliques`] gives, and their members in all.
    pub fn size_of_cliques(&self) -> (usize, usize) {
        (self.count, self.own.len())
    }

    /// Index of every tangent entry among the values of a pattern; `u32::MAX`: none, or
    /// one of the elements `dependent`.
    pub fn entries(
        &self,
        dependent: &[usize],
        constraints: &ConstraintNumbering,
        pattern: &Pattern,
    ) -> Vec<u32> {
        let mut entries = vec![u32::MAX; self.entries];
        let mut later = dependent;
        for (block, element, own) in self.elements() {
            if let Some(rest) = later.strip_prefix(&[element]) {
                later = rest;
                continue;
            }
            let columns = own.iter().map(|&dof| constraints.equation(dof));
            let rows = entries[block.entries(element)].chunks_exact_mut(own.len().max(1));
            let (mut before, mut places): (&[usize], _) = (&[], [usize::MAX; MOST_VARIABLES]);
            for (entries, row) in rows.zip(columns.clone()) {
                let Some(row) = row else { continue };
                let start = pattern.row_start()[row];
                // the dofs of a node have the same columns
                if pattern.row(row) != before {
                    before = pattern.row(row);
                    let mut next = usize::MAX;
                    for (place, column) in places.iter_mut().zip(columns.clone()) {
                        let at = column.and_then(|j| pattern.position_at((row, j), &mut next));
                        *place = at.map_or(usize::MAX, |at| at - start);
                    }
                }
                for (entry, &place) in entries.iter_mut().zip(&places) {
                    let at = if place == usize::MAX { None } else { Some(start + place) };
                    *entry = at.and_then(|at| u32::try_from(at).ok()).unwrap_or(u32::MAX);
                }
            }
        }
        entries
    }

    /// Whether each dof belongs to an element (rounding grows with those).
    pub fn touched(&self, dofs: usize) -> Vec<bool> {
        let mut touched = vec![false; dofs];
        for &dof in &self.own {
            touched[dof] = true;
        }
        touched
    }
}

/// Whether all of it belongs to one rigid body: nothing to strain.
fn is_rigid(
    element: &Element<'_>,
    block: &ElementBlock,
    constraints: &ConstraintNumbering,
) -> bool {
    let carrier = |node: usize| constraints.carrier(node);
    let first = carrier(element.nodes[0]);
    block.kind.joins() && element.nodes.iter().all(|&node| carrier(node) == first)
}
