//! The results of an increment, a block for each quantity.

use crate::fixed::{push_exponent, push_whole};
use crate::outline::{Drawing, SPACE};
use crate::section::nodal_sections;
use slideline_model::{Dialect, Dof, ElementVariable, NodeIndex};
use slideline_results::element::{AtNodes, nodal_results};
use slideline_results::{NodeField, contact_component};
use slideline_solve::observe::{ContactRow, Frame};
use std::collections::{BTreeMap, HashSet};
use std::fmt::Write as _;

/// How a viewer combines components.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Shape {
    Scalars,
    /// With a magnitude that viewers compute.
    Vector,
    /// xx, yy, zz, xy, yz, zx.
    Tensor,
}

/// The results of one increment on their way to the file.
pub(super) struct Results<'a> {
    pub text: &'a mut String,
    pub frame: &'a Frame<'a>,
    /// Numbers of nodes that are not in the file.
    pub left_out: &'a HashSet<u64>,
    /// Of the increment among those of all steps.
    pub number: usize,
}

impl Results<'_> {
    /// DISP and FORC of every node, and NDTEMP where the deck speaks of temperatures.
    pub fn push_motion(&mut self, drawing: &Drawing) {
        let [_, mut motion] = drawing.moved(self.frame);
        let mut forces: Vec<f64> = match self.frame.model.dialect {
            // there RF is what supports and loads do together
            Dialect::Calculix => {
                let own = |node| SPACE.map(|dof| self.frame.nodal.carried(node, dof));
                (0..self.frame.model.nodes.len()).flat_map(own).collect()
            }
            Dialect::Abaqus => NodeField::Reaction.table(self.frame, &SPACE),
        };
        if self.along_own_axes() {
            let named =
                drawing.values(self.named(|node, dof| self.frame.nodal.named(node, dof)[0]));
            let of_nodes = motion.len() - 3 * drawing.outline_points();
            motion[..of_nodes].copy_from_slice(&named[..of_nodes]);
            forces = self.named(|node, dof| match self.frame.model.dialect {
                Dialect::Calculix => self.frame.nodal.carried_as_named(node, dof),
                Dialect::Abaqus => self.frame.nodal.named(node, dof)[1],
            });
        }
        let forces = drawing.values(forces);
        let rows = |values: &[f64]| {
            drawing.labels.iter().copied().zip(values.as_chunks().0.iter().copied()).collect()
        };
        self.push("DISP", Shape::Vector, &["D1", "D2", "D3"], rows(&motion));
        self.push("FORC", Shape::Vector, &["F1", "F2", "F3"], rows(&forces));
        if self.frame.model.has_temperatures() {
            let nodes = &self.frame.model.nodes;
            let of = |node| (nodes.label(node), [self.frame.nodal.temperature(node)]);
            self.push("NDTEMP", Shape::Scalars, &["T"], (0..nodes.len()).map(of).collect());
        }
    }

    /// Whether the step asks for vectors along the axes of the nodes: `GLOBAL=NO`.
    fn along_own_axes(&self) -> bool {
        let step = self.frame.model.steps.get(self.frame.step.wrapping_sub(1));
        let mut prints = step.into_iter().flat_map(|step| &step.output.node_prints);
        let asked = prints.any(|print| print.request.target.is_file() && print.own_axes);
        asked && self.frame.model.has_own_axes()
    }

    /// Values of every node along the axes in which its dofs are named.
    fn named(&self, value: impl Fn(NodeIndex, Dof) -> f64) -> Vec<f64> {
        let own = |node| SPACE.map(|dof| value(node, dof));
        (0..self.frame.model.nodes.len()).flat_map(own).collect()
    }

    /// Stresses at the nodes of solids and beams, section forces of beams.
    pub fn push_sections(&mut self) {
        let nodes = nodal_sections(self.frame);
        let label = |node: &NodeIndex| self.frame.model.nodes.label(*node);
        let solids = nodal_results(self.frame, self.frame.model.nodes.len(), |_, node| node);
        let of_solids = solids.iter().enumerate().filter_map(|(node, own)| Some((node, *own?)));
        let of_solids: BTreeMap<NodeIndex, AtNodes> = of_solids.collect();
        let mut tensors: BTreeMap<NodeIndex, [f64; 6]> =
            of_solids.iter().map(|(&node, own)| (node, in_order(own.stress))).collect();
        // where beams and solids share a node, the beam's outer fibre is told
        tensors.extend(nodes.iter().map(|(&node, at)| (node, at.tensor())));
        if tensors.is_empty() {
            return;
        }
        let stress = tensors.iter().map(|(node, tensor)| (label(node), *tensor)).collect();
        let points = nodes.iter().map(|(node, at)| (label(node), at.stresses())).collect();
        let forces = nodes.iter().map(|(node, at)| (label(node), at.forces())).collect();
        let names = ["SXX", "SYY", "SZZ", "SXY", "SYZ", "SZX"];
        self.push("STRESS", Shape::Tensor, &names, stress);
        self.push_asked(&of_solids);
        if nodes.is_empty() {
            return;
        }
        let names = ["S11_1", "S11_2", "S11_3", "S11_4", "S11_5"];
        self.push("S11", Shape::Scalars, &names, points);
        self.push("SECTION", Shape::Scalars, &["SF1", "SF2", "SM1"], forces);
    }

    /// What the step asks for beside stresses, of the nodes of solids.
    fn push_asked(&mut self, solids: &BTreeMap<NodeIndex, AtNodes>) {
        let step = self.frame.model.steps.get(self.frame.step.wrapping_sub(1)).into_iter();
        let prints = step.flat_map(|step| &step.output.element_prints);
        let files = prints.filter(|print| print.request.target.is_file());
        let asked: Vec<ElementVariable> =
            files.flat_map(|print| &print.variables).copied().collect();
        let label = |node: &NodeIndex| self.frame.model.nodes.label(*node);
        let strains = solids.iter().map(|(node, own)| (label(node), in_order(own.strain)));
        let plastic = solids.iter().map(|(node, own)| (label(node), [own.plastic]));
        let of_all_work = self.frame.model.dialect == Dialect::Calculix;
        let energy = solids.iter().map(|(node, own)| {
            let taken = if of_all_work { own.dissipated } else { 0.0 };
            (label(node), [own.energy + taken])
        });
        let (strains, plastic, energy) = (strains.collect(), plastic.collect(), energy.collect());
        if asked.iter().any(|own| matches!(own, ElementVariable::E | ElementVariable::LE)) {
            let names = ["EXX", "EYY", "EZZ", "EXY", "EYZ", "EZX"];
            self.push("TOSTRAIN", Shape::Tensor, &names, strains);
        }
        // CalculiX does not tell creep from plastic strain
        let flowed = |own: &ElementVariable| match own {
            ElementVariable::PEEQ => true,
            ElementVariable::CEEQ => of_all_work,
            _ => false,
        };
        if asked.iter().any(flowed) {
            self.push("PE", Shape::Scalars, &["PE"], plastic);
        }
        if asked.contains(&ElementVariable::ENER) {
            self.push("ENER", Shape::Scalars, &["ENER"], energy);
        }
    }

    pub fn push_contact(&mut self) {
        let label = |node: &NodeIndex| self.frame.model.nodes.label(*node);
        // in the plane there is no second tangent
        let names = ["COPEN", "CSLIP1", "CSLIP2", "CPRESS", "CSHEAR1", "CSHEAR2"];
        let parts = names.map(contact_component);
        let values = |row: &ContactRow| parts.map(|own| own.map_or(0.0, |own| (own.value)(row)));
        let rows: Vec<(u64, [f64; 6])> =
            contact(self.frame).iter().map(|(node, row)| (label(node), values(row))).collect();
        if !rows.is_empty() {
            self.push("CONTACT", Shape::Scalars, &names, rows);
        }
    }

    /// A block of results. A String takes any text.
    fn push<const N: usize>(
        &mut self,
        name: &str,
        shape: Shape,
        components: &[&str; N],
        rows: Vec<(u64, [f64; N])>,
    ) {
        let (frame, number, text) = (self.frame, self.number, &mut *self.text);
        let rows = || rows.iter().filter(|(label, _)| !self.left_out.contains(label));
        let (mut time, nodes) = (String::new(), rows().count());
        push_exponent(&mut time, frame.total_time, 5);
        let (step, increment) = (frame.step, frame.increment);
        let _ = writeln!(text, "    1PSTEP{:16}{number:>10}{increment:>10}{step:>10}", "");
        let _ = writeln!(
            text,
            "  100CL{:>5}{time}{nodes:>12}{:20} 0{number:>5}{:10} 1",
            100 + number,
            "",
            ""
        );
        let count = N + usize::from(shape == Shape::Vector);
        let _ = writeln!(text, " -4  {name:<8}{count:>5}    1");
        for (place, component) in components.iter().enumerate() {
            let (kind, first, second) = match shape {
                Shape::Scalars => (1, place + 1, 0),
                Shape::Vector => (2, place + 1, 0),
                Shape::Tensor => {
                    let (first, second) = TENSOR[place % 6];
                    (4, first, second)
                }
            };
            let _ = writeln!(text, " -5  {component:<8}    1{kind:>5}{first:>5}{second:>5}    0");
        }
        if shape == Shape::Vector {
            text.push_str(" -5  ALL         1    2    0    0    1ALL\n");
        }
        for (label, values) in rows() {
            push_node(text, *label, values);
        }
        text.push_str(" -3\n");
    }
}

/// Places of the components of a tensor.
const TENSOR: [(usize, usize); 6] = [(1, 1), (2, 2), (3, 3), (1, 2), (2, 3), (3, 1)];

/// Slave nodes that face a master; a node of several pairs shows where it is
/// pressed most.
fn contact<'a>(frame: &Frame<'a>) -> BTreeMap<NodeIndex, &'a ContactRow> {
    let mut shown: BTreeMap<NodeIndex, &ContactRow> = BTreeMap::new();
    for row in frame.contact.iter().filter(|row| row.opening.is_finite()) {
        let kept = shown.entry(row.node).or_insert(row);
        if row.pressure > kept.pressure {
            *kept = row;
        }
    }
    shown
}

/// xx, yy, zz, xy, yz, zx of 11, 22, 33, 12, 13, 23.
fn in_order([xx, yy, zz, xy, zx, yz]: [f64; 6]) -> [f64; 6] {
    [xx, yy, zz, xy, yz, zx]
}

/// A line of a node: its number and values of twelve places.
pub(super) fn push_node(text: &mut String, label: u64, values: &[f64]) {
    text.push_str(" -1");
    push_whole(text, label, 10);
    for &value in values {
        push_exponent(text, value, 5);
    }
    text.push('\n');
}
