//! `JOB.frd`: mesh and nodal results in the ASCII format of CalculiX, which
//! cgx and PrePoMax open. Written where the deck asks for result files.
//!
//! ```text
//!     1C title      2C nodes      3C elements (type 11: lines)
//!   100C DISP, FORC, CONTACT for each increment that is due
//!  9999
//! ```

use crate::file::{Growing, WriteError, beside};
use crate::job::JobFiles;
use crate::writers::Writer;
use slideline_model::{Dof, ElementBlock, Model, NodeIndex, OutputRequests, PrintTarget};
use slideline_solve::observe::{ContactRow, Event, Frame};
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// Writes `JOB.frd`; it takes its name when the run is over.
pub(crate) struct Frd {
    job: JobFiles,
    file: Option<Growing>,
    blocks: usize,
}

impl Frd {
    pub fn new(job: &JobFiles) -> Self {
        Self { job: job.clone(), file: None, blocks: 0 }
    }

    fn begin(&mut self, model: &Model) -> Result<(), WriteError> {
        let asked = model.steps.iter().any(|step| !frequencies(&step.output).is_empty());
        if !asked || self.file.is_some() {
            return Ok(());
        }
        let mut file = Growing::create(beside(&self.job.path(".frd")))?;
        push_mesh(&mut file.text, model, &self.job.name());
        file.flush()?;
        self.file = Some(file);
        Ok(())
    }

    fn state(&mut self, frame: &Frame<'_>) -> Result<(), WriteError> {
        let Some(file) = &mut self.file else { return Ok(()) };
        let Some(step) = frame.model.steps.get(frame.step - 1) else { return Ok(()) };
        let asked = frequencies(&step.output);
        let due = asked.iter().any(|&every| frame.increment.is_multiple_of(every.max(1)));
        if asked.is_empty() || !(due || frame.last_of_step) {
            return Ok(());
        }
        self.blocks += 1;
        push_results(&mut file.text, frame, self.blocks);
        file.flush()
    }

    fn finish(&mut self) -> Result<(), WriteError> {
        let Some(mut file) = self.file.take() else { return Ok(()) };
        file.text.push_str(" 9999\n");
        file.rename(&self.job.path(".frd"))
    }
}

/// Every how many increments the requests for result files are due.
fn frequencies(output: &OutputRequests) -> Vec<usize> {
    let nodes = output.node_prints.iter().map(|print| (print.target, print.frequency));
    let elements = output.element_prints.iter().map(|print| (print.target, print.frequency));
    let contact = output.contact_prints.iter().map(|print| (print.target, print.frequency));
    let all = nodes.chain(elements).chain(contact);
    all.filter(|(target, _)| *target == PrintTarget::File).map(|(_, every)| every).collect()
}

/// Title, nodes and line elements. A String takes any text.
fn push_mesh(text: &mut String, model: &Model, job: &str) {
    let _ = writeln!(text, "    1C{:<66}", job.chars().filter(char::is_ascii).collect::<String>());
    let _ = writeln!(text, "    2C{:18}{:>12}{:37}1", "", model.nodes.len(), "");
    for node in model.nodes.iter() {
        let _ = write!(text, " -1{:>10}", node.label);
        push_floats(text, &node.position);
    }
    text.push_str(" -3\n");
    let lines = lines(model);
    let _ = writeln!(text, "    3C{:18}{:>12}{:37}1", "", lines.len(), "");
    for (place, (group, nodes)) in lines.iter().enumerate() {
        let [a, b] = nodes.map(|node| model.nodes.label(node));
        let _ = writeln!(text, " -1{:>10}{:>5}{group:>5}{:>5}", place + 1, 11, 1);
        let _ = writeln!(text, " -2{a:>10}{b:>10}");
    }
    text.push_str(" -3\n");
}

/// Beams and springs (groups 0 and 1), slave surfaces (2), numbered in turn:
/// a beam of three nodes is two lines.
fn lines(model: &Model) -> Vec<(u32, [NodeIndex; 2])> {
    let mut lines = Vec::new();
    for block in &model.blocks {
        if let Some(beams) = block.beams() {
            for beam in &beams.elements {
                let ends = beam.all_nodes().zip(beam.all_nodes().skip(1));
                lines.extend(ends.map(|(a, b)| (0, [a, b])));
            }
        } else if let ElementBlock::Spring(springs) = block {
            let joining = springs.elements.iter().filter(|e| e.nodes[0] != e.nodes[1]);
            lines.extend(joining.map(|e| (1, e.nodes)));
        }
    }
    let pairs = model.contact_pairs.iter();
    lines.extend(pairs.flat_map(|pair| &pair.elements).map(|element| (2, element.nodes)));
    lines
}

fn push_results(text: &mut String, frame: &Frame<'_>, block: usize) {
    let moves = [Dof::U1, Dof::U2, Dof::U3];
    let nodes: Vec<NodeIndex> = (0..frame.model.nodes.len()).collect();
    push_head(text, frame, (block, nodes.len()), ("DISP", &["D1", "D2", "D3"]));
    for &node in &nodes {
        push_node(text, frame, node, &moves.map(|dof| frame.nodal.displacement(node, dof)));
    }
    text.push_str(" -3\n");
    push_head(text, frame, (block, nodes.len()), ("FORC", &["F1", "F2", "F3"]));
    for &node in &nodes {
        push_node(text, frame, node, &moves.map(|dof| frame.nodal.reaction(node, dof)));
    }
    text.push_str(" -3\n");
    let contact = contact(frame);
    if contact.is_empty() {
        return;
    }
    let names = ["COPEN", "CSLIP1", "CSLIP2", "CPRESS", "CSHEAR1", "CSHEAR2"];
    push_head(text, frame, (block, contact.len()), ("CONTACT", &names));
    for (&node, row) in &contact {
        push_node(text, frame, node, &[row.opening, row.slip, 0.0, row.pressure, row.shear, 0.0]);
    }
    text.push_str(" -3\n");
}

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

/// Head of a result block: vectors have a magnitude that viewers compute.
fn push_head(
    text: &mut String,
    frame: &Frame<'_>,
    (block, nodes): (usize, usize),
    (name, components): (&str, &[&str]),
) {
    let vector = components.len() == 3;
    let (step, increment, time) = (frame.step, frame.increment, exponent(frame.total_time));
    let _ = writeln!(text, "    1PSTEP{:16}{block:>10}{increment:>10}{step:>10}", "");
    let _ = writeln!(text, "  100CL  {:>3}{time}{nodes:>12}{:20} 0{block:>5}{:10} 1", 100, "", "");
    let count = components.len() + usize::from(vector);
    let _ = writeln!(text, " -4  {name:<8}{count:>5}    1");
    for (place, component) in components.iter().enumerate() {
        let kind = if vector { 2 } else { 1 };
        let _ = writeln!(text, " -5  {component:<8}    1{kind:>5}{:>5}    0", place + 1);
    }
    if vector {
        text.push_str(" -5  ALL         1    2    0    0    1ALL\n");
    }
}

fn push_node(text: &mut String, frame: &Frame<'_>, node: NodeIndex, values: &[f64]) {
    let _ = write!(text, " -1{:>10}", frame.model.nodes.label(node));
    push_floats(text, values);
}

fn push_floats(text: &mut String, values: &[f64]) {
    for &value in values {
        text.push_str(&exponent(value));
    }
    text.push('\n');
}

/// Twelve places, as E12.5 writes: `-1.23457E-03`.
fn exponent(value: f64) -> String {
    let text = format!("{value:.5e}");
    let (digits, power) = text.split_once('e').unwrap_or((&text, "0"));
    let power: i32 = power.parse().unwrap_or(0);
    let (digits, power) = match power {
        ..-99 => ("0.00000", 0), // two digits of a power is all there is room for
        _ => (digits, power),
    };
    let sign = if power < 0 { '-' } else { '+' };
    format!("{:>12}", format!("{digits}E{sign}{:02}", power.abs()))
}

impl Writer for Frd {
    fn event(&mut self, event: &Event<'_>) -> Result<(), WriteError> {
        match event {
            Event::StepBegin(report) => self.begin(report.model),
            Event::Committed(frame) => self.state(frame),
            Event::End(_) => self.finish(),
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::exponent;

    /// Requirement: E12.5, twelve places whatever the value.
    #[test]
    fn numbers_take_twelve_places() {
        assert_eq!(exponent(-1.234_567e-3), "-1.23457E-03");
        assert_eq!(exponent(0.0), " 0.00000E+00");
        assert_eq!(exponent(-3.0e-200), " 0.00000E+00");
        assert_eq!(exponent(2.5e10), " 2.50000E+10");
    }
}
