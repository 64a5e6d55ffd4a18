//! Rounds that fit one another, drawn with straight faces of different lengths.
//!
//! ```text
//!        .-'''''-.          the chords of a pin lie within its round, those of a hole as well: spread over
//!      .'  .---.  '.        faces, contact finds the pin thinner and the hole narrower than they are, and
//!     /   /     \   \       what is left where the faces are not as long counts as an overlap or a gap
//! ```
//!
//! docs/theory.md section 5.22

use slideline_mech::surface::mesh::SHARP;
use slideline_mech::vector::{Vector, add, cross, dot, scale, size, sub};
use slideline_model::{ContactPair, Formulation, Lumping, Master, Model, NodeIndex};
use slideline_solve::observe::ContactRow;
use std::collections::HashMap;

/// Part of the size of faces by which what they are chords of stands out of them below which they count as flat [1]: they
/// turn by less than a hundredth then.
const FLAT: f64 = 1e-3;

/// Sizes of faces within which parts begin beside one another [1].
const BESIDE: f64 = 2.0;

/// How much deeper the faces of both sides stand in one another than the rounds that they are chords of.
#[derive(Clone, Debug, Default)]
pub(super) struct Facets {
    /// The same about each slave node, mean over its faces [L].
    deeper: HashMap<NodeIndex, f64>,
}

/// A face with straight sides where it begins.
#[derive(Clone, Copy)]
struct Face<'a> {
    nodes: &'a [NodeIndex],
    middle: Vector,
    normal: Vector,
}

/// How far what is round stands out of its faces about a node, in the mean over them, negative where it is hollow [L],
/// with the size of the faces [L].
#[derive(Clone, Copy, Default)]
struct Bulge {
    out: f64,
    wide: f64,
}

impl Facets {
    /// Those of a pair of rounds, one in the other, whose contact is spread over faces; `None` of others.
    pub fn of(model: &Model, pair: &ContactPair) -> Option<Self> {
        if pair.formulation != Formulation::Mortar || pair.meets_itself() {
            return None;
        }
        let own = bulges(model, &slave_faces(pair)?);
        let other = bulges(model, &master_faces(&pair.master)?);
        let wide = own.values().chain(other.values()).map(|own| own.wide).fold(0.0, f64::max);
        let near = Near::new(model, other.keys().copied(), BESIDE * wide);
        let mut deeper = HashMap::new();
        for (&node, own) in own.iter().filter(|(_, own)| own.out != 0.0) {
            let Some((way, nearest)) = near.nearest(model.nodes.position(node)) else { continue };
            let other = &other[&nearest];
            // one is hollow where the other one stands out, and they begin beside one another
            if own.out * other.out < 0.0 && way <= BESIDE * own.wide.max(other.wide) {
                deeper.insert(node, -(own.out + other.out));
            }
        }
        (!deeper.is_empty()).then_some(Self { deeper })
    }

    /// Forces on the slave nodes of the pair of that place, and the mean by these of how much deeper the faces stand
    /// [F, L].
    pub fn weigh<'a>(&self, rows: impl Iterator<Item = &'a ContactRow>) -> (f64, f64) {
        let (force, work) = rows.fold((0.0, 0.0), |(force, work), row| {
            let own = row.pressure * row.area;
            (force + own, work + own * self.deeper.get(&row.node).copied().unwrap_or_default())
        });
        (force, if force > 0.0 { work / force } else { 0.0 })
    }
}

/// Nodes in the cells of a grid.
struct Near {
    size: f64,
    cells: HashMap<[i64; 3], Vec<(NodeIndex, Vector)>>,
}

impl Near {
    /// Those of a model in cells of that size [L].
    fn new(model: &Model, nodes: impl Iterator<Item = NodeIndex>, size: f64) -> Self {
        let mut new = Self { size, cells: HashMap::new() };
        for node in nodes {
            let at = model.nodes.position(node);
            let cell = new.cell(at);
            new.cells.entry(cell).or_default().push((node, at));
        }
        new
    }

    fn cell(&self, at: Vector) -> [i64; 3] {
        at.map(|x| (x / self.size).floor() as i64)
    }

    /// The node nearest to a place, with its distance, where one is no further than a cell is wide [L].
    fn nearest(&self, at: Vector) -> Option<(f64, NodeIndex)> {
        let middle = self.cell(at);
        let beside = (0..27_i64).map(|k| [k % 3, k / 3 % 3, k / 9].map(|step| step - 1));
        let cells =
            beside.map(|step| std::array::from_fn(|axis| middle[axis].saturating_add(step[axis])));
        let nodes = cells.filter_map(|cell| self.cells.get::<[i64; 3]>(&cell)).flatten();
        let ways = nodes.map(|&(node, place)| (size(sub(place, at)), node));
        // of two that are as near the one that comes first in the model
        ways.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)))
    }
}

/// The nodes of the faces of the slave, material on the left of those in the plane; `None` with middle nodes, whose
/// faces are round themselves.
fn slave_faces(pair: &ContactPair) -> Option<Vec<Vec<NodeIndex>>> {
    if pair.elements.iter().any(|element| element.lumping != Lumping::Halves) {
        return None;
    }
    let lines = pair.elements.iter().map(|element| element.nodes.to_vec());
    straight(lines.chain(pair.faces.iter().map(|face| face.nodes.clone())).collect())
}

/// The same of the master.
fn master_faces(master: &Master) -> Option<Vec<Vec<NodeIndex>>> {
    match master {
        Master::SlideLine(line) if line.middles.iter().any(|&middle| middle) => None,
        // its material is on the right
        Master::SlideLine(line) => {
            Some(line.nodes.windows(2).map(|ends| vec![ends[1], ends[0]]).collect())
        }
        Master::Faces(faces) if faces.swept.is_none() => {
            straight(faces.faces.iter().map(|face| face.nodes.clone()).collect())
        }
        _ => None,
    }
}

/// Faces none of which has middle nodes.
fn straight(faces: Vec<Vec<NodeIndex>>) -> Option<Vec<Vec<NodeIndex>>> {
    (!faces.is_empty() && faces.iter().all(|nodes| nodes.len() <= 4)).then_some(faces)
}

/// What is round about the nodes of faces.
fn bulges(model: &Model, faces: &[Vec<NodeIndex>]) -> HashMap<NodeIndex, Bulge> {
    let faces: Vec<Face<'_>> = faces.iter().filter_map(|nodes| Face::new(model, nodes)).collect();
    let mut about: HashMap<NodeIndex, Vec<usize>> = HashMap::new();
    for (place, face) in faces.iter().enumerate() {
        face.nodes.iter().for_each(|&node| about.entry(node).or_default().push(place));
    }
    let own: HashMap<NodeIndex, Bulge> = about
        .iter()
        .map(|(&node, of)| (node, bulge(model.nodes.position(node), of.iter().map(|&k| faces[k]))))
        .collect();
    // at the end of a surface half of the faces about a node are missing: the faces as a whole say what is round there
    let most = |face: &Face<'_>| {
        let all = face.nodes.iter().map(|node| own[node].out);
        all.fold(0.0, |a: f64, b| if b.abs() > a.abs() { b } else { a })
    };
    let of_faces: Vec<f64> = faces.iter().map(most).collect();
    let of_node = |(node, of): (NodeIndex, Vec<usize>)| {
        let all = of.iter().map(|&face| of_faces[face]);
        let out = all.fold(0.0, |a: f64, b| if b.abs() > a.abs() { b } else { a });
        (node, Bulge { out, wide: own[&node].wide })
    };
    about.into_iter().map(of_node).collect()
}

/// That of a node with the faces about it: eq. (5.60).
fn bulge<'a>(at: Vector, faces: impl Iterator<Item = Face<'a>> + Clone) -> Bulge {
    let sum = faces.clone().fold([0.0; 3], |sum, own| add(sum, own.normal));
    let normal = scale(sum, 1.0 / size(sum));
    let count = faces.clone().count() as f64;
    let wide = faces.clone().map(|own| 2.0 * size(sub(at, own.middle))).fold(0.0, f64::max);
    let is_smooth = faces.clone().all(|own| dot(own.normal, normal) > SHARP);
    if !is_smooth {
        return Bulge { out: 0.0, wide };
    }
    let out: f64 = faces.map(|own| dot(sub(at, own.middle), normal)).sum();
    let out = out / (3.0 * count);
    Bulge { out: if out.abs() > FLAT * wide { out } else { 0.0 }, wide }
}

impl<'a> Face<'a> {
    fn new(model: &Model, nodes: &'a [NodeIndex]) -> Option<Self> {
        let place = |k: usize| model.nodes.position(nodes[k]);
        let sum = (0..nodes.len()).fold([0.0; 3], |sum, k| add(sum, place(k)));
        let middle = scale(sum, 1.0 / nodes.len() as f64);
        let normal = match nodes.len() {
            2 => {
                let along = sub(place(1), place(0));
                [along[1], -along[0], 0.0]
            }
            3 => cross(sub(place(1), place(0)), sub(place(2), place(0))),
            _ => cross(sub(place(2), place(0)), sub(place(3), place(1))),
        };
        let long = size(normal);
        (long > 0.0).then(|| Self { nodes, middle, normal: scale(normal, 1.0 / long) })
    }
}
