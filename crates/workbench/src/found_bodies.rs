//! Where a rigid body of elements stands: what is added to the coordinates of all its nodes.
//!
//! A body is looked for in the model, its numbers in the lines of `*NODE`. Nodes that are generated
//! follow those that they are generated from; whether all of them do, and nothing else, is measured
//! ([`Body::is_moved_alone`]).

use crate::places::Follows;
use crate::search::{Number, Search, parameter, shifted};
use slideline::Read;
use slideline::deck::{Card, DataLine, Field, parse_number};
use slideline::diag::{FileId, Span};
use slideline::model::{Model, NodeIndex};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// Types of elements that have no stiffness of their own, with which rigid bodies are drawn.
const DRAWN: [&str; 4] = ["R2D2", "RAX2", "R3D3", "R3D4"];

/// A rigid body that may be moved along an axis.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Body {
    /// The set that it is made of.
    pub owner: String,
    pub axis: usize,
    /// Its nodes.
    pub nodes: BTreeSet<NodeIndex>,
    /// Smallest and largest coordinate of them along every axis [L].
    pub ends: [[f64; 2]; 3],
    /// Coordinates that are written in the deck, and where.
    written: Vec<(Span, f64)>,
}

impl Body {
    /// A slider and the coordinates that follow it.
    pub fn search(&self, search: &mut Search) {
        let slider = search.add(Number::shift(self.axis, &self.owner, self.ends));
        for (span, value) in &self.written {
            search.follow(*span, *value, Follows::Moved(slider));
        }
    }

    /// How far it is moved where that is tried [L].
    pub fn trial(&self) -> f64 {
        shifted(self.axis, self.ends)
    }

    /// Whether its nodes, and they alone, stand elsewhere in another model by that much.
    pub fn is_moved_alone(&self, by: f64, [before, after]: [&Model; 2]) -> bool {
        let size = self.ends.as_flattened().iter().fold(by.abs(), |most, own| most.max(own.abs()));
        before.nodes.len() == after.nodes.len()
            && before.nodes.iter().zip(after.nodes.iter()).enumerate().all(|(index, (old, new))| {
                let mut wanted = old.position;
                if !self.nodes.contains(&index) {
                    return new.position == wanted;
                }
                wanted[self.axis] += by;
                let off = wanted.iter().zip(new.position).map(|(own, new)| (own - new).abs());
                off.fold(0.0, f64::max) <= ROUNDING * size
            })
    }
}

/// Part of the size of a body by which generated nodes may miss it: what rounding leaves.
const ROUNDING: f64 = 1e-12;

/// Rigid bodies of nodes that are part of nothing else, once for each axis.
pub(crate) fn bodies(read: &Read) -> Vec<Body> {
    let (Some(model), Some(file)) = (&read.model, read.deck.files.first()) else {
        return Vec::new();
    };
    let mut members: BTreeMap<NodeIndex, (Span, BTreeSet<NodeIndex>)> = BTreeMap::new();
    for link in &model.rigid_links {
        let own = members.entry(link.master).or_insert((link.origin, BTreeSet::new()));
        own.1.insert(link.dependent);
    }
    let lines = lines(&read.deck.cards, file.file);
    let axes = if model.is_in_space() { 3 } else { 2 };
    let mut found = Vec::new();
    for (master, (origin, mut nodes)) in members {
        if is_drawn_with(model.nodes.label(master), &read.deck.cards) {
            nodes.insert(master);
        }
        let card = read.deck.cards.iter().find(|card| card.span == origin);
        let Some(card) = card.filter(|card| card.keyword.name == "RIGIDBODY") else { continue };
        // one whose reference node is a node of a part hangs on that part
        let held: BTreeSet<NodeIndex> = nodes.iter().copied().chain([master]).collect();
        if is_part_of_more(model, &held) {
            continue;
        }
        let all = (0..axes).map(|axis| body(model, &lines, (owner(card), axis), &nodes));
        found.extend(all.filter(|own| !own.written.is_empty()));
    }
    found
}

/// Data lines of `*NODE` in the file of the deck, by their places.
fn lines(cards: &[Card], file: FileId) -> HashMap<Span, &DataLine> {
    let nodes = cards.iter().filter(|card| card.keyword.name == "NODE");
    let lines = nodes.flat_map(|card| &card.data).filter(|line| line.span.file == file);
    lines.map(|line| (line.span, line)).collect()
}

/// Whether elements that draw rigid bodies name a node.
fn is_drawn_with(label: u64, cards: &[Card]) -> bool {
    let of_rigid =
        |card: &&Card| card.keyword.name == "ELEMENT" && DRAWN.contains(&&*parameter(card, "TYPE"));
    let lines = cards.iter().filter(of_rigid).flat_map(|card| &card.data);
    let named = |field: &Field| field.text.trim().parse() == Ok(label);
    lines.into_iter().any(|line| line.fields.iter().skip(1).any(named))
}

/// Whether an element has nodes of a body and others.
fn is_part_of_more(model: &Model, nodes: &BTreeSet<NodeIndex>) -> bool {
    let mut elements = model.blocks.iter().flat_map(|block| block.elements.iter());
    elements.any(|own| {
        let inside = own.nodes.iter().filter(|node| nodes.contains(node)).count();
        inside > 0 && inside < own.nodes.len()
    })
}

fn owner(card: &Card) -> String {
    let names = ["ELSET", "TIENSET", "PINNSET", "NSET"].map(|name| parameter(card, name));
    names.into_iter().find(|name| !name.is_empty()).unwrap_or_default()
}

fn body(
    model: &Model,
    lines: &HashMap<Span, &DataLine>,
    (owner, axis): (String, usize),
    nodes: &BTreeSet<NodeIndex>,
) -> Body {
    let own: Vec<_> = nodes.iter().map(|&node| model.nodes.get(node)).collect();
    let ends = [0, 1, 2].map(|axis| {
        let along = own.iter().map(|node| node.position[axis]);
        along.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], own| {
            [low.min(own), high.max(own)]
        })
    });
    let written = own.iter().filter_map(|node| {
        let field = lines.get(&node.origin)?.fields.get(1 + axis)?;
        let value = parse_number(&field.text).ok().filter(|value| value.is_finite())?;
        Some((field.span, value))
    });
    let written = written.collect();
    Body { owner, axis, nodes: nodes.clone(), ends, written }
}
