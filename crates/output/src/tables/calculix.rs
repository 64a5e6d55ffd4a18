//! Tables as CalculiX prints them, which programs around it read.
//!
//! ```text
//!
//!  stresses (elem, integ.pnt.,sxx,syy,szz,sxy,sxz,syz) for set E and time  0.1000000E+01
//!
//!          1   1  2.029475E+01  7.385710E-04 ...
//! ```
//!
//! RF is the sum of reaction and load there, at joined nodes what their elements carry, and energies
//! are those of all work, what plastic strain took included; measured with ccx 2.20 (docs/keywords/NODE-PRINT.md, EL-PRINT.md).

use super::table::named;
use crate::fixed::push_exponent;
use crate::fortran::push_fortran;
use slideline_mech::orientation;
use slideline_model::{
    Axes, Dialect, Dof, ElementPrint, ElementVariable, NodePrint, NodeVariable, Request, Totals,
};
use slideline_results::NodeField;
use slideline_results::element::{Quantity, Solid};
use slideline_solve::observe::Frame;
use std::fmt::Write as _;

const MOVES: [Dof; 3] = [Dof::U1, Dof::U2, Dof::U3];
const TURNS: [Dof; 3] = [Dof::UR1, Dof::UR2, Dof::UR3];

/// Whether CalculiX prints that at nodes.
pub(super) fn has(variable: NodeVariable) -> bool {
    matches!(variable, NodeVariable::U | NodeVariable::RF | NodeVariable::NT)
}

/// Whether CalculiX prints that of solids.
pub(super) fn has_element(variable: ElementVariable) -> bool {
    let of_points = heading(variable).is_some();
    of_points || matches!(variable, ElementVariable::ELSE | ElementVariable::EVOL)
}

/// A table's title between empty lines; `what` ends with the blank before `for`, which one of them
/// lacks. A String takes any text.
fn push_title(text: &mut String, what: &str, request: &Request, frame: &Frame<'_>) {
    let set = if request.set.is_empty() { "ALL" } else { &request.set };
    let mut time = String::new();
    push_fortran(&mut time, frame.total_time, 7);
    let _ = writeln!(text, "\n {what}for set {set} and time {time}\n");
}

/// Numbers of thirteen places each, and the end of the line.
pub(super) fn push_numbers(text: &mut String, values: impl IntoIterator<Item = f64>) {
    for value in values {
        text.push(' ');
        push_exponent(text, value, 6);
    }
    text.push('\n');
}

/// Displacements and forces of a request, with rotations and moments where the model has them.
pub(super) fn push_nodes(text: &mut String, frame: &Frame<'_>, print: &NodePrint) {
    for &variable in print.variables.iter().filter(|variable| has(**variable)) {
        if variable == NodeVariable::NT {
            push_temperatures(text, frame, print);
            continue;
        }
        let forces = variable == NodeVariable::RF;
        let titles = match forces {
            false => ["displacements (vx,vy,vz) ", "rotations (rx,ry,rz) "],
            true => ["forces (fx,fy,fz) ", "moments (mx,my,mz) "],
        };
        let count = 1 + usize::from(frame.nodal.has_rotations());
        for (what, dofs) in titles.into_iter().zip([MOVES, TURNS]).take(count) {
            let table = nodal(frame, forces, dofs);
            let rows = print.nodes.iter().map(|&node| table[node]);
            let own_axes = print.own_axes && frame.model.has_own_axes();
            if print.request.totals != Totals::Only || !forces {
                push_title(text, what, &print.request, frame);
                for (&node, row) in print.nodes.iter().zip(rows.clone()) {
                    // A String takes any text.
                    let _ = write!(text, "{:>10}", frame.model.nodes.label(node));
                    let named = dofs.map(|dof| match forces {
                        true => frame.nodal.carried_as_named(node, dof),
                        false => frame.nodal.named(node, dof)[0],
                    });
                    push_numbers(text, if own_axes { named } else { row });
                }
            }
            if forces && print.request.totals != Totals::No {
                let what = if dofs == MOVES {
                    "total force (fx,fy,fz) "
                } else {
                    "total moment (mx,my,mz) "
                };
                push_title(text, what, &print.request, frame);
                let sum = rows
                    .fold([0.0; 3], |sum, row| std::array::from_fn(|axis| sum[axis] + row[axis]));
                text.push_str("      ");
                push_numbers(text, sum);
            }
        }
    }
}

fn push_temperatures(text: &mut String, frame: &Frame<'_>, print: &NodePrint) {
    push_title(text, "temperatures ", &print.request, frame);
    for &node in &print.nodes {
        let _ = write!(text, "{:>10}", frame.model.nodes.label(node)); // a String takes any text
        push_numbers(text, [frame.nodal.temperature(node)]);
    }
}

/// Motions, or reactions with loads, of all nodes along three dofs.
fn nodal(frame: &Frame<'_>, forces: bool, dofs: [Dof; 3]) -> Vec<[f64; 3]> {
    if forces {
        let carried = |node| dofs.map(|dof| frame.nodal.carried(node, dof));
        return (0..frame.model.nodes.len()).map(carried).collect();
    }
    NodeField::Motion.table(frame, &dofs).as_chunks::<3>().0.to_vec()
}

/// Heading of a quantity at integration points.
fn heading(variable: ElementVariable) -> Option<&'static str> {
    match variable {
        ElementVariable::S => Some("stresses (elem, integ.pnt.,sxx,syy,szz,sxy,sxz,syz) "),
        ElementVariable::E => Some("strains (elem, integ.pnt.,exx,eyy,ezz,exy,exz,eyz) "),
        // ccx has no blank there
        ElementVariable::PEEQ | ElementVariable::CEEQ => {
            Some("equivalent plastic strain (elem, integ.pnt.,pe)")
        }
        ElementVariable::ENER => Some("internal energy density (elem, integ.pnt.,energy) "),
        _ => None,
    }
}

/// Tables of the solids of a request.
pub(super) fn push_elements(text: &mut String, frame: &Frame<'_>, print: &ElementPrint) {
    if named(frame, print).next().is_none() {
        return;
    }
    for &variable in &print.variables {
        if let Some(heading) = heading(variable) {
            if print.request.totals != Totals::Only {
                push_title(text, heading, &print.request, frame);
                named(frame, print).for_each(|solid| {
                    push_points(text, &solid, variable, &axes(frame, print, &solid));
                });
            }
        } else if has_element(variable) {
            push_whole(text, frame, print, variable);
        }
    }
}

/// Axes along which tensors of a solid are printed: those of its material; none: as they are.
fn axes(frame: &Frame<'_>, print: &ElementPrint, solid: &Solid<'_>) -> Vec<Axes> {
    if !print.own_axes {
        return Vec::new();
    }
    let nodes = solid.element.nodes.iter().map(|&node| frame.model.nodes.position(node));
    solid.block.axes_at_points(solid.place, &nodes.collect::<Vec<_>>())
}

/// Whether an element has what is printed.
fn offers(solid: &Solid<'_>, variable: ElementVariable) -> bool {
    let kind = solid.block.kind;
    Quantity::of(variable).is_some_and(|own| !own.components(kind, Dialect::Calculix).is_empty())
}

fn push_points(text: &mut String, solid: &Solid<'_>, variable: ElementVariable, axes: &[Axes]) {
    let mut values = Vec::new();
    let Some(quantity) = Quantity::of(variable).filter(|_| offers(solid, variable)) else { return };
    for point in 0..solid.points() {
        values.clear();
        // ccx tells of trusses along the axes of the model
        match (variable, solid.truss_strain(point)) {
            (ElementVariable::S, Some(_)) => values.extend(solid.stress_in_space(point)),
            (ElementVariable::E, Some(strain)) => values.extend(strain),
            _ => solid.push(quantity, point, &mut values),
        }
        if variable == ElementVariable::ENER {
            solid.push(Quantity::Field("PENER"), point, &mut values);
            values = vec![values.iter().sum()];
        }
        if matches!(variable, ElementVariable::S | ElementVariable::E) {
            values.resize(6, 0.0);
            if let (Some(axes), [xx, yy, zz, xy, xz, yz]) = (axes.get(point), &values[..]) {
                values = orientation::along(axes, &[*xx, *yy, *zz, *xy, *xz, *yz]).to_vec();
            }
        }
        let _ = write!(text, "{:>10} {:>3}", solid.element.label, point + 1); // takes any text
        push_numbers(text, values.iter().copied());
    }
}

/// Energy or volume of every element, and the sums.
fn push_whole(
    text: &mut String,
    frame: &Frame<'_>,
    print: &ElementPrint,
    variable: ElementVariable,
) {
    let (fields, rows, sum): (&[&str], _, _) = match variable {
        ElementVariable::EVOL => (&["EVOL"], "volume (element, volume) ", "total volume "),
        _ => (&["ELSE", "ELPD"], "internal energy (element, energy) ", "total internal energy "),
    };
    let value = |solid: &Solid<'_>| {
        let mut values = Vec::new();
        fields.iter().for_each(|name| solid.push(Quantity::Field(name), 0, &mut values));
        values.iter().sum::<f64>()
    };
    if print.request.totals != Totals::Only {
        push_title(text, rows, &print.request, frame);
        for solid in named(frame, print).filter(|solid| offers(solid, variable)) {
            let _ = write!(text, "{:>10}", solid.element.label); // a String takes any text
            push_numbers(text, [value(&solid)]);
        }
    }
    if print.request.totals != Totals::No {
        push_title(text, sum, &print.request, frame);
        text.push_str("      ");
        push_numbers(text, [named(frame, print).map(|solid| value(&solid)).sum()]);
    }
}
