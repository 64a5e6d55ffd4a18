//! The faces of a slave surface about its nodes, where their master has sharp edges.
//!
//! ```text
//!     o---o---o---o      each slave node knows the faces that meet there, and so which sides of
//!     |  its faces       a sharp edge of the master it may meet
//!     o
//! ```

use super::master::MasterSurface;
use super::pairs::{Contact, SlavePoint};
use super::slave_face::SlaveFace;
use crate::dofs::DofMap;
use slideline_mech::contact::search::outlook::Outlook;
use slideline_mech::contact::search::sharp;
use slideline_model::{ContactPair, Model, NodeIndex};
use std::collections::{HashMap, HashSet};

impl Contact {
    /// Notes the faces about the slave nodes of a pair.
    pub(super) fn add_slave_faces(&mut self, dofs: &DofMap, place: usize, pair: &ContactPair) {
        let first = self.slave_faces.len();
        self.first_faces.push(first);
        let corner = |&node: &NodeIndex| (node, [0.0; 3], dofs.translations(node));
        if pair.of_solids {
            let elements = pair.elements.iter().map(|element| element.nodes.iter().map(corner));
            let faces = elements.map(|own| SlaveFace { corners: own.collect(), parts: 1.0 });
            self.slave_faces.extend(faces);
        }
        let (faces, slaves) = (&pair.faces[..], &self.slave_nodes[place][..]);
        let slaves: HashSet<NodeIndex> =
            if faces.is_empty() { HashSet::new() } else { slaves.iter().copied().collect() };
        let mut of_node: HashMap<NodeIndex, Vec<usize>> = HashMap::new();
        for face in faces {
            let Some(cell) = face.cell() else { continue };
            let (corners, middles) = face.nodes.split_at(cell.faces.len());
            let parts = if middles.iter().any(|node| slaves.contains(node)) { 2.0 } else { 1.0 };
            let own = self.slave_faces.len();
            middles.iter().for_each(|node| of_node.entry(*node).or_default().push(own));
            self.slave_faces
                .push(SlaveFace { corners: corners.iter().map(corner).collect(), parts });
        }
        for (own, face) in self.slave_faces.iter().enumerate().skip(first) {
            for (node, ..) in &face.corners {
                of_node.entry(*node).or_default().push(own);
            }
        }
        for point in self.points.iter_mut().filter(|point| point.pair == place) {
            point.faces = of_node.get(&point.node).cloned().unwrap_or_default();
        }
    }

    /// Takes the positions of the faces of slave nodes, and which masters have sharp edges.
    pub(super) fn take_slave_faces(&mut self, model: &Model) {
        for (node, position, _) in self.slave_faces.iter_mut().flat_map(|face| &mut face.corners) {
            *position = model.nodes.get(*node).position;
        }
        let Self { masters, sharp, .. } = self;
        sharp.clear();
        sharp.extend(masters.iter().map(|master| match master {
            MasterSurface::Line { nodes, itself: None, .. } => {
                sharp::is_sharp(nodes.iter().map(|(at, _)| *at))
            }
            MasterSurface::Faces { mesh, itself: None, .. } => mesh.is_sharp(),
            MasterSurface::Body { surface, .. } => surface.is_sharp(),
            _ => false,
        }));
    }

    /// What the faces of a slave node look at; `None`: everywhere, where they are not known, and where
    /// its master has no sharp edge.
    #[inline]
    pub(super) fn outlook(&self, point: &SlavePoint, u: &[f64]) -> Option<Outlook> {
        (self.sharp[point.pair] && !point.faces.is_empty()).then(|| {
            let mut outlook = Outlook::EVERYWHERE;
            for &face in &point.faces {
                let (normal, size) = self.slave_faces[face].stands(u);
                outlook.add(normal, size);
            }
            outlook
        })
    }
}
