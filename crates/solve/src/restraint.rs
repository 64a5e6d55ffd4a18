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

use slideline_linalg::reduce_rows;
use slideline_model::{Dof, Model, NodeIndex, Presence, SpringWay, Step};
use std::collections::{HashMap, HashSet};

/// The bodies of a model and how a step restrains them.
pub struct Restraint {
    bodies: Bodies,
    /// By the root of a body.
    rows: HashMap<NodeIndex, Vec<Motion>>,
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

/// Coefficients of a rigid motion: along the three axes, and about them.
type Motion = [f64; 6];

/// A dof with a factor.
type Term = (NodeIndex, Dof, f64);

impl Restraint {
    /// That of a step. Rotations count with the size of the model, so that the
    /// units of length decide nothing.
    pub fn of(model: &Model, step: &Step) -> Self {
        let presence = &step.presence;
        let mut bodies = Bodies::of(model, presence);
        let tethers = bodies.tethers(model, step);
        let size = (0..model.nodes.len())
            .flat_map(|node| model.nodes.position(node))
            .fold(0.0_f64, |size, x| size.max(x.abs()));
        let held = step.prescribed.iter().map(|prescribed| (prescribed.node, prescribed.dof));
        let springs = presence.elements(&model.blocks).filter_map(|(block, spring)| {
            let section = block.springs()?.section;
            let SpringWay::Dof(dof) = section.way else { return None };
            let to_ground = section.law.stiffest() != 0.0 && spring.nodes.len() == 1;
            to_ground.then_some((spring.nodes[0], dof))
        });
        let held = held.chain(springs).chain(presence.rings(&model.blocks));
        let held: Vec<Term> = held.map(|(node, dof)| (node, dof, 1.0)).collect();
        let mut rows: HashMap<NodeIndex, Vec<Motion>> = HashMap::new();
        for terms in held.chunks(1).chain(tethers.iter().map(Vec::as_slice)) {
            let root = bodies.root(terms[0].0);
            let mut row = [0.0; 6];
            for &(node, dof, factor) in terms {
                let (at, origin) = (model.nodes.position(node), model.nodes.position(root));
                let arm: [f64; 3] = std::array::from_fn(|axis| match size > 0.0 {
                    true => (at[axis] - origin[axis]) / size,
                    false => 0.0,
                });
                let own = named_motion(model, node, dof, arm);
                row.iter_mut().zip(own).for_each(|(sum, part)| *sum += factor * part);
            }
            // one within a body may hinder none of its motions, but for rounding
            if row.iter().any(|part| part.abs() > DEPENDENT) {
                rows.entry(root).or_default().push(row);
            }
        }
        let in_space = model.is_in_space();
        Self { bodies, rows, in_space, size }
    }

    /// Whether no rigid motion is left to the body of a node, contact aside.
    pub fn holds(&mut self, node: NodeIndex) -> bool {
        let root = self.bodies.root(node);
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
        let unknowns: &[usize] = if self.in_space { &[0, 1, 2, 3, 4, 5] } else { &[0, 1, 5] };
        let rows = self.rows.get(&root).map_or(&[][..], Vec::as_slice);
        let motions = null_motions(rows, unknowns);
        let size = if self.size > 0.0 { self.size } else { 1.0 };
        let origin = model.nodes.position(root);
        let members: Vec<NodeIndex> =
            (0..model.nodes.len()).filter(|&other| self.bodies.root(other) == root).collect();
        let moved = |motion: &Motion, node: NodeIndex| -> [f64; 3] {
            let at = model.nodes.position(node);
            let arm = std::array::from_fn(|axis| (at[axis] - origin[axis]) / size);
            [Dof::U1, Dof::U2, Dof::U3]
                .map(|dof| rigid_motion(dof, arm).iter().zip(motion).map(|(a, b)| a * b).sum())
        };
        let length = |way: [f64; 3]| way.iter().fold(0.0_f64, |sum, x| sum.hypot(*x));
        motions.into_iter().find_map(|motion| {
            let far = |node: &NodeIndex| length(moved(&motion, *node));
            let node = members.iter().copied().max_by(|a, b| far(a).total_cmp(&far(b)))?;
            let most = far(&node);
            let way = moved(&motion, node).map(|x| x / most);
            let turn = std::array::from_fn(|axis| motion[3 + axis] / (size * most));
            (most > DEPENDENT).then_some(RigidMotion { node, way, turn })
        })
    }

    /// A rigid motion that is left to some body; `None`: all are held.
    pub fn left(&mut self, model: &Model) -> Option<RigidMotion> {
        let mut roots: Vec<NodeIndex> = self.bodies.used.clone();
        roots.iter_mut().for_each(|node| *node = self.bodies.root(*node));
        roots.sort_unstable();
        roots.dedup();
        roots.into_iter().find_map(|root| self.left_to(model, root))
    }

    /// Whether some body keeps a rigid motion.
    pub fn has_loose_body(&mut self) -> bool {
        let mut roots: Vec<NodeIndex> = self.bodies.used.clone();
        roots.iter_mut().for_each(|node| *node = self.bodies.root(*node));
        roots.sort_unstable();
        roots.dedup();
        roots.into_iter().any(|root| !self.holds(root))
    }
}

/// Nodes that move as one because beams or rigid links join them.
struct Bodies {
    parent: Vec<NodeIndex>,
    /// Nodes that something uses.
    used: Vec<NodeIndex>,
    /// Roots of bodies that can turn: all but lone contact nodes.
    turns: HashSet<NodeIndex>,
}

impl Bodies {
    fn of(model: &Model, presence: &Presence) -> Self {
        let parent = (0..model.nodes.len()).collect();
        let mut new = Self { parent, used: Vec::new(), turns: Default::default() };
        let joining = || presence.elements(&model.blocks).filter(|(block, _)| block.kind.joins());
        let corners = joining().map(|(_, element)| element.nodes.len()).sum::<usize>();
        let further = model.rigid_links.len() + model.contact_pairs.len();
        let mut turning = Vec::with_capacity(corners + further);
        for (_, element) in joining() {
            element.nodes.windows(2).for_each(|w| new.join(w[0], w[1]));
            turning.extend(element.nodes);
        }
        for link in &model.rigid_links {
            new.join(link.master, link.dependent);
            turning.push(link.master);
        }
        let pairs = model.contact_pairs.iter().enumerate();
        for (_, pair) in pairs.filter(|&(place, _)| presence.has_pair(place)) {
            new.used.extend(pair.slave_nodes());
            new.used.extend(pair.master.deforming_nodes());
            turning.extend(pair.rigid_surfaces().map(|surface| surface.reference));
        }
        for &node in &turning {
            let root = new.root(node);
            new.turns.insert(root);
        }
        new.used.extend(turning);
        new
    }

    /// What equations hold of single bodies, the rest of whose terms is prescribed in the step. Several bodies that an
    /// equation or a tie joins are taken as one from then on: it may hold.
    fn tethers(&mut self, model: &Model, step: &Step) -> Vec<Vec<Term>> {
        let prescribed: HashSet<(NodeIndex, Dof)> =
            step.prescribed.iter().map(|own| (own.node, own.dof)).collect();
        let (mut tethers, mut joints) = (Vec::new(), Vec::new());
        for constraint in &model.linear_constraints {
            let (node, dof) = constraint.dependent;
            let others = constraint.terms.iter().map(|&(node, dof, factor)| (node, dof, -factor));
            let mut free: Vec<_> = std::iter::once((node, dof, 1.0)).chain(others).collect();
            free.retain(|&(node, dof, factor)| factor != 0.0 && !prescribed.contains(&(node, dof)));
            let Some(&(first, ..)) = free.first() else { continue };
            let body = self.root(first);
            let largest = free.iter().fold(0.0_f64, |most, own| most.max(own.2.abs()));
            free.iter_mut().for_each(|own| own.2 /= largest);
            match free.iter().all(|&(node, ..)| self.root(node) == body) {
                true => tethers.push(free),
                false => joints.push(free),
            }
        }
        for joint in joints {
            joint.windows(2).for_each(|two| self.join(two[0].0, two[1].0));
        }
        let turning = std::mem::take(&mut self.turns);
        self.turns = turning.into_iter().map(|node| self.root(node)).collect();
        tethers
    }

    fn root(&mut self, mut node: NodeIndex) -> NodeIndex {
        while self.parent[node] != node {
            self.parent[node] = self.parent[self.parent[node]];
            node = self.parent[node];
        }
        node
    }

    fn join(&mut self, a: NodeIndex, b: NodeIndex) {
        let (a, b) = (self.root(a), self.root(b));
        self.parent[b] = a;
    }
}

/// Part of the largest entry below which a row depends on the others [1].
const DEPENDENT: f64 = 1e-9;

/// What a dof of a rigid body sees of its motion, `arm` away from its root.
fn rigid_motion(dof: Dof, arm: [f64; 3]) -> Motion {
    let mut row = [0.0; 6];
    row[dof as usize] = 1.0;
    if !dof.is_rotation() {
        // u = t + omega x r
        let axis = dof as usize;
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        (row[3 + next], row[3 + last]) = (arm[last], -arm[next]);
    }
    row
}

/// The same of a dof as the deck names it: along the own axes of its node where it has some.
fn named_motion(model: &Model, node: NodeIndex, dof: Dof, arm: [f64; 3]) -> Motion {
    let Some(axes) = model.axes_of(node) else { return rigid_motion(dof, arm) };
    let first = dof as usize - dof as usize % 3;
    let mut row = [0.0; 6];
    for (k, cosine) in axes[dof as usize % 3].into_iter().enumerate() {
        let plain = rigid_motion(Dof::ALL[first + k], arm);
        row.iter_mut().zip(plain).for_each(|(sum, part)| *sum += cosine * part);
    }
    row
}

/// Motions along some of the unknowns that a few rows do not hinder: a base of all of them.
fn null_motions(rows: &[Motion], unknowns: &[usize]) -> Vec<Motion> {
    let mut rows = rows.as_flattened().to_vec();
    let scale = rows.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
    let mut pivots = Vec::with_capacity(6);
    reduce_rows(&mut rows, 6, DEPENDENT * scale, &mut pivots);
    let free = unknowns.iter().filter(|column| !pivots.contains(column));
    let motion = |&column: &usize| {
        let mut motion = [0.0; 6];
        motion[column] = 1.0;
        for (&pivot, row) in pivots.iter().zip(rows.as_chunks::<6>().0) {
            motion[pivot] = -row[column] / row[pivot];
        }
        motion
    };
    free.map(motion).collect()
}

/// Rank of a few rows.
fn rank(rows: &[Motion]) -> usize {
    let mut rows = rows.as_flattened().to_vec();
    let scale = rows.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
    let mut pivots = Vec::with_capacity(6);
    reduce_rows(&mut rows, 6, DEPENDENT * scale, &mut pivots);
    pivots.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: rows of a clamp are of rank three, those of supports along one line of rank two,
    /// whatever the arm.
    #[test]
    fn ranks_of_supports() {
        let at = |dof, x, y, z| rigid_motion(dof, [x, y, z]);
        let (x, y) = (at(Dof::U1, 0.7, 0.3, 0.0), at(Dof::U2, 0.7, 0.3, 0.0));
        assert_eq!(rank(&[x, y, at(Dof::UR3, 0.7, 0.3, 0.0)]), 3);
        assert_eq!(rank(&[y, at(Dof::U2, 0.2, 0.0, 0.0)]), 2);
        assert_eq!(rank(&[x, at(Dof::U1, 0.1, 0.3, 0.0), y]), 2);
        assert_eq!(rank(&[]), 0);
        // three supports across a plane, two along it, one across that: 3-2-1
        let across = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(|[x, y]| at(Dof::U3, x, y, 0.5));
        let along =
            [at(Dof::U2, 0.0, 0.0, 0.0), at(Dof::U2, 1.0, 0.0, 0.0), at(Dof::U1, 0.0, 0.0, 0.0)];
        assert_eq!(rank(&[&across[..], &along].concat()), 6);
        assert_eq!(rank(&[&across[..], &along[..2]].concat()), 5);
    }

    /// Requirement: two hinges leave the turn about the line through them, which moves what is beside
    /// that line; clamps leave nothing.
    #[test]
    fn hinges_leave_a_turn() {
        let all = [0, 1, 2, 3, 4, 5];
        let hinge = |x| [Dof::U1, Dof::U2, Dof::U3].map(|dof| rigid_motion(dof, [x, 0.5, 0.25]));
        let left = null_motions(&[hinge(0.0), hinge(1.0)].concat(), &all);
        assert_eq!(left.len(), 1);
        let turn = left[0];
        // the line goes along x: it turns about x, and a point of the line stays
        assert!(turn[4].abs() < 1e-12 && turn[5].abs() < 1e-12 && turn[3].abs() > 0.1);
        let still = hinge(0.3).map(|row| row.iter().zip(turn).map(|(a, b)| a * b).sum::<f64>());
        assert!(still.iter().all(|u| u.abs() < 1e-12));
        let clamp = [Dof::UR1, Dof::UR2, Dof::UR3].map(|dof| rigid_motion(dof, [0.0; 3]));
        assert!(null_motions(&[hinge(0.0), clamp].concat(), &all).is_empty());
    }

    /// Requirement: the row of a dof is its displacement under a rigid motion: about the third axis
    /// u = -w y, v = w x.
    #[test]
    fn rows_are_rigid_motions() {
        let arm = [2.0, 3.0, 5.0];
        assert_eq!(rigid_motion(Dof::U1, arm), [1.0, 0.0, 0.0, 0.0, 5.0, -3.0]);
        assert_eq!(rigid_motion(Dof::U2, arm), [0.0, 1.0, 0.0, -5.0, 0.0, 2.0]);
        assert_eq!(rigid_motion(Dof::U3, arm), [0.0, 0.0, 1.0, 3.0, -2.0, 0.0]);
        assert_eq!(rigid_motion(Dof::UR2, arm), [0.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
    }
}
