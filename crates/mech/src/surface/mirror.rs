//! A surface that ends in planes of symmetry, with its mirror images beyond them.
//!
//! ```text
//!      o-----o-----|- - -o - - -o     a node in the plane has the normal of its faces and of their mirror images:
//!      |  f  |  g  |  g'    f'  |     what these have across the plane cancels
//!      o-----o-----|- - -o - - -o
//! ```
//!
//! docs/theory.md section 5.9. (derived)

use super::edges::MeshFace;
use crate::vector::{Vector, dot, scale, size, sub};

/// Part of a vector below which nothing is left of it [1].
const NOTHING: f64 = 1e-6;

/// Cosine of the angle up to which two planes are across one another [1]: decks are written with a few digits.
const RIGHT: f64 = 1e-4;

/// A plane of symmetry at which a surface ends.
#[derive(Debug, Clone, PartialEq)]
pub struct Mirror {
    /// Its unit normal [1].
    pub normal: Vector,
    /// Which nodes of the surface lie in it.
    pub inside: Vec<bool>,
}

impl Mirror {
    /// Whether an edge lies in it.
    pub fn has(&self, [a, b]: [usize; 2]) -> bool {
        self.inside[a] && self.inside[b]
    }
}

/// The image of a place in the plane with that unit normal through another place [L].
pub fn image(at: Vector, (normal, through): (Vector, Vector)) -> Vector {
    sub(at, scale(normal, 2.0 * dot(normal, sub(at, through))))
}

/// Faces with their images in mirrors: those of each mirror stand behind all faces before, so that a bit of the number
/// of a copy says in which ones it was reflected.
pub(super) struct Reflected {
    pub faces: Vec<MeshFace>,
    pub positions: Vec<Vector>,
    /// Number of the faces themselves.
    own: usize,
    /// The mirrors that nodes of the surface lie in.
    normals: Vec<Vector>,
}

impl Reflected {
    /// The images of faces at their undeformed positions [L].
    pub fn new(faces: &[MeshFace], positions: &[Vector], mirrors: &[Mirror]) -> Self {
        let (faces, positions) = (faces.to_vec(), positions.to_vec());
        let mut all = Self { own: faces.len(), faces, positions, normals: Vec::new() };
        let mut inside: Vec<Vec<bool>> = mirrors.iter().map(|own| own.inside.clone()).collect();
        for (place, mirror) in mirrors.iter().enumerate() {
            let Some(through) = inside[place].iter().position(|is_inside| *is_inside) else {
                continue;
            };
            let copies = all.reflect((mirror.normal, through), &inside[place]);
            for (own, other) in inside.iter_mut().zip(mirrors) {
                // an image lies in another plane with its node where both planes are across one another
                let is_across = dot(mirror.normal, other.normal).abs() <= RIGHT;
                let images = copies.iter().map(|&node| is_across && own[node]).collect::<Vec<_>>();
                own.extend(images);
            }
        }
        all
    }

    /// Adds the image of all in the plane through a node; which nodes have a new one, in its order.
    fn reflect(&mut self, (normal, through): (Vector, usize), inside: &[bool]) -> Vec<usize> {
        let plane = (normal, self.positions[through]);
        let mut of_node: Vec<usize> = (0..self.positions.len()).collect();
        let mut copies = Vec::new();
        for node in (0..of_node.len()).filter(|&node| !inside[node]) {
            of_node[node] = self.positions.len();
            self.positions.push(image(self.positions[node], plane));
            copies.push(node);
        }
        let turned = |face: &MeshFace| {
            // the other way round: the outside stays outside
            let (corners, middles) = face.nodes.split_at(face.cell.faces.len());
            let first = corners[..1].iter().chain(corners[1..].iter().rev());
            let nodes = first.chain(middles.iter().rev()).map(|&node| of_node[node]).collect();
            MeshFace { cell: face.cell, nodes }
        };
        let images: Vec<MeshFace> = self.faces.iter().map(turned).collect();
        self.faces.extend(images);
        self.normals.push(normal);
        copies
    }

    /// Whether a face is an image.
    pub fn is_image(&self, face: usize) -> bool {
        face >= self.own
    }

    /// Unit vectors across one another that span the normals of the mirrors in which some of these faces are images.
    pub fn crossed(&self, faces: &[usize]) -> Vec<Vector> {
        let mut found: Vec<Vector> = Vec::new();
        for (bit, &normal) in self.normals.iter().enumerate() {
            if faces.iter().any(|face| (face / self.own) >> bit & 1 == 1) {
                let left = across(normal, &found);
                let rest = size(left);
                if rest > NOTHING {
                    found.push(scale(left, 1.0 / rest));
                }
            }
        }
        found
    }
}

/// What a vector has across directions that are across one another.
pub fn across(vector: Vector, directions: &[Vector]) -> Vector {
    directions.iter().fold(vector, |left, own| sub(left, scale(*own, dot(left, *own))))
}

#[cfg(test)]
mod tests;
