//! Rigid motions that nothing hinders: the null space of what holds the
//! undeformed bodies.
//!
//! ```text
//!   unknowns: u, v, w of every body      rows: supports, springs, touching
//!   [ rows ] motion = 0  --> motions left over
//! ```
//!
//! Beams resist every deformation, so the null space of the undeformed
//! stiffness holds rigid motions of whole bodies only, and a few rows find it.

use crate::bodies::Bodies;
use crate::finding::{Finding, Place};
use crate::start::{Start, arc_of, circle_of, length, less, spacing};
use slideline_diag::{Code, Diagnostic};
use slideline_model::{ContactPair, Dof, Master, NodeIndex, Presence, SpringWay, Step};
use std::collections::BTreeMap;

/// Pivots below this count as zero; rows are of length one [1].
const ZERO: f64 = 1e-8;
/// Turn over the size of the model, relative to the way, below which a motion
/// is told as straight [1].
const STRAIGHT: f64 = 0.2;

/// SL0409, and SL0414 where contact that is still open will hold the motion.
/// A motion is told in the step in which it becomes free.
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    let mut told = Vec::new();
    for (number, step) in start.model.steps.iter().enumerate() {
        let changed = (!step.presence.is_whole()).then(|| Bodies::of(start.model, &step.presence));
        let bodies = changed.as_ref().unwrap_or(&start.bodies);
        let mut holds = Holds::new(start, (bodies, &step.presence));
        holds.supports(step);
        holds.springs();
        holds.rings();
        // what touches at the end of the step before is not known here
        holds.contact(number == 0);
        let free = holds.motions();
        if free.is_empty() {
            continue;
        }
        holds.contact(false);
        let remaining = holds.motions();
        let for_good = !remaining.is_empty();
        let broken = findings.iter().any(|other| other.diagnostic.code == Code("SL0410"));
        for (body, motions) in if for_good { remaining } else { free } {
            if told.contains(&(body, for_good)) {
                continue;
            }
            told.push((body, for_good));
            let mut finding = holds.say((number, step), (body, &motions), for_good);
            if broken {
                finding.card = None; // joining what is broken comes first
            }
            findings.push(finding);
        }
    }
}

/// A rigid motion u, v, w of a body about its node.
type Motion = [f64; 3];

struct Holds<'a> {
    start: &'a Start<'a>,
    /// Who moves with whom in the step, and what is there.
    bodies: &'a Bodies,
    presence: &'a Presence,
    /// First unknown of every body.
    column: BTreeMap<NodeIndex, usize>,
    rows: Vec<Vec<f64>>,
    size: f64,
}

impl<'a> Holds<'a> {
    fn new(start: &'a Start<'a>, (bodies, presence): (&'a Bodies, &'a Presence)) -> Self {
        let mut column = BTreeMap::new();
        for node in (0..start.model.nodes.len()).filter(|&node| bodies.active[node]) {
            let next = 3 * column.len();
            column.entry(bodies.of_node(node)).or_insert(next);
        }
        let size = if start.reach > 0.0 { start.reach } else { 1.0 };
        Self { start, bodies, presence, column, rows: Vec::new(), size }
    }

    fn width(&self) -> usize {
        3 * self.column.len()
    }

    /// Adds `sign` times the motion of `point` with the body of `node` along
    /// `way`; rotations are scaled with the size of the model.
    fn add(&self, row: &mut [f64], node: NodeIndex, point: [f64; 3], way: [f64; 3], sign: f64) {
        let body = self.bodies.of_node(node);
        let Some(&first) = self.column.get(&body) else { return };
        let arm = less(point, self.start.model.nodes.position(body));
        row[first] += sign * way[0];
        row[first + 1] += sign * way[1];
        row[first + 2] += sign * (way[1] * arm[0] - way[0] * arm[1]) / self.size;
    }

    fn supports(&mut self, step: &Step) {
        let held: Vec<(NodeIndex, Dof)> = step.prescribed.iter().map(|p| (p.node, p.dof)).collect();
        for (node, dof) in held {
            self.hold(node, dof);
        }
    }

    fn hold(&mut self, node: NodeIndex, dof: Dof) {
        // the third displacement of a rotation node is the turn of its body
        let mut links = self.start.model.rigid_links.iter();
        let turned = links.find(|link| dof == Dof::U3 && link.turn == Some(node));
        let (node, dof) = turned.map_or((node, dof), |link| (link.master, Dof::UR3));
        let mut row = vec![0.0; self.width()];
        let at = self.start.model.nodes.position(node);
        let axes = self.start.model.axes_of(node).filter(|_| !dof.is_rotation());
        match dof {
            _ if axes.is_some() => {
                let way = axes.map_or([0.0; 3], |axes| axes[dof as usize]);
                self.add(&mut row, node, at, way, 1.0);
            }
            Dof::U1 => self.add(&mut row, node, at, [1.0, 0.0, 0.0], 1.0),
            Dof::U2 => self.add(&mut row, node, at, [0.0, 1.0, 0.0], 1.0),
            Dof::UR3 => {
                if let Some(&first) = self.column.get(&self.bodies.of_node(node)) {
                    row[first + 2] = 1.0;
                }
            }
            _ => {}
        }
        self.rows.push(row);
    }

    /// Rings are held along their radius and against turns by their own hoop strain.
    fn rings(&mut self) {
        let mut held = std::collections::BTreeSet::new();
        for (node, dof) in self.presence.rings(&self.start.model.blocks) {
            if held.insert((self.bodies.of_node(node), dof)) {
                self.hold(node, dof);
            }
        }
    }

    fn springs(&mut self) {
        let model = self.start.model;
        for (block, spring) in self.presence.elements(&model.blocks) {
            let Some(springs) = block.springs() else { continue };
            if !springs.section.law.holds_at_rest() {
                continue;
            }
            match springs.section.way {
                SpringWay::Dof(dof) if spring.nodes.len() == 1 => {
                    self.hold(spring.nodes[0], dof);
                }
                SpringWay::Dof(dof) if dof.is_rotation() => {}
                SpringWay::Dof(dof) => {
                    let mut way = [0.0; 3];
                    way[dof as usize] = 1.0;
                    let at = model.nodes.position(spring.nodes[0]);
                    self.between(spring.ends(), at, way);
                }
                SpringWay::Direction { direction: Some(way), .. } => {
                    let at = model.nodes.position(spring.nodes[0]);
                    self.between(spring.ends(), at, way);
                }
                SpringWay::Around { .. } => {}
                SpringWay::Line { .. } | SpringWay::Direction { direction: None, .. } => {
                    let ends = spring.ends().map(|node| model.nodes.position(node));
                    let way = less(ends[1], ends[0]);
                    let long = length(way);
                    if long > 0.0 {
                        let way = way.map(|x| x / long);
                        self.between(spring.ends(), ends[0], way);
                    }
                }
            }
        }
    }

    /// No motion of one body against the other at a point along `way`.
    fn between(&mut self, nodes: [NodeIndex; 2], point: [f64; 3], way: [f64; 3]) {
        let mut row = vec![0.0; self.width()];
        self.add(&mut row, nodes[0], point, way, 1.0);
        self.add(&mut row, nodes[1], point, way, -1.0);
        self.rows.push(row);
    }

    /// Contact that touches, or all contact that faces its master. Only the
    /// nearest points of a pair hold, and only along the normal there: the
    /// others of a round body touch nothing when these do.
    fn contact(&mut self, touching: bool) {
        let model = self.start.model;
        let pairs = model.contact_pairs.iter().enumerate();
        for (place, pair) in pairs.filter(|&(place, _)| self.presence.has_pair(place)) {
            let begins = pair.interaction.normal.contact_begins();
            let Some(nearest) = self.start.nearest(place).copied() else { continue };
            if touching && nearest.opening > -begins + 1e-9 * self.size {
                continue;
            }
            let round = circle_of(pair).is_some() || arc_of(model, pair, nearest.node).is_some();
            let reach = nearest.opening + 0.05 * spacing(model, pair);
            let near: Vec<_> = self
                .start
                .facing(place)
                .filter(|row| row.node == nearest.node || (!round && row.opening <= reach))
                .copied()
                .collect();
            for row in near {
                let nodes = [row.node, master_node(pair)];
                self.between(nodes, row.position, nearest.normal);
                if pair.interaction.has_friction() {
                    let way = [nearest.normal[1], -nearest.normal[0], 0.0];
                    self.between(nodes, row.position, way);
                }
            }
        }
    }

    /// Motions that no row hinders, by the body that each moves.
    fn motions(&self) -> BTreeMap<NodeIndex, Vec<Motion>> {
        let width = self.width();
        let mut rows = self.rows.clone();
        let mut pivots: Vec<usize> = Vec::new();
        let mut free: Vec<usize> = Vec::new();
        for column in 0..width {
            let from = pivots.len();
            let largest = (from..rows.len())
                .max_by(|&a, &b| rows[a][column].abs().total_cmp(&rows[b][column].abs()));
            let Some(largest) = largest.filter(|&row| rows[row][column].abs() > ZERO) else {
                free.push(column);
                continue;
            };
            rows.swap(from, largest);
            let pivot = rows[from].clone();
            for (place, row) in rows.iter_mut().enumerate() {
                let factor = row[column] / pivot[column];
                if place != from && factor != 0.0 {
                    for (value, from) in row.iter_mut().zip(&pivot) {
                        *value -= factor * from;
                    }
                }
            }
            pivots.push(column);
        }
        let mut motions: BTreeMap<NodeIndex, Vec<Motion>> = BTreeMap::new();
        for &column in &free {
            let (body, motion) = self.read(&rows, &pivots, column);
            motions.entry(body).or_default().push(motion);
        }
        motions
    }

    /// The motion with one free unknown at one and the others at zero.
    fn read(&self, rows: &[Vec<f64>], pivots: &[usize], free: usize) -> (NodeIndex, Motion) {
        let mut motion = vec![0.0; self.width()];
        motion[free] = 1.0;
        for (row, &pivot) in pivots.iter().enumerate() {
            motion[pivot] = -rows[row][free] / rows[row][pivot];
        }
        let first = free / 3 * 3;
        let body = self.column.iter().find(|&(_, &own)| own == first);
        let body = body.map_or(0, |(&body, _)| body);
        (body, [motion[first], motion[first + 1], motion[first + 2] / self.size])
    }

    /// A motion in words, and the node and the number of the dof that stop it.
    fn describe(&self, body: NodeIndex, [u, v, w]: Motion) -> (String, (NodeIndex, usize)) {
        // what turns about a place far outside the model moves straight on
        if w.abs() * self.size > STRAIGHT * u.hypot(v) {
            let at = self.start.model.nodes.position(body);
            let centre = [at[0] - v / w, at[1] + u / w, at[2]];
            let words = format!("turn about ({:.4e}, {:.4e})", centre[0], centre[1]);
            return (words, self.stop_of_turn(body, centre));
        }
        let dof = if u.abs() > v.abs() { 1 } else { 2 };
        let size = u.hypot(v);
        let way = [u / size + 0.0, v / size + 0.0]; // no minus before a zero
        (format!("move along ({:.3}, {:.3})", way[0], way[1]), (body, dof))
    }

    /// What stops a turn of a body about a place: the rotation of its node; where that has none, as
    /// in solids, the motion of the node that the turn moves most.
    fn stop_of_turn(&self, body: NodeIndex, centre: [f64; 3]) -> (NodeIndex, usize) {
        let model = self.start.model;
        let mut about = self
            .presence
            .elements(&model.blocks)
            .filter(|(_, element)| element.nodes.contains(&body))
            .map(|(block, _)| block.dofs().contains(&Dof::UR3))
            .peekable();
        let is_solid = about.peek().is_some() && about.all(|turns| !turns);
        let mut links = model.rigid_links.iter();
        let solid = (0..model.nodes.len())
            .filter(|&node| self.bodies.active[node] && self.bodies.of_node(node) == body);
        let arm = |node: NodeIndex| {
            let [x, y, _] = model.nodes.position(node);
            [x - centre[0], y - centre[1]]
        };
        let far = |node: &NodeIndex| arm(*node)[0].hypot(arm(*node)[1]);
        let farthest = solid.max_by(|a, b| far(a).total_cmp(&far(b)));
        match farthest.filter(|_| is_solid && links.all(|link| link.master != body)) {
            Some(node) => (node, if arm(node)[0].abs() >= arm(node)[1].abs() { 2 } else { 1 }),
            None => (body, 6),
        }
    }

    fn say(
        &self,
        (number, step): (usize, &Step),
        (body, motions): (NodeIndex, &[Motion]),
        for_good: bool,
    ) -> Finding {
        let nodes = &self.start.model.nodes;
        let (label, origin) = (nodes.name(body), nodes.get(body).origin);
        let (how, mut dofs): (Vec<String>, Vec<(NodeIndex, usize)>) =
            motions.iter().map(|motion| self.describe(body, *motion)).unzip();
        dofs.sort_unstable();
        dofs.dedup();
        let how = how.join(", and ");
        let when =
            if number == 0 { String::new() } else { format!("from step {} on ", number + 1) };
        if !for_good {
            let message = format!(
                "{when}the body of node {label} will be supported only by contact that is still \
                 open; until then it can {how}"
            );
            return Finding::said(Diagnostic::advice(Code("SL0414"), message).at(origin).help(
                "the run will stabilise the contact if necessary (*CONTACT CONTROLS, STABILIZE); \
                 for an undamped path move the body by a displacement on *BOUNDARY until it \
                 touches, or attach a weak *SPRING",
            ));
        }
        let message = format!("{when}the body of node {label} is unsupported: it can {how} freely");
        let list: Vec<String> = dofs
            .chunk_by(|a, b| a.0 == b.0)
            .map(|own| {
                let numbers: Vec<String> = own.iter().map(|(_, dof)| dof.to_string()).collect();
                format!(
                    "node {}, degree of freedom {}",
                    nodes.name(own[0].0),
                    numbers.join(" and ")
                )
            })
            .collect();
        let said = Diagnostic::warning(Code("SL0409"), message)
            .at(origin)
            .help(format!("support it: *BOUNDARY with {}", list.join(", and ")));
        let line =
            |&(node, dof): &(NodeIndex, usize)| format!("{}, {dof}, {dof}\n", nodes.name(node));
        let lines: String = dofs.iter().map(line).collect();
        // behind the step's own cards, of which one may begin with OP=NEW
        let own = step.prescribed.iter().map(|p| p.origin);
        let own = own.filter(|at| at.file == step.origin.file && at.start > step.origin.start);
        match own.max_by_key(|at| at.start).or(step.procedure.origin) {
            Some(at) => Finding::with(said, Place::After(at), format!("*BOUNDARY\n{lines}")),
            None => Finding::said(said),
        }
    }
}

fn master_node(pair: &ContactPair) -> NodeIndex {
    match &pair.master {
        Master::RigidSurface(surface) => surface.reference,
        Master::SlideLine(line) => line.nodes.first().copied().unwrap_or_default(),
        Master::Faces(faces) => faces.first_node().unwrap_or_default(),
        Master::Itself(surface) => surface.nodes().next().unwrap_or_default(),
    }
}
