//! What continues a chain of master nodes beyond its ends: a ring its other end, a chain that ends in a plane of symmetry
//! its image.
//!
//! ```text
//!    4 5 6 [0 1 2 3 4 5 6 0] 1 2 3       a ring: some nodes stand in the list twice
//!    3'2'1'[0 1 2 3 4 . . .              an end in a plane of symmetry: an image follows its node and that in the plane
//! ```
//!
//! docs/theory.md section 5.3.

use crate::dofs::Translations;
use slideline_mech::rigid::{Attachment, PointMap};
use slideline_mech::surface::mirror::image;
use slideline_mech::vector::{dot, size, sub};
use slideline_model::SymmetryPlane;
use std::ops::Range;

/// Nodes that continue a chain at an end: curves at a node follow its second neighbours, and what these turn.
const CONTINUED: usize = 4;

/// A node of a chain: its undeformed position [L], and its dofs.
pub type ChainNode = ([f64; 3], Translations);

/// Which nodes of a list continue a chain.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Beyond {
    /// How many stand before its first node, and behind its last one.
    pub counts: [usize; 2],
    /// The normals of the planes of symmetry in which its ends lie, where they do [1].
    normals: Vec<([f64; 3], End)>,
}

/// An end of a chain.
#[derive(Clone, Copy, Debug, PartialEq)]
enum End {
    First,
    Last,
}

impl Beyond {
    /// Continues a ring, or a chain that ends in one of the planes; the room of other chains stays as it is.
    pub fn continued(nodes: &mut Vec<ChainNode>, is_ring: bool, planes: &[SymmetryPlane]) -> Self {
        let segments = nodes.len().saturating_sub(1);
        let count = CONTINUED.min(segments);
        let mut all = Self::default();
        if is_ring {
            let before = nodes[segments - count..segments].to_vec();
            let behind = nodes[1..=count].to_vec();
            nodes.splice(0..0, before);
            nodes.extend(behind);
            all.counts = [count; 2];
            return all;
        }
        if planes.is_empty() {
            return all;
        }
        let images = |own: &[ChainNode], normal| -> Vec<ChainNode> {
            let through = own[0].0;
            own[1..=count].iter().map(|&(at, dofs)| (image(at, (normal, through)), dofs)).collect()
        };
        let mut turned: Vec<ChainNode> = nodes.iter().rev().copied().collect();
        if let Some(normal) = plane_at(&turned, planes) {
            nodes.extend(images(&turned, normal));
            all.counts[1] = count;
            all.normals.push((normal, End::Last));
        }
        turned.reverse();
        if let Some(normal) = plane_at(&turned, planes) {
            let mut before = images(&turned, normal);
            before.reverse();
            nodes.splice(0..0, before);
            all.counts[0] = count;
            all.normals.push((normal, End::First));
        }
        all
    }

    /// The places of the chain's own nodes in the list of so many.
    pub fn own(&self, nodes: usize) -> Range<usize> {
        self.counts[0]..nodes - self.counts[1]
    }

    /// Normals of the planes of symmetry beyond which there are images [1].
    pub fn normals(&self) -> impl ExactSizeIterator<Item = [f64; 3]> + '_ {
        self.normals.iter().map(|(normal, _)| *normal)
    }

    /// What an image stands for in the list of so many nodes: the place of its node, that of the one in the plane, and the
    /// normal of that.
    fn image_at(&self, place: usize, nodes: usize) -> Option<(usize, usize, [f64; 3])> {
        let (first, last) = (self.counts[0], nodes - 1 - self.counts[1]);
        self.normals.iter().find_map(|&(normal, end)| match end {
            End::First if place < first => Some((2 * first - place, first, normal)),
            End::Last if place > last => Some((2 * last - place, last, normal)),
            _ => None,
        })
    }

    /// Which segment of the chain itself, from zero on, one of the list is or stands for.
    pub fn own_segment(&self, segment: usize, nodes: usize) -> usize {
        let (first, count) = (self.counts[0], nodes - 1 - self.counts[0] - self.counts[1]);
        if self.normals.is_empty() {
            return (segment + count - first % count) % count;
        }
        match (segment < first, segment >= first + count) {
            (true, _) => first - 1 - segment,
            (_, true) => 2 * count - 1 - (segment - first),
            _ => segment - first,
        }
    }

    /// Where all nodes stand, as they follow the displacements `u` [L].
    pub fn place(&self, nodes: &[ChainNode], u: &[f64], into: &mut Vec<[f64; 3]>) {
        let begin = into.len();
        into.extend(nodes.iter().map(|(at, dofs)| dofs.displace(*at, u)));
        if self.normals.is_empty() {
            return;
        }
        for place in 0..nodes.len() {
            if let Some((node, rim, normal)) = self.image_at(place, nodes.len()) {
                into[begin + place] = image(into[begin + node], (normal, into[begin + rim]));
            }
        }
    }

    /// How a node of the list follows dofs, by the places at which `follow` puts those of nodes.
    pub fn attachment(
        &self,
        (place, nodes): (usize, usize),
        mut follow: impl FnMut(usize) -> usize,
    ) -> Attachment {
        match self.image_at(place, nodes) {
            None => Attachment::Point { map: PointMap::Free, first: follow(place) },
            Some((node, rim, [x, y, _])) => {
                let (node, plane) = (follow(node), follow(rim));
                Attachment::Image { normal: [x, y], node, plane }
            }
        }
    }

    /// The nodes in the planes that images among some nodes of the list follow.
    pub fn rims(&self, part: Range<usize>, nodes: usize) -> impl Iterator<Item = usize> + '_ {
        let (first, last) = (self.counts[0], nodes - 1 - self.counts[1]);
        self.normals.iter().filter_map(move |(_, end)| match end {
            End::First => (part.start < first).then_some(first),
            End::Last => (part.end > last + 1).then_some(last),
        })
    }
}

/// The normal of the plane in which the first of these nodes lies, and the second one does not.
fn plane_at(nodes: &[ChainNode], planes: &[SymmetryPlane]) -> Option<[f64; 3]> {
    let (&(first, _), &(second, _)) = (nodes.first()?, nodes.get(1)?);
    let way = sub(second, first);
    let across = |plane: &&SymmetryPlane| (dot(plane.normal, way) / size(way)).abs();
    let ends = planes.iter().filter(|plane| plane.holds(first) && !plane.holds(second));
    let found = ends.max_by(|a, b| across(a).total_cmp(&across(b)))?;
    Some(found.normal)
}
