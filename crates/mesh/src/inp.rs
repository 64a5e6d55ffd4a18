//! Nodes, elements, sets and surfaces of a deck, as gmsh and meshio write them, and in the forms of
//! FreeCAD, PrePoMax and Netgen. A type names no more than a cell: gmsh calls all lines trusses and
//! all areas plane stress, meshio bricks C3D8RH; what they are is said by the wishes.

use crate::corners::{is_known, kept};
use crate::fault::{no_element, unreadable};
use crate::mesh::{Cell, Group, Mesh};
use crate::msh::WEDGE as GMSH_WEDGE;
use crate::names::distinguish;
use crate::shapes::{faces, shape};
use slideline_deck::{Card, DataLine, MAX_VALUES, NoFiles, parse};
use slideline_diag::{Diagnostic, Severity, Sources, Span};
use std::collections::HashMap;

type Fallible<T> = Result<T, Box<Diagnostic>>;

/// Sets of a deck by their names, in the order of the deck.
#[derive(Default)]
struct Sets(Vec<Group>);

impl Sets {
    fn named(&mut self, name: &str) -> &mut Group {
        let place = self.0.iter().position(|own| own.name == name).unwrap_or_else(|| {
            self.0.push(Group { name: name.to_owned(), ..Group::default() });
            self.0.len() - 1
        });
        &mut self.0[place]
    }

    /// The set of a name; capitals do not matter in a deck.
    fn find(&self, name: &str) -> Option<&Group> {
        self.0.iter().find(|own| own.name.eq_ignore_ascii_case(name))
    }
}

/// Reads a mesh.
pub(crate) fn read(sources: &mut Sources, name: &str, bytes: &[u8]) -> Fallible<Mesh> {
    let parsed = parse(sources, name, bytes, &NoFiles);
    if let Some(said) = parsed.diagnostics.iter().find(|said| said.severity == Severity::Error) {
        return Err(Box::new(said.clone()));
    }
    let mut mesh = Mesh::default();
    let mut places = HashMap::new();
    let (mut blocks, mut sets) = (Sets::default(), Sets::default());
    // nodes that their own card gives a name to, mostly all: named only by other sets
    let (mut lists, mut surfaces) = (Sets::default(), Vec::new());
    for card in &parsed.deck.cards {
        match card.keyword.name.as_str() {
            "NODE" => nodes(card, &mut mesh, &mut lists)?,
            "ELEMENT" => elements(card, &mut mesh, &mut places, &mut blocks)?,
            "ELSET" => {
                let own = members(card, |name| {
                    let set = sets.find(name).or_else(|| blocks.find(name))?;
                    Some(set.cells.iter().map(|&cell| mesh.cells[cell].label).collect())
                })?;
                let own: Vec<usize> = own.iter().filter_map(|l| places.get(l)).copied().collect();
                sets.named(&title(card, "ELSET")?).cells.extend(own);
            }
            "NSET" => {
                let own = members(card, |name| {
                    let set = sets.find(name).or_else(|| lists.find(name));
                    set.map(|set| mesh.nodes_of(set))
                })?;
                sets.named(&title(card, "NSET")?).nodes.extend(own);
            }
            "SURFACE" => surfaces.push(card),
            _ => {} // a heading; a deck with more than a mesh is a deck already
        }
    }
    if mesh.cells.is_empty() {
        let start = parsed.deck.files.first().map(|file| Span::new(file.file, 0, 0));
        return Err(unreadable("the mesh has no elements", start));
    }
    let surfaces = of_faces(&surfaces, &mut mesh, &places, &blocks, &mut sets)?;
    let mut groups = groups(blocks, sets);
    groups.extend(surfaces);
    for group in &mut groups {
        let dimensions = group.cells.iter().map(|&cell| mesh.cells[cell].dimension);
        group.dimension = dimensions.max().unwrap_or_default();
    }
    distinguish(&mut groups);
    mesh.groups = groups;
    Ok(mesh)
}

/// Blocks are parts; those of gmsh are entities, of which it makes sets where no group has a name.
fn groups(blocks: Sets, sets: Sets) -> Vec<Group> {
    let entity = |name: &str| {
        let numbered = |rest: &str| rest.bytes().all(|byte| byte.is_ascii_digit());
        ["Point", "Line", "Surface", "Volume"]
            .iter()
            .any(|kind| name.strip_prefix(kind).is_some_and(numbered))
    };
    let all = sets.0.is_empty();
    let same = |own: &Group| sets.find(&own.name).is_some();
    let kept = |own: &Group| all || !entity(&own.name) && shape(&own.name).is_none() && !same(own);
    let parts: Vec<Group> = blocks.0.iter().filter(|own| kept(own)).cloned().collect();
    parts.into_iter().chain(sets.0).collect()
}

/// Surfaces of element faces, as cells on these faces. Sets that begin with `_` serve a surface
/// alone: they are left out.
fn of_faces(
    surfaces: &[&Card],
    mesh: &mut Mesh,
    places: &HashMap<u64, usize>,
    blocks: &Sets,
    sets: &mut Sets,
) -> Fallible<Vec<Group>> {
    let (mut groups, mut served) = (Vec::new(), Vec::new());
    for card in surfaces {
        let mut group = Group { name: title(card, "NAME")?, ..Group::default() };
        for line in &card.data {
            let [set, face, ..] = &line.fields[..] else { continue };
            // S1, S2, ...; sides of shells and nodes are no faces
            let face = face.text.to_ascii_uppercase();
            let Some(face) = face.strip_prefix('S').and_then(|own| own.parse::<usize>().ok())
            else {
                continue;
            };
            let cells = match set.text.parse::<u64>() {
                Ok(label) => places.get(&label).map(|&cell| vec![cell]),
                Err(_) => sets
                    .find(&set.text)
                    .or_else(|| blocks.find(&set.text))
                    .map(|own| own.cells.clone()),
            };
            let Some(cells) = cells else {
                return Err(unreadable(
                    format!("there is no element or set `{}`", set.text),
                    Some(set.span),
                ));
            };
            served.push(set.text.to_uppercase());
            for cell in cells {
                let Cell { dimension, nodes, .. } = &mesh.cells[cell];
                let Some(own) = faces(*dimension, nodes.len()).get(face.wrapping_sub(1)) else {
                    continue; // a side of a shell
                };
                let nodes = own.iter().map(|&node| nodes[node]).collect();
                let own = Cell { label: 0, dimension: dimension - 1, nodes, span: line.span };
                group.cells.push(mesh.cells.len());
                mesh.cells.push(own);
            }
        }
        if !group.cells.is_empty() {
            groups.push(group);
        }
    }
    sets.0.retain(|own| !own.name.starts_with('_') || !served.contains(&own.name.to_uppercase()));
    // a surface of the name of a set of other things
    for own in groups.iter_mut().filter(|own| sets.find(&own.name).is_some()) {
        own.name.push_str("_FACES");
    }
    Ok(groups)
}

fn title(card: &Card, parameter: &str) -> Fallible<String> {
    let value = card.parameter(parameter).and_then(|own| own.value.as_ref());
    value
        .map(|word| word.raw.clone())
        .ok_or_else(|| unreadable(format!("*{parameter} has no name"), Some(card.span)))
}

fn whole(line: &DataLine) -> Fallible<Vec<u64>> {
    let fields = line.fields.iter().filter(|field| !field.text.is_empty());
    let number = |text: &str| text.parse::<u64>().ok();
    fields
        .map(|field| {
            number(&field.text).ok_or_else(|| {
                unreadable(format!("`{}` is no number", field.text), Some(field.span))
            })
        })
        .collect()
}

/// Numbers of a set; a name stands for the numbers of the set of that name.
fn members(card: &Card, named: impl Fn(&str) -> Option<Vec<u64>>) -> Fallible<Vec<u64>> {
    if card.parameter("GENERATE").is_none() {
        let fields = card.data.iter().flat_map(|line| &line.fields);
        let mut all = Vec::new();
        for field in fields.filter(|field| !field.text.is_empty()) {
            match field.text.parse::<u64>() {
                Ok(number) => all.push(number),
                Err(_) => all.extend(named(&field.text).ok_or_else(|| {
                    let message = format!("`{}` is no number, and no set before it", field.text);
                    unreadable(message, Some(field.span))
                })?),
            }
        }
        return Ok(all);
    }
    let lines: Vec<Vec<u64>> = card.data.iter().map(whole).collect::<Fallible<_>>()?;
    let ranges = lines.iter().map(|line| match line[..] {
        [first, last] => Ok((first, last, 1)),
        [first, last, by, ..] if by > 0 => Ok((first, last, by)),
        _ => Err(unreadable("a range has a first and a last number", Some(card.span))),
    });
    let ranges: Vec<(u64, u64, u64)> = ranges.collect::<Fallible<_>>()?;
    let counts = ranges.iter().map(|(first, last, by)| last.saturating_sub(*first) / by);
    let count = counts.fold(ranges.len() as u64, u64::saturating_add);
    if count > MAX_VALUES as u64 {
        return Err(unreadable("the ranges have too many numbers", Some(card.span)));
    }
    Ok(ranges.into_iter().flat_map(|(a, b, by)| (a..=b).step_by(by as usize)).collect())
}

fn nodes(card: &Card, mesh: &mut Mesh, lists: &mut Sets) -> Fallible<()> {
    let name = title(card, "NSET").ok();
    for line in &card.data {
        let mut fields = line.fields.iter();
        let label = fields.next().and_then(|field| field.text.parse().ok());
        let mut position = [0.0; 3];
        for (own, field) in position.iter_mut().zip(fields) {
            *own = slideline_deck::number(field)?;
        }
        let Some(label) = label else {
            return Err(unreadable("a node has a number and a position", Some(line.span)));
        };
        mesh.nodes.insert(label, position);
        if let Some(name) = &name {
            lists.named(name).nodes.push(label);
        }
    }
    Ok(())
}

fn elements(
    card: &Card,
    mesh: &mut Mesh,
    places: &mut HashMap<u64, usize>,
    blocks: &mut Sets,
) -> Fallible<()> {
    let kind = title(card, "TYPE")?.to_uppercase();
    let Some((dimension, count)) = shape(&kind) else {
        let message = format!("elements of type {kind} have no counterpart here");
        return Err(no_element(message, Some(card.span)));
    };
    if !is_known(dimension, kept(dimension, count)) {
        let message = format!("elements of type {kind} are no part of a mesh");
        return Err(no_element(message, Some(card.span)));
    }
    let name = title(card, "ELSET").unwrap_or_else(|_| kind.clone());
    let numbers: Vec<(u64, Span)> = card
        .data
        .iter()
        .map(|line| Ok(whole(line)?.into_iter().map(|number| (number, line.span)).collect()))
        .collect::<Fallible<Vec<Vec<_>>>>()?
        .concat();
    let full = is_of_full_wedges(&kind, &numbers);
    let count = if full { FULL_WEDGE.1 } else { count };
    for (place, chunk) in numbers.chunks(count + 1).enumerate() {
        let (label, span) = chunk[0];
        let mut nodes: Vec<u64> = chunk[1..].iter().map(|(node, _)| *node).collect();
        // an element may take more than one line, and ends with a line
        let behind = numbers.get((place + 1) * (count + 1));
        if behind.is_some_and(|behind| Some(behind.1) == chunk.last().map(|own| own.1)) {
            let message = format!(
                "element {label} has more numbers on its line than the {count} nodes of {kind}"
            );
            return Err(unreadable(message, Some(span)));
        }
        if nodes.len() < count {
            return Err(unreadable(
                format!("element {label} should have {count} nodes"),
                Some(span),
            ));
        }
        if let Some(node) = nodes.iter().find(|node| !mesh.nodes.contains_key(node)) {
            let message = format!("element {label} has node {node}, which is not in the mesh");
            return Err(unreadable(message, Some(span)));
        }
        if full {
            nodes = GMSH_WEDGE.iter().map(|&place| nodes[place]).collect();
        }
        nodes.truncate(kept(dimension, count));
        places.insert(label, mesh.cells.len());
        blocks.named(&name).cells.push(mesh.cells.len());
        mesh.cells.push(Cell { label, dimension, nodes, span });
    }
    Ok(())
}

/// What gmsh calls its wedges of the second order with the nodes in the middle of their faces, and how many nodes
/// they have: those of C3D15 have another name.
const FULL_WEDGE: (&str, usize) = ("C3D6", 18);

/// Whether all elements of a card are such wedges: one takes a line that is full, and what is left over.
fn is_of_full_wedges(kind: &str, numbers: &[(u64, Span)]) -> bool {
    let (name, count) = FULL_WEDGE;
    let lines: Vec<usize> = numbers.chunk_by(|a, b| a.1 == b.1).map(<[_]>::len).collect();
    let is_one = |lines: &[usize]| lines.len() == 2 && lines.iter().sum::<usize>() == count + 1;
    kind == name && !lines.is_empty() && lines.chunks(2).all(is_one)
}
