//! Nodes that move as one.

use super::rigid_motions::{Motion, rank, seen};
use slideline_model::{Dof, Model, NodeIndex, Presence, RigidLink, Step};
use std::collections::{BTreeMap, HashMap, HashSet};

/// A dof with a factor.
pub type Term = (NodeIndex, Dof, f64);

/// Nodes that move as one because elements or rigid links join them.
pub struct Bodies {
    parent: Vec<NodeIndex>,
    /// Nodes that something uses.
    pub used: Vec<NodeIndex>,
    /// Roots of bodies that can turn: all but lone contact nodes.
    pub turns: HashSet<NodeIndex>,
    /// Dofs of nodes of one body that follow the motion of another one, in part.
    pub tied: Vec<Tied>,
}

/// A dof of a node that follows the motion of the body of another one.
#[derive(Clone, Copy)]
pub struct Tied {
    /// The dof that follows.
    pub own: (NodeIndex, Dof),
    /// The node that leads.
    pub master: NodeIndex,
}

impl Bodies {
    /// The bodies of what is there.
    pub fn of(model: &Model, presence: &Presence) -> Self {
        let parent = (0..model.nodes.len()).collect();
        let mut new =
            Self { parent, used: Vec::new(), turns: Default::default(), tied: Vec::new() };
        let joining = || presence.elements(&model.blocks).filter(|(block, _)| block.kind.joins());
        let corners = joining().map(|(_, element)| element.nodes.len()).sum::<usize>();
        let further = model.rigid_links.len() + model.contact_pairs.len();
        let mut turning = Vec::with_capacity(corners + further);
        let mut ends = Ends::of(model);
        for (block, element) in joining() {
            ends.note(block.dofs(), element.nodes);
            element.nodes.windows(2).for_each(|w| new.join(w[0], w[1]));
            turning.extend(element.nodes);
        }
        for link in &model.rigid_links {
            match ends.tied(model, link) {
                Some(tied) => new.tied.extend(tied),
                None => new.join(link.master, link.dependent),
            }
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
    pub fn tethers(&mut self, model: &Model, step: &Step) -> Vec<Vec<Term>> {
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
        self.gather();
        tethers
    }

    /// Takes bodies as one that all that ties them leaves no motion to one another.
    pub fn weld(&mut self, model: &Model, size: f64) {
        let needed = if model.is_in_space() { 6 } else { 3 };
        loop {
            let mut rows: BTreeMap<[NodeIndex; 2], Vec<Motion>> = BTreeMap::new();
            for Tied { own, master } in self.tied.clone() {
                let bodies = [master, own.0].map(|node| self.root(node));
                let origin = model.nodes.position(bodies[0]);
                rows.entry(bodies).or_default().push(seen(model, own, (origin, size)));
            }
            let welded = rows.iter().filter(|(_, rows)| rank(rows) >= needed);
            let welded: Vec<_> = welded.map(|(bodies, _)| *bodies).collect();
            welded.iter().for_each(|&[one, other]| self.join(one, other));
            self.gather();
            if welded.is_empty() {
                return;
            }
        }
    }

    /// Keeps what is said of bodies by their roots, and ties between two of them.
    fn gather(&mut self) {
        let turning = std::mem::take(&mut self.turns);
        self.turns = turning.into_iter().map(|node| self.root(node)).collect();
        let mut tied = std::mem::take(&mut self.tied);
        tied.retain(|own| self.root(own.own.0) != self.root(own.master));
        self.tied = tied;
    }

    /// The node that stands for the body of a node.
    pub fn root(&mut self, mut node: NodeIndex) -> NodeIndex {
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

/// What elements make of the nodes that follow others.
struct Ends {
    /// Whether elements turn with them; none without elements.
    turn: HashMap<NodeIndex, Option<bool>>,
}

impl Ends {
    fn of(model: &Model) -> Self {
        let ends = model.rigid_links.iter().map(|link| (link.dependent, None));
        Self { turn: ends.collect() }
    }

    fn note(&mut self, dofs: &[Dof], nodes: &[NodeIndex]) {
        if self.turn.is_empty() {
            return;
        }
        let turns = dofs.iter().any(|dof| dof.is_rotation());
        for node in nodes {
            if let Some(known) = self.turn.get_mut(node) {
                *known = Some(known.unwrap_or(false) || turns);
            }
        }
    }

    /// The dofs of a node of elements that follow, where these leave something; `None`: all does.
    fn tied(&self, model: &Model, link: &RigidLink) -> Option<Vec<Tied>> {
        let turns = self.turn.get(&link.dependent).copied().flatten()?;
        let felt = |dof: &Dof| link.follows[*dof as usize] && (turns || !dof.is_rotation());
        let dofs: Vec<Dof> = model.directions().iter().copied().filter(felt).collect();
        let tied = |dof| Tied { own: (link.dependent, dof), master: link.master };
        (dofs.len() < model.directions().len()).then(|| dofs.into_iter().map(tied).collect())
    }
}
