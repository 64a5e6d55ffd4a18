//! What passes through the surfaces of `*SECTION PRINT`: a row, or as CalculiX prints it.
//!
//! ```text
//!   SECTION             SOAREA     SOFM     SOF1 ...     statistics for surface set S and time ...
//!   CUT                    ...                             total surface force (fx,fy,fz) ...
//! ```

use super::calculix::push_numbers;
use super::table::{Row, Table};
use crate::fortran::push_fortran;
use slideline_model::{Dialect, SectionPrint, SectionVariable};
use slideline_solve::observe::{Frame, SectionRow};
use std::fmt::Write as _;

/// The table of a request.
pub(super) fn push(
    text: &mut String,
    frame: &Frame<'_>,
    (print, row): (&SectionPrint, &SectionRow),
) {
    if frame.model.dialect == Dialect::Calculix {
        return push_statistics(text, frame, (print, row));
    }
    let in_space = frame.model.is_in_space();
    let parts = print.variables.iter().map(|&variable| part(variable, row, in_space));
    let (names, values): (Vec<_>, Vec<_>) = parts.unzip();
    let table = Table {
        head: format!("{:<16}", "SECTION"),
        names: names.concat(),
        rows: vec![Row {
            head: format!("{:<16}", print.name),
            label: 0,
            values: values.concat(),
            summed: None,
        }],
    };
    table.push(text, frame, ("SURFACE", &print.request));
}

/// Columns of a variable and their values: size and components, in the plane those that it has.
fn part(
    variable: SectionVariable,
    row: &SectionRow,
    in_space: bool,
) -> (&'static [&'static str], Vec<f64>) {
    let ([fx, fy, fz], [mx, my, mz]) = (row.carried.force, row.carried.moment);
    match (variable, in_space) {
        (SectionVariable::SOAREA, _) => (&["SOAREA"], vec![row.area]),
        (SectionVariable::SOF, false) => (&["SOFM", "SOF1", "SOF2"], vec![fx.hypot(fy), fx, fy]),
        (SectionVariable::SOF, true) => {
            (&["SOFM", "SOF1", "SOF2", "SOF3"], vec![size([fx, fy, fz]), fx, fy, fz])
        }
        (SectionVariable::SOM, false) => (&["SOM3"], vec![mz]),
        (SectionVariable::SOM, true) => {
            (&["SOMM", "SOM1", "SOM2", "SOM3"], vec![size([mx, my, mz]), mx, my, mz])
        }
    }
}

fn size(vector: [f64; 3]) -> f64 {
    vector[0].hypot(vector[1]).hypot(vector[2])
}

/// The vector along a unit vector, and what is left of it across.
fn along(vector: [f64; 3], unit: [f64; 3]) -> (f64, [f64; 3]) {
    let along: f64 = vector.iter().zip(unit).map(|(own, n)| own * n).sum();
    (along, std::array::from_fn(|k| vector[k] - along * unit[k]))
}

/// CalculiX' block of a surface; measured with ccx 2.20 (docs/keywords/SECTION-PRINT.md). A String
/// takes any text.
fn push_statistics(
    text: &mut String,
    frame: &Frame<'_>,
    (print, row): (&SectionPrint, &SectionRow),
) {
    let mut time = String::new();
    push_fortran(&mut time, frame.total_time, 7);
    let surface = &print.request.set;
    let _ = writeln!(text, "\n\n\n statistics for surface set {surface} and time {time}");
    let mut part = |title: &str, values: &[f64]| {
        let _ = write!(text, "\n   {title}\n\n  ");
        push_numbers(text, values.iter().copied());
    };
    let (carried, normal) = (row.carried, row.normal);
    let about_centre = carried.moment_about(row.centre);
    let (pull, shear) = along(carried.force, normal);
    let (torque, bending) = along(about_centre, normal);
    part(
        "total surface force (fx,fy,fz) and moment about the origin(mx,my,mz)",
        &[carried.force, carried.moment].concat(),
    );
    part("center of gravity and mean normal", &[row.centre, normal].concat());
    part("moment about the center of gravity(mx,my,mz)", &about_centre);
    part(
        "area, normal force (+ = tension), shear force (size), torque and bending moment (size)",
        &[row.area, pull, size(shear), torque, size(bending)],
    );
}
