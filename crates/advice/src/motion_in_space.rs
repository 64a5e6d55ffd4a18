//! Rigid motions of bodies in space that nothing hinders.
//!
//! ```text
//!   motion of a body: v of its centre, w about it      rows: what supports and springs hold,
//!   a node x moves by v + w x (x - centre)             one a body, of length one
//! ```
//!
//! A body that contact may hold is left to the run: where its points will touch is not known here.
//! Equations join bodies; what they say of a rigid motion is a row like that of a support.

use crate::bodies::Bodies;
use crate::finding::{Finding, Place};
use crate::start::{Start, length, less};
use slideline_diag::{Code, Diagnostic};
use slideline_model::{Dof, Master, NodeIndex, Prescribed, Presence, SpringWay, Step};
use std::collections::{BTreeMap, BTreeSet};

/// Remainder of a row below which it says nothing new, and of a motion below which it is none [1].
const NOTHING: f64 = 1e-8;
/// Turn over the size of the model, relative to the way, below which a motion is told as straight.
const STRAIGHT: f64 = 0.2;
/// Bodies that are told of.
const TOLD: usize = 5;

/// Motion of the centre and turn times the size of the model [L].
type Motion = [f64; 6];

/// SL0409 in space: a body is told in the first step in which it is free.
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    let mut told = BTreeSet::new();
    let broken = findings.iter().any(|other| other.diagnostic.code == Code("SL0410"));
    for (number, step) in start.model.steps.iter().enumerate() {
        // what has been moved may be held elsewhere by now
        let moved = |before: &Step| before.prescribed.iter().any(Prescribed::moves);
        if start.model.steps[..number].iter().any(moved) {
            break;
        }
        let changed = (!step.presence.is_whole()).then(|| Bodies::of(start.model, &step.presence));
        let bodies = changed.as_ref().unwrap_or(&start.bodies);
        for (node, body) in Parts::new(start, bodies, step).parts {
            let motions = body.motions();
            if motions.is_empty() || told.len() >= TOLD || !told.insert(node) {
                continue;
            }
            let mut finding = body.say(start, (number, step), &motions);
            if broken {
                finding.card = None; // joining what is broken comes first
            }
            findings.push(finding);
        }
    }
}

/// A body with what holds it.
#[derive(Default)]
struct Part {
    nodes: Vec<NodeIndex>,
    /// Places of the nodes from the centre, over the size [1].
    arms: Vec<[f64; 3]>,
    centre: [f64; 3],
    size: f64,
    /// Whether an element of it turns at its nodes.
    turns: bool,
    /// Whether an element of it moves in space.
    spatial: bool,
    /// Whether contact, a gap or a spring without stiffness at rest may hold it.
    in_doubt: bool,
    /// What is held, at right angles to one another.
    held: Vec<Motion>,
}

impl Part {
    /// The motion of a place along `way`, as a row.
    fn row(&self, arm: [f64; 3], way: [f64; 3]) -> Motion {
        let turn = cross(arm, way);
        [way[0], way[1], way[2], turn[0], turn[1], turn[2]]
    }

    fn hold(&mut self, row: Motion) {
        if let Some(new) = beside(&self.held, row) {
            self.held.push(new);
        }
    }

    /// Motions that are not held, at right angles to one another: straight ones first.
    fn motions(&self) -> Vec<Motion> {
        if self.in_doubt || !self.spatial {
            return Vec::new();
        }
        let mut known = self.held.clone();
        let mut free = Vec::new();
        for axis in 0..6 {
            let mut way = [0.0; 6];
            way[axis] = 1.0;
            let Some(motion) = beside(&known, way) else { continue };
            known.push(motion);
            let moves = |arm: &[f64; 3]| length(moved(motion, *arm)) > NOTHING.sqrt();
            if self.turns || self.arms.iter().any(moves) {
                free.push(motion);
            }
        }
        free
    }

    /// Supports that stop the motions: of each the node and direction that it moves most.
    fn stops(&self, motions: &[Motion]) -> Vec<(NodeIndex, usize)> {
        let mut held = self.held.clone();
        let mut stops = Vec::new();
        for &motion in motions {
            let Some(left) = beside(&held, motion) else { continue };
            let mut most = (0.0, (0, 1), [0.0; 6]);
            for (&node, &arm) in self.nodes.iter().zip(&self.arms) {
                let way = moved(left, arm);
                for axis in 0..3 {
                    if way[axis].abs() > most.0 {
                        let mut unit = [0.0; 3];
                        unit[axis] = 1.0;
                        most = (way[axis].abs(), (node, axis + 1), self.row(arm, unit));
                    }
                }
            }
            stops.push(most.1);
            if let Some(new) = beside(&held, most.2) {
                held.push(new);
            }
        }
        stops.sort_unstable();
        stops.dedup();
        stops
    }

    fn describe(&self, motion: Motion) -> String {
        let (way, turn) = ([motion[0], motion[1], motion[2]], [motion[3], motion[4], motion[5]]);
        let told = |own: [f64; 3]| {
            let size = length(own);
            let [x, y, z] = own.map(|x| x / size + 0.0); // no minus before a zero
            format!("({x:.3}, {y:.3}, {z:.3})")
        };
        if length(turn) <= STRAIGHT * length(way) {
            return format!("move along {}", told(way));
        }
        let square = turn.iter().map(|x| x * x).sum::<f64>();
        let off = cross(turn, way).map(|x| x / square * self.size);
        let [x, y, z] = [0, 1, 2].map(|axis| self.centre[axis] + off[axis]);
        format!("turn about the axis along {} through ({x:.4e}, {y:.4e}, {z:.4e})", told(turn))
    }

    fn say(&self, start: &Start<'_>, (number, step): (usize, &Step), all: &[Motion]) -> Finding {
        let nodes = &start.model.nodes;
        let first = self.nodes.first().copied().unwrap_or_default();
        let (label, origin) = (nodes.name(first), nodes.get(first).origin);
        let how: Vec<String> = all.iter().map(|motion| self.describe(*motion)).collect();
        let when =
            if number == 0 { String::new() } else { format!("from step {} on ", number + 1) };
        let message = format!(
            "{when}the body of node {label} is unsupported: it can {} freely",
            how.join(", and ")
        );
        let stops = self.stops(all);
        let words =
            stops.iter().map(|(node, dof)| format!("node {}, degree {dof}", nodes.name(*node)));
        let words = words.collect::<Vec<_>>().join("; ");
        let said = Diagnostic::warning(Code("SL0409"), message)
            .at(origin)
            .help(format!("support it: *BOUNDARY with {words}"));
        let line =
            |&(node, dof): &(NodeIndex, usize)| format!("{}, {dof}, {dof}\n", nodes.name(node));
        let lines: String = stops.iter().map(line).collect();
        let own = step.prescribed.iter().map(|p| p.origin);
        let own = own.filter(|at| at.file == step.origin.file && at.start > step.origin.start);
        match own.max_by_key(|at| at.start).or(step.procedure.origin) {
            Some(at) => Finding::with(said, Place::After(at), format!("*BOUNDARY\n{lines}")),
            None => Finding::said(said),
        }
    }
}

/// The bodies of a step.
#[derive(Default)]
struct Parts {
    /// By the node that stands for each.
    parts: BTreeMap<NodeIndex, Part>,
    /// Nodes whose displacements are the rotation of another one.
    turn_of: BTreeMap<NodeIndex, NodeIndex>,
    /// Nodes without elements that turn: those that rigid bodies and couplings follow.
    turning: BTreeSet<NodeIndex>,
}

impl Parts {
    fn new(start: &Start<'_>, bodies: &Bodies, step: &Step) -> Self {
        let model = start.model;
        let size = if start.reach > 0.0 { start.reach } else { 1.0 };
        let links = &model.rigid_links;
        let terms = model.linear_constraints.iter().flat_map(|own| {
            let terms = own.terms.iter().map(|&(node, dof, _)| (node, dof));
            terms.chain([own.dependent])
        });
        let turning = terms.filter(|(_, dof)| dof.is_rotation()).map(|(node, _)| node);
        let mut parts = Self {
            parts: BTreeMap::new(),
            turn_of: links.iter().filter_map(|link| Some((link.turn?, link.master))).collect(),
            turning: turning.chain(links.iter().map(|link| link.master)).collect(),
        };
        for node in (0..model.nodes.len()).filter(|&node| bodies.active[node]) {
            parts.parts.entry(bodies.of_node(node)).or_default().nodes.push(node);
        }
        for part in parts.parts.values_mut() {
            let places = part.nodes.iter().map(|&node| model.nodes.position(node));
            let count = part.nodes.len() as f64;
            part.centre = places
                .clone()
                .fold([0.0; 3], |sum, at| std::array::from_fn(|axis| sum[axis] + at[axis] / count));
            part.arms = places.map(|at| less(at, part.centre).map(|x| x / size)).collect();
            part.size = size;
        }
        let presence = &step.presence;
        parts.elements(start, bodies, presence);
        parts.contact(start, bodies, presence);
        parts.equations(start, bodies);
        for support in &step.prescribed {
            let row = parts.motion(start, bodies, (support.node, support.dof), true);
            if let Some((body, row)) = row {
                parts.of(body, |part| part.hold(row));
            }
        }
        parts
    }

    fn of(&mut self, body: NodeIndex, change: impl FnOnce(&mut Part)) {
        if let Some(part) = self.parts.get_mut(&body) {
            change(part);
        }
    }

    /// The row of a node's motion, with the body that it belongs to; `own`: along the node's axes.
    fn motion(
        &self,
        start: &Start<'_>,
        bodies: &Bodies,
        (node, dof): (NodeIndex, Dof),
        own: bool,
    ) -> Option<(NodeIndex, Motion)> {
        let model = start.model;
        let axis = dof as usize % 3;
        let mut way = [0.0; 3];
        way[axis] = 1.0;
        let turn = |way: [f64; 3]| [0.0, 0.0, 0.0, way[0], way[1], way[2]];
        if let Some(&master) = self.turn_of.get(&node) {
            return Some((bodies.of_node(master), turn(way)));
        }
        if let Some(axes) = model.axes_of(node).filter(|_| own) {
            way = axes[axis];
        }
        let body = bodies.of_node(node);
        let part = self.parts.get(&body)?;
        if dof.is_rotation() {
            // solids are not held by rotations that their nodes do not have
            let turns = part.turns || self.turning.contains(&node);
            return turns.then_some((body, turn(way)));
        }
        let arm = less(model.nodes.position(node), part.centre).map(|x| x / part.size);
        Some((body, part.row(arm, way)))
    }

    fn elements(&mut self, start: &Start<'_>, bodies: &Bodies, presence: &Presence) {
        let model = start.model;
        for (block, element) in presence.elements(&model.blocks) {
            let body = bodies.of_node(element.nodes[0]);
            let Some(springs) = block.springs() else {
                let turns = block.dofs().contains(&Dof::UR1);
                let spatial = block.dofs().contains(&Dof::U3);
                self.of(body, |part| {
                    part.turns |= turns;
                    part.spatial |= spatial;
                });
                continue;
            };
            // a spring between two bodies is taken as one to the ground: it may hold
            let rests = springs.section.law.holds_at_rest();
            let along = match springs.section.way {
                SpringWay::Dof(dof) => Some(dof),
                _ => None,
            };
            for &node in element.nodes {
                let row = along.and_then(|dof| self.motion(start, bodies, (node, dof), true));
                self.of(bodies.of_node(node), |part| match row {
                    Some((_, row)) if rests => part.hold(row),
                    _ => part.in_doubt = true,
                });
            }
        }
    }

    fn contact(&mut self, start: &Start<'_>, bodies: &Bodies, presence: &Presence) {
        let pairs = start.model.contact_pairs.iter().enumerate();
        for (_, pair) in pairs.filter(|&(place, _)| presence.has_pair(place)) {
            let mut touched: BTreeSet<NodeIndex> = pair.slave_places().collect();
            match &pair.master {
                Master::RigidSurface(surface) => touched.extend([surface.reference]),
                Master::SlideLine(line) => touched.extend(&line.nodes),
                Master::Faces(faces) => {
                    touched.extend(faces.faces.iter().flat_map(|face| face.nodes.iter().copied()));
                }
                Master::Itself(surface) => touched.extend(surface.nodes()),
            }
            for node in touched {
                self.of(bodies.of_node(node), |part| part.in_doubt = true);
            }
        }
    }

    /// What equations say of rigid motions; those of ties say nothing.
    fn equations(&mut self, start: &Start<'_>, bodies: &Bodies) {
        for constraint in &start.model.linear_constraints {
            let (node, dof) = constraint.dependent;
            let Some((body, mut row)) = self.motion(start, bodies, (node, dof), true) else {
                continue;
            };
            for &(node, dof, factor) in &constraint.terms {
                let Some((_, own)) = self.motion(start, bodies, (node, dof), true) else {
                    continue;
                };
                row.iter_mut().zip(own).for_each(|(sum, own)| *sum -= factor * own);
            }
            self.of(body, |part| part.hold(row));
        }
    }
}

/// What a row adds to others at right angles to one another, of length one; `None`: nothing.
fn beside(others: &[Motion], mut row: Motion) -> Option<Motion> {
    let size = |row: &Motion| row.iter().map(|x| x * x).sum::<f64>().sqrt();
    // twice, so that rounding of the first time is taken away
    for _ in 0..2 {
        for other in others {
            let along: f64 = row.iter().zip(other).map(|(a, b)| a * b).sum();
            row.iter_mut().zip(other).for_each(|(own, other)| *own -= along * other);
        }
    }
    let left = size(&row);
    (left > NOTHING).then(|| row.map(|x| x / left))
}

/// Where a motion takes a node at an arm.
fn moved(motion: Motion, arm: [f64; 3]) -> [f64; 3] {
    let turn = cross([motion[3], motion[4], motion[5]], arm);
    std::array::from_fn(|axis| motion[axis] + turn[axis])
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
