//! Nodes of sharp edges, and the side of a pair that they meet.

use crate::contact::ContactPair;
use crate::left_out::LeftOut;
use crate::node::NodeIndex;
use crate::surface::{ContactFace, Master};

/// Nodes of sharp edges on one side of a pair, and what they meet.
#[derive(Clone, Debug, PartialEq)]
pub struct EdgePair {
    /// Place of the pair.
    pub of: usize,
    /// The nodes.
    pub nodes: Vec<NodeIndex>,
    /// Whether they are of the master, and meet the slave surface; or else of the slave, and meet the master.
    pub is_of_master: bool,
    /// What they meet, as nodes meet it.
    pub met: Master,
    /// Faces of both sides that do not meet one another; the slave's are those about the nodes.
    pub left_out: Vec<LeftOut>,
}

impl EdgePair {
    /// What they meet where it goes on beyond planes of symmetry: faces of space.
    pub fn met_in_space(&self) -> Option<&Master> {
        matches!(self.met, Master::Faces(_)).then_some(&self.met)
    }

    /// The faces of the surface of its pair that its nodes belong to, by their corners and their middle nodes: in the plane
    /// with the material on the left, in space counter-clockwise as seen from outside.
    pub fn own_faces(&self, pair: &ContactPair) -> Vec<[Vec<NodeIndex>; 2]> {
        let parts = |face: &ContactFace| {
            let (corners, middles) = face.nodes.split_at(face.cell()?.faces.len());
            Some([corners.to_vec(), middles.to_vec()])
        };
        match (self.is_of_master, &pair.master) {
            (false, _) if pair.faces.is_empty() => {
                pair.elements.iter().map(|element| [element.nodes.to_vec(), Vec::new()]).collect()
            }
            (false, _) => pair.faces.iter().filter_map(parts).collect(),
            (true, Master::SlideLine(line)) => {
                line.nodes.windows(2).map(|own| [vec![own[1], own[0]], Vec::new()]).collect()
            }
            (true, Master::Faces(faces)) => faces.faces.iter().filter_map(parts).collect(),
            (true, Master::RigidSurface(_) | Master::Itself(_)) => Vec::new(),
        }
    }
}
