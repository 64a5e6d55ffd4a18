//! Printed tables of beams and of contact.

use crate::section::{axial_stresses, beams, outer_mises};
use slideline_model::{
    BeamSection, ContactPrint, ContactVariable, ElementPrint, ElementVariable, Model,
};
use slideline_solve::observe::{BeamRow, ContactRow, Frame};
use std::fmt::Write as _;

/// The line above a table. A String takes any text.
pub(crate) fn push_title(text: &mut String, frame: &Frame<'_>, what: &str) {
    let _ = writeln!(
        text,
        "\nSTEP {}  INCREMENT {}  TOTAL TIME {}  {what}",
        frame.step, frame.increment, frame.total_time
    );
}

fn push_names<'a>(text: &mut String, names: impl Iterator<Item = &'a str>) {
    for name in names {
        let _ = write!(text, " {name:>15}");
    }
    text.push('\n');
}

fn push_values(text: &mut String, values: impl Iterator<Item = f64>) {
    for value in values {
        let _ = write!(text, " {value:>15.7e}");
    }
    text.push('\n');
}

/// A table that `*EL PRINT` asks for: a row a beam and, where stresses are
/// asked for, one a section point.
pub(crate) fn push_elements(text: &mut String, frame: &Frame<'_>, print: &ElementPrint) {
    let set = if print.set.is_empty() { "all beams" } else { &print.set };
    push_title(text, frame, &format!("ELEMENTS {set}"));
    let stressed = print.variables.contains(&ElementVariable::S);
    let names = print.variables.iter().flat_map(|&variable| element_columns(variable));
    let _ = write!(text, "{:>10}", "ELEMENT");
    if stressed {
        let _ = write!(text, " {:>5}", "POINT");
    }
    push_names(text, names.copied());
    let own = |label: &u64| print.elements.binary_search(label).is_ok();
    for (row, section) in beams(frame).filter(|(row, _)| own(&row.label)) {
        let points: &[usize] = if stressed { &print.section_points } else { &[1] };
        for &point in points {
            let _ = write!(text, "{:>10}", row.label);
            if stressed {
                let _ = write!(text, " {point:>5}");
            }
            let values = print.variables.iter();
            push_values(text, values.flat_map(|&v| element_values(v, row, section, point)));
        }
    }
}

fn element_columns(variable: ElementVariable) -> &'static [&'static str] {
    match variable {
        ElementVariable::SF => &["SF1", "SF2"],
        ElementVariable::SM => &["SM1"],
        ElementVariable::SE => &["SE1", "SE2"],
        ElementVariable::SK => &["SK1"],
        ElementVariable::S => &["S11"],
        ElementVariable::MISES => &["MISES"],
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
    }
}

/// A table that `*CONTACT PRINT` asks for: a row a slave node of every pair.
pub(crate) fn push_contact(text: &mut String, frame: &Frame<'_>, print: &ContactPrint) {
    let set = if print.set.is_empty() { "all slave nodes" } else { &print.set };
    push_title(text, frame, &format!("CONTACT {set}"));
    let _ = write!(text, "{:<16} {:>10} {:<6}", "PAIR", "NODE", "STATUS");
    push_names(text, print.variables.iter().flat_map(|&v| contact_columns(v)).copied());
    for row in frame.contact.iter().filter(|row| print.nodes.contains(&row.node)) {
        let (pair, label) = (pair_name(frame.model, row), frame.model.nodes.label(row.node));
        let _ = write!(text, "{pair:<16} {label:>10} {:<6}", row.status.word());
        push_values(text, print.variables.iter().flat_map(|&v| contact_values(v, row)));
    }
}

fn pair_name<'a>(model: &'a Model, row: &ContactRow) -> &'a str {
    model.contact_pairs.get(row.pair).map_or("", |pair| pair.name.as_str())
}

fn contact_columns(variable: ContactVariable) -> &'static [&'static str] {
    match variable {
        ContactVariable::CSTRESS => &["CPRESS", "CSHEAR1"],
        ContactVariable::CDISP => &["COPEN", "CSLIP1"],
        ContactVariable::CFORCE => &["CNORMF", "CSHEARF"],
    }
}

fn contact_values(variable: ContactVariable, row: &ContactRow) -> [f64; 2] {
    match variable {
        ContactVariable::CSTRESS => [row.pressure, row.shear],
        ContactVariable::CDISP => [row.opening, row.slip],
        ContactVariable::CFORCE => [row.pressure * row.area, row.shear * row.area],
    }
}
