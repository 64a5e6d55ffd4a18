//! What of the model is there in a step.
//!
//! ```text
//!   step 1   [ A ][ B ]    all
//!   step 2   [ A ]  .      B absent: removed
//!   step 3   [ A ][ B ]    B begins, free of strain where its nodes stand
//! ```

use crate::element::block::{Element, ElementBlock};
use crate::node::{Dof, NodeIndex};
use slideline_diag::Span;

/// An element: its block in the model, and its place among the elements of the block.
pub type ElementIndex = (usize, usize);

/// What a step leaves out of the model, and which elements begin in it.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Presence {
    /// Elements that are absent, ascending.
    pub absent: Vec<ElementIndex>,
    /// Elements that begin with the step, free of strain where their nodes stand then, ascending.
    /// Those that were absent and are in neither list come back with the strain that their nodes
    /// have had since the undeformed model, or since they began.
    pub begun: Vec<ElementIndex>,
    /// Contact pairs that are absent, by their places in the model, ascending.
    pub absent_pairs: Vec<usize>,
    /// The card that changed it last.
    pub origin: Option<Span>,
}

impl Presence {
    /// Whether an element is there.
    pub fn has(&self, element: ElementIndex) -> bool {
        self.absent.binary_search(&element).is_err()
    }

    /// Whether a contact pair is there.
    pub fn has_pair(&self, pair: usize) -> bool {
        self.absent_pairs.binary_search(&pair).is_err()
    }

    /// Whether everything is there, and was.
    pub fn is_whole(&self) -> bool {
        self.absent.is_empty() && self.begun.is_empty() && self.absent_pairs.is_empty()
    }

    /// The elements of the blocks of a model that are there, in their order.
    pub fn elements<'a>(
        &'a self,
        blocks: &'a [ElementBlock],
    ) -> impl Iterator<Item = (&'a ElementBlock, Element<'a>)> {
        blocks.iter().enumerate().flat_map(move |(block, own)| {
            let elements = own.elements.iter().enumerate();
            let there = elements.filter(move |&(member, _)| self.has((block, member)));
            there.map(move |(_, element)| (own, element))
        })
    }

    /// What their hoop strain holds of the rings that are there: a node and a direction of every
    /// element's rigid motions.
    pub fn rings<'a>(
        &'a self,
        blocks: &'a [ElementBlock],
    ) -> impl Iterator<Item = (NodeIndex, Dof)> + 'a {
        let rings = self.elements(blocks).filter(|(block, _)| block.kind.is_ring());
        rings.flat_map(|(_, own)| [(own.nodes[0], Dof::U1), (own.nodes[0], Dof::UR3)])
    }
}
