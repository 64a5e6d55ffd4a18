//! The table of beams: a row a beam or, where stresses are asked for, a section point.

use super::table::{Row, Table, head, title};
use crate::section::{axial_stresses, outer_mises, space_beams};
use slideline_model::{BeamSection, ElementPrint, ElementVariable, types};
use slideline_solve::observe::{BlockResults, Frame};

/// The tables of the beams of a request, with their titles: of those in the plane, of those in
/// space.
pub(super) fn tables(frame: &Frame<'_>, print: &ElementPrint) -> Vec<(&'static str, Table)> {
    let of_space = || frame.model.blocks.iter().any(|block| block.kind.is_space_beam());
    let of_plane = || frame.model.blocks.iter().any(|block| block.kind.is_beam());
    let plane = if of_plane() || !of_space() { table(frame, print) } else { None };
    plane.into_iter().chain(in_space(frame, print).filter(|_| of_space())).collect()
}

/// The table of beams in space: what they have at their middle; `None` where the request wants
/// nothing of that.
fn in_space(frame: &Frame<'_>, print: &ElementPrint) -> Option<(&'static str, Table)> {
    let mut names: Vec<&'static str> = Vec::new();
    for &variable in &print.variables {
        names.extend(columns_in_space(variable));
    }
    if names.is_empty() {
        return None;
    }
    let pointed = print.variables.contains(&ElementVariable::S);
    let mut rows = Vec::new();
    let named = |label: u64| print.elements.binary_search(&label).is_ok();
    for beam in space_beams(frame).filter(|beam| named(beam.element.label)) {
        let label = beam.element.label;
        let stresses = if pointed { beam.stresses() } else { vec![0.0] };
        for (point, stress) in stresses.into_iter().enumerate() {
            let number = pointed.then(|| (point + 1).to_string());
            let of = |&variable: &ElementVariable| -> Vec<f64> {
                let name = field(variable);
                let width = columns_in_space(variable).len();
                match variable {
                    ElementVariable::S => vec![stress],
                    _ => (0..width).map(|place| beam.value(name, place)).collect(),
                }
            };
            let head = head(&label.to_string(), number.as_deref());
            let values = print.variables.iter().flat_map(of).collect();
            rows.push(Row { head, label, values, summed: None });
        }
    }
    let table = Table { head: head("ELEMENT", pointed.then_some("POINT")), names, rows };
    Some((title(print, "ELEMENTS all beams in space"), table))
}

/// Columns of a variable of beams in space; none where they lack it.
fn columns_in_space(variable: ElementVariable) -> &'static [&'static str] {
    match variable {
        ElementVariable::S => &["S11"],
        _ => types::B31.field(field(variable)).map_or(&[], |(field, _)| field.components),
    }
}

/// The table of the beams of a request, with its title; `None` where it wants nothing that beams
/// have.
fn table(frame: &Frame<'_>, print: &ElementPrint) -> Option<(&'static str, Table)> {
    let pointed = print.variables.contains(&ElementVariable::S);
    let names = print.variables.iter().flat_map(|&variable| columns(variable)).copied();
    let names: Vec<&'static str> = names.collect();
    if names.is_empty() {
        return None;
    }
    let mut rows = Vec::new();
    for results in frame.elements {
        let Some(section) = section_of(frame, results) else { continue };
        for (beam, values) in results.elements(frame.model) {
            if print.elements.binary_search(&beam.label).is_err() {
                continue;
            }
            let points = if pointed { &print.section_points[..] } else { &[1] };
            rows.extend(points.iter().map(|point| {
                Row {
                    head: head(
                        &beam.label.to_string(),
                        pointed.then(|| point.to_string()).as_deref(),
                    ),
                    label: beam.label,
                    values: print
                        .variables
                        .iter()
                        .flat_map(|&variable| at(variable, (values, section), *point))
                        .collect(),
                    summed: None,
                }
            }));
        }
    }
    let head = head("ELEMENT", pointed.then_some("POINT"));
    Some((title(print, "ELEMENTS all beams"), Table { head, names, rows }))
}

fn section_of<'a>(frame: &Frame<'a>, results: &BlockResults) -> Option<&'a BeamSection> {
    Some(frame.model.blocks.get(results.block)?.beams()?.section)
}

/// Columns of a variable; none where beams lack it.
fn columns(variable: ElementVariable) -> &'static [&'static str] {
    match (variable, field(variable)) {
        (ElementVariable::MISES, _) => &["MISES"],
        (ElementVariable::S, _) => &["S11"],
        (_, name) => types::B21.field(name).map_or(&[], |(field, _)| field.components),
    }
}

/// The field that a variable stands for.
fn field(variable: ElementVariable) -> &'static str {
    match variable {
        ElementVariable::SF => "SF",
        ElementVariable::SM => "SM",
        ElementVariable::SE => "SE",
        ElementVariable::SK => "SK",
        _ => "",
    }
}

/// What stands in the columns of a variable at a section point.
fn at(
    variable: ElementVariable,
    (values, section): (&[f64], &BeamSection),
    point: usize,
) -> Vec<f64> {
    let stresses = axial_stresses([values[0], values[2]], section);
    match variable {
        ElementVariable::MISES => vec![outer_mises(&stresses)],
        ElementVariable::S => vec![stresses[point - 1]],
        _ => {
            let Some((field, first)) = types::B21.field(field(variable)) else { return Vec::new() };
            values[first..first + field.components.len()].to_vec()
        }
    }
}
