//! Rounds that fit one another, drawn with straight faces of different lengths.
//!
//! ```text
//!        .-'''''-.          the chords of a pin lie within its round, those of a hole as well: spread over
//!      .'  .---.  '.        faces, contact finds the pin thinner and the hole narrower than they are, and
//!     /   /     \   \       what is left where the faces are not as long counts as an overlap or a gap
//! ```
//!
//! docs/theory.md section 5.22

use slideline_mech::contact::search::tree::BoxTree;
use slideline_mech::surface::mesh::{area_between, is_crease};
use slideline_mech::vector::{Vector, add, dot, scale, size, sub};
use slideline_model::{ContactPair, Formulation, Lumping, Master, Model, NodeIndex};
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
        let place = |node: NodeIndex| model.nodes.position(node);
        let mut masters: Vec<NodeIndex> = other.keys().copied().collect();
        masters.sort_unstable();
        let tree = BoxTree::<3>::new(masters.len(), |k| (place(masters[k]), place(masters[k])));
        let mut deeper = HashMap::new();
        for (&node, own) in own.iter().filter(|(_, own)| own.out != 0.0) {
            let at = place(node);
            let square = |k: usize| size(sub(place(masters[k]), at)).powi(2);
            let Some((nearest, square)) = tree.nearest_within(at, BESIDE * wide, square) else {
                continue;
            };
            let other = &other[&masters[nearest]];
            // one is hollow where the other one stands out, and they begin beside one another
            if own.out * other.out < 0.0 && square.sqrt() <= BESIDE * own.wide.max(other.wide) {
                deeper.insert(node, -(own.out + other.out));
            }
        }
        (!deeper.is_empty()).then_some(Self { deeper })
    }

    /// How much deeper the faces stand in one another about a slave node [L].
    pub fn deeper(&self, node: NodeIndex) -> f64 {
        self.deeper.get(&node).copied().unwrap_or_default()
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
        .map(|(&node, of)| {
            let of: Vec<Face<'_>> = of.iter().map(|&face| faces[face]).collect();
            (node, bulge(model.nodes.position(node), &of))
        })
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
fn bulge(at: Vector, faces: &[Face<'_>]) -> Bulge {
    let wide = faces.iter().map(|own| 2.0 * size(sub(at, own.middle))).fold(0.0, f64::max);
    let is_sharp = |one: &Face<'_>| faces.iter().any(|other| is_crease(one.normal, other.normal));
    if faces.iter().any(is_sharp) {
        return Bulge { out: 0.0, wide };
    }
    let sum = faces.iter().fold([0.0; 3], |sum, own| add(sum, own.normal));
    let normal = scale(sum, 1.0 / size(sum));
    let out: f64 = faces.iter().map(|own| dot(sub(at, own.middle), normal)).sum();
    let out = out / (3.0 * faces.len() as f64);
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
            corners => area_between(corners, place),
        };
        let long = size(normal);
        (long > 0.0).then(|| Self { nodes, middle, normal: scale(normal, 1.0 / long) })
    }
}
