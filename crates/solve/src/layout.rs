//! Which numbers describe the motion, and which of them are unknown.
//!
//! ```text
//!   node 1        node 2         reference node
//!   [U1 U2 UR3]   [U1 U2 UR3]    [U1 U2 UR3] <--- rigid link --- dependent node
//!    |  |   |      |  |   |       |                               (no unknowns)
//!   prescribed    equations 0..  prescribed or equations
//! ```
//!
//! A slot is a place in the full vector of all nodes' dofs.

use slideline_mech::rigid::PointMap;
use slideline_model::{BeamElement, Dof, ElementBlock, Master, Model, NodeIndex, SpringKind, Step};

/// What a slot is in a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Nothing uses it; it stays zero.
    Inactive,
    /// Unknown; its equation.
    Free(usize),
    /// Prescribed; its place in the step's list.
    Prescribed(usize),
    /// Follows a master through a rigid link.
    Dependent,
}

/// A node that follows another as part of a rigid body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link {
    /// The dependent node.
    pub dependent: NodeIndex,
    /// The node with the dofs.
    pub master: NodeIndex,
    /// Undeformed vector from the master to the dependent node [L].
    pub arm: [f64; 2],
}

/// A point that moves with dofs: on a free node or with an arm on one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Carried {
    /// The node whose dofs carry it.
    pub node: NodeIndex,
    /// How.
    pub map: PointMap,
    /// Undeformed position [L].
    pub reference: [f64; 2],
}

/// Slots of a model and their roles in a step.
#[derive(Clone, Debug)]
pub struct Layout {
    /// Dofs of a node, in slot order.
    pub dofs: &'static [Dof],
    /// Role of every slot.
    pub roles: Vec<Role>,
    /// Rigid links, chains of links resolved to the node with the dofs.
    pub links: Vec<Link>,
    link_of: Vec<Option<usize>>,
    /// Slot of every equation.
    pub slot_of_equation: Vec<usize>,
}

impl Layout {
    /// Numbers the unknowns of a step.
    pub fn new(model: &Model, step: &Step) -> Self {
        let dofs: &'static [Dof] = &Dof::PLANE;
        let links = resolve_links(model);
        let mut link_of = vec![None; model.nodes.len()];
        for (place, link) in links.iter().enumerate() {
            link_of[link.dependent] = Some(place);
        }
        let mut layout = Self { dofs, roles: vec![], links, link_of, slot_of_equation: Vec::new() };
        layout.roles = layout.find_roles(model, step);
        for slot in 0..layout.roles.len() {
            if layout.roles[slot] == Role::Free(0) {
                layout.roles[slot] = Role::Free(layout.slot_of_equation.len());
                layout.slot_of_equation.push(slot);
            }
        }
        layout
    }

    fn find_roles(&self, model: &Model, step: &Step) -> Vec<Role> {
        let mut roles = vec![Role::Inactive; model.nodes.len() * self.dofs.len()];
        for (node, dof) in active_dofs(model) {
            if let Some(slot) = self.slot(self.carrier(node), dof) {
                roles[slot] = Role::Free(0);
            }
        }
        for link in &self.links {
            for &dof in self.dofs {
                if let Some(slot) = self.slot(link.dependent, dof) {
                    roles[slot] = Role::Dependent;
                }
            }
        }
        for (place, prescribed) in step.prescribed.iter().enumerate() {
            // Also a node without elements moves as it is told: it may be a
            // contact point.
            if let Some(slot) = self.slot(prescribed.node, prescribed.dof) {
                roles[slot] = Role::Prescribed(place);
            }
        }
        roles
    }

    /// Number of slots.
    pub fn slots(&self) -> usize {
        self.roles.len()
    }

    /// Number of unknowns.
    pub fn equations(&self) -> usize {
        self.slot_of_equation.len()
    }

    /// The slot of a node's dof, if nodes of this model have that dof.
    pub fn slot(&self, node: NodeIndex, dof: Dof) -> Option<usize> {
        let place = self.dofs.iter().position(|&own| own == dof)?;
        Some(node * self.dofs.len() + place)
    }

    /// Node and dof of a slot.
    pub fn name(&self, slot: usize) -> (NodeIndex, Dof) {
        (slot / self.dofs.len(), self.dofs[slot % self.dofs.len()])
    }

    /// The equation of a slot.
    pub fn equation(&self, slot: usize) -> Option<usize> {
        match self.roles[slot] {
            Role::Free(equation) => Some(equation),
            _ => None,
        }
    }

    /// The link that makes a node dependent.
    pub fn link(&self, node: NodeIndex) -> Option<&Link> {
        self.link_of[node].map(|place| &self.links[place])
    }

    /// The node whose dofs carry this one.
    pub fn carrier(&self, node: NodeIndex) -> NodeIndex {
        self.link(node).map_or(node, |link| link.master)
    }

    /// A node as a carried point.
    pub fn carried_node(&self, model: &Model, node: NodeIndex) -> Carried {
        let reference = model.nodes.plane(node);
        match self.link(node) {
            None => Carried { node, map: PointMap::Free, reference },
            Some(link) => {
                Carried { node: link.master, map: PointMap::Arm { arm: link.arm }, reference }
            }
        }
    }

    /// Moves dependent nodes to where their masters take them.
    pub fn follow_links(&self, displacement: &mut [f64]) {
        let width = self.dofs.len();
        for link in &self.links {
            let master = link.master * width;
            let pose = [displacement[master], displacement[master + 1], displacement[master + 2]];
            let [x, y] = PointMap::Arm { arm: link.arm }.displacement(&pose);
            displacement[link.dependent * width..][..3].copy_from_slice(&[x, y, pose[2]]);
        }
    }

    /// Hands the loads of dependent nodes to their masters, with the moment
    /// of their arms.
    pub fn carry_loads(&self, displacement: &[f64], load: &[f64], external: &mut [f64]) {
        external.copy_from_slice(load);
        let width = self.dofs.len();
        for link in &self.links {
            let dependent = link.dependent * width;
            let [fx, fy, moment] = [0, 1, 2].map(|k| load[dependent + k]);
            if fx == 0.0 && fy == 0.0 && moment == 0.0 {
                continue;
            }
            let [x, y] = self.current_arm(link, displacement);
            let master = link.master * width;
            external[dependent..dependent + 3].fill(0.0);
            external[master] += fx;
            external[master + 1] += fy;
            external[master + 2] += moment + x * fy - y * fx;
        }
    }

    /// How the moment of loads on dependent nodes falls as their masters
    /// turn, r.f: slot of the master's rotation and stiffness [F L].
    pub fn load_stiffness<'a>(
        &'a self,
        displacement: &'a [f64],
        load: &'a [f64],
    ) -> impl Iterator<Item = (usize, f64)> + 'a {
        let width = self.dofs.len();
        self.links.iter().filter_map(move |link| {
            let dependent = link.dependent * width;
            let (fx, fy) = (load[dependent], load[dependent + 1]);
            let [x, y] = self.current_arm(link, displacement);
            (fx != 0.0 || fy != 0.0).then_some((link.master * width + 2, x * fx + y * fy))
        })
    }

    fn current_arm(&self, link: &Link, displacement: &[f64]) -> [f64; 2] {
        let turn = displacement[link.master * self.dofs.len() + 2];
        PointMap::Arm { arm: link.arm }.current_arm(&[0.0, 0.0, turn])
    }
}

/// Chains of links end at the first node that is not dependent itself.
fn resolve_links(model: &Model) -> Vec<Link> {
    let master_of: std::collections::HashMap<_, _> =
        model.rigid_links.iter().map(|link| (link.dependent, link.master)).collect();
    let last = |mut node: NodeIndex| {
        for _ in 0..model.rigid_links.len() {
            match master_of.get(&node) {
                Some(&next) => node = next,
                None => break,
            }
        }
        node
    };
    model
        .rigid_links
        .iter()
        .map(|link| {
            let master = last(link.master);
            let (from, to) = (model.nodes.plane(master), model.nodes.plane(link.dependent));
            Link { dependent: link.dependent, master, arm: [to[0] - from[0], to[1] - from[1]] }
        })
        .collect()
}

/// Dofs that some element, link or rigid surface uses.
fn active_dofs(model: &Model) -> Vec<(NodeIndex, Dof)> {
    let mut active = Vec::new();
    let mut whole = |node: NodeIndex| active.extend(Dof::PLANE.map(|dof| (node, dof)));
    for link in &model.rigid_links {
        whole(link.master);
    }
    for pair in &model.contact_pairs {
        if let Master::RigidSurface(surface) = &pair.master {
            whole(surface.reference);
        }
    }
    for block in &model.blocks {
        match block {
            ElementBlock::B21(block) | ElementBlock::B22(block) | ElementBlock::B23(block) => {
                block.elements.iter().flat_map(BeamElement::all_nodes).for_each(&mut whole);
            }
            ElementBlock::Spring(_) => {}
        }
    }
    // A contact node needs no element: its translations matter all the same.
    for pair in &model.contact_pairs {
        let chain: &[NodeIndex] = match &pair.master {
            Master::SlideLine(line) => &line.nodes,
            Master::RigidSurface(_) => &[],
        };
        let slaves = pair.elements.iter().flat_map(|element| element.nodes);
        for node in slaves.chain(chain.iter().copied()) {
            active.extend([(node, Dof::U1), (node, Dof::U2)]);
        }
    }
    for block in &model.blocks {
        if let ElementBlock::Spring(block) = block {
            for element in &block.elements {
                match block.kind {
                    SpringKind::Ground(dof) => active.push((element.nodes[0], dof)),
                    SpringKind::Axial => active
                        .extend(element.nodes.iter().flat_map(|&n| [(n, Dof::U1), (n, Dof::U2)])),
                }
            }
        }
    }
    active
}
