//! The outside of the solids of a model, part by part; a rigid mesh is all outside.
//!
//! ```text
//!    +-----+
//!    |  B  |        a part: elements that share nodes
//!    +-----+-----+
//!       |  A     |  its skin: the faces that only one element has
//!       +--------+
//! ```

use std::collections::{BTreeSet, HashMap};

use slideline_diag::Span;
use slideline_model::{NodeIndex, Section};

use super::faces::{SolidFace, free_faces};
use crate::draft::{Draft, ElementKind};
use crate::log::Target;

/// Faces of the skin, by their places in it.
pub(super) type Patch = BTreeSet<usize>;

/// All outer faces of solids, and those of rigid meshes.
pub(super) struct Skin {
    /// The faces.
    pub faces: Vec<SolidFace>,
    /// The part that each belongs to.
    pub part_of: Vec<usize>,
    /// The parts.
    pub parts: Vec<Part>,
    places: HashMap<(usize, usize), usize>,
}

/// Elements that share nodes.
#[derive(Default)]
pub(super) struct Part {
    /// Its name: of the set that has its elements and no others, or a number.
    pub name: String,
    /// The largest stiffness of its materials [F/L2].
    pub stiffness: f64,
    /// The rigid body that has all its nodes.
    pub body: Option<usize>,
    /// Places of its elements in the draft.
    elements: Vec<usize>,
}

impl Skin {
    /// The skin of the solids of a draft.
    pub fn of(span: Span, draft: &mut Draft) -> Self {
        let solids: Vec<usize> =
            (0..draft.elements.len()).filter(|&k| is_solid(k, draft)).collect();
        let roots = joined(&solids, draft);
        let mut numbers: HashMap<usize, usize> = HashMap::new();
        let mut parts: Vec<Part> = Vec::new();
        for (&element, &root) in solids.iter().zip(&roots) {
            let number = *numbers.entry(root).or_insert_with(|| {
                parts.push(Part::default());
                parts.len() - 1
            });
            parts[number].elements.push(element);
        }
        let part_of_element: HashMap<usize, usize> = parts
            .iter()
            .enumerate()
            .flat_map(|(number, part)| part.elements.iter().map(move |&element| (element, number)))
            .collect();
        let faces = free_faces(&solids, span, draft);
        let part_of = faces.iter().map(|face| part_of_element[&face.element]).collect();
        let place = |(place, face): (usize, &SolidFace)| Some(((face.element, face.face?), place));
        let places = faces.iter().enumerate().filter_map(place).collect();
        let mut skin = Self { faces, part_of, parts, places };
        skin.name(draft);
        skin.measure(draft);
        skin.find_bodies(draft);
        skin
    }

    /// Those of some faces that are on the outside.
    pub fn patch(&self, faces: &[SolidFace]) -> Patch {
        let place = |face: &SolidFace| self.places.get(&(face.element, face.face?)).copied();
        faces.iter().filter_map(place).collect()
    }

    /// All of it.
    pub fn whole(&self) -> Patch {
        (0..self.faces.len()).collect()
    }

    /// A patch by parts.
    pub fn by_parts(&self, patch: &Patch) -> Vec<(usize, Patch)> {
        let mut found: Vec<Patch> = vec![Patch::new(); self.parts.len()];
        for &face in patch {
            found[self.part_of[face]].insert(face);
        }
        found.into_iter().enumerate().filter(|(_, own)| !own.is_empty()).collect()
    }

    /// How far apart the neighbouring nodes of a patch stand: the middle one of their distances [L],
    /// which a few long faces do not change. Nodes carry contact, so that middle nodes count.
    pub fn spacing(&self, patch: &Patch, draft: &Draft) -> f64 {
        let place = |node| draft.model.nodes.position(node);
        let length = |[a, b]: [NodeIndex; 2]| {
            let (a, b) = (place(a), place(b));
            (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
        };
        let of_face = |&face: &usize| stretches(&self.faces[face], draft);
        let mut lengths: Vec<f64> = patch.iter().flat_map(of_face).map(length).collect();
        if lengths.is_empty() {
            return 0.0;
        }
        let middle = lengths.len() / 2;
        *lengths.select_nth_unstable_by(middle, f64::total_cmp).1
    }

    fn name(&mut self, draft: &Draft) {
        let names: Vec<String> = draft.element_sets.names().map(str::to_owned).collect();
        let sets: Vec<(String, BTreeSet<u64>)> = names
            .into_iter()
            .filter_map(|name| {
                let labels = draft.element_sets.labels(&name)?.into_iter().collect();
                Some((name, labels))
            })
            .collect();
        for (number, part) in self.parts.iter_mut().enumerate() {
            let label = |&element: &usize| draft.elements[element].label;
            let own: BTreeSet<u64> = part.elements.iter().map(label).collect();
            let same = sets.iter().find(|(_, labels)| *labels == own);
            part.name = same.map_or_else(|| format!("PART-{}", number + 1), |own| own.0.clone());
        }
    }

    fn measure(&mut self, draft: &Draft) {
        let mut stiffness: HashMap<u64, f64> = HashMap::new();
        for block in &draft.model.blocks {
            let Section::Solid(section) = &block.section else { continue };
            let own = section.material.stiffest();
            stiffness.extend(block.elements.iter().map(|element| (element.label, own)));
        }
        for part in &mut self.parts {
            let of = |&element: &usize| stiffness.get(&draft.elements[element].label).copied();
            part.stiffness = part.elements.iter().filter_map(of).fold(0.0, f64::max);
        }
    }

    /// Finds the parts that are rigid: all nodes of their faces are tied to one body.
    fn find_bodies(&mut self, draft: &mut Draft) {
        let mut body_of: HashMap<NodeIndex, usize> = HashMap::new();
        for (number, body) in draft.bodies.clone().into_iter().enumerate() {
            if let Some(set) = &body.tied {
                let nodes = draft.nodes_of(&Target::Set(set.name.clone()), set.span);
                body_of.extend(nodes.into_iter().map(|node| (node, number)));
            }
            if let Some(set) = &body.elements {
                for element in draft.elements_of(&set.name, set.span).unwrap_or_default() {
                    let labels = draft.elements[element].nodes().to_vec();
                    let nodes =
                        labels.into_iter().filter_map(|label| draft.model.nodes.find(label));
                    body_of.extend(nodes.map(|node| (node, number)));
                }
            }
        }
        let mut bodies: Vec<Option<Option<usize>>> = vec![None; self.parts.len()];
        for (face, &part) in self.faces.iter().zip(&self.part_of) {
            for node in &face.nodes {
                let own = body_of.get(node).copied();
                let known = bodies[part].get_or_insert(own);
                *known = known.filter(|&body| own == Some(body));
            }
        }
        for (part, body) in self.parts.iter_mut().zip(bodies) {
            part.body = body.flatten();
        }
    }
}

fn is_solid(element: usize, draft: &Draft) -> bool {
    match draft.elements[element].kind {
        ElementKind::Structural(row) => !row.cell.faces.is_empty(),
        kind => kind.bare().is_some(),
    }
}

/// Stretches between neighbouring nodes along the edges of a face, whose middle nodes come after its
/// corners, of an edge between its ends.
fn stretches(face: &SolidFace, draft: &Draft) -> Vec<[NodeIndex; 2]> {
    let nodes = &face.nodes;
    if face_is_edge(face, draft) {
        return nodes.windows(2).map(|ends| [ends[0], ends[1]]).collect();
    }
    let corners = if nodes.len().is_multiple_of(3) { 3 } else { 4 }.min(nodes.len());
    let is_quadratic = nodes.len() >= 2 * corners;
    let of_edge = |k: usize| {
        let (from, to) = (nodes[k], nodes[(k + 1) % corners]);
        match is_quadratic {
            true => vec![[from, nodes[corners + k]], [nodes[corners + k], to]],
            false => vec![[from, to]],
        }
    };
    (0..corners).flat_map(of_edge).collect()
}

fn face_is_edge(face: &SolidFace, draft: &Draft) -> bool {
    match draft.elements[face.element].kind {
        ElementKind::Structural(row) => row.cell.dimension == 2,
        kind => kind.bare().is_some_and(|mesh| !mesh.spatial),
    }
}

/// For each element the first one of those that it is joined with through nodes, of what has been
/// cut by a pre-tension section through those before the cut.
fn joined(elements: &[usize], draft: &Draft) -> Vec<usize> {
    let mut parent: Vec<usize> = (0..elements.len()).collect();
    let mut first: HashMap<u64, usize> = HashMap::new();
    for (place, &element) in elements.iter().enumerate() {
        for &node in draft.elements[element].nodes() {
            let other = *first.entry(draft.uncut(node)).or_insert(place);
            let (a, b) = (root(&mut parent, place), root(&mut parent, other));
            parent[a.max(b)] = a.min(b);
        }
    }
    (0..elements.len()).map(|place| root(&mut parent, place)).collect()
}

/// The first of those that a place is joined with.
fn root(parent: &mut [usize], mut at: usize) -> usize {
    while parent[at] != at {
        parent[at] = parent[parent[at]];
        at = parent[at];
    }
    at
}
