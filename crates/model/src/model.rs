//! The model: all of the problem, and what follows from its parts together.

use crate::amplitude::Amplitude;
use crate::contact::ContactPair;
use crate::crossing_edges::CrossingEdges;
use crate::dialect::Dialect;
use crate::edge_pair::EdgePair;
use crate::element::block::{Allowable, ElementBlock};
use crate::initial_stress::{InitialHardening, InitialStress};
use crate::kept_shape::KeptShape;
use crate::mean_motion::{LinearMeanTurn, MeanMotion};
use crate::node::{Dof, LinearConstraint, NodeIndex, NodeSet, Nodes, RigidLink};
use crate::presence::ElementIndex;
use crate::step::Step;
use crate::tested::Tested;
use crate::transform::Transform;
use crate::vocabulary::Vocabulary;
use slideline_mech::axes::Axes;
use slideline_mech::contact::onset::Onset;
use slideline_mech::element::Temperature;
use std::collections::HashSet;

/// A whole problem.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Model {
    /// Text of `*HEADING`, lines joined by line feeds.
    pub heading: String,
    /// Reading of ambiguous keywords.
    pub dialect: Dialect,
    /// Whether its nodes move in space though the types of its elements do not say so: springs,
    /// gaps and rigid meshes alone.
    pub in_space: bool,
    /// All nodes.
    pub nodes: Nodes,
    /// Named node sets, members in order.
    pub node_sets: Vec<NodeSet>,
    /// Axes of nodes that are not those of the model.
    pub transforms: Vec<Transform>,
    /// Elements in blocks of one type and one section.
    pub blocks: Vec<ElementBlock>,
    /// Rubbers that come from test data, with these.
    pub tested: Vec<Tested>,
    /// What beams may be strained to, where the deck says so.
    pub allowables: Vec<Allowable>,
    /// Nodes that move as parts of rigid bodies.
    pub rigid_links: Vec<RigidLink>,
    /// Dofs that follow others linearly.
    pub linear_constraints: Vec<LinearConstraint>,
    /// Shapes that nodes keep in large motion.
    pub shapes: Vec<KeptShape>,
    /// Clouds of nodes whose mean motion another node follows, for turns of any size in large motion.
    pub mean_motions: Vec<MeanMotion>,
    /// Those that stay linear in large motion.
    pub linear_mean_turns: Vec<LinearMeanTurn>,
    /// Nodes at one place that are one in contact: the first follows the second.
    pub seams: Vec<[NodeIndex; 2]>,
    /// Contact pairs.
    pub contact_pairs: Vec<ContactPair>,
    /// Sharp edges of their surfaces ([`Model::find_edges`]).
    pub edge_pairs: Vec<EdgePair>,
    /// Lines of these that may cross one another in space.
    pub crossing_edges: Vec<CrossingEdges>,
    /// When friction is called after a change of contact.
    pub friction_onset: Onset,
    /// Temperatures before the first step, a node each; empty: all are zero.
    pub initial_temperatures: Vec<Temperature>,
    /// Stresses before the first step; a later one counts where two are of one point.
    pub initial_stresses: Vec<InitialStress>,
    /// Plastic strain before the first step; a later one counts where two are of one element.
    pub initial_hardening: Vec<InitialHardening>,
    /// Named amplitudes.
    pub amplitudes: Vec<Amplitude>,
    /// Steps, in order.
    pub steps: Vec<Step>,
}

impl Model {
    /// The words of the deck's contact, for a remedy that speaks of no pair.
    pub fn vocabulary(&self) -> Vocabulary {
        self.contact_pairs.first().map_or_else(Vocabulary::default, |pair| pair.vocabulary)
    }

    /// Nodes whose motion and reaction a user always wants to see: those with
    /// a non-zero prescribed motion or a load in any step, and the members of
    /// every set named by a node output request. Ascending labels.
    pub fn history_nodes(&self) -> Vec<NodeIndex> {
        let mut nodes: Vec<NodeIndex> = Vec::new();
        for step in &self.steps {
            nodes.extend(step.prescribed.iter().filter(|p| p.moves()).map(|p| p.node));
            nodes.extend(step.loads.iter().map(|load| load.node));
            // a request of all nodes names no set: states and tables are for those
            let named = step.output.node_prints.iter().filter(|own| !own.request.set.is_empty());
            nodes.extend(named.flat_map(|print| &print.nodes));
        }
        nodes.sort_by_key(|&node| self.nodes.label(node));
        nodes.dedup();
        nodes
    }

    /// Gives the numbers of instances another stride: nodes, elements, and who names them.
    pub fn restride(&mut self, stride: u64) {
        let numbering = self.nodes.numbering().clone();
        let new = |number: &mut u64| *number = numbering.restride(*number, stride);
        self.blocks.iter_mut().flat_map(|block| block.elements.labels_mut()).for_each(new);
        let pairs = self.contact_pairs.iter_mut().flat_map(|pair| &mut pair.elements);
        pairs.map(|element| &mut element.label).for_each(new);
        let steps = self.steps.iter_mut().flat_map(|step| &mut step.output.element_prints);
        steps.flat_map(|print| &mut print.elements).for_each(new);
        self.nodes.restride(stride);
    }

    /// Whether the deck speaks of temperatures.
    pub fn has_temperatures(&self) -> bool {
        !self.initial_temperatures.is_empty()
            || self.steps.iter().any(|step| !step.temperatures.is_empty())
    }

    /// The temperature of a node before the first step.
    pub fn initial_temperature(&self, node: NodeIndex) -> Temperature {
        self.initial_temperatures.get(node).copied().unwrap_or_default()
    }

    /// Whether some element or contact pair is absent in some step.
    pub fn is_changed(&self) -> bool {
        self.steps.iter().any(|step| !step.presence.is_whole())
    }

    /// Whether the way to a state of its elements is part of it, see [`ElementBlock::remembers`].
    pub fn remembers(&self) -> bool {
        self.blocks.iter().any(ElementBlock::remembers)
    }

    /// Whether its nodes move in space, not in a plane alone.
    pub fn is_in_space(&self) -> bool {
        let outside = |block: &ElementBlock| block.dofs().iter().any(|dof| !dof.is_plane());
        self.in_space || self.blocks.iter().any(outside)
    }

    /// Whether the plane of the model is half a section of parts that go all round axis 2.
    pub fn is_of_rings(&self) -> bool {
        self.blocks.iter().any(|block| block.kind.is_ring())
    }

    /// Elements that some step takes away.
    pub fn taken_away(&self) -> HashSet<ElementIndex> {
        self.steps.iter().flat_map(|step| &step.presence.absent).copied().collect()
    }

    /// The directions in which a rigid body of the model moves.
    pub fn directions(&self) -> &'static [Dof] {
        Dof::of_rigid_body(self.is_in_space())
    }

    /// Number of state variables of all elements.
    pub fn element_states(&self) -> usize {
        self.blocks.iter().map(|block| block.states() * block.elements.len()).sum()
    }

    /// The amplitude of that name, letter case ignored.
    pub fn amplitude(&self, name: &str) -> Option<&Amplitude> {
        self.amplitudes.iter().find(|amplitude| amplitude.name.eq_ignore_ascii_case(name))
    }

    /// Whether some node has axes of its own.
    pub fn has_own_axes(&self) -> bool {
        !self.transforms.is_empty()
    }

    /// The axes along which the degrees of freedom of a node are named, where these are not
    /// those of the model.
    pub fn axes_of(&self, node: NodeIndex) -> Option<Axes> {
        let own = self.transforms.iter().find(|own| own.nodes.contains(&node))?;
        Some(own.system.at(self.nodes.position(node)))
    }
}
