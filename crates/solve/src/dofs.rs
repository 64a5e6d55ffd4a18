//! Which numbers describe the motion.
//!
//! ```text
//!   node 1          node 2      node 3         dofs, one after the other:
//!   [U1 U2 UR3]     [U1 U2]     [U1 U2 UR3]    0 1 2   3 4   5 6 7
//!   beam            solid       no element
//! ```
//!
//! A node has the dofs of its elements and of the rigid body or contact that it
//! belongs to; one without elements has all, to move as it is told. The numbering
//! knows no step: it holds for a whole run and for those that go on from it.

use slideline_model::{Dof, Master, Model, NodeIndex};
use std::ops::Range;

/// The dofs of a model's nodes, numbered node by node.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct DofMap {
    /// First dof of every node, and behind the last one their number.
    first: Vec<usize>,
    /// Node and direction of every dof.
    names: Vec<(NodeIndex, Dof)>,
    /// Whether an element, a rigid body or contact uses it.
    active: Vec<bool>,
    /// Those that are rotations.
    rotations: Vec<usize>,
    /// Directions that some node has.
    kinds: Vec<Dof>,
}

impl DofMap {
    /// Numbers the dofs of a model.
    pub fn new(model: &Model) -> Self {
        let mut has = vec![[None; Dof::ALL.len()]; model.nodes.len()];
        // a spring acts on a node, but is no part that the node belongs to
        let mut alone = vec![true; model.nodes.len()];
        let parts = model.blocks.iter().filter(|block| block.kind.joins());
        let members = parts.flat_map(|block| block.elements.iter()).flat_map(|e| e.nodes);
        members.for_each(|&node| alone[node] = false);
        let free =
            (0..alone.len()).filter(|&node| alone[node]).flat_map(|node| rigid_body(model, node));
        free.for_each(|(node, dof)| has[node][dof as usize] = Some(false));
        of_elements(model, |node, dof| has[node][dof as usize] = Some(true));
        of_bodies(model, |(node, dof)| has[node][dof as usize] = Some(true));
        let count = has.iter().flatten().flatten().count();
        let mut map = Self {
            first: Vec::with_capacity(model.nodes.len() + 1),
            names: Vec::with_capacity(count),
            active: Vec::with_capacity(count),
            ..Self::default()
        };
        map.first.push(0);
        for (node, has) in has.iter().enumerate() {
            for dof in Dof::ALL {
                if let Some(active) = has[dof as usize] {
                    map.names.push((node, dof));
                    map.active.push(active);
                }
            }
            map.first.push(map.names.len());
        }
        let turning = |dof: &usize| map.is_rotation(*dof);
        let mut rotations = Vec::with_capacity((0..count).filter(turning).count());
        rotations.extend((0..count).filter(turning));
        map.rotations = rotations;
        let used = |dof: &Dof| dof.is_plane() || map.names.iter().any(|(_, own)| own == dof);
        map.kinds = Dof::ALL.into_iter().filter(used).collect();
        map
    }

    /// How many.
    pub fn len(&self) -> usize {
        self.names.len()
    }

    /// The dofs of a node.
    pub fn of_node(&self, node: NodeIndex) -> Range<usize> {
        self.first[node]..self.first[node + 1]
    }

    /// The dof of a node in a direction, where it has it.
    pub fn find(&self, node: NodeIndex, dof: Dof) -> Option<usize> {
        let own = self.of_node(node);
        let place = self.names[own.clone()].iter().position(|&(_, kind)| kind == dof)?;
        Some(own.start + place)
    }

    /// Node and direction of every dof.
    pub fn names(&self) -> &[(NodeIndex, Dof)] {
        &self.names
    }

    /// Node and direction of a dof.
    pub fn name(&self, dof: usize) -> (NodeIndex, Dof) {
        self.names[dof]
    }

    /// Whether a dof is a rotation.
    pub fn is_rotation(&self, dof: usize) -> bool {
        self.names[dof].1.is_rotation()
    }

    /// Whether an element, a rigid body or contact uses a dof: what only a
    /// support or a load names does not move by itself.
    pub fn is_active(&self, dof: usize) -> bool {
        self.active[dof]
    }

    /// The dofs that are rotations, ascending.
    pub fn rotations(&self) -> &[usize] {
        &self.rotations
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.first.len() - 1
    }

    /// Directions that some node of the model has, those of the plane always.
    pub fn kinds(&self) -> &[Dof] {
        &self.kinds
    }

    /// A value of a nodal vector; zero where the node lacks the dof.
    pub fn read(&self, vector: &[f64], node: NodeIndex, dof: Dof) -> f64 {
        self.find(node, dof).map_or(0.0, |dof| vector[dof])
    }

    /// The displacement of a node [L]; zero along an axis whose dof it lacks.
    pub fn translation(&self, u: &[f64], node: NodeIndex) -> [f64; 3] {
        std::array::from_fn(|axis| self.read(u, node, Dof::ALL[axis]))
    }

    /// The dofs of a node's displacement, those of the plane at least.
    pub fn translations(&self, node: NodeIndex) -> Translations {
        let of = |axis: usize| self.find(node, Dof::ALL[axis]);
        let axes = if of(2).is_some() { 3 } else { 2 };
        Translations { dofs: [0, 1, 2].map(|axis| of(axis).unwrap_or(0)), axes }
    }
}

/// The dofs that carry a point in space: one an axis of the model's dimension.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Translations {
    dofs: [usize; 3],
    axes: usize,
}

impl Translations {
    /// The dofs, axis by axis.
    pub fn as_slice(&self) -> &[usize] {
        &self.dofs[..self.axes]
    }

    /// Where a point that follows them stands [L].
    pub fn displace(&self, mut position: [f64; 3], u: &[f64]) -> [f64; 3] {
        for (at, &dof) in position.iter_mut().zip(self.as_slice()) {
            *at += u[dof];
        }
        position
    }
}

/// Calls back with the dofs that elements give stiffness to.
fn of_elements(model: &Model, mut note: impl FnMut(NodeIndex, Dof)) {
    for block in &model.blocks {
        let stiffened = block.stiffened_dofs();
        for &node in block.elements.iter().flat_map(|element| element.nodes) {
            stiffened.iter().for_each(|&dof| note(node, dof));
        }
    }
}

/// Calls back with the dofs that rigid bodies and contact use.
fn of_bodies(model: &Model, mut note: impl FnMut((NodeIndex, Dof))) {
    for link in &model.rigid_links {
        for (node, dof) in rigid_body(model, link.dependent) {
            if link.follows[dof as usize] {
                note((node, dof));
            }
        }
        for (node, dof) in rigid_body(model, link.master) {
            match link.turn.filter(|_| dof.is_rotation()) {
                Some(turn) => note((turn, Dof::ALL[dof as usize - 3])),
                None => note((node, dof)),
            }
        }
    }
    for constraint in &model.linear_constraints {
        note(constraint.dependent);
        constraint.terms.iter().for_each(|&(node, dof, _)| note((node, dof)));
    }
    for pair in &model.contact_pairs {
        // A contact node needs no element: its translations matter all the same.
        let slaves = pair.elements.iter().flat_map(|element| element.nodes);
        slaves.flat_map(|node| point(model, node)).for_each(&mut note);
        match &pair.master {
            Master::RigidSurface(surface) => {
                rigid_body(model, surface.reference).for_each(&mut note)
            }
            Master::SlideLine(line) => {
                line.nodes.iter().flat_map(|&node| point(model, node)).for_each(&mut note);
            }
        }
    }
}

/// The dofs of a node that turns.
fn rigid_body(model: &Model, node: NodeIndex) -> impl Iterator<Item = (NodeIndex, Dof)> + use<> {
    model.directions().iter().map(move |&dof| (node, dof))
}

/// The dofs of a node that does not turn.
fn point(model: &Model, node: NodeIndex) -> impl Iterator<Item = (NodeIndex, Dof)> + use<> {
    rigid_body(model, node).filter(|(_, dof)| !dof.is_rotation())
}
