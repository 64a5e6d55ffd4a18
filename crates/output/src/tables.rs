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

use crate::section::{axial_stresses, outer_mises};
use slideline_mech::orientation;
use slideline_model::{
    Axes, ContactPrint, ContactVariable, Dialect, Element, ElementBlock, ElementPrint, ElementType,
    ElementVariable, Location, Model, NodeIndex, NodePrint, Request, Section, types,
};
use slideline_results::element as solid;
use slideline_results::{CONTACT_FIELDS, ContactComponent, NodeComponent, NodeField};
use slideline_solve::observe::{ContactRow, Frame};
use std::fmt::Write as _;

/// A table on its way to the file.
struct Table {
    /// What stands above the places, such as `NODE`.
    head: String,
    names: Vec<&'static str>,
    rows: Vec<Row>,
    of_beams: bool,
}

struct Row {
    /// What stands before the values, as wide as the table's head.
    head: String,
    /// Number of the node or element.
    label: u64,
    values: Vec<f64>,
    /// What of them is summed, where not the values themselves.
    summed: Option<Vec<f64>>,
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
            let own = |row: &Row, column: usize| row.summed.as_ref().unwrap_or(&row.values)[column];
            let sum = |column| self.rows.iter().map(|row| own(row, column)).sum();
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
        let plain: Vec<f64> = columns.iter().map(|column| column.value(frame, node)).collect();
        let (values, summed) = match print.own_axes && frame.model.has_own_axes() {
            // sums along axes that differ would mean nothing
            true => (columns.iter().map(|own| own.named_value(frame, node)).collect(), Some(plain)),
            false => (plain, None),
        };
        Row { head: format!("{label:>10}"), label, values, summed }
    };
    let table = Table {
        head: format!("{:>10}", "NODE"),
        names: columns.iter().map(|column| column.name()).collect(),
        rows: print.nodes.iter().map(row).collect(),
        of_beams: false,
    };
    let what = if print.request.set.is_empty() { "NODES all nodes" } else { "NODES" };
    table.push(text, frame, (what, &print.request));
}

/// The tables that `*EL PRINT` asks for: of solids, a row an integration point, and of
/// beams, a row a beam or, where stresses are asked for, a section point. Elements
/// whose columns are not the same have tables of their own.
pub(crate) fn push_elements(text: &mut String, frame: &Frame<'_>, print: &ElementPrint) {
    let model = frame.model;
    let mut tables = element_tables(frame, print, false);
    if tables.is_empty() || model.blocks.iter().any(|block| block.beams().is_some()) {
        tables.extend(element_tables(frame, print, true));
    }
    for table in tables {
        let what = match (print.request.set.is_empty(), table.of_beams) {
            (false, _) => "ELEMENTS",
            (true, false) => "ELEMENTS all solids",
            (true, true) => "ELEMENTS all beams",
        };
        table.push(text, frame, (what, &print.request));
    }
}

/// The tables of beams, of which there is one at least, or of other elements.
fn element_tables(frame: &Frame<'_>, print: &ElementPrint, of_beams: bool) -> Vec<Table> {
    let pointed = !of_beams || print.variables.contains(&ElementVariable::S);
    let head = |element: &str, point: &str| match pointed {
        true => format!("{element:>10} {point:>5}"),
        false => format!("{element:>10}"),
    };
    let columns = |kind| -> Vec<&'static str> {
        print.variables.iter().flat_map(|&variable| columns(variable, kind)).copied().collect()
    };
    let empty = |names| Table { head: head("ELEMENT", "POINT"), names, rows: Vec::new(), of_beams };
    let mut tables: Vec<Table> =
        of_beams.then(|| empty(columns(&types::B21))).into_iter().collect();
    for results in frame.elements {
        let block = &frame.model.blocks[results.block];
        let names = columns(block.kind);
        if block.kind.is_beam() != of_beams || names.is_empty() {
            continue;
        }
        for (element, values) in results.elements(frame.model) {
            if print.elements.binary_search(&element.label).is_err() {
                continue;
            }
            let stresses = solid::stresses(block.kind, values);
            let own =
                Own { block, values, stresses, axes: axes(frame.model, print, (block, element)) };
            let points: Vec<usize> = match of_beams {
                true if pointed => print.section_points.clone(),
                true => vec![1],
                // what is told of a beam in space is told of its middle
                false if block.kind.is_space_beam() => vec![1],
                false => (1..=own.stresses.len()).collect(),
            };
            let known = tables.iter().position(|table| table.names == names);
            let known = match known {
                None if points.is_empty() => continue,
                None => {
                    tables.push(empty(names.clone()));
                    tables.len() - 1
                }
                Some(known) => known,
            };
            tables[known].rows.extend(points.into_iter().map(|point| Row {
                head: head(&element.label.to_string(), &point.to_string()),
                label: element.label,
                values: print.variables.iter().flat_map(|&v| own.at(v, point)).collect(),
                summed: None,
            }));
        }
    }
    tables
}

/// Columns of a variable for elements of a type; none where they lack it.
fn columns(variable: ElementVariable, kind: &ElementType) -> &'static [&'static str] {
    match variable {
        ElementVariable::MISES if kind.is_space_beam() => &[],
        ElementVariable::MISES => &["MISES"],
        ElementVariable::S if kind.is_beam() => &["S11"],
        other => kind.field(field(other)).map_or(&[], |(field, _)| field.components),
    }
}

/// The field that a variable stands for.
fn field(variable: ElementVariable) -> &'static str {
    match variable {
        ElementVariable::SF => "SF",
        ElementVariable::SM => "SM",
        ElementVariable::SE => "SE",
        ElementVariable::SK => "SK",
        ElementVariable::S | ElementVariable::MISES => "S",
        ElementVariable::E => "E",
        ElementVariable::PEEQ => "PEEQ",
    }
}

/// Axes along which CalculiX prints the tensors of an element: those of its material.
fn axes(
    model: &Model,
    print: &ElementPrint,
    (block, element): (&ElementBlock, Element<'_>),
) -> Vec<Axes> {
    if !print.own_axes || model.dialect != Dialect::Calculix {
        return Vec::new();
    }
    let nodes = element.nodes.iter().map(|&node| model.nodes.position(node));
    block.axes_at_points(&nodes.collect::<Vec<_>>())
}

/// The results of an element.
struct Own<'a> {
    block: &'a ElementBlock,
    values: &'a [f64],
    /// Of a solid at its integration points.
    stresses: Vec<[f64; 6]>,
    /// Axes along which tensors are printed, point by point; none: as they are.
    axes: Vec<Axes>,
}

impl Own<'_> {
    /// What stands in the columns of a variable at a section or integration point.
    fn at(&self, variable: ElementVariable, point: usize) -> Vec<f64> {
        let kind = self.block.kind;
        match (variable, &self.block.section) {
            (ElementVariable::S | ElementVariable::MISES, Section::Beam(section))
                if kind.is_beam() =>
            {
                let stresses = axial_stresses([self.values[0], self.values[2]], section);
                let is_mises = variable == ElementVariable::MISES;
                vec![if is_mises { outer_mises(&stresses) } else { stresses[point - 1] }]
            }
            (ElementVariable::MISES, _) if kind.is_space_beam() => Vec::new(),
            (ElementVariable::MISES, _) => vec![solid::mises(self.stresses[point - 1])],
            _ => {
                let Some((field, first)) = kind.field(field(variable)) else { return Vec::new() };
                let width = field.components.len();
                let before = if field.location == Location::Points { point - 1 } else { 0 };
                let own = &self.values[first + width * before..][..width];
                match (self.axes.get(before), width) {
                    (Some(axes), 4 | 6) => {
                        let mut tensor = [0.0; 6];
                        tensor[..width].copy_from_slice(own);
                        orientation::along(axes, &tensor)[..width].to_vec()
                    }
                    _ => own.to_vec(),
                }
            }
        }
    }
}

/// A table that `*CONTACT PRINT` asks for: a row a slave node of every pair.
pub(crate) fn push_contact(text: &mut String, frame: &Frame<'_>, print: &ContactPrint) {
    let in_space = frame.model.is_in_space();
    let columns = || {
        let all = print.variables.iter().flat_map(|&variable| contact_field(variable));
        all.filter(move |column| in_space || !column.in_space)
    };
    let row = |row: &ContactRow| {
        let (pair, label) = (pair_name(frame.model, row), frame.model.nodes.label(row.node));
        let values = columns().map(|column| (column.value)(row)).collect();
        let head = format!("{pair:<16} {label:>10} {:<6}", row.status.word());
        Row { head, label, values, summed: None }
    };
    let own = frame.contact.iter().filter(|row| print.nodes.contains(&row.node));
    let table = Table {
        head: format!("{:<16} {:>10} {:<6}", "PAIR", "NODE", "STATUS"),
        names: columns().map(|column| column.name).collect(),
        rows: own.map(row).collect(),
        of_beams: false,
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
