//! Nodes that are part of a rigid body.
//!
//! ```text
//!   master (x, phi) o===========o dependent: x + R(phi) arm, phi
//! ```

use crate::dofs::DofMap;
use slideline_mech::rigid::PointMap;
use slideline_model::{Dof, Model, NodeIndex};

/// A node that follows another as part of a rigid body, in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct RigidLink {
    /// The node with the dofs, and the dependent one.
    nodes: [NodeIndex; 2],
    /// Displacements and rotation of the dependent node.
    dependent: [Option<usize>; 3],
    /// Those of the node with the dofs.
    master: [usize; 3],
}

const PLANE: [Dof; 3] = [Dof::U1, Dof::U2, Dof::UR3];

/// The links of a model, chains of them ended at the first node that is not
/// dependent itself, and the carrier of every node.
pub(super) fn resolve(model: &Model, dofs: &DofMap) -> (Vec<RigidLink>, Vec<NodeIndex>) {
    let mut follows: Vec<NodeIndex> = (0..model.nodes.len()).collect();
    for link in &model.rigid_links {
        follows[link.dependent] = link.master;
    }
    let last = |mut node: NodeIndex| {
        for _ in 0..model.rigid_links.len() {
            node = follows[node];
        }
        node
    };
    let mut carrier: Vec<NodeIndex> = (0..model.nodes.len()).collect();
    let mut links = Vec::with_capacity(model.rigid_links.len());
    for link in &model.rigid_links {
        let master = last(link.master);
        carrier[link.dependent] = master;
        let [Some(x), Some(y), Some(turn)] = PLANE.map(|dof| dofs.find(master, dof)) else {
            continue; // a master that the numbering does not know: none is made
        };
        links.push(RigidLink {
            nodes: [master, link.dependent],
            dependent: PLANE.map(|dof| dofs.find(link.dependent, dof)),
            master: [x, y, turn],
        });
    }
    (links, carrier)
}

impl RigidLink {
    /// The undeformed vector from the master to the dependent node [L].
    pub fn arm(&self, model: &Model) -> PointMap {
        let [from, to] = self.nodes.map(|node| model.nodes.plane(node));
        PointMap::Arm { arm: [to[0] - from[0], to[1] - from[1]] }
    }

    /// Dependent dofs with their components.
    pub fn dependent_dofs(&self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let own = self.dependent;
        (0..3).filter_map(move |component| Some((component, own[component]?)))
    }

    /// Dofs that a component follows.
    pub fn followed(&self, component: usize) -> [Option<usize>; 2] {
        let turn = self.master[2];
        match component {
            2 => [Some(turn), None],
            _ => [Some(self.master[component]), Some(turn)],
        }
    }

    /// Their coefficients at displacements `u`, in the same order.
    pub fn coefficients(&self, arm: &PointMap, component: usize, u: &[f64]) -> [f64; 2] {
        let [x, y] = arm.current_arm(&[0.0, 0.0, u[self.master[2]]]);
        match component {
            0 => [1.0, -y],
            1 => [1.0, x],
            _ => [1.0, 0.0],
        }
    }

    /// Moves the dependent node to where its master takes it.
    pub fn enforce(&self, arm: &PointMap, u: &mut [f64]) {
        let pose = self.master.map(|dof| u[dof]);
        let [x, y] = arm.displacement(&pose);
        for (own, value) in self.dependent.into_iter().zip([x, y, pose[2]]) {
            if let Some(own) = own {
                u[own] = value;
            }
        }
    }

    /// The rotation of the master and -(r . f), with f the force on the
    /// dependent node [F L]; docs/theory.md eq. (4.4).
    pub fn turning(&self, arm: &PointMap, u: &[f64], f: &[f64]) -> Option<(usize, f64)> {
        let [fx, fy] = [self.dependent[0], self.dependent[1]].map(|dof| dof.map_or(0.0, |d| f[d]));
        let turn = self.master[2];
        let [x, y] = arm.current_arm(&[0.0, 0.0, u[turn]]);
        (fx != 0.0 || fy != 0.0).then_some((turn, -(x * fx + y * fy)))
    }
}
