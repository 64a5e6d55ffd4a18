//! Nodes that are part of a rigid body.
//!
//! ```text
//!   master (x, phi) o===========o dependent: x + R(phi) arm, phi
//! ```

use crate::dofs::DofMap;
use slideline_mech::rigid::PointMap;
use slideline_mech::rotation;
use slideline_model::{Dof, Model, NodeIndex};

/// A node that follows another as part of a rigid body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct RigidLink {
    /// The node with the dofs, and the dependent one.
    nodes: [NodeIndex; 2],
    /// Displacements and rotations of the dependent node, those that follow.
    dependent: [Option<usize>; 6],
    /// How the body moves.
    body: Body,
}

/// The dofs of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Body {
    /// In the plane: two displacements and a rotation.
    Plane { pose: [usize; 3] },
    /// In space: three displacements and a rotation vector.
    Space { shift: [usize; 3], turn: [usize; 3] },
}

/// The most dofs that one follows.
const MOST: usize = 4;

/// The links of a model, chains of them ended at the first node that is not
/// dependent itself, and the carrier of every node.
pub(super) fn resolve(model: &Model, dofs: &DofMap) -> (Vec<RigidLink>, Vec<NodeIndex>) {
    let mut follows: Vec<NodeIndex> = (0..model.nodes.len()).collect();
    let mut turns = vec![None; model.nodes.len()];
    for link in &model.rigid_links {
        follows[link.dependent] = link.master;
        turns[link.master] = link.turn;
    }
    let last = |mut node: NodeIndex| {
        for _ in 0..model.rigid_links.len() {
            if follows[node] == node {
                break;
            }
            node = follows[node];
        }
        node
    };
    let in_space = model.is_in_space();
    let mut carrier: Vec<NodeIndex> = (0..model.nodes.len()).collect();
    let mut links = Vec::with_capacity(model.rigid_links.len());
    for link in &model.rigid_links {
        let master = last(link.master);
        if link.follows == slideline_model::RigidLink::WELDED {
            carrier[link.dependent] = master;
        }
        let body = match in_space {
            true => Body::in_space(dofs, (master, turns[master])),
            false => Body::in_plane(dofs, (master, turns[master])),
        };
        let Some(body) = body else {
            continue; // a master that the numbering does not know: none is made
        };
        let own = |dof: Dof| dofs.find(link.dependent, dof).filter(|_| link.follows[dof as usize]);
        let nodes = [master, link.dependent];
        links.push(RigidLink { nodes, dependent: Dof::ALL.map(own), body });
    }
    (links, carrier)
}

/// The dof that is a rotation of a body: its own, or a displacement of its rotation node.
fn turning(dofs: &DofMap, master: NodeIndex, turn: Option<NodeIndex>, dof: Dof) -> Option<usize> {
    match turn {
        Some(node) => dofs.find(node, Dof::ALL[dof as usize - 3]),
        None => dofs.find(master, dof),
    }
}

impl Body {
    fn in_plane(dofs: &DofMap, (master, turn): (NodeIndex, Option<NodeIndex>)) -> Option<Self> {
        let [x, y] = [Dof::U1, Dof::U2].map(|dof| dofs.find(master, dof));
        Some(Self::Plane { pose: [x?, y?, turning(dofs, master, turn, Dof::UR3)?] })
    }

    fn in_space(dofs: &DofMap, (master, turn): (NodeIndex, Option<NodeIndex>)) -> Option<Self> {
        let [x, y, z] = [Dof::U1, Dof::U2, Dof::U3].map(|dof| dofs.find(master, dof));
        let [a, b, c] = [Dof::UR1, Dof::UR2, Dof::UR3].map(|dof| turning(dofs, master, turn, dof));
        Some(Self::Space { shift: [x?, y?, z?], turn: [a?, b?, c?] })
    }
}

/// An arm in the plane.
fn in_plane([x, y, _]: [f64; 3]) -> PointMap {
    PointMap::Arm { arm: [x, y] }
}

impl RigidLink {
    /// The undeformed vector from the master to the dependent node [L].
    pub fn arm(&self, model: &Model) -> [f64; 3] {
        let [from, to] = self.nodes.map(|node| model.nodes.get(node).position);
        std::array::from_fn(|k| to[k] - from[k])
    }

    /// Dependent dofs with their components.
    pub fn dependent_dofs(&self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let own = self.dependent;
        (0..6).filter_map(move |component| Some((component, own[component]?)))
    }

    /// Dofs that a component follows.
    pub fn followed(&self, component: usize) -> [Option<usize>; MOST] {
        match self.body {
            Body::Plane { pose: [.., turn], .. } if component >= 3 => {
                [Some(turn), None, None, None]
            }
            Body::Plane { pose, .. } => [Some(pose[component.min(1)]), Some(pose[2]), None, None],
            Body::Space { turn, .. } if component >= 3 => {
                [Some(turn[component - 3]), None, None, None]
            }
            Body::Space { shift, turn: [a, b, c], .. } => {
                [Some(shift[component]), Some(a), Some(b), Some(c)]
            }
        }
    }

    /// Their coefficients at displacements `u`, in the same order.
    pub fn coefficients(&self, arm: [f64; 3], component: usize, u: &[f64]) -> [f64; MOST] {
        match self.body {
            _ if component >= 3 => [1.0, 0.0, 0.0, 0.0],
            Body::Plane { pose } => {
                let [x, y] = in_plane(arm).current_arm(&[0.0, 0.0, u[pose[2]]]);
                [1.0, if component == 0 { -y } else { x }, 0.0, 0.0]
            }
            Body::Space { turn, .. } => {
                let [a, b, c] = rotation::slopes(turn.map(|dof| u[dof]), arm)[component];
                [1.0, a, b, c]
            }
        }
    }

    /// Moves the dependent node to where its master takes it.
    pub fn enforce(&self, arm: [f64; 3], u: &mut [f64]) {
        let values = match self.body {
            Body::Plane { pose } => {
                let pose = pose.map(|dof| u[dof]);
                let [x, y] = in_plane(arm).displacement(&pose);
                [x, y, 0.0, 0.0, 0.0, pose[2]]
            }
            Body::Space { shift, turn } => {
                let phi = turn.map(|dof| u[dof]);
                let [x, y, z] = rotation::displacement(&phi, arm);
                let [a, b, c] = shift.map(|dof| u[dof]);
                [a + x, b + y, c + z, phi[0], phi[1], phi[2]]
            }
        };
        for (own, value) in self.dependent.into_iter().zip(values) {
            if let Some(own) = own {
                u[own] = value;
            }
        }
    }

    /// Pairs of rotations of the body with f . d2x/dphi2, f the force on the
    /// dependent node [F L]; docs/theory.md eqs (4.4), (4.6).
    pub fn turning(
        &self,
        arm: [f64; 3],
        u: &[f64],
        f: &[f64],
        mut call: impl FnMut(usize, usize, f64),
    ) {
        let [own @ .., _, _, _] = self.dependent;
        let force = own.map(|dof| dof.map_or(0.0, |dof| f[dof]));
        if force == [0.0; 3] {
            return;
        }
        match self.body {
            Body::Plane { pose: [.., turn] } => {
                let [x, y] = in_plane(arm).current_arm(&[0.0, 0.0, u[turn]]);
                call(turn, turn, -(x * force[0] + y * force[1]));
            }
            Body::Space { turn, .. } => {
                let curvature = rotation::curvature(turn.map(|dof| u[dof]), arm, force);
                for (i, row) in curvature.iter().enumerate() {
                    row.iter().zip(turn).for_each(|(&value, dof)| call(turn[i], dof, value));
                }
            }
        }
    }
}
