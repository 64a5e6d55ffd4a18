//! The pairs of a model prepared: which points there are, which dofs they follow, which masters.

use super::laws::{self, mean_length};
use super::master::MasterSurface;
use super::mortar::slave::Mortar;
use super::mortar_faces::slave::FaceMortar;
use super::pairs::{Carrier, Contact};
use super::profiles::placed;
use super::segment::{CELLS, SEGMENT_POINTS, STRETCHES, SlaveSegment};
use super::shear::{Shear, sheared_beams};
use super::stencil::{NO_TURN, SectionTurn};
use crate::dofs::{DofMap, rigid_dofs};
use crate::users::UserFrictions;
use slideline_mech::contact::pair::Stretch;
use slideline_mech::contact::points::integration_points::POINTS;
use slideline_mech::contact::search::rigid::RigidSegment;
use slideline_model::{
    ContactPair, Dof, EdgePair, Formulation, Model, NodeIndex, RigidSurface, SymmetryPlane,
};
use std::collections::{HashMap, HashSet};

impl Contact {
    /// Prepares the pairs of a model.
    pub fn new(model: &Model, dofs: &DofMap, users: &UserFrictions) -> Self {
        let slave_nodes: Vec<_> =
            model.contact_pairs.iter().map(ContactPair::slave_nodes).collect();
        let mut contact = Self {
            points: Vec::with_capacity(slave_nodes.iter().map(Vec::len).sum()),
            slave_nodes,
            directions: if model.is_in_space() { 2 } else { 1 },
            ..Self::default()
        };
        let planes = planes_beyond(model);
        for (place, pair) in model.contact_pairs.iter().enumerate() {
            let at_nodes = pair.formulation == Formulation::NodeToSurface;
            let beyond = at_nodes.then(|| planes.get(place).map_or(&[][..], Vec::as_slice));
            contact.edges.push(Vec::new());
            contact.spread_nodes.push(Vec::new());
            match pair.formulation {
                Formulation::NodeToSurface => contact.add_nodes(dofs, place, pair),
                Formulation::Mortar => contact.add_mortar(model, dofs, place, pair),
                Formulation::SurfaceToSurface => contact.add_segments(model, dofs, place, pair),
            }
            let length = mean_length(model, pair);
            contact.laws.push(laws::laws(model, pair, length, users));
            contact.keeps.push(pair.interaction.no_separation);
            let places = (contact.chain_nodes, length);
            let master = MasterSurface::of((model, dofs), (&pair.master, beyond), places);
            contact.chain_nodes += master.nodes().len();
            contact.spacing.push(laws::spacing(model, length, &master));
            contact.masters.push(master);
            contact.offsets.push(pair.offset);
            contact.take_axes(model, place);
            contact.take_seats(place, pair);
            contact.add_slave_faces(dofs, place, pair);
        }
        for (place, edges) in model.edge_pairs.iter().enumerate() {
            let beyond = beyond_edges(&planes, (model, place));
            contact.add_edges((model, dofs), (edges, beyond));
        }
        model.crossing_edges.iter().for_each(|own| contact.add_crossings(model, dofs, own));
        contact.take_bonds();
        contact.opposed = contact.opposed_pairs();
        contact.take_points(model);
        contact.take_segments(model);
        contact.take_edges(model);
        contact.follow_pairs(model);
        contact.take_crossings(model);
        contact.take_slave_faces(model);
        contact.take_left_out(model);
        contact.take_thicknesses(model);
        contact
    }

    /// Where the points of a surface that meets itself stand on it.
    fn take_seats(&mut self, place: usize, pair: &ContactPair) {
        if !pair.meets_itself() {
            return;
        }
        let own = self.masters[place].own();
        let seat = |number: usize| own.map_or(number, |own| own.seat(number));
        let nodes = pair.master.deforming_nodes();
        let seats: HashMap<_, _> =
            nodes.into_iter().enumerate().map(|(number, node)| (node, seat(number))).collect();
        for point in self.points.iter_mut().filter(|point| point.pair == place) {
            point.seat = seats.get(&point.node).copied().unwrap_or(0);
        }
    }

    /// Pairs with rigid masters that share slave nodes.
    fn opposed_pairs(&self) -> Vec<[usize; 2]> {
        let rigid = |pair: &usize| matches!(self.masters[*pair], MasterSurface::Body { .. });
        let pairs: Vec<usize> = (0..self.own_pairs()).filter(rigid).collect();
        let mut opposed = Vec::new();
        for (k, &first) in pairs.iter().enumerate() {
            let own: HashSet<_> = self.slave_nodes[first].iter().collect();
            let shares =
                |second: &&usize| self.slave_nodes[**second].iter().any(|node| own.contains(node));
            opposed.extend(pairs[k + 1..].iter().filter(shares).map(|&second| [first, second]));
        }
        opposed
    }

    fn add_nodes(&mut self, dofs: &DofMap, place: usize, pair: &ContactPair) {
        let nodes = self.slave_nodes[place].clone();
        let first = self.points.len();
        let points = nodes.iter().enumerate().map(|(k, &node)| (node, first + k));
        let points: HashMap<_, _> = points.collect();
        let elements = pair.elements.iter();
        self.edges[place] = elements.map(|own| own.nodes.map(|node| points[&node])).collect();
        self.points.reserve(nodes.len());
        for node in nodes {
            let section = section_of(dofs, node, pair);
            let (position, dofs) = ([0.0; 3], dofs.translations(node));
            self.add_point(place, pair, node, Carrier::Node { position, dofs, section });
        }
    }

    /// Adds the slave nodes of a pair whose contact is spread over their faces, and the points that
    /// corners add.
    fn add_mortar(&mut self, model: &Model, dofs: &DofMap, place: usize, pair: &ContactPair) {
        let first = self.points.len();
        self.add_nodes(dofs, place, pair);
        for &node in &pair.corners {
            let (position, dofs) = ([0.0; 3], dofs.translations(node));
            let carrier = Carrier::Node { position, dofs, section: NO_TURN };
            self.add_point(place, pair, node, carrier);
        }
        let nodes = &self.slave_nodes[place][..];
        let own = match pair.faces.is_empty() {
            true => {
                self.mortars.push(Mortar::new((place, pair), first, (nodes, dofs)));
                self.mortars.len() - 1
            }
            false => {
                let own = FaceMortar::new((place, pair), first, (nodes, model, dofs));
                self.face_mortars.push(own);
                self.face_mortars.len() - 1
            }
        };
        self.points[first..].iter_mut().for_each(|point| point.mortar = Some(own));
        // faces press on the nodes in the middle of their edges too, which have no points
        let of_faces = pair.faces.iter().flat_map(|face| face.nodes.iter());
        let all = &mut self.spread_nodes[place];
        all.extend(self.slave_nodes[place].iter().chain(of_faces));
        all.sort_unstable();
        all.dedup();
    }

    /// Adds the elements of a pair as segments of integration points, without their numbers.
    fn add_segments(&mut self, model: &Model, dofs: &DofMap, place: usize, pair: &ContactPair) {
        let beams = sheared_beams(model);
        let rows: HashMap<_, _> =
            self.slave_nodes[place].iter().enumerate().map(|(row, &node)| (node, row)).collect();
        for element in &pair.elements {
            let [a, b] = element.nodes.map(|node| rigid_dofs(dofs, node));
            let (segment, first) = (self.segments.len(), self.points.len());
            for point in 0..SEGMENT_POINTS {
                let node = element.nodes[usize::from(2 * (point / POINTS) >= CELLS)];
                self.add_point(place, pair, node, Carrier::IntegrationPoint { segment });
            }
            let rows = element.nodes.map(|node| rows[&node]);
            let own = [a[0], a[1], a[2], b[0], b[1], b[2]];
            let mut new = SlaveSegment::of_beam((place, rows), own, first);
            new.shear = Shear::new(model, dofs, element.nodes, &beams);
            self.segments.push(new);
        }
        if let Some(profile) = &pair.profile {
            self.add_profile(dofs, (place, pair), profile);
        }
    }

    /// Adds the parts of a profile as segments of integration points, without their numbers.
    fn add_profile(
        &mut self,
        dofs: &DofMap,
        (place, pair): (usize, &ContactPair),
        profile: &RigidSurface,
    ) {
        let node = profile.reference;
        let own = rigid_dofs(dofs, node);
        let still = RigidSegment::Line { a: [0.0; 2], b: [0.0; 2] };
        for _ in 0..STRETCHES * profile.segments.len() {
            let (segment, first) = (self.segments.len(), self.points.len());
            for _ in 0..SEGMENT_POINTS {
                self.add_point(place, pair, node, Carrier::IntegrationPoint { segment });
            }
            let stretch = Stretch::new(still, [0.0, 1.0], [0.0; 3]);
            self.segments.push(SlaveSegment::of_profile(place, stretch, own, first));
        }
    }

    /// Takes the numbers of a model with the pairs that were prepared, or prepares them.
    ///
    /// Errors: the index of a pair whose master has lost or gained its extent.
    pub fn take(
        &mut self,
        model: &Model,
        dofs: &DofMap,
        users: &UserFrictions,
    ) -> Result<(), usize> {
        if self.laws.is_empty() {
            *self = Self::new(model, dofs, users);
            return Ok(());
        }
        self.take_points(model);
        self.take_segments(model);
        let planes = planes_beyond(model);
        for (index, pair) in model.contact_pairs.iter().enumerate() {
            let length = mean_length(model, pair);
            let at_nodes = pair.formulation == Formulation::NodeToSurface;
            let beyond = at_nodes.then(|| planes.get(index).map_or(&[][..], Vec::as_slice));
            if !self.take_master(model, dofs, (index, &pair.master, length), beyond) {
                return Err(index);
            }
            if pair.profile.as_ref().is_some_and(|own| placed(own).is_none()) {
                return Err(index);
            }
            self.take_axes(model, index);
            self.spacing[index] = laws::spacing(model, length, &self.masters[index]);
            self.take_laws((model, pair), (index, length), users);
            self.offsets[index] = pair.offset;
        }
        for (place, edges) in model.edge_pairs.iter().enumerate() {
            let (index, length) = (model.contact_pairs.len() + place, self.spacing[edges.of]);
            let beyond = beyond_edges(&planes, (model, place));
            if !self.take_master(model, dofs, (index, &edges.met, length), beyond) {
                return Err(edges.of);
            }
        }
        self.take_edges(model);
        self.follow_pairs(model);
        self.take_crossings(model);
        self.take_slave_faces(model);
        self.take_bonds();
        self.take_thicknesses(model);
        Ok(())
    }
}

/// The planes of symmetry beyond which masters go on, pair by pair, and then those of what sharp edges meet.
fn planes_beyond(model: &Model) -> Vec<Vec<SymmetryPlane>> {
    let of_pairs = model.contact_pairs.iter().map(ContactPair::met_at_nodes);
    model.planes_beyond(of_pairs.chain(model.edge_pairs.iter().map(EdgePair::met_in_space)))
}

/// Those of what the edges of that place meet; none of lines in the plane.
fn beyond_edges<'a>(
    planes: &'a [Vec<SymmetryPlane>],
    (model, place): (&Model, usize),
) -> Option<&'a [SymmetryPlane]> {
    let own = planes.get(model.contact_pairs.len() + place).map_or(&[][..], Vec::as_slice);
    model.edge_pairs[place].met_in_space().map(|_| own)
}

/// The rotation that carries the surface of a beam about a slave node; none where the surface is its
/// line, or no section turns there.
fn section_of(dofs: &DofMap, node: NodeIndex, pair: &ContactPair) -> SectionTurn {
    let turn = dofs.find(node, Dof::UR3).filter(|_| pair.offset.slave != 0.0);
    turn.map_or(NO_TURN, |dof| [(dof, 1.0), (dof, 0.0), (dof, 0.0)])
}
