//! Masters, ready to be searched.

use super::beyond::Beyond;
use super::chains::{continued, listed_nodes, own_parts};
use super::facing::{Facing, Standing};
use super::mirrors::mirrors;
use super::positions::MasterPositions;
use super::profiles::{placed, swept_profile};
use super::stencil::Stencil;
use crate::dofs::{DofMap, Translations, rigid_dofs};
use slideline_mech::contact::gap::Order;
use slideline_mech::contact::pair::{
    AnyGap, Body, RigidSurface, chain_attachments, chain_gap, chain_overclosure,
};
use slideline_mech::contact::search::chain::{Chain, Piece};
use slideline_mech::contact::search::itself::{Itself, Placed};
use slideline_mech::contact::search::outlook::Outlook;
use slideline_mech::contact::search::own_faces::OwnFaces;
use slideline_mech::contact::search::sharp;
use slideline_mech::contact::search::through::CONTROLS;
use slideline_mech::rigid::Attachment;
use slideline_mech::surface::mesh::{FaceMesh, MeshFace};
use slideline_model::{
    Master, MasterFaces, Model, NodeIndex, OwnSurface, SlideLine, SymmetryPlane,
};
use std::collections::HashMap;
use std::ops::Range;

/// A master, ready to be searched.
#[derive(Clone, Debug)]
pub enum MasterSurface {
    /// A rigid surface on the body of a node.
    Body {
        /// Dofs of the body's dofs.
        dofs: [usize; 3],
        /// Undeformed position of its node [L].
        reference: [f64; 3],
        /// The surface, undeformed.
        surface: RigidSurface,
    },
    /// A chain of nodes, and where its positions begin in the scratch.
    Line {
        /// Its reference geometry.
        chain: Chain,
        /// Undeformed positions of its nodes [L], and their dofs.
        nodes: Vec<([f64; 3], Translations)>,
        /// Place of its first position in the scratch.
        offset: usize,
        /// Which of its nodes are middle nodes of faces; empty: none is.
        middles: Vec<bool>,
        /// Which of its parts its own nodes may meet, where it meets itself.
        itself: Option<Box<Itself>>,
        /// Which of its nodes continue it.
        beyond: Beyond,
    },
    /// Faces in space, and where the positions of their nodes begin in the scratch.
    Faces {
        /// How they are joined.
        mesh: FaceMesh,
        /// Undeformed positions of its nodes [L], and their dofs.
        nodes: Vec<([f64; 3], Translations)>,
        /// Place of its first position in the scratch.
        offset: usize,
        /// Part of a face by which an open end is prolonged [1].
        extension: f64,
        /// Which of its faces its own nodes may meet, where it meets itself.
        itself: Option<Box<OwnFaces>>,
    },
    /// Nothing to slide on (a master that reading has refused).
    Nothing,
}

impl MasterSurface {
    /// A master that goes on beyond planes of symmetry, and whose nodes follow those of the masters before; faces of the
    /// slave are so long [L].
    pub fn of(
        (model, dofs): (&Model, &DofMap),
        (said, planes): (&Master, Option<&[SymmetryPlane]>),
        (offset, slave): (usize, f64),
    ) -> MasterSurface {
        match said {
            Master::RigidSurface(surface) => Self::body(model, dofs, surface, slave),
            Master::SlideLine(line) => Self::chain((model, dofs), (line, planes), (offset, slave)),
            Master::Faces(faces) => {
                let planes = planes.unwrap_or_default();
                Self::faces((model, dofs), (faces, planes), (offset, slave))
            }
            Master::Itself(surface) => Self::itself(model, dofs, surface, offset),
        }
    }

    /// The master of a chain of nodes; faces of the slave are so long [L].
    pub fn chain(
        (model, dofs): (&Model, &DofMap),
        (line, planes): (&SlideLine, Option<&[SymmetryPlane]>),
        (offset, slave): (usize, f64),
    ) -> MasterSurface {
        let mut nodes = Vec::new();
        let beyond = continued((model, dofs), (line, planes), &mut nodes);
        let reference: Vec<_> = nodes.iter().map(|(at, _)| *at).collect();
        match Chain::new(&reference, line.smooth, line.extension) {
            Some(mut chain) => {
                (chain.slave, chain.is_ring) = (slave, line.is_ring());
                chain.continue_by(beyond.counts);
                let (middles, itself) = (line.middles.clone(), None);
                MasterSurface::Line { chain, nodes, offset, middles, itself, beyond }
            }
            None => MasterSurface::Nothing,
        }
    }

    /// The surface that its own nodes meet.
    pub fn itself(
        model: &Model,
        dofs: &DofMap,
        surface: &OwnSurface,
        offset: usize,
    ) -> MasterSurface {
        let list = listed_nodes(surface);
        let nodes: Vec<_> = list
            .iter()
            .map(|&node| (model.nodes.get(node).position, dofs.translations(node)))
            .collect();
        match own_parts(model, surface, &list) {
            Some((itself, chain)) => {
                let (middles, itself) = (Vec::new(), Some(Box::new(itself)));
                let beyond = Beyond::default();
                MasterSurface::Line { chain, nodes, offset, middles, itself, beyond }
            }
            None => MasterSurface::Nothing,
        }
    }

    /// What a surface that meets itself knows of its parts.
    pub fn own(&self) -> Option<&Itself> {
        match self {
            Self::Line { itself, .. } => itself.as_deref(),
            _ => None,
        }
    }

    /// Whether its own nodes are its slaves.
    pub fn meets_itself(&self) -> bool {
        matches!(self, Self::Line { itself: Some(_), .. } | Self::Faces { itself: Some(_), .. })
    }

    /// Whether the node at a seat of a master can pass through a part or face of it: all can where it
    /// does not meet itself.
    pub(super) fn stops(&self, seat: usize, part: usize) -> bool {
        match self {
            Self::Line { itself: Some(own), .. } => own.stops(seat, part),
            Self::Faces { itself: Some(own), .. } => own.stops(seat, part),
            _ => true,
        }
    }

    /// The master of a rigid surface on the body of its node; faces of the slave are so long [L].
    pub fn body(
        model: &Model,
        dofs: &DofMap,
        surface: &slideline_model::RigidSurface,
        slave: f64,
    ) -> MasterSurface {
        let Some(mut placed) = placed(surface) else { return MasterSurface::Nothing };
        placed.prolong(surface.extension, slave);
        MasterSurface::Body {
            dofs: rigid_dofs(dofs, surface.reference),
            reference: model.nodes.get(surface.reference).position,
            surface: placed,
        }
    }

    /// The master of faces in space.
    pub fn faces(
        (model, dofs): (&Model, &DofMap),
        (faces, planes): (&MasterFaces, &[SymmetryPlane]),
        (offset, slave): (usize, f64),
    ) -> MasterSurface {
        let labels = faces.nodes();
        let place: HashMap<_, _> = labels.iter().enumerate().map(|(k, &node)| (node, k)).collect();
        let at = |&node: &NodeIndex| model.nodes.get(node).position;
        let reference: Vec<_> = labels.iter().map(at).collect();
        let of_mesh = faces.faces.iter().filter_map(|face| {
            let nodes = face.nodes.iter().map(|node| place[node]).collect();
            Some(MeshFace { cell: face.cell()?, nodes })
        });
        let mut mesh = match &faces.swept {
            None => {
                let own: Vec<_> = of_mesh.collect();
                let mirrors = mirrors(&own, &reference, planes);
                FaceMesh::mirrored(own, &reference, (faces.smooth, &mirrors))
            }
            Some(swept) => match swept_profile(swept) {
                Some(swept) => FaceMesh::analytical(swept),
                None => return MasterSurface::Nothing,
            },
        };
        // nodes alone have no faces
        mesh.slave = if slave > 0.0 { slave } else { f64::INFINITY };
        let nodes = labels.iter().map(|node| (at(node), dofs.translations(*node))).collect();
        let itself = faces.meets_itself.then(|| Box::new(OwnFaces::new(&mesh, &reference)));
        MasterSurface::Faces { mesh, nodes, offset, extension: faces.extension, itself }
    }

    /// Nodes of a deforming master.
    pub fn nodes(&self) -> &[([f64; 3], Translations)] {
        match self {
            Self::Line { nodes, .. } | Self::Faces { nodes, .. } => nodes,
            Self::Body { .. } | Self::Nothing => &[],
        }
    }

    /// The most dofs of the master that a point follows at a time.
    pub fn most_dofs(&self) -> usize {
        match self {
            Self::Nothing => 0,
            Self::Body { dofs, .. } => dofs.len(),
            // an image follows a node in its plane too
            Self::Line { chain, nodes, beyond, .. } => {
                (chain.most_nodes() + beyond.normals().len().min(1))
                    * nodes.iter().map(|(_, dofs)| dofs.as_slice().len()).max().unwrap_or(0)
            }
            // of the face, and of the one at the last commit
            Self::Faces { mesh, .. } => 2 * 3 * mesh.longest_stencil(),
        }
    }

    /// The body of a rigid master at displacements `u`.
    pub fn placed_body(&self, u: &[f64]) -> Body {
        match self {
            Self::Body { dofs, reference, .. } => {
                Body { reference: *reference, dofs: dofs.map(|dof| u[dof]) }
            }
            _ => Body::STILL,
        }
    }

    /// What a point of the pair of that index faces, with masters at `positions`; `seat` is its
    /// place on a master that it belongs to, `outlook` what its own faces look at.
    pub fn search(
        &self,
        u: &[f64],
        (positions, pair): (&MasterPositions, usize),
        (point, seat, outlook): (Standing, usize, &Outlook),
    ) -> Option<Facing> {
        match self {
            Self::Nothing | Self::Faces { .. } => None,
            Self::Body { surface, .. } => {
                let at = (point.at, point.on, outlook);
                surface.closest_to_node(&self.placed_body(u), at).map(Facing::Surface)
            }
            Self::Line { .. } => {
                self.piece((positions, pair), (point, seat, outlook)).map(Facing::Piece)
            }
        }
    }

    /// The piece of a line that a point faces.
    pub(super) fn piece(
        &self,
        (positions, pair): (&MasterPositions, usize),
        (point, seat, outlook): (Standing, usize, &Outlook),
    ) -> Option<Piece> {
        let Self::Line { chain, nodes, offset, itself, .. } = self else { return None };
        let range = *offset..offset + nodes.len();
        match itself {
            None => {
                let (own, nearby) = positions.chain(pair, range)?;
                let found = sharp::closest(chain, own, nearby, (point.at, point.on, outlook))?;
                Some(chain.met_piece(found))
            }
            Some(itself) => itself.closest(placed_itself((chain, range), (positions, pair))?, seat),
        }
    }

    /// Overclosure of the node of a surface that meets itself against what it meets, whichever of
    /// both is the slave [L]; `None` where it meets nothing.
    pub(super) fn met_itself(
        &self,
        (positions, pair): (&MasterPositions, usize),
        seat: usize,
    ) -> Option<f64> {
        let Self::Line { chain, nodes, offset, itself: Some(itself), .. } = self else {
            return None;
        };
        let range = *offset..offset + nodes.len();
        let placed = placed_itself((chain, range), (positions, pair))?;
        let piece = itself.met(placed, seat)?;
        let found = chain_overclosure(chain, &piece, placed.positions, placed.positions[seat])?;
        Some(found[0])
    }

    /// The gap of the point of a stencil to what it faces; the master's part is
    /// added to the stencil. `slave` tells how the point follows its own dofs.
    #[inline]
    pub fn gap<O: Order>(
        &self,
        facing: &Facing,
        slave: Attachment,
        (u, positions): (&[f64], &[[f64; 3]]),
        stencil: &mut Stencil<'_>,
    ) -> Option<AnyGap<O>> {
        match (self, facing) {
            (Self::Body { dofs, surface, .. }, Facing::Surface(facing)) => {
                let body = self.placed_body(u);
                let gap = surface.gap(&body, facing, (stencil.position, stencil.offset))?;
                let first = stencil.width();
                stencil.attachments = surface.attachments(&body, facing, slave, first);
                stencil.add_from(dofs, u);
                Some(gap)
            }
            (Self::Line { chain, nodes, offset, beyond, .. }, Facing::Piece(piece)) => {
                let positions = positions.get(*offset..offset + nodes.len())?;
                let point = (stencil.position, stencil.offset);
                let gap = chain_gap(chain, piece, positions, point)?;
                let mut control = [slave; CONTROLS];
                let (from, facing) = (stencil.width(), piece.nodes());
                for (attachment, place) in control.iter_mut().zip(facing.clone()) {
                    let follow = |node: usize| stencil.follow(from, nodes[node].1.as_slice(), u);
                    *attachment = beyond.attachment((place, nodes.len()), follow);
                }
                stencil.attachments = Some(chain_attachments(slave, &control[..facing.len()]));
                Some(gap)
            }
            _ => None,
        }
    }

    /// Places whose box holds the master at displacements of both ends of a
    /// way and, straight, between them; a master of the plane has all depth there is.
    pub fn swept(&self, u: &[Vec<f64>; 2], chains: &[MasterPositions; 2]) -> [[f64; 3]; 2] {
        let mut low = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY];
        let mut high = low.map(|x: f64| -x);
        let mut take = |at: [f64; 3], room: f64| {
            for axis in 0..2 {
                low[axis] = low[axis].min(at[axis] - room);
                high[axis] = high[axis].max(at[axis] + room);
            }
        };
        match self {
            Self::Nothing => {}
            Self::Faces { mesh, .. } if mesh.swept().is_some() => {
                return [[f64::NEG_INFINITY; 3], [f64::INFINITY; 3]];
            }
            Self::Faces { nodes, offset, .. } => {
                let range = *offset..offset + nodes.len();
                let all = chains.iter().flat_map(|c| &c.nodes[range.clone()]);
                return bounds_of(all.copied());
            }
            Self::Body { surface, .. } => {
                let (centre, radius) = surface.bounds();
                u.iter().for_each(|u| take(self.placed_body(u).to_space(centre), radius));
            }
            Self::Line { nodes, offset, .. } => {
                let range = *offset..offset + nodes.len();
                chains.iter().flat_map(|c| &c.nodes[range.clone()]).for_each(|&at| take(at, 0.0));
            }
        }
        [low, high]
    }

    /// Overclosure [L] that `point` would have were the end prolonged beyond
    /// which it lies; `None` where it lies beyond none.
    pub fn beyond_end(&self, point: [f64; 3], u: &[f64], positions: &[[f64; 3]]) -> Option<f64> {
        match self {
            Self::Nothing | Self::Faces { .. } => None,
            Self::Body { surface, .. } => surface.beyond_end(&self.placed_body(u), point),
            // where the faces of a surface end, its part turns away
            Self::Line { itself: Some(_), .. } => None,
            Self::Line { chain, nodes, offset, .. } => {
                chain.beyond_end(positions.get(*offset..offset + nodes.len())?, point)
            }
        }
    }
}

/// The surface of a pair that meets itself where it stands.
fn placed_itself<'a>(
    (chain, range): (&'a Chain, Range<usize>),
    (positions, pair): (&'a MasterPositions, usize),
) -> Option<Placed<'a>> {
    let (positions, tree) = (positions.nodes.get(range)?, positions.tree(pair)?);
    Some(Placed { chain, positions, tree })
}

/// The box about places.
fn bounds_of(places: impl Iterator<Item = [f64; 3]>) -> [[f64; 3]; 2] {
    let nothing = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    places.fold(nothing, |[low, high], at| {
        let join = |k: usize| (low[k].min(at[k]), high[k].max(at[k]));
        [std::array::from_fn(|k| join(k).0), std::array::from_fn(|k| join(k).1)]
    })
}
