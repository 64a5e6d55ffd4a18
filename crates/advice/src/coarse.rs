//! Slave surfaces of solids that are coarser than their master, contact at nodes.
//!
//! ```text
//!   slave    o-----------------o      the slave's nodes stand on the master; the master's nodes
//!   master   o---o---o---o---o---o    between them go into the slave, and nothing holds them
//! ```
//!
//! What is pressed flat is then carried by a few nodes of the master, which give way as under point
//! forces. Blocks of one modulus whose slave edges are twice as long lose a third of their force in
//! space and a tenth in the plane where the slave is two elements wide, two thirds and a third where
//! it is one; a master of ten times the modulus makes that 8 and 2 %, one of a hundred times 1 % and
//! less.

use crate::finding::Finding;
use crate::start::{Start, length, less};
use slideline_diag::{Code, Diagnostic};
use slideline_model::{ContactPair, Formulation, Master, NodeIndex, Section};
use std::collections::{HashMap, HashSet};

/// Ratio of the distances of nodes from which on a slave is coarse [1].
const COARSE: f64 = 1.5;
/// Ratio of moduli from which on a master keeps its shape between slaves [1].
const STIFF: f64 = 30.0;

/// SL0428: slaves farther apart than the nodes of a deforming master.
pub fn judge(start: &Start<'_>, findings: &mut Vec<Finding>) {
    let at_nodes = |pair: &&ContactPair| pair.formulation == Formulation::NodeToSurface;
    let pairs: Vec<&ContactPair> = start.model.contact_pairs.iter().filter(at_nodes).collect();
    if pairs.is_empty() {
        return;
    }
    let moduli = moduli(start);
    for pair in &pairs {
        let Some(sides) = Sides::of(start, pair) else { continue };
        let mirrored = pairs.iter().any(|other| sides.are_met_by(other));
        let [own, other] = [&sides.slave, &sides.master].map(|edges| stiffness(edges, &moduli));
        let (Some(own), Some(other)) = (own, other) else { continue };
        if mirrored || other >= STIFF * own {
            continue;
        }
        let [apart, between] = [&sides.slave, &sides.master].map(|edges| typical(start, edges));
        if apart > COARSE * between && between > 0.0 {
            findings.push(say(pair, apart, between));
        }
    }
}

/// Lines between neighbouring nodes of both sides of a pair.
struct Sides {
    slave: Vec<[NodeIndex; 2]>,
    master: Vec<[NodeIndex; 2]>,
}

impl Sides {
    /// Those of a pair of solids; none where a side has no faces, or is rigid.
    fn of(start: &Start<'_>, pair: &ContactPair) -> Option<Self> {
        let master: Vec<[NodeIndex; 2]> = match &pair.master {
            Master::SlideLine(line) if pair.of_solids => {
                line.nodes.windows(2).map(|ends| [ends[0], ends[1]]).collect()
            }
            Master::Faces(faces) if faces.swept.is_none() && !faces.meets_itself => {
                faces.faces.iter().flat_map(|face| edges(&face.nodes)).collect()
            }
            _ => return None,
        };
        let listed: HashSet<NodeIndex> = pair.slaves.iter().copied().collect();
        let is_slave = |node: &NodeIndex| listed.is_empty() || listed.contains(node);
        let faces = pair.faces.iter().flat_map(|face| edges(&face.nodes));
        let elements = pair.elements.iter().map(|element| element.nodes);
        let slave: Vec<[NodeIndex; 2]> =
            faces.chain(elements).filter(|ends| ends.iter().all(is_slave)).collect();
        let rigid = master.iter().flatten().all(|&node| start.bodies.dependent[node].is_some());
        (!slave.is_empty() && !rigid).then_some(Self { slave, master })
    }

    /// Whether another pair samples the same surfaces with turned roles.
    fn are_met_by(&self, other: &ContactPair) -> bool {
        let masters: HashSet<NodeIndex> = match &other.master {
            Master::SlideLine(line) => line.nodes.iter().copied().collect(),
            Master::Faces(faces) => faces.faces.iter().flat_map(|f| &f.nodes).copied().collect(),
            Master::Itself(_) | Master::RigidSurface(_) => return false,
        };
        let slaves: HashSet<NodeIndex> = other.slave_places().collect();
        self.slave.iter().flatten().any(|node| masters.contains(node))
            && self.master.iter().flatten().any(|node| slaves.contains(node))
    }
}

/// Stretches between neighbouring nodes along the edges of a face, whose middle nodes come after
/// its corners.
fn edges(nodes: &[NodeIndex]) -> Vec<[NodeIndex; 2]> {
    let corners = if nodes.len().is_multiple_of(3) { 3 } else { 4 }.min(nodes.len());
    let is_quadratic = nodes.len() >= 2 * corners;
    let mut all = Vec::with_capacity(2 * corners);
    for k in 0..corners {
        let (from, to) = (nodes[k], nodes[(k + 1) % corners]);
        if is_quadratic {
            all.extend([[from, nodes[corners + k]], [nodes[corners + k], to]]);
        } else {
            all.push([from, to]);
        }
    }
    all
}

/// The middle one of their lengths [L].
fn typical(start: &Start<'_>, edges: &[[NodeIndex; 2]]) -> f64 {
    let place = |node| start.model.nodes.position(node);
    let mut lengths: Vec<f64> =
        edges.iter().map(|&[a, b]| length(less(place(b), place(a)))).collect();
    let middle = lengths.len() / 2;
    *lengths.select_nth_unstable_by(middle, f64::total_cmp).1
}

/// The largest modulus at every node of solids [F/L2].
fn moduli(start: &Start<'_>) -> HashMap<NodeIndex, f64> {
    let mut moduli = HashMap::new();
    for block in &start.model.blocks {
        let Section::Solid(section) = &block.section else { continue };
        let own = section.material.stiffest();
        for &node in block.elements.iter().flat_map(|element| element.nodes) {
            let most = moduli.entry(node).or_insert(own);
            *most = own.max(*most);
        }
    }
    moduli
}

/// The largest modulus along edges; none where they are of no solid.
fn stiffness(edges: &[[NodeIndex; 2]], moduli: &HashMap<NodeIndex, f64>) -> Option<f64> {
    edges.iter().flatten().filter_map(|node| moduli.get(node)).copied().reduce(f64::max)
}

fn say(pair: &ContactPair, apart: f64, between: f64) -> Finding {
    let message = format!(
        "slave nodes of {} stand {:.2} times as far apart as those of the master, and contact is \
         sampled at slave nodes alone: what lies between them goes into the slave, and forces come \
         out too small",
        pair.name,
        apart / between
    );
    let said = Diagnostic::advice(Code("SL0428"), message).at(pair.origin);
    Finding::said(said.help(
        "name the surface with the finer mesh first on *CONTACT PAIR, or give it \
         TYPE=SURFACE TO SURFACE; general contact leaves surfaces to a *CONTACT PAIR of their own",
    ))
}
