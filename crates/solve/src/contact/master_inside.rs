//! Nodes of a master that stand in the part of the slave, behind faces none of whose nodes is held.
//!
//! ```text
//!     o-------------------o  slave     contact is at the nodes of the slave: those of a wide face meet
//!     |     +-----+       |            nothing beside a narrow master, which goes through between them
//!     o-----|-----|-------o
//!           |     |  master
//! ```

use super::edges::{EdgeInside, EdgePlace, Found, in_order, note_nearest};
use super::master::MasterSurface;
use super::pairs::Contact;
use super::solids_of_side::{Behind, SolidsOfSide};
use crate::dofs::Translations;
use crate::problem::Problem;
use crate::state::State;
use slideline_mech::vector::{scale, size};
use slideline_model::NodeIndex;

/// Part of the size of a face by which a node may stand behind it unsaid [1], as of edges. (choice)
const DEEP: f64 = 0.1;

impl Contact {
    /// The deepest node of a master in the part of its slave, behind a face that no slave node holds.
    pub fn master_inside(&self, plan: &Problem<'_>, committed: &State) -> Option<EdgeInside> {
        let mut own =
            (0..self.own_pairs()).filter(|&pair| self.may_go_through(plan, pair)).peekable();
        own.peek()?;
        let held = self.held_nodes(&committed.points);
        own.find_map(|pair| self.node_inside(pair, &held, (plan, committed)))
    }

    /// Whether a pair is one of solids at the nodes of the slave, and its master a mesh.
    fn may_go_through(&self, plan: &Problem<'_>, pair: usize) -> bool {
        let of = &plan.model.contact_pairs[pair];
        let is_of_solids = of.of_solids || !of.faces.is_empty();
        is_of_solids && self.is_at_nodes(pair) && is_mesh(&self.masters[pair])
    }

    /// Whether the slave of a pair is met at its nodes.
    fn is_at_nodes(&self, pair: usize) -> bool {
        let mut own = self.points.iter().filter(|point| point.pair == pair);
        own.next().is_some_and(|point| point.is_node() && point.mortar.is_none())
    }

    fn node_inside(
        &self,
        pair: usize,
        held: &[NodeIndex],
        (plan, committed): (&Problem<'_>, &State),
    ) -> Option<EdgeInside> {
        let (own, u) = (&plan.model.contact_pairs[pair], &committed.displacement);
        let is_held = |node: &NodeIndex| held.binary_search(node).is_ok();
        let of_master = own.master.deforming_nodes();
        let mut places = self.places_of_master(pair, u);
        places.retain(|place| of_master.get(place.node).is_some_and(|node| !is_held(node)));
        if places.is_empty() {
            return None;
        }
        let axis = in_order(&mut places);
        let points = || self.points.iter().filter(|point| point.pair == pair);
        let mut faces: Vec<usize> = points().flat_map(|point| &point.faces).copied().collect();
        faces.sort_unstable();
        faces.dedup();
        for &face in &faces {
            note_nearest((face, &self.slave_faces[face]), u, (&mut places, axis));
        }
        let corners = |face: usize| self.slave_faces[face].corners.iter().map(|(node, ..)| *node);
        let mut found: Vec<(Behind, usize, usize)> = places
            .iter()
            .filter_map(|place| {
                let near = place.nearest.filter(|near| near.straight > DEEP)?;
                let (normal, _) = self.slave_faces[near.face].stands(u);
                let normal = scale(normal, 1.0 / size(normal));
                let behind = Behind { node: of_master[place.node], depth: near.distance, normal };
                let unheld = !corners(near.face).any(|node| is_held(&node));
                unheld.then_some((behind, near.face, place.node))
            })
            .collect();
        if found.is_empty() {
            return None;
        }
        found.sort_by(|a, b| a.0.deeper_first(&b.0));
        let of_slave: Vec<NodeIndex> = points().map(|point| point.node).collect();
        let part = SolidsOfSide::new(plan, committed, &of_slave)?;
        let is_inside = |behind: &Behind| part.holds(behind).is_some() && part.surrounds(behind);
        found.into_iter().find(|(behind, ..)| is_inside(behind)).map(|(behind, face, node)| {
            EdgeInside {
                pair,
                what: Found::Node(node),
                face: corners(face).collect(),
                depth: behind.depth,
            }
        })
    }

    /// Where the nodes of a meshed master stand.
    fn places_of_master(&self, pair: usize, u: &[f64]) -> Vec<EdgePlace> {
        let nodes = match &self.masters[pair] {
            MasterSurface::Line { nodes, beyond, .. } => &nodes[beyond.own(nodes.len())],
            MasterSurface::Faces { nodes, .. } => &nodes[..],
            _ => &[],
        };
        let place = |(node, (from, dofs)): (usize, &([f64; 3], Translations))| EdgePlace {
            at: dofs.displace(*from, u),
            node,
            nearest: None,
        };
        nodes.iter().enumerate().map(place).collect()
    }
}

/// Whether a master is a mesh that does not meet itself.
fn is_mesh(master: &MasterSurface) -> bool {
    match master {
        MasterSurface::Line { itself, .. } => itself.is_none(),
        MasterSurface::Faces { mesh, itself, .. } => itself.is_none() && mesh.swept().is_none(),
        _ => false,
    }
}
