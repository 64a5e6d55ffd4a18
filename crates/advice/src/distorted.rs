//! Solids whose corners are nearly flat, needles, or turned in.
//!
//! ```text
//!    4 +-------+ 3      at a corner the unit vectors along its edges span 1 in a rectangle or a box,
//!      |    _.'         nearly nothing where they lie along one another or in a plane,
//!      | 2+'            less than nothing where the corner is turned in
//!    1 +'
//! ```
//!
//! What an element does is integrated inside it, so that it may work all the same; its strains at
//! such a corner are wrong.

use crate::corners::corners;
use crate::finding::Finding;
use crate::start::{Start, less};
use slideline_diag::{Code, Diagnostic};
use slideline_mech::vector::{cross, dot};
use slideline_model::{ElementBlock, Kinematics, Model, NodeIndex};

/// What unit vectors along the edges of a corner span at least in a sound element [1]: one degree in
/// the plane.
const FLAT: f64 = 0.02;

/// A corner and what the edges there span.
struct Corner {
    element: u64,
    node: NodeIndex,
    spans: f64,
    origin: slideline_diag::Span,
}

/// SL0426: a block with such elements, by the worst.
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    for block in &start.model.blocks {
        if !matches!(block.kind.kinematics, Kinematics::Solid { .. }) {
            continue;
        }
        let worst: Vec<Corner> = (0..block.elements.len())
            .filter_map(|member| worst(start.model, block, member))
            .collect();
        let bad = || worst.iter().filter(|corner| corner.spans < FLAT);
        if let Some(first) = bad().min_by(|a, b| a.spans.total_cmp(&b.spans)) {
            findings.push(Finding::said(say(start.model, block, first, bad().count())));
        }
    }
}

fn say(model: &Model, block: &ElementBlock, worst: &Corner, count: usize) -> Diagnostic {
    let turned_in = worst.spans <= 0.0;
    let message = format!(
        "element {} of {} is badly distorted: its corner at node {} is {}{}",
        worst.element,
        block.name,
        model.nodes.name(worst.node),
        match turned_in {
            true => "turned in".to_string(),
            false => format!("nearly flat, its edges span {:.2e} of a right corner", worst.spans),
        },
        match count {
            1 => String::new(),
            more => format!("; so are {} more of {}", more - 1, block.name),
        }
    );
    let said = match turned_in {
        true => Diagnostic::warning(Code("SL0426"), message),
        false => Diagnostic::advice(Code("SL0426"), message),
    };
    said.at(worst.origin).help(
        "move the node, or mesh the place anew: strains and stresses at such a corner are wrong, and \
         large motion soon turns the element inside out",
    )
}

/// The worst corner of an element; `None` where it is of another shape, or all corners have an edge
/// without length, as where nodes are one on purpose.
fn worst(model: &Model, block: &ElementBlock, member: usize) -> Option<Corner> {
    let element = block.elements.get(member);
    let corners = corners(block.kind.cell.dimension, block.kind.cell.nodes)?;
    let at = |own: usize| model.nodes.position(element.nodes[own]);
    let all = corners.iter().enumerate().filter_map(|(own, others)| {
        let mut edges = [[0.0, 0.0, 1.0]; 3];
        for (edge, &other) in edges.iter_mut().zip(*others) {
            let along = less(at(other), at(own));
            let length = dot(along, along).sqrt();
            *edge = along.map(|x| x / length);
        }
        let spans = dot(cross(edges[0], edges[1]), edges[2]);
        spans.is_finite().then_some((own, spans))
    });
    let (own, spans) = all.min_by(|a, b| a.1.total_cmp(&b.1))?;
    Some(Corner { element: element.label, node: element.nodes[own], spans, origin: element.origin })
}
