//! The format of gmsh, versions 2.2 and 4.1 as text. [gmsh 4.15 reference manual, section 10]
//!
//! ```text
//!   $PhysicalNames  dimension, number, "name"
//!   $Entities       (4.1) numbers of the groups that a point, curve, surface or volume is in
//!   $Nodes          number and position; in 4.1 in blocks
//!   $Elements       number, type, (2.2) numbers of groups, nodes; in 4.1 in blocks
//! ```

use crate::corners::is_known;
use crate::fault::{no_element, unreadable};
use crate::lines::{Line, Lines};
use crate::mesh::{Cell, Group, Mesh};
use crate::names::distinguish;
use slideline_diag::{Diagnostic, Sources, Span};
use std::collections::{BTreeMap, HashMap};

type Fallible<T> = Result<T, Box<Diagnostic>>;

/// Dimension and number of a group or an entity.
type Key = (usize, u64);

/// Dimension, number of nodes, and the place in gmsh's order of each node that is kept, in the order
/// of Abaqus.
type Kind = (usize, usize, &'static [usize]);

const BRICK: &[usize] = &[0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 13, 9, 16, 18, 19, 17, 10, 12, 14, 15];
pub(crate) const WEDGE: &[usize] = &[0, 1, 2, 3, 4, 5, 6, 9, 7, 12, 14, 13, 8, 10, 11];

/// The element types of gmsh that elements here can be made of. [same, section 9.2]
fn kind(number: u64) -> Option<Kind> {
    let all: (usize, &'static [usize]) = match number {
        15 => (0, &[0]),
        1 => (1, &[0, 1]),
        8 => (1, &[0, 2, 1]),
        2 => (2, &[0, 1, 2]),
        3 => (2, &[0, 1, 2, 3]),
        9 => (2, &[0, 1, 2, 3, 4, 5]),
        10 | 16 => (2, &[0, 1, 2, 3, 4, 5, 6, 7]),
        4 => (3, &[0, 1, 2, 3]),
        5 => (3, &[0, 1, 2, 3, 4, 5, 6, 7]),
        6 => (3, &[0, 1, 2, 3, 4, 5]),
        11 => (3, &[0, 1, 2, 3, 4, 5, 6, 7, 9, 8]),
        12 | 17 => (3, BRICK),
        13 | 18 => (3, WEDGE),
        _ => return None,
    };
    let count = match number {
        10 => 9,
        12 => 27,
        13 => 18,
        _ => all.1.len(),
    };
    Some((all.0, count, all.1))
}

/// What is known while a file is read.
#[derive(Default)]
struct Reading {
    mesh: Mesh,
    names: HashMap<Key, String>,
    /// Groups of the entities (4.1).
    entities: HashMap<Key, Vec<u64>>,
    groups: BTreeMap<Key, Vec<usize>>,
    /// Cells by their nodes: 2.2 writes one that is in two groups twice.
    seen: HashMap<(usize, Vec<u64>), usize>,
}

/// Reads a mesh.
pub(crate) fn read(sources: &mut Sources, name: &str, bytes: &[u8]) -> Fallible<Mesh> {
    let text = String::from_utf8_lossy(bytes).into_owned();
    let file = sources.add(name, text.clone());
    let mut lines = Lines::new(&text, file);
    let mut reading = Reading::default();
    let mut version = None;
    while let Some(line) = lines.next() {
        match line.text {
            "$MeshFormat" => version = Some(format(&mut lines)?),
            "$PhysicalNames" => reading.names(&mut lines)?,
            "$Entities" => reading.entities(&mut lines)?,
            "$Nodes" if version == Some(2) => reading.nodes(&mut lines)?,
            "$Elements" if version == Some(2) => reading.elements(&mut lines)?,
            "$Nodes" => reading.node_blocks(&mut lines)?,
            "$Elements" => reading.element_blocks(&mut lines)?,
            other if other.starts_with('$') => skip(&mut lines, other)?,
            _ => {
                return Err(unreadable(
                    "a section that begins with $ should stand here",
                    Some(line.span),
                ));
            }
        }
    }
    reading.finish(Span::new(file, 0, 0))
}

/// Two or four; other versions and binary files are refused.
fn format(lines: &mut Lines<'_>) -> Fallible<u32> {
    let line = lines.wanted("the version")?;
    let words: Vec<&str> = line.text.split_whitespace().collect();
    if words.get(1) == Some(&"1") {
        let message = "this mesh is binary, and text is read";
        return Err(unreadable(message, Some(line.span)));
    }
    let version = match words.first() {
        Some(&("2" | "2.1" | "2.2")) => 2,
        Some(&"4.1") => 4,
        other => {
            let own = other.unwrap_or(&"unknown");
            let message = format!("version {own} of gmsh's format is not read: 2.2 and 4.1 are");
            return Err(unreadable(message, Some(line.span)));
        }
    };
    skip(lines, "$MeshFormat")?;
    Ok(version)
}

/// Leaves a section.
fn skip(lines: &mut Lines<'_>, section: &str) -> Fallible<()> {
    let end = section.replacen('$', "$End", 1);
    while lines.wanted(&end)?.text != end {}
    Ok(())
}

fn count(line: &Line<'_>, what: &str) -> Fallible<usize> {
    Ok(line.numbers(1, what)?[0])
}

impl Reading {
    fn names(&mut self, lines: &mut Lines<'_>) -> Fallible<()> {
        for _ in 0..count(&lines.wanted("the number of names")?, "names")? {
            let line = lines.wanted("a name")?;
            let mut words = line.text.splitn(3, char::is_whitespace);
            let mut number = || words.next()?.parse::<u64>().ok();
            let (dimension, tag) = (number(), number());
            let name = words.next().map(|name| name.trim().trim_matches('"').to_owned());
            let (Some(dimension), Some(tag), Some(name)) = (dimension, tag, name) else {
                return Err(unreadable(
                    "a name has a dimension, a number and a text",
                    Some(line.span),
                ));
            };
            self.names.insert((dimension as usize, tag), name);
        }
        skip(lines, "$PhysicalNames")
    }

    /// Which groups an entity is in: behind its number three coordinates of a point, six of others.
    fn entities(&mut self, lines: &mut Lines<'_>) -> Fallible<()> {
        let counts: Vec<usize> = lines.wanted("the entities")?.numbers(4, "entities")?;
        for (dimension, &count) in counts.iter().enumerate().take(4) {
            let box_size = if dimension == 0 { 3 } else { 6 };
            for _ in 0..count {
                let line = lines.wanted("an entity")?;
                let values: Vec<f64> = line.numbers(box_size + 2, "an entity")?;
                let tags = values[box_size + 1] as usize;
                let own = values.iter().skip(box_size + 2).take(tags);
                // a negative number says that the entity is turned round
                let own = own.map(|tag| tag.abs() as u64).collect();
                self.entities.insert((dimension, values[0].abs() as u64), own);
            }
        }
        skip(lines, "$Entities")
    }

    fn nodes(&mut self, lines: &mut Lines<'_>) -> Fallible<()> {
        for _ in 0..count(&lines.wanted("the number of nodes")?, "nodes")? {
            let line = lines.wanted("a node")?;
            let (label, rest) =
                line.text.split_once(char::is_whitespace).unwrap_or((line.text, ""));
            let Ok(label) = label.parse() else {
                return Err(unreadable(
                    format!("`{label}` is no number of a node"),
                    Some(line.span),
                ));
            };
            let position = Line { text: rest, span: line.span }.position()?;
            self.mesh.nodes.insert(label, position);
        }
        skip(lines, "$Nodes")
    }

    fn node_blocks(&mut self, lines: &mut Lines<'_>) -> Fallible<()> {
        for _ in 0..count(&lines.wanted("the blocks of nodes")?, "nodes")? {
            let block: Vec<u64> =
                lines.wanted("a block of nodes")?.numbers(4, "a block of nodes")?;
            let mut labels: Vec<u64> = Vec::new();
            for _ in 0..block[3] {
                labels.push(lines.wanted("a node")?.numbers(1, "a node")?[0]);
            }
            for label in labels {
                let position = lines.wanted("a position")?.position()?;
                self.mesh.nodes.insert(label, position);
            }
        }
        skip(lines, "$Nodes")
    }

    fn elements(&mut self, lines: &mut Lines<'_>) -> Fallible<()> {
        for _ in 0..count(&lines.wanted("the number of elements")?, "elements")? {
            let line = lines.wanted("an element")?;
            let numbers: Vec<u64> = line.numbers(3, "an element")?;
            let behind = 3_usize.saturating_add(numbers[2] as usize);
            if numbers.len() < behind {
                return Err(unreadable("an element ends within its groups", Some(line.span)));
            }
            let group: Vec<u64> = numbers[3..behind].iter().take(1).copied().collect();
            self.element((numbers[0], numbers[1]), &numbers[behind..], &group, line.span)?;
        }
        skip(lines, "$Elements")
    }

    fn element_blocks(&mut self, lines: &mut Lines<'_>) -> Fallible<()> {
        for _ in 0..count(&lines.wanted("the blocks of elements")?, "elements")? {
            let block: Vec<u64> =
                lines.wanted("a block of elements")?.numbers(4, "a block of elements")?;
            let entity = (block[0] as usize, block[1]);
            let groups = self.entities.get(&entity).cloned().unwrap_or_default();
            for _ in 0..block[3] {
                let line = lines.wanted("an element")?;
                let numbers: Vec<u64> = line.numbers(2, "an element")?;
                self.element((numbers[0], block[2]), &numbers[1..], &groups, line.span)?;
            }
        }
        skip(lines, "$Elements")
    }

    fn element(
        &mut self,
        (label, gmsh): (u64, u64),
        nodes: &[u64],
        groups: &[u64],
        span: Span,
    ) -> Fallible<()> {
        let Some((dimension, count, order)) = kind(gmsh) else {
            let message =
                format!("element {label} is of gmsh's type {gmsh}, which no element here has");
            return Err(no_element(message, Some(span)));
        };
        if nodes.len() < count || !is_known(dimension, order.len()) {
            let message = format!("element {label} should have {count} nodes");
            return Err(unreadable(message, Some(span)));
        }
        let nodes: Vec<u64> = order.iter().map(|&place| nodes[place]).collect();
        if let Some(node) = nodes.iter().find(|node| !self.mesh.nodes.contains_key(node)) {
            let message = format!("element {label} has node {node}, which is not in the mesh");
            return Err(unreadable(message, Some(span)));
        }
        let cells = &mut self.mesh.cells;
        let place = *self.seen.entry((dimension, nodes.clone())).or_insert_with(|| {
            cells.push(Cell { label, dimension, nodes, span });
            cells.len() - 1
        });
        for &group in groups.iter().filter(|group| **group > 0) {
            self.groups.entry((dimension, group)).or_default().push(place);
        }
        Ok(())
    }

    fn finish(mut self, start: Span) -> Fallible<Mesh> {
        if self.mesh.cells.is_empty() {
            return Err(unreadable("the mesh has no elements", Some(start)));
        }
        for ((dimension, tag), cells) in self.groups {
            let name = self.names.remove(&(dimension, tag));
            let name = name.unwrap_or_else(|| format!("GROUP_{dimension}_{tag}"));
            self.mesh.groups.push(Group { name, dimension, cells, nodes: Vec::new() });
        }
        distinguish(&mut self.mesh.groups);
        Ok(self.mesh)
    }
}
