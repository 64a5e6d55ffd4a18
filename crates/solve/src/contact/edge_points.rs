//! Nodes of sharp edges that meet the other side by themselves, where contact over faces, or at the nodes
//! of the slave, does not see them.
//!
//! ```text
//!      mean |~~~~~~~~~~~~|                  c = mean gap - gap of the edge
//!     ------o-----+------o  slave
//!               .-X-.       gap of the edge    c = 0    flat on flat: the mean holds all, the edge nothing
//!        master/     \                        c large  the edge is held as a node
//! ```
//!
//! docs/theory.md section 5.17

use super::master::MasterSurface;
use super::pairs::{Carrier, Contact, SlavePoint};
use super::slave_face::SlaveFace;
use super::stencil::NO_TURN;
use crate::dofs::DofMap;
use crate::state::{PointState, State};
use slideline_mech::vector::{size, sub};
use slideline_model::{EdgePair, Model, NodeIndex};
use std::collections::{HashMap, HashSet};
use std::ops::Range;

/// Part of the size of a face by which an edge may stand in it beyond the mean and not be held [1]: less is
/// what faces that bend about an edge, and meshes that do not match, come to.
const FREE: f64 = 0.02;

/// The points of an edge pair.
#[derive(Clone, Debug)]
pub(super) struct EdgePoints {
    /// The pair whose edges they are.
    pub of: usize,
    /// Whether they are of its master.
    pub of_master: bool,
    /// The first of them.
    first: usize,
    /// How many they are.
    count: usize,
    /// Of the slave: the slave node of each. Of the master: the slave node at each node of what they meet.
    seats: Vec<usize>,
    /// Slave nodes of the pair.
    slaves: Vec<SlaveNode>,
}

/// A slave node of a pair with edges.
#[derive(Clone, Debug, Default)]
struct SlaveNode {
    /// Its contact points: where the surface turns sharply, more than one.
    points: Vec<usize>,
    /// Mean size of the faces about it [L].
    size: f64,
}

/// Slave nodes of a pair about an edge, with their shares [1].
type About = [(usize, f64); 4];

impl Contact {
    /// Adds the points of the edges of a pair that has been added.
    pub(super) fn add_edges(&mut self, model: &Model, dofs: &DofMap, edges: &EdgePair) {
        let pair = &model.contact_pairs[edges.of];
        let (place, first) = (self.masters.len(), self.points.len());
        for &node in &edges.nodes {
            let (position, dofs) = ([0.0; 3], dofs.translations(node));
            let carrier = Carrier::Node { position, dofs, section: NO_TURN };
            self.add_point(place, pair, node, carrier);
        }
        let mut of_node = HashMap::new();
        let mut slaves: Vec<SlaveNode> = Vec::new();
        for (own, point) in self.points.iter().enumerate().filter(|(_, p)| p.pair == edges.of) {
            let seat = *of_node.entry(point.node).or_insert(slaves.len());
            if seat == slaves.len() {
                slaves.push(SlaveNode::default());
            }
            slaves[seat].points.push(own);
        }
        let met;
        let nodes = match edges.is_of_master {
            false => &edges.nodes,
            true => {
                met = edges.met.deforming_nodes();
                &met
            }
        };
        let seats = nodes.iter().map(|node| of_node.get(node).copied().unwrap_or(slaves.len()));
        let seats = seats.collect();
        let (of, of_master) = (edges.of, edges.is_of_master);
        let count = edges.nodes.len();
        self.edge_points.push(EdgePoints { of, of_master, first, count, seats, slaves });
        self.slave_nodes.push(edges.nodes.clone());
        self.edges.push(Vec::new());
        self.spread_nodes.push(Vec::new());
        self.laws.push(self.laws[of].clone());
        self.keeps.push(false);
        self.offsets.push(pair.offset);
        self.spacing.push(self.spacing[of]);
        let master = self.master(model, dofs, &edges.met, self.spacing[of]);
        self.chain_nodes += master.nodes().len();
        self.masters.push(master);
        self.add_faces_of_edges(model, dofs, edges);
    }

    /// Notes the faces about the nodes of edges.
    fn add_faces_of_edges(&mut self, model: &Model, dofs: &DofMap, edges: &EdgePair) {
        let corner = |&node: &NodeIndex| (node, [0.0; 3], dofs.translations(node));
        let own: HashSet<_> = edges.nodes.iter().collect();
        for face in edges.own_faces(model) {
            if !face.iter().any(|node| own.contains(node)) {
                continue;
            }
            let number = self.slave_faces.len();
            self.slave_faces.push(SlaveFace { corners: face.iter().map(corner).collect() });
            let place = self.masters.len() - 1;
            let about = |point: &&mut SlavePoint| point.pair == place && face.contains(&point.node);
            self.points.iter_mut().rev().filter(about).for_each(|point| point.faces.push(number));
        }
    }

    /// Takes the areas of edge points, which are those of the slave nodes that they are, or stand between,
    /// and the sizes of the faces about slave nodes.
    pub(super) fn take_edges(&mut self, model: &Model) {
        let Self { points, edge_points, .. } = self;
        for own in edge_points {
            own.take_sizes(model, |point| points[point].node);
            let area =
                |slave: &SlaveNode| slave.points.iter().map(|&p| points[p].area).sum::<f64>();
            let areas: Vec<f64> = own.slaves.iter().map(area).collect();
            let mean = areas.iter().sum::<f64>() / areas.len().max(1) as f64;
            for place in own.range() {
                let seat = if own.of_master { usize::MAX } else { own.seats[place - own.first] };
                points[place].area = areas.get(seat).copied().unwrap_or(mean);
            }
        }
    }

    /// Laws, spacings and axes of edge points: those of their pairs.
    pub(super) fn follow_pairs(&mut self, model: &Model) {
        let pairs = self.own_pairs();
        for (place, edges) in model.edge_pairs.iter().enumerate() {
            let (own, of) = (pairs + place, edges.of);
            self.laws[own] = self.laws[of].clone();
            self.spacing[own] = self.spacing[of];
            self.offsets[own] = self.offsets[of];
            self.take_axes(model, own);
        }
    }

    /// Pairs of the model: those of edges come behind them.
    pub fn own_pairs(&self) -> usize {
        self.masters.len() - self.edge_points.len()
    }

    /// The pair of the model that a pair is, or whose edges it has.
    pub fn parent(&self, pair: usize) -> usize {
        let edges = pair.checked_sub(self.own_pairs());
        edges.map_or(pair, |own| self.edge_points[own].of)
    }

    /// The pairs of the edges of a pair of the model.
    pub(super) fn edges_of(&self, pair: usize) -> Vec<usize> {
        let own = self.edge_points.iter().enumerate().filter(|(_, own)| own.of == pair);
        own.map(|(place, _)| self.own_pairs() + place).collect()
    }

    /// Whether a pair of edges meets the slave: its nodes are those of the master.
    pub fn is_reversed(&self, pair: usize) -> bool {
        let edges = pair.checked_sub(self.own_pairs());
        edges.is_some_and(|own| self.edge_points[own].of_master)
    }

    /// Whether a point is of a sharp edge.
    pub fn is_edge(&self, place: usize) -> bool {
        self.points[place].pair >= self.own_pairs()
    }

    /// Whether no edge is held in a state of the points.
    pub fn edges_are_open(&self, points: &[PointState]) -> bool {
        self.places_of_edges().all(|place| !points[place].closed)
    }

    /// The points of sharp edges.
    pub fn places_of_edges(&self) -> Range<usize> {
        let first = self.edge_points.first().map_or(self.points.len(), |own| own.first);
        first..self.points.len()
    }

    /// How deep an edge may stand in a face in the next increment: as deep as the mean is, and further the
    /// flatter it lay upon the face at the last commit [L]. docs/theory.md eq. (5.49)
    pub(super) fn edge_allowance(&self, place: usize, before: &[PointState]) -> f64 {
        let edges = self.points[place].pair.checked_sub(self.own_pairs());
        let (Some(edges), Some(now)) = (edges, before.get(place)) else { return 0.0 };
        let own = &self.edge_points[edges];
        if !now.opening.is_finite() || now.along.is_none() {
            return 0.0;
        }
        let raw = |&point: &usize| before[point].opening - before[point].allowed;
        let mut sums = [0.0; 3];
        for (seat, share) in self.about(place, now).into_iter().filter(|(_, share)| *share > 0.0) {
            let Some(slave) = own.slaves.get(seat) else { continue };
            let gap = slave.points.iter().map(raw).fold(f64::INFINITY, f64::min);
            // a slave node that faces nothing knows of no gap
            if gap.is_finite() {
                let [shares, gaps, sizes] = sums;
                sums = [shares + share, gaps + share * gap, sizes + share * slave.size];
            }
        }
        let [shares, gaps, sizes] = sums;
        let (mean, size) = (gaps / shares, sizes / shares);
        if shares == 0.0 || size == 0.0 {
            return 0.0;
        }
        let beyond = mean - (now.opening - now.allowed);
        let free = FREE * size;
        (-mean).max(0.0) + free * (1.0 - smooth_step(beyond / free))
    }

    /// Whether an edge point that was not held is deeper in a face than a face is long: it has come to it
    /// from behind, as round an open end.
    pub(super) fn came_from_behind(
        &self,
        place: usize,
        deep: f64,
        before: Option<&PointState>,
    ) -> bool {
        let was_held = before.is_some_and(|before| before.closed);
        self.is_edge(place) && !was_held && deep > self.spacing[self.points[place].pair]
    }

    /// The slave nodes about an edge point of a state, with their shares.
    fn about(&self, place: usize, now: &PointState) -> About {
        let mut about = [(usize::MAX, 0.0); 4];
        let pair = self.points[place].pair;
        let Some(own) = pair.checked_sub(self.own_pairs()).map(|own| &self.edge_points[own]) else {
            return about;
        };
        if !own.of_master {
            about[0] = (own.seats[place - own.first], 1.0);
            return about;
        }
        match (&self.masters[pair], now.along, now.footing) {
            (MasterSurface::Line { chain, .. }, Some(along), _) => {
                let (part, t) = chain.part_at(along[0]);
                about[0] = (own.seats[part], 1.0 - t);
                about[1] = (own.seats[part + 1], t);
            }
            (MasterSurface::Faces { mesh, .. }, _, Some(footing)) => {
                let face = &mesh.faces()[footing.place.face];
                let corners = face.cell.faces.len();
                let shares = footing.place.corner_shares(corners);
                for (into, (node, share)) in
                    about.iter_mut().zip(face.nodes.iter().zip(shares)).take(corners)
                {
                    *into = (own.seats[*node], share);
                }
            }
            _ => {}
        }
        about
    }

    /// Calls back with the points of slave nodes that stand about a closed edge point, and the part of its
    /// force that each of them takes [1].
    pub fn spread_edge(&self, place: usize, now: &PointState, mut call: impl FnMut(usize, f64)) {
        let Some(own) = self.points[place].pair.checked_sub(self.own_pairs()) else { return };
        for (seat, share) in self.about(place, now).into_iter().filter(|(_, share)| *share != 0.0) {
            let slave = self.edge_points[own].slaves.get(seat);
            if let Some(&point) = slave.and_then(|slave| slave.points.first()) {
                call(point, share);
            }
        }
    }

    /// Work of edges as more or less of their depth is allowed, by the trapezoidal rule [F L].
    pub(super) fn work_at_edges(&self, committed: &State, trial: &State) -> f64 {
        let own = self.places_of_edges();
        let (Some(then), Some(now)) = (committed.points.get(own.clone()), trial.points.get(own))
        else {
            return 0.0;
        };
        let work = |(then, now): (&PointState, &PointState)| {
            let mean = 0.5 * (then.area * then.pressure + now.area * now.pressure);
            if mean == 0.0 { 0.0 } else { mean * (then.allowed - now.allowed) }
        };
        then.iter().zip(now).map(work).sum()
    }
}

impl EdgePoints {
    fn range(&self) -> Range<usize> {
        self.first..self.first + self.count
    }

    /// Mean undeformed sizes of the faces about the slave nodes.
    fn take_sizes(&mut self, model: &Model, node: impl Fn(usize) -> NodeIndex) {
        let pair = &model.contact_pairs[self.of];
        let at = |node: NodeIndex| model.nodes.position(node);
        let mut sums: HashMap<NodeIndex, (f64, f64)> = HashMap::new();
        let mut add = |[a, b]: [NodeIndex; 2]| {
            let length = size(sub(at(a), at(b)));
            for node in [a, b] {
                let sum = sums.entry(node).or_default();
                *sum = (sum.0 + length, sum.1 + 1.0);
            }
        };
        pair.elements.iter().for_each(|element| add(element.nodes));
        for face in &pair.faces {
            let corners = face.cell().map_or(0, |cell| cell.faces.len());
            (0..corners).for_each(|k| add([face.nodes[k], face.nodes[(k + 1) % corners]]));
        }
        let whole: (f64, f64) =
            sums.values().fold((0.0, 0.0), |sum, own| (sum.0 + own.0, sum.1 + own.1));
        for slave in &mut self.slaves {
            let own = slave.points.first().and_then(|&point| sums.get(&node(point)));
            let (sum, count) = own.copied().unwrap_or(whole);
            slave.size = if count > 0.0 { sum / count } else { 0.0 };
        }
    }
}

/// Zero up to 0, one from 1 on, smooth between.
fn smooth_step(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}
