//! The numbers of contact taken anew: areas, masters, laws.
//!
//! ```text
//!   o--o--o   other positions, other areas        _____
//!   ~~~~~~~   another master, another law        /     \   in the room of those before
//! ```
//!
//! Which points there are, and which dofs they follow, stays.

use super::areas::across;
use super::chains::{continued, listed_nodes, own_parts};
use super::laws;
use super::master::MasterSurface;
use super::pairs::{Carrier, Contact, SlavePoint};
use super::profiles::{placed_segments, swept_profile};
use super::segment::{Along, NEAR, SEGMENT_POINTS, STRETCHES, SlaveSegment};
use crate::dofs::DofMap;
use crate::users::UserFrictions;
use slideline_mech::contact::pair::Stretch;
use slideline_mech::contact::points::{chord, integration_points::HermiteLine};
use slideline_mech::surface::mesh::FaceMesh;
use slideline_mech::vector::{size, sub};
use slideline_model::{
    ContactPair, Formulation, Master, MasterFaces, Model, NodeIndex, RigidSurface, SlideLine,
    SymmetryPlane,
};

impl Contact {
    /// Positions and areas of the slave nodes.
    pub(super) fn take_points(&mut self, model: &Model) {
        for point in &mut self.points {
            point.area = 0.0;
            point.shares.clear();
            if let Carrier::Node { position, .. } = &mut point.carrier {
                *position = model.nodes.get(point.node).position;
            }
        }
        for (place, pair) in model.contact_pairs.iter().enumerate() {
            self.take_element_areas(model, place, pair);
        }
        self.take_mortars(model);
        let at_nodes = |pair: &ContactPair| pair.formulation != Formulation::Mortar;
        for (place, pair) in model.contact_pairs.iter().enumerate() {
            if at_nodes(pair) && !pair.faces.is_empty() {
                self.take_face_areas(model, place, pair);
            }
        }
    }

    /// Positions and areas of slave nodes whose contact is spread over their faces.
    fn take_mortars(&mut self, model: &Model) {
        let Self { points, mortars, face_mortars, slave_nodes, .. } = self;
        for mortar in face_mortars {
            let first = mortar.first;
            mortar.take(model, |point, area| points[first + point].area += area);
            mortar.axes.clear();
            if laws::is_directed(model, mortar.pair) {
                let pair = &model.contact_pairs[mortar.pair];
                mortar.take_axes(|at| pair.axes_of_slave(at));
            }
        }
        for mortar in mortars {
            let nodes = slave_nodes[mortar.pair].iter();
            let positions = nodes.map(|&node| model.nodes.get(node).position);
            let pair = &model.contact_pairs[mortar.pair];
            let first = mortar.first;
            mortar.take(positions, across(model, pair), |point, area| {
                points[first + point].area += area;
            });
        }
    }

    /// Lines and areas along which contact is integrated.
    pub(super) fn take_segments(&mut self, model: &Model) {
        let Self { segments, points, slave_nodes, tangents, .. } = self;
        let mut rest = &mut segments[..];
        let integrated = |pair: &ContactPair| pair.formulation == Formulation::SurfaceToSurface;
        for (index, pair) in model.contact_pairs.iter().enumerate().filter(|p| integrated(p.1)) {
            if let Some(profile) = &pair.profile {
                let count = STRETCHES * profile.segments.len();
                let Some(own) = rest.split_off_mut(..count) else { return };
                take_profile((model, pair), profile, own, points);
                continue;
            }
            let Some(own) = rest.split_off_mut(..pair.elements.len()) else { return };
            tangents.clear();
            tangents.resize(slave_nodes[index].len(), [0.0; 3]);
            for (element, segment) in pair.elements.iter().zip(&*own) {
                let [a, b] = element.nodes.map(|node| model.nodes.get(node).position);
                let d: [f64; 3] = std::array::from_fn(|c| b[c] - a[c]);
                let length = distance(model, element.nodes);
                for row in segment.rows {
                    tangents[row].iter_mut().zip(d).for_each(|(sum, d)| *sum += d / length);
                }
            }
            for tangent in tangents.iter_mut() {
                let size = tangent[0].hypot(tangent[1]).hypot(tangent[2]);
                if size > 0.0 {
                    *tangent = tangent.map(|t| t / size);
                }
            }
            for (element, segment) in pair.elements.iter().zip(own) {
                let length = distance(model, element.nodes);
                let nodes = element.nodes.map(|node| model.nodes.get(node).position);
                let tangents = segment.rows.map(|row| tangents[row].map(|t| t * length));
                segment.line = Along::Beam(HermiteLine::new(nodes, tangents));
                segment.near = NEAR * segment.line.length();
                segment.width = pair.interaction.width;
                segment.offset = pair.offset;
                segment.shear.iter_mut().for_each(|shear| shear.take(model));
                let areas = segment.areas();
                let own = &mut points[segment.first..][..SEGMENT_POINTS];
                own.iter_mut().zip(areas).for_each(|(point, area)| point.area = area);
            }
        }
    }

    /// The axes of the faces of a master, where friction has coefficients along them.
    pub(super) fn take_axes(&mut self, model: &Model, index: usize) {
        let (parent, reversed) = (self.parent(index), self.is_reversed(index));
        if let MasterSurface::Faces { mesh, nodes, .. } = &mut self.masters[index] {
            mesh.forget_axes();
            if laws::is_directed(model, parent) {
                let pair = &model.contact_pairs[parent];
                let axes =
                    |at| if reversed { pair.axes_of_slave(at) } else { pair.axes_of_master(at) };
                mesh.take_axes(axes, |node| nodes[node].0);
            }
        }
    }

    /// The master of a pair whose slave faces are so long on average [L]; false where there is none any more, or one that was not.
    pub(super) fn take_master(
        &mut self,
        model: &Model,
        dofs: &DofMap,
        (index, said, slave): (usize, &Master, f64),
        planes: Option<&[SymmetryPlane]>,
    ) -> bool {
        match (&mut self.masters[index], said) {
            (MasterSurface::Body { reference, surface, .. }, Master::RigidSurface(said)) => {
                *reference = model.nodes.get(said.reference).position;
                let whole = surface.take(placed_segments(said));
                surface.prolong(said.extension, slave);
                whole
            }
            (MasterSurface::Line { chain, nodes, itself, .. }, Master::Itself(surface)) => {
                let list = listed_nodes(surface);
                for ((position, _), &node) in nodes.iter_mut().zip(&list) {
                    *position = model.nodes.get(node).position;
                }
                let Some((own, line)) = own_parts(model, surface, &list) else { return false };
                (*chain, *itself) = (line, Some(Box::new(own)));
                true
            }
            (own @ MasterSurface::Line { .. }, Master::SlideLine(line)) => {
                own.take_line((model, dofs), (line, planes), slave)
            }
            (own @ MasterSurface::Faces { .. }, Master::Faces(faces)) => {
                own.take_faces((model, dofs), (faces, planes.unwrap_or_default()), slave)
            }
            (MasterSurface::Nothing, Master::RigidSurface(said)) => {
                matches!(MasterSurface::body(model, dofs, said, slave), MasterSurface::Nothing)
            }
            (MasterSurface::Nothing, Master::Itself(surface)) => {
                own_parts(model, surface, &listed_nodes(surface)).is_none()
            }
            (MasterSurface::Nothing, Master::SlideLine(line)) => {
                let made = MasterSurface::chain((model, dofs), (line, planes), (0, slave));
                matches!(made, MasterSurface::Nothing)
            }
            _ => false,
        }
    }

    /// The laws of a pair whose contact elements have that mean length [L].
    pub(super) fn take_laws(
        &mut self,
        (model, pair): (&Model, &ContactPair),
        (index, length): (usize, f64),
        users: &UserFrictions,
    ) {
        self.keeps[index] = pair.interaction.no_separation;
        let own = &mut self.laws[index];
        if own.user.is_some() {
            *own = laws::laws(model, pair, length, users);
            return;
        }
        let normal = laws::normal((model, pair), &pair.interaction.normal, length);
        if own.normal != *normal {
            own.normal = normal.into_owned();
        }
        own.friction = laws::friction((model, pair, &pair.interaction.friction), length);
        own.onset = model.friction_onset;
        if matches!(pair.interaction.friction, slideline_model::Friction::User { .. }) {
            *own = laws::laws(model, pair, length, users);
        }
    }
}

/// The parts of a profile along which contact is integrated, and their areas.
fn take_profile(
    (model, pair): (&Model, &ContactPair),
    profile: &RigidSurface,
    own: &mut [SlaveSegment],
    points: &mut [SlavePoint],
) {
    let reference = model.nodes.get(profile.reference).position;
    let parts = |k: usize| [k, k + 1].map(|end| end as f64 / STRETCHES as f64);
    let placed = placed_segments(profile).flatten();
    let stretches = placed
        .flat_map(|part| (0..STRETCHES).map(move |k| Stretch::new(part, parts(k), reference)));
    let whole = placed_segments(profile).flatten().map(|part| part.length()).sum::<f64>();
    for (segment, stretch) in own.iter_mut().zip(stretches) {
        segment.near = NEAR * whole;
        segment.line = Along::Profile(stretch);
        segment.width = pair.interaction.width;
        let areas = segment.areas();
        let own = &mut points[segment.first..][..SEGMENT_POINTS];
        own.iter_mut().zip(areas).for_each(|(point, area)| point.area = area);
    }
}

fn distance(model: &Model, nodes: [NodeIndex; 2]) -> f64 {
    chord(nodes.map(|node| model.nodes.get(node).position))
}

impl MasterSurface {
    /// Takes the places of a line; false where it has no extent any more, or goes on otherwise beyond its ends.
    fn take_line(
        &mut self,
        from: (&Model, &DofMap),
        (line, planes): (&SlideLine, Option<&[SymmetryPlane]>),
        slave: f64,
    ) -> bool {
        let Self::Line { chain, nodes, beyond, .. } = self else { return false };
        let before = (nodes.len(), beyond.counts);
        *beyond = continued(from, (line, planes), nodes);
        if (nodes.len(), beyond.counts) != before {
            return false;
        }
        let places = || nodes.iter().map(|(at, _)| *at);
        let lengths = places().zip(places().skip(1)).map(|(a, b)| size(sub(b, a)));
        (chain.slave, chain.is_ring) = (slave, line.is_ring());
        let whole = chain.take(lengths, line.smooth.unwrap_or(0.0), line.extension);
        if line.smooth.is_none() {
            chain.round(places());
        }
        chain.continue_by(beyond.counts);
        whole
    }

    /// Takes the places of faces; false where what smooths them follows other nodes.
    fn take_faces(
        &mut self,
        (model, dofs): (&Model, &DofMap),
        (faces, planes): (&MasterFaces, &[SymmetryPlane]),
        slave: f64,
    ) -> bool {
        let Self::Faces { mesh, nodes, extension, itself, offset } = self else { return false };
        *extension = faces.extension;
        if let Some(said) = &faces.swept {
            let Some(swept) = swept_profile(said) else { return false };
            if mesh.swept() != Some(&swept) {
                *mesh = FaceMesh::analytical(swept);
            }
        }
        for ((position, _), node) in nodes.iter_mut().zip(faces.nodes()) {
            *position = model.nodes.get(node).position;
        }
        if faces.swept.is_none() && !(planes.is_empty() && mesh.planes().is_empty()) {
            // what smooths it follows where its images stand
            let made = Self::faces((model, dofs), (faces, planes), (*offset, slave));
            let Self::Faces { mesh: made, .. } = made else { return false };
            if !mesh.follows_as(&made) {
                return false;
            }
            *mesh = made;
        }
        if let Some(own) = itself {
            own.take(mesh, nodes.iter().map(|(at, _)| *at));
        }
        true
    }
}
