//! Which nodes move together: bodies joined by elements, rigid links and equations.

use slideline_model::{Model, NodeIndex, Presence};

/// Nodes in bodies: two nodes of one body cannot move apart rigidly.
pub struct Bodies {
    parent: Vec<NodeIndex>,
    /// Whether a node has stiffness or is a reference node.
    pub active: Vec<bool>,
    /// Whether a node hangs on a rigid link.
    pub dependent: Vec<Option<NodeIndex>>,
    /// Whether an element of the node's body can strain, by the node that stands
    /// for the body.
    flexible: Vec<bool>,
}

impl Bodies {
    /// Bodies of what there is of a model.
    pub fn of(model: &Model, presence: &Presence) -> Self {
        let count = model.nodes.len();
        let mut bodies = Self {
            parent: (0..count).collect(),
            active: vec![false; count],
            dependent: vec![None; count],
            flexible: vec![false; count],
        };
        for (_, element) in presence.elements(&model.blocks).filter(|(block, _)| block.kind.joins())
        {
            let first = element.nodes[0];
            for &node in element.nodes {
                bodies.join(first, node);
                bodies.active[node] = true;
            }
        }
        for link in &model.rigid_links {
            bodies.join(link.dependent, link.master);
            bodies.dependent[link.dependent] = Some(link.master);
            bodies.active[link.dependent] = true;
            bodies.active[link.master] = true;
        }
        // what an equation or a tie joins is taken as one body: it may hold
        for constraint in &model.linear_constraints {
            for &(node, ..) in &constraint.terms {
                bodies.join(constraint.dependent.0, node);
            }
        }
        let pairs = model.contact_pairs.iter().enumerate();
        for (_, pair) in pairs.filter(|&(place, _)| presence.has_pair(place)) {
            for surface in pair.rigid_surfaces() {
                bodies.active[surface.reference] = true;
            }
        }
        bodies.find_flexible(model, presence);
        bodies
    }

    fn find_flexible(&mut self, model: &Model, presence: &Presence) {
        for (_, element) in presence.elements(&model.blocks).filter(|(block, _)| block.kind.joins())
        {
            if element.ends().iter().any(|&node| self.dependent[node].is_none()) {
                let body = self.of_node(element.nodes[0]);
                self.flexible[body] = true;
            }
        }
    }

    /// Whether an element of the body of `node` can strain.
    pub fn is_flexible(&self, node: NodeIndex) -> bool {
        self.flexible[self.of_node(node)]
    }

    /// The node that the rigid body of `node` follows, itself where it is
    /// that node; `None` for a node that moves on its own.
    pub fn rigid_with(&self, node: NodeIndex) -> Option<NodeIndex> {
        self.dependent[node].or_else(|| self.dependent.contains(&Some(node)).then_some(node))
    }

    /// The node that stands for a node's body.
    pub fn of_node(&self, mut node: NodeIndex) -> NodeIndex {
        while self.parent[node] != node {
            node = self.parent[node];
        }
        node
    }

    fn join(&mut self, a: NodeIndex, b: NodeIndex) {
        let (a, b) = (self.of_node(a), self.of_node(b));
        self.parent[a.max(b)] = a.min(b);
    }
}
