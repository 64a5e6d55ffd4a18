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

use super::edge_points::{EdgePoints, SlaveNode};
use super::master::MasterSurface;
use super::pairs::{Carrier, Contact};
use super::slave_face::SlaveFace;
use super::stencil::NO_TURN;
use crate::dofs::DofMap;
use crate::state::{PointState, State};
use slideline_model::{EdgePair, Model, NodeIndex, SymmetryPlane};
use std::collections::HashMap;

/// Part of the size of a face by which an edge may stand in it beyond the mean and not be held [1]: less is
/// what faces that bend about an edge, and meshes that do not match, come to.
const FREE: f64 = 0.01;

/// Slave nodes of a pair about an edge, with their shares [1].
type About = [(usize, f64); 4];

impl Contact {
    /// Adds the points of the edges of a pair that has been added.
    pub(super) fn add_edges(
        &mut self,
        (model, dofs): (&Model, &DofMap),
        (edges, beyond): (&EdgePair, Option<&[SymmetryPlane]>),
    ) {
        let pair = &model.contact_pairs[edges.of];
        let (place, first) = (self.masters.len(), self.points.len());
        for &node in &edges.nodes {
            let (position, dofs) = ([0.0; 3], dofs.translations(node));
            let carrier = Carrier::Node { position, dofs, section: NO_TURN };
            self.add_point(place, pair, node, carrier);
        }
        let (of_node, slaves) = self.slave_nodes_of(edges.of);
        let seat = |node: &NodeIndex| of_node.get(node).copied().unwrap_or(slaves.len());
        let seats = match edges.is_of_master {
            false => edges.nodes.iter().map(seat).collect(),
            true => edges.met.deforming_nodes().iter().map(seat).collect(),
        };
        let (of, of_master) = (edges.of, edges.is_of_master);
        let count = edges.nodes.len();
        self.edge_points.push(EdgePoints { of, of_master, first, count, seats, slaves });
        self.slave_nodes.push(edges.nodes.clone());
        self.edges.push(Vec::new());
        self.spread_nodes.push(Vec::new());
        self.laws.push(self.laws[of].clone());
        self.keeps.push(pair.interaction.no_separation);
        self.offsets.push(pair.offset);
        self.spacing.push(self.spacing[of]);
        let master = MasterSurface::of(
            (model, dofs),
            (&edges.met, beyond),
            (self.chain_nodes, self.spacing[of]),
        );
        self.chain_nodes += master.nodes().len();
        self.masters.push(master);
        self.add_faces_of_edges(model, dofs, edges);
    }

    /// The slave nodes of a pair, and which place among them a node has.
    fn slave_nodes_of(&self, pair: usize) -> (HashMap<NodeIndex, usize>, Vec<SlaveNode>) {
        let (mut of_node, mut slaves) = (HashMap::new(), Vec::<SlaveNode>::new());
        for (own, point) in self.points.iter().enumerate().filter(|(_, p)| p.pair == pair) {
            let seat = *of_node.entry(point.node).or_insert(slaves.len());
            if seat == slaves.len() {
                slaves.push(SlaveNode::default());
            }
            slaves[seat].points.push(own);
        }
        (of_node, slaves)
    }

    /// Notes the faces about the nodes of edges.
    fn add_faces_of_edges(&mut self, model: &Model, dofs: &DofMap, edges: &EdgePair) {
        let corner = |&node: &NodeIndex| (node, [0.0; 3], dofs.translations(node));
        let first = self.points.len() - edges.nodes.len();
        let places = edges.nodes.iter().enumerate().map(|(own, node)| (*node, first + own));
        let places: HashMap<_, _> = places.collect();
        for [face, middles] in edges.own_faces(&model.contact_pairs[edges.of]) {
            let all = face.iter().chain(&middles);
            let about: Vec<usize> = all.filter_map(|node| places.get(node).copied()).collect();
            if about.is_empty() {
                continue;
            }
            let number = self.slave_faces.len();
            let corners = face.iter().map(corner).collect();
            self.slave_faces.push(SlaveFace { corners, parts: 1.0 });
            about.into_iter().for_each(|place| self.points[place].faces.push(number));
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
                let own = areas.get(seat).copied().filter(|area| *area > 0.0);
                points[place].area = own.unwrap_or(mean);
            }
        }
    }

    /// Laws, spacings and axes of edge points: those of their pairs.
    pub(super) fn follow_pairs(&mut self, model: &Model) {
        let pairs = self.own_pairs();
        for (place, edges) in model.edge_pairs.iter().enumerate() {
            let (own, of) = (pairs + place, edges.of);
            self.laws[own] = self.laws[of].clone();
            self.keeps[own] = self.keeps[of];
            self.spacing[own] = self.spacing[of];
            self.offsets[own] = self.offsets[of];
            self.take_axes(model, own);
        }
    }

    /// How deep an edge may stand in a face in the next increment, by how it and the pair stood at the last commit [L].
    /// docs/theory.md eq. (5.49)
    pub(super) fn edge_allowance(&self, place: usize, before: &[PointState]) -> f64 {
        let stand = self.stand_of_edge(place, before);
        stand.map_or(0.0, |stand| self.allowance(&stand, self.points[place].pair))
    }

    /// What an edge of a pair may do unheld [L]. Under a soft law its pair goes on sinking in within the increment: an
    /// edge that was open and lay flat is left to it. docs/theory.md eq. (5.49)
    pub(super) fn allowance(&self, stand: &EdgeStand, pair: usize) -> f64 {
        match self.is_soft(pair) {
            true => stand.allowance_beside(self.laws[pair].normal.contact_begins()),
            false => stand.allowance(0.0),
        }
    }

    /// How an edge stands in the other side in a state; `None` where it, or every slave node about it, faces nothing,
    /// and of points that are no edges. docs/theory.md eq. (5.48)
    pub(super) fn stand_of_edge(&self, place: usize, points: &[PointState]) -> Option<EdgeStand> {
        let edges = self.points[place].pair.checked_sub(self.own_pairs())?;
        let (own, now) = (self.edge_points.get(edges)?, points.get(place)?);
        // one that faced nothing has nothing to be held against
        now.along.filter(|_| now.opening.is_finite())?;
        let mut sums = [0.0; 3];
        for (seat, share) in self.about(place, now).into_iter().filter(|(_, share)| *share > 0.0) {
            let Some(slave) = own.slaves.get(seat) else { continue };
            let raw = |&point: &usize| points[point].raw_gap();
            let gap = slave.points.iter().map(raw).fold(f64::INFINITY, f64::min);
            if gap.is_finite() {
                let [shares, gaps, sizes] = sums;
                sums = [shares + share, gaps + share * gap, sizes + share * slave.size];
            }
        }
        let [shares, gaps, sizes] = sums;
        (shares > 0.0 && sizes > 0.0).then(|| EdgeStand {
            mean: gaps / shares,
            gap: now.raw_gap(),
            size: sizes / shares,
            is_held: now.closed,
        })
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
        let Some(own) =
            pair.checked_sub(self.own_pairs()).and_then(|own| self.edge_points.get(own))
        else {
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

    /// Work of edges as more or less of their depth is allowed, by the trapezoidal rule [F L].
    pub(super) fn work_at_edges(&self, committed: &State, trial: &State) -> f64 {
        let own = self.places_of_edges();
        let (Some(then), Some(now)) = (committed.points.get(own.clone()), trial.points.get(own))
        else {
            return 0.0;
        };
        let work = |(then, now): (&PointState, &PointState)| {
            let mean = 0.5 * (then.area * then.pressure + now.area * now.pressure);
            let is_held = mean != 0.0 && now.along.is_some();
            // what was open is pushed out from where it stood
            let from = match then.closed {
                true => then.allowed,
                false => then.allowed.min(-then.raw_gap()).max(now.allowed),
            };
            if is_held { mean * (from - now.allowed) } else { 0.0 }
        };
        then.iter().zip(now).map(work).sum()
    }
}

/// How an edge stands in the other side [L].
pub(super) struct EdgeStand {
    /// The gap that the pair shows there.
    pub mean: f64,
    /// The gap of the edge.
    pub gap: f64,
    /// Size of the faces there.
    pub size: f64,
    /// Whether it is held.
    pub is_held: bool,
}

impl EdgeStand {
    /// How deep it may stand unheld beside a pair whose pressure begins at an overclosure [L].
    fn allowance(&self, begins: f64) -> f64 {
        let free = FREE * self.size;
        let beyond = 0.5 * (self.mean - self.gap) / free;
        (-self.mean - begins).max(0.0) + free * (1.0 - smooth_step(beyond))
    }

    /// The same of a pair whose law is soft: an edge that it holds may go with it as far as a face is long.
    fn allowance_beside(&self, begins: f64) -> f64 {
        let goes_along = !self.is_held && !self.is_alone();
        self.allowance(begins) + if goes_along { self.size } else { 0.0 }
    }

    /// Whether it stands deeper than the pair shows, so that the pair does not hold it.
    pub fn is_alone(&self) -> bool {
        self.mean - self.gap > FREE * self.size
    }
}

/// Zero up to 0, one from 1 on, smooth between.
fn smooth_step(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}
