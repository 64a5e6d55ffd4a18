//! Whether a way from a node of a surface leads into its part.
//!
//! ```text
//!            |  part                  the node stands in a valley on one side and on an edge on the other:
//!      ______o______    way           what of the fan of its faces is nearest to a place on the way tells
//!     /     /  `-._                   on which side of it that is
//!    /_____/       `->
//! ```
//!
//! The normal at an edge is the mean of both faces', at the node itself the mean by the angles of the faces there: the sign is right
//! for every fan that closes. docs/theory.md section 5.12, [baerentzen2005]

use super::super::faces::nearest_of_triangle;
use crate::surface::mesh::{FaceMesh, MeshFace};
use crate::vector::{Vector, add, cross, dot, scale, size, sub};

/// How far on the way is asked, by the shortest edge at the node [1]. (choice)
const STEP: f64 = 1e-3;
/// Distances that are the same, by that length [1].
const SAME: f64 = 1e-6;

/// Whether a way from an undeformed node with these faces leads into their part, or along a face of it.
pub(super) fn leads_in(
    (mesh, reference): (&FaceMesh, &[Vector]),
    (node, faces): (usize, &[usize]),
    way: Vector,
) -> bool {
    let from = reference[node];
    let fan = || faces.iter().flat_map(|&face| triangles_at(&mesh.faces()[face], node));
    let edges = fan().flatten().map(|other| size(sub(reference[other], from)));
    let shortest = edges.fold(f64::INFINITY, f64::min);
    let step = STEP * shortest;
    let place = add(from, scale(way, step / size(way)));
    let (mut least, mut normal, mut by_angles) = (f64::INFINITY, [0.0; 3], [0.0; 3]);
    for [second, third] in fan() {
        let corners = [from, reference[second], reference[third]];
        let distance = nearest_of_triangle(corners, place).0.sqrt();
        let (one, other) = (sub(corners[1], from), sub(corners[2], from));
        let area = cross(one, other);
        if area == [0.0; 3] {
            continue;
        }
        let unit = scale(area, 1.0 / size(area));
        by_angles = add(by_angles, scale(unit, size(area).atan2(dot(one, other))));
        if distance < least - SAME * step {
            normal = unit;
        } else if distance <= least + SAME * step {
            normal = add(normal, unit);
        }
        least = least.min(distance);
    }
    // nothing of the fan is nearer than the node
    if least >= (1.0 - SAME) * step {
        normal = by_angles;
    }
    dot(normal, way) <= SAME * size(way)
}

/// The triangles from a node of a face, a corner or the middle of an edge, to its other corners: those two of each, in their order.
fn triangles_at(face: &MeshFace, node: usize) -> impl Iterator<Item = [usize; 2]> + '_ {
    let corners = face.cell.faces.len();
    let place = face.nodes.iter().position(|&own| own == node);
    let (first, count) = match place {
        Some(place) if place < corners => (place + 1, corners - 1),
        Some(place) => (place - corners + 1, corners),
        None => (0, 1),
    };
    let other = move |k: usize| face.nodes[(first + k) % corners];
    (1..count).map(move |k| [other(k - 1), other(k)])
}
