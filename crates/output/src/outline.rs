//! What viewers draw of a model: pieces of elements, slave surfaces, and rigid
//! surfaces as chains of points that move with their bodies.
//!
//! ```text
//!   o---o---o---o    pieces between nodes
//!      .---.
//!     (  x  )        chords; x: the node that carries them
//! ```

use slideline_model::{
    ContactPair, Dof, ElementIndex, Kinematics, Model, NodeIndex, Presence, ProfilePoint,
    RigidSurface, SurfaceSegment,
};
use slideline_results::NodeField;
use slideline_results::element::regions;
use slideline_solve::observe::Frame;
use std::collections::HashMap;

/// Chords of an arc or parabola per segment; at most 7.5 degrees of arc.
const CHORDS: u32 = 24;
/// The axes of space.
pub(crate) const SPACE: [Dof; 3] = [Dof::U1, Dof::U2, Dof::U3];

/// What a piece stands for, as files number it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Beam = 0,
    Spring = 1,
    SlaveSurface = 2,
    RigidSurface = 3,
    Solid = 4,
}

/// What of a model a piece belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Owner {
    Element(ElementIndex),
    /// A contact pair, by its place in the model.
    Pair(usize),
    /// A body that is always there.
    Body,
}

impl Owner {
    /// Whether it is there in a step.
    pub fn is_there(self, presence: &Presence) -> bool {
        match self {
            Self::Element(own) => presence.has(own),
            Self::Pair(pair) => presence.has_pair(pair),
            Self::Body => true,
        }
    }
}

/// A piece between points.
pub(crate) struct Piece {
    pub kind: Kind,
    pub owner: Owner,
    /// Number of its element; 0 for a rigid surface.
    pub label: u64,
    /// Its type and its places among the points, as VTK numbers them.
    pub vtk: (u8, Vec<usize>),
    /// The same as CalculiX numbers them.
    pub frd: (u8, Vec<usize>),
}

impl Piece {
    /// All curves are lines (some readers know no poly-lines).
    fn line((kind, owner): (Kind, Owner), label: u64, points: [usize; 2]) -> Self {
        Self { kind, owner, label, vtk: (3, points.to_vec()), frd: (11, points.to_vec()) }
    }
}

/// The edges of a cell by its type, each from corner to corner through its middle if it has one.
/// [VTK file formats: cell types, numbering of nodes]
pub(crate) fn edges(vtk: u8) -> &'static [&'static [usize]] {
    match vtk {
        3 => &[&[0, 1]],
        5 => &[&[0, 1], &[1, 2], &[2, 0]],
        9 => &[&[0, 1], &[1, 2], &[2, 3], &[3, 0]],
        10 => &[&[0, 1], &[1, 2], &[2, 0], &[0, 3], &[1, 3], &[2, 3]],
        12 => &[
            &[0, 1],
            &[1, 2],
            &[2, 3],
            &[3, 0],
            &[4, 5],
            &[5, 6],
            &[6, 7],
            &[7, 4],
            &[0, 4],
            &[1, 5],
            &[2, 6],
            &[3, 7],
        ],
        13 => &[&[0, 1], &[1, 2], &[2, 0], &[3, 4], &[4, 5], &[5, 3], &[0, 3], &[1, 4], &[2, 5]],
        22 => &[&[0, 3, 1], &[1, 4, 2], &[2, 5, 0]],
        23 => &[&[0, 4, 1], &[1, 5, 2], &[2, 6, 3], &[3, 7, 0]],
        24 => &[&[0, 4, 1], &[1, 5, 2], &[2, 6, 0], &[0, 7, 3], &[1, 8, 3], &[2, 9, 3]],
        25 => &[
            &[0, 8, 1],
            &[1, 9, 2],
            &[2, 10, 3],
            &[3, 11, 0],
            &[4, 12, 5],
            &[5, 13, 6],
            &[6, 14, 7],
            &[7, 15, 4],
            &[0, 16, 4],
            &[1, 17, 5],
            &[2, 18, 6],
            &[3, 19, 7],
        ],
        26 => &[
            &[0, 6, 1],
            &[1, 7, 2],
            &[2, 8, 0],
            &[3, 9, 4],
            &[4, 10, 5],
            &[5, 11, 3],
            &[0, 12, 3],
            &[1, 13, 4],
            &[2, 14, 5],
        ],
        _ => &[],
    }
}

/// A rigid surface as a chain of points, undeformed.
struct Outline {
    /// The node that carries it.
    reference: NodeIndex,
    points: Vec<ProfilePoint>,
}

/// What viewers draw. Points are the nodes of the model, then copies of those
/// where solids of several sections meet, then those of rigid surfaces.
#[derive(Default)]
pub(crate) struct Drawing {
    /// Of every block the block that stands for its section, and the copies of
    /// nodes that its solids have.
    regions: Vec<usize>,
    copy_of: HashMap<(usize, NodeIndex), usize>,
    copies: Vec<NodeIndex>,
    pub pieces: Vec<Piece>,
    /// Numbers of the points: those of the nodes, larger ones behind them.
    pub labels: Vec<u64>,
    outlines: Vec<Outline>,
}

impl Drawing {
    /// That of a model: its blocks, then slave and rigid surfaces pair by pair.
    pub fn of(model: &Model) -> Self {
        Self::new(model, vec![0; model.blocks.len()])
    }

    /// The same with a copy of a node for every further section of solids that meet
    /// there: stresses jump over such a border.
    pub fn split(model: &Model) -> Self {
        Self::new(model, regions(model))
    }

    fn new(model: &Model, regions: Vec<usize>) -> Self {
        let (copy_of, copies) = copies(model, &regions);
        let mut pieces = Vec::new();
        for (number, block) in model.blocks.iter().enumerate() {
            let point =
                |node: NodeIndex| copy_of.get(&(regions[number], node)).copied().unwrap_or(node);
            let kind = match block.kind.kinematics {
                Kinematics::Beam { .. } | Kinematics::SpaceBeam => Kind::Beam,
                Kinematics::Spring | Kinematics::Gap => Kind::Spring,
                Kinematics::Solid { .. } | Kinematics::Truss | Kinematics::Other => Kind::Solid,
            };
            for (member, element) in block.elements.iter().enumerate() {
                let owner = Owner::Element((number, member));
                pieces.extend(block.kind.cell.pieces.iter().map(|piece| {
                    let of = |places: &[usize]| {
                        places.iter().map(|&p| point(element.nodes[p])).collect()
                    };
                    let vtk = (piece.vtk, of(piece.nodes));
                    let frd = (piece.frd, of(piece.frd_nodes));
                    Piece { kind, owner, label: element.label, vtk, frd }
                }));
            }
        }
        for (place, pair) in model.contact_pairs.iter().enumerate() {
            let own = (Kind::SlaveSurface, Owner::Pair(place));
            let elements = pair.elements.iter();
            pieces.extend(elements.map(|element| Piece::line(own, element.label, element.nodes)));
        }
        let outlines = outlines(model);
        let mut labels: Vec<u64> = model.nodes.iter().map(|node| node.label).collect();
        let mut next = labels.iter().max().unwrap_or(&0) + 1;
        labels.extend(copies.iter().map(|&node| model.nodes.label(node)));
        for outline in &outlines {
            let (begin, end) = (labels.len(), next + outline.points.len() as u64);
            labels.extend(next..end);
            next = end;
            let chords = (begin + 1..labels.len()).map(|end| [end - 1, end]);
            let own = (Kind::RigidSurface, Owner::Body);
            pieces.extend(chords.map(|ends| Piece::line(own, 0, ends)));
        }
        Self { regions, copy_of, copies, pieces, labels, outlines }
    }

    /// The point that a block has for a node.
    pub fn point(&self, block: usize, node: NodeIndex) -> usize {
        let region = self.regions.get(block).copied().unwrap_or_default();
        self.copy_of.get(&(region, node)).copied().unwrap_or(node)
    }

    /// The points of the nodes that were copied, with those nodes.
    pub fn copies(&self, nodes: usize) -> impl Iterator<Item = (usize, NodeIndex)> {
        self.copies.iter().enumerate().map(move |(copy, &node)| (nodes + copy, node))
    }

    /// Three values of every node, then those of the copies.
    fn with_copies(&self, mut values: Vec<f64>) -> Vec<f64> {
        for &node in &self.copies {
            values.extend_from_within(3 * node..3 * node + 3);
        }
        values
    }

    /// Undeformed positions of all points [L].
    pub fn still(&self, model: &Model) -> impl Iterator<Item = [f64; 3]> {
        let chains = self.outlines.iter().flat_map(|outline| &outline.points);
        let copies = self.copies.iter().map(|&node| model.nodes.position(node));
        let nodes = model.nodes.iter().map(|node| node.position).chain(copies);
        nodes.chain(chains.map(|&[x, y]| [x, y, 0.0]))
    }

    /// Current positions and displacements of all points, x, y, z of each [L].
    pub fn moved(&self, frame: &Frame<'_>) -> [Vec<f64>; 2] {
        let [mut points, mut displacement] = [NodeField::Coordinate, NodeField::Motion]
            .map(|field| self.with_copies(field.table(frame, &SPACE)));
        for outline in &self.outlines {
            for &point in &outline.points {
                let moved = outline.carried(frame, point);
                points.extend([moved[0], moved[1], 0.0]);
                displacement.extend([moved[0] - point[0], moved[1] - point[1], 0.0]);
            }
        }
        [points, displacement]
    }

    /// How many of the points are those of rigid surfaces, behind all others.
    pub fn outline_points(&self) -> usize {
        self.outlines.iter().map(|outline| outline.points.len()).sum()
    }

    /// Three values of every node at all points; zero on rigid surfaces.
    pub fn values(&self, of_nodes: Vec<f64>) -> Vec<f64> {
        let mut values = self.with_copies(of_nodes);
        values.resize(3 * self.labels.len(), 0.0);
        values
    }
}

/// For nodes of solids of several regions: the first one keeps the node, others have
/// copies behind all nodes; by region and node, and the nodes copied.
fn copies(
    model: &Model,
    regions: &[usize],
) -> (HashMap<(usize, NodeIndex), usize>, Vec<NodeIndex>) {
    let (mut copy_of, mut copies) = (HashMap::new(), Vec::new());
    let mut first: Vec<Option<usize>> = vec![None; model.nodes.len()];
    for (block, &region) in model.blocks.iter().zip(regions) {
        if !matches!(block.kind.kinematics, Kinematics::Solid { .. } | Kinematics::Other) {
            continue;
        }
        for &node in block.elements.iter().flat_map(|element| element.nodes) {
            if *first[node].get_or_insert(region) != region {
                copy_of.entry((region, node)).or_insert_with(|| {
                    copies.push(node);
                    model.nodes.len() + copies.len() - 1
                });
            }
        }
    }
    (copy_of, copies)
}

/// The outlines of a model, in the order of its contact pairs.
fn outlines(model: &Model) -> Vec<Outline> {
    let surfaces = model.contact_pairs.iter().flat_map(ContactPair::rigid_surfaces);
    surfaces.map(outline).collect()
}

/// Undeformed points of a rigid surface, its arcs in chords [L].
pub fn profile(surface: &RigidSurface) -> Vec<ProfilePoint> {
    outline(surface).points
}

/// Undeformed points of every rigid surface [L].
pub(crate) fn chains(model: &Model) -> impl Iterator<Item = Vec<ProfilePoint>> {
    outlines(model).into_iter().map(|outline| outline.points)
}

impl Outline {
    /// Where one of its points is: x = x_ref + R(phi) (X - X_ref).
    /// [semantics: segments of a rigid surface]
    fn carried(&self, frame: &Frame<'_>, point: ProfilePoint) -> ProfilePoint {
        let reference = self.reference;
        let origin = frame.model.nodes.position(reference);
        let moved = |dof| frame.nodal.displacement(reference, dof);
        let (sine, cosine) = moved(Dof::UR3).sin_cos();
        let arm = [point[0] - origin[0], point[1] - origin[1]];
        [
            origin[0] + moved(Dof::U1) + cosine * arm[0] - sine * arm[1],
            origin[1] + moved(Dof::U2) + sine * arm[0] + cosine * arm[1],
        ]
    }
}

fn outline(surface: &RigidSurface) -> Outline {
    let mut points = vec![surface.start];
    let mut at = surface.start;
    for segment in &surface.segments {
        at = match *segment {
            SurfaceSegment::Line { end } => {
                points.push(end);
                end
            }
            SurfaceSegment::Circle { end, centre } => {
                push_arc(&mut points, at, end, centre);
                end
            }
            SurfaceSegment::Parabola { middle, end } => {
                push_parabola(&mut points, [at, middle, end]);
                end
            }
        };
    }
    Outline { reference: surface.reference, points }
}

/// The shorter arc from `from` to `end`.
fn push_arc(
    points: &mut Vec<ProfilePoint>,
    from: ProfilePoint,
    end: ProfilePoint,
    centre: ProfilePoint,
) {
    let arm = [from[0] - centre[0], from[1] - centre[1]];
    let last = [end[0] - centre[0], end[1] - centre[1]];
    let turn = (arm[0] * last[1] - arm[1] * last[0]).atan2(arm[0] * last[0] + arm[1] * last[1]);
    for chord in 1..CHORDS {
        let (sine, cosine) = (turn * f64::from(chord) / f64::from(CHORDS)).sin_cos();
        points.push([
            centre[0] + cosine * arm[0] - sine * arm[1],
            centre[1] + sine * arm[0] + cosine * arm[1],
        ]);
    }
    points.push(end);
}

/// The quadratic through three points, the second at half the parameter.
fn push_parabola(points: &mut Vec<ProfilePoint>, [from, middle, end]: [ProfilePoint; 3]) {
    for chord in 1..CHORDS {
        let s = f64::from(chord) / f64::from(CHORDS);
        let weights = [(1.0 - s) * (1.0 - 2.0 * s), 4.0 * s * (1.0 - s), s * (2.0 * s - 1.0)];
        points.push([0, 1].map(|axis| {
            weights[0] * from[axis] + weights[1] * middle[axis] + weights[2] * end[axis]
        }));
    }
    points.push(end);
}

#[cfg(test)]
mod tests {
    use super::*;
    use slideline_model::TYPES;

    /// Requirement: of every cell that elements are drawn with, edges join its corners, each edge
    /// that has a middle node goes through it, and that node is half way.
    #[test]
    fn edges_are_those_of_the_cells() {
        for row in TYPES.into_iter().filter(|row| !row.cell.places.is_empty()) {
            for piece in row.cell.pieces {
                let place = |point: usize| row.cell.places[piece.nodes[point]];
                let edges = edges(piece.vtk);
                let mut drawn = vec![false; piece.nodes.len()];
                edges.iter().flat_map(|edge| edge.iter()).for_each(|&point| drawn[point] = true);
                assert!(drawn.iter().all(|drawn| *drawn), "{}: a node is on no edge", row.name());
                for edge in edges {
                    let (first, last) = (place(edge[0]), place(edge[edge.len() - 1]));
                    for &middle in &edge[1..edge.len() - 1] {
                        for axis in 0..3 {
                            let half = 0.5 * (first[axis] + last[axis]);
                            assert!((place(middle)[axis] - half).abs() < 1e-15, "{}", row.name());
                        }
                    }
                    // of cells with faces every edge is one of a face
                    let ends = [edge[0], edge[edge.len() - 1]].map(|end| piece.nodes[end]);
                    let on = |face: &&[usize]| ends.iter().all(|end| face.contains(end));
                    assert!(row.cell.faces.iter().any(on), "{}", row.name());
                }
            }
        }
    }
}
