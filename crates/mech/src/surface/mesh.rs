//! Faces that meet at common nodes.
//!
//! ```text
//!    o-----o-----o
//!    |  f  |  g  |     across an edge: the neighbour
//!    o-----*-----o     round a node: the star, whose mean normal smooths both faces
//!    |     |     |     an edge that is SHARP stays one: stars end there
//!    o-----o-----o
//! ```
//!
//! Nodes are numbered within the mesh. An analytical surface has its charts for faces, all of them over
//! the four markers of its body.

use super::axes::{Bearing, axis, bearing_of_axis};
pub use super::edges::{MeshFace, SHARP, area_between, is_crease, nodes_at_ends, surface_ends};
use super::edges::{area, edge, ends, faces_around, middle, neighbours, normal};
use super::meridian::SweptPlace;
use super::mirror::Mirror;
use super::patch::{MOST_CORNERS, MOST_NODES, Patch};
use super::smoothing::{Round, Smoothing, group};
use super::star::{Star, StarNormal};
use super::swept::Swept;
use crate::axes::Axes;
use crate::element::cell::QUAD4;
use crate::vector::{Vector, add, cross, dot, scale, size, sub};

/// What follows from the way in which faces are joined.
#[derive(Debug, Clone)]
struct Joined {
    /// The face behind each edge, where there is one.
    neighbours: [Option<usize>; MOST_CORNERS],
    /// Faces that share a corner with it.
    around: Vec<usize>,
    /// Nodes that the face follows: its own ones, then those of its stars.
    stencil: Vec<usize>,
    /// The star at each corner, by places in the stencil; none where it is flat.
    stars: Vec<Round>,
    /// Edges in planes of symmetry.
    mirrored: [bool; MOST_CORNERS],
}

/// Faces with their neighbours.
#[derive(Debug, Clone)]
pub struct FaceMesh {
    faces: Vec<MeshFace>,
    joined: Vec<Joined>,
    swept: Option<Swept>,
    /// Whether two neighbours meet at a crease.
    is_sharp: bool,
    /// Edges of each face at which the surface ends or has a crease.
    ends: Vec<[bool; MOST_CORNERS]>,
    /// The nodes on these edges, in order.
    at_ends: Vec<usize>,
    /// Where friction has coefficients along the axes of the surface: how axis 1 stands to the first
    /// tangent in the middle of each face; empty else [1].
    axes: Vec<Bearing>,
    /// Whether it has such axes.
    is_directed: bool,
    /// Edges of each face that are drawn as they are; empty where none is smoothed.
    drawn: Vec<[bool; MOST_CORNERS]>,
    /// Normals of the planes of symmetry at which it ends [1].
    planes: Vec<Vector>,
    /// Mean length of the slave faces that may stand about its edges [L].
    pub slave: f64,
}

/// A smoothed face in its place, with the normals that smooth it.
#[derive(Debug, Clone)]
pub struct PlacedFace {
    /// Positions of its stencil [L].
    pub positions: Vec<Vector>,
    /// The normals at its corners; none where it is flat.
    pub normals: Vec<StarNormal>,
}

impl Joined {
    /// A face with what smooths its corners, by nodes of the mesh, without what it is joined with.
    fn new(face: &MeshFace, mut stars: Vec<Round>) -> Self {
        let mut stencil = face.nodes.clone();
        let mut local = |node: usize| {
            stencil.iter().position(|&own| own == node).unwrap_or_else(|| {
                stencil.push(node);
                stencil.len() - 1
            })
        };
        for corner in stars.iter_mut().flat_map(|star| &mut star.corners) {
            *corner = corner.map(&mut local);
        }
        let (neighbours, mirrored) = ([None; MOST_CORNERS], [false; MOST_CORNERS]);
        Self { neighbours, around: Vec::new(), stencil, stars, mirrored }
    }
}

impl FaceMesh {
    /// The faces with their neighbours; `reference` are the undeformed positions of the nodes [L].
    /// Faces of linear cells are smoothed where that is asked for.
    pub fn new(faces: Vec<MeshFace>, reference: &[Vector], smooth: bool) -> Self {
        Self::mirrored(faces, reference, (smooth, &[]))
    }

    /// The same of faces that go on as their images beyond planes of symmetry.
    pub fn mirrored(
        faces: Vec<MeshFace>,
        reference: &[Vector],
        (smooth, mirrors): (bool, &[Mirror]),
    ) -> Self {
        let (neighbours, around) = (neighbours(&faces), faces_around(&faces));
        let normals: Vec<_> =
            faces.iter().map(|face| normal(face, |node| reference[node])).collect();
        let joins = |a: usize, b: usize| !is_crease(normals[a], normals[b]);
        let behind = |face: usize| neighbours[face].iter().flatten().copied();
        let is_sharp = (0..faces.len()).any(|face| behind(face).any(|other| !joins(face, other)));
        let smoothing = smooth.then(|| Smoothing::new(&faces, reference, mirrors));
        let Smoothing { drawn, mut rounds } = smoothing.unwrap_or_default();
        let joined = (0..faces.len()).map(|own| {
            let (face, rounds) = (&faces[own], rounds.get_mut(own).map(std::mem::take));
            let mut new = Joined::new(face, rounds.unwrap_or_default());
            let corners = &face.nodes[..face.cell.faces.len()];
            new.neighbours = neighbours[own];
            new.around.extend(corners.iter().flat_map(|node| &around[node]).map(|&(face, _)| face));
            new.around.retain(|&face| face != own);
            new.around.sort_unstable();
            new.around.dedup();
            let is_in = |own| mirrors.iter().any(|mirror: &Mirror| mirror.has(edge(face, own)));
            new.mirrored = std::array::from_fn(|own| own < corners.len() && is_in(own));
            new
        });
        let joined = joined.collect();
        let ends = ends(&faces, &neighbours, joins);
        let at_ends = nodes_at_ends(&faces, &ends);
        let (axes, slave) = (Vec::new(), f64::INFINITY);
        let planes = mirrors.iter().map(|own| own.normal).collect();
        Self {
            faces,
            joined,
            swept: None,
            is_sharp,
            ends,
            at_ends,
            axes,
            is_directed: false,
            drawn,
            planes,
            slave,
        }
    }

    /// An analytical surface on the four markers of its body.
    pub fn analytical(swept: Swept) -> Self {
        let markers = || vec![0, 1, 2, 3];
        let face = || MeshFace { cell: &QUAD4, nodes: markers() };
        let charts = 0..swept.charts();
        Self {
            faces: charts.clone().map(|_| face()).collect(),
            joined: charts.map(|_| Joined::new(&face(), Vec::new())).collect(),
            swept: Some(swept),
            is_sharp: false,
            ends: Vec::new(),
            at_ends: Vec::new(),
            axes: Vec::new(),
            is_directed: false,
            drawn: Vec::new(),
            planes: Vec::new(),
            slave: f64::INFINITY,
        }
    }

    /// No direction of its faces is special any more.
    pub fn forget_axes(&mut self) {
        self.axes.clear();
        self.is_directed = false;
    }

    /// Notes the axes of its faces as they are undeformed, by the axes of space in their middles and the
    /// positions of its nodes [L]; those of an analytical surface are its profile and what stands across it.
    pub fn take_axes(&mut self, axes: impl Fn(Vector) -> Axes, position: impl Fn(usize) -> Vector) {
        self.is_directed = true;
        if self.swept.is_some() {
            return;
        }
        let of_face = |face: &MeshFace| {
            let nodes: Vec<Vector> = face.nodes.iter().map(|&node| position(node)).collect();
            let patch = Patch::new(face.cell, &nodes, None);
            let (tangents, normal) = patch.frame(&patch.place(patch.middle()))?;
            let middle = nodes.iter().fold([0.0; 3], |sum, &at| add(sum, at));
            let middle = scale(middle, 1.0 / nodes.len() as f64);
            Some(bearing_of_axis(axes(middle), tangents[0], normal))
        };
        self.axes = self.faces.iter().map(|face| of_face(face).unwrap_or([1.0, 0.0])).collect();
    }

    /// Axis 1 in the middle of a face that stands like this, where it was noted [1].
    pub fn axis(&self, face: usize, patch: &Patch) -> Option<Vector> {
        let bearing = *self.axes.get(face)?;
        let (tangents, normal) = patch.frame(&patch.place(patch.middle()))?;
        Some(axis(bearing, tangents[0], normal))
    }

    /// Axis 1 of a surface of revolution where a point stands that stood elsewhere `before`, where friction
    /// has coefficients along the axes and the profile has a direction [1].
    pub fn profile(
        &self,
        (markers, normal): (&[Vector], Vector),
        places: [SweptPlace; 2],
    ) -> Option<Vector> {
        let swept = self.swept.as_ref().filter(|_| self.is_directed)?;
        swept.profile_of_way((markers, normal), places)
    }

    /// Whether a place is in a pole, where axis 1 has no direction.
    pub fn is_pole(&self, place: SweptPlace) -> bool {
        self.is_directed && self.swept.as_ref().is_some_and(|swept| swept.is_pole(place))
    }

    /// The analytical surface that it is.
    pub fn swept(&self) -> Option<&Swept> {
        self.swept.as_ref()
    }

    /// The faces.
    pub fn faces(&self) -> &[MeshFace] {
        &self.faces
    }

    /// The face behind an edge of a face.
    pub fn neighbour(&self, face: usize, edge: usize) -> Option<usize> {
        self.joined[face].neighbours[edge]
    }

    /// At which edges of a face the surface ends or has a crease.
    pub fn ends(&self, face: usize) -> [bool; MOST_CORNERS] {
        self.ends.get(face).copied().unwrap_or_default()
    }

    /// Whether the surface ends or has a crease at a node.
    pub fn is_at_end(&self, node: usize) -> bool {
        self.at_ends.binary_search(&node).is_ok()
    }

    /// Unit normal of a face between its corners [1]; zero of one without area.
    pub fn normal(&self, face: usize, positions: &[Vector]) -> Vector {
        normal(&self.faces[face], |node| positions[node])
    }

    /// The middle of the corners of a face [L].
    pub fn middle(&self, face: usize, positions: &[Vector]) -> Vector {
        middle(&self.faces[face], |node| positions[node])
    }

    /// Whether a face and a neighbour of it meet at a crease that stands out.
    pub fn stands_out(&self, face: usize, other: usize, positions: &[Vector]) -> bool {
        let normal = self.normal(face, positions);
        is_crease(normal, self.normal(other, positions)) && self.turns_away(face, other, positions)
    }

    /// Whether a neighbour of a face lies behind it.
    pub fn turns_away(&self, face: usize, other: usize, positions: &[Vector]) -> bool {
        let aside = sub(self.middle(other, positions), self.middle(face, positions));
        dot(aside, self.normal(face, positions)) < 0.0
    }

    /// Size of a face: the root of its area [L].
    pub fn size(&self, face: usize, positions: &[Vector]) -> f64 {
        size(area(&self.faces[face], |node| positions[node])).sqrt()
    }

    /// How far a face reaches from an edge of it: between the middles of two opposite edges, or the height of a
    /// triangle [L].
    pub fn across(&self, face: usize, own: usize, positions: &[Vector]) -> f64 {
        let [a, b] = edge(&self.faces[face], own).map(|node| positions[node]);
        let (along, aside) = (sub(b, a), sub(self.middle(face, positions), a));
        let parts = if self.faces[face].cell.faces.len() == 3 { 3.0 } else { 2.0 };
        parts * size(cross(along, aside)) / size(along)
    }

    /// Whether some neighbours meet at a crease.
    pub fn is_sharp(&self) -> bool {
        self.is_sharp
    }

    /// Whether a face and the one behind an edge have one normal there.
    pub fn is_smoothed_at(&self, face: usize, edge: usize) -> bool {
        let apart = |of: &[[bool; MOST_CORNERS]]| of.get(face).is_some_and(|edges| edges[edge]);
        !self.joined[face].stars.is_empty() && !apart(&self.ends) && !apart(&self.drawn)
    }

    /// Whether its faces follow the same nodes as those of another one.
    pub fn follows_as(&self, other: &Self) -> bool {
        let mut both = self.joined.iter().zip(&other.joined);
        self.joined.len() == other.joined.len()
            && both.all(|(one, other)| one.stencil == other.stencil)
    }

    /// Normals of the planes of symmetry at which it ends [1].
    pub fn planes(&self) -> &[Vector] {
        &self.planes
    }

    /// Whether a face goes on as its image beyond an edge.
    pub fn is_mirrored(&self, face: usize, edge: usize) -> bool {
        self.joined[face].mirrored[edge]
    }

    /// Faces that share a corner with a face.
    pub fn around(&self, face: usize) -> &[usize] {
        &self.joined[face].around
    }

    /// Nodes that a face follows, its own ones first.
    pub fn stencil(&self, face: usize) -> &[usize] {
        &self.joined[face].stencil
    }

    /// The longest stencil.
    pub fn longest_stencil(&self) -> usize {
        self.joined.iter().map(|joined| joined.stencil.len()).max().unwrap_or(0)
    }

    /// The star at a corner of a face, over its stencil.
    pub fn star(&self, face: usize, corner: usize) -> Star<'_> {
        let Round { corners, across } = &self.joined[face].stars[corner];
        Star { node: corner, corners, across }
    }

    /// A face where the nodes stand now; `None` where a normal of it vanishes.
    pub fn place(&self, face: usize, positions: &[Vector], into: &mut PlacedFace) -> Option<Patch> {
        let joined = &self.joined[face];
        into.positions.clear();
        into.positions.extend(joined.stencil.iter().map(|&node| positions[node]));
        into.normals.clear();
        let mut normals = [[0.0; 3]; MOST_CORNERS];
        for (corner, normal) in (0..joined.stars.len()).zip(&mut normals) {
            let own = self.star(face, corner).normal(&into.positions)?;
            *normal = own.normal;
            into.normals.push(own);
        }
        if let Some(swept) = &self.swept {
            return Some(Patch::on_markers(swept.chart(face), &into.positions));
        }
        let own = &self.faces[face];
        let nodes = &into.positions[..own.nodes.len().min(MOST_NODES)];
        let smooth = !joined.stars.is_empty();
        Some(Patch::new(own.cell, nodes, smooth.then_some(&normals[..own.cell.faces.len()])))
    }
}

impl PlacedFace {
    /// Room for a face.
    pub const EMPTY: Self = Self { positions: Vec::new(), normals: Vec::new() };
}

/// Which faces belong together at each corner of each face, no crease between them: the lowest one
/// of them. `position` gives undeformed positions of nodes [L].
pub fn smooth_groups(
    faces: &[MeshFace],
    position: impl Fn(usize) -> Vector,
) -> Vec<[usize; MOST_CORNERS]> {
    let neighbours = neighbours(faces);
    let around = faces_around(faces);
    let normals: Vec<_> = faces.iter().map(|face| normal(face, &position)).collect();
    let joins = |a: usize, _: usize, b: usize| !is_crease(normals[a], normals[b]);
    let lowest = |face: usize, corner: usize| {
        let at = &around[&faces[face].nodes[corner]];
        group(face, at, &neighbours, joins).into_iter().min().unwrap_or(face)
    };
    let of_face = |(place, face): (usize, &MeshFace)| {
        let corners = face.cell.faces.len();
        std::array::from_fn(|corner| if corner < corners { lowest(place, corner) } else { place })
    };
    faces.iter().enumerate().map(of_face).collect()
}
