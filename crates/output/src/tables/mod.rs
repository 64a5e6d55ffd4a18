//! Printed tables of nodes, elements and contact; in the dialect of CalculiX those that it prints
//! look as there.
//!
//! ```text
//!   STEP 1  INCREMENT 20  TOTAL TIME 1  NODES TIP
//!         NODE             RF1             RF2
//!         9999     1.2345670e0    -8.7654321e0
//!        TOTAL     1.2345670e0    -8.7654321e0     TOTALS=YES
//!      MAXIMUM     1.2345670e0    -8.7654321e0     SUMMARY=YES
//!           AT            9999            9999
//! ```

mod beams;
mod calculix;
mod pairs;
mod sections;
mod solids;
mod table;

use slideline_model::{
    ContactPrint, ContactVariable, Dialect, ElementPrint, ElementType, Model, NodeIndex, NodePrint,
    NodeVariable, SectionPrint,
};
use slideline_results::{CONTACT_FIELDS, ContactComponent, NodeComponent, NodeField};
use slideline_solve::observe::{ContactRow, Frame};
use table::{Row, Table};

/// A table that `*NODE PRINT` asks for: a row a node.
pub(crate) fn push_nodes(text: &mut String, frame: &Frame<'_>, print: &NodePrint) {
    let dofs = frame.nodal.dofs();
    let as_calculix = frame.model.dialect == Dialect::Calculix;
    if as_calculix {
        calculix::push_nodes(text, frame, print);
    }
    let own = |variable: &&NodeVariable| !(as_calculix && calculix::has(**variable));
    let fields = print.variables.iter().filter(own).map(|&variable| NodeField::from(variable));
    let columns: Vec<NodeComponent> = fields.flat_map(|field| field.components(dofs)).collect();
    if columns.is_empty() {
        return;
    }
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
    };
    let what = if print.request.set.is_empty() { "NODES all nodes" } else { "NODES" };
    table.push(text, frame, (what, &print.request));
}

/// The tables that `*EL PRINT` asks for: of solids, and of beams.
pub(crate) fn push_elements(text: &mut String, frame: &Frame<'_>, print: &ElementPrint) {
    let mut tables = solids::tables(text, frame, print);
    let is_beam = |kind: &ElementType| kind.is_beam() || kind.is_space_beam();
    let has_beams = frame.model.blocks.iter().any(|block| is_beam(block.kind));
    if tables.is_empty() && solids::count(frame, print) == 0 || has_beams {
        tables.extend(beams::tables(frame, print));
    }
    for (what, table) in tables {
        table.push(text, frame, (what, &print.request));
    }
}

/// The tables that `*SECTION PRINT` asks for: a row each, in the order of the requests.
pub(crate) fn push_section(
    text: &mut String,
    frame: &Frame<'_>,
    number: usize,
    print: &SectionPrint,
) {
    if let Some(row) = frame.sections.get(number) {
        sections::push(text, frame, (print, row));
    }
}

/// The tables that `*CONTACT PRINT` asks for: a row a slave node of every pair, and sums of pairs.
pub(crate) fn push_contact(text: &mut String, frame: &Frame<'_>, print: &ContactPrint) {
    if print.variables.iter().any(|variable| variable.is_of_points()) {
        push_points(text, frame, print);
    }
    pairs::push(text, frame, print);
}

fn push_points(text: &mut String, frame: &Frame<'_>, print: &ContactPrint) {
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
    let wants = |row: &ContactRow| {
        let pair = frame.model.contact_pairs.get(row.pair);
        pair.is_some_and(|pair| print.wants(pair)) && print.nodes.contains(&row.node)
    };
    let own = frame.contact.iter().filter(|row| wants(row));
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
