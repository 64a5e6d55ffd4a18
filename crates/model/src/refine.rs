//! The same problem on a mesh of half the width.
//!
//! ```text
//!   o-------o-------o        beams: a node in the middle of each
//!   o---x---o---x---o
//!
//!   .o---.   .o-x-.          slave nodes on a rigid body: a node on the circle
//!        o         x o       that their neighbours lie on
//! ```
//!
//! What is refined is what the deck approximates: beams, quadrilaterals (in four),
//! the contact elements on them, slide lines, and contact elements on the rim of a rigid body,
//! whose true shape is taken to be the circle (or straight line) through
//! neighbouring nodes. Sections, laws, steps and requests stay. Beams in a
//! row that approximate a bow stay the polygon that they are.

mod edge;
mod temperatures;

use crate::contact::ContactElement;
use crate::element::block::{Element, Elements};
use crate::element::section::Section;
use crate::initial_stress::{InitialHardening, InitialStress};
use crate::model::Model;
use crate::node::{Dof, Node, NodeIndex, RigidLink};
use crate::presence::{ElementIndex, Presence};
use crate::step::{Prescribed, Step};
use crate::surface::Master;
use edge::{Edge, edge, refusal, unknown_cell};
use slideline_diag::{Diagnostic, Span};
use slideline_mech::element::cell::QUAD4;
use std::collections::{HashMap, HashSet};

/// The model with every beam, and every contact element, in two. Old nodes
/// and elements keep their labels, new ones follow the largest.
///
/// # Errors
/// Where a contact element or a slide line joins nodes between which the
/// shape is not known.
pub fn refine(model: &Model) -> Result<Model, Box<Diagnostic>> {
    let mut halving = Halving::new(model);
    halving.elements()?;
    for place in 0..model.contact_pairs.len() {
        halving.contact(model, place)?;
    }
    halving.sets(model);
    temperatures::fill(&mut halving.model, &halving.added)?;
    halving.model.find_edges();
    Ok(halving.model)
}

/// The parts of elements have the axes of the whole.
fn part_axes(section: &mut Section, begin: &[usize]) {
    if let Section::Solid(solid) = section {
        solid.orientation = solid.orientation.take().map(|all| all.parted(begin));
    }
}

struct Halving {
    model: Model,
    /// The node between two others, where one is known.
    middles: HashMap<Edge, NodeIndex>,
    /// Each new node with the two between which it stands.
    added: Vec<(NodeIndex, Edge)>,
    masters: HashMap<NodeIndex, NodeIndex>,
    bodies: HashSet<NodeIndex>,
    next_node: u64,
    next_element: u64,
}

impl Halving {
    fn new(model: &Model) -> Self {
        let masters: HashMap<_, _> =
            model.rigid_links.iter().map(|link| (link.dependent, link.master)).collect();
        let mut bodies: HashSet<_> = masters.values().copied().collect();
        for pair in &model.contact_pairs {
            bodies.extend(pair.rigid_surfaces().map(|surface| surface.reference));
        }
        Self {
            middles: HashMap::new(),
            added: Vec::new(),
            masters,
            bodies,
            next_node: model.nodes.iter().map(|node| node.label).max().unwrap_or(0) + 1,
            next_element: largest_element(model) + 1,
            model: model.clone(),
        }
    }

    /// The reference node of the rigid body that a node belongs to.
    fn body(&self, node: NodeIndex) -> Option<NodeIndex> {
        let mut at = node;
        for _ in 0..=self.masters.len() {
            match self.masters.get(&at) {
                Some(&master) => at = master,
                None => return self.bodies.contains(&at).then_some(at),
            }
        }
        None
    }

    /// The rigid body to which both belong.
    fn same_body(&self, [a, b]: [NodeIndex; 2]) -> Option<NodeIndex> {
        self.body(a).filter(|&body| self.body(b) == Some(body))
    }

    fn add_node(&mut self, position: [f64; 3], ends: [NodeIndex; 2], origin: Span) -> NodeIndex {
        let node = self.model.nodes.insert(Node { label: self.next_node, position, origin });
        self.next_node += 1;
        self.middles.insert(edge(ends), node);
        self.added.push((node, ends));
        node
    }

    fn element_label(&mut self) -> u64 {
        self.next_element += 1;
        self.next_element - 1
    }

    /// The node in the middle of a beam's edge; `weights` of the nodes of
    /// `stencil` give its position.
    fn middle(
        &mut self,
        ends: [NodeIndex; 2],
        stencil: &[(NodeIndex, f64)],
        origin: Span,
    ) -> NodeIndex {
        if let Some(&known) = self.middles.get(&edge(ends)) {
            return known;
        }
        let mut position = [0.0; 3];
        for &(node, weight) in stencil {
            let from = self.model.nodes.get(node).position;
            for (into, x) in position.iter_mut().zip(from) {
                *into += weight * x;
            }
        }
        self.add_node(position, ends, origin)
    }

    fn elements(&mut self) -> Result<(), Box<Diagnostic>> {
        let mut blocks = std::mem::take(&mut self.model.blocks);
        // where the parts of every element begin
        let mut begin: Vec<Vec<usize>> = Vec::with_capacity(blocks.len());
        for block in &mut blocks {
            if !block.kind.joins() {
                begin.push((0..=block.elements.len()).collect());
                continue;
            }
            let mut parts = Elements::new(block.kind.cell.nodes);
            let mut own = vec![0];
            for element in &block.elements {
                match block.kind.cell {
                    _ if block.kind.is_beam() || block.kind.is_space_beam() => {
                        self.halve(element, &mut parts);
                    }
                    cell if *cell == QUAD4 => self.quarter(element, &mut parts),
                    _ => return Err(unknown_cell(block.word(), block.origin)),
                }
                own.push(parts.len());
            }
            part_axes(&mut block.section, &own);
            begin.push(own);
            block.elements = parts;
        }
        self.model.blocks = blocks;
        self.presence(&begin);
        Ok(())
    }

    /// The parts of an element that is absent are, those of one that begins begin, and those of one
    /// under stress are.
    fn presence(&mut self, begin: &[Vec<usize>]) {
        let parts = |&(block, member): &ElementIndex| {
            let own = begin.get(block).map_or(&[][..], Vec::as_slice);
            let first = own.get(member).copied().unwrap_or_default();
            (first..own.get(member + 1).copied().unwrap_or(first)).map(move |part| (block, part))
        };
        let hardening = std::mem::take(&mut self.model.initial_hardening);
        self.model.initial_hardening = hardening
            .into_iter()
            .flat_map(|own| {
                parts(&own.element).map(move |element| InitialHardening { element, ..own.clone() })
            })
            .collect();
        let stresses = std::mem::take(&mut self.model.initial_stresses);
        self.model.initial_stresses = stresses
            .into_iter()
            .flat_map(|own| {
                let of = own.clone();
                parts(&own.element).map(move |element| InitialStress { element, ..of.clone() })
            })
            .collect();
        for step in &mut self.model.steps {
            let Presence { absent, begun, .. } = &mut step.presence;
            for list in [absent, begun] {
                *list = list.iter().flat_map(parts).collect();
            }
            for changed in &mut step.sections {
                let own = begin.get(changed.block).map_or(&[][..], Vec::as_slice);
                part_axes(&mut changed.section, own);
            }
        }
    }

    /// A quadrilateral in four.
    fn quarter(&mut self, element: Element<'_>, into: &mut Elements) {
        let Element { label, nodes, origin } = element;
        let [a, b, c, d] = *nodes else { return };
        let sides = [[a, b], [b, c], [c, d], [d, a]];
        let sides = sides.map(|ends| self.middle(ends, &[(ends[0], 0.5), (ends[1], 0.5)], origin));
        let corners = [(a, 0.25), (b, 0.25), (c, 0.25), (d, 0.25)];
        let [ab, bc, cd, da] = sides;
        let centre = self.middle([ab, cd], &corners, origin);
        let parts =
            [[a, ab, centre, da], [ab, b, bc, centre], [centre, bc, c, cd], [da, centre, cd, d]];
        for (place, part) in parts.iter().enumerate() {
            let label = if place == 0 { label } else { self.element_label() };
            into.push(label, part, origin);
        }
    }

    /// A beam in two. One between nodes of the same rigid body strains
    /// nothing and stays.
    fn halve(&mut self, beam: Element<'_>, into: &mut Elements) {
        let Element { label, nodes, origin } = beam;
        let ends = beam.ends();
        if self.same_body(ends).is_some() {
            return into.push(label, nodes, origin);
        }
        let new = self.element_label();
        match *nodes {
            // the parabola through the three nodes, at its quarters
            [a, m, b] => {
                self.middles.insert(edge(ends), m);
                let first = [(a, 0.375), (m, 0.75), (b, -0.125)];
                let last = [(a, -0.125), (m, 0.75), (b, 0.375)];
                let first = self.middle([a, m], &first, origin);
                let last = self.middle([m, b], &last, origin);
                into.push(label, &[a, first, m], origin);
                into.push(new, &[m, last, b], origin);
            }
            _ => {
                let [a, b] = ends;
                let m = self.middle(ends, &[(a, 0.5), (b, 0.5)], origin);
                into.push(label, &[a, m], origin);
                into.push(new, &[m, b], origin);
            }
        }
    }

    fn contact(&mut self, model: &Model, place: usize) -> Result<(), Box<Diagnostic>> {
        let pair = &model.contact_pairs[place];
        let chain: Vec<Edge> = pair.elements.iter().map(|element| element.nodes).collect();
        let mut halves = Vec::with_capacity(2 * chain.len());
        for (k, element) in pair.elements.iter().enumerate() {
            let m = self.between(model, &chain, k, element.origin)?;
            let [a, b] = element.nodes;
            let label = self.element_label();
            let [first, last] = element.lumping.halved();
            halves.push(ContactElement { nodes: [a, m], lumping: first, ..*element });
            halves.push(ContactElement { label, nodes: [m, b], lumping: last, ..*element });
        }
        self.model.contact_pairs[place].elements = halves;
        if let Master::SlideLine(line) = &pair.master {
            let chain: Vec<Edge> = line.nodes.windows(2).map(|pair| [pair[0], pair[1]]).collect();
            let mut nodes: Vec<NodeIndex> = line.nodes.first().copied().into_iter().collect();
            for (k, ends) in chain.iter().enumerate() {
                nodes.push(self.between(model, &chain, k, line.origin)?);
                nodes.push(ends[1]);
            }
            if let Master::SlideLine(into) = &mut self.model.contact_pairs[place].master {
                into.nodes = nodes;
                into.extension *= 2.0; // a fraction of an end segment that is half as long
            }
        }
        self.halve_left_out(place);
        Ok(())
    }

    /// Halves the faces of a pair that do not meet one another.
    fn halve_left_out(&mut self, place: usize) {
        let middles = &self.middles;
        let halve = |faces: &mut Vec<Vec<NodeIndex>>| {
            let halves = |face: Vec<NodeIndex>| match face[..] {
                [a, b] => match middles.get(&edge([a, b])) {
                    Some(&middle) => vec![vec![a, middle], vec![middle, b]],
                    None => vec![face],
                },
                _ => vec![face],
            };
            *faces = std::mem::take(faces).into_iter().flat_map(halves).collect();
        };
        for own in &mut self.model.contact_pairs[place].left_out {
            halve(&mut own.slave);
            halve(&mut own.master);
        }
    }

    /// The node between the ends of an edge of a chain: that of the beam
    /// there, or a new one on the rim of a rigid body.
    fn between(
        &mut self,
        model: &Model,
        chain: &[Edge],
        place: usize,
        origin: Span,
    ) -> Result<NodeIndex, Box<Diagnostic>> {
        let ends = chain[place];
        if let Some(&known) = self.middles.get(&edge(ends)) {
            return Ok(known);
        }
        let labels = ends.map(|node| model.nodes.label(node));
        let Some(master) = self.same_body(ends) else {
            return Err(refusal(labels, "no beam joins them and they share no rigid body", origin));
        };
        let Some(at) = rim(model, chain, place) else {
            let reason = "they and their neighbours lie neither on one circle nor on a line";
            return Err(refusal(labels, reason, origin));
        };
        let node = self.add_node(at, ends, origin);
        self.model.rigid_links.push(RigidLink::welded(node, master, origin));
        Ok(node)
    }

    /// New nodes join every set, and every motion prescribed to a set, of
    /// both nodes between which they stand.
    fn sets(&mut self, model: &Model) {
        for set in &mut self.model.node_sets {
            let members: HashSet<_> = set.members.iter().copied().collect();
            let joins = |ends: &Edge| ends.iter().all(|end| members.contains(end));
            let new = self.added.iter().filter(|(_, ends)| joins(ends)).map(|&(node, _)| node);
            set.members.extend(new);
        }
        for (step, old) in self.model.steps.iter_mut().zip(&model.steps) {
            for &(node, ends) in &self.added {
                if self.masters.contains_key(&ends[0]) {
                    continue; // it moves with its body
                }
                let held = Dof::ALL.into_iter().filter_map(|dof| held_together(old, ends, dof));
                step.prescribed.extend(held.map(|motion| Prescribed { node, ..motion }));
            }
        }
    }
}

/// The motion that one line of the deck prescribes to both nodes.
fn held_together(step: &Step, ends: Edge, dof: Dof) -> Option<Prescribed> {
    let of = |node| step.prescribed.iter().find(|p| p.node == node && p.dof == dof);
    let (first, last) = (of(ends[0])?, of(ends[1])?);
    let same = first.origin == last.origin
        && first.value == last.value
        && first.amplitude == last.amplitude;
    same.then(|| first.clone())
}

fn largest_element(model: &Model) -> u64 {
    let structural = model.blocks.iter().flat_map(|block| &block.elements).map(|e| e.label);
    let pairs = model.contact_pairs.iter();
    let contact = pairs.flat_map(|pair| pair.elements.iter().map(|element| element.label));
    structural.chain(contact).max().unwrap_or(0)
}

/// By how much of the sagitta the two circles may disagree [1].
const AGREEMENT: f64 = 0.05;
/// Flatter than this, as a fraction of its chord, an arc is a line [1].
const FLAT: f64 = 1e-9;

/// The point halfway between the ends of an edge on the circle through them
/// and a neighbour, on either side the same [L].
fn rim(model: &Model, chain: &[Edge], place: usize) -> Option<[f64; 3]> {
    let [a, b] = chain[place];
    let before = place.checked_sub(1).map(|k| chain[k]).filter(|edge| edge[1] == a);
    let after = chain.get(place + 1).filter(|edge| edge[0] == b);
    let at = |node| model.nodes.position(node);
    let [pa, pb] = [at(a), at(b)];
    let sagittas: Vec<f64> = [before.map(|edge| edge[0]), after.map(|edge| edge[1])]
        .into_iter()
        .flatten()
        .map(|third| sagitta(pa, pb, at(third)))
        .collect();
    let chord = [pb[0] - pa[0], pb[1] - pa[1]];
    let length = chord[0].hypot(chord[1]);
    let mean = sagittas.iter().sum::<f64>() / sagittas.len() as f64; // NaN without neighbours
    let agrees = |s: &f64| (s - mean).abs() <= AGREEMENT * mean.abs() + FLAT * length;
    if !mean.is_finite() || !sagittas.iter().all(agrees) {
        return None;
    }
    let normal = [-chord[1] / length, chord[0] / length, 0.0];
    Some([0, 1, 2].map(|k| 0.5 * (pa[k] + pb[k]) + mean * normal[k]))
}

/// How far the minor arc over the chord a b of the circle through c stands
/// off the chord, along its left normal [L].
fn sagitta(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> f64 {
    let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    let length = dx.hypot(dy);
    let (ex, ey) = (dx / length, dy / length);
    // c in the frame of the chord, from its middle
    let [cx, cy] = [c[0] - 0.5 * (a[0] + b[0]), c[1] - 0.5 * (a[1] + b[1])];
    let (u, v) = (cx * ex + cy * ey, cy * ex - cx * ey);
    // centre at (0, w): u2 + v2 - 2 v w = (l/2)2
    let half = 0.5 * length;
    if v.abs() <= FLAT * length {
        return 0.0;
    }
    let w = (u * u + v * v - half * half) / (2.0 * v);
    // of the two arcs the smaller one, which the third point is not on: on the far side of w
    -(half * half / (w.abs() + w.hypot(half))) * w.signum()
}

#[cfg(test)]
mod tests;
