//! Nodes, elements and sections that cannot be meant.

use crate::finding::{Finding, Place};
use crate::start::{Start, length, less};
use slideline_diag::{Code, Diagnostic};
use slideline_model::{BeamBlock, NodeIndex};
use std::collections::BTreeMap;

/// Ratio of neighbouring element lengths that spoils both [1].
const UNEVEN: f64 = 10.0;

/// SL0410, SL0411 and SL0412.
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    same_place(start, findings);
    twice(start, findings);
    for block in start.model.blocks.iter().filter_map(|block| block.beams()) {
        findings.extend(stout(start, block));
        findings.extend(uneven(start, block));
    }
}

fn beam_nodes(start: &Start<'_>) -> Vec<NodeIndex> {
    let blocks = start.model.blocks.iter().filter_map(|block| block.beams());
    let mut nodes: Vec<NodeIndex> =
        blocks.flat_map(|block| &block.elements).flat_map(|element| element.all_nodes()).collect();
    nodes.sort_unstable();
    nodes.dedup();
    nodes
}

/// SL0410: two beam nodes at one place that do not move together.
fn same_place(start: &Start<'_>, findings: &mut Vec<Finding>) {
    let nodes = &start.model.nodes;
    let mut beams = beam_nodes(start);
    beams.retain(|&node| start.bodies.dependent[node].is_none());
    beams.sort_by(|&a, &b| nodes.plane(a)[0].total_cmp(&nodes.plane(b)[0]));
    let near = 1e-9 * start.reach;
    for (place, &a) in beams.iter().enumerate() {
        let follow = beams[place + 1..].iter();
        for &b in follow.take_while(|&&b| nodes.plane(b)[0] - nodes.plane(a)[0] <= near) {
            let apart = length(less(nodes.plane(a), nodes.plane(b))) > near;
            if apart || start.bodies.of_node(a) == start.bodies.of_node(b) {
                continue;
            }
            let (first, second) = (a.min(b), a.max(b));
            let labels = [nodes.label(first), nodes.label(second)];
            let message = format!(
                "beam nodes {} and {} stand at the same place but nothing joins them: the beam is \
                 broken there",
                labels[0], labels[1]
            );
            let said = Diagnostic::warning(Code("SL0410"), message)
                .at(nodes.get(second).origin)
                .help("use one node for both elements, or weld them with *MPC, BEAM");
            let card = format!("*MPC\nBEAM, {}, {}\n", labels[1], labels[0]);
            findings.push(match start.model.steps.first() {
                Some(step) => Finding::with(said, Place::Before(step.origin), card),
                None => Finding::said(said),
            });
        }
    }
}

/// SL0411: two beams between the same nodes.
fn twice(start: &Start<'_>, findings: &mut Vec<Finding>) {
    let mut seen: BTreeMap<[NodeIndex; 2], u64> = BTreeMap::new();
    for block in start.model.blocks.iter().filter_map(|block| block.beams()) {
        for element in &block.elements {
            let mut ends = element.nodes;
            ends.sort_unstable();
            if ends.iter().all(|&node| start.bodies.dependent[node].is_some()) {
                continue; // for plotting only: it has no stiffness
            }
            if let Some(first) = seen.insert(ends, element.label) {
                let message = format!(
                    "beams {first} and {} lie on one another between the same two nodes: their \
                     stiffness counts twice",
                    element.label
                );
                let said = Diagnostic::warning(Code("SL0411"), message).at(element.origin);
                findings.push(Finding::said(said.help("remove one of them from *ELEMENT")));
            }
        }
    }
}

fn lengths(start: &Start<'_>, block: &BeamBlock) -> Vec<f64> {
    let at = |node| start.model.nodes.plane(node);
    let elements = block.elements.iter();
    elements.map(|e| length(less(at(e.nodes[1]), at(e.nodes[0])))).collect()
}

/// SL0412: a part that is no beam.
fn stout(start: &Start<'_>, block: &BeamBlock) -> Option<Finding> {
    let whole: f64 = lengths(start, block).iter().sum();
    let height = block.section.height;
    let rigid = block
        .elements
        .iter()
        .all(|e| e.nodes.iter().all(|&node| start.bodies.dependent[node].is_some()));
    if whole >= 3.0 * height || rigid {
        return None;
    }
    let message = format!(
        "the beams of {} are {whole:.3e} long in all and {height:.3e} high: beam theory does not \
         describe such a part",
        block.name
    );
    let said = Diagnostic::warning(Code("SL0412"), message).at(block.origin);
    Some(Finding::said(said.help(
        "check *BEAM SECTION: width (out of plane) first, then height; and that both are in the \
         unit of *NODE",
    )))
}

/// SL0412: neighbours of very different length.
fn uneven(start: &Start<'_>, block: &BeamBlock) -> Option<Finding> {
    let lengths = lengths(start, block);
    let place = block.elements.windows(2).zip(lengths.windows(2)).position(|(both, long)| {
        both[0].nodes[1] == both[1].nodes[0] && long[0].max(long[1]) > UNEVEN * long[0].min(long[1])
    })?;
    let message = format!(
        "neighbouring beams {} and {} are {:.3e} and {:.3e} long: contact areas and forces jump \
         between them",
        block.elements[place].label,
        block.elements[place + 1].label,
        lengths[place],
        lengths[place + 1]
    );
    let said = Diagnostic::advice(Code("SL0412"), message).at(block.elements[place + 1].origin);
    Some(Finding::said(said.help("grade the mesh of *NODE and *NGEN more gently")))
}
