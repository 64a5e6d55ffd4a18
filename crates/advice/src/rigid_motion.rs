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

use crate::finding::{Finding, Place};
use crate::start::{Start, length, less};
use slideline_diag::{Code, Diagnostic};
use slideline_model::{
    ContactPair, Dof, ElementBlock, Friction, Master, NodeIndex, SpringKind, Step,
};
use std::collections::BTreeMap;

/// Pivots below this count as zero; rows are of length one [1].
const ZERO: f64 = 1e-8;

/// SL0409, and SL0414 where contact that is still open will hold the motion.
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    let Some(step) = start.model.steps.first() else { return };
    let mut holds = Holds::new(start);
    holds.supports(step);
    holds.springs();
    holds.contact(true);
    let Some(free) = holds.motion() else { return };
    holds.contact(false);
    let remaining = holds.motion();
    findings.push(holds.say(step, remaining.as_ref().unwrap_or(&free), remaining.is_some()));
}

struct Holds<'a> {
    start: &'a Start<'a>,
    /// First unknown of every body.
    column: BTreeMap<NodeIndex, usize>,
    rows: Vec<Vec<f64>>,
    size: f64,
}

impl<'a> Holds<'a> {
    fn new(start: &'a Start<'a>) -> Self {
        let mut column = BTreeMap::new();
        for node in (0..start.model.nodes.len()).filter(|&node| start.bodies.active[node]) {
            let next = 3 * column.len();
            column.entry(start.bodies.of_node(node)).or_insert(next);
        }
        let size = if start.reach > 0.0 { start.reach } else { 1.0 };
        Self { start, column, rows: Vec::new(), size }
    }

    fn width(&self) -> usize {
        3 * self.column.len()
    }

    /// Adds `sign` times the motion of `point` with the body of `node` along
    /// `way`; rotations are scaled with the size of the model.
    fn add(&self, row: &mut [f64], node: NodeIndex, point: [f64; 2], way: [f64; 2], sign: f64) {
        let body = self.start.bodies.of_node(node);
        let Some(&first) = self.column.get(&body) else { return };
        let arm = less(point, self.start.model.nodes.plane(body));
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
        let mut row = vec![0.0; self.width()];
        let at = self.start.model.nodes.plane(node);
        match dof {
            Dof::U1 => self.add(&mut row, node, at, [1.0, 0.0], 1.0),
            Dof::U2 => self.add(&mut row, node, at, [0.0, 1.0], 1.0),
            Dof::UR3 => {
                if let Some(&first) = self.column.get(&self.start.bodies.of_node(node)) {
                    row[first + 2] = 1.0;
                }
            }
            _ => {}
        }
        self.rows.push(row);
    }

    fn springs(&mut self) {
        let model = self.start.model;
        for block in &model.blocks {
            let ElementBlock::Spring(block) = block else { continue };
            for spring in &block.elements {
                match block.kind {
                    SpringKind::Ground(dof) => self.hold(spring.nodes[0], dof),
                    SpringKind::Axial => {
                        let ends = spring.nodes.map(|node| model.nodes.plane(node));
                        let way = less(ends[1], ends[0]);
                        let long = length(way);
                        if long > 0.0 {
                            let way = [way[0] / long, way[1] / long];
                            self.between(spring.nodes, ends[0], way);
                        }
                    }
                }
            }
        }
    }

    /// No motion of one body against the other at a point along `way`.
    fn between(&mut self, nodes: [NodeIndex; 2], point: [f64; 2], way: [f64; 2]) {
        let mut row = vec![0.0; self.width()];
        self.add(&mut row, nodes[0], point, way, 1.0);
        self.add(&mut row, nodes[1], point, way, -1.0);
        self.rows.push(row);
    }

    /// Contact that touches, or all contact that faces its master.
    fn contact(&mut self, touching: bool) {
        let model = self.start.model;
        for (place, pair) in model.contact_pairs.iter().enumerate() {
            let begins = pair.interaction.normal.contact_begins();
            let near: Vec<_> = self
                .start
                .facing(place)
                .filter(|row| !touching || row.opening <= -begins + 1e-9 * self.size)
                .copied()
                .collect();
            for row in near {
                let nodes = [row.node, master_node(pair)];
                self.between(nodes, row.position, row.normal);
                if pair.interaction.friction != Friction::Frictionless {
                    let way = [row.normal[1], -row.normal[0]];
                    self.between(nodes, row.position, way);
                }
            }
        }
    }

    /// A motion that no row hinders: (body, u, v, w), the largest body first.
    fn motion(&self) -> Option<(NodeIndex, [f64; 3])> {
        let width = self.width();
        let mut rows = self.rows.clone();
        let mut pivots: Vec<usize> = Vec::new();
        for column in 0..width {
            let from = pivots.len();
            let largest = (from..rows.len())
                .max_by(|&a, &b| rows[a][column].abs().total_cmp(&rows[b][column].abs()));
            let Some(largest) = largest.filter(|&row| rows[row][column].abs() > ZERO) else {
                return Some(self.read(&rows, &pivots, column));
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
        None
    }

    /// The motion with the free unknown at one; all earlier ones are pivots.
    fn read(&self, rows: &[Vec<f64>], pivots: &[usize], free: usize) -> (NodeIndex, [f64; 3]) {
        let mut motion = vec![0.0; self.width()];
        motion[free] = 1.0;
        for (row, &pivot) in pivots.iter().enumerate() {
            motion[pivot] = -rows[row][free] / rows[row][pivot];
        }
        let body = self.column.iter().find(|&(_, &first)| first == free / 3 * 3);
        let body = body.map_or(0, |(&body, _)| body);
        let first = free / 3 * 3;
        (body, [motion[first], motion[first + 1], motion[first + 2] / self.size])
    }

    fn say(&self, step: &Step, free: &(NodeIndex, [f64; 3]), for_good: bool) -> Finding {
        let (body, [u, v, w]) = *free;
        let nodes = &self.start.model.nodes;
        let (label, origin) = (nodes.label(body), nodes.get(body).origin);
        let turns = w.abs() * self.size > ZERO;
        let how = if turns {
            let at = nodes.plane(body);
            let centre = [at[0] - v / w, at[1] + u / w];
            format!("turn about ({:.4e}, {:.4e})", centre[0], centre[1])
        } else {
            format!("move along ({u:.3}, {v:.3})")
        };
        if !for_good {
            let message = format!(
                "only contact that is still open will hold the body of node {label}, which can \
                 {how} until then"
            );
            return Finding::said(Diagnostic::advice(Code("SL0414"), message).at(origin).help(
                "the run will stabilise its contact where it must (*CONTACT CONTROLS, STABILIZE); \
                 for a way that is not damped drive the body by a displacement on *BOUNDARY until \
                 it touches, or attach a weak *SPRING",
            ));
        }
        let message = format!("nothing holds the body of node {label}: it can {how} freely");
        let dof = if turns {
            6
        } else if u.abs() > v.abs() {
            1
        } else {
            2
        };
        let said = Diagnostic::warning(Code("SL0409"), message)
            .at(origin)
            .help(format!("hold it: *BOUNDARY with node {label}, degree of freedom {dof}"));
        match step.procedure.origin {
            Some(at) => {
                Finding::with(said, Place::After(at), format!("*BOUNDARY\n{label}, {dof}, {dof}\n"))
            }
            None => Finding::said(said),
        }
    }
}

fn master_node(pair: &ContactPair) -> NodeIndex {
    match &pair.master {
        Master::RigidSurface(surface) => surface.reference,
        Master::SlideLine(line) => line.nodes.first().copied().unwrap_or_default(),
    }
}
