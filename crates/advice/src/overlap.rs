//! Parts that are there twice, or run through one another.
//!
//! ```text
//!   o---o---o          o---o====o---o       \ /
//!   o---o---o  twice        along            X   across
//!                                           / \
//! ```

use crate::finding::Finding;
use crate::start::{Start, length, less};
use slideline_diag::{Code, Diagnostic};
use slideline_model::{ContactPair, Element, Master, NodeIndex};

/// Pieces nearer than this fraction of the shorter one lie on one another [1].
const NEAR: f64 = 1e-6;
/// Overlaps named one by one; of more only the number is told.
const NAMED: usize = 3;

/// SL0411: beams on one another, and contact pairs that are there twice.
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    let mut elements: Vec<Piece<'_>> = pieces(start);
    elements.sort_by(|a, b| a.low.total_cmp(&b.low));
    let mut found: Vec<(Overlap, Element<'_>, Element<'_>)> = Vec::new();
    for (place, a) in elements.iter().enumerate() {
        for b in elements[place + 1..].iter().take_while(|b| b.low <= a.high) {
            if let Some(overlap) = overlap(start, a, b) {
                let ordered = if a.element.origin.start <= b.element.origin.start
                    && a.element.label <= b.element.label
                {
                    (a.element, b.element)
                } else {
                    (b.element, a.element)
                };
                found.push((overlap, ordered.0, ordered.1));
            }
        }
    }
    for kind in [Overlap::Along, Overlap::Across] {
        let mut of_kind: Vec<_> = found.iter().filter(|(own, ..)| *own == kind).collect();
        of_kind.sort_by_key(|(_, first, second)| (first.label, second.label));
        let count = of_kind.len();
        let last = of_kind.into_iter().take(NAMED).enumerate();
        findings.extend(last.map(|(k, (_, a, b))| {
            let others = if k + 1 == NAMED && count > NAMED { count - NAMED } else { 0 };
            say(kind, *a, *b, others)
        }));
    }
    pairs(start, findings);
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Overlap {
    /// They share a stretch.
    Along,
    /// They cross without a common node.
    Across,
}

struct Piece<'a> {
    element: Element<'a>,
    ends: [[f64; 3]; 2],
    low: f64,
    high: f64,
}

/// Beams that have stiffness.
fn pieces<'a>(start: &Start<'a>) -> Vec<Piece<'a>> {
    let blocks = start.model.blocks.iter().filter_map(|block| block.beams());
    let rigid = |node: NodeIndex| start.bodies.dependent[node].is_some();
    let elements = blocks.flat_map(|block| block.elements);
    elements
        .filter(|element| !element.ends().iter().all(|&node| rigid(node)))
        .map(|element| {
            let ends = element.ends().map(|node| start.model.nodes.position(node));
            let (low, high) = (ends[0][0].min(ends[1][0]), ends[0][0].max(ends[1][0]));
            Piece { element, ends, low, high }
        })
        .collect()
}

/// How two beams lie on one another, if they do.
fn overlap(start: &Start<'_>, a: &Piece<'_>, b: &Piece<'_>) -> Option<Overlap> {
    let ([p, q], [r, s]) = (a.ends, b.ends);
    let along = less(q, p);
    let (long, other) = (length(along), length(less(s, r)));
    let near = NEAR * long.min(other);
    if near <= 0.0 {
        return None;
    }
    let t = [along[0] / long, along[1] / long];
    // coordinates of b in the frame of a
    let local = |point: [f64; 3]| {
        let d = less(point, p);
        [d[0] * t[0] + d[1] * t[1], d[1] * t[0] - d[0] * t[1]]
    };
    let (from, to) = (local(r), local(s));
    if from[1].abs() <= near && to[1].abs() <= near {
        let shared = from[0].max(to[0]).min(long) - from[0].min(to[0]).max(0.0);
        let meet = in_contact(start, a.element, b.element);
        return (shared > 1e-3 * long.min(other) && !meet).then_some(Overlap::Along);
    }
    let joined = start.bodies.of_node(a.element.nodes[0])
        == start.bodies.of_node(b.element.nodes[0])
        && a.element.ends().iter().any(|node| b.element.ends().contains(node));
    if joined || from[1] * to[1] >= 0.0 || from[1].abs() <= near || to[1].abs() <= near {
        return None;
    }
    let at = from[0] + (to[0] - from[0]) * from[1] / (from[1] - to[1]);
    (at > near && at < long - near).then_some(Overlap::Across)
}

/// Whether one beam carries slaves of a pair whose master the other carries:
/// then they may start on one another.
fn in_contact(start: &Start<'_>, a: Element<'_>, b: Element<'_>) -> bool {
    let sides = |pair: &ContactPair, slave: Element<'_>, master: Element<'_>| {
        let Master::SlideLine(line) = &pair.master else { return false };
        slave.ends().iter().any(|&n| pair.elements.iter().any(|e| e.nodes.contains(&n)))
            && master.ends().iter().any(|node| line.nodes.contains(node))
    };
    let mut pairs = start.model.contact_pairs.iter();
    pairs.any(|pair| sides(pair, a, b) || sides(pair, b, a))
}

fn say(kind: Overlap, a: Element<'_>, b: Element<'_>, others: usize) -> Finding {
    let more = if others > 0 { format!(" (and {others} more)") } else { String::new() };
    let [ends, others_ends] = [a.ends(), b.ends()];
    let same = ends == others_ends || ends == [others_ends[1], others_ends[0]];
    let said = match (kind, same) {
        (Overlap::Along, true) => Diagnostic::warning(
            Code("SL0411"),
            format!(
                "beams {} and {} lie on one another between the same two nodes{more}: their \
                 stiffness counts twice",
                a.label, b.label
            ),
        )
        .help("remove one of them from *ELEMENT"),
        (Overlap::Along, false) => Diagnostic::warning(
            Code("SL0411"),
            format!(
                "beams {} and {} lie on one another over a part of their length{more}: two bodies \
                 are at the same place",
                a.label, b.label
            ),
        )
        .help("remove one of the bodies from *ELEMENT, or move it away in *NODE"),
        (Overlap::Across, _) => Diagnostic::advice(
            Code("SL0411"),
            format!(
                "beams {} and {} cross without a common node{more}: they pass through one another",
                a.label, b.label
            ),
        )
        .help("give them a common node in *ELEMENT, or move one of them in *NODE"),
    };
    Finding::said(said.at(b.origin))
}

/// Two pairs with the same slaves and the same master shape.
fn pairs(start: &Start<'_>, findings: &mut Vec<Finding>) {
    let all = &start.model.contact_pairs;
    for (place, b) in all.iter().enumerate() {
        let sorted = |pair: &ContactPair| {
            let mut nodes = pair.slave_nodes();
            nodes.sort_unstable();
            nodes
        };
        let same_shape = |a: &ContactPair| match (&a.master, &b.master) {
            (Master::RigidSurface(one), Master::RigidSurface(other)) => {
                one.start == other.start && one.segments == other.segments
            }
            (Master::SlideLine(one), Master::SlideLine(other)) => one.nodes == other.nodes,
            (Master::Faces(one), Master::Faces(other)) => one.nodes() == other.nodes(),
            (Master::Itself(_), Master::Itself(_)) => true,
            _ => false,
        };
        let same_slaves = |a: &ContactPair| {
            sorted(a) == sorted(b)
                && match (&a.profile, &b.profile) {
                    (Some(one), Some(other)) => one.segments == other.segments,
                    (None, None) => true,
                    _ => false,
                }
        };
        let same = all[..place]
            .iter()
            .find(|a| same_shape(a) && same_slaves(a) && a.left_out == b.left_out);
        if let Some(a) = same {
            let message = format!(
                "contact pairs {} and {} have the same slaves and masters of the same shape at the \
                 same place: their pressure counts twice",
                a.name, b.name
            );
            let said = Diagnostic::warning(Code("SL0411"), message).at(b.origin);
            findings.push(Finding::said(said.help("remove one of the two pairs")));
        }
    }
}
