//! Printed tables of nodes, beams and contact.
//!
//! ```text
//!   STEP 1  INCREMENT 20  TOTAL TIME 1  NODES TIP
//!         NODE             RF1             RF2
//!         9999     1.2345670e0    -8.7654321e0
//!        TOTAL     1.2345670e0    -8.7654321e0     TOTALS=YES
//!      MAXIMUM     1.2345670e0    -8.7654321e0     SUMMARY=YES
//!           AT            9999            9999
//! ```

use crate::section::{axial_stresses, beams, outer_mises};
use slideline_model::{
    BeamSection, ContactPrint, ContactVariable, ElementPrint, ElementType, ElementVariable, Model,
    NodeIndex, NodePrint, Request,
};
use slideline_results::element as solid;
use slideline_results::{CONTACT_FIELDS, ContactComponent, NodeComponent, NodeField};
use slideline_solve::observe::{BeamRow, ContactRow, Frame};
use std::fmt::Write as _;

/// A table on its way to the file.
struct Table {
    /// What stands above the places, such as `NODE`.
    head: String,
    names: Vec<&'static str>,
    rows: Vec<Row>,
}

struct Row {
    /// What stands before the values, as wide as the table's head.
    head: String,
    /// Number of the node or element.
    label: u64,
    values: Vec<f64>,
}

impl Table {
    /// Appends it under its title, then what the request wants below.
    fn push(&self, text: &mut String, frame: &Frame<'_>, (what, request): (&str, &Request)) {
        let set = &request.set;
        let of = if set.is_empty() { String::new() } else { format!(" {set}") };
        // A String takes any text.
        let _ = writeln!(
            text,
            "\nSTEP {}  INCREMENT {}  TOTAL TIME {}  {what}{of}",
            frame.step, frame.increment, frame.total_time
        );
        push_cells(text, &self.head, self.names.iter());
        for row in &self.rows {
            push_values(text, &row.head, &row.values);
        }
        let columns = 0..self.names.len();
        if request.totals {
            let sum = |column| self.rows.iter().map(|row| row.values[column]).sum();
            let sums: Vec<f64> = columns.clone().map(sum).collect();
            push_values(text, &self.below("TOTAL"), &sums);
        }
        if request.summary && !self.rows.is_empty() {
            self.push_extreme(text, "MAXIMUM", |value, most| value > most);
            self.push_extreme(text, "MINIMUM", |value, least| value < least);
        }
    }

    /// A row of extremes, and below it where they are: the first of equals.
    fn push_extreme(&self, text: &mut String, what: &str, beyond: fn(f64, f64) -> bool) {
        let mut extremes: Vec<(f64, u64)> = Vec::new();
        for row in &self.rows {
            for (column, &value) in row.values.iter().enumerate() {
                match extremes.get_mut(column) {
                    Some(extreme) if beyond(value, extreme.0) => *extreme = (value, row.label),
                    Some(_) => {}
                    None => extremes.push((value, row.label)),
                }
            }
        }
        let (values, labels): (Vec<f64>, Vec<u64>) = extremes.into_iter().unzip();
        push_values(text, &self.below(what), &values);
        push_cells(text, &self.below("AT"), labels.iter());
    }

    fn below(&self, what: &str) -> String {
        format!("{what:>width$}", width = self.head.chars().count())
    }
}

fn push_cells(text: &mut String, head: &str, cells: impl Iterator<Item = impl std::fmt::Display>) {
    text.push_str(head);
    for cell in cells {
        let _ = write!(text, " {cell:>15}"); // a String takes any text
    }
    text.push('\n');
}

fn push_values(text: &mut String, head: &str, values: &[f64]) {
    push_cells(text, head, values.iter().map(|value| format!("{value:.7e}")));
}

/// A table that `*NODE PRINT` asks for: a row a node.
pub(crate) fn push_nodes(text: &mut String, frame: &Frame<'_>, print: &NodePrint) {
    let dofs = frame.nodal.dofs();
    let fields = print.variables.iter().map(|&variable| NodeField::from(variable));
    let columns: Vec<NodeComponent> = fields.flat_map(|field| field.components(dofs)).collect();
    let row = |&node: &NodeIndex| {
        let label = frame.model.nodes.label(node);
        let values = columns.iter().map(|column| column.value(frame, node)).collect();
        Row { head: format!("{label:>10}"), label, values }
    };
    let table = Table {
        head: format!("{:>10}", "NODE"),
        names: columns.iter().map(|column| column.name()).collect(),
        rows: print.nodes.iter().map(row).collect(),
    };
    let what = if print.request.set.is_empty() { "NODES all nodes" } else { "NODES" };
    table.push(text, frame, (what, &print.request));
}

/// The tables that `*EL PRINT` asks for: of beams and of solids.
pub(crate) fn push_elements(text: &mut String, frame: &Frame<'_>, print: &ElementPrint) {
    let for_solids = |variable: &ElementVariable| {
        solid_field(*variable).is_some() || *variable == ElementVariable::MISES
    };
    let of_solids = print.variables.iter().any(for_solids);
    let solids = of_solids && push_solids(text, frame, print);
    if !solids || frame.model.blocks.iter().any(|block| block.beams().is_some()) {
        push_beams(text, frame, print);
    }
}

/// A row an integration point of a solid; false where there is none.
fn push_solids(text: &mut String, frame: &Frame<'_>, print: &ElementPrint) -> bool {
    let mut rows = Vec::new();
    let mut widest: Option<&ElementType> = None;
    for (kind, results) in solid::blocks(frame) {
        for (element, values) in results.elements(frame.model) {
            let label = element.label;
            if print.elements.binary_search(&label).is_err() {
                continue;
            }
            widest = widest.filter(|old| old.dofs.len() >= kind.dofs.len()).or(Some(kind));
            for point in 0..solid::stresses(kind, values).len() {
                let of = |&variable| solid_values(variable, kind, values, point);
                let head = format!("{label:>10} {:>5}", point + 1);
                rows.push(Row {
                    head,
                    label,
                    values: print.variables.iter().flat_map(of).collect(),
                });
            }
        }
    }
    let found = !rows.is_empty();
    if let Some(kind) = widest.filter(|_| found) {
        let names = print.variables.iter().flat_map(|&variable| solid_columns(variable, kind));
        let head = format!("{:>10} {:>5}", "ELEMENT", "POINT");
        let table = Table { head, names: names.copied().collect(), rows };
        let what = if print.request.set.is_empty() { "ELEMENTS all solids" } else { "ELEMENTS" };
        table.push(text, frame, (what, &print.request));
    }
    found
}

/// The field of a solid that holds a variable.
fn solid_field(variable: ElementVariable) -> Option<&'static str> {
    match variable {
        ElementVariable::S => Some("S"),
        ElementVariable::E => Some("E"),
        ElementVariable::PEEQ => Some("PEEQ"),
        _ => None,
    }
}

/// Names of a variable's components in elements of a type.
fn solid_columns(variable: ElementVariable, kind: &ElementType) -> &'static [&'static str] {
    match solid_field(variable) {
        Some(name) => kind.field(name).map_or(&[], |(field, _)| field.components),
        None if variable == ElementVariable::MISES => &["MISES"],
        None => &[],
    }
}

fn solid_values(
    variable: ElementVariable,
    kind: &ElementType,
    values: &[f64],
    point: usize,
) -> Vec<f64> {
    if variable == ElementVariable::MISES {
        return vec![solid::mises(solid::stresses(kind, values)[point])];
    }
    let Some((field, first)) = solid_field(variable).and_then(|name| kind.field(name)) else {
        return Vec::new();
    };
    let width = field.components.len();
    values[first + width * point..first + width * (point + 1)].to_vec()
}

/// A row a beam and, where stresses are asked for, one a section point.
fn push_beams(text: &mut String, frame: &Frame<'_>, print: &ElementPrint) {
    let stressed = print.variables.contains(&ElementVariable::S);
    let place = |element: &str, point: &str| match stressed {
        true => format!("{element:>10} {point:>5}"),
        false => format!("{element:>10}"),
    };
    let points: &[usize] = if stressed { &print.section_points } else { &[1] };
    let own = |label: &u64| print.elements.binary_search(label).is_ok();
    let mut rows = Vec::new();
    for (beam, _, section) in beams(frame).filter(|(beam, ..)| own(&beam.label)) {
        for &point in points {
            let values = print.variables.iter();
            let values = values.flat_map(|&v| element_values(v, beam, section, point)).collect();
            let head = place(&beam.label.to_string(), &point.to_string());
            rows.push(Row { head, label: beam.label, values });
        }
    }
    let names = print.variables.iter().flat_map(|&variable| element_columns(variable));
    let table = Table { head: place("ELEMENT", "POINT"), names: names.copied().collect(), rows };
    let what = if print.request.set.is_empty() { "ELEMENTS all beams" } else { "ELEMENTS" };
    table.push(text, frame, (what, &print.request));
}

fn element_columns(variable: ElementVariable) -> &'static [&'static str] {
    match variable {
        ElementVariable::SF => &["SF1", "SF2"],
        ElementVariable::SM => &["SM1"],
        ElementVariable::SE => &["SE1", "SE2"],
        ElementVariable::SK => &["SK1"],
        ElementVariable::S => &["S11"],
        ElementVariable::MISES => &["MISES"],
        ElementVariable::E | ElementVariable::PEEQ => &[],
    }
}

fn element_values(
    variable: ElementVariable,
    row: &BeamRow,
    section: &BeamSection,
    point: usize,
) -> Vec<f64> {
    let stresses = axial_stresses(row, section);
    match variable {
        ElementVariable::SF => vec![row.axial_force, row.shear_force],
        ElementVariable::SM => vec![row.bending_moment],
        ElementVariable::SE => row.strains[..2].to_vec(),
        ElementVariable::SK => vec![row.strains[2]],
        ElementVariable::S => vec![stresses[point - 1]],
        ElementVariable::MISES => vec![outer_mises(&stresses)],
        ElementVariable::E | ElementVariable::PEEQ => Vec::new(),
    }
}

/// A table that `*CONTACT PRINT` asks for: a row a slave node of every pair.
pub(crate) fn push_contact(text: &mut String, frame: &Frame<'_>, print: &ContactPrint) {
    let columns = || print.variables.iter().flat_map(|&variable| contact_field(variable));
    let row = |row: &ContactRow| {
        let (pair, label) = (pair_name(frame.model, row), frame.model.nodes.label(row.node));
        let values = columns().map(|column| (column.value)(row)).collect();
        let head = format!("{pair:<16} {label:>10} {:<6}", row.status.word());
        Row { head, label, values }
    };
    let own = frame.contact.iter().filter(|row| print.nodes.contains(&row.node));
    let table = Table {
        head: format!("{:<16} {:>10} {:<6}", "PAIR", "NODE", "STATUS"),
        names: columns().map(|column| column.name).collect(),
        rows: own.map(row).collect(),
    };
    let what = if print.request.set.is_empty() { "CONTACT all slave nodes" } else { "CONTACT" };
    table.push(text, frame, (what, &print.request));
}

fn pair_name<'a>(model: &'a Model, row: &ContactRow) -> &'a str {
    model.contact_pairs.get(row.pair).map_or("", |pair| pair.name.as_str())
}

/// The components that a variable of `*CONTACT PRINT` stands for.
fn contact_field(variable: ContactVariable) -> &'static [ContactComponent] {
    let mut fields = CONTACT_FIELDS.iter();
    fields.find(|field| field.variable == Some(variable)).map_or(&[], |field| field.components)
}
