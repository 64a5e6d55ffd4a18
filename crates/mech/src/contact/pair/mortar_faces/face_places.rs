//! The nodes of a face in a configuration, and the planes of its pieces.

use super::places::{Place, add_scaled, cross, dot, scale, sub, zero};
use super::shapes::{MOST_NODES, Shapes, pieces, shapes};
use crate::differentiate::Real;

/// The nodes of a face in a configuration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FacePlaces<R> {
    /// Where they stand [L].
    pub nodes: [Place<R>; MOST_NODES],
    /// How many they are: 3, 4, 6 or 8.
    pub count: usize,
}

/// The plane of a piece.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plane<R> {
    /// Unit normal [1].
    pub normal: Place<R>,
    /// Length of the product of the sides [L2].
    size: R,
    sides: [Place<R>; 2],
}

impl<R: Real> FacePlaces<R> {
    /// A face of up to eight nodes.
    pub fn new(nodes: &[Place<R>]) -> Self {
        let at = |k: usize| nodes.get(k).copied().unwrap_or_else(zero);
        Self { nodes: std::array::from_fn(at), count: nodes.len().min(MOST_NODES) }
    }

    /// Nodes blended [L].
    pub(super) fn blend(&self, by: &[R; MOST_NODES]) -> Place<R> {
        let own = self.nodes[..self.count].iter().zip(by);
        own.fold(zero(), |sum, (&node, &by)| add_scaled(sum, by, node))
    }

    /// Its shape functions at a place of its cell.
    pub(super) fn shapes(&self, at: [R; 2]) -> Shapes<R> {
        shapes(self.count, at)
    }

    /// The same without derivatives.
    pub(super) fn values(&self) -> FacePlaces<f64> {
        let nodes = self.nodes.map(|node| node.map(|x| x.value()));
        FacePlaces { nodes, count: self.count }
    }

    /// The nodes at the corners of a piece.
    pub(super) fn piece(&self, piece: usize) -> FacePlaces<R> {
        let own = pieces(self.count)[piece];
        let at = |k: usize| own.get(k).map_or_else(zero, |&node| self.nodes[node]);
        FacePlaces { nodes: std::array::from_fn(at), count: own.len() }
    }

    /// The plane of a piece; `None` where it has collapsed.
    pub(super) fn plane(&self, piece: usize) -> Option<Plane<R>> {
        let [a, b, c, d] = ends(self.count, piece).map(|node| self.nodes[node]);
        let sides = [sub(b, a), sub(d, c)];
        let across = cross(sides[0], sides[1]);
        let size = dot(across, across).sqrt();
        let is_sound = size.value() > 0.0 && size.value().is_finite();
        let normal = scale(R::from_f64(1.0) / size, across);
        is_sound.then_some(Plane { normal, size, sides })
    }

    /// What a derivative by the normal of a piece is by its nodes, added.
    pub(super) fn pull_normal(
        &self,
        (piece, plane): (usize, &Plane<R>),
        by: Place<R>,
        into: &mut [Place<R>],
    ) {
        let along = dot(plane.normal, by);
        let one = R::from_f64(1.0);
        let by = scale(one / plane.size, add_scaled(by, -along, plane.normal));
        let [first, second] = plane.sides;
        let [a, b, c, d] = ends(self.count, piece);
        for (node, sign, force) in [
            (a, -one, cross(second, by)),
            (b, one, cross(second, by)),
            (c, -one, cross(by, first)),
            (d, one, cross(by, first)),
        ] {
            into[node] = add_scaled(into[node], sign, force);
        }
    }
}

impl FacePlaces<f64> {
    /// Unit normals of its pieces; none of one that has collapsed [1].
    pub fn normals(&self) -> impl Iterator<Item = Place<f64>> + '_ {
        (0..pieces(self.count).len()).filter_map(|piece| Some(self.plane(piece)?.normal))
    }
}

/// The nodes that two sides join whose product is along the normal of a piece: two edges of a
/// triangle, the diagonals of a quadrilateral.
fn ends(count: usize, piece: usize) -> [usize; 4] {
    match *pieces(count)[piece] {
        [a, b, c] => [a, b, a, c],
        [a, b, c, d] => [a, c, b, d],
        _ => [0; 4],
    }
}
