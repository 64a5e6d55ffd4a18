//! Nodes that are part of a rigid body.
//!
//! ```text
//!   master (x, phi) o===========o dependent: x + R(phi) arm, phi
//! ```

use crate::dofs::DofMap;
use slideline_mech::axes::{self, Axes};
use slideline_mech::rigid::PlaneTurn;
use slideline_mech::rotation;
use slideline_mech::turn::Turn;
use slideline_model::{Dof, Model, NodeIndex};

/// A node that follows another as part of a rigid body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct RigidLink {
    /// The node with the dofs, and the dependent one.
    nodes: [NodeIndex; 2],
    /// Displacements and rotations of the dependent node, those that follow: along its own
    /// axes where it has some.
    dependent: [Option<usize>; 6],
    /// Its place among the nodes with axes of their own.
    turned: Option<usize>,
    /// How the body moves.
    body: Body,
    /// Whether it moves linearly: the job has no NLGEOM.
    small: bool,
}

/// The dofs of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Body {
    /// In the plane: two displacements and a rotation.
    Plane { pose: [usize; 3] },
    /// In space: three displacements and a rotation vector.
    Space { shift: [usize; 3], turn: Turning },
}

/// The three dofs that turn a body in space.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Turning {
    dofs: [usize; 3],
    /// The node whose rotations they are; `None`: they are displacements of a rotation node.
    node: Option<NodeIndex>,
}

impl Turning {
    /// What they count from.
    fn start(&self, turns: &[Turn]) -> Turn {
        self.node.and_then(|node| turns.get(node).copied()).unwrap_or_default()
    }

    /// The rotation vector, how an arm [L] stood at its start and how far its end had moved then.
    fn at(&self, (u, turns): (&[f64], &[Turn]), arm: Arm) -> ([f64; 3], Arm, Arm) {
        let start = self.start(turns);
        let (arm, moved) = start.arm(arm);
        (start.vector(self.dofs.map(|dof| u[dof])), arm, moved)
    }
}

/// The most dofs that one follows.
const MOST: usize = 6;

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
    let small = model.steps.iter().all(|step| !step.nlgeom);
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
        let own = |dof: Dof| dofs.named(link.dependent, dof).filter(|_| link.follows[dof as usize]);
        let nodes = [master, link.dependent];
        let turned = dofs.place_of_turned(link.dependent);
        links.push(RigidLink { nodes, dependent: Dof::ALL.map(own), turned, body, small });
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
        let node = turn.is_none().then_some(master);
        Some(Self::Space { shift: [x?, y?, z?], turn: Turning { dofs: [a?, b?, c?], node } })
    }
}

/// The undeformed vector from a master to its dependent node [L].
type Arm = [f64; 3];

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

    /// Whether its arm turns where the dofs move so.
    pub fn turns_along(&self, moved: &[f64]) -> bool {
        let moves = |dof: &usize| moved[*dof] != 0.0;
        !self.small
            && match &self.body {
                Body::Plane { pose: [.., turn] } => moves(turn),
                Body::Space { turn, .. } => turn.dofs.iter().any(moves),
            }
    }

    /// The angle by which the arm of a body in the plane has turned [1]; none without NLGEOM,
    /// where displacements are those of small rotations, docs/theory.md eq. (4.2).
    fn angle(&self, pose: [usize; 3], u: &[f64]) -> f64 {
        if self.small { 0.0 } else { u[pose[2]] }
    }

    /// The same of a body in space, as [`Turning::at`].
    fn turned_by(&self, turn: Turning, at: (&[f64], &[Turn]), arm: Arm) -> ([f64; 3], Arm, Arm) {
        if self.small { ([0.0; 3], arm, [0.0; 3]) } else { turn.at(at, arm) }
    }

    /// The place of the dependent node among those with axes of their own.
    pub fn place_of_turned(&self) -> Option<usize> {
        self.turned
    }

    /// Dofs that a component follows.
    pub fn followed(&self, component: usize) -> [Option<usize>; MOST] {
        let mut followed = [None; MOST];
        let mut at = 0;
        let mut add = |dof: usize| {
            followed[at] = Some(dof);
            at += 1;
        };
        let all = self.turned.is_some();
        let shifted = |k: usize| component < 3 && (all || k == component);
        match self.body {
            Body::Plane { pose: [x, y, turn] } => {
                [x, y]
                    .into_iter()
                    .enumerate()
                    .filter(|&(k, _)| shifted(k))
                    .for_each(|own| add(own.1));
                add(turn);
            }
            Body::Space { shift, turn } => {
                shift
                    .into_iter()
                    .enumerate()
                    .filter(|&(k, _)| shifted(k))
                    .for_each(|own| add(own.1));
                let turns = |k: usize| all || component < 3 || k == component - 3;
                turn.dofs
                    .into_iter()
                    .enumerate()
                    .filter(|&(k, _)| turns(k))
                    .for_each(|own| add(own.1));
            }
        }
        followed
    }

    /// Adds the coefficients of all components that follow, in the order of [`Self::followed`]; the
    /// dependent node has an arm and perhaps axes of its own. `turned` is scratch that the links of
    /// a body in the plane share.
    pub fn push_coefficients(
        &self,
        (arm, axes): (Arm, Option<&Axes>),
        (at, turned): ((&[f64], &[Turn]), &mut PlaneTurn),
        into: &mut Vec<f64>,
    ) {
        if let (Body::Plane { pose }, None) = (self.body, axes) {
            let [x, y] = turned.become_by(self.angle(pose, at.0)).arm(arm);
            for (component, _) in self.dependent_dofs() {
                match component {
                    0 => into.extend([1.0, -y]),
                    1 => into.extend([1.0, x]),
                    _ => into.push(1.0),
                }
            }
            return;
        }
        for (component, _) in self.dependent_dofs() {
            let count = self.followed(component).into_iter().flatten().count();
            into.extend(&self.coefficients((arm, axes), component, at)[..count]);
        }
    }

    /// Those of a component at displacements `u`.
    fn coefficients(
        &self,
        (arm, axes): (Arm, Option<&Axes>),
        component: usize,
        at: (&[f64], &[Turn]),
    ) -> [f64; MOST] {
        let Some(axes) = axes else { return self.plain_coefficients(arm, component, at) };
        let (u, _) = at;
        let axis = axes[component % 3];
        match self.body {
            Body::Plane { .. } if component >= 3 => [axis[2], 0.0, 0.0, 0.0, 0.0, 0.0],
            Body::Plane { pose } => {
                let [x, y] = PlaneTurn::by(self.angle(pose, u)).arm(arm);
                [axis[0], axis[1], axis[1] * x - axis[0] * y, 0.0, 0.0, 0.0]
            }
            Body::Space { .. } if component >= 3 => [axis[0], axis[1], axis[2], 0.0, 0.0, 0.0],
            Body::Space { turn, .. } => {
                let (phi, arm, _) = self.turned_by(turn, at, arm);
                let slopes = rotation::slopes(phi, arm);
                let by = |k: usize| (0..3).map(|j| axis[j] * slopes[j][k]).sum();
                [axis[0], axis[1], axis[2], by(0), by(1), by(2)]
            }
        }
    }

    /// The same along the axes of the model.
    fn plain_coefficients(&self, arm: Arm, component: usize, at: (&[f64], &[Turn])) -> [f64; MOST] {
        let (u, _) = at;
        match self.body {
            _ if component >= 3 => [1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            Body::Plane { pose } => {
                let [x, y] = PlaneTurn::by(self.angle(pose, u)).arm(arm);
                [1.0, if component == 0 { -y } else { x }, 0.0, 0.0, 0.0, 0.0]
            }
            Body::Space { turn, .. } => {
                let (phi, arm, _) = self.turned_by(turn, at, arm);
                let [a, b, c] = rotation::slopes(phi, arm)[component];
                [1.0, a, b, c, 0.0, 0.0]
            }
        }
    }

    /// Moves the dependent node to where its master takes it; `turned` as for the coefficients.
    pub fn enforce(
        &self,
        (arm, axes): (Arm, Option<&Axes>),
        (turns, turned): (&[Turn], &mut PlaneTurn),
        u: &mut [f64],
    ) {
        let mut values = match self.body {
            Body::Plane { pose } if self.small => {
                let [x, y, angle] = pose.map(|dof| u[dof]);
                [x - angle * arm[1], y + angle * arm[0], 0.0, 0.0, 0.0, angle]
            }
            Body::Space { shift, turn } if self.small => {
                let ([a, b, c], [d, e, f]) = (shift.map(|dof| u[dof]), turn.dofs.map(|dof| u[dof]));
                let [x, y, z] = arm;
                [a + (e * z - f * y), b + (f * x - d * z), c + (d * y - e * x), d, e, f]
            }
            Body::Plane { pose } => {
                let [x, y, angle] = pose.map(|dof| u[dof]);
                let [x, y] = turned.become_by(angle).displacement([x, y], arm);
                [x, y, 0.0, 0.0, 0.0, angle]
            }
            Body::Space { shift, turn } => {
                let (phi, arm, moved) = turn.at((u, turns), arm);
                let [x, y, z] = rotation::displacement(&phi, arm);
                let [a, b, c] = shift.map(|dof| u[dof]);
                let [d, e, f] = turn.dofs.map(|dof| u[dof]);
                [a + (x + moved[0]), b + (y + moved[1]), c + (z + moved[2]), d, e, f]
            }
        };
        if let Some(axes) = axes {
            let [x, y, z, a, b, c] = values;
            let ([x, y, z], [a, b, c]) =
                (axes::along(axes, [x, y, z]), axes::along(axes, [a, b, c]));
            values = [x, y, z, a, b, c];
        }
        for (own, value) in self.dependent.into_iter().zip(values) {
            if let Some(own) = own {
                u[own] = value;
            }
        }
    }

    /// Pairs of rotations of the body with f . d2x/dphi2, f the force on the
    /// dependent node [F L]; docs/theory.md eqs (4.4), (4.5).
    pub fn turning(
        &self,
        (arm, axes): (Arm, Option<&Axes>),
        at: (&[f64], &[Turn]),
        f: &[f64],
        mut call: impl FnMut(usize, usize, f64),
    ) {
        let [own @ .., _, _, _] = self.dependent;
        let force = own.map(|dof| dof.map_or(0.0, |dof| f[dof]));
        if self.small || force == [0.0; 3] {
            return;
        }
        let force = axes.map_or(force, |axes| axes::vector(axes, force));
        match self.body {
            Body::Plane { pose: [.., turn] } => {
                let [x, y] = PlaneTurn::by(at.0[turn]).arm(arm);
                call(turn, turn, -(x * force[0] + y * force[1]));
            }
            Body::Space { turn, .. } => {
                let (phi, arm, _) = turn.at(at, arm);
                let (curvature, turn) = (rotation::curvature(phi, arm, force), turn.dofs);
                for (i, row) in curvature.iter().enumerate() {
                    row.iter().zip(turn).for_each(|(&value, dof)| call(turn[i], dof, value));
                }
            }
        }
    }
}
