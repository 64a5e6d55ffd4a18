//! Which nodes move together: bodies joined by elements and rigid links.

use slideline_model::{Master, Model, NodeIndex};

/// Nodes in bodies: two nodes of one body cannot move apart rigidly.
pub struct Bodies {
    parent: Vec<NodeIndex>,
    /// Whether a node has stiffness or is a reference node.
    pub active: Vec<bool>,
    /// Whether a node hangs on a rigid link.
    pub dependent: Vec<Option<NodeIndex>>,
}

impl Bodies {
    /// Bodies of a model.
    pub fn of(model: &Model) -> Self {
        let count = model.nodes.len();
        let mut bodies = Self {
            parent: (0..count).collect(),
            active: vec![false; count],
            dependent: vec![None; count],
        };
        for beam in model.blocks.iter().filter_map(|block| block.beams()) {
            for element in &beam.elements {
                let first = element.nodes[0];
                for node in element.all_nodes() {
                    bodies.join(first, node);
                    bodies.active[node] = true;
                }
            }
        }
        for link in &model.rigid_links {
            bodies.join(link.dependent, link.master);
            bodies.dependent[link.dependent] = Some(link.master);
            bodies.active[link.dependent] = true;
            bodies.active[link.master] = true;
        }
        for pair in &model.contact_pairs {
            if let Master::RigidSurface(surface) = &pair.master {
                bodies.active[surface.reference] = true;
            }
        }
        bodies
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
