//! A part of the elements: blocks alone, and tangents that were kept.

use super::contributions::Contributions;
use super::elements::{Configuration, Structure};
use super::evaluate::{PARALLEL, Part, Product};
use rayon::ThreadPool;

impl Structure<'_> {
    /// Number of blocks, and the block of the model that each is of.
    pub fn blocks(&self) -> impl Iterator<Item = (usize, usize)> {
        self.numbering.blocks.iter().enumerate().map(|(number, block)| (number, block.block))
    }

    /// Evaluates forces and energies of a block alone, with the bits of [`Structure::evaluate_forces`].
    pub fn evaluate_block(
        &self,
        number: usize,
        at: &Configuration<'_>,
        into: &mut Contributions,
        pool: Option<&ThreadPool>,
    ) {
        let elements = self.numbering.blocks[number].elements.clone();
        let [force, _, state] = self.sizes(0..elements.start);
        let [forces, _, states] = self.sizes(elements.clone());
        let part = Part {
            elements: elements.clone(),
            force: &mut into.force[force..force + forces],
            tangent: None,
            energy: &mut into.energy[elements.clone()],
            state: &mut into.state[state..state + states],
        };
        let at = Configuration { stresses: None, ..*at };
        self.evaluate_all(&at, part, pool.filter(|_| elements.len() >= PARALLEL));
    }

    /// Adds `weight` times the forces of a block to a vector of all dofs; `weight` times its energy.
    /// `None`: an element has no answer.
    pub fn add_block(
        &self,
        number: usize,
        (weight, from): (f64, &Contributions),
        into: &mut [f64],
    ) -> Option<f64> {
        let elements = self.numbering.blocks[number].elements.clone();
        let [first, ..] = self.sizes(0..elements.start);
        let [count, ..] = self.sizes(elements.clone());
        let own = first..first + count;
        for (&dof, force) in self.numbering.own[own.clone()].iter().zip(&from.force[own]) {
            into[dof] += weight * force;
        }
        from.energy[elements].iter().try_fold(0.0, |sum, own| Some(sum + weight * own.ok()?))
    }

    /// Adds what kept tangents of elements do with a vector of all dofs.
    pub fn multiply_kept(
        &self,
        (elements, tangents): (&[usize], &[f64]),
        vector: &[f64],
        into: &mut [f64],
    ) {
        let mut product = Product { vector, into };
        let mut rest = tangents;
        for &element in elements {
            let (block, _) = self.element(element);
            let own = self.own(block, element);
            let (tangent, behind) = rest.split_at(own.len() * own.len());
            rest = behind;
            product.add(own, tangent, own.len().max(1));
        }
    }
}
