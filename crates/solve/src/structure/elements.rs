//! All elements of a step, and what is around them.

use super::block::Block;
use super::contributions::Contributions;
use super::kernels::Kernels;
use super::numbering::ElementNumbering;
use super::reference::Reference;
use slideline_mech::element::{Kernel, MOST_NODES, Strains, Surroundings, Temperature};
use slideline_mech::material::Clock;
use slideline_mech::turn::Turn;

/// All elements of a step at work: numbering of the plan, kernels of the values.
#[derive(Clone, Copy, Debug)]
pub struct Structure<'a> {
    /// Where elements stand and which dofs they have.
    pub numbering: &'a ElementNumbering,
    /// What they are.
    pub kernels: &'a Kernels,
    /// Elements with dofs that follow others.
    pub dependent: &'a [usize],
    /// Index of each tangent entry among the matrix values, element by element and row
    /// by row; `u32::MAX`: none.
    pub entries: &'a [u32],
    /// Whether each element is absent; empty: none is.
    pub absent: &'a [bool],
    /// Where the elements begin that were added free of strain, by ascending element.
    pub references: &'a [Reference],
    /// Temperatures of all nodes before the first step; empty: all are zero.
    pub initial: &'a [Temperature],
    /// Whether displacements may be large.
    pub nlgeom: bool,
    /// Largest EA/l [F/L], for the rounding floor of the residual.
    pub stiffest: f64,
    /// Length of the element that has it [L].
    pub stiffest_length: f64,
}

/// What is around the elements.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ambient<'a> {
    /// Temperatures, a node each; empty: all are zero and were.
    pub temperatures: &'a [Temperature],
    /// What rotations in space count from, a node each; empty: all from rest.
    pub turns: &'a [Turn],
    /// What the clock shows to the materials.
    pub clock: Clock,
}

/// What elements respond to.
#[derive(Clone, Copy, Debug)]
pub struct Configuration<'a> {
    /// Displacements and rotations, a dof each [L or 1].
    pub u: &'a [f64],
    /// Estimated stresses that the geometric stiffness is made of, where they are
    /// not those of the strains.
    pub stresses: Option<&'a [f64]>,
    /// Committed state variables of all elements.
    pub state: &'a [f64],
    /// Temperatures and time.
    pub ambient: Ambient<'a>,
}

/// What the nodes of an element are in: temperatures now and before the first step, and what their
/// rotations count from.
pub(super) struct AtNodes {
    now: [Temperature; MOST_NODES],
    initial: [Temperature; MOST_NODES],
    heated: usize,
    turns: [Turn; MOST_NODES],
    turning: usize,
}

impl Default for AtNodes {
    fn default() -> Self {
        let none = [Temperature::default(); MOST_NODES];
        let turns = [Turn::REST; MOST_NODES];
        Self { now: none, initial: none, heated: 0, turns, turning: 0 }
    }
}

impl AtNodes {
    /// What an element responds under.
    pub(super) fn under<'a>(&'a self, strains: Strains<'a>, clock: Clock) -> Surroundings<'a> {
        let (temperatures, initial) = (&self.now[..self.heated], &self.initial[..self.heated]);
        Surroundings { strains, temperatures, initial, turns: self.turns(), clock }
    }

    /// What the rotations of its nodes count from.
    pub(super) fn turns(&self) -> &[Turn] {
        &self.turns[..self.turning]
    }
}

impl Structure<'_> {
    /// Room for what the elements contribute, empty.
    pub fn room(&self) -> Contributions {
        let mut room = Contributions::default();
        room.fit(self.numbering);
        room
    }

    /// All elements, each with its block and kernel.
    pub(super) fn elements(&self) -> impl Iterator<Item = (&Block, &dyn Kernel, usize)> {
        let blocks = self.numbering.blocks.iter().zip(self.kernels.iter());
        blocks.flat_map(|(block, kernel)| block.elements.clone().map(move |e| (block, kernel, e)))
    }

    /// The block of an element, and its kernel.
    pub(super) fn element(&self, element: usize) -> (&Block, &dyn Kernel) {
        let at = self.numbering.blocks.partition_point(|block| block.elements.end <= element);
        (&self.numbering.blocks[at], self.kernels.of(at))
    }

    /// Whether an element is there.
    pub(super) fn has(&self, element: usize) -> bool {
        !self.absent.get(element).is_some_and(|&absent| absent)
    }

    /// The elements that are there, each with its block and kernel.
    pub(super) fn present(&self) -> impl Iterator<Item = (&Block, &dyn Kernel, usize)> {
        self.elements().filter(|&(.., element)| self.has(element))
    }

    /// Where an element begins that was added free of strain.
    fn reference(&self, element: usize) -> Option<&Reference> {
        if self.references.is_empty() {
            return None;
        }
        let at = self.references.binary_search_by_key(&element, |own| own.element).ok()?;
        self.references.get(at)
    }

    /// Reads the variables of an element from displacements and rotations of all dofs, counted
    /// from where it begins.
    #[inline]
    pub(super) fn read(&self, block: &Block, element: usize, u: &[f64], q: &mut [f64]) {
        q.iter_mut().zip(self.own(block, element)).for_each(|(q, &dof)| *q = u[dof]);
        if let Some(reference) = self.reference(element) {
            reference.take_from(q, block, self.nlgeom);
        }
    }

    /// The dofs of an element.
    pub(super) fn own(&self, block: &Block, element: usize) -> &[usize] {
        &self.numbering.own[block.own(element)]
    }

    /// What is around the nodes of an element.
    #[inline]
    pub(super) fn at_nodes<'n>(
        &self,
        block: &Block,
        element: usize,
        ambient: &Ambient<'_>,
        into: &'n mut AtNodes,
    ) -> &'n AtNodes {
        (into.heated, into.turning) = (0, 0);
        if ambient.temperatures.is_empty() && !block.turns_in_space() {
            return into;
        }
        let nodes = &self.numbering.nodes[block.nodes(element)];
        let reference = self.reference(element);
        if !ambient.temperatures.is_empty() {
            let of = |list: &[Temperature], node: usize| list.get(node).copied();
            for &node in nodes {
                into.now[into.heated] = of(ambient.temperatures, node).unwrap_or_default();
                let begun = reference.and_then(|own| own.temperatures.get(into.heated).copied());
                let initial = begun.or_else(|| of(self.initial, node));
                into.initial[into.heated] = initial.unwrap_or_default();
                into.heated += 1;
            }
        }
        if block.turns_in_space() && (!ambient.turns.is_empty() || reference.is_some()) {
            for &node in nodes {
                let turn = ambient.turns.get(node).copied().unwrap_or_default();
                let seen = reference.map_or(turn, |own| own.turn(into.turning, &turn));
                into.turns[into.turning] = seen;
                into.turning += 1;
            }
        }
        into
    }

    /// How strains follow displacements in this step.
    pub(super) fn strains(&self) -> Strains<'static> {
        if self.nlgeom { Strains::Exact } else { Strains::Linear }
    }
}
