//! Which bodies supports and springs to ground hold, whatever contact does.
//!
//! ```text
//!   |/o=======o     held: three rows of rank 3        o=======o   loose: rank 2,
//!   |/clamped                                         ^       ^   free to move along
//! ```
//!
//! Decided from the structure: nodes that beams and rigid links join move as one
//! body, supports, springs to ground and equations to what is prescribed give rows for its rigid motion. A tangent
//! that happens to be singular proves nothing of a body that is held: there the
//! structure has reached a limit of its strength, or numbers one of theirs.

mod bodies;
pub mod clamped;
pub mod loose;
mod rigid_motions;
mod ties;
pub mod unopposed;

use bodies::{Bodies, Term};
use rigid_motions::{DEPENDENT, Motion, rank, rigid_motion, seen};
use slideline_model::{Dof, Model, NodeIndex, SpringWay, Step};
use ties::{Rows, Ties};

/// The bodies of a model and how a step restrains them.
pub struct Restraint {
    bodies: Bodies,
    /// By the root of a body.
    rows: Rows,
    ties: Ties,
    /// Whether bodies move in space.
    in_space: bool,
    /// The size of the model [L].
    size: f64,
}

/// A rigid motion of a body.
pub struct RigidMotion {
    /// The node of the body that moves most.
    pub node: NodeIndex,
    /// Its motion, of length one [1].
    pub way: [f64; 3],
    /// The turn about the axes that belongs to it [1/L].
    pub turn: [f64; 3],
}

impl Restraint {
    /// That of a step. Rotations count with the size of the model, so that the
    /// units of length decide nothing.
    pub fn of(model: &Model, step: &Step) -> Self {
        let presence = &step.presence;
        let size = (0..model.nodes.len())
            .flat_map(|node| model.nodes.position(node))
            .fold(0.0_f64, |size, x| size.max(x.abs()));
        let mut bodies = Bodies::of(model, presence);
        bodies.weld(model, size);
        let tethers = bodies.tethers(model, step);
        bodies.weld(model, size);
        let held = step.prescribed.iter().map(|prescribed| (prescribed.node, prescribed.dof));
        let springs = presence.elements(&model.blocks).filter_map(|(block, spring)| {
            let section = block.springs()?.section;
            let SpringWay::Dof(dof) = section.way else { return None };
            let to_ground = section.law.stiffest() != 0.0 && spring.nodes.len() == 1;
            to_ground.then_some((spring.nodes[0], dof))
        });
        let held = held.chain(springs).chain(presence.rings(&model.blocks));
        let held: Vec<Term> = held.map(|(node, dof)| (node, dof, 1.0)).collect();
        let mut rows = Rows::new();
        for terms in held.chunks(1).chain(tethers.iter().map(Vec::as_slice)) {
            let root = bodies.root(terms[0].0);
            let origin = model.nodes.position(root);
            let mut row = [0.0; 6];
            for &(node, dof, factor) in terms {
                let own = seen(model, (node, dof), (origin, size));
                row.iter_mut().zip(own).for_each(|(sum, part)| *sum += factor * part);
            }
            // one within a body may hinder none of its motions, but for rounding
            if row.iter().any(|part| part.abs() > DEPENDENT) {
                rows.entry(root).or_default().push(row);
            }
        }
        let in_space = model.is_in_space();
        let ties = Ties::of((model, size), &mut bodies, &mut rows);
        Self { bodies, rows, ties, in_space, size }
    }

    /// The components of rigid motions.
    fn unknowns(&self) -> &'static [usize] {
        if self.in_space { &[0, 1, 2, 3, 4, 5] } else { &[0, 1, 5] }
    }

    /// Whether no rigid motion is left to the body of a node, contact aside.
    pub fn holds(&mut self, node: NodeIndex) -> bool {
        let root = self.bodies.root(node);
        let group = self.ties.group(root);
        if group.len() > 1 {
            return self.ties.motions(&group, &self.rows, self.unknowns()).is_empty();
        }
        let needed = match (self.in_space, self.bodies.turns.contains(&root)) {
            (true, true) => 6,
            (true, false) | (false, true) => 3,
            (false, false) => 2,
        };
        rank(self.rows.get(&root).map_or(&[], Vec::as_slice)) >= needed
    }

    /// A rigid motion that is left to the body of a node and moves it, contact aside; `None`: there
    /// is none.
    pub fn left_to(&mut self, model: &Model, node: NodeIndex) -> Option<RigidMotion> {
        let root = self.bodies.root(node);
        let motions = self.motions(root);
        let members = self.members(model, root);
        motions.iter().find_map(|motion| self.of_body(model, (root, &members), motion))
    }

    /// The motions that are left to the body of a root, contact aside.
    fn motions(&self, root: NodeIndex) -> Vec<Motion> {
        self.ties.motions(&self.ties.group(root), &self.rows, self.unknowns())
    }

    /// The nodes of the body of a root.
    fn members(&mut self, model: &Model, root: NodeIndex) -> Vec<NodeIndex> {
        (0..model.nodes.len()).filter(|&other| self.bodies.root(other) == root).collect()
    }

    /// The node of a body that a motion moves most, with its way per part of the motion; `None` where none moves.
    fn farthest(
        &self,
        model: &Model,
        (root, members): (NodeIndex, &[NodeIndex]),
        motion: &Motion,
    ) -> Option<(NodeIndex, [f64; 3])> {
        let size = if self.size > 0.0 { self.size } else { 1.0 };
        let origin = model.nodes.position(root);
        let moved = |node: NodeIndex| -> [f64; 3] {
            let at = model.nodes.position(node);
            let arm = std::array::from_fn(|axis| (at[axis] - origin[axis]) / size);
            [Dof::U1, Dof::U2, Dof::U3]
                .map(|dof| rigid_motion(dof, arm).iter().zip(motion).map(|(a, b)| a * b).sum())
        };
        let far = |node: &NodeIndex| length(moved(*node));
        let node = members.iter().copied().max_by(|a, b| far(a).total_cmp(&far(b)))?;
        (far(&node) > DEPENDENT).then(|| (node, moved(node)))
    }

    /// A motion as that of the node of the body that moves most.
    fn of_body(
        &self,
        model: &Model,
        body: (NodeIndex, &[NodeIndex]),
        motion: &Motion,
    ) -> Option<RigidMotion> {
        let size = if self.size > 0.0 { self.size } else { 1.0 };
        let (node, moved) = self.farthest(model, body, motion)?;
        let most = length(moved);
        let way = moved.map(|x| x / most);
        let turn = std::array::from_fn(|axis| motion[3 + axis] / (size * most));
        Some(RigidMotion { node, way, turn })
    }

    /// The roots of all bodies.
    fn roots(&mut self) -> Vec<NodeIndex> {
        let mut roots: Vec<NodeIndex> = self.bodies.used.clone();
        roots.iter_mut().for_each(|node| *node = self.bodies.root(*node));
        roots.sort_unstable();
        roots.dedup();
        roots
    }

    /// A rigid motion that is left to some body; `None`: all are held.
    pub fn left(&mut self, model: &Model) -> Option<RigidMotion> {
        self.roots().into_iter().find_map(|root| self.left_to(model, root))
    }

    /// Whether a spring or a gap between two nodes holds on to one of the body of a root. What holds on to ground is a
    /// support.
    fn is_sprung(&mut self, model: &Model, step: &Step, root: NodeIndex) -> bool {
        let loose = step.presence.elements(&model.blocks).filter(|(block, _)| !block.kind.joins());
        let mut between = loose.map(|(_, own)| own.nodes).filter(|nodes| nodes.len() > 1).flatten();
        between.any(|&node| self.bodies.root(node) == root)
    }

    /// Whether some body keeps a rigid motion.
    pub fn has_loose_body(&mut self) -> bool {
        self.roots().into_iter().any(|root| !self.holds(root))
    }
}

fn length(way: [f64; 3]) -> f64 {
    way.iter().fold(0.0_f64, |sum, x| sum.hypot(*x))
}
