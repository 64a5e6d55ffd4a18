//! Nodes, elements and sections that cannot be meant.

use crate::finding::{Finding, Place};
use crate::start::{Start, length, less};
use slideline_diag::{Code, Diagnostic};
use slideline_model::{ContactPair, Dof, Element, Master, NodeIndex, SlideLine, Vocabulary};
use std::collections::BTreeMap;

/// Ratio of neighbouring element lengths that spoils both [1].
const UNEVEN: f64 = 10.0;

/// SL0410 and SL0412.
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    same_place(start, findings);
    stout(start, findings);
    findings.extend(uneven(start));
    for pair in &start.model.contact_pairs {
        // faces of solids come in their order, and a tooth may be pointed
        if let Master::SlideLine(line) = &pair.master
            && pair.vocabulary != Vocabulary::Faces
        {
            findings.extend(doubles_back(start, pair, line));
        }
    }
}

fn beam_nodes(start: &Start<'_>) -> Vec<NodeIndex> {
    let blocks = start.model.blocks.iter().filter_map(|block| block.beams());
    let mut nodes: Vec<NodeIndex> = blocks
        .flat_map(|block| block.elements)
        .flat_map(|element| element.nodes)
        .copied()
        .collect();
    nodes.sort_unstable();
    nodes.dedup();
    nodes
}

/// Whether two nodes of two bodies may stand at one place: both held there,
/// joined by a spring, or sides of a contact pair.
fn stand_apart(start: &Start<'_>, a: NodeIndex, b: NodeIndex) -> bool {
    let model = start.model;
    let held = |node| {
        let holds = |dof| {
            let step = model.steps.first();
            step.is_some_and(|step| step.prescribed.iter().any(|p| p.node == node && p.dof == dof))
        };
        holds(Dof::U1) && holds(Dof::U2)
    };
    let mut springs = model.blocks.iter().filter_map(|block| block.springs());
    let joined = springs.any(|springs| {
        springs.elements.iter().any(|e| e.nodes.contains(&a) && e.nodes.contains(&b))
    });
    let touching = model.contact_pairs.iter().any(|pair| {
        let slave = |node| pair.slave_places().any(|own| own == node);
        let master = |node| match &pair.master {
            Master::SlideLine(line) => line.nodes.contains(&node),
            Master::Faces(faces) => faces.faces.iter().any(|face| face.nodes.contains(&node)),
            Master::Itself(surface) => surface.nodes().any(|own| own == node),
            Master::RigidSurface(_) => false,
        };
        slave(a) && master(b) || slave(b) && master(a)
    });
    held(a) && held(b) || joined || touching
}

/// More common places of two bodies than a joint has: one is a copy.
const JOINT: usize = 2;

/// SL0410: two beam nodes at one place that do not move together. Of a body
/// that is there twice SL0411 speaks.
fn same_place(start: &Start<'_>, findings: &mut Vec<Finding>) {
    let nodes = &start.model.nodes;
    let mut beams = beam_nodes(start);
    beams.retain(|&node| start.bodies.dependent[node].is_none());
    beams.sort_by(|&a, &b| nodes.position(a)[0].total_cmp(&nodes.position(b)[0]));
    let near = 1e-9 * start.reach;
    let mut found: Vec<[NodeIndex; 2]> = Vec::new();
    for (place, &a) in beams.iter().enumerate() {
        let follow = beams[place + 1..].iter();
        for &b in follow.take_while(|&&b| nodes.position(b)[0] - nodes.position(a)[0] <= near) {
            let apart = length(less(nodes.position(a), nodes.position(b))) > near;
            let one_body = start.bodies.of_node(a) == start.bodies.of_node(b);
            if apart || one_body || stand_apart(start, a, b) {
                continue;
            }
            found.push([a.min(b), a.max(b)]);
        }
    }
    let bodies = |pair: &[NodeIndex; 2]| pair.map(|node| start.bodies.of_node(node));
    for pair in &found {
        if found.iter().filter(|other| bodies(other) == bodies(pair)).count() <= JOINT {
            findings.push(not_joined(start, *pair));
        }
    }
}

fn not_joined(start: &Start<'_>, [first, second]: [NodeIndex; 2]) -> Finding {
    let nodes = &start.model.nodes;
    let labels = [nodes.name(first), nodes.name(second)];
    let message = format!(
        "beam nodes {} and {} are at the same place but not connected: the beam has a gap there",
        labels[0], labels[1]
    );
    let said = Diagnostic::warning(Code("SL0410"), message)
        .at(nodes.get(second).origin)
        .help("use one node for both elements, or connect them with *MPC of type BEAM");
    let card = format!("*MPC\nBEAM, {}, {}\n", labels[1], labels[0]);
    match start.model.steps.first() {
        Some(step) => Finding::with(said, Place::Before(step.origin), card),
        None => Finding::said(said),
    }
}

fn long(start: &Start<'_>, element: Element<'_>) -> f64 {
    let [a, b] = element.ends().map(|node| start.model.nodes.position(node));
    length(less(b, a))
}

/// SL0412: a part that is no beam. All beams of a body count together: a set
/// may be a short piece of a long beam.
fn stout(start: &Start<'_>, findings: &mut Vec<Finding>) {
    let blocks = || start.model.blocks.iter().filter_map(|block| block.beams());
    let mut whole: BTreeMap<NodeIndex, f64> = BTreeMap::new();
    for element in blocks().flat_map(|block| block.elements) {
        *whole.entry(start.bodies.of_node(element.nodes[0])).or_default() += long(start, element);
    }
    let mut told: Vec<NodeIndex> = Vec::new();
    for block in blocks() {
        let height = block.section.shape.height();
        let flexible = block
            .elements
            .iter()
            .filter(|e| e.ends().iter().any(|&node| start.bodies.dependent[node].is_none()));
        for element in flexible {
            let body = start.bodies.of_node(element.nodes[0]);
            let whole = whole.get(&body).copied().unwrap_or_default();
            if whole >= 3.0 * height || told.contains(&body) {
                continue;
            }
            told.push(body);
            let message = format!(
                "the beams of {} and of the body they belong to are {whole:.3e} long in all and \
                 {height:.3e} high: beam theory does not describe such a part",
                block.name
            );
            let said = Diagnostic::warning(Code("SL0412"), message).at(block.origin);
            findings.push(Finding::said(said.help(
                "check *BEAM SECTION: width (out of plane) first, then height; and that both are \
                 in the unit of *NODE",
            )));
        }
    }
}

/// SL0412: neighbours of very different length.
fn uneven(start: &Start<'_>) -> Option<Finding> {
    let blocks = start.model.blocks.iter().filter_map(|block| block.beams());
    let mut at_node: BTreeMap<NodeIndex, Element<'_>> = BTreeMap::new();
    let rigid = |e: &Element<'_>| e.ends().iter().all(|&n| start.bodies.dependent[n].is_some());
    for element in blocks.flat_map(|block| block.elements).filter(|element| !rigid(element)) {
        for node in element.ends() {
            let Some(other) = at_node.insert(node, element) else { continue };
            let (one, two) = (long(start, other), long(start, element));
            if one.max(two) > UNEVEN * one.min(two) {
                let message = format!(
                    "neighbouring beams {} and {} are {one:.3e} and {two:.3e} long: contact areas \
                     and forces jump between them",
                    other.label, element.label
                );
                let said = Diagnostic::advice(Code("SL0412"), message).at(element.origin);
                return Some(Finding::said(
                    said.help("let element lengths change gradually in *NODE and *NGEN"),
                ));
            }
        }
    }
    None
}

/// SL0412: a slide line that turns back upon itself.
fn doubles_back(start: &Start<'_>, pair: &ContactPair, line: &SlideLine) -> Option<Finding> {
    let at = |node| start.model.nodes.position(node);
    let back = line.nodes.windows(3).find(|w| {
        let (a, b) = (less(at(w[1]), at(w[0])), less(at(w[2]), at(w[1])));
        a[0] * b[0] + a[1] * b[1] < -0.5 * length(a) * length(b)
    })?;
    let message = format!(
        "the slide line of {} turns back at node {}: its nodes are not listed in their order \
         along the part",
        pair.name,
        start.model.nodes.name(back[1])
    );
    let said = Diagnostic::warning(Code("SL0412"), message).at(line.origin);
    Some(Finding::said(said.help(pair.vocabulary.order_chain())))
}
