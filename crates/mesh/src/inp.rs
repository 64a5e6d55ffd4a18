//! The deck that gmsh writes: nodes, elements, sets. gmsh calls all lines trusses and all areas
//! plane stress; what they are is said by the wishes.

use crate::corners::is_known;
use crate::fault::{no_element, unreadable};
use crate::mesh::{Cell, Group, Mesh};
use slideline_deck::{Card, DataLine, MAX_VALUES, NoFiles, parse};
use slideline_diag::{Diagnostic, Severity, Sources, Span};
use slideline_model::element_type;
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
    for card in &parsed.deck.cards {
        match card.keyword.name.as_str() {
            "NODE" => nodes(card, &mut mesh)?,
            "ELEMENT" => elements(card, &mut mesh, &mut places, &mut blocks)?,
            "ELSET" => {
                let own = members(card)?.into_iter().filter_map(|label| places.get(&label));
                let own: Vec<usize> = own.copied().collect();
                sets.named(&title(card, "ELSET")?).cells.extend(own);
            }
            "NSET" => {
                let own = members(card)?;
                sets.named(&title(card, "NSET")?).nodes.extend(own);
            }
            _ => {} // a heading; a deck with more than a mesh is a deck already
        }
    }
    if mesh.cells.is_empty() {
        let start = parsed.deck.files.first().map(|file| Span::new(file.file, 0, 0));
        return Err(unreadable("the mesh has no elements", start));
    }
    // blocks are entities, of which gmsh makes sets where no group has a name
    let mut groups = if sets.0.is_empty() { blocks.0 } else { sets.0 };
    for group in &mut groups {
        let dimensions = group.cells.iter().map(|&cell| mesh.cells[cell].dimension);
        group.dimension = dimensions.max().unwrap_or_default();
    }
    mesh.groups = groups;
    Ok(mesh)
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

fn members(card: &Card) -> Fallible<Vec<u64>> {
    let lines: Vec<Vec<u64>> = card.data.iter().map(whole).collect::<Fallible<_>>()?;
    if card.parameter("GENERATE").is_none() {
        return Ok(lines.concat());
    }
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

fn nodes(card: &Card, mesh: &mut Mesh) -> Fallible<()> {
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
    let cell = element_type(&kind).map(|row| row.cell);
    let Some((dimension, count)) = cell.map(|cell| (cell.dimension, cell.nodes)) else {
        let message = format!("elements of type {kind} have no counterpart here");
        return Err(no_element(message, Some(card.span)));
    };
    if !is_known(dimension, count) {
        let message = format!("elements of type {kind} are no part of a mesh");
        return Err(no_element(message, Some(card.span)));
    }
    let name = title(card, "ELSET").unwrap_or_else(|_| kind.clone());
    // an element may take more than one line
    let numbers: Vec<(u64, Span)> = card
        .data
        .iter()
        .map(|line| Ok(whole(line)?.into_iter().map(|number| (number, line.span)).collect()))
        .collect::<Fallible<Vec<Vec<_>>>>()?
        .concat();
    for chunk in numbers.chunks(count + 1) {
        let (label, span) = chunk[0];
        let nodes: Vec<u64> = chunk[1..].iter().map(|(node, _)| *node).collect();
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
        places.insert(label, mesh.cells.len());
        blocks.named(&name).cells.push(mesh.cells.len());
        mesh.cells.push(Cell { label, dimension, nodes, span });
    }
    Ok(())
}
