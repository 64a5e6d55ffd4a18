//! States as they are told: nodal values, rows of contact, sections and elements.

use super::results::{BeamRow, BlockResults, ContactRow, Energies, PairRow, SectionRow};
use crate::dofs::DofMap;
use slideline_mech::axes::{self, Axes};
use slideline_mech::element::Temperature;
use slideline_mech::rotation;
use slideline_mech::turn::Turn;
use slideline_model::{Dof, Model, NodeIndex};

/// A committed state, borrowed.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a> {
    /// The model.
    pub model: &'a Model,
    /// Step number from 1.
    pub step: usize,
    /// Increment number from 1; 0 for the start of a step.
    pub increment: usize,
    /// Attempts that were needed.
    pub attempt: usize,
    /// Severe discontinuity iterations.
    pub severe_iterations: usize,
    /// Equilibrium iterations.
    pub equilibrium_iterations: usize,
    /// Total time [T].
    pub total_time: f64,
    /// Time in the step [T].
    pub step_time: f64,
    /// The increment [T].
    pub time_increment: f64,
    /// Whether the step ends with it.
    pub last_of_step: bool,
    /// Nodal values.
    pub nodal: Nodal<'a>,
    /// One row per contact point of every pair, in order.
    pub contact: &'a [ContactRow],
    /// One row per contact pair; none at the start of a step.
    pub pairs: &'a [PairRow],
    /// One row per request of the step for what passes through a surface; none at its start.
    pub sections: &'a [SectionRow],
    /// Section results of the beams, block by block in element order.
    pub beams: &'a [BeamRow],
    /// Results of the elements of every block, as the fields of its type.
    pub elements: &'a [BlockResults],
    /// Energies.
    pub energy: Energies,
    /// What rounding alone may make of energies [F L].
    pub energy_rounding: f64,
    /// The most until now by which energies that do not balance say nothing: rounding, and what the work of heat is not known
    /// by [F L].
    pub energy_unsure: f64,
}

/// The state in which an attempt was given up, for viewing: no equilibrium.
#[derive(Clone, Copy, Debug)]
pub struct Unconverged<'a> {
    /// The state, as if it were one; energies count up to it.
    pub frame: Frame<'a>,
    pub(crate) residual: &'a [f64],
}

impl Unconverged<'_> {
    /// Force or moment at a node that nothing balances [F or F L].
    pub fn residual(&self, node: NodeIndex, dof: Dof) -> f64 {
        self.frame.nodal.force(self.residual, node, dof)
    }

    /// The state with what is missing to equilibrium in place of its reactions.
    pub fn missing(&self) -> Frame<'_> {
        Frame { nodal: Nodal { reaction: self.residual, ..self.frame.nodal }, ..self.frame }
    }
}

/// Dofs of a node that turns in space.
const ROTATIONS: [Dof; 3] = [Dof::UR1, Dof::UR2, Dof::UR3];

/// Nodal vectors of a frame; dofs that a model does not have read zero.
#[derive(Clone, Copy, Debug)]
pub struct Nodal<'a> {
    pub(crate) dofs: &'a DofMap,
    /// Axes of the nodes that have their own.
    pub(crate) axes: &'a [Axes],
    pub(crate) displacement: &'a [f64],
    pub(crate) reaction: &'a [f64],
    pub(crate) load: &'a [f64],
    pub(crate) joined: &'a [f64],
    /// What rotations in space count from, with large rotations; `None`: they are small.
    pub(crate) turns: Option<&'a [Turn]>,
    pub(crate) temperatures: &'a [Temperature],
}

impl Nodal<'_> {
    /// A force at a node along an axis of the model: what acts there and what acts along the own
    /// axes of the node.
    fn force(&self, vector: &[f64], node: NodeIndex, dof: Dof) -> f64 {
        let plain = self.dofs.read(vector, node, dof);
        let Some((axes, own)) = self.own(vector, node, dof) else { return plain };
        let component = dof as usize % 3;
        plain + own.iter().zip(axes).map(|(own, axis)| own * axis[component]).sum::<f64>()
    }

    /// The same along an axis in which the dofs of the node are named.
    fn named_force(&self, vector: &[f64], node: NodeIndex, dof: Dof) -> f64 {
        let Some((axes, own)) = self.own(vector, node, dof) else {
            return self.dofs.read(vector, node, dof);
        };
        let first = dof as usize - dof as usize % 3;
        let plain = std::array::from_fn(|k| self.dofs.read(vector, node, Dof::ALL[first + k]));
        own[dof as usize % 3] + axes::along(axes, plain)[dof as usize % 3]
    }

    /// Own axes of a node and the components along them of the vector that a dof belongs to.
    fn own(&self, vector: &[f64], node: NodeIndex, dof: Dof) -> Option<(&Axes, [f64; 3])> {
        let axes = self.axes.get(self.dofs.place_of_turned(node)?)?;
        let first = dof as usize - dof as usize % 3;
        let read = |k: usize| {
            let own = self.dofs.named(node, Dof::ALL[first + k]);
            own.map_or(0.0, |own| vector[own])
        };
        Some((axes, std::array::from_fn(read)))
    }

    /// Displacement or rotation along an axis of the model [L or 1].
    pub fn displacement(&self, node: NodeIndex, dof: Dof) -> f64 {
        self.dofs.read(self.displacement, node, dof)
    }

    /// Force or moment of the support on the model, along an axis of the model [F or F L]; zero
    /// where nothing is prescribed. docs/theory.md eq. (4.15).
    pub fn reaction(&self, node: NodeIndex, dof: Dof) -> f64 {
        match self.moment(node, dof) {
            Some(moment) => moment[dof as usize % 3],
            None => self.force(self.reaction, node, dof),
        }
    }

    /// The moment of the supports of a node that turns in space, along the axes of the model [F L];
    /// `None`: what the supports do to the dof is that already.
    fn moment(&self, node: NodeIndex, dof: Dof) -> Option<[f64; 3]> {
        let turns = self.turns.filter(|_| dof.is_rotation())?;
        let share = ROTATIONS.map(|dof| self.force(self.reaction, node, dof));
        if share == [0.0; 3] || ROTATIONS.iter().any(|&dof| self.dofs.find(node, dof).is_none()) {
            return None;
        }
        let angles = ROTATIONS.map(|dof| self.displacement(node, dof));
        let vector = turns.get(node).unwrap_or(&Turn::REST).vector(angles);
        Some(rotation::moment_of_share(vector, share))
    }

    /// Applied load along an axis of the model [F or F L].
    pub fn load(&self, node: NodeIndex, dof: Dof) -> f64 {
        self.force(self.load, node, dof)
    }

    /// Reaction and load together along an axis of the model [F or F L], as CalculiX counts forces
    /// at nodes: where equations or rigid bodies join the node to others what its own elements and
    /// contact carry.
    pub fn carried(&self, node: NodeIndex, dof: Dof) -> f64 {
        match self.joined.is_empty() {
            true => self.reaction(node, dof) + self.load(node, dof),
            false => self.force(self.joined, node, dof),
        }
    }

    /// The same along the axis in which the deck names the dof.
    pub fn carried_as_named(&self, node: NodeIndex, dof: Dof) -> f64 {
        match self.joined.is_empty() {
            true => self.named(node, dof)[1..].iter().sum(),
            false => self.named_force(self.joined, node, dof),
        }
    }

    /// Temperature [theta].
    pub fn temperature(&self, node: NodeIndex) -> f64 {
        self.temperatures.get(node).map_or(0.0, |own| own.value)
    }

    /// Displacement, reaction and load along the axis in which the deck names the dof: that of
    /// the node where it has axes of its own.
    pub fn named(&self, node: NodeIndex, dof: Dof) -> [f64; 3] {
        let moved = self.dofs.named(node, dof).map_or(0.0, |own| self.displacement[own]);
        let load = self.named_force(self.load, node, dof);
        let reaction = match self.moment(node, dof) {
            Some(moment) => {
                match self.dofs.place_of_turned(node).and_then(|own| self.axes.get(own)) {
                    Some(own) => axes::along(own, moment)[dof as usize % 3],
                    None => moment[dof as usize % 3],
                }
            }
            None => self.named_force(self.reaction, node, dof),
        };
        [moved, reaction, load]
    }

    /// Node, direction, displacement, reaction and load of every dof there is, along the axes of
    /// the model.
    pub fn all(&self) -> impl Iterator<Item = (NodeIndex, Dof, [f64; 3])> {
        let names = self.dofs.names().iter().take(self.dofs.plain()).enumerate();
        names.map(|(place, &(node, dof))| {
            let forces = match self.dofs.place_of_turned(node) {
                None if !dof.is_rotation() => [self.reaction[place], self.load[place]],
                _ => [self.reaction(node, dof), self.load(node, dof)],
            };
            (node, dof, [self.displacement[place], forces[0], forces[1]])
        })
    }

    /// Whether some node has a rotation.
    pub fn has_rotations(&self) -> bool {
        !self.dofs.rotations().is_empty()
    }

    /// The dofs that nodes of this model have.
    pub fn dofs(&self) -> &[Dof] {
        self.dofs.kinds()
    }
}
