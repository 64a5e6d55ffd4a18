//! The deck of a mesh: it runs once what is marked by FILL IN is filled in.

use crate::corners::corners;
use crate::mesh::{Group, Mesh};
use crate::names::{clean, free};
use crate::parts::{Part, Parts};
use crate::wishes::{Asked, Wishes};
use slideline_diag::Diagnostic;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::fmt::Write as _;

/// Numbers on a line of a set.
const NUMBERS_A_LINE: usize = 16;

/// Appends a line; a String takes any text.
macro_rules! line {
    ($text:expr, $($content:tt)*) => {{
        let _ = writeln!($text, $($content)*);
    }};
}

/// The deck of a mesh, whose file has that name.
///
/// # Errors
/// SL0832 for groups that the mesh does not have, SL0833 and SL0834 for what cannot become elements.
pub fn deck(mesh: &Mesh, wishes: &Wishes, name: &str) -> Result<String, Vec<Diagnostic>> {
    let asked = Asked::of(mesh, wishes)?;
    let parts = Parts::of(mesh, &asked).map_err(|said| vec![*said])?;
    let mut writing = Writing { mesh, asked: &asked, parts: &parts, text: String::new() };
    writing.head(name);
    writing.nodes();
    writing.elements();
    writing.groups();
    writing.rigid_bodies();
    writing.sections();
    writing.step();
    Ok(writing.text)
}

struct Writing<'a> {
    mesh: &'a Mesh,
    asked: &'a Asked,
    parts: &'a Parts,
    text: String,
}

impl Writing<'_> {
    fn head(&mut self, name: &str) {
        let name: String = name.chars().filter(|c| !c.is_control()).collect();
        line!(self.text, "*HEADING\nMesh of {name}, by slideline import\n**");
        line!(
            self.text,
            "** What its groups became. Fill in what is marked by FILL IN, then add loads and contact."
        );
        for (place, group) in self.mesh.groups.iter().enumerate() {
            line!(self.text, "**   {:<24} {}", clean(&group.name), self.became(place, group));
        }
        line!(self.text, "**");
    }

    fn became(&self, place: usize, group: &Group) -> String {
        let mut words = Vec::new();
        if let Some(part) = self.parts.parts.iter().find(|part| part.set == clean(&group.name)) {
            words.push(format!("elements {}, *ELSET", part.kind.name()));
        } else if self.is_of_solids(group) {
            words.push("*ELSET".to_owned());
        }
        if self.has_faces(place, group) {
            words.push("*SURFACE of element faces".to_owned());
        }
        if self.is_node_set(place, group) {
            words.push("*NSET".to_owned());
        }
        if self.asked.rigid[place] {
            words.push("rigid body".to_owned());
        }
        if self.asked.fixed[place] {
            words.push("held".to_owned());
        }
        words.join(", ")
    }

    fn is_of_solids(&self, group: &Group) -> bool {
        self.parts.dimension > 1 && group.dimension == self.parts.dimension
    }

    fn is_of_beams(&self, place: usize) -> bool {
        self.asked.kinds[place].as_ref().is_some_and(|(_, beam)| *beam)
    }

    fn has_faces(&self, place: usize, group: &Group) -> bool {
        let of_faces = self.parts.dimension > 1 && group.dimension + 1 == self.parts.dimension;
        of_faces
            && !group.cells.is_empty()
            && !self.asked.node_set[place]
            && !self.is_of_beams(place)
    }

    fn is_node_set(&self, place: usize, group: &Group) -> bool {
        let below = !self.is_of_solids(group) && !self.is_of_beams(place);
        below || self.asked.node_set[place] || self.asked.rigid[place] || self.asked.fixed[place]
    }

    /// Nodes of elements, and those that sets name.
    fn nodes(&mut self) {
        let elements = self.parts.parts.iter().flat_map(|part| &part.elements);
        let mut used: BTreeSet<u64> = elements.flat_map(|(_, nodes)| nodes).copied().collect();
        for (place, group) in self.mesh.groups.iter().enumerate() {
            if self.is_node_set(place, group) {
                used.extend(self.mesh.nodes_of(group));
            }
        }
        line!(self.text, "*NODE");
        for node in used {
            let Some([x, y, z]) = self.mesh.nodes.get(&node) else { continue };
            match self.parts.in_plane {
                true => line!(self.text, "{node}, {x:?}, {y:?}"),
                false => line!(self.text, "{node}, {x:?}, {y:?}, {z:?}"),
            }
        }
    }

    fn elements(&mut self) {
        for Part { set, kind, elements } in &self.parts.parts {
            line!(self.text, "*ELEMENT, TYPE={}, ELSET={set}", kind.name());
            for (label, nodes) in elements {
                let numbers: Vec<u64> = std::iter::once(*label).chain(nodes.clone()).collect();
                push_numbers(&mut self.text, &numbers);
            }
        }
    }

    fn groups(&mut self) {
        let faces = self.faces();
        let parts = self.parts.parts.iter();
        let written: Vec<(&str, BTreeSet<u64>)> = parts
            .map(|own| (own.set.as_str(), own.elements.iter().map(|(label, _)| *label).collect()))
            .collect();
        for (place, group) in self.mesh.groups.iter().enumerate() {
            let name = clean(&group.name);
            let has_part = self.parts.parts.iter().any(|part| part.set == name);
            let labels = || group.cells.iter().map(|&cell| self.mesh.cells[cell].label);
            let stands = |own: &u64| written.iter().any(|(_, labels)| labels.contains(own));
            if self.is_of_solids(group) && !has_part {
                let labels: Vec<u64> = labels().filter(stands).collect();
                push_set(&mut self.text, &format!("*ELSET, ELSET={name}"), &labels);
            }
            if has_part {
                // an element belongs to one part, as its section does
                let own = |label: &u64| {
                    written.iter().any(|(set, all)| *set == name && all.contains(label))
                };
                let others = labels().filter(|label| stands(label) && !own(label)).count();
                if others > 0 {
                    line!(
                        self.text,
                        "** {others} elements of {name} stand in sets before it, where they have their section."
                    );
                }
            }
            if self.is_node_set(place, group) {
                let nodes = self.mesh.nodes_of(group);
                push_set(&mut self.text, &format!("*NSET, NSET={name}"), &nodes);
            }
            if self.has_faces(place, group) {
                self.surface(&name, group, &faces);
            }
        }
    }

    /// Elements and numbers of their faces by the corners of the face.
    fn faces(&self) -> HashMap<Vec<u64>, Vec<(u64, usize)>> {
        let mut faces: HashMap<Vec<u64>, Vec<(u64, usize)>> = HashMap::new();
        let solids = self.parts.parts.iter().filter(|part| part.kind.cell.dimension > 1);
        for part in solids {
            for (label, nodes) in &part.elements {
                for (place, face) in part.kind.cell.faces.iter().enumerate() {
                    let own: Vec<u64> = face.iter().map(|&node| nodes[node]).collect();
                    let key = corners(part.kind.cell.dimension - 1, &own);
                    faces.entry(key).or_default().push((*label, place + 1));
                }
            }
        }
        faces
    }

    /// A surface of the faces that the cells of a group lie on. A face between two elements is none.
    fn surface(&mut self, name: &str, group: &Group, faces: &HashMap<Vec<u64>, Vec<(u64, usize)>>) {
        let (mut outer, mut inner) = (BTreeMap::<usize, Vec<u64>>::new(), 0);
        for &cell in &group.cells {
            let cell = &self.mesh.cells[cell];
            match faces.get(&corners(cell.dimension, &cell.nodes)).map(Vec::as_slice) {
                Some(&[(label, face)]) => outer.entry(face).or_default().push(label),
                _ => inner += 1,
            }
        }
        if inner > 0 {
            line!(
                self.text,
                "** {inner} faces of {name} lie between elements or on none: they are not in its surface."
            );
        }
        for (face, labels) in &outer {
            push_set(&mut self.text, &format!("*ELSET, ELSET=_{name}_S{face}"), labels);
        }
        if !outer.is_empty() {
            line!(self.text, "*SURFACE, NAME={name}, TYPE=ELEMENT");
            outer.keys().for_each(|face| line!(self.text, "_{name}_S{face}, S{face}"));
        }
    }

    /// The set of the reference node of a rigid group.
    fn reference(&self, name: &str) -> String {
        let mut taken = self.mesh.groups.iter().map(|own| clean(&own.name)).collect();
        free(&format!("{name}_REF"), &mut taken)
    }

    /// A reference node in the middle of each rigid group, behind all nodes.
    fn rigid_bodies(&mut self) {
        let rigid = self.mesh.groups.iter().zip(&self.asked.rigid).filter(|(_, own)| **own);
        let rigid: Vec<&Group> = rigid.map(|(group, _)| group).collect();
        for (group, node) in rigid.into_iter().zip(self.first_free()..) {
            let name = clean(&group.name);
            let [x, y, z] = self.middle(group);
            line!(self.text, "*NODE, NSET={}", self.reference(&name));
            match self.parts.in_plane {
                true => line!(self.text, "{node}, {x:?}, {y:?}"),
                false => line!(self.text, "{node}, {x:?}, {y:?}, {z:?}"),
            }
            line!(self.text, "*RIGID BODY, REF NODE={node}, TIE NSET={name}");
        }
    }

    fn first_free(&self) -> u64 {
        self.mesh.nodes.keys().next_back().map_or(1, |last| last.saturating_add(1))
    }

    /// Mean position of the nodes of a group [L].
    fn middle(&self, group: &Group) -> [f64; 3] {
        let nodes = self.mesh.nodes_of(group);
        let places = nodes.iter().filter_map(|node| self.mesh.nodes.get(node));
        let sum = places.fold([0.0; 3], |sum, place| std::array::from_fn(|a| sum[a] + place[a]));
        sum.map(|value| value / nodes.len().max(1) as f64)
    }

    fn sections(&mut self) {
        line!(self.text, "**\n*MATERIAL, NAME=MATERIAL\n*ELASTIC");
        line!(self.text, "** FILL IN: Young's modulus, Poisson's ratio");
        let mut told = BTreeSet::new();
        for Part { set, kind, .. } in &self.parts.parts {
            if !told.insert(set) {
                continue; // a set of triangles and quadrilaterals has one section
            }
            match kind.cell.dimension {
                1 => {
                    line!(self.text, "*BEAM SECTION, SECTION=RECT, ELSET={set}, MATERIAL=MATERIAL");
                    line!(self.text, "** FILL IN: width, height");
                }
                2 if !kind.is_ring() => {
                    line!(self.text, "*SOLID SECTION, ELSET={set}, MATERIAL=MATERIAL");
                    line!(self.text, "** FILL IN: thickness (1 if nothing stands here)");
                }
                _ => line!(self.text, "*SOLID SECTION, ELSET={set}, MATERIAL=MATERIAL"),
            }
        }
    }

    fn step(&mut self) {
        line!(self.text, "**\n*STEP, NLGEOM, INC=1000\n*STATIC\n0.1, 1.0\n*BOUNDARY");
        for (place, group) in self.mesh.groups.iter().enumerate() {
            let name = clean(&group.name);
            let reference = self.reference(&name);
            match (self.asked.rigid[place], self.asked.fixed[place]) {
                (true, true) => line!(self.text, "{reference}, 1, 6"),
                (false, true) => line!(self.text, "{name}, 1, {}", self.last_dof(place)),
                (true, false) => {
                    line!(self.text, "** {reference} moves the rigid body {name}, for instance:");
                    line!(self.text, "** {reference}, 2, 2, -1.0");
                }
                (false, false) => {}
            }
        }
        line!(
            self.text,
            "** FILL IN: what is held or moved: node or set, first and last dof, value"
        );
        line!(self.text, "*NODE FILE\nU, RF\n*EL FILE\nS\n*END STEP");
    }

    /// Nodes of beams turn, those of solids do not.
    fn last_dof(&self, place: usize) -> usize {
        let own: BTreeSet<u64> = self.mesh.nodes_of(&self.mesh.groups[place]).into_iter().collect();
        let beams = self.parts.parts.iter().filter(|part| part.kind.cell.dimension == 1);
        let mut of_beams = beams.flat_map(|part| &part.elements).flat_map(|(_, nodes)| nodes);
        match of_beams.any(|node| own.contains(node)) {
            true => 6,
            false if self.parts.in_plane => 2,
            false => 3,
        }
    }
}

fn push_set(text: &mut String, head: &str, numbers: &[u64]) {
    line!(text, "{head}");
    numbers.chunks(NUMBERS_A_LINE).for_each(|chunk| push_numbers(text, chunk));
}

/// Numbers, on more than one line where there are many: a comma at the end goes on.
fn push_numbers(text: &mut String, numbers: &[u64]) {
    let lines: Vec<String> = numbers
        .chunks(NUMBERS_A_LINE)
        .map(|chunk| chunk.iter().map(u64::to_string).collect::<Vec<_>>().join(", "))
        .collect();
    line!(text, "{}", lines.join(",\n"));
}
